//! A model with the modes of both its rotors: what all else follows from, found once and handed on.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::{Compliance, Modes, ResponseError, Spectrum, rotor_modes_over};
use crate::design::Side;
use crate::model::{Model, RotorModes, WorkDone};

/// A model and its rotors' modes without the mesh, pinion first; a clone shares both.
#[derive(Debug, Clone)]
pub struct Solved {
    pub model: Arc<Model>,
    pub rotor_modes: Arc<[RotorModes; 2]>,
}

impl Solved {
    /// # Errors
    ///
    /// As [`super::rotor_modes`].
    pub fn new(model: Model) -> Result<Self, ResponseError> {
        Self::over(model, &mut |_| ControlFlow::Continue(()))
    }

    /// As [`Solved::new`]; `done` hears of the work, [`crate::model::modes_work`] of both rotors in all.
    ///
    /// # Errors
    ///
    /// As [`rotor_modes_over`].
    pub fn over(model: Model, done: &mut WorkDone<'_>) -> Result<Self, ResponseError> {
        let pinion = rotor_modes_over(&model.pinion, Side::Pinion, done)?;
        let rotor_modes = [pinion, rotor_modes_over(&model.gear, Side::Gear, done)?];
        Ok(Self { model: Arc::new(model), rotor_modes: Arc::new(rotor_modes) })
    }

    pub fn compliance(&self) -> Compliance {
        Compliance::with_modes(&self.model, &self.rotor_modes)
    }

    /// Response on the given lines (Hz, all greater than 0).
    ///
    /// # Errors
    ///
    /// A line whose result overflows.
    pub fn spectrum(&self, frequency_hz: &[f64]) -> Result<Spectrum, ResponseError> {
        let mut out = Spectrum::with_capacity(frequency_hz.len(), self.model.coordinates());
        out.extend(&self.model, &self.compliance(), frequency_hz)?;
        Ok(out)
    }

    /// Frequencies of all modes with the mesh, Hz, ascending.
    pub fn frequencies(&self) -> Vec<f64> {
        Modes::frequencies(&self.model, &self.rotor_modes)
    }

    /// All modes with the mesh; `done` is asked often whether to go on.
    ///
    /// # Errors
    ///
    /// As [`Modes::with_rotor_modes_over`].
    pub fn modes_over(&self, done: &mut WorkDone<'_>) -> Result<Modes, ResponseError> {
        Modes::with_rotor_modes_over(&self.model, &self.rotor_modes, usize::MAX, done)
    }
}
