//! What an edit is called.

use std::fmt;

use super::{Edit, Towards};
use crate::design::document::Tree;
use crate::design::label;

/// What an edit is called, by meaning: `outer diameter of pinion segment 3`. May hold characters of the file: make it
/// [printable](crate::text::printable) before it is shown.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct EditName(String);

impl EditName {
    pub fn new(name: impl Into<String>) -> Self {
        Self(name.into())
    }

    /// The name of an edit of the design before it.
    pub(super) fn of(edit: &Edit, tree: &Tree) -> Self {
        let row = |row| label::of_row_in_words(tree, &tree.by_place(row));
        let value = |path| label::of_value(tree, &tree.by_place(path));
        Self(match edit {
            Edit::Set { path, .. } => value(path),
            Edit::Remove { path } => format!("clear {}", value(path)),
            Edit::Comment { path, .. } => format!("comment of {}", value(path)),
            Edit::InsertRow { list, place } => {
                // the row is not there yet and has no name
                format!("insert {}", label::of_row_in_words(&Tree::table(), &list.place(*place)))
            }
            Edit::DuplicateRow { row: path } => format!("duplicate {}", row(path)),
            Edit::DeleteRow { row: path } => format!("delete {}", row(path)),
            Edit::MoveRow { row: path, towards: Towards::Start } => format!("move {} up", row(path)),
            Edit::MoveRow { row: path, towards: Towards::End } => format!("move {} down", row(path)),
            Edit::SetModel { bearing, model } => {
                format!("model of {}: {model}", label::of_table(tree, &tree.by_place(bearing)))
            }
            Edit::AddMaterial { name } => format!("add material {name}"),
            Edit::RenameMaterial { from, to } => format!("rename material {from} to {to}"),
            Edit::RemoveMaterial { name } => format!("remove material {name}"),
            Edit::ReplaceText { name, .. } | Edit::Several { name, .. } => return name.clone(),
        })
    }

    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for EditName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}
