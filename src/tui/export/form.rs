//! The name of the file that is to be written, while it is typed.

use std::path::{Path, PathBuf};

use super::{Export, Shown};
use crate::document::Format;
use crate::text::printable;
use crate::tui::app::App;
use crate::tui::file_jobs::FileJob;
use crate::tui::keymap::Mode;
use crate::tui::message::Effect;
use crate::tui::text_field::TextField;

/// What is typed, and what was in sight when the form was opened.
#[derive(Debug)]
pub struct ExportForm {
    pub field: TextField,
    /// Why the file was not written.
    pub refused: Option<String>,
    /// It is being written.
    pub pending: bool,
    shown: Shown,
}

impl App {
    pub(in crate::tui) fn open_export(&mut self) {
        let Some((name, shown)) = self.shown() else {
            return self.complain("there is nothing to write yet");
        };
        let letter = |letter: char| if letter.is_alphanumeric() || "-_.".contains(letter) { letter } else { '-' };
        let name: String = name.chars().map(letter).collect();
        self.export = Some(ExportForm { field: TextField::proposed(name), refused: None, pending: false, shown });
        self.open(Mode::Export);
    }

    /// What the screen shows, and a name for it.
    fn shown(&self) -> Option<(String, Shown)> {
        let stem = |path: &Path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let document = |document| Shown::Document(Box::new(document));
        match self.mode {
            Mode::Spectra => {
                let view = self.spectra.as_ref()?;
                let shown = view.shown_now()?;
                Some((format!("{}-{}.csv", stem(&view.path), shown.name()), Shown::Spectra(Box::new(shown))))
            }
            Mode::Modes => {
                let (what, found) = self.modes.as_ref()?.document()?;
                Some((format!("{}-{what}.csv", self.modes.as_ref()?.stem), document(found)))
            }
            Mode::Overview => Some(("overview.csv".into(), document(self.overview_document()))),
            Mode::Compare => {
                let view = self.compare.as_ref()?;
                let [a, b] = view.paths().each_ref().map(|path| stem(path));
                Some((format!("{a}-and-{b}.csv"), document(view.document()?)))
            }
            Mode::Bearings => Some((
                format!("{}-bearings.csv", stem(&self.editors.open()?.path)),
                document(self.bearings_document()?),
            )),
            Mode::Pair => {
                Some((format!("{}-gear-pair.csv", stem(&self.editors.open()?.path)), document(self.pair_document()?)))
            }
            _ => {
                let path = match self.editors.open() {
                    Some(editing) => editing.path.clone(),
                    None => self.library.selected()?.path.clone(),
                };
                let text = self.editors.unsaved_text(&path);
                Some((format!("{}.html", stem(&path)), Shown::Design { path, text }))
            }
        }
    }

    pub(in crate::tui) fn edit_export(&mut self, edit: impl FnOnce(&mut TextField)) {
        if let Some(form) = self.export.as_mut().filter(|form| !form.pending) {
            form.refused = None;
            edit(&mut form.field);
        }
    }

    pub(in crate::tui) fn accept_export(&mut self) -> Vec<Effect> {
        let Some(form) = self.export.as_mut().filter(|form| !form.pending) else { return Vec::new() };
        let path = PathBuf::from(form.field.text().trim());
        let refused = if path.as_os_str().is_empty() {
            Some("a file needs a name".to_owned())
        } else {
            Format::of(&path).err().map(|error| error.to_string())
        };
        if refused.is_some() {
            form.refused = refused;
            return Vec::new();
        }
        form.pending = true;
        vec![Effect::File(FileJob::Export(Box::new(Export { path, shown: form.shown.clone() })))]
    }

    /// The file is there, or not.
    pub(in crate::tui) fn exported(&mut self, result: Result<PathBuf, String>) {
        let form = self.export.as_mut().filter(|form| form.pending);
        match (result, form) {
            (Ok(path), form) => {
                if form.is_some() {
                    self.close_export();
                }
                self.say_in_sight(format!("written: {}", printable(&path.display().to_string())));
            }
            (Err(error), Some(form)) => {
                form.pending = false;
                form.refused = Some(printable(&error).into_owned());
            }
            (Err(error), None) => self.complain(error),
        }
    }

    pub(in crate::tui) fn close_export(&mut self) {
        self.export = None;
        if self.mode == Mode::Export {
            self.close();
        } else {
            self.below.retain(|mode| *mode != Mode::Export);
        }
    }
}
