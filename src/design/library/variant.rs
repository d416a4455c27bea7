//! New files from old ones: variants, copies, other names.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::{VariantName, files};
use crate::design::save::{SaveError, move_to_free, save, save_new};
use crate::design::{Document, EditError, KeyPath, Spelled};

/// Why there is no variant.
#[derive(Debug, thiserror::Error)]
pub enum VariantError {
    #[error(transparent)]
    Edit(#[from] EditError),
    #[error(transparent)]
    Save(#[from] SaveError),
}

/// What a variant says about itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct About<'a> {
    /// Name of the design; nothing leaves it as it is
    pub design_name: Option<&'a str>,
    /// File stem of the design that it came from; nothing takes the key out
    pub parent: Option<&'a str>,
    /// Nothing takes the key out
    pub note: Option<&'a str>,
}

/// Writes a text as a new file of the library; `name`, `parent` and `note` are set in it, all else is kept. Gives the path
/// and the text that was written.
///
/// # Errors
///
/// [`VariantError`]; a file that is there is never overwritten.
pub fn save_variant(
    folder: &Path,
    name: &VariantName,
    text: &str,
    about: About<'_>,
) -> Result<(PathBuf, String), VariantError> {
    let text = with_about(text, about)?;
    let path = name.path_in(folder);
    save_new(&path, &text)?;
    Ok((path, text))
}

fn with_about(text: &str, about: About<'_>) -> Result<String, EditError> {
    let mut document = Document::parse(text)?;
    if let Some(name) = about.design_name {
        document.put(&KeyPath::root().key("name"), Spelled::text(name).as_str())?;
    }
    for (key, value) in [("parent", about.parent), ("note", about.note)] {
        let path = KeyPath::root().key(key);
        match value {
            Some(value) => drop(document.put(&path, Spelled::text(value).as_str())?),
            None if document.raw(&path).is_some() => document.unset(&path)?,
            None => {}
        }
    }
    Ok(document.text().to_owned())
}

/// Gives a file another name in its folder. Variants of it name the old one as their parent until [`follow_parent`].
///
/// # Errors
///
/// [`SaveError`]; a file that is there is never overwritten.
pub fn rename(path: &Path, name: &VariantName) -> Result<PathBuf, SaveError> {
    let new = name.path_in(path.parent().unwrap_or(Path::new("")));
    if new != path {
        move_to_free(path, &new)?;
    }
    Ok(new)
}

/// Copies a file, byte for byte, to another name in its folder.
///
/// # Errors
///
/// [`SaveError`]; a file that is there is never overwritten.
pub fn duplicate(path: &Path, name: &VariantName) -> Result<PathBuf, SaveError> {
    let new = name.path_in(path.parent().unwrap_or(Path::new("")));
    let bytes = fs::read(path).map_err(|source| match source.kind() {
        io::ErrorKind::NotFound => SaveError::NotThere(path.into()),
        io::ErrorKind::IsADirectory => SaveError::Folder(path.into()),
        _ => SaveError::Io { path: path.into(), doing: "cannot be read", source },
    })?;
    save_new(&new, &bytes)?;
    Ok(new)
}

/// After a renaming: every design of the folder whose `parent` is `from` gets `to`, all else in it is kept. Gives the files
/// that name it, each with its text now or with why it stayed as it was.
pub fn follow_parent(folder: &Path, from: &str, to: &VariantName) -> Vec<(PathBuf, Result<String, VariantError>)> {
    let parent = KeyPath::root().key("parent");
    let follow = |path: PathBuf| {
        let mut document = Document::parse(fs::read_to_string(&path).ok()?).ok()?;
        if document.get(&parent)?.as_str() != Some(from) {
            return None;
        }
        let set = document.set(&parent, to.as_str()).map_err(VariantError::from);
        let saved = set.and_then(|()| Ok(save(&path, document.text())?));
        Some((path, saved.map(|()| document.text().to_owned())))
    };
    // the current folder is listed as `.`, and its files are named without it
    let here = folder.as_os_str().is_empty();
    let listed = files(&[if here { PathBuf::from(".") } else { folder.to_path_buf() }]).into_iter();
    let listed = listed.filter_map(|path| if here { path.file_name().map(PathBuf::from) } else { Some(path) });
    listed.filter_map(follow).collect()
}
