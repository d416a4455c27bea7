//! The formats of files, by the ends of their names.

use std::path::Path;

/// What a file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// The data
    Csv,
    /// The picture
    Svg,
    /// A page of all of it
    Html,
}

/// A name that says no format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("the name must end in .csv (the data), .svg (the picture) or .html (a page of all)")]
pub struct WrongExtension;

impl Format {
    /// # Errors
    ///
    /// [`WrongExtension`]; small and capital letters are the same.
    ///
    /// ```
    /// use bevelscope::document::{Format, WrongExtension};
    /// assert_eq!(Format::of("modes.SVG".as_ref()), Ok(Format::Svg));
    /// assert_eq!(Format::of("csv".as_ref()), Err(WrongExtension));
    /// ```
    pub fn of(path: &Path) -> Result<Self, WrongExtension> {
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_lowercase());
        match extension.as_deref() {
            Some("csv") => Ok(Self::Csv),
            Some("svg") => Ok(Self::Svg),
            Some("html") => Ok(Self::Html),
            _ => Err(WrongExtension),
        }
    }
}
