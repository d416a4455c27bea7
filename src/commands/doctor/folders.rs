//! The folders and files of the user's that the program knows: whether they are there, and can be written.

use std::fs::{self, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

use crate::commands::keys::KeysArg;
use crate::crash;
use crate::design::library;

/// A row a folder.
pub fn rows(keys: &KeysArg) -> Vec<(String, String)> {
    let config = dirs::config_dir().map(|folder| folder.join("bevelscope"));
    let key_file = keys.named().or_else(|| config.as_ref().map(|folder| folder.join("keys.toml")));
    let designs = library::default_place(Path::new(""), dirs::data_dir().as_deref());
    let folder = |path: Option<PathBuf>| path.map_or_else(|| "this system names none".into(), |path| folder(&path));
    vec![
        ("designs".into(), folder(designs)),
        ("configuration".into(), folder(config)),
        ("state".into(), folder(crash::folder())),
        ("key file".into(), key_file.map_or_else(|| "this system names none".into(), |path| file(&path))),
    ]
}

fn folder(path: &Path) -> String {
    let shown = std::path::absolute(path).unwrap_or_else(|_| path.into()).display().to_string();
    if path.is_dir() {
        return match try_to_write(path) {
            Ok(()) => format!("{shown} (exists, can be written)"),
            Err(error) => format!("{shown} (exists, cannot be written: {error})"),
        };
    }
    if path.symlink_metadata().is_ok() {
        return format!("{shown} (is no folder)");
    }
    // it is made when it is first needed, in the nearest folder that is there
    let above = path.ancestors().skip(1).find(|above| above.is_dir());
    match above.map(try_to_write) {
        Some(Ok(())) => format!("{shown} (not there yet, can be made)"),
        Some(Err(error)) => format!("{shown} (not there, cannot be made: {error})"),
        None => format!("{shown} (not there, and nothing above it)"),
    }
}

fn file(path: &Path) -> String {
    let shown = path.display();
    match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => format!("{shown} (is a folder)"),
        Ok(metadata) if !metadata.is_file() => format!("{shown} (is no plain file)"),
        Ok(_) => match fs::File::open(path) {
            // opened and closed as it is
            Ok(_) if OpenOptions::new().append(true).open(path).is_ok() => format!("{shown} (exists, can be written)"),
            Ok(_) => format!("{shown} (exists, cannot be written)"),
            Err(error) => format!("{shown} (cannot be read: {error})"),
        },
        Err(error) if error.kind() == io::ErrorKind::NotFound => format!("{shown} (not there: the shipped keys hold)"),
        Err(error) => format!("{shown} (cannot be reached: {error})"),
    }
}

/// Permissions do not tell: not as root, not on a file system that is mounted read-only.
fn try_to_write(folder: &Path) -> io::Result<()> {
    let probe = folder.join(format!(".bevelscope-doctor-{}", std::process::id()));
    OpenOptions::new().write(true).create_new(true).open(&probe)?;
    fs::remove_file(&probe)
}
