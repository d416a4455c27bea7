//! Rows that come, go and move.

use super::Editing;
use super::typing::{Input, Target};
use super::view::Tab;
use crate::design::grid::Shape;
use crate::design::{Edit, KeyPath, Spelled, Towards};

impl Editing {
    /// Adds a row beside the cursor.
    pub fn add_row(&mut self, after: bool) {
        let row = self.cursor().row;
        let Some(sheet) = self.view.sheet(row) else { return };
        match sheet.shape {
            Shape::List { .. } => {
                let place = if self.view.rows.is_empty() { 0 } else { row + usize::from(after) };
                let edit = Edit::InsertRow { list: sheet.path.clone(), place };
                if let Some(applied) = self.make(&edit) {
                    self.go_to(&applied.focus);
                    self.say(format!("done: {}", applied.name));
                }
            }
            Shape::Named => self.input = Some(Input::new(Target::NewMaterial, "", true)),
            Shape::Single if self.lacks_drive() => self.add_drive(),
            Shape::Single => self.say("this table has no rows to add"),
        }
    }

    /// Does something to the row under the cursor.
    fn edit_row(&mut self, edit: impl FnOnce(KeyPath) -> Edit) {
        let row = self.cursor().row;
        let is_list = matches!(self.view.shape, Shape::List { .. });
        let Some(path) = self.view.row(row).filter(|_| is_list).map(|row| row.path.clone()) else {
            return self.say("no row of a list");
        };
        // rows that are alike change places without a trace in the text
        if let Some(applied) = self.make(&edit(path)) {
            let column = self.cursor().column;
            self.go_to(&applied.focus);
            self.cursor_mut().column = column;
            self.hold_cursor();
            self.say(format!("done: {}", applied.name));
        }
    }

    pub fn duplicate_row(&mut self) {
        self.edit_row(|row| Edit::DuplicateRow { row });
    }

    /// The table of the drive is in sight, and the shaft has none.
    pub fn lacks_drive(&self) -> bool {
        self.tab == Tab::Drives && !self.has_drive()
    }

    /// The table of the drive is in sight, and the shaft has one.
    pub fn has_drive(&self) -> bool {
        let cells = self.view.row(0).map_or(&[][..], |row| &row.cells);
        self.tab == Tab::Drives && cells.iter().any(|cell| cell.shown.is_written())
    }

    /// A drive at the end of the shaft; what else it needs is left open, and findings say so.
    fn add_drive(&mut self) {
        let length = self.last_design.as_ref().map_or(0.0, |design| design.rotor(self.side).length());
        let path = KeyPath::root().key(self.side.name()).key("drive").key("position_mm");
        let Some(value) = Spelled::parse(&format!("{:?}", (length * 1e9).round() / 1e6)) else { return };
        if let Some(applied) = self.make(&Edit::Set { path, value }) {
            self.go_to(&applied.focus);
            self.say(format!("done: {}; stiffness and inertia are still wanted", applied.name));
        }
    }

    fn remove_drive(&mut self) {
        let path = KeyPath::root().key(self.side.name()).key("drive");
        if let Some(applied) = self.make(&Edit::Remove { path }) {
            self.hold_cursor();
            self.say(format!("done: {}; the shaft's end turns freely", applied.name));
        }
    }

    pub fn delete_row(&mut self) {
        if self.has_drive() {
            return self.remove_drive();
        }
        if self.tab == Tab::Drives {
            return self.say("this shaft has no drive");
        }
        if self.view.shape != Shape::Named {
            return self.edit_row(|row| Edit::DeleteRow { row });
        }
        let Some(name) = self.view.row(self.cursor().row).map(|row| row.label.clone()) else { return };
        if let Some(applied) = self.make(&Edit::RemoveMaterial { name }) {
            self.say(format!("done: {}", applied.name));
        }
    }

    pub fn move_row(&mut self, towards: Towards) {
        self.edit_row(|row| Edit::MoveRow { row, towards });
    }
}
