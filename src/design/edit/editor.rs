//! A design that is being edited: its text, what it says, and how it came to be.

use super::history::History;
use super::{Edit, EditName, steps};
use crate::design::document::Tree;
use crate::design::grid::{Grid, Sheet};
use crate::design::{Document, EditError, KeyPath, Reading, label, read};

/// A text with its history. What it says is read again after every change.
#[derive(Debug, Clone)]
pub struct Editor {
    document: Document,
    saved: String,
    reading: Reading,
    history: History,
}

/// What an edit did.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Applied {
    pub name: EditName,
    /// Where to look: the value that was set, the row where it is now. By place.
    pub focus: KeyPath,
    /// False where the text already said that; nothing is to be undone then.
    pub changed: bool,
}

impl Editor {
    /// The text as it was read from a file, which counts as saved.
    ///
    /// # Errors
    ///
    /// [`EditError::Syntax`] where the text is no TOML. What the values mean is not looked at.
    pub fn new(text: impl Into<String>) -> Result<Self, EditError> {
        let document = Document::parse(text)?;
        let (saved, reading) = (document.text().to_owned(), read(document.text()));
        Ok(Self { document, saved, reading, history: History::default() })
    }

    /// Makes the edit as a whole or not at all. The design may have errors afterwards: the [findings](Reading) say so.
    ///
    /// # Errors
    ///
    /// [`EditError`] where the edit cannot be made, or where the text would be no TOML after it.
    pub fn apply(&mut self, edit: &Edit) -> Result<Applied, EditError> {
        let name = EditName::of(edit, &self.document.tree());
        let mut steps = steps::Steps::new(self.document.clone());
        let focus = steps.make(edit)?;
        let changed = !steps.changes.is_empty();
        if changed {
            self.document = steps.document;
            let applied = Applied { name, focus, changed };
            self.history.push(applied.clone(), steps.changes);
            self.read_again();
            return Ok(applied);
        }
        Ok(Applied { name, focus, changed })
    }

    /// Takes the last edit back: the text is byte for byte what it was before.
    pub fn undo(&mut self) -> Option<Applied> {
        let applied = self.history.undo(&mut self.document)?;
        self.read_again();
        Some(applied)
    }

    /// Makes the edit again that was taken back last.
    pub fn redo(&mut self) -> Option<Applied> {
        let applied = self.history.redo(&mut self.document)?;
        self.read_again();
        Some(applied)
    }

    /// What [`undo`](Self::undo) would take back.
    pub fn undo_name(&self) -> Option<&EditName> {
        self.history.undo_name()
    }

    /// What [`redo`](Self::redo) would make again.
    pub fn redo_name(&self) -> Option<&EditName> {
        self.history.redo_name()
    }

    /// Is the text another than what was saved last?
    pub fn is_modified(&self) -> bool {
        self.document.text() != self.saved
    }

    /// This text is in the file now; what is edited may have moved on since. The history stays.
    pub fn mark_saved(&mut self, text: String) {
        self.saved = text;
    }

    /// The text that was saved last.
    pub fn saved_text(&self) -> &str {
        &self.saved
    }

    pub fn text(&self) -> &str {
        self.document.text()
    }

    /// The design of the text as it is now, and everything wrong with it.
    pub fn reading(&self) -> &Reading {
        &self.reading
    }

    /// A table of the design, with the findings of [`reading`](Self::reading) beside the cells, and mesh vectors that follow from gear data.
    pub fn grid(&self, sheet: &Sheet) -> Grid {
        let mut grid = Grid::new(self.text(), &self.reading.findings, sheet);
        grid.derive(self.text(), self.reading.design.as_ref());
        grid
    }

    /// Whether the text has that key or table.
    pub fn is_written(&self, path: &KeyPath) -> bool {
        self.document.tree().at(path).is_some()
    }

    /// How many keys the table has; none where it is not written.
    pub fn count_keys(&self, path: &KeyPath) -> usize {
        match self.document.tree().at(path) {
            Some(Tree::Table(keys)) => keys.len(),
            _ => 0,
        }
    }

    /// What people call the values at some paths: `outer diameter of pinion segment 3`.
    pub fn labels<'a>(&self, paths: impl Iterator<Item = &'a KeyPath>) -> Vec<String> {
        let tree = self.document.tree();
        paths.map(|path| label::of_value(&tree, path)).collect()
    }

    fn read_again(&mut self) {
        self.reading = read(self.document.text());
    }
}
