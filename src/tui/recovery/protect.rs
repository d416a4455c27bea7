//! What is to be kept, and which files to look after, after each message.

use std::path::{Path, PathBuf};

use super::{FileState, Kept, Look};
use crate::tui::app::App;
use crate::tui::file_jobs::FileJob;
use crate::tui::message::Effect;

impl App {
    /// Brings what is kept outside the program in line with the texts.
    pub(in crate::tui) fn protect(&mut self) -> Vec<Effect> {
        let mut effects = Vec::new();
        let recovery = &mut self.recovery;
        if recovery.is_over {
            return effects;
        }
        let mut gone: Vec<PathBuf> = recovery.kept.keys().cloned().collect();
        let mut looked: Vec<PathBuf> = Vec::new();
        for editing in self.editors.unsaved() {
            gone.retain(|path| *path != editing.path);
            let (path, base, text) = (editing.path.clone(), editing.saved_text(), editing.editor.text());
            if recovery.kept.get(&path).is_some_and(|kept| kept.0 == base && kept.1 == text) {
                continue;
            }
            let kept = (base.to_owned(), text.to_owned());
            recovery.kept.insert(path.clone(), kept.clone());
            looked.push(path.clone());
            effects.push(Effect::Keep(Kept::Edits { path, base: kept.0, text: kept.1 }));
        }
        for path in gone {
            recovery.kept.remove(&path);
            effects.push(Effect::Keep(Kept::Nothing { path }));
        }
        let open: Vec<PathBuf> = self.editors.in_use().map(|editing| editing.path.clone()).collect();
        for path in open.iter().filter(|path| !recovery.open.contains(*path)) {
            if !looked.contains(path) {
                looked.push(path.clone());
            }
        }
        let left: Vec<PathBuf> = recovery.open.iter().filter(|path| !open.contains(path)).cloned().collect();
        recovery.open = open.into_iter().collect();
        for path in left {
            if let Some(editing) = self.editors.get_mut(&path) {
                editing.look = Look::default();
            }
            effects.push(Effect::File(FileJob::Release { path }));
        }
        effects.extend(looked.into_iter().filter_map(|path| self.look(path)));
        effects
    }

    /// Asks what has become of the file, unless the answer is on its way.
    pub(in crate::tui) fn look(&mut self, path: PathBuf) -> Option<Effect> {
        let editing = self.editors.get_mut(&path)?;
        if editing.is_saving || std::mem::replace(&mut editing.is_looking, true) {
            return None;
        }
        let expected = editing.saved_text().to_owned();
        Some(Effect::File(FileJob::Look { path, expected }))
    }

    pub(super) fn looked(&mut self, path: &Path, look: Look) {
        let Some(editing) = self.editors.get_mut(path) else { return };
        editing.is_looking = false;
        let before = std::mem::replace(&mut editing.look, look);
        match (&before.holder, &editing.look.holder) {
            (None, Some(holder)) => {
                let text =
                    format!("{holder} has this design open as well: what is saved last would win, so saving asks");
                editing.warn(text);
            }
            (Some(holder), None) => editing.say(format!("the design is held here now, no longer by {holder}")),
            _ => {}
        }
        if before.state != editing.look.state {
            match editing.look.state {
                FileState::Changed => editing.warn("somebody else has changed the file: saving will show how"),
                FileState::Gone => editing.warn("the file is gone: saving will ask"),
                FileState::Same => editing.say("the file is again as these edits began"),
            }
        }
    }

    /// The edits that are not saved are not wanted.
    pub(super) fn discard_all(&mut self) -> Vec<Effect> {
        self.recovery.is_over = true;
        let kept = std::mem::take(&mut self.recovery.kept);
        kept.into_keys().map(|path| Effect::Keep(Kept::Discarded { path })).collect()
    }

    pub(super) fn protected(&mut self, result: Result<(), String>) {
        let before = self.recovery.unprotected.take();
        match result {
            Ok(()) if before.is_some() => self.say("unsaved edits are protected again"),
            Ok(()) => {}
            Err(error) => {
                self.recovery.unprotected = Some(format!("unsaved edits are not protected: {error}"));
                self.messages.keep(format!("unsaved edits are not protected: {error}"));
            }
        }
    }
}
