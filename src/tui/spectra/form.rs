//! The name of the file that is to be written, while it is typed.

use std::path::PathBuf;

use crate::text::printable;
use crate::tui::app::App;
use crate::tui::file_jobs::FileJob;
use crate::tui::keymap::Mode;
use crate::tui::message::Effect;
use crate::tui::text_field::TextField;

/// What is typed.
#[derive(Debug, Default)]
pub struct ExportForm {
    pub field: TextField,
    /// Why the file was not written.
    pub refused: Option<String>,
    /// It is being written.
    pub pending: bool,
}

impl App {
    pub(in crate::tui) fn open_export(&mut self) {
        let Some(view) = &mut self.spectra else { return };
        let Some(export) = view.export(PathBuf::new()) else {
            return self.complain("there is no curve to write");
        };
        let subject = view.known.subject.as_ref();
        let column = subject.map_or(String::new(), |subject| view.quantity.column(&subject.design));
        let stem = view.path.file_stem().unwrap_or_default().to_string_lossy();
        let letter = |letter: char| if letter.is_alphanumeric() || "-_".contains(letter) { letter } else { '-' };
        let name: String =
            format!("{stem}-{}", column.trim_end_matches("_n").trim_end_matches("_um")).chars().map(letter).collect();
        drop(export);
        view.form = Some(ExportForm { field: TextField::new(format!("{name}.csv")), ..ExportForm::default() });
        self.open(Mode::Export);
    }

    pub(in crate::tui) fn edit_export(&mut self, edit: impl FnOnce(&mut TextField)) {
        let form = self.spectra.as_mut().and_then(|view| view.form.as_mut());
        if let Some(form) = form.filter(|form| !form.pending) {
            form.refused = None;
            edit(&mut form.field);
        }
    }

    pub(in crate::tui) fn accept_export(&mut self) -> Vec<Effect> {
        let Some(view) = &mut self.spectra else { return Vec::new() };
        let Some(form) = view.form.as_ref().filter(|form| !form.pending) else { return Vec::new() };
        let name = form.field.text().trim().to_owned();
        let export = if name.is_empty() { None } else { view.export(PathBuf::from(name)) };
        let Some(form) = &mut view.form else { return Vec::new() };
        let Some(export) = export else {
            form.refused = Some("a file needs a name".into());
            return Vec::new();
        };
        form.pending = true;
        vec![Effect::File(FileJob::Export(Box::new(export)))]
    }

    /// The file is there, or not.
    pub(in crate::tui) fn exported(&mut self, result: Result<PathBuf, String>) {
        let form = self.spectra.as_mut().and_then(|view| view.form.as_mut());
        match (result, form) {
            (Ok(path), form) => {
                if form.is_some_and(|form| form.pending) {
                    self.close_export();
                }
                self.say(format!("written: {}", printable(&path.display().to_string())));
            }
            (Err(error), Some(form)) if form.pending => {
                form.pending = false;
                form.refused = Some(printable(&error).into_owned());
            }
            (Err(error), _) => self.complain(error),
        }
    }

    pub(in crate::tui) fn close_export(&mut self) {
        if let Some(view) = &mut self.spectra {
            view.form = None;
        }
        if self.mode == Mode::Export {
            self.close();
        } else {
            self.below.retain(|mode| *mode != Mode::Export);
        }
    }
}
