//! The journals that this process writes.

use std::collections::HashMap;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};

use super::Journal;
use super::folder::{ENDING, discard, make_private};
use crate::design::draft::{Draft, sync_folder};
use crate::design::hash;
use crate::design::save::SaveError;

/// At most one journal a design, each locked as long as this lives.
#[derive(Debug)]
pub struct Journals {
    folder: PathBuf,
    /// Names this process among all that were and will be.
    process: String,
    /// By the design's path as the program names it.
    own: HashMap<PathBuf, (PathBuf, Lock)>,
}

/// Ends with the file.
#[derive(Debug)]
struct Lock(#[allow(dead_code, reason = "held, not read")] File);

impl Journals {
    /// Nothing is written yet.
    pub fn new(folder: PathBuf) -> Self {
        let now = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        Self { folder, process: format!("{}-{:x}", std::process::id(), now.as_nanos()), own: HashMap::new() }
    }

    /// Writes the unsaved edits of a design in place of those that were written before. `base` is what its file held when they
    /// began.
    ///
    /// # Errors
    ///
    /// [`SaveError`]; what was written before is still there then.
    pub fn keep(&mut self, design: &Path, base: &str, text: &str) -> Result<(), SaveError> {
        let made = make_private(&self.folder);
        made.map_err(|source| SaveError::Io { path: self.folder.clone(), doing: "the folder cannot be made", source })?;
        let journal = Journal {
            design: settled(design),
            when: SystemTime::now(),
            program: env!("CARGO_PKG_VERSION").into(),
            base: base.into(),
            text: text.into(),
        };
        let name = hash(journal.design.as_os_str().as_encoded_bytes());
        let new = || self.folder.join(format!("{name}-{}.{ENDING}", self.process));
        let path = self.own.get(design).map_or_else(new, |(path, _)| path.clone());
        // locked before it has its name: at no moment does it look left behind
        let draft = Draft::write_private(&path, &journal.encode())?;
        let renamed = fs::rename(draft.path(), &path);
        renamed.map_err(|source| SaveError::Io { path: path.clone(), doing: "cannot be replaced", source })?;
        sync_folder(&path);
        self.own.insert(design.into(), (path, Lock(draft.file)));
        Ok(())
    }

    /// The design has no unsaved edits any more.
    ///
    /// # Errors
    ///
    /// [`SaveError`] where the journal cannot be removed.
    pub fn forget(&mut self, design: &Path) -> Result<(), SaveError> {
        let Some((path, _lock)) = self.own.remove(design) else { return Ok(()) };
        remove(&path)
    }

    /// Nobody wants the unsaved edits: they are moved to [those](super::DISCARDED) that nobody wanted.
    ///
    /// # Errors
    ///
    /// [`SaveError`]; the journal is where it was then.
    pub fn discard(&mut self, design: &Path) -> Result<(), SaveError> {
        let Some((path, _lock)) = self.own.remove(design) else { return Ok(()) };
        discard(&path)
    }
}

/// Removes a journal whose edits are kept elsewhere, or in the file by now.
///
/// # Errors
///
/// [`SaveError`] where it cannot be removed.
pub fn remove(journal: &Path) -> Result<(), SaveError> {
    match fs::remove_file(journal) {
        Err(source) if source.kind() != io::ErrorKind::NotFound => {
            Err(SaveError::Io { path: journal.into(), doing: "cannot be removed", source })
        }
        _ => Ok(()),
    }
}

/// The path from the root, with no link but in its last part: the same however the design is named, and also when it is gone.
pub(crate) fn settled(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.into());
    let folder = path.parent().and_then(|folder| fs::canonicalize(folder).ok());
    match (folder, path.file_name()) {
        (Some(folder), Some(name)) => folder.join(name),
        _ => path,
    }
}
