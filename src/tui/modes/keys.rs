//! What the keys do on the screen of the modes.

use std::sync::Arc;

use super::{Answer, LUMPED, ModesJob, ModesView, PHASES, Study, Wanted, rows};
use crate::number::significant;
use crate::tui::action::Action;
use crate::tui::app::{App, Scroll};
use crate::tui::keymap::Mode;
use crate::tui::message::Effect;
use crate::tui::solving::Ticket;
use crate::tui::text_field::TextField;

/// A step of the frequency: the thirty-second part of an octave.
const STEP: f64 = 1.0 / 32.0;

impl App {
    /// Does an action of the screen, or opens it; nothing where the action is another's.
    pub(in crate::tui) fn act_in_modes(&mut self, action: Action) -> Option<Vec<Effect>> {
        match (action, self.mode) {
            (Action::Modes, _) => return Some(self.open_modes()),
            (Action::Accept, Mode::Frequency) => return Some(self.accept_frequency()),
            (Action::Back, Mode::Modes) => {
                self.modes = None;
                self.close();
                return Some(vec![Effect::CancelModes]);
            }
            (Action::TypeFrequency, _) => {
                let view = self.modes.as_mut().filter(|view| view.study().is_some())?;
                view.field = TextField::new(view.deflection_hz.map_or(String::new(), |hz| significant(hz, 6)));
                self.open(Mode::Frequency);
            }
            (Action::Deflection, _) => {
                let wanted = self.modes.as_mut()?.toggle_deflection();
                return Some(wanted.map_or(Vec::new(), |hz| self.deflect(hz)));
            }
            (Action::MoveLeft | Action::MoveRight, Mode::Modes) => {
                let wanted = self.modes.as_mut()?.move_across(if action == Action::MoveLeft { -1 } else { 1 });
                return Some(wanted.map_or(Vec::new(), |hz| self.deflect(hz)));
            }
            _ => {
                let view = self.modes.as_mut()?;
                if !view.look_otherwise(action) {
                    return None;
                }
                view.keep_mac_in_bounds();
            }
        }
        Some(Vec::new())
    }

    fn open_modes(&mut self) -> Vec<Effect> {
        let path = match self.editors.open() {
            Some(editing) => Some(editing.path.clone()),
            None => self.library.selected().map(|row| row.path.clone()),
        };
        let Some(path) = path else { return Vec::new() };
        let stem = self.library.row(&path).map_or_else(String::new, |row| row.stem.clone());
        let unsaved = self.editors.unsaved_text(&path);
        let name = if unsaved.is_some() { format!("{stem} (unsaved edits)") } else { stem.clone() };
        let ticket = self.ticket();
        self.modes = Some(Box::new(ModesView {
            ticket,
            name,
            stem,
            study: None,
            rows: Vec::new(),
            cursor: 0,
            scroll: Scroll::default(),
            lumped: 0,
            phase: 0,
            mac: None,
            deflection_hz: None,
            deflection: None,
            field: TextField::default(),
        }));
        self.open(Mode::Modes);
        vec![Effect::Modes(ModesJob { ticket, wanted: Wanted::Modes { path, unsaved } })]
    }

    fn deflect(&mut self, at_hz: f64) -> Vec<Effect> {
        let ticket = self.ticket();
        let Some(view) = &mut self.modes else { return Vec::new() };
        let Some(study) = view.study().cloned() else { return Vec::new() };
        view.ticket = ticket;
        view.deflection_hz = Some(at_hz);
        view.mac = None;
        vec![Effect::Modes(ModesJob { ticket, wanted: Wanted::Deflection { study, at_hz } })]
    }

    pub(in crate::tui) fn edit_frequency(&mut self, edit: impl FnOnce(&mut TextField)) {
        if let Some(view) = &mut self.modes {
            edit(&mut view.field);
        }
    }

