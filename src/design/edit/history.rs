//! What was done, and what was taken back.

use super::{Applied, EditName};
use crate::design::document::{Change, Document};

/// Edits as differences of the text.
#[derive(Debug, Clone, Default)]
pub(super) struct History {
    done: Vec<Entry>,
    undone: Vec<Entry>,
}

#[derive(Debug, Clone)]
struct Entry {
    applied: Applied,
    changes: Vec<Change>,
}

impl History {
    /// What was taken back before cannot be made again after something else was done.
    pub fn push(&mut self, applied: Applied, changes: Vec<Change>) {
        self.undone.clear();
        self.done.push(Entry { applied, changes });
    }

    pub fn undo(&mut self, document: &mut Document) -> Option<Applied> {
        let entry = self.done.pop()?;
        entry.changes.iter().rev().for_each(|change| change.undo(document.text_mut()));
        let applied = entry.applied.clone();
        self.undone.push(entry);
        Some(applied)
    }

    pub fn redo(&mut self, document: &mut Document) -> Option<Applied> {
        let entry = self.undone.pop()?;
        entry.changes.iter().for_each(|change| change.redo(document.text_mut()));
        let applied = entry.applied.clone();
        self.done.push(entry);
        Some(applied)
    }

    pub fn undo_name(&self) -> Option<&EditName> {
        self.done.last().map(|entry| &entry.applied.name)
    }

    pub fn redo_name(&self) -> Option<&EditName> {
        self.undone.last().map(|entry| &entry.applied.name)
    }
}
