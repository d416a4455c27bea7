//! Rows that come, go and move.

use super::Editing;
use super::typing::{Input, Target};
use crate::design::grid::Shape;
use crate::design::{Edit, KeyPath, Towards};

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

    pub fn delete_row(&mut self) {
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
