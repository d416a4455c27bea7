//! What the keys do on the screen of the bearings.

use super::text::as_text;
use super::torque::{LARGE_STEP, STEP, edit, typed};
use super::{BearingsView, follows_torque, places, rows, shown_torque, stepped, torque};
use crate::design::{Edit, KeyPath, Side};
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::editor::{Editing, Tab};
use crate::tui::keymap::Mode;
use crate::tui::message::Effect;
use crate::tui::text_field::TextField;

impl App {
    /// Does an action of the screen, or opens it; nothing where the action is another's.
    pub(in crate::tui) fn act_in_bearings(&mut self, action: Action) -> Option<Vec<Effect>> {
        if action == Action::BearingLoads {
            return Some(self.open_bearings());
        }
        if self.mode == Mode::Torque {
            return (action == Action::Accept).then(|| self.accept_torque());
        }
        if self.mode != Mode::Bearings {
            return None;
        }
        if let Some(editing) = self.editors.open_mut() {
            editing.notice = None;
        }
        match action {
            Action::Back => return Some(self.close_bearings()),
            Action::OpenEditor => {
                self.go_to_bearing();
                return Some(Vec::new());
            }
            Action::MoreTorque => return Some(self.step_torque(true, STEP)),
            Action::LessTorque => return Some(self.step_torque(false, STEP)),
            Action::MuchMoreTorque => return Some(self.step_torque(true, LARGE_STEP)),
            Action::MuchLessTorque => return Some(self.step_torque(false, LARGE_STEP)),
            Action::TypeTorque => {
                let design = self.editors.open().and_then(|editing| editing.last_design.as_ref());
                let now = design.and_then(|design| torque(design));
                let field = TextField::proposed(now.map_or(String::new(), |torque| format!("{torque:?}")));
                self.bearings.as_mut()?.field = field;
                self.open(Mode::Torque);
            }
            Action::NextView => {
                let view = self.bearings.as_mut()?;
                let at = view.shared.iter().position(|pane| *pane == view.pane).map_or(0, |at| at + 1);
                view.pane = view.shared.get(at).or(view.shared.first()).copied().unwrap_or_default();
            }
            Action::PreviousElement => self.move_element(-1),
            Action::NextElement => self.move_element(1),
            Action::Undo | Action::Redo => return Some(self.step_in_bearings(action)),
            _ => return self.act_on_solution(action),
        }
        Some(Vec::new())
    }

    /// Opens the screen over the tables, which are read first where they are not open.
    fn open_bearings(&mut self) -> Vec<Effect> {
        if self.editors.open().is_some() {
            self.show_bearings(false);
            return Vec::new();
        }
        let effects = self.open_editor();
        if self.editors.open().is_some() {
            self.show_bearings(true);
        } else {
            self.editors.then_bearings = true;
        }
        effects
    }

    /// The tables are there: shows the screen over them, on the bearing under their cursor.
    pub(in crate::tui) fn show_bearings(&mut self, from_list: bool) {
        let Some(editing) = self.editors.open() else { return };
        let at = (editing.tab == Tab::Bearings).then(|| (editing.side, editing.cursor().row));
        let design = editing.last_design.as_ref();
        let cursor = design.and_then(|design| places(design).position(|place| Some(place) == at));
        self.bearings = Some(BearingsView { cursor: cursor.unwrap_or(0), from_list, ..BearingsView::default() });
        self.open(Mode::Bearings);
    }

    fn close_bearings(&mut self) -> Vec<Effect> {
        let from_list = self.bearings.take().is_some_and(|view| view.from_list);
        self.close();
        if from_list { self.close_editor() } else { Vec::new() }
    }

    /// To the row of the bearing in the tables.
    fn go_to_bearing(&mut self) {
        let cursor = self.bearings.take().map_or(0, |view| view.cursor);
        if let Some(editing) = self.editors.open_mut()
            && let Some((side, place)) = place_of(editing, cursor)
        {
            editing.go_to(&KeyPath::root().key(side.name()).key("bearing").place(place));
        }
        self.close();
    }

