//! Files beside those that they will take the place of.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, SystemTime};

use super::save::{SaveError, folder_of};

/// A file beside the one that is meant, locked while its writer lives; removed unless it took its place.
pub(super) struct Draft {
    pub file: File,
    name: Name,
}

/// Removed when it is dropped.
struct Name(PathBuf);

impl Drop for Name {
    fn drop(&mut self) {
        // gone already where all went well
        let _ = fs::remove_file(&self.0);
    }
}

impl Draft {
    /// Writes the text beside `target`. `named` is what the file is called in errors.
    pub fn write(target: &Path, named: &Path, content: &[u8], old: Option<&Metadata>) -> Result<Self, SaveError> {
        let failed = |doing| move |source| SaveError::Io { path: named.into(), doing, source };
        let mut draft = Self::make(target, named, old.is_some())?;
        draft.file.write_all(content).map_err(failed("cannot be written"))?;
        if let Some(old) = old {
            keep_owner(&draft.file, old);
            draft.file.set_permissions(old.permissions()).map_err(failed("its permissions cannot be kept"))?;
        }
        draft.file.sync_all().map_err(failed("cannot be written"))?;
        Ok(draft)
    }

    /// Writes what is nobody else's to read.
    pub fn write_private(target: &Path, content: &[u8]) -> Result<Self, SaveError> {
        let failed = |source| SaveError::Io { path: target.into(), doing: "cannot be written", source };
        let mut draft = Self::make(target, target, true)?;
        draft.file.write_all(content).map_err(failed)?;
        draft.file.sync_all().map_err(failed)?;
        Ok(draft)
    }

    pub fn path(&self) -> &Path {
        &self.name.0
    }

    /// Makes a file with a name that nothing has.
    fn make(target: &Path, named: &Path, private: bool) -> Result<Self, SaveError> {
        /// How many may be left over from processes of the same number that were ended half-way
        const MOST_LEFT: u64 = 1000;
        static COUNT: AtomicU64 = AtomicU64::new(0);
        let folder = folder_of(target);
        if !folder.is_dir() {
            return Err(SaveError::NoFolder(named.into()));
        }
        let mut left = 0;
        loop {
            let count = COUNT.fetch_add(1, Ordering::Relaxed);
            let path = folder.join(format!("{START}{}.{count}{END}", std::process::id()));
            match options(private).open(&path) {
                Ok(file) => {
                    // on a file system without locks its age tells that it is stale
                    let _ = file.try_lock();
                    return Ok(Self { file, name: Name(path) });
                }
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists && left < MOST_LEFT => left += 1,
                Err(source) => {
                    let doing = "a file cannot be made in its folder";
                    return Err(SaveError::Io { path: named.into(), doing, source });
                }
            }
        }
    }
}

const START: &str = ".bevelscope.";
const END: &str = ".new";

/// Removes what writers that were ended half-way have left in a folder. What is locked has a writer that lives.
pub(super) fn clear_stale(folder: &Path) {
    /// Nobody takes longer between making a file and locking it.
    const YOUNG: Duration = Duration::from_secs(10);
    /// Nobody takes longer to write one, where it cannot be locked.
    const OLD: Duration = Duration::from_secs(24 * 3600);
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if !name.starts_with(START) || !name.ends_with(END) {
            continue;
        }
        let Some(metadata) = fs::symlink_metadata(entry.path()).ok().filter(Metadata::is_file) else { continue };
        let age = metadata.modified().ok().and_then(|then| SystemTime::now().duration_since(then).ok());
        let age = age.unwrap_or_default();
        let is_stale = age > YOUNG
            && match File::open(entry.path()).map(|file| file.try_lock()) {
                Ok(Ok(())) => true,
                Ok(Err(fs::TryLockError::WouldBlock)) => false,
                Ok(Err(fs::TryLockError::Error(_))) | Err(_) => age > OLD,
            };
        if is_stale {
            // another process may have been faster
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// What is to replace a file is nobody else's to read before it has that file's permissions.
fn options(private: bool) -> OpenOptions {
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    if private {
        std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    }
    #[cfg(not(unix))]
    let _ = private;
    options
}

/// Only the superuser may give files away; anyone else keeps the group at most.
fn keep_owner(file: &File, old: &Metadata) {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        if fchown(file, Some(old.uid()), Some(old.gid())).is_err() {
            let _ = fchown(file, None, Some(old.gid()));
        }
    }
    #[cfg(not(unix))]
    let _ = (file, old);
}

/// So that the name survives a power cut. Not every system can; the file itself is safe by now.
pub(super) fn sync_folder(path: &Path) {
    if let Ok(folder) = File::open(folder_of(path)) {
        let _ = folder.sync_all();
    }
}
