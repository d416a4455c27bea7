//! Design files from disk or standard input.

use std::borrow::Cow;
use std::ffi::OsStr;
use std::io::{self, Read};
use std::path::Path;

use super::document::Tree;
use super::finding::{Finding, is_error};
use super::label;
use super::model::Design;
use super::read::read;
use super::render::Source;
use super::text_file::{TextError, read_text, read_text_from};
use crate::text::printable;

/// Largest design file that is read, in bytes.
pub const MAX_BYTES: u64 = 4 * 1024 * 1024;

/// A design with the text that it was read from.
#[derive(Debug, Clone, PartialEq)]
pub struct Loaded {
    pub design: Design,
    pub text: String,
    pub warnings: Vec<Finding>,
    /// What the file is called in messages
    pub name: String,
}

impl Loaded {
    /// The warnings, each a sentence with what it is about in words behind it.
    pub fn sentences(&self) -> Vec<String> {
        let tree = Tree::read(&self.text);
        let sentence = |finding: &Finding| match finding.shown_path().as_str() {
            "" => finding.message.clone(),
            _ => format!("{} ({})", finding.message, label::of_value(&tree, &finding.key_path)),
        };
        self.warnings.iter().map(sentence).collect()
    }

    /// The last part of [`name`](Self::name): what is passed on need not say where a file lies.
    pub fn file_name(&self) -> Cow<'_, str> {
        Path::new(&self.name).file_name().map_or(Cow::Borrowed(&*self.name), OsStr::to_string_lossy)
    }

    /// The warnings as people read them; empty if there are none.
    pub fn render_warnings(&self) -> String {
        Source::new(&self.name, &self.text).render_all(&self.warnings)
    }
}

/// Why there is no design. Messages begin with the file's name and steer no terminal, whatever file and name hold.
#[derive(Debug, thiserror::Error)]
pub enum LoadError {
    #[error("{}: this is a folder, not a design file", printable(.name))]
    Folder { name: String },
    #[error("{}: there is no such file", printable(.name))]
    NotFound { name: String },
    #[error("{}: {source}", printable(.name))]
    Io { name: String, source: io::Error },
    #[error("{}: the file is empty", printable(.name))]
    Empty { name: String },
    #[error("{}: the file is larger than 4 MiB, the most that a design file may have", printable(.name))]
    TooLarge { name: String },
    /// `line` counts from 1, `byte` from 0 at the start of the file
    #[error("{}:{line}: not UTF-8 text: byte {byte} of the file is 0x{value:02x}", printable(.name))]
    NotUtf8 { name: String, line: usize, byte: usize, value: u8 },
    /// At least one finding is an error.
    #[error("{}", Source::new(.name, .text).render_all(.findings).trim_end())]
    Invalid { name: String, text: String, findings: Vec<Finding> },
}

impl LoadError {
    fn of(error: TextError, name: String) -> Self {
        match error {
            TextError::Folder => Self::Folder { name },
            TextError::NotFound => Self::NotFound { name },
            TextError::TooLarge { .. } => Self::TooLarge { name },
            TextError::NotUtf8 { line, byte, value } => Self::NotUtf8 { name, line, byte, value },
            TextError::Io(source) => Self::Io { name, source },
        }
    }

    /// The reason in one line, without the file's name: `line 12: pinion.segment[0].lenght_mm: unknown key (and 2 more errors)`.
    pub fn reason(&self) -> String {
        match self {
            Self::Folder { .. } => "this is a folder, not a design file".into(),
            Self::NotFound { .. } => "there is no such file".into(),
            Self::Io { source, .. } => source.to_string(),
            Self::Empty { .. } => "the file is empty".into(),
            Self::TooLarge { .. } => "the file is larger than 4 MiB".into(),
            Self::NotUtf8 { line, .. } => format!("line {line}: not UTF-8 text"),
            Self::Invalid { text, findings, .. } => reason_of(text, findings),
        }
    }
}

fn reason_of(text: &str, findings: &[Finding]) -> String {
    let mut errors = findings.iter().filter(|finding| is_error(finding));
    let Some(first) = errors.next() else { return String::new() };
    let mut reason = String::new();
    if let Some(span) = &first.span {
        reason = format!("line {}: ", Source::new("", text).position(span.start).line);
    }
    let path = first.shown_path();
    if !path.is_empty() {
        reason.push_str(&printable(&path));
        reason.push_str(": ");
    }
    reason.push_str(&printable(&first.message));
    match errors.count() {
        0 => reason,
        1 => reason + " (and 1 more error)",
        more => format!("{reason} (and {more} more errors)"),
    }
}

/// Reads and checks a design file; `-` is standard input.
///
/// # Errors
///
/// [`LoadError`] says why there is no design.
pub fn load(path: &Path) -> Result<Loaded, LoadError> {
    if path.as_os_str() == "-" {
        return load_from(io::stdin().lock(), "standard input");
    }
    let name = path.display().to_string();
    match read_text(path, MAX_BYTES) {
        Ok(text) => loaded(text, name),
        Err(error) => Err(LoadError::of(error, name)),
    }
}

/// Reads and checks a design from a reader, which is called `name` in messages. Reads at most one byte over the limit.
///
/// # Errors
///
/// [`LoadError`] says why there is no design.
pub fn load_from(reader: impl Read, name: &str) -> Result<Loaded, LoadError> {
    let name = name.to_owned();
    match read_text_from(reader, MAX_BYTES) {
        Ok(text) => loaded(text, name),
        Err(error) => Err(LoadError::of(error, name)),
    }
}

fn loaded(text: String, name: String) -> Result<Loaded, LoadError> {
    if text.is_empty() {
        return Err(LoadError::Empty { name });
    }
    let reading = read(&text);
    match reading.design {
        Some(design) => Ok(Loaded { design, text, warnings: reading.findings, name }),
        None => Err(LoadError::Invalid { name, text, findings: reading.findings }),
    }
}
