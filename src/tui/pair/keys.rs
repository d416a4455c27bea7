//! Opening the screen, its keys, and the edits that they make.

use super::PairView;
use crate::design::{Edit, KeyPath, Spelled, Turns};
use crate::number::significant;
use crate::text::printable;
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::editor::Editing;
use crate::tui::keymap::Mode;
use crate::tui::message::Effect;

impl App {
    /// Does an action of the screen, or opens it; nothing where the action is another's.
    pub(in crate::tui) fn act_in_pair(&mut self, action: Action) -> Option<Vec<Effect>> {
        match (action, self.mode) {
            (Action::GearPair, _) => return Some(self.open_pair()),
            (Action::Back, Mode::Pair) => return Some(self.close_pair()),
            (Action::Back, Mode::FaceWidth | Mode::MeshFile | Mode::MeshImport) => self.close_pair_form(),
            (Action::Accept, Mode::FaceWidth) => return Some(self.accept_estimate()),
            (Action::Accept, Mode::MeshFile) => return Some(self.read_mesh_file()),
            (Action::Accept, Mode::MeshImport) => return Some(self.accept_import()),
            (Action::OtherFlank, _) => self.other_flank(),
            (Action::OtherValue, _) => {
                self.pair.as_mut()?.estimate.as_mut()?.switch();
            }
            (Action::FlipFlank, Mode::Pair) => return Some(self.flip_flank()),
            (Action::EstimateStiffness, Mode::Pair) => self.open_estimate(),
            (Action::ImportMesh, Mode::Pair) => self.open_import(),
            (Action::Undo, Mode::Pair) => return Some(self.step_in_pair(Editing::undo)),
            (Action::Redo, Mode::Pair) => return Some(self.step_in_pair(Editing::redo)),
            (Action::Save, Mode::Pair) => return Some(self.save(None)),
            _ => return None,
        }
        Some(Vec::new())
    }

    /// From the tables at once, from the list as soon as their text is there.
    fn open_pair(&mut self) -> Vec<Effect> {
        let from_list = self.editors.open().is_none();
        self.pair = Some(Box::new(PairView { from_list, ..PairView::default() }));
        if !from_list {
            self.open(Mode::Pair);
            return Vec::new();
        }
        let effects = self.open_editor();
        self.show_awaited_pair();
        effects
    }

    /// The tables of a design are there, or not: of its gear pair, if that was asked for.
    pub(in crate::tui) fn show_awaited_pair(&mut self) {
        let is_shown = self.layers().any(|mode| mode == Mode::Pair);
        if is_shown || self.pair.is_none() {
            return;
        }
        if self.editors.open().is_some() && self.below.is_empty() {
            self.open(Mode::Pair);
        } else if self.editors.opening.is_none() {
            self.pair = None;
        }
    }

    fn close_pair(&mut self) -> Vec<Effect> {
        let from_list = self.pair.take().is_some_and(|view| view.from_list);
        self.close();
        if from_list && self.below.is_empty() { self.close_editor() } else { Vec::new() }
    }

    /// Closes what lies over the screen; nothing of it is taken.
    pub(super) fn close_pair_form(&mut self) {
        if let Some(view) = &mut self.pair {
            (view.estimate, view.import) = (None, None);
        }
        self.close();
    }

    /// Makes an edit, says so, and solves again.
    pub(super) fn edit_pair(&mut self, edit: &Edit) -> Vec<Effect> {
        self.edit_pair_saying(edit, |name| format!("done: {name}"))
    }

    /// The same, with words of its own for what was done; they are given the edit's name.
    pub(super) fn edit_pair_saying(&mut self, edit: &Edit, done: impl FnOnce(&str) -> String) -> Vec<Effect> {
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        match editing.apply(edit) {
            Ok(applied) => {
                let name = printable(applied.name.as_str()).into_owned();
                self.say(if applied.changed { done(&name) } else { "as it was already".into() });
            }
            Err(error) => self.complain(printable(&error.to_string())),
        }
        self.after_edit()
    }

    fn step_in_pair(&mut self, step: fn(&mut Editing)) -> Vec<Effect> {
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        step(editing);
        if let Some(notice) = editing.notice.take() {
            self.say(printable(&notice.text));
        }
        self.after_edit()
    }

    /// The pinion turns the other way, so that the other side of the teeth carries the load.
    fn flip_flank(&mut self) -> Vec<Effect> {
        let design = self.editors.open().and_then(|editing| editing.last_design.clone());
        let Some(geometry) = design.and_then(|design| design.mesh.geometry) else {
            self.complain("mesh vectors are of one flank only: the other needs gear data, or an import");
            return Vec::new();
        };
        let word = match geometry.pinion_turns {
            Turns::Positive => "negative",
            Turns::Negative => "positive",
        };
        let path = KeyPath::root().key("mesh").key("geometry").key("pinion_turns");
        let angle = significant(geometry.pressure_angle.to_degrees(), 3);
        self.edit_pair_saying(&Edit::Set { path, value: Spelled::text(word) }, |_| {
            format!("other flank; pressure angle as written, {angle} deg: write its own if it differs")
        })
    }
}
