//! One design that is being edited: its text, where the cursor is, what lies over the table.

use std::path::PathBuf;
use std::sync::Arc;

use super::cursor::Cursor;
use super::form::Form;
use super::solving::{Ghost, Solving, same_mechanics};
use super::typing::{Choice, Entry, Input};
use super::view::{Place, Tab, View, is_unknown};
use crate::design::grid::{Cell, Shown};
use crate::design::{
    Applied, Design, Document, Edit, EditError, EditName, Editor, Finding, KeyPath, Severity, Side, Spelled,
};
use crate::text::printable;
use crate::tui::app::Scroll;
use crate::tui::keymap::Mode;
use crate::tui::recovery::Look;

/// A design with its edits, kept while the program runs.
#[derive(Debug)]
pub struct Editing {
    pub path: PathBuf,
    pub editor: Editor,
    saved_design: Option<Arc<Design>>,
    /// What the text says; nothing while it has errors.
    pub design: Option<Arc<Design>>,
    /// The last one without errors.
    pub last_design: Option<Arc<Design>>,
    pub tab: Tab,
    pub side: Side,
    pub(super) cursors: [[Cursor; 2]; 8],
    pub view: View,
    pub input: Option<Input>,
    pub layer: Option<Layer>,
    pub solving: Solving,
    pub notice: Option<Notice>,
    /// A text is on its way to the file.
    pub is_saving: bool,
    /// What became of the file outside the program, as far as is known.
    pub look: Look,
    pub(in crate::tui) is_looking: bool,
}

/// What lies over the table and takes the keys.
#[derive(Debug)]
pub enum Layer {
    Choice(Choice),
    Matrix(Entry),
    Findings(List),
    Form(Form),
}

/// A list with a cursor.
#[derive(Debug, Clone, Copy, Default)]
pub struct List {
    pub cursor: usize,
    pub scroll: Scroll,
}

/// What happened, in a line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Notice {
    pub is_error: bool,
    pub text: String,
}

impl Editing {
    /// The tables of a text that was read from a file.
    ///
    /// # Errors
    ///
    /// [`EditError::Syntax`] where it is no TOML.
    pub fn new(path: PathBuf, text: String) -> Result<Self, EditError> {
        let editor = Editor::new(text)?;
        let (tab, side) = (Tab::Segments, Side::Pinion);
        let mut editing = Self {
            path,
            saved_design: None,
            design: None,
            last_design: None,
            tab,
            side,
            cursors: Default::default(),
            view: View::new(&editor, tab, side),
            editor,
            input: None,
            layer: None,
            solving: Solving::default(),
            notice: None,
            is_saving: false,
            look: Look::default(),
            is_looking: false,
        };
        editing.take_in_text();
        editing.saved_design = editing.design.clone();
        Ok(editing)
    }

    /// Who listens to the keys.
    pub fn mode(&self) -> Mode {
        match (&self.input, &self.layer) {
            (Some(_), _) => Mode::Cell,
            (None, Some(Layer::Choice(_))) => Mode::Choice,
            (None, Some(Layer::Matrix(_))) => Mode::Matrix,
            (None, Some(Layer::Findings(_))) => Mode::Findings,
            (None, Some(Layer::Form(_))) => Mode::Form,
            (None, None) => Mode::Table,
        }
    }

    pub fn is_modified(&self) -> bool {
        self.editor.is_modified()
    }

    /// The text that the file had when it was read or written last.
    pub fn saved_text(&self) -> &str {
        self.editor.saved_text()
    }

    /// What that text says; nothing if it has errors.
    pub(super) fn saved_design(&self) -> Option<&Arc<Design>> {
        self.saved_design.as_ref()
    }

    pub fn findings(&self) -> &[Finding] {
        &self.editor.reading().findings
    }

    /// All that is wrong or unusual: the findings, and last why the design cannot be solved.
    pub fn problems(&self) -> Vec<Finding> {
        let refusal = self.design.as_ref().and_then(|design| self.solving.failure(design));
        let refusal = refusal.map(|reason| Finding {
            severity: Severity::Error,
            // what is not held lacks a bearing
            key_path: Side::BOTH
                .into_iter()
                .find(|side| reason.starts_with(side.name()))
                .map_or(KeyPath::root(), |side| KeyPath::root().key(side.name()).key("bearing")),
            span: None,
            message: format!("cannot be solved: {reason}"),
            hint: None,
        });
        self.findings().iter().cloned().chain(refusal).collect()
    }

