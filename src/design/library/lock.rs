//! Who has a design open for editing: an advisory lock on the file itself.
//!
//! It leaves nothing behind, is found through every link to the file and by every user, and ends with its owner, however that
//! ends. Saving puts another file in the place of the locked one: the new one is locked before it takes its place. Nobody
//! is kept from reading or writing by the lock.

use std::collections::HashMap;
use std::fmt;
use std::fs::File;
use std::path::{Path, PathBuf};

use crate::design::save::{SaveError, save_over};

/// Who has a design open.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Holder {
    /// Nothing where the system does not say
    pub process: Option<u32>,
    pub user: Option<String>,
}

impl fmt::Display for Holder {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.process {
            Some(process) => write!(formatter, "process {process}")?,
            None => write!(formatter, "another process")?,
        }
        self.user.as_ref().map_or(Ok(()), |user| write!(formatter, " of {}", crate::text::printable(user)))
    }
}

/// Who has a design open for editing; nothing where nobody has, or where the file system has no locks.
pub fn holder(path: &Path) -> Option<Holder> {
    match Lock::take(path) {
        Taken::Mine(_) | Taken::NoLocks => None,
        Taken::Others(holder) => Some(holder),
    }
}

/// The designs that this process has open.
#[derive(Debug, Default)]
pub struct Locks {
    held: HashMap<PathBuf, Lock>,
}

impl Locks {
    /// Locks a design, also if another file has taken its place since. Gives who else has it; nothing where the file
    /// system has no locks.
    pub fn hold(&mut self, path: &Path) -> Option<Holder> {
        if self.held.get(path).is_some_and(|lock| lock.is_of(path)) {
            return None;
        }
        // the old one is of a file that is no longer there
        self.held.remove(path);
        match Lock::take(path) {
            Taken::Mine(lock) => {
                self.held.insert(path.into(), lock);
                None
            }
            // by another name
            Taken::Others(holder) if holder.process == Some(std::process::id()) => None,
            Taken::Others(holder) => Some(holder),
            Taken::NoLocks => None,
        }
    }

    pub fn release(&mut self, path: &Path) {
        self.held.remove(path);
    }

    /// Saves a design if its file still holds `expected`, or is still not there where that is nothing. A file that was locked is
    /// locked afterwards, without a moment in between.
    ///
    /// # Errors
    ///
    /// [`SaveError::Changed`] where the file holds anything else; otherwise as [`save`](crate::design::save).
    pub fn save(&mut self, path: &Path, expected: Option<&[u8]>, text: &str) -> Result<(), SaveError> {
        if let Some(file) = save_over(path, expected, text)?
            && cfg!(unix)
        {
            self.held.insert(path.into(), Lock { file });
        }
        Ok(())
    }
}

/// Ends when it is dropped.
#[derive(Debug)]
struct Lock {
    file: File,
}

enum Taken {
    Mine(Lock),
    Others(Holder),
    NoLocks,
}

impl Lock {
    /// Elsewhere a lock would keep others from reading.
    #[cfg(not(unix))]
    fn take(_: &Path) -> Taken {
        Taken::NoLocks
    }

    #[cfg(not(unix))]
    fn is_of(&self, _: &Path) -> bool {
        let _ = &self.file;
        true
    }

    #[cfg(unix)]
    fn take(path: &Path) -> Taken {
        use std::fs::{self, OpenOptions, TryLockError};
        // opening anything else may wait, or do something
        if !fs::metadata(path).is_ok_and(|metadata| metadata.is_file()) {
            return Taken::NoLocks;
        }
        let mut reading = OpenOptions::new();
        let mut writing = reading.clone();
        // over a network a file may have to be open for writing to be locked
        for options in [reading.read(true), writing.read(true).write(true)] {
            let Ok(file) = options.open(path) else { continue };
            match file.try_lock() {
                Ok(()) => return Taken::Mine(Self { file }),
                Err(TryLockError::WouldBlock) => return Taken::Others(holder_of(&file)),
                Err(TryLockError::Error(_)) => {}
            }
        }
        Taken::NoLocks
    }

