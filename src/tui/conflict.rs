//! Saving where somebody else has changed the file: what they did, what is to be saved, and which of both is to stay.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};

use super::app::{App, Scroll};
use super::editor::{Form, Layer};
use super::file_jobs::FileJob;
use super::keymap::Mode;
use super::library::Row;
use super::message::{Effect, Ending};
use super::recovery::Theirs;
use crate::design::library::OnDisk;
use crate::design::{Changes, Document, Edit, EditName};

/// A file that is not what the edits began with.
#[derive(Debug, Clone, PartialEq)]
pub struct Conflict {
    pub path: PathBuf,
    /// The file's name without `.toml`, safe to show
    pub stem: String,
    /// What the file holds, to the byte; nothing where it is gone
    on_disk: Option<Vec<u8>>,
    /// The edits since they began
    pub mine: Changes,
    /// What became of the file since then
    pub theirs: Theirs,
    /// Its text, where it can be shown in tables
    their_text: Option<String>,
}

/// What is still to be answered, the first one in sight.
#[derive(Debug, Default)]
pub struct Conflicts {
    waiting: VecDeque<Conflict>,
    pub scroll: Scroll,
}

impl Conflicts {
    pub fn present(&self) -> Option<&Conflict> {
        self.waiting.front()
    }
}

impl Conflict {
    fn new(path: PathBuf, base: &str, text: &str, on_disk: Option<Vec<u8>>) -> Self {
        let now = OnDisk::from_bytes(on_disk.clone());
        let mut theirs = Theirs::since(base, &now).unwrap_or(Theirs::Changed(Changes::between(base, base)));
        let mut their_text = if let OnDisk::Text(text) = now { Some(text) } else { None };
        if let Some(Err(error)) = their_text.as_deref().map(Document::parse) {
            let reason = error.to_string();
            theirs = Theirs::Unreadable(reason.lines().next().unwrap_or_default().to_owned());
            their_text = None;
        }
        let stem = Row::new(path.clone()).stem;
        Self { path, stem, on_disk, mine: Changes::between(base, text), theirs, their_text }
    }

    /// Whether the file can be shown in tables.
    pub fn can_be_taken(&self) -> bool {
        self.their_text.is_some()
    }
}

impl App {
    /// A design was not saved because its file holds something else.
    pub(super) fn conflicting(&mut self, path: &Path, on_disk: Option<Vec<u8>>) {
        let Some(editing) = self.editors.get(path) else { return };
        let conflict = Conflict::new(path.into(), editing.saved_text(), editing.editor.text(), on_disk);
        self.conflicts.waiting.retain(|other| other.path != path);
        self.conflicts.waiting.push_back(conflict);
        if self.mode != Mode::Conflict {
            self.conflicts.scroll = Scroll::default();
            self.open(Mode::Conflict);
        }
    }

    /// Takes the present one out and closes the window after the last.
    fn answer_conflict(&mut self) -> Option<Conflict> {
        let conflict = self.conflicts.waiting.pop_front()?;
        self.conflicts.scroll = Scroll::default();
        if self.conflicts.waiting.is_empty() {
            self.close();
        }
        Some(conflict)
    }

    /// Writes over exactly what was shown.
    pub(super) fn keep_mine(&mut self) -> Vec<Effect> {
        let Some(Conflict { path, on_disk, .. }) = self.answer_conflict() else { return Vec::new() };
        let Some(editing) = self.editors.get_mut(&path) else { return Vec::new() };
        editing.is_saving = true;
        let text = editing.editor.text().to_owned();
        vec![Effect::File(FileJob::Save { path, expected: on_disk, text })]
    }

    /// The file's text as an edit, which can be undone.
    pub(super) fn take_theirs(&mut self) -> Vec<Effect> {
        if !self.conflicts.present().is_some_and(Conflict::can_be_taken) {
            self.complain("the file cannot be shown in tables, so it cannot be taken");
            return Vec::new();
        }
        let Some(Conflict { path, stem, their_text: Some(text), .. }) = self.answer_conflict() else {
            return Vec::new();
        };
        let Some(editing) = self.editors.get_mut(&path) else { return Vec::new() };
        let name = EditName::new("took the file's version");
        match editing.apply(&Edit::ReplaceText { text: text.clone(), name }) {
            Ok(_) => {
                editing.saved(text);
                editing.look.state = super::recovery::FileState::Same;
                editing.say(format!("took the file's version of {stem}; undo brings the edits back"));
            }
            Err(error) => editing.warn(error.to_string()),
        }
        if let Some(row) = self.library.row_mut(&path) {
            (row.unsaved, row.stale) = (false, true);
        }
        let mut effects = self.after_edit();
        // another file is in its place, to be locked
        if self.editors.open().is_some_and(|open| open.path == path) {
            effects.extend(self.look(path));
        }
        effects.extend(self.leave_if_saved());
        effects
    }

    /// Back to the tables, with the form for a variant.
    pub(super) fn conflict_to_variant(&mut self) -> Vec<Effect> {
        let Some(Conflict { path, .. }) = self.answer_conflict() else { return Vec::new() };
        self.cancel_conflicts();
        while !self.below.is_empty() {
            self.close();
        }
        let Some(editing) = self.editors.get_mut(&path) else { return Vec::new() };
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        editing.input = None;
        editing.layer = Some(Layer::Form(Form::new(format!("{stem}-mine"))));
        self.library.select(&path);
        let mut effects = self.follow_selection();
        effects.extend(self.show_editor(path));
        effects
    }

    /// Nothing happens: the edits are as unsaved as before.
    pub(super) fn cancel_conflicts(&mut self) {
        self.editors.is_leaving = false;
        self.conflicts.waiting.clear();
        if self.mode == Mode::Conflict {
            self.close();
        }
    }

    /// Ends the program if that was only waiting for the last design to be saved.
    pub(super) fn leave_if_saved(&self) -> Option<Effect> {
        let waits = self.editors.is_leaving || self.mode == Mode::Leave;
        (waits && self.editors.unsaved().next().is_none()).then_some(Effect::Quit(Ending::Quit))
    }
}
