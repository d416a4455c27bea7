//! The folder of journals, as every process sees it.

use std::fs::{self, File, TryLockError};
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use super::{Journal, JournalError};
use crate::design::load::MAX_BYTES;
use crate::design::save::{SaveError, move_to_free};

/// The folder, in that of the journals, where those lie that nobody wanted.
pub const DISCARDED: &str = "discarded";
/// As many of them are kept, the newest.
const KEPT: usize = 20;
pub(super) const ENDING: &str = "journal";

/// A file of the folder.
#[derive(Debug)]
pub struct Found {
    pub path: PathBuf,
    /// The process that writes it lives.
    pub is_alive: bool,
    pub journal: Result<Journal, JournalError>,
}

/// Where journals are kept: `bevelscope/recovery` in the user's folder for state (`$XDG_STATE_HOME`), or for local data where the
/// system knows no such folder. `None` where it knows neither.
pub fn recovery_folder() -> Option<PathBuf> {
    Some(dirs::state_dir().or_else(dirs::data_local_dir)?.join("bevelscope").join("recovery"))
}

/// All journals of a folder, the latest first, damaged ones last. A folder that is not there has none. Nothing is changed.
pub fn journals(folder: &Path) -> Vec<Found> {
    let paths = fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut found: Vec<Found> = paths.filter(|path| is_journal(path)).map(look_at).collect();
    let when = |found: &Found| found.journal.as_ref().ok().map(|journal| journal.when);
    found.sort_by(|a, b| when(b).cmp(&when(a)).then_with(|| a.path.cmp(&b.path)));
    found
}

fn is_journal(path: &Path) -> bool {
    let is_file = || fs::symlink_metadata(path).is_ok_and(|metadata| metadata.is_file());
    path.extension().is_some_and(|ending| ending == ENDING) && is_file()
}

fn look_at(path: PathBuf) -> Found {
    match File::open(&path) {
        Ok(file) => {
            // without locks nobody can tell, and an offer too many does no harm
            let is_alive = matches!(file.try_lock(), Err(TryLockError::WouldBlock));
            Found { journal: read(&file), path, is_alive }
        }
        Err(error) => Found { path, is_alive: false, journal: Err(error.into()) },
    }
}

fn read(file: &File) -> Result<Journal, JournalError> {
    /// Two texts of the largest size, a path, and what stands before them.
    const MOST: u64 = 2 * MAX_BYTES + 64 * 1024;
    let mut bytes = Vec::new();
    file.take(MOST).read_to_end(&mut bytes)?;
    Journal::decode(&bytes)
}

/// Moves a journal to those that nobody wanted, of which the newest are kept.
///
/// # Errors
///
/// The system's; the journal is where it was then.
pub fn discard(journal: &Path) -> Result<(), SaveError> {
    let name = journal.file_name().unwrap_or_default();
    let folder = journal.parent().unwrap_or(Path::new("")).join(DISCARDED);
    let made = make_private(&folder);
    made.map_err(|source| SaveError::Io { path: folder.clone(), doing: "the folder cannot be made", source })?;
    move_to_free(journal, &free(&folder.join(name)))?;
    let modified = |path: &PathBuf| fs::metadata(path).and_then(|metadata| metadata.modified()).ok();
    let mut kept: Vec<PathBuf> =
        fs::read_dir(&folder).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
    kept.sort_by_key(|path| std::cmp::Reverse(modified(path)));
    for old in kept.iter().skip(KEPT) {
        // the next one will try again
        let _ = fs::remove_file(old);
    }
    Ok(())
}

/// Renames a file that cannot be used as a journal, so that it is not looked at again. Gives its new name.
///
/// # Errors
///
/// The system's; the file is where it was then.
pub fn set_aside(journal: &Path) -> Result<PathBuf, SaveError> {
    let mut name = journal.file_name().unwrap_or_default().to_owned();
    name.push(".damaged");
    let aside = free(&journal.with_file_name(name));
    move_to_free(journal, &aside)?;
    Ok(aside)
}

/// The path, or one with a number that nothing has.
fn free(path: &Path) -> PathBuf {
    let numbered = |number: u32| {
        let mut name = path.file_name().unwrap_or_default().to_owned();
        name.push(format!(".{number}"));
        path.with_file_name(name)
    };
    let candidates = std::iter::once(path.to_path_buf()).chain((1..1000).map(numbered));
    candidates.into_iter().find(|path| fs::symlink_metadata(path).is_err()).unwrap_or_else(|| path.into())
}

/// A folder that is nobody else's to look into.
pub(super) fn make_private(folder: &Path) -> io::Result<()> {
    let mut builder = fs::DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(folder)?;
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        let permissions = fs::metadata(folder)?.permissions();
        if permissions.mode() & 0o077 != 0 {
            fs::set_permissions(folder, fs::Permissions::from_mode(0o700))?;
        }
    }
    Ok(())
}
