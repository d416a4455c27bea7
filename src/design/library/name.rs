//! File names that are safe on every system.

use std::fmt;
use std::path::{Path, PathBuf};

/// A checked name of a design file, without `.toml`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct VariantName(String);

/// Why a name is not taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum NameError {
    #[error("a name is wanted")]
    Empty,
    #[error("the name is too long: 100 bytes at most")]
    TooLong,
    #[error("a name must not have {0:?} in it")]
    Character(char),
    #[error("a name must not begin with {0:?}")]
    Start(char),
    #[error("a name must not end with {0:?}")]
    End(char),
    #[error("this name is reserved by some systems")]
    Reserved,
}

impl VariantName {
    /// Checks a name; a `.toml` at its end is not part of it.
    ///
    /// # Errors
    ///
    /// [`NameError`] says what is wrong with it.
    pub fn new(name: &str) -> Result<Self, NameError> {
        let name = name.strip_suffix(".toml").unwrap_or(name);
        if name.is_empty() { Err(NameError::Empty) } else { Ok(Self(name.into())) }
    }

    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// `FOLDER/NAME.toml`
    pub fn path_in(&self, folder: &Path) -> PathBuf {
        folder.join(format!("{}.toml", self.0))
    }
}

impl fmt::Display for VariantName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}