    /// Whether the path still leads to the file that is locked.
    #[cfg(unix)]
    fn is_of(&self, path: &Path) -> bool {
        use std::os::unix::fs::MetadataExt;
        match (self.file.metadata(), std::fs::metadata(path)) {
            (Ok(mine), Ok(there)) => (mine.dev(), mine.ino()) == (there.dev(), there.ino()),
            _ => false,
        }
    }
}

/// Who has locked a file, as far as the system says.
#[cfg(target_os = "linux")]
fn holder_of(file: &File) -> Holder {
    use std::os::unix::fs::MetadataExt;
    let Ok(metadata) = file.metadata() else { return Holder::default() };
    let locks = std::fs::read_to_string("/proc/locks").unwrap_or_default();
    let process = process_in(&locks, metadata.dev(), metadata.ino());
    Holder { process, user: process.and_then(user_of) }
}

#[cfg(all(unix, not(target_os = "linux")))]
fn holder_of(_: &File) -> Holder {
    Holder::default()
}

/// The process that has an inode locked, from lines such as `1: FLOCK  ADVISORY  WRITE 1234 fe:00:5678 0 EOF` (proc_locks(5)).
/// Layered file systems give another device there than a file has, so the inode alone will do.
#[cfg(target_os = "linux")]
fn process_in(locks: &str, device: u64, inode: u64) -> Option<u32> {
    let (major, minor) = ((device >> 8) & 0xfff, (device & 0xff) | ((device >> 12) & 0xf_ff00));
    let found = locks.lines().filter_map(|line| {
        let words: Vec<&str> = line.split_whitespace().collect();
        let [_, "FLOCK", "ADVISORY", "WRITE", process, file, ..] = words[..] else { return None };
        let mut parts = file.rsplitn(2, ':');
        (parts.next()?.parse() == Ok(inode)).then_some(())?;
        let is_here = parts.next()? == format!("{major:02x}:{minor:02x}");
        Some((is_here, process.parse().ok().filter(|process| *process > 0)?))
    });
    let found: Vec<(bool, u32)> = found.collect();
    let best = found.iter().find(|(is_here, _)| *is_here).or(found.first());
    best.map(|(_, process)| *process)
}

#[cfg(target_os = "linux")]
fn user_of(process: u32) -> Option<String> {
    use std::os::unix::fs::MetadataExt;
    let user = std::fs::metadata(format!("/proc/{process}")).ok()?.uid().to_string();
    let users = std::fs::read_to_string("/etc/passwd").unwrap_or_default();
    let named = users.lines().map(|line| line.split(':').collect::<Vec<_>>());
    let name =
        named.into_iter().find(|fields| fields.get(2) == Some(&user.as_str())).map(|fields| fields[0].to_owned());
    Some(name.unwrap_or_else(|| format!("user {user}")))
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    use super::*;

    // Lines as in proc_locks(5); device 0xfe00 is 254:0, which stat(1) gives as 65024.
    #[test]
    fn the_holder_is_found_among_the_locks() {
        let locks = "1: POSIX  ADVISORY  WRITE 11 fe:00:42 0 EOF\n2: FLOCK  ADVISORY  WRITE 12 00:2f:42 0 EOF\n\
                     3: FLOCK  ADVISORY  WRITE 13 fe:00:42 0 EOF\n3: -> FLOCK  ADVISORY  WRITE 14 fe:00:42 0 EOF\n\
                     4: FLOCK  ADVISORY  WRITE -1 fe:00:43 0 EOF\nnonsense\n";
        assert_eq!(process_in(locks, 65024, 42), Some(13));
        assert_eq!(process_in(locks, 1, 42), Some(12));
        assert_eq!(process_in(locks, 65024, 43), None);
        assert_eq!(process_in(locks, 65024, 44), None);
    }
}
