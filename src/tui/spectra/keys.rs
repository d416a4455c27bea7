//! What the keys do to the view.

use super::{ListPlace, Listed, Lower, MOST_REDUCED, SpectraView, TOLERANCES};
use crate::model::ModelKind;
use crate::tui::action::Action;

/// Columns of a jump.
const JUMP: f64 = 10.0;
/// What is left of the window at each step inwards.
const ZOOM: f64 = 0.5;
/// The fewest lines in a window.
const LEAST_LINES: usize = 4;

impl SpectraView {
    /// Does what a key asks for; says whether something else is to be known for it.
    pub(super) fn act(&mut self, action: Action) -> bool {
        match action {
            Action::MoveLeft => self.move_columns(-1.0),
            Action::MoveRight => self.move_columns(1.0),
            Action::JumpLeft => self.move_columns(-JUMP),
            Action::JumpRight => self.move_columns(JUMP),
            Action::First | Action::FirstCell => self.put(0),
            Action::Last | Action::LastCell => self.put(self.lines().len().saturating_sub(1)),
            Action::PageUp => self.pan(-1.0),
            Action::PageDown => self.pan(1.0),
            Action::PanLeft => self.pan(-0.25),
            Action::PanRight => self.pan(0.25),
            Action::ZoomIn => self.zoom(ZOOM),
            Action::ZoomOut => self.zoom(1.0 / ZOOM),
            Action::ZoomFit => self.window = None,
            Action::NextPeak => self.jump_to_peak(1),
            Action::PreviousPeak => self.jump_to_peak(-1),
            Action::MoveDown if self.listed == Listed::Peaks => self.jump_to_peak(1),
            Action::MoveUp if self.listed == Listed::Peaks => self.jump_to_peak(-1),
            Action::NextBand | Action::MoveDown => self.jump_to_band(1),
            Action::PreviousBand | Action::MoveUp => self.jump_to_band(-1),
            Action::LogFrequency => self.log = !self.log,
            Action::LinearLevel => self.linear_level = !self.linear_level,
            Action::NextPanel => {
                let at = self.lower as usize + 1;
                self.lower = Lower::ALL[at % Lower::ALL.len()];
            }
            Action::ListPeaks if self.list_place == ListPlace::Alone => match self.listed {
                Listed::Bands => self.listed = Listed::Peaks,
                _ => self.list_place = ListPlace::Hidden,
            },
            Action::ListPeaks if self.list_place == ListPlace::Hidden => {
                self.list_place = ListPlace::Alone;
                self.listed = Listed::Bands;
            }
            Action::ListPeaks => {
                self.listed = match self.listed {
                    Listed::Bands => Listed::Peaks,
                    Listed::Peaks => Listed::Nothing,
                    Listed::Nothing => Listed::Bands,
                };
            }
            _ => return self.act_on_what_is_wanted(action),
        }
        false
    }

    fn act_on_what_is_wanted(&mut self, action: Action) -> bool {
        let design = self.known.subject.as_ref().map(|subject| &subject.design);
        match action {
            Action::ShowFe => self.shown[0] = !self.shown[0],
            Action::ShowEnhanced => self.shown[1] = !self.shown[1],
            Action::ShowBasic => self.shown[2] = !self.shown[2],
            Action::ShowReduced => self.shown[3] = !self.shown[3],
            Action::MoreModes | Action::FewerModes => {
                let by = if action == Action::MoreModes { 1 } else { -1 };
                self.reduced = self.reduced.saturating_add_signed(by).min(MOST_REDUCED);
                self.shown[3] = true;
                // of reduced models only the one in sight is kept
                let wanted = ModelKind::Reduced(self.reduced);
                let is_kept = |kind: ModelKind| !matches!(kind, ModelKind::Reduced(_)) || kind == wanted;
                self.known.models.retain(|model| is_kept(model.kind));
                self.known.modes.retain(|modes| is_kept(modes.lumped_model.kind));
            }
            Action::NextAgainst => {
                self.against = self.against % 3 + 1;
                self.shown[self.against] = true;
            }
            Action::LessTolerance => self.tolerance = (self.tolerance - 1.0).max(TOLERANCES.0),
            Action::MoreTolerance => self.tolerance = (self.tolerance + 1.0).min(TOLERANCES.1),
            Action::NextQuantity | Action::PreviousQuantity => {
                let Some(design) = design else { return false };
                self.quantity = self.quantity.next(if action == Action::NextQuantity { 1 } else { -1 }, design);
            }
            Action::NextDirection => self.quantity = self.quantity.next_part(),
            _ => return false,
        }
        true
    }

