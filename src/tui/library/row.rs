//! What is known of one design file.

use std::path::PathBuf;
use std::sync::Arc;

use crate::text::printable;
use crate::tui::backend::{BrokenDesign, LoadedDesign};
use crate::tui::solving::{Summary, Ticket};

/// One design file.
#[derive(Debug, Clone)]
pub struct Row {
    pub path: PathBuf,
    /// File name without `.toml`, safe to show.
    pub stem: String,
    pub loaded: Option<Arc<LoadedDesign>>,
    pub state: RowState,
    /// What is known comes from this request; older results are refused.
    pub ticket: Ticket,
    /// To be read again.
    pub stale: bool,
    /// It has edits that are not in the file.
    pub unsaved: bool,
}

#[derive(Debug, Clone, PartialEq)]
pub enum RowState {
    /// Not read yet.
    Pending,
    /// Read, not solved yet.
    Loaded,
    Solved(Summary),
    Broken(BrokenDesign),
    /// Can be read but not solved; the whole message.
    Unsolvable(String),
}

impl Row {
    pub(in crate::tui) fn new(path: PathBuf) -> Self {
        let stem = path.file_stem().map_or_else(|| path.to_string_lossy(), |stem| stem.to_string_lossy());
        let stem = printable(&stem).into_owned();
        Self {
            path,
            stem,
            loaded: None,
            state: RowState::Pending,
            ticket: Ticket::default(),
            stale: false,
            unsaved: false,
        }
    }

    /// The design's own name, or the file's while it is not known; safe to show.
    pub fn name(&self) -> String {
        let name = self.loaded.as_ref().map(|loaded| printable(loaded.design.name.trim()).into_owned());
        name.filter(|name| !name.is_empty()).unwrap_or_else(|| self.stem.clone())
    }

    /// What of the file looks unintended, and what is unusual about the mean states of its bearings.
    pub fn warnings(&self) -> impl Iterator<Item = &str> {
        let of_file = self.loaded.iter().flat_map(|loaded| &loaded.warnings);
        let of_states = match &self.state {
            RowState::Solved(summary) => &*summary.warnings,
            _ => &[],
        };
        of_file.chain(of_states).map(String::as_str)
    }

    /// The file's name as it is, without `.toml`: what a variant names as its parent.
    pub(super) fn raw_stem(&self) -> String {
        self.path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
    }

    pub(super) fn parent(&self) -> Option<&str> {
        self.loaded.as_ref().and_then(|loaded| loaded.design.parent.as_deref())
    }

    pub(super) fn matches(&self, filter: &str) -> bool {
        let name = self.loaded.as_ref().map_or("", |loaded| &loaded.design.name);
        filter.is_empty() || self.stem.to_lowercase().contains(filter) || name.to_lowercase().contains(filter)
    }

    /// What of the design's own name matches where the file's does not, from the match on; safe to show.
    pub fn matching_title(&self, filter: &str) -> Option<String> {
        let filter = filter.to_lowercase();
        if filter.is_empty() || self.stem.to_lowercase().contains(&filter) {
            return None;
        }
        let name = self.loaded.as_ref()?.design.name.as_str();
        let start = name.char_indices().map(|(at, _)| at).find(|&at| name[at..].to_lowercase().starts_with(&filter))?;
        Some(printable(&name[start..]).into_owned())
    }

    pub(super) fn waits(&self) -> bool {
        self.stale || matches!(self.state, RowState::Pending | RowState::Loaded)
    }
}
