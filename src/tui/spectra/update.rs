//! Opening the screen, its keys, and what comes from the background.

use super::job::{Part, SpectraJob};
use super::{ListPlace, SpectraView, readout};
use crate::model::ModelKind;
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::keymap::Mode;
use crate::tui::message::Effect;
use crate::tui::solving::Ticket;

impl App {
    /// Opens the screen on the selected design, or on the one whose tables are in sight, as it is now.
    pub(in crate::tui) fn open_spectra(&mut self) -> Vec<Effect> {
        let (name, path, text) = if let Some(editing) = self.editors.open() {
            let row = self.library.row(&editing.path);
            let name = row.map_or_else(String::new, crate::tui::library::Row::name);
            (name, editing.path.clone(), Some(editing.editor.text().to_owned()))
        } else {
            let Some(row) = self.library.selected() else { return Vec::new() };
            (row.name(), row.path.clone(), self.editors.unsaved_text(&row.path))
        };
        let is_edited = self.editors.unsaved_text(&path).is_some();
        let unsaved = if is_edited { " (unsaved edits)" } else { "" };
        let ticket = self.ticket();
        self.spectra = Some(SpectraView::new(ticket, name + unsaved, path, text, is_edited));
        self.open(Mode::Spectra);
        self.ask_for_spectra()
    }

    /// Asks for what is wanted; what is known goes along.
    fn ask_for_spectra(&mut self) -> Vec<Effect> {
        let ticket = self.ticket();
        let Some(view) = &mut self.spectra else { return Vec::new() };
        view.ticket = ticket;
        view.pending = Some(0.0);
        view.failure = None;
        view.missing.clear();
        let mut kinds = vec![ModelKind::Fe, view.against()];
        kinds.extend(view.shown_kinds().filter(|kind| !kinds.contains(kind)).collect::<Vec<_>>());
        vec![Effect::Spectra(Box::new(SpectraJob {
            ticket,
            path: view.path.clone(),
            text: view.text.clone(),
            known: view.known.clone(),
            kinds,
            quantity: view.quantity,
            against: view.against(),
            tolerance: view.tolerance,
        }))]
    }

    pub(in crate::tui) fn spectra_came(&mut self, ticket: Ticket, part: &Part) {
        if let Some(view) = self.spectra.as_mut().filter(|view| view.ticket == ticket) {
            view.take(part);
        }
    }

    /// What a key does on the screen; nothing if it is not its own.
    pub(in crate::tui) fn act_in_spectra(&mut self, action: Action) -> Option<Vec<Effect>> {
        let own = matches!(self.mode, Mode::Spectra);
        match action {
            Action::OpenSpectra => return Some(self.open_spectra()),
            Action::Why if own => self.open_why(),
            Action::Back | Action::Help | Action::Palette | Action::Messages | Action::Copy | Action::Modes => {
                return None;
            }
            _ if own => {
                let view = self.spectra.as_mut()?;
                let against = view.against;
                let wants_more = view.act(action);
                let name = readout::legend_name(view.against());
                if view.against != against {
                    self.say(format!("held against FE: {name}"));
                }
                return if wants_more { Some(self.ask_for_spectra()) } else { is_of_screen(action).then(Vec::new) };
            }
            _ => return None,
        }
        Some(Vec::new())
    }

    fn open_why(&mut self) {
        let next = self.keys.names(Mode::Spectra, self.theme.glyphs.ascii).of(Action::NextBand);
        let Some(view) = &mut self.spectra else { return };
        if view.band_under().is_none() {
            let why = match view.findings() {
                Some(findings) if !findings.bands.is_empty() => format!("no band here: {next} goes to the next"),
                Some(findings) => format!("no band: no line is off by more than {} dB", findings.tolerance),
                None => "the bands are not known yet".into(),
            };
            return self.complain(why);
        }
        view.scroll.top = 0;
        self.open(Mode::Why);
    }

    pub(in crate::tui) fn close_spectra(&mut self) -> Vec<Effect> {
        if let Some(view) = self.spectra.as_mut().filter(|view| view.is_list_alone()) {
            view.list_place = ListPlace::Hidden;
            return Vec::new();
        }
        self.spectra = None;
        self.close();
        vec![Effect::CancelSpectra]
    }
}

/// Whether an action is done with on the screen; others mean the same everywhere.
fn is_of_screen(action: Action) -> bool {
    !matches!(
        action,
        Action::CycleMarker
            | Action::ToggleBackground
            | Action::CopyPath
            | Action::Redraw
            | Action::Suspend
            | Action::Quit
    )
}
