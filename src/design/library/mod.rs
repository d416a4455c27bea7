//! Folders of designs, the designs that come with the program, who has one open, and unsaved edits of earlier runs.

mod journal;
mod left;
mod lock;
mod name;
mod order;
mod trash;
mod tree;
mod variant;

pub use journal::{
    DISCARDED, Found, Journal, JournalError, Journals, discard as discard_journal, journals, recovery_folder,
    remove as remove_journal, set_aside as set_journal_aside,
};
pub use left::{Left, LeftEdits, OnDisk, left_edits};
pub use lock::{Holder, Locks, holder};
pub use name::{NameError, VariantName};
pub use order::by_name;
pub use trash::{TRASH, Trashed, delete, restore, trashed};
pub use tree::{Branch, tree};
pub use variant::{About, VariantError, duplicate, follow_parent, rename, save_variant};

use std::collections::HashSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::text::printable;

/// A design that comes with the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shipped {
    pub file_name: &'static str,
    pub text: &'static str,
}

/// The designs of the folder `designs`, by file name.
pub const SHIPPED: &[Shipped] = &[
    Shipped { file_name: "overhung-elastic.toml", text: include_str!("../../../designs/overhung-elastic.toml") },
    Shipped { file_name: "overhung-rigid.toml", text: include_str!("../../../designs/overhung-rigid.toml") },
    Shipped { file_name: "straddle-elastic.toml", text: include_str!("../../../designs/straddle-elastic.toml") },
    Shipped { file_name: "straddle-helical.toml", text: include_str!("../../../designs/straddle-helical.toml") },
    Shipped { file_name: "tapered-axle.toml", text: include_str!("../../../designs/tapered-axle.toml") },
    Shipped { file_name: "tapered-hypoid.toml", text: include_str!("../../../designs/tapered-hypoid.toml") },
    Shipped { file_name: "turbine-generator.toml", text: include_str!("../../../designs/turbine-generator.toml") },
];

/// Why there is no default library.
#[derive(Debug, thiserror::Error)]
pub enum LibraryError {
    #[error("there is no folder `designs` here, and this system names no folder for the user's data: name a folder")]
    NoDataFolder,
    #[error("{}: the library of designs cannot be created: {source}", printable(&.folder.display().to_string()))]
    Fill { folder: PathBuf, source: io::Error },
}

/// The library where none is named.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DefaultFolder {
    pub path: PathBuf,
    /// It was made just now, with the shipped designs
    pub is_new: bool,
}

/// The design files of folders and of files named one by one, in the order given; those of a folder [by name](by_name). Folders
/// below are not searched, hidden files are left out; a file that is named twice is there once. A folder that cannot be read stands for itself.
pub fn files(paths: &[PathBuf]) -> Vec<PathBuf> {
    let mut seen = HashSet::new();
    let files = paths.iter().flat_map(|path| folder_files(path).unwrap_or_else(|| vec![path.clone()]));
    files.filter(|file| seen.insert(file.clone())).collect()
}

fn folder_files(folder: &Path) -> Option<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).ok()?;
    let mut files: Vec<PathBuf> =
        entries.flatten().map(|entry| entry.path()).filter(|path| is_design_file(path)).collect();
    files.sort_by(|one, other| by_name(one, other));
    Some(files)
}

fn is_design_file(path: &Path) -> bool {
    let hidden = path.file_name().is_none_or(|name| name.to_string_lossy().starts_with('.'));
    // a pipe would be waited for without end; a link that leads nowhere is listed, with that as its reason
    let readable = fs::metadata(path).map_or(true, |metadata| metadata.is_file());
    !hidden && path.extension().is_some_and(|extension| extension == "toml") && readable
}

/// The library that is used where none is named: `designs` in the current folder, else in the user's data folder, filled
/// with the shipped designs on first use.
///
/// # Errors
///
/// [`LibraryError`] where neither is there nor can be made.
pub fn default_folder() -> Result<DefaultFolder, LibraryError> {
    default_folder_in(Path::new(""), dirs::data_dir().as_deref())
}

/// [`default_folder`], with the current folder and the user's data folder given.
///
/// # Errors
///
/// As [`default_folder`].
pub fn default_folder_in(current: &Path, data: Option<&Path>) -> Result<DefaultFolder, LibraryError> {
    let folder = default_place(current, data).ok_or(LibraryError::NoDataFolder)?;
    if folder.is_dir() {
        return Ok(DefaultFolder { path: folder, is_new: false });
    }
    match fill(&folder) {
        Ok(()) => Ok(DefaultFolder { path: folder, is_new: true }),
        Err(source) => Err(LibraryError::Fill { folder, source }),
    }
}

/// Where [`default_folder_in`] is or would be.
pub fn default_place(current: &Path, data: Option<&Path>) -> Option<PathBuf> {
    let here = current.join("designs");
    if here.is_dir() { Some(here) } else { data.map(|data| data.join("bevelscope").join("designs")) }
}

/// Writes the shipped designs beside the folder first and renames it as a whole, so there is never half a library, and
/// a folder that someone else made meanwhile stays as it is.
fn fill(folder: &Path) -> io::Result<()> {
    let parent = folder.parent().unwrap_or(Path::new(""));
    fs::create_dir_all(parent)?;
    let draft = parent.join(format!(".designs.{}.new", std::process::id()));
    let filled = write_shipped(&draft).and_then(|()| fs::rename(&draft, folder));
    if filled.is_err() {
        // whatever is left of the draft is of no use; the first error is the one that counts
        let _ = fs::remove_dir_all(&draft);
        if folder.is_dir() {
            return Ok(());
        }
    }
    filled
}

fn write_shipped(draft: &Path) -> io::Result<()> {
    // left over from a process that was ended half-way
    let _ = fs::remove_dir_all(draft);
    fs::create_dir(draft)?;
    SHIPPED.iter().try_for_each(|shipped| fs::write(draft.join(shipped.file_name), shipped.text))
}