    /// Problems in the words of the tables, with the key path behind.
    pub fn sentences(&self, problems: &[Finding]) -> Vec<String> {
        let labels = self.editor.labels(problems.iter().map(|one| &one.key_path));
        let sentence = |(finding, label): (&Finding, String)| {
            let hint = finding.hint.as_ref().map_or(String::new(), |hint| format!(" ({hint})"));
            let (severity, path) = (finding.severity.word(), finding.shown_path());
            match path.as_str() {
                "" => format!("{severity} {}{hint}", finding.message),
                path if path == label => format!("{severity} {path}: {}{hint}", finding.message),
                path => format!("{severity} {label}: {}{hint} [{path}]", finding.message),
            }
        };
        problems.iter().zip(labels).map(sentence).collect()
    }

    /// Those about a table as a whole, or about keys in it that no table has, as places in the list of findings.
    pub fn findings_of_table(&self, table: &KeyPath) -> Vec<usize> {
        let is_about = |path: &KeyPath| {
            path == table || is_unknown(path) && path.split_last().is_some_and(|(around, _)| around == *table)
        };
        let findings = self.findings().iter().enumerate();
        findings.filter(|(_, finding)| is_about(&finding.key_path)).map(|(at, _)| at).collect()
    }

    /// The worst of what is wrong in a table.
    pub fn worst_in(&self, tab: Tab) -> Option<Severity> {
        let findings = self.findings().iter();
        let here = findings.filter(|finding| Tab::of(&finding.key_path).0 == tab);
        here.map(|finding| finding.severity).min()
    }

    /// How many of these are errors.
    pub fn errors(&self) -> usize {
        self.problems().iter().filter(|finding| finding.severity == Severity::Error).count()
    }

    /// `pinion bearings`, `materials`
    pub fn title(&self) -> String {
        let tab = self.tab.title();
        if self.tab.has_sides() { format!("{} {tab}", self.side.name()) } else { tab.into() }
    }

    pub fn cursor(&self) -> Cursor {
        self.cursors[self.tab as usize][self.side as usize]
    }

    pub fn cursor_mut(&mut self) -> &mut Cursor {
        &mut self.cursors[self.tab as usize][self.side as usize]
    }

    /// The cell under the cursor.
    pub fn cell(&self) -> Option<&Cell> {
        let cursor = self.cursor();
        self.view.cell(cursor.row, cursor.column)
    }

    /// The entry under the cursor of the matrix that lies open.
    pub fn entry(&self) -> Option<&Cell> {
        let Some(Layer::Matrix(entry)) = &self.layer else { return None };
        self.view.matrix_entry(self.cursor().row, (entry.row, entry.column))
    }

    /// What would be typed into now.
    pub fn target(&self) -> Option<&Cell> {
        if matches!(self.layer, Some(Layer::Matrix(_))) { self.entry() } else { self.cell() }
    }

    /// The text has changed: reads the tables again.
    fn take_in_text(&mut self) {
        self.design = self.editor.reading().design.clone().map(Arc::new);
        if self.design.is_some() {
            self.last_design = self.design.clone();
        }
        self.show(self.tab, self.side);
    }

    /// Shows a table.
    pub fn show(&mut self, tab: Tab, side: Side) {
        (self.tab, self.side) = (tab, side);
        self.view = View::new(&self.editor, tab, side);
        self.hold_cursor();
    }

    pub fn say(&mut self, text: impl Into<String>) {
        self.notice = Some(Notice { is_error: false, text: text.into() });
    }

    pub fn warn(&mut self, text: impl Into<String>) {
        self.notice = Some(Notice { is_error: true, text: text.into() });
    }

    /// Makes an edit. Where the cursor goes is left to the caller.
    pub(in crate::tui) fn apply(&mut self, edit: &Edit) -> Result<Applied, EditError> {
        let applied = self.editor.apply(edit)?;
        if applied.changed {
            self.take_in_text();
        }
        Ok(applied)
    }