    /// Puts the cursor on a line, and the window around it.
    fn put(&mut self, line: usize) {
        self.cursor = line.min(self.lines().len().saturating_sub(1));
        let (Some(axis), Some(hz)) = (self.axis(), self.at_hz()) else { return };
        let place = axis.fraction(hz);
        if !(0.0..=1.0).contains(&place) {
            self.shift(place - 0.5);
        }
    }

    fn nearest(&self, hz: f64) -> usize {
        let lines = self.lines();
        let after = lines.partition_point(|line| *line < hz).min(lines.len().saturating_sub(1));
        let before = after.saturating_sub(1);
        match (lines.get(before), lines.get(after)) {
            (Some(low), Some(high)) if hz - low < high - hz => before,
            _ => after,
        }
    }

    /// The line that is nearest so many columns away, another one in any case.
    fn move_columns(&mut self, by: f64) {
        let (Some(axis), Some(hz)) = (self.axis(), self.at_hz()) else { return };
        let wanted = axis.frequency(axis.fraction(hz) + by / self.width.max(1) as f64);
        let line = self.nearest(wanted);
        let line = if by > 0.0 { line.max(self.cursor + 1) } else { line.min(self.cursor.saturating_sub(1)) };
        self.put(line);
    }

    /// Moves the window by a part of itself.
    fn shift(&mut self, by: f64) {
        let (Some(axis), Some((first, last))) = (self.axis(), self.ends()) else { return };
        let all = crate::tui::axis::FrequencyAxis { min: first, max: last, log: axis.log };
        // in the axis' own measure, so that the window keeps its width
        let (from, to) = (all.fraction(axis.min), all.fraction(axis.max));
        let width = to - from;
        let from = (from + by * width).clamp(0.0, (1.0 - width).max(0.0));
        if width < 1.0 {
            self.window = Some((all.frequency(from), all.frequency(from + width)));
        }
    }

    fn pan(&mut self, by: f64) {
        self.shift(by);
        let (Some(axis), Some(hz)) = (self.axis(), self.at_hz()) else { return };
        if !(axis.min..=axis.max).contains(&hz) {
            let end = if hz < axis.min { axis.min } else { axis.max };
            let line = self.nearest(end);
            let inside = |line: &usize| self.lines().get(*line).is_some_and(|hz| (axis.min..=axis.max).contains(hz));
            self.cursor = [line, line + 1, line.saturating_sub(1)].into_iter().find(inside).unwrap_or(line);
        }
    }

    /// Makes the window so many times as wide, around the cursor.
    fn zoom(&mut self, factor: f64) {
        let (Some(axis), Some((first, last)), Some(hz)) = (self.axis(), self.ends(), self.at_hz()) else { return };
        let place = axis.fraction(hz).clamp(0.0, 1.0);
        let end = |end: f64| axis.frequency(place + (end - place) * factor);
        let (from, to) = (end(0.0).max(first), end(1.0).min(last));
        let lines = self.lines();
        let inside = lines.partition_point(|f| *f <= to) - lines.partition_point(|f| *f < from);
        if factor < 1.0 && inside < LEAST_LINES {
            return;
        }
        self.window = (from > first || to < last).then_some((from, to));
    }

    fn jump_to_band(&mut self, by: isize) {
        let (Some(hz), Some(findings)) = (self.at_hz(), self.findings()) else { return };
        let places = findings.bands.iter().map(|band| band.band.worst_at_hz);
        if let Some(place) = neighbour(places, hz, by) {
            self.put(self.nearest(place));
        }
    }

    fn jump_to_peak(&mut self, by: isize) {
        let (Some(hz), Some(findings)) = (self.at_hz(), self.findings()) else { return };
        if let Some(place) = neighbour(findings.peaks.iter().map(super::Labelled::place), hz, by) {
            self.put(self.nearest(place));
        }
    }
}

/// The next of some ascending places, or the one before; after the last comes the first.
fn neighbour(places: impl Iterator<Item = f64>, hz: f64, by: isize) -> Option<f64> {
    let places: Vec<f64> = places.collect();
    let near = 1e-9 * hz.abs();
    if by > 0 {
        places.iter().find(|place| **place > hz + near).or(places.first()).copied()
    } else {
        places.iter().rev().find(|place| **place < hz - near).or(places.last()).copied()
    }
}
