//! Saving, variants, and what to do with unsaved edits when the program ends.

use std::path::{Path, PathBuf};

use super::{Layer, update::plural};
use crate::text::printable;
use crate::tui::app::App;
use crate::tui::backend::NotSaved;
use crate::tui::file_jobs::FileJob;
use crate::tui::keymap::Mode;
use crate::tui::message::{Effect, Ending};
use crate::tui::recovery::FileState;

impl App {
    /// Saves one design, or the one in sight.
    pub(in crate::tui) fn save(&mut self, path: Option<&Path>) -> Vec<Effect> {
        let editing = match path {
            Some(path) => self.editors.get_mut(path),
            None => self.editors.open_mut(),
        };
        let Some(editing) = editing else { return Vec::new() };
        if !editing.is_modified() {
            editing.say("nothing to save");
            return Vec::new();
        }
        if editing.is_saving {
            return Vec::new();
        }
        editing.is_saving = true;
        let (path, expected) = (editing.path.clone(), editing.saved_text().as_bytes().to_vec());
        vec![Effect::File(FileJob::Save { path, expected: Some(expected), text: editing.editor.text().to_owned() })]
    }

    pub(in crate::tui) fn saved(&mut self, path: &Path, text: String, result: Result<(), NotSaved>) -> Vec<Effect> {
        let Some(editing) = self.editors.get_mut(path) else { return Vec::new() };
        editing.is_saving = false;
        let name = file_name(path);
        match result {
            Ok(()) => {
                editing.saved(text);
                editing.look.state = FileState::Same;
                let errors = editing.errors();
                match errors {
                    0 => editing.say(format!("saved {name}")),
                    _ => editing.say(format!("saved {name}, with {errors} {}", plural(errors, "error"))),
                }
                let unsaved = editing.is_modified();
                if let Some(row) = self.library.row_mut(path) {
                    row.unsaved = unsaved;
                }
            }
            Err(NotSaved::Changed(on_disk)) => {
                editing.warn("not saved: the file has changed on disk");
                editing.look.state = if on_disk.is_some() { FileState::Changed } else { FileState::Gone };
                self.conflicting(path, on_disk);
                return Vec::new();
            }
            Err(error) => {
                editing.warn(format!("not saved: {error}"));
                if self.editors.open().is_none_or(|editing| editing.path != path) {
                    self.complain(format!("{name} not saved: {error}"));
                }
                self.editors.is_leaving = false;
                return Vec::new();
            }
        }
        if self.editors.is_leaving || self.mode == Mode::Leave {
            return self.leave_if_saved().into_iter().collect();
        }
        let mut effects = self.show_saved(path);
        effects.extend(self.fill());
        effects
    }

    pub(super) fn save_form(&mut self) -> Vec<Effect> {
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        let (original, text) = (editing.path.clone(), editing.editor.text().to_owned());
        if editing.is_saving {
            return Vec::new();
        }
        let Some(Layer::Form(form)) = &mut editing.layer else { return Vec::new() };
        match form.checked_name() {
            Ok(name) => {
                let note = Some(form.note.text().trim()).filter(|note| !note.is_empty()).map(str::to_owned);
                editing.is_saving = true;
                vec![Effect::File(FileJob::SaveVariant { original, name, text, note })]
            }
            Err(error) => {
                form.error = Some(error.to_string());
                form.on_note = false;
                Vec::new()
            }
        }
    }

    pub(in crate::tui) fn variant_saved(
        &mut self,
        original: &Path,
        result: Result<(PathBuf, String), String>,
    ) -> Vec<Effect> {
        let Some(editing) = self.editors.get_mut(original) else { return Vec::new() };
        editing.is_saving = false;
        match result {
            Ok((path, text)) => {
                let name = file_name(&path);
                editing.become_variant(path.clone(), text);
                editing.say(format!("saved {name}, a variant of {}", file_name(original)));
                if let Some(row) = self.library.row_mut(original) {
                    row.unsaved = false;
                }
                let was_open = self.editors.open.as_deref() == Some(original);
                self.library.add(path.clone());
                if was_open {
                    self.editors.open = Some(path.clone());
                    self.library.select(&path);
                }
                let mut effects = self.follow_selection();
                effects.push(Effect::List);
                effects.extend(self.fill());
                effects.extend(self.after_edit());
                effects
            }
            Err(error) => {
                match &mut editing.layer {
                    Some(Layer::Form(form)) => form.error = Some(error),
                    _ => editing.warn(format!("no variant: {error}")),
                }
                Vec::new()
            }
        }
    }

    /// Ends the program, or asks what to do with edits that are not saved.
    pub(in crate::tui) fn quit(&mut self) -> Vec<Effect> {
        if self.editors.unsaved().next().is_none() {
            return vec![Effect::Quit(Ending::Quit)];
        }
        if self.mode != Mode::Leave {
            while !self.below.is_empty() {
                self.close();
            }
            self.open(Mode::Leave);
        }
        Vec::new()
    }

    /// Saves everything and ends the program then.
    pub(in crate::tui) fn save_all(&mut self) -> Vec<Effect> {
        self.stay();
        self.editors.is_leaving = true;
        let paths: Vec<PathBuf> = self.editors.unsaved().map(|editing| editing.path.clone()).collect();
        paths.iter().flat_map(|path| self.save(Some(path))).collect()
    }

    /// Closes the question.
    pub(in crate::tui) fn stay(&mut self) {
        self.editors.is_leaving = false;
        if self.mode == Mode::Leave {
            self.close();
        }
    }
}

/// The file's name, harmless to show.
fn file_name(path: &Path) -> String {
    printable(&path.file_name().unwrap_or_default().to_string_lossy()).into_owned()
}
