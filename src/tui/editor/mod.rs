//! The editor: a design's tables, solved again while they change.
//!
//! ```text
//! key ─> edit of the text ─> reading ─┬─> tables, findings, side view
//!                                     └─> job on the worker ─> spectra over those of the saved state
//! ```
//!
//! One [`Editing`] a design, kept while the program runs. What the keys go to follows from its state
//! ([`Editing::mode`]): a cell that is typed into, a layer over the table, or the table.

mod cursor;
mod editing;
mod form;
mod keys;
mod outside;
mod rows;
mod saving;
mod solving;
mod typing;
mod update;
mod view;

use std::path::{Path, PathBuf};

use super::files::Followed;

pub use cursor::Cursor;
pub use editing::{Editing, Layer, List, Notice, shown_text};
pub use form::Form;
pub use solving::{Ghost, Pending, Solution, Solving, same_mechanics};
pub use typing::{Choice, Entry, FROM_GEOMETRY, Input, Target};
pub use view::{Place, Tab, View, ViewColumn, ViewRow};

/// The designs that are being edited.
#[derive(Debug)]
pub struct Editors {
    all: Vec<Editing>,
    /// The one in sight
    open: Option<PathBuf>,
    /// The one whose text is being read
    pub(super) opening: Option<PathBuf>,
    /// Its bearings are shown once it is there
    pub(super) then_bearings: bool,
    /// Whether each edit is solved
    pub live: bool,
    /// The program ends once everything is saved.
    pub(super) is_leaving: bool,
    /// What was said last, and is with the messages
    kept_notice: Option<Notice>,
}

impl Default for Editors {
    fn default() -> Self {
        Self {
            all: Vec::new(),
            open: None,
            opening: None,
            then_bearings: false,
            live: true,
            is_leaving: false,
            kept_notice: None,
        }
    }
}

impl Editors {
    /// The design whose tables are in sight.
    pub fn open(&self) -> Option<&Editing> {
        self.open.as_deref().and_then(|path| self.get(path))
    }

    pub fn open_mut(&mut self) -> Option<&mut Editing> {
        let path = self.open.clone()?;
        self.get_mut(&path)
    }

    pub fn get(&self, path: &Path) -> Option<&Editing> {
        self.all.iter().find(|editing| editing.path == path)
    }

    pub fn get_mut(&mut self, path: &Path) -> Option<&mut Editing> {
        self.all.iter_mut().find(|editing| editing.path == path)
    }

    /// Those that are in sight, or not as their files are.
    pub(super) fn in_use(&self) -> impl Iterator<Item = &Editing> {
        let is_open = |editing: &Editing| self.open.as_deref() == Some(&*editing.path);
        self.all.iter().filter(move |editing| is_open(editing) || editing.is_modified() || editing.is_saving)
    }

    /// Takes one out, to be [put](Self::put) back.
    pub(super) fn take(&mut self, path: &Path) -> Option<Editing> {
        let at = self.all.iter().position(|editing| editing.path == path)?;
        Some(self.all.remove(at))
    }

    pub(super) fn put(&mut self, editing: Editing) {
        self.forget(&editing.path);
        self.all.push(editing);
    }

    /// A design is no longer where it was.
    pub(super) fn forget(&mut self, path: &Path) {
        self.all.retain(|editing| editing.path != path);
    }

    /// Whether a text is on its way to a file.
    pub(super) fn is_saving(&self) -> bool {
        self.all.iter().any(|editing| editing.is_saving)
    }

    /// After a renaming in their folder: those that name the old design as their parent name the new one, saved or not, and
    /// for the files that have followed already that is the saved state.
    pub(super) fn follow_parent(&mut self, from: &Path, to: &Path, followed: &[Followed]) {
        for editing in self.all.iter_mut().filter(|editing| editing.path.parent() == from.parent()) {
            editing.follow_parent(&file_stem(from), &file_stem(to));
            let text = followed.iter().find(|one| one.path == editing.path).and_then(|one| one.result.as_ref().ok());
            if let Some(text) = text {
                editing.saved(text.clone());
            }
        }
    }

    /// The text of a design with edits that are not saved.
    pub(super) fn unsaved_text(&self, path: &Path) -> Option<String> {
        self.get(path).filter(|editing| editing.is_modified()).map(|editing| editing.editor.text().to_owned())
    }

    /// Those with edits that are not saved.
    pub fn unsaved(&self) -> impl Iterator<Item = &Editing> {
        self.all.iter().filter(|editing| editing.is_modified())
    }
}

/// The file's name without `.toml`, as a variant names it.
fn file_stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
