//! Deleted designs, which can be had back: they lie in a hidden folder of their library.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use crate::design::save::{SaveError, move_to_free};
use crate::moment;

/// The hidden folder, in the library's.
pub const TRASH: &str = ".trash";

/// A deleted file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Trashed {
    /// Where it lies now
    pub path: PathBuf,
    /// The file's name before
    pub file_name: String,
    /// When it was deleted: `2025-01-31 12:00:00`, UTC
    pub when: String,
}

/// Moves a file to the trash of its folder.
///
/// # Errors
///
/// [`SaveError`]; the file is where it was then.
pub fn delete(path: &Path) -> Result<Trashed, SaveError> {
    match fs::symlink_metadata(path) {
        Ok(file) if file.is_dir() => return Err(SaveError::Folder(path.into())),
        Ok(_) => {}
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Err(SaveError::NotThere(path.into())),
        Err(source) => return Err(SaveError::Io { path: path.into(), doing: "cannot be reached", source }),
    }
    let trash = path.parent().unwrap_or(Path::new("")).join(TRASH);
    let made = fs::create_dir_all(&trash);
    made.map_err(|source| SaveError::Io { path: trash.clone(), doing: "the trash cannot be made", source })?;
    let name = path.file_name().unwrap_or_default();
    let stamp = moment::stamp(SystemTime::now());
    // several of the same name may be deleted in one second
    for number in 0..MOST_IN_A_SECOND {
        let mut trashed = std::ffi::OsString::from(format!("{stamp}.{number:03}."));
        trashed.push(name);
        let to = trash.join(trashed);
        match move_to_free(path, &to) {
            Ok(()) => {
                return Ok(Trashed { path: to, file_name: name.to_string_lossy().into_owned(), when: when(&stamp) });
            }
            Err(SaveError::Exists(_)) => {}
            Err(error) => return Err(error),
        }
    }
    Err(SaveError::Exists(trash))
}

const MOST_IN_A_SECOND: u32 = 1000;

/// Moves a deleted file back to where it was.
///
/// # Errors
///
/// [`SaveError::Exists`] where another file has its name by now.
pub fn restore(trashed: &Trashed) -> Result<PathBuf, SaveError> {
    let lost = || SaveError::NotThere(trashed.path.clone());
    let folder = trashed.path.parent().and_then(Path::parent).ok_or_else(lost)?;
    // as it is on disk, which need not be text
    let name = trashed.path.file_name().and_then(|name| before(Path::new(name))).ok_or_else(lost)?;
    let to = folder.join(name);
    move_to_free(&trashed.path, &to)?;
    Ok(to)
}

/// What was deleted from a folder, the latest first.
pub fn trashed(folder: &Path) -> Vec<Trashed> {
    let entries = fs::read_dir(folder.join(TRASH)).into_iter().flatten().flatten();
    let found = entries.filter_map(|entry| {
        let name = entry.file_name();
        let file_name = before(Path::new(&name))?.to_string_lossy().into_owned();
        Some(Trashed { path: entry.path(), file_name, when: when(&name.to_string_lossy()) })
    });
    let mut found: Vec<Trashed> = found.collect();
    found.sort_by(|a, b| b.path.cmp(&a.path));
    found
}

/// Length of `20250131T120000Z.000.`
const STAMP: usize = 21;

/// The name before the deletion.
fn before(trashed: &Path) -> Option<std::ffi::OsString> {
    let bytes = trashed.as_os_str().as_encoded_bytes();
    let (stamp, _) = bytes.split_at_checked(STAMP)?;
    let stamp = std::str::from_utf8(stamp).ok()?;
    let shape: String = stamp.chars().map(|c| if c.is_ascii_digit() { '0' } else { c }).collect();
    if shape != "00000000T000000Z.000." || bytes.len() == STAMP {
        return None;
    }
    strip(trashed.as_os_str())
}

#[cfg(unix)]
fn strip(name: &std::ffi::OsStr) -> Option<std::ffi::OsString> {
    use std::os::unix::ffi::OsStrExt;
    Some(std::ffi::OsStr::from_bytes(name.as_bytes().get(STAMP..)?).into())
}

#[cfg(not(unix))]
fn strip(name: &std::ffi::OsStr) -> Option<std::ffi::OsString> {
    Some(name.to_str()?.get(STAMP..)?.into())
}

/// A time as people read it: `2025-01-31 12:00:00`, UTC.
pub(super) fn shown(time: SystemTime) -> String {
    when(&moment::stamp(time))
}

/// A stamp as people read it.
fn when(stamp: &str) -> String {
    let part = |range: std::ops::Range<usize>| stamp.get(range).unwrap_or_default();
    let (date, time) =
        ([part(0..4), part(4..6), part(6..8)].join("-"), [part(9..11), part(11..13), part(13..15)].join(":"));
    format!("{date} {time}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stamps_are_read_as_dates() {
        assert_eq!(when("20240229T235959Z.000.a.toml"), "2024-02-29 23:59:59");
    }

    #[test]
    fn only_what_was_deleted_here_is_had_back() {
        let name = |trashed: &str| before(Path::new(trashed)).map(|name| name.into_string().unwrap());
        assert_eq!(name("20240229T235959Z.000.a.b.toml"), Some("a.b.toml".into()));
        for foreign in
            ["a.toml", "20240229T235959Z.000.", "20240229T235959Z.00a.toml", "", "2024022ä235959Z.000.a.toml"]
        {
            assert_eq!(name(foreign), None, "{foreign}");
        }
    }
}
