//! Writing a design file so that there is always a whole one: the old or the new.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use super::draft::{Draft, clear_stale, sync_folder};
use super::load::MAX_BYTES;
use crate::text::printable;

/// Why a file was not written. Whatever was there is untouched.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    #[error("{}: this is a folder", shown(.0))]
    Folder(PathBuf),
    #[error("{}: this is no regular file", shown(.0))]
    NoFile(PathBuf),
    #[error("{}: there is no such file", shown(.0))]
    NotThere(PathBuf),
    #[error("{}: the file is write-protected", shown(.0))]
    ReadOnly(PathBuf),
    #[error("{}: there is a {} of that name already", shown(.0), if .0.is_dir() { "folder" } else { "file" })]
    Exists(PathBuf),
    #[error("{}: the folder is not there", shown(.0))]
    NoFolder(PathBuf),
    /// With the bytes that the file has now; nothing where it is gone
    #[error("{}: the file has changed on disk", shown(.0))]
    Changed(PathBuf, Option<Vec<u8>>),
    /// `doing` is what could not be done, e.g. `cannot be written`
    #[error("{}: {doing}: {source}", shown(.path))]
    Io { path: PathBuf, doing: &'static str, source: io::Error },
}

fn shown(path: &Path) -> String {
    printable(&path.display().to_string()).into_owned()
}

/// Replaces the file's content, or makes the file. The text is written beside it and put in its place by one renaming, so a
/// reader sees the old file or the new one. Permissions, and the owner where that is allowed, stay; of a link, the file
/// that it leads to is replaced.
///
/// # Errors
///
/// [`SaveError`]; the old file is untouched then, and nothing is left beside it.
pub fn save(path: &Path, text: &str) -> Result<(), SaveError> {
    let (target, draft) = draft_for(path, text)?;
    replace(draft, &target, path).map(drop)
}

/// As [`save`], if the file still holds `expected`, or still is not there where that is nothing: this is looked at last,
/// when the new text is on the disk already. Gives the file that is in place now, [locked](File::try_lock) where the file system has
/// locks. Where somebody else wrote the same text, nothing is left to do and no file is given.
///
/// # Errors
///
/// [`SaveError::Changed`] where the file holds anything else; otherwise as [`save`].
pub(super) fn save_over(path: &Path, expected: Option<&[u8]>, text: &str) -> Result<Option<File>, SaveError> {
    let (target, draft) = draft_for(path, text)?;
    let now = content(&target, path)?;
    if now.as_deref() == Some(text.as_bytes()) {
        return Ok(None);
    }
    if now.as_deref() != expected {
        return Err(SaveError::Changed(path.into(), now));
    }
    if expected.is_some() {
        return replace(draft, &target, path).map(Some);
    }
    match move_to_free(draft.path(), &target) {
        Ok(()) => Ok(Some(draft.file)),
        Err(SaveError::Exists(_)) => Err(SaveError::Changed(path.into(), content(&target, path)?)),
        Err(error) => Err(error),
    }
}

/// The text beside the file that it is meant for, and where that file is.
fn draft_for(path: &Path, text: &str) -> Result<(PathBuf, Draft), SaveError> {
    let target = followed(path)?;
    let old = match fs::metadata(&target) {
        Ok(old) if old.is_dir() => return Err(SaveError::Folder(path.into())),
        Ok(old) if !old.is_file() => return Err(SaveError::NoFile(path.into())),
        Ok(old) if old.permissions().readonly() => return Err(SaveError::ReadOnly(path.into())),
        Ok(old) => Some(old),
        Err(error) if error.kind() == io::ErrorKind::NotFound => None,
        Err(source) => return Err(SaveError::Io { path: path.into(), doing: "cannot be reached", source }),
    };
    clear_stale(folder_of(&target));
    let draft = Draft::write(&target, path, text.as_bytes(), old.as_ref())?;
    Ok((target, draft))
}

fn replace(draft: Draft, target: &Path, named: &Path) -> Result<File, SaveError> {
    let renamed = fs::rename(draft.path(), target);
    renamed.map_err(|source| SaveError::Io { path: named.into(), doing: "cannot be replaced", source })?;
    sync_folder(target);
    Ok(draft.file)
}

/// What a file holds now; nothing where it is not there.
fn content(target: &Path, named: &Path) -> Result<Option<Vec<u8>>, SaveError> {
    let failed =
        |source| SaveError::Io { path: named.into(), doing: "cannot be compared with what is there now", source };
    let mut bytes = Vec::new();
    match File::open(target).and_then(|file| file.take(MAX_BYTES + 1).read_to_end(&mut bytes)) {
        Ok(length) if length as u64 > MAX_BYTES => Err(failed(io::Error::other("it is larger than 4 MiB"))),
        Ok(_) => Ok(Some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(failed(error)),
    }
}

/// Makes a file that must not be there yet; otherwise as [`save`].
///
/// # Errors
///
/// As [`save`]; [`SaveError::Exists`] where anything has that name.
pub fn save_new(path: &Path, content: impl AsRef<[u8]>) -> Result<(), SaveError> {
    if fs::symlink_metadata(path).is_ok() {
        return Err(SaveError::Exists(path.into()));
    }
    let draft = Draft::write(path, path, content.as_ref(), None)?;
    move_to_free(draft.path(), path)
}

/// Renames a file to a name that nothing has: where something has it meanwhile, it is left alone.
pub(super) fn move_to_free(from: &Path, to: &Path) -> Result<(), SaveError> {
    let failed = |source: io::Error| match source.kind() {
        io::ErrorKind::AlreadyExists => SaveError::Exists(to.into()),
        io::ErrorKind::NotFound => SaveError::NotThere(from.into()),
        _ => SaveError::Io { path: to.into(), doing: "cannot be made", source },
    };
    match fs::hard_link(from, to) {
        Ok(()) => fs::remove_file(from).map_err(|source| {
            // as it was
            let _ = fs::remove_file(to);
            SaveError::Io { path: from.into(), doing: "cannot be moved", source }
        })?,
        Err(error) if matches!(error.kind(), io::ErrorKind::AlreadyExists | io::ErrorKind::NotFound) => {
            return Err(failed(error));
        }
        // a file system without links: the name is taken first, then replaced
        Err(_) => {
            OpenOptions::new().write(true).create_new(true).open(to).map_err(failed)?;
            fs::rename(from, to).map_err(|error| {
                let _ = fs::remove_file(to);
                failed(error)
            })?;
        }
    }
    sync_folder(to);
    sync_folder(from);
    Ok(())
}

/// Where the links lead, also where nothing is there yet.
fn followed(path: &Path) -> Result<PathBuf, SaveError> {
    const MOST: usize = 40;
    let mut target = path.to_path_buf();
    for _ in 0..MOST {
        match fs::read_link(&target) {
            Ok(link) => target = target.parent().unwrap_or(Path::new("")).join(link),
            Err(_) => return Ok(target),
        }
    }
    let source = io::Error::other("too many links");
    Err(SaveError::Io { path: path.into(), doing: "cannot be reached", source })
}

pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}
