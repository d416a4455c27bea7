//! A table of averaged mesh numbers: its file while that is named, and what it would change.

use std::path::{Path, PathBuf};

use crate::design::grid::Sheet;
use crate::design::{EditError, Editor, Side, diff};
use crate::gear::AveragedMesh;
use crate::pair::{Flank, edit_of, import_notes};
use crate::text::printable;
use crate::tui::app::{App, Scroll};
use crate::tui::file_jobs::FileJob;
use crate::tui::keymap::Mode;
use crate::tui::message::Effect;
use crate::tui::solving::Ticket;
use crate::tui::text_field::TextField;
use crate::tui::widgets::findings::sentence;

/// What is chosen so far.
#[derive(Debug)]
pub struct ImportForm {
    /// The file
    pub field: TextField,
    pub flank: Flank,
    /// Why the file was not taken, harmless to show.
    pub refused: Option<String>,
    /// The file is being read.
    pub pending: Option<Ticket>,
    flanks: Vec<AveragedMesh>,
    /// What the flank would change, or why it cannot be taken.
    pub preview: Option<Result<Preview, String>>,
    pub scroll: Scroll,
}

/// What would be changed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Preview {
    /// Label, old and new value, unit; harmless to show
    pub changes: Vec<[String; 4]>,
    /// What is to be known before, and what would be wrong or unusual in the mesh afterwards
    pub findings: Vec<String>,
}

impl Default for ImportForm {
    fn default() -> Self {
        Self {
            field: TextField::default(),
            flank: Flank::Drive,
            refused: None,
            pending: None,
            flanks: Vec::new(),
            preview: None,
            scroll: Scroll::default(),
        }
    }
}

impl App {
    pub(super) fn open_import(&mut self) {
        if let Some(view) = &mut self.pair {
            view.import = Some(ImportForm::default());
            self.open(Mode::MeshFile);
        }
    }

    fn import_form(&mut self) -> Option<&mut ImportForm> {
        self.pair.as_mut().and_then(|view| view.import.as_mut())
    }

    pub(in crate::tui) fn edit_mesh_file(&mut self, edit: impl FnOnce(&mut TextField)) {
        if let Some(form) = self.import_form().filter(|form| form.pending.is_none()) {
            form.refused = None;
            edit(&mut form.field);
        }
    }

    pub(super) fn other_flank(&mut self) {
        if let Some(form) = self.import_form() {
            form.flank = form.flank.other();
        }
        if self.mode == Mode::MeshImport {
            self.preview_import();
        }
    }

    /// Asks for the file.
    pub(super) fn read_mesh_file(&mut self) -> Vec<Effect> {
        let ticket = self.ticket();
        let Some(form) = self.import_form().filter(|form| form.pending.is_none()) else { return Vec::new() };
        let name = form.field.text().trim();
        if name.is_empty() {
            form.refused = Some("the name of a CSV file is wanted".into());
            return Vec::new();
        }
        let path = PathBuf::from(name);
        form.pending = Some(ticket);
        vec![Effect::File(FileJob::MeshTable { ticket, path })]
    }

    /// The table is there, or why it is not.
    pub(in crate::tui) fn mesh_table_came(&mut self, ticket: Ticket, result: Result<Vec<AveragedMesh>, String>) {
        let Some(form) = self.import_form().filter(|form| form.pending == Some(ticket)) else { return };
        form.pending = None;
        let flank = form.flank;
        match result.and_then(|flanks| flank.of(&flanks).map(drop).map(|()| flanks)) {
            Ok(flanks) => {
                form.flanks = flanks;
                form.scroll = Scroll::default();
                // something may lie over the form meanwhile
                if self.mode == Mode::MeshFile {
                    self.mode = Mode::MeshImport;
                } else {
                    self.below
                        .iter_mut()
                        .filter(|mode| **mode == Mode::MeshFile)
                        .for_each(|mode| *mode = Mode::MeshImport);
                }
                self.preview_import();
            }
            Err(error) => form.refused = Some(printable(&error).into_owned()),
        }
    }

    fn preview_import(&mut self) {
        let Some(editing) = self.editors.open() else { return };
        let text = editing.editor.text();
        let Some(form) = self.pair.as_ref().and_then(|view| view.import.as_ref()) else { return };
        let preview = form.flank.of(&form.flanks).and_then(|mesh| preview(text, mesh, &file_name(form.field.text())));
        if let Some(form) = self.import_form() {
            form.preview = Some(preview);
        }
    }

    /// Takes the flank over, as one edit.
    pub(super) fn accept_import(&mut self) -> Vec<Effect> {
        let Some(form) = self.pair.as_ref().and_then(|view| view.import.as_ref()) else { return Vec::new() };
        let (Some(Ok(_)), Some(editing)) = (&form.preview, self.editors.open()) else { return Vec::new() };
        let edit =
            form.flank.of(&form.flanks).map(|mesh| edit_of(mesh, &editing.editor, &file_name(form.field.text())));
        self.close_pair_form();
        edit.map_or(Vec::new(), |edit| self.edit_pair(&edit))
    }
}

/// The last part of a path, which a design's comment names.
fn file_name(path: &str) -> String {
    Path::new(path.trim()).file_name().map_or_else(String::new, |name| printable(&name.to_string_lossy()).into_owned())
}

fn preview(text: &str, mesh: &AveragedMesh, file: &str) -> Result<Preview, String> {
    let in_words = |error: EditError| printable(&error.to_string()).into_owned();
    let before = Editor::new(text).map_err(in_words)?;
    let mut editor = before.clone();
    editor.apply(&edit_of(mesh, &before, file)).map_err(in_words)?;
    let vectors = Side::BOTH.map(|side| before.grid(&Sheet::mesh_side(side)));
    let changes = diff(text, editor.text()).into_iter().map(|difference| {
        let [a, b] = difference.shown();
        // of what was not written the label is in the new text
        let label = if difference.a.is_some() { &difference.label } else { &difference.label_in_b };
        let derived =
            vectors.iter().find_map(|grid| grid.cell(&difference.path)).filter(|cell| cell.shown.is_derived());
        let a = derived.map_or_else(|| a.to_owned(), |cell| format!("({})", cell.shown.text()));
        let (b, unit) = if difference.b.is_none() { ("removed", "") } else { (b, difference.unit) };
        [label.as_str(), &a, b, unit].map(|text| printable(text).into_owned())
    });
    let findings = editor.reading().findings.iter().filter(|finding| finding.shown_path().starts_with("mesh"));
    let notes = import_notes(mesh, &before).into_iter().map(|note| printable(&note).into_owned());
    Ok(Preview { changes: changes.collect(), findings: notes.chain(findings.map(sentence)).collect() })
}
