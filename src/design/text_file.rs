//! Texts from files that may be no files, not end, or be no texts.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// Why there is no text.
#[derive(Debug, thiserror::Error)]
pub enum TextError {
    #[error("this is a folder")]
    Folder,
    #[error("there is no such file")]
    NotFound,
    #[error("the file is larger than {} MiB", .max_bytes >> 20)]
    TooLarge { max_bytes: u64 },
    /// `line` counts from 1, `byte` from 0 at the start of the file
    #[error("line {line}: not UTF-8 text")]
    NotUtf8 { line: usize, byte: usize, value: u8 },
    #[error("{0}")]
    Io(io::Error),
}

impl From<io::Error> for TextError {
    fn from(error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::NotFound => Self::NotFound,
            io::ErrorKind::IsADirectory => Self::Folder,
            _ => Self::Io(error),
        }
    }
}

/// The text of a file with at most `max_bytes` bytes.
///
/// # Errors
///
/// [`TextError`] says why there is none.
pub fn read_text(path: &Path, max_bytes: u64) -> Result<String, TextError> {
    // asked before opening: opening a folder is an error on some systems and none on others
    let metadata = std::fs::metadata(path)?;
    if metadata.is_dir() {
        return Err(TextError::Folder);
    }
    if metadata.is_file() && metadata.len() > max_bytes {
        return Err(TextError::TooLarge { max_bytes });
    }
    read_text_from(File::open(path)?, max_bytes)
}

/// The text of a reader, of which at most one byte over the limit is read.
///
/// # Errors
///
/// [`TextError`] says why there is none.
pub fn read_text_from(reader: impl Read, max_bytes: u64) -> Result<String, TextError> {
    let mut bytes = Vec::new();
    if reader.take(max_bytes + 1).read_to_end(&mut bytes)? as u64 > max_bytes {
        return Err(TextError::TooLarge { max_bytes });
    }
    String::from_utf8(bytes).map_err(|error| {
        let byte = error.utf8_error().valid_up_to();
        let bytes = error.as_bytes();
        let line = bytes[..byte].split(|byte| *byte == b'\n').count();
        TextError::NotUtf8 { line, byte, value: bytes.get(byte).copied().unwrap_or_default() }
    })
}
