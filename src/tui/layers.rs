//! What lies over what: the mode that listens to the keys, and those below it.

use super::action::Action;
use super::app::App;
use super::conflict::Conflict;
use super::editor::{Editing, Layer, Tab};
use super::keymap::Mode;
use super::message::Effect;
use crate::crash;
use crate::design::grid::{CellKind, Shape};

impl App {
    /// All modes, the lowest first.
    pub fn layers(&self) -> impl Iterator<Item = Mode> {
        self.below.iter().copied().chain([self.mode])
    }

    /// Puts a mode over the present one.
    pub(super) fn open(&mut self, mode: Mode) {
        self.below.push(self.mode);
        self.mode = mode;
    }

    /// Back to the mode below.
    pub(super) fn close(&mut self) {
        self.mode = self.below.pop().unwrap_or(Mode::Library);
        // the text may have gone while something lay over it
        if self.mode == Mode::Text && !self.has_text() {
            self.mode = Mode::Library;
        }
        self.follow_editor();
    }

    /// What a key or the palette asks for: of the screen first that is in sight.
    pub(super) fn run(&mut self, action: Action) -> Vec<Effect> {
        crash::remember(self.mode.name(), action.name());
        if action == Action::ExportShown {
            self.open_export();
            return Vec::new();
        }
        if let Some(effects) = self.act_in_spectra(action) {
            return effects;
        }
        if let Some(effects) = self.act_in_bearings(action) {
            return effects;
        }
        let in_screen = self.act_in_new(action).or_else(|| self.act_in_editor(action));
        let in_screen = in_screen.or_else(|| self.act_in_modes(action)).or_else(|| self.act_in_pair(action));
        in_screen.or_else(|| self.act_in_overview(action)).unwrap_or_else(|| self.act(action))
    }

    /// Whether an action would do something now.
    pub fn applies(&self, action: Action) -> bool {
        let panes = matches!(self.mode, Mode::Library | Mode::Text | Mode::Filter);
        let selected = self.library.selected();
        match action {
            Action::NextPane => self.has_text() && self.detail.text_scroll.last() > 0,
            Action::NextMatch | Action::PreviousMatch if self.mode == Mode::Help => !self.help_search.is_empty(),
            Action::NextMatch | Action::PreviousMatch => {
                !self.library.filter().is_empty() && self.mode == Mode::Library
            }
            Action::Filter | Action::MoveUp | Action::MoveDown if panes => !self.library.is_empty(),
            Action::Back => self.mode != Mode::Library || !self.library.filter().is_empty(),
            Action::Mark
            | Action::Rename
            | Action::Duplicate
            | Action::Delete
            | Action::OpenEditor
            | Action::OpenSpectra
            | Action::BearingLoads => selected.is_some(),
            Action::NextDirection => self.spectra.as_ref().is_some_and(|view| view.quantity.has_parts()),
            Action::Why => self.spectra.as_ref().is_some_and(|view| view.band_under().is_some()),
            Action::SortColumn | Action::SortDirection | Action::ShowDesign => self.library.matches() > 0,
            // in the tables there is more to say
            Action::Overview => self.editors.open().is_none(),
            Action::NextPhase => self.modes.as_ref().is_some_and(|view| view.study().is_some() && view.mac.is_none()),
            Action::OtherModel | Action::ShowMac | Action::Deflection | Action::TypeFrequency => {
                self.modes.as_ref().is_some_and(|view| view.study().is_some())
            }
            Action::Modes | Action::GearPair if self.editors.open().is_none() => selected.is_some(),
            Action::MoveLeft | Action::MoveRight if self.mode == Mode::Modes => {
                self.modes.as_ref().is_some_and(|view| view.mac.is_some() || view.deflection_hz.is_some())
            }
            Action::Compare => selected.is_some_and(|row| self.compared_with(row).is_some()),
            Action::NextElement | Action::PreviousElement => self.has_elements(),
            Action::NextView => self.bearings.as_ref().is_some_and(|view| view.shared.len() > 1),
            Action::Undo | Action::Redo | Action::Save | Action::Solve | Action::CancelSolve
                if self.mode == Mode::Bearings =>
            {
                self.editors.open().is_some_and(|editing| applies_in_editor(editing, action))
            }
            Action::NextOffer => self.recovery.offers.all.len() > 1,
            Action::TakeTheirs => self.conflicts.present().is_some_and(Conflict::can_be_taken),
            Action::Quit
                if matches!(self.mode, Mode::Leave | Mode::Recovery | Mode::Conflict) || self.mode.is_typing() =>
            {
                false
            }
            // everyone knows, and there is much to say
            Action::MoveUp | Action::MoveDown if self.mode == Mode::Table => false,
            Action::Undo | Action::Redo | Action::Save | Action::FlipFlank if self.mode == Mode::Pair => {
                self.editors.open().is_some_and(|editing| applies_in_editor(editing, action))
            }
            _ if !self.below.is_empty() => true,
            _ => self.editors.open().is_none_or(|editing| applies_in_editor(editing, action)),
        }
    }
}

fn applies_in_editor(editing: &Editing, action: Action) -> bool {
    let is_list = matches!(editing.view.shape, Shape::List { .. });
    let is_there = editing.view.row(editing.cursor().row).is_some();
    match action {
        Action::Undo => editing.editor.undo_name().is_some(),
        Action::Redo => editing.editor.redo_name().is_some(),
        Action::Save => editing.is_modified(),
        Action::OtherShaft => editing.tab.has_sides(),
        Action::AddRow => editing.view.shape != Shape::Single || editing.lacks_drive(),
        Action::DeleteRow if editing.tab == Tab::Drives => editing.has_drive(),
        Action::DuplicateRow => is_list && is_there,
        Action::DeleteRow => editing.view.shape != Shape::Single && is_there,
        Action::CancelSolve => editing.solving.pending.is_some(),
        Action::Solve => editing.solving.pending.is_none() && editing.wants_solution(),
        Action::Findings => !editing.problems().is_empty(),
        Action::CycleCell => {
            editing.cell().is_some_and(|cell| matches!(cell.kind, CellKind::Choice(_) | CellKind::Model(_)))
        }
        Action::ClearCell => {
            let target = editing.target();
            target.is_some_and(|cell| cell.shown.is_written() && !cell.required)
        }
        Action::Tick => matches!(&editing.layer, Some(Layer::Choice(choice)) if choice.ticked.is_some()),
        Action::FlipFlank => editing.last_design.as_ref().is_some_and(|design| design.mesh.geometry.is_some()),
        Action::NextCell => !editing.view.is_turned(),
        _ => true,
    }
}
