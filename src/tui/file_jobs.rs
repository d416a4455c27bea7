//! What is done with single files in the background, in the order in which it was asked for.

use std::path::PathBuf;

use super::backend::{Backend, NotSaved};
use super::export::Export;
use super::message::Message;
use super::solving::{Ticket, guarded};
use crate::design::library::VariantName;

/// A text to be read or written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FileJob {
    Open {
        path: PathBuf,
    },
    /// Written only if the file still is as `expected`.
    Save {
        path: PathBuf,
        expected: Option<Vec<u8>>,
        text: String,
    },
    /// Whether somebody else has changed or opened the file.
    Look {
        path: PathBuf,
        expected: String,
    },
    /// It is not open any more.
    Release {
        path: PathBuf,
    },
    /// What earlier runs have left.
    Left,
    /// A table of averaged mesh numbers.
    MeshTable {
        ticket: Ticket,
        path: PathBuf,
    },
    /// To be written to a new file.
    Export(Box<Export>),
    SaveVariant {
        original: PathBuf,
        name: VariantName,
        text: String,
        note: Option<String>,
    },
}

/// Reads or writes a text, or looks after its file; nothing where there is nothing to be told.
pub fn perform_file(job: FileJob, backend: &dyn Backend) -> Option<Message> {
    let failed = |panic| format!("failed unexpectedly: {panic}");
    Some(match job {
        FileJob::Look { path, expected } => {
            let look = guarded(|| backend.look(&path, &expected)).unwrap_or_default();
            Message::Looked { path, look }
        }
        FileJob::Release { path } => {
            let _ = guarded(|| backend.release(&path));
            return None;
        }
        FileJob::Export(export) => {
            Message::Exported(guarded(|| export.write(backend)).unwrap_or_else(|panic| Err(failed(panic))))
        }
        FileJob::MeshTable { ticket, path } => {
            let result = guarded(|| backend.mesh_table(&path)).unwrap_or_else(|panic| Err(failed(panic)));
            Message::MeshTable { ticket, result }
        }
        FileJob::Left => Message::Left(guarded(|| backend.left()).unwrap_or_default()),
        FileJob::Open { path } => {
            let result = guarded(|| backend.read(&path)).unwrap_or_else(|panic| Err(failed(panic)));
            Message::Opened { path, result }
        }
        FileJob::Save { path, expected, text } => {
            let result = guarded(|| backend.save(&path, expected.as_deref(), &text))
                .unwrap_or_else(|panic| Err(NotSaved::Failed(failed(panic))));
            Message::Saved { path, text, result }
        }
        FileJob::SaveVariant { original, name, text, note } => {
            let result = guarded(|| backend.save_variant(&original, &name, &text, note.as_deref()))
                .unwrap_or_else(|panic| Err(failed(panic)));
            Message::VariantSaved { original, result }
        }
    })
}