    /// Makes an edit and says why it cannot be made.
    pub(super) fn make(&mut self, edit: &Edit) -> Option<Applied> {
        self.apply(edit).map_err(|error| self.warn(error.to_string())).ok()
    }

    pub fn undo(&mut self) {
        match self.editor.undo() {
            Some(applied) => self.step_taken("undo", &applied),
            None => self.say("nothing to undo"),
        }
    }

    pub fn redo(&mut self) {
        match self.editor.redo() {
            Some(applied) => self.step_taken("redo", &applied),
            None => self.say("nothing to redo"),
        }
    }

    fn step_taken(&mut self, what: &str, Applied { name, focus, .. }: &Applied) {
        let entry = match self.layer {
            Some(Layer::Matrix(entry)) => Some((entry, self.cursor().row)),
            _ => None,
        };
        self.take_in_text();
        self.go_to(focus);
        // the matrix stays open while its entries change
        if let Some((entry, row)) = entry.filter(|(_, row)| self.cursor().row == *row && self.on_matrix()) {
            self.cursor_mut().row = row;
            self.layer = Some(Layer::Matrix(entry));
        }
        self.say(format!("{what}: {name}"));
    }

    fn on_matrix(&self) -> bool {
        let cursor = self.cursor();
        self.view.place(cursor.row, cursor.column) == Some(Place::Matrix)
    }

    /// Takes over that a text is in the file now.
    pub fn saved(&mut self, text: String) {
        if self.editor.text() == text {
            self.saved_design.clone_from(&self.design);
        } else {
            self.saved_design = crate::design::read(&text).design.map(Arc::new);
        }
        self.editor.mark_saved(text);
        self.show(self.tab, self.side);
        self.solving.ghost = None;
        self.keep_ghost();
    }

    /// The design lives on as a variant: another file with the same history.
    pub fn become_variant(&mut self, path: PathBuf, text: String) {
        let name = EditName::new("saving as a variant");
        let edit = Edit::ReplaceText { text: text.clone(), name };
        if self.apply(&edit).is_err()
            && let Ok(editor) = Editor::new(text.clone())
        {
            self.editor = editor;
            self.take_in_text();
        }
        self.path = path;
        self.look = Look::default();
        self.is_looking = false;
        self.layer = None;
        // what is under way would come for the other file
        self.solving.pending = None;
        self.saved(text);
    }

    /// Names another parent if it is this one that is named.
    pub fn follow_parent(&mut self, from: &str, to: &str) {
        let path = KeyPath::root().key("parent");
        let named = Document::parse(self.editor.text()).ok().and_then(|document| {
            let item = document.get(&path)?;
            item.as_str().map(str::to_owned)
        });
        if named.as_deref() == Some(from) {
            self.make(&Edit::Set { path, value: Spelled::text(to) });
        }
    }

    /// The solution as it is now, if it is that of the saved state, is what later ones are compared with.
    pub fn keep_ghost(&mut self) {
        if let (Some(saved), Some(solution)) = (&self.saved_design, &self.solving.current)
            && same_mechanics(saved, &solution.design)
        {
            self.solving.ghost = Some(Ghost::of(solution));
        }
    }

    /// Whether the design's solution is neither there nor known to be none.
    pub fn wants_solution(&self) -> bool {
        let Some(design) = &self.design else { return false };
        let solved = self.solving.current.as_ref().is_some_and(|solution| same_mechanics(design, &solution.design));
        !solved && self.solving.failure(design).is_none()
    }

    /// Whether the solution that is awaited is that of the design as it is now.
    pub fn is_pending_for_now(&self) -> bool {
        match (&self.solving.pending, &self.design) {
            (Some(pending), Some(design)) => same_mechanics(&pending.design, design),
            _ => false,
        }
    }

    pub fn is_stale(&self) -> bool {
        self.solving.is_stale(self.design.as_deref())
    }
}

/// The text of a place, harmless to show, with what is not written in brackets.
pub fn shown_text(shown: &Shown) -> String {
    match shown {
        Shown::Written(text) if text.is_empty() => "\"\"".into(),
        Shown::Written(text) => printable(text).into_owned(),
        Shown::Default(text) if text.is_empty() => "()".into(),
        Shown::Default(text) => format!("({})", printable(text)),
        Shown::Derived(text) => format!("= {text}"),
        Shown::Nothing => "-".into(),
    }
}