    pub(in crate::tui) fn move_in_bearings(&mut self, by: isize) {
        let count = self.editors.open().map_or(0, |editing| rows(editing).len());
        if let Some(view) = &mut self.bearings {
            let cursor = view.cursor.saturating_add_signed(by).min(count.saturating_sub(1));
            if cursor != view.cursor {
                (view.cursor, view.element) = (cursor, 0);
            }
        }
    }

    /// Round the ring.
    fn move_element(&mut self, by: isize) {
        let Some((editing, view)) = self.editors.open().zip(self.bearings.as_mut()) else { return };
        let row = rows(editing).get(view.cursor).copied();
        let count = row.and_then(|row| row.rolling).map_or(0, |rolling| rolling.state.contacts.len());
        if count > 0 {
            let element = view.element.min(count - 1).cast_signed() + by;
            view.element = element.rem_euclid(count.cast_signed()).cast_unsigned();
        }
    }

    /// Whether the selected bearing has elements to be read out.
    pub(in crate::tui) fn has_elements(&self) -> bool {
        let row = self
            .editors
            .open()
            .zip(self.bearings.as_ref())
            .map(|(editing, view)| rows(editing).get(view.cursor).copied());
        row.flatten().is_some_and(|row| row.rolling.is_some())
    }

    fn step_torque(&mut self, up: bool, part: f64) -> Vec<Effect> {
        let keys = self.keys.names(Mode::Bearings, self.theme.glyphs.ascii);
        let how = keys.of(Action::TypeTorque);
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        let Some(now) = editing.design.as_ref().and_then(|design| torque(design)) else {
            let why = if editing.design.is_some() { "no torque is given" } else { "the design has errors" };
            editing.warn(format!("{why}: {how} types a torque"));
            return Vec::new();
        };
        let next = stepped(now, up, part);
        let edit = if next == now { None } else { edit(next) };
        self.edit_torque(edit.ok_or_else(|| "no further step".to_owned()))
    }

    fn accept_torque(&mut self) -> Vec<Effect> {
        let Some((view, editing)) = self.bearings.as_ref().zip(self.editors.open()) else { return Vec::new() };
        match typed(editing, view.field.text()) {
            Ok(edit) => {
                self.close();
                self.edit_torque(Ok(edit))
            }
            Err(error) => {
                self.complain(error);
                Vec::new()
            }
        }
    }

    fn edit_torque(&mut self, edit: Result<Edit, String>) -> Vec<Effect> {
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        match edit.and_then(|edit| editing.apply(&edit).map_err(|error| error.to_string())) {
            Ok(_) => say_torque(editing),
            Err(error) => editing.warn(error),
        }
        self.after_edit()
    }

    /// Undo and redo; the table stays where it was.
    fn step_in_bearings(&mut self, action: Action) -> Vec<Effect> {
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        let place = (editing.tab, editing.side);
        if action == Action::Undo {
            editing.undo();
        } else {
            editing.redo();
        }
        editing.show(place.0, place.1);
        let count = rows(editing).len();
        if let Some(view) = &mut self.bearings {
            view.cursor = view.cursor.min(count.saturating_sub(1));
        }
        self.after_edit()
    }

    /// The selected bearing in words, for the clipboard.
    pub(in crate::tui) fn bearings_text(&self) -> Option<String> {
        let (view, editing) = (self.bearings.as_ref()?, self.editors.open()?);
        rows(editing).get(view.cursor).map(as_text)
    }

    pub(in crate::tui) fn edit_torque_field(&mut self, edit: impl FnOnce(&mut TextField)) {
        if let Some(view) = &mut self.bearings {
            edit(&mut view.field);
        }
    }
}

fn place_of(editing: &Editing, cursor: usize) -> Option<(Side, usize)> {
    rows(editing).get(cursor).map(|row| (row.side, row.place))
}

fn say_torque(editing: &mut Editing) {
    let torque = editing.design.as_ref().and_then(|design| torque(design));
    let now = torque.map_or("no torque".into(), |torque| format!("torque {} N m", shown_torque(torque)));
    let without = if torque.is_some_and(|torque| torque < 0.0) {
        ", its sign does not count"
    } else if follows_torque(editing) {
        ""
    } else {
        ": no bearing follows it, and neither do the spectra"
    };
    editing.say(format!("{now}{without}"));
}
