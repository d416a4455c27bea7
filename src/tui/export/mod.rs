//! Writing what a screen shows to a file: its name is typed here, the file is made in the background.
//!
//! ```text
//! key ─> Shown, name ─> Export ─> Document ─> Backend ─> file
//! ```

mod bearings;
mod compare;
mod form;
mod modes;
mod overview;
mod pair;
mod spectra;

use std::path::PathBuf;

pub use form::ExportForm;
pub use spectra::ShownSpectra;

use super::backend::Backend;
use super::editor::Editing;
use crate::design;
use crate::document::{Document, Source};
use crate::text::printable;

/// A file to be written.
#[derive(Debug, Clone)]
pub struct Export {
    pub path: PathBuf,
    pub shown: Shown,
}

/// What is in sight.
#[derive(Debug, Clone)]
pub enum Shown {
    /// Made into a document in the background: there may be a million lines
    Spectra(Box<ShownSpectra>),
    Document(Box<Document>),
    /// A design of the list or of the tables, with its text where that is not saved
    Design {
        path: PathBuf,
        text: Option<String>,
    },
}

/// A request is where it writes to.
impl PartialEq for Export {
    fn eq(&self, other: &Self) -> bool {
        self.path == other.path
    }
}

impl Eq for Export {}

impl Export {
    /// Writes the file, and says where it is.
    ///
    /// # Errors
    ///
    /// Why not, in one line.
    pub fn write(&self, backend: &dyn Backend) -> Result<PathBuf, String> {
        match &self.shown {
            Shown::Spectra(shown) => backend.export(&self.path, &shown.document()),
            Shown::Document(document) => backend.export(&self.path, document),
            Shown::Design { path, text } => backend.export_design(&self.path, path, text.as_deref()),
        }
    }
}

/// The design of the tables as it is now.
fn source(editing: &Editing) -> Source {
    let stem = editing.path.file_stem().unwrap_or_default().to_string_lossy();
    let unsaved = if editing.is_modified() { " (unsaved edits)" } else { "" };
    let hash = design::hash(editing.editor.text().as_bytes());
    Source { role: "design".into(), name: format!("{}{unsaved}", printable(&stem)), hash: Some(hash) }
}
