//! Writing a design file so that there is always a whole one: the old or the new.

use std::fs::{self, File, Metadata, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

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
    #[error("{}: there is a file of that name already", shown(.0))]
    Exists(PathBuf),
    #[error("{}: the folder is not there", shown(.0))]
    NoFolder(PathBuf),
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
    let target = followed(path)?;
    let old = match fs::metadata(&target) {
        Ok(old) if old.is_dir() => return Err(SaveError::Folder(path.into())),
        Ok(old) if !old.is_file() => return Err(SaveError::NoFile(path.into())),
        Ok(old) if old.permissions().readonly() => return Err(SaveError::ReadOnly(path.into())),
        Ok(old) => Some(old),
        Err(error) if error.kind() == io::ErrorKind::NotFound => None,
        Err(source) => return Err(SaveError::Io { path: path.into(), doing: "cannot be reached", source }),
    };
    let draft = Draft::write(&target, path, text.as_bytes(), old.as_ref())?;
    let renamed = fs::rename(&draft.path, &target);
    renamed.map_err(|source| SaveError::Io { path: path.into(), doing: "cannot be replaced", source })?;
    sync_folder(&target);
    Ok(())
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
    move_to_free(&draft.path, path)
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

/// A file beside the one that is meant; removed unless it took its place.
struct Draft {
    path: PathBuf,
}

impl Drop for Draft {
    fn drop(&mut self) {
        // gone already where all went well
        let _ = fs::remove_file(&self.path);
    }
}

impl Draft {
    /// Writes the text beside `target`. `named` is what the file is called in errors.
    fn write(target: &Path, named: &Path, content: &[u8], old: Option<&Metadata>) -> Result<Self, SaveError> {
        let folder = folder_of(target);
        if !folder.is_dir() {
            return Err(SaveError::NoFolder(named.into()));
        }
        let failed = |doing| move |source| SaveError::Io { path: named.into(), doing, source };
        let (path, mut file) = make(folder, old.is_some()).map_err(failed("a file cannot be made in its folder"))?;
        let draft = Self { path };
        file.write_all(content).map_err(failed("cannot be written"))?;
        if let Some(old) = old {
            keep_owner(&file, old);
            file.set_permissions(old.permissions()).map_err(failed("its permissions cannot be kept"))?;
        }
        file.sync_all().map_err(failed("cannot be written"))?;
        Ok(draft)
    }
}

/// Makes a file with a name that nothing has.
fn make(folder: &Path, private: bool) -> io::Result<(PathBuf, File)> {
    /// How many may be left over from processes of the same number that were ended half-way
    const MOST_LEFT: u64 = 1000;
    static COUNT: AtomicU64 = AtomicU64::new(0);
    for left in 1.. {
        let count = COUNT.fetch_add(1, Ordering::Relaxed);
        let path = folder.join(format!(".bevelscope.{}.{count}.new", std::process::id()));
        match options(private).open(&path) {
            Ok(file) => return Ok((path, file)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists && left < MOST_LEFT => {}
            Err(error) => return Err(error),
        }
    }
    Err(io::ErrorKind::AlreadyExists.into())
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

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// So that the name survives a power cut. Not every system can; the file itself is safe by now.
fn sync_folder(path: &Path) {
    if let Ok(folder) = File::open(folder_of(path)) {
        let _ = folder.sync_all();
    }
}
