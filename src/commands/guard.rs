//! What keeps the explorer from losing edits on disk: journals and locks.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use crate::design::SaveError;
use crate::design::library::{self, Journals, Left, Locks, OnDisk};
use crate::tui::NotSaved;
use crate::tui::recovery::{FileState, Kept, Look};

#[derive(Debug)]
pub struct Guard {
    /// Nothing where the system knows no folder for them.
    folder: Option<PathBuf>,
    journals: Option<Mutex<Journals>>,
    locks: Mutex<Locks>,
}

impl Guard {
    pub fn new() -> Self {
        let folder = library::recovery_folder();
        let journals = folder.clone().map(|folder| Mutex::new(Journals::new(folder)));
        Self { folder, journals, locks: Mutex::default() }
    }

    pub fn keep(&self, change: &Kept) -> Result<(), String> {
        let Some(journals) = &self.journals else {
            return match change {
                Kept::Edits { .. } => Err("this system names no folder for them".into()),
                _ => Ok(()),
            };
        };
        let mut journals = lock(journals);
        let done = match change {
            Kept::Edits { path, base, text } => journals.keep(path, base, text),
            Kept::Nothing { path } => journals.forget(path),
            Kept::Discarded { path } => journals.discard(path),
            Kept::Taken { journal, .. } => library::remove_journal(journal),
            Kept::Unwanted { journal } => library::discard_journal(journal),
        };
        done.map_err(|error| error.to_string())
    }

    /// For the designs of a library: its files, and what was in the folders given.
    pub fn left(&self, paths: &[PathBuf]) -> Left {
        let Some(folder) = &self.folder else { return Left::default() };
        let folders: Vec<PathBuf> = paths.iter().filter(|path| path.is_dir()).cloned().collect();
        library::left_edits(folder, &library::files(paths), &folders)
    }

    pub fn look(&self, path: &Path, expected: &str) -> Look {
        let state = match OnDisk::read(path) {
            OnDisk::Text(text) if text == expected => FileState::Same,
            OnDisk::Gone => FileState::Gone,
            OnDisk::Text(_) | OnDisk::Unreadable(_) => FileState::Changed,
        };
        let holder = lock(&self.locks).hold(path);
        Look { state, holder: holder.map(|holder| holder.to_string()) }
    }

    pub fn release(&self, path: &Path) {
        lock(&self.locks).release(path);
    }

    pub fn save(&self, path: &Path, expected: Option<&[u8]>, text: &str) -> Result<(), NotSaved> {
        lock(&self.locks).save(path, expected, text).map_err(|error| match error {
            SaveError::Changed(_, now) => NotSaved::Changed(now),
            error => NotSaved::Failed(error.to_string()),
        })
    }
}

/// What is behind the lock is whole also after a panic: it is changed by whole values.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
