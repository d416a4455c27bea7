//! An edit as the changes of the text that make it up.

use super::{Edit, Towards, bearing, material, row, value};
use crate::design::EditError;
use crate::design::document::{Change, Document, NewRow, Tree};
use crate::design::key_path::{KeyPath, Step};

/// A document on its way through an edit. If a step fails, it is thrown away.
pub(super) struct Steps {
    pub document: Document,
    pub changes: Vec<Change>,
}

impl Steps {
    pub fn new(document: Document) -> Self {
        Self { document, changes: Vec::new() }
    }

    /// Makes the edit, and says where to look afterwards.
    pub fn make(&mut self, edit: &Edit) -> Result<KeyPath, EditError> {
        let tree = self.tree();
        match edit {
            Edit::Set { path, value } => value::set(self, &tree.by_place(path), value.as_str()),
            Edit::Remove { path } => value::remove(self, &tree.by_place(path)),
            Edit::Comment { path, text } => {
                let change = self.document.comment(path, text)?;
                self.changes.extend(change);
                Ok(tree.by_place(path))
            }
            Edit::InsertRow { list, place } => row::insert(self, list, *place),
            Edit::DuplicateRow { row } => row::duplicate(self, &tree.by_place(row)),
            Edit::DeleteRow { row } => row::delete(self, &tree.by_place(row)),
            Edit::MoveRow { row, towards } => self.move_row(&tree.by_place(row), *towards),
            Edit::SetModel { bearing, model } => bearing::set_model(self, &tree.by_place(bearing), model),
            Edit::AddMaterial { name } => material::add(self, name),
            Edit::RenameMaterial { from, to } => material::rename(self, from, to),
            Edit::RemoveMaterial { name } => material::remove(self, name),
            // the last one says where to look
            Edit::Several { edits, .. } => edits.iter().try_fold(KeyPath::root(), |_, edit| self.make(edit)),
            Edit::ReplaceText { text, .. } => {
                let change = self.document.replace(text)?;
                self.changes.extend(change);
                Ok(KeyPath::root())
            }
        }
    }

    fn move_row(&mut self, row: &KeyPath, towards: Towards) -> Result<KeyPath, EditError> {
        let (list, place) = row_of(row)?;
        let count = self.tree().at(&list).map_or(0, |list| list.entries().len());
        let refused = |end: &str| EditError::Refused(format!("this is the {end} one already"));
        let to = match towards {
            Towards::Start => place.checked_sub(1).ok_or_else(|| refused("first"))?,
            Towards::End if place + 1 < count => place + 1,
            Towards::End => return Err(refused("last")),
        };
        let change = self.document.swap_rows(&list, place.min(to))?;
        self.changes.extend(change);
        Ok(list.place(to))
    }

    pub fn tree(&self) -> Tree {
        self.document.tree()
    }

    pub fn put(&mut self, path: &KeyPath, value: &str) -> Result<(), EditError> {
        let change = self.document.put(path, value)?;
        self.changes.extend(change);
        Ok(())
    }

    /// The same value at several paths.
    pub fn put_all(&mut self, paths: &[KeyPath], value: &str) -> Result<(), EditError> {
        let change = self.document.put_all(paths, value)?;
        self.changes.extend(change);
        Ok(())
    }

    pub fn remove(&mut self, path: &KeyPath) -> Result<(), EditError> {
        let change = self.document.remove(path)?;
        self.changes.extend(change);
        Ok(())
    }

    pub fn insert_row(&mut self, list: &KeyPath, place: usize, row: &NewRow) -> Result<(), EditError> {
        let change = self.document.insert_row(list, place, row)?;
        self.changes.extend(change);
        Ok(())
    }

    pub fn delete_row(&mut self, list: &KeyPath, place: usize) -> Result<(), EditError> {
        let change = self.document.delete_row(list, place)?;
        self.changes.extend(change);
        Ok(())
    }

    pub fn rename(&mut self, path: &KeyPath, name: &str) -> Result<(), EditError> {
        let change = self.document.rename(path, name)?;
        self.changes.extend(change);
        Ok(())
    }
}

/// The list of a row, and the row's place in it.
pub(super) fn row_of(row: &KeyPath) -> Result<(KeyPath, usize), EditError> {
    match row.split_last() {
        Some((list, Step::Place(place))) => Ok((list, *place)),
        _ => Err(EditError::NotThere(row.clone())),
    }
}