    fn accept_frequency(&mut self) -> Vec<Effect> {
        let Some(view) = &self.modes else { return Vec::new() };
        let text = view.field.text().trim().trim_end_matches("Hz").replace(',', "");
        let Some([low, high]) = view.study().map(band) else { return Vec::new() };
        match text.trim().parse::<f64>() {
            Ok(hz) if (low..=high).contains(&hz) => {
                self.close();
                self.deflect(hz)
            }
            _ => {
                let [low, high] = [low, high].map(|hz| significant(hz, 6));
                self.complain(format!("wanted a frequency in Hz from {low} to {high}"));
                Vec::new()
            }
        }
    }

    pub(in crate::tui) fn move_in_modes(&mut self, by: isize) {
        let Some(view) = &mut self.modes else { return };
        if let Some((row, column)) = view.mac {
            view.mac = Some((row.saturating_add_signed(by), column));
            view.keep_mac_in_bounds();
        } else {
            view.cursor = view.cursor.saturating_add_signed(by).min(view.rows.len().saturating_sub(1));
        }
    }

    pub(in crate::tui) fn modes_found(&mut self, ticket: Ticket, result: Result<Answer, String>) {
        let Some(view) = self.modes.as_mut().filter(|view| view.ticket == ticket) else { return };
        match result {
            Ok(Answer::Modes(study)) => {
                view.rows = rows::rows(&study);
                // the rigid rotation is the least interesting
                view.cursor = usize::from(view.rows.len() > 1);
                view.study = Some(Ok(study));
            }
            Ok(Answer::Deflection(found)) => view.deflection = Some(Ok(found)),
            Err(error) if view.study().is_none() => view.study = Some(Err(error)),
            Err(error) => view.deflection = Some(Err(error)),
        }
    }
}

impl ModesView {
    /// Whether the action is one that only changes what is shown.
    fn look_otherwise(&mut self, action: Action) -> bool {
        match action {
            Action::NextPhase => self.phase = (self.phase + 1) % PHASES,
            Action::OtherModel => self.lumped = 1 - self.lumped,
            Action::ShowMac => self.mac = if self.mac.is_some() { None } else { Some(self.place_in_mac()) },
            _ => return false,
        }
        true
    }

    /// Leaves the deflection shape, or gives the frequency at which it is wanted: that of the selected mode.
    fn toggle_deflection(&mut self) -> Option<f64> {
        if self.deflection_hz.take().is_some() {
            self.deflection = None;
            return None;
        }
        let study = self.study()?;
        let [low, high] = band(study);
        Some(self.row()?.mode(study)?.frequency_hz.clamp(low, high))
    }

    /// Moves the cursor of the MAC picture, or gives the next frequency of the deflection shape.
    fn move_across(&mut self, by: isize) -> Option<f64> {
        if let Some((row, column)) = self.mac {
            self.mac = Some((row, column.saturating_add_signed(by)));
            self.keep_mac_in_bounds();
            return None;
        }
        let [low, high] = band(self.study()?);
        Some((self.deflection_hz? * (by as f64 * STEP).exp2()).clamp(low, high))
    }

    /// Where the selected mode is in the MAC picture.
    fn place_in_mac(&self) -> (usize, usize) {
        let row = self.row();
        let lumped = row.and_then(|row| row.lumped[self.lumped]).map_or(0, |one| one.mode);
        (lumped, row.and_then(|row| row.fe).unwrap_or(0))
    }

    fn keep_mac_in_bounds(&mut self) {
        let Some(mac) = self.study().map(|study| study.mac[self.lumped.min(LUMPED.len() - 1)].shape()) else { return };
        if let Some((row, column)) = &mut self.mac {
            *row = (*row).min(mac.0.saturating_sub(1));
            *column = (*column).min(mac.1.saturating_sub(1));
        }
    }
}

/// The lines of the analysis, Hz.
fn band(study: &Arc<Study>) -> [f64; 2] {
    let analysis = &study.design.analysis;
    [analysis.frequency_min, analysis.frequency_max]
}
