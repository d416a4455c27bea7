//! What the keys do on the screen of the modes.

use std::sync::Arc;

use super::{Answer, FIRST_REDUCED, MODELS, MOST_REDUCED, ModeRow, ModesJob, ModesView, PHASES, Study, Wanted, rows};
use crate::number::significant;
use crate::tui::action::Action;
use crate::tui::app::{App, Scroll};
use crate::tui::keymap::Mode;
use crate::tui::message::Effect;
use crate::tui::solving::Ticket;
use crate::tui::spectra::SpectraView;
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
                if self.modes.as_mut()?.leave_picture() {
                    return Some(Vec::new());
                }
                self.modes = None;
                self.close();
                return Some(vec![Effect::CancelModes]);
            }
            (Action::TypeFrequency, _) => {
                let view = self.modes.as_mut().filter(|view| view.study().is_some())?;
                view.field = TextField::proposed(view.deflection_hz.map_or(String::new(), |hz| significant(hz, 6)));
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
            (Action::MoreModes, Mode::Modes) => return Some(self.reduce(1)),
            (Action::FewerModes, Mode::Modes) => return Some(self.reduce(-1)),
            // nothing to look at yet
            (Action::OtherModel | Action::ShowMac | Action::NextPhase, Mode::Modes)
                if self.modes.as_ref()?.study().is_none() => {}
            (Action::OtherModel, Mode::Modes) => {
                let view = self.modes.as_mut()?;
                view.model = (view.model + 1) % MODELS;
                view.keep_mac_in_bounds();
                return Some(if view.model == MODELS - 1 { self.reduce(0) } else { Vec::new() });
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
        // from the spectra: the deflection where their cursor is
        let spectra = self.spectra.as_ref();
        let path = match (spectra, self.editors.open()) {
            (Some(spectra), _) => Some(spectra.path.clone()),
            (_, Some(editing)) => Some(editing.path.clone()),
            _ => self.library.selected().map(|row| row.path.clone()),
        };
        let deflection_hz = spectra.and_then(SpectraView::at_hz);
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
            model: 0,
            reduced: FIRST_REDUCED,
            is_reducing: false,
            phase: 0,
            mac: None,
            deflection_hz,
            deflection: None,
            field: TextField::default(),
        }));
        self.open(Mode::Modes);
        vec![Effect::Modes(ModesJob { ticket, wanted: Wanted::Modes { path, unsaved, reduced: FIRST_REDUCED } })]
    }

    /// Shows the reduced model with more or fewer fixed-interface modes, and asks for it where it is not known.
    fn reduce(&mut self, by: isize) -> Vec<Effect> {
        let ticket = self.ticket();
        let Some(view) = &mut self.modes else { return Vec::new() };
        let Some(study) = view.study().cloned() else { return Vec::new() };
        view.model = MODELS - 1;
        view.keep_mac_in_bounds();
        let before = view.reduced;
        view.reduced = before.saturating_add_signed(by).min(MOST_REDUCED);
        let is_asked_for = view.is_reducing && view.reduced == before;
        if is_asked_for || study.reduced() == Some(view.reduced) {
            return Vec::new();
        }
        (view.is_reducing, view.ticket) = (true, ticket);
        vec![Effect::Modes(ModesJob { ticket, wanted: Wanted::Reduced { study, reduced: view.reduced } })]
    }

    fn deflect(&mut self, at_hz: f64) -> Vec<Effect> {
        let ticket = self.ticket();
        let Some(view) = &mut self.modes else { return Vec::new() };
        let Some(study) = view.study().cloned() else { return Vec::new() };
        view.deflection_hz = Some(at_hz);
        // that of another frequency would be drawn under this one
        view.deflection = None;
        view.mac = None;
        // with the reduced model it comes as well
        if view.is_reducing {
            return Vec::new();
        }
        view.ticket = ticket;
        vec![Effect::Modes(ModesJob { ticket, wanted: Wanted::Deflection { study, at_hz } })]
    }

    pub(in crate::tui) fn edit_frequency(&mut self, edit: impl FnOnce(&mut TextField)) {
        if let Some(view) = &mut self.modes {
            edit(&mut view.field);
        }
    }

    fn accept_frequency(&mut self) -> Vec<Effect> {
        let Some(view) = &self.modes else { return Vec::new() };
        let text = without_groups(view.field.text().trim().trim_end_matches("Hz").trim());
        let Some([low, high]) = view.study().map(band) else { return Vec::new() };
        match text.parse::<f64>() {
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

    pub(in crate::tui) fn modes_found(&mut self, ticket: Ticket, result: Result<Answer, String>) -> Vec<Effect> {
        let Some(view) = self.modes.as_mut().filter(|view| view.ticket == ticket) else { return Vec::new() };
        match result {
            Ok(Answer::Modes(study)) => {
                let rows = rows::rows(&study);
                if view.rows.is_empty() {
                    // the rigid rotation is the least interesting
                    let first = usize::from(rows.len() > 1);
                    view.cursor = view.deflection_hz.map_or(first, |hz| nearest(&rows, hz, &study));
                }
                view.rows = rows;
                view.study = Some(Ok(study));
                view.is_reducing = false;
                view.keep_mac_in_bounds();
                view.deflection = None;
                return view.deflection_hz.map_or(Vec::new(), |hz| self.deflect(hz));
            }
            // it may have been left meanwhile
            Ok(Answer::Deflection(found)) => {
                if view.deflection_hz.is_some() {
                    view.deflection = Some(Ok(found));
                }
            }
            Err(error) if view.is_reducing => {
                view.is_reducing = false;
                view.model = 0;
                self.complain(error);
            }
            Err(error) if view.study().is_none() => view.study = Some(Err(error)),
            Err(error) => view.deflection = Some(Err(error)),
        }
        Vec::new()
    }
}

/// A number without the commas between its thousands; what has others stays as it is, and is no number: `1,5` is neither 1.5 nor 15.
fn without_groups(text: &str) -> String {
    let whole = text.split('.').next().unwrap_or_default();
    let mut groups = whole.split(',');
    let is_short = groups.next().is_some_and(|first| (1..=3).contains(&first.len()));
    let is_grouped = is_short && groups.all(|group| group.len() == 3);
    if is_grouped { text.replace(',', "") } else { text.to_owned() }
}

/// The row whose mode is nearest to a frequency.
fn nearest(rows: &[ModeRow], at_hz: f64, study: &Study) -> usize {
    let distance = |row: &ModeRow| (row.hz(study) - at_hz).abs();
    let nearest = rows.iter().enumerate().min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)));
    nearest.map_or(0, |(at, _)| at)
}

impl ModesView {
    /// Whether the action is one that only changes what is shown.
    fn look_otherwise(&mut self, action: Action) -> bool {
        match action {
            Action::NextPhase if self.mac.is_none() => self.phase = (self.phase + 1) % PHASES,
            Action::ShowMac => self.mac = if self.mac.is_some() { None } else { Some(self.place_in_mac()) },
            _ => return false,
        }
        true
    }

    /// Back from the MAC or the deflection shape to the mode; says whether there was one to leave.
    fn leave_picture(&mut self) -> bool {
        if self.mac.take().is_some() {
            return true;
        }
        self.deflection = None;
        self.study().is_some() && self.deflection_hz.take().is_some()
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
        let own = row.and_then(|row| row.partners[self.model]).map_or(0, |one| one.mode);
        (own, row.and_then(|row| row.fe).unwrap_or(0))
    }

    fn keep_mac_in_bounds(&mut self) {
        let mac = self.study().and_then(|study| study.one(self.model)).map(|small| small.mac.shape());
        if let (Some(mac), Some((row, column))) = (mac, &mut self.mac) {
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
