//! What stands in a journal.

use std::path::PathBuf;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use crate::design::hash::checksum;

/// The unsaved edits of one design.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Journal {
    /// Absolute
    pub design: PathBuf,
    /// To the second
    pub when: SystemTime,
    /// Version of the program that wrote it
    pub program: String,
    /// What the file held when the edits began
    pub base: String,
    /// The design with the edits
    pub text: String,
}

/// Why a file is not taken for a journal.
#[derive(Debug, thiserror::Error)]
pub enum JournalError {
    #[error("it is not a recovery journal, or its beginning is lost")]
    Foreign,
    #[error("it is in format {0}; this program knows format {FORMAT}")]
    Version(u32),
    #[error("it is damaged: its checksum is another")]
    Damaged,
    #[error("it cannot be read: {0}")]
    Io(#[from] std::io::Error),
}

const FORMAT: u32 = 1;
const FIRST_LINE: &str = "bevelscope recovery journal ";

impl Journal {
    /// ```text
    /// bevelscope recovery journal 1
    /// SHA-256 of all that follows
    /// program 0.1.0
    /// when 1735689600                  seconds since 1970
    /// lengths 24 5000 5003             bytes of path, base and text, which follow without anything in between
    /// ```
    pub fn encode(&self) -> Vec<u8> {
        let path = self.design.as_os_str().as_encoded_bytes();
        let when = self.when.duration_since(UNIX_EPOCH).unwrap_or_default().as_secs();
        let lengths = format!("{} {} {}", path.len(), self.base.len(), self.text.len());
        let mut body = format!("program {}\nwhen {when}\nlengths {lengths}\n", self.program).into_bytes();
        for part in [path, self.base.as_bytes(), self.text.as_bytes()] {
            body.extend_from_slice(part);
        }
        let mut bytes = format!("{FIRST_LINE}{FORMAT}\n{}\n", checksum(&body)).into_bytes();
        bytes.extend(body);
        bytes
    }

    /// Reads what [`encode`](Self::encode) wrote.
    ///
    /// # Errors
    ///
    /// [`JournalError`] for anything else: what comes back is what was written, whole.
    pub fn decode(bytes: &[u8]) -> Result<Self, JournalError> {
        let (first, rest) = line(bytes).ok_or(JournalError::Foreign)?;
        let version = first.strip_prefix(FIRST_LINE).and_then(|version| version.parse().ok());
        match version.ok_or(JournalError::Foreign)? {
            FORMAT => {}
            other => return Err(JournalError::Version(other)),
        }
        let (sum, body) = line(rest).ok_or(JournalError::Damaged)?;
        if sum != checksum(body) {
            return Err(JournalError::Damaged);
        }
        parts(body).ok_or(JournalError::Damaged)
    }
}

fn parts(body: &[u8]) -> Option<Journal> {
    let (program, body) = line(body)?;
    let (when, body) = line(body)?;
    let (lengths, body) = line(body)?;
    let seconds = when.strip_prefix("when ")?.parse().ok()?;
    let lengths = lengths.strip_prefix("lengths ")?.split(' ').map(|length| length.parse().ok());
    let lengths: Vec<usize> = lengths.collect::<Option<_>>()?;
    let [path, base, text] = lengths[..] else { return None };
    let (path, body) = body.split_at_checked(path)?;
    let (base, body) = body.split_at_checked(base)?;
    if body.len() != text {
        return None;
    }
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).ok();
    Some(Journal {
        design: path_of(path)?,
        when: UNIX_EPOCH.checked_add(Duration::from_secs(seconds))?,
        program: program.strip_prefix("program ")?.to_owned(),
        base: text(base)?,
        text: text(body)?,
    })
}

fn line(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let end = bytes.iter().position(|byte| *byte == b'\n')?;
    Some((std::str::from_utf8(&bytes[..end]).ok()?, &bytes[end + 1..]))
}

/// A path need not be text.
#[cfg(unix)]
#[allow(clippy::unnecessary_wraps, reason = "elsewhere it may fail")]
fn path_of(bytes: &[u8]) -> Option<PathBuf> {
    use std::os::unix::ffi::OsStrExt;
    Some(std::ffi::OsStr::from_bytes(bytes).into())
}

#[cfg(not(unix))]
fn path_of(bytes: &[u8]) -> Option<PathBuf> {
    std::str::from_utf8(bytes).ok().map(PathBuf::from)
}
