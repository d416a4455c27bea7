//! What is known of the solution of a design that is being edited.

use std::sync::Arc;

use crate::design::Design;
use crate::tui::app::Picture;
use crate::tui::axis::FrequencyAxis;
use crate::tui::bearings::BearingStates;
use crate::tui::solving::{Summary, Ticket};
use crate::tui::traces::{Envelope, Traces};

/// A design that was solved.
#[derive(Debug)]
pub struct Solution {
    pub design: Arc<Design>,
    pub summary: Summary,
    pub picture: Picture,
    pub bearings: Option<Arc<BearingStates>>,
}

/// The saved state, to be drawn behind the state as it is now.
#[derive(Debug)]
pub struct Ghost {
    pub design: Arc<Design>,
    pub summary: Summary,
    pub bearings: Option<Arc<BearingStates>>,
    traces: Arc<Traces>,
    /// At the axis and the width that were drawn last
    columns: Option<(FrequencyAxis, usize, Envelope)>,
}

/// A solution that is still to come.
#[derive(Debug, Clone, PartialEq)]
pub struct Pending {
    pub ticket: Ticket,
    pub design: Arc<Design>,
    /// From 0 to 1
    pub done: f64,
    /// No frame has shown that it is awaited.
    pub is_fresh: bool,
}

#[derive(Debug, Default)]
pub struct Solving {
    /// The last one that came; it may be of an earlier state.
    pub current: Option<Solution>,
    pub ghost: Option<Ghost>,
    pub pending: Option<Pending>,
    /// What cannot be solved, and why.
    pub failure: Option<(Arc<Design>, String)>,
}

impl Ghost {
    pub fn of(solution: &Solution) -> Self {
        Self {
            design: Arc::clone(&solution.design),
            summary: solution.summary.clone(),
            bearings: solution.bearings.clone(),
            traces: Arc::clone(&solution.picture.traces),
            columns: None,
        }
    }

    pub(super) fn traces(&self) -> Arc<Traces> {
        Arc::clone(&self.traces)
    }

    /// The finite element model's curve at an axis and a number of columns.
    pub fn columns(&mut self, axis: FrequencyAxis, width: usize) -> &Envelope {
        if !self.columns.as_ref().is_some_and(|(of, count, _)| *of == axis && *count == width) {
            self.columns = None;
        }
        let traces = &self.traces;
        &self.columns.get_or_insert_with(|| (axis, width, traces.fe_columns(&axis, width))).2
    }
}

impl Solving {
    /// Whether the solution that is shown is not that of `design`.
    pub fn is_stale(&self, design: Option<&Design>) -> bool {
        self.current.as_ref().is_some_and(|solution| design.is_none_or(|now| !same_mechanics(now, &solution.design)))
    }

    /// Why `design` cannot be solved, if that was found out.
    pub fn failure(&self, design: &Design) -> Option<&str> {
        self.failure.as_ref().filter(|(of, _)| same_mechanics(of, design)).map(|(_, text)| text.as_str())
    }
}

/// Torque of the pinion, N m.
fn torque(design: &Design) -> Option<f64> {
    design.operating.and_then(|operating| operating.pinion_torque)
}

/// Whether two designs have the same solution. What is only said about them does not count.
pub fn same_mechanics(a: &Design, b: &Design) -> bool {
    a.analysis == b.analysis
        && a.mesh == b.mesh
        && a.materials == b.materials
        && a.pinion == b.pinion
        && a.gear == b.gear
        && (!a.follows_torque() || torque(a) == torque(b))
}
