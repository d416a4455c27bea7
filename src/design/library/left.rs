//! What earlier runs have left for the designs of a library.

use std::collections::HashMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use super::journal::{Found, Journal, journals, set_aside, settled};
use super::trash::shown;
use crate::design::draft::clear_stale;
use crate::text::printable;

/// Unsaved edits of a design that nobody has open any more.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LeftEdits {
    pub journal: PathBuf,
    /// The design, as the library names it.
    pub path: PathBuf,
    /// When they were written: `2025-01-31 12:00:00 UTC, 3 hours ago`
    pub when: String,
    /// What the file held when the edits began
    pub base: String,
    pub text: String,
    pub on_disk: OnDisk,
}

/// What a design file holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum OnDisk {
    Text(String),
    Gone,
    /// Why it cannot be read
    Unreadable(String),
}

impl OnDisk {
    /// What is at a path now.
    pub fn read(path: &Path) -> Self {
        // anything else than a file may never end
        match fs::metadata(path) {
            Ok(metadata) if metadata.is_dir() => return Self::Unreadable("it is a folder now".into()),
            Ok(metadata) if metadata.len() > crate::design::MAX_BYTES || !metadata.is_file() => {
                return Self::Unreadable("it is no design file any more".into());
            }
            _ => {}
        }
        match fs::read(path) {
            Ok(bytes) => Self::from_bytes(Some(bytes)),
            Err(error) if error.kind() == io::ErrorKind::NotFound => Self::Gone,
            Err(error) => Self::Unreadable(error.to_string()),
        }
    }

    /// Of a file's bytes; nothing where it is gone.
    pub fn from_bytes(bytes: Option<Vec<u8>>) -> Self {
        match bytes.map(String::from_utf8) {
            Some(Ok(text)) => Self::Text(text),
            Some(Err(_)) => Self::Unreadable("it is no UTF-8 text any more".into()),
            None => Self::Gone,
        }
    }
}

/// What earlier runs have left.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Left {
    /// Of designs of the library, the latest first.
    pub edits: Vec<LeftEdits>,
    /// Designs elsewhere that have some.
    pub elsewhere: Vec<PathBuf>,
    /// What could not be used and was set aside, a sentence each.
    pub damaged: Vec<String>,
}

/// Looks through a folder of journals for the edits of designs of a library: its `files`, and those that were in its `folders`.
/// Journals of processes that live are left alone, damaged ones are renamed, and what is of no use is removed: a journal whose edits are in
/// the file already, and drafts whose writers have ended.
pub fn left_edits(journal_folder: &Path, files: &[PathBuf], folders: &[PathBuf]) -> Left {
    let files: HashMap<PathBuf, &PathBuf> = files.iter().map(|file| (settled(file), file)).collect();
    let folders: HashMap<PathBuf, &PathBuf> =
        folders.iter().filter_map(|folder| Some((fs::canonicalize(folder).ok()?, folder))).collect();
    let in_library = |design: &Path| {
        let file = files.get(design).map(|file| (*file).clone());
        file.or_else(|| Some(folders.get(design.parent()?)?.join(design.file_name()?)))
    };
    clear_stale(journal_folder);
    let mut left = Left::default();
    for Found { path: journal, journal: read, .. } in
        journals(journal_folder).into_iter().filter(|found| !found.is_alive)
    {
        match read {
            Ok(read) => take_in(journal, read, &in_library, &mut left),
            Err(error) => {
                let name = printable(&journal.display().to_string()).into_owned();
                left.damaged.push(match set_aside(&journal) {
                    Ok(aside) => {
                        let aside = aside.file_name().unwrap_or_default().to_string_lossy().into_owned();
                        format!("{name} cannot be used: {error}. It is called {} now.", printable(&aside))
                    }
                    Err(_) => format!("{name} cannot be used: {error}."),
                });
            }
        }
    }
    left
}

fn take_in(journal: PathBuf, read: Journal, in_library: &dyn Fn(&Path) -> Option<PathBuf>, left: &mut Left) {
    let on_disk = OnDisk::read(&read.design);
    if matches!(&on_disk, OnDisk::Text(text) if *text == read.text) {
        // saved, and ended before the journal was removed; at worst it is found again
        let _ = fs::remove_file(&journal);
        return;
    }
    let Journal { design, when, base, text, .. } = read;
    match in_library(&design) {
        Some(path) => left.edits.push(LeftEdits { journal, path, when: when_and_ago(when), base, text, on_disk }),
        None if left.elsewhere.contains(&design) => {}
        None => left.elsewhere.push(design),
    }
}

fn when_and_ago(when: SystemTime) -> String {
    match SystemTime::now().duration_since(when) {
        Ok(ago) => format!("{} UTC, {}", shown(when), in_words(ago)),
        Err(_) => format!("{} UTC", shown(when)),
    }
}

fn in_words(ago: Duration) -> String {
    let minutes = ago.as_secs() / 60;
    let (count, word) = match minutes {
        0 => return "just now".into(),
        1..60 => (minutes, "minute"),
        60..1440 => (minutes / 60, "hour"),
        _ => (minutes / 1440, "day"),
    };
    format!("{count} {word}{} ago", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ages_are_told_in_words() {
        let words = |seconds| in_words(Duration::from_secs(seconds));
        let told = [0, 60, 3599, 3600, 86_399, 86_400, 864_000].map(words);
        let expected =
            ["just now", "1 minute ago", "59 minutes ago", "1 hour ago", "23 hours ago", "1 day ago", "10 days ago"];
        assert_eq!(told, expected);
    }
}
