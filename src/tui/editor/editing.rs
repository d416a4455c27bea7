//! One design that is being edited: its text, where the cursor is, what lies over the table.

use std::path::PathBuf;
use std::sync::Arc;

use super::form::Form;
use super::line::Line;
use super::solving::{Ghost, Solving, same_mechanics};
use super::view::{Place, Tab, View};
use crate::design::grid::{Cell, CellKind, Shape, Shown};
use crate::design::{Applied, Design, Edit, EditError, EditName, Editor, Finding, KeyPath, Side, Towards};
use crate::text::printable;
use crate::tui::app::Scroll;
use crate::tui::keymap::Mode;

/// A design with its edits, kept while the program runs.
#[derive(Debug)]
pub struct Editing {
    pub path: PathBuf,
    pub editor: Editor,
    /// The text that is in the file, as far as is known.
    saved: String,
    saved_design: Option<Arc<Design>>,
    /// What the text says; nothing while it has errors.
    pub design: Option<Arc<Design>>,
    /// The last one without errors.
    pub last_design: Option<Arc<Design>>,
    pub tab: Tab,
    pub side: Side,
    cursors: [[Cursor; 2]; 8],
    pub view: View,
    pub input: Option<Input>,
    pub layer: Option<Layer>,
    pub solving: Solving,
    pub notice: Option<Notice>,
    /// A text is on its way to the file.
    pub is_saving: bool,
    /// Where to look for each edit that can be undone, and redone.
    done: Vec<KeyPath>,
    undone: Vec<KeyPath>,
}

/// Where one is in a table, and what of it is in sight.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Cursor {
    pub row: usize,
    pub column: usize,
    /// The first line and the first column in sight, known after the first frame
    pub top: usize,
    pub left: usize,
    /// Rows in sight
    pub height: usize,
}

/// A value while it is typed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Input {
    pub target: Target,
    pub line: Line,
    before: String,
    /// Why it was not taken.
    pub error: Option<String>,
}

/// What is typed into.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Target {
    /// The cell under the cursor
    Cell,
    /// The entry of the matrix under the cursor
    Entry,
    /// The name of the material under the cursor
    MaterialName,
    /// The name of a material that is not there yet
    NewMaterial,
}

/// What lies over the table and takes the keys.
#[derive(Debug)]
pub enum Layer {
    Choice(Choice),
    Matrix(Entry),
    Findings(List),
    Form(Form),
}

/// The entry of a matrix that the cursor is on.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Entry {
    pub row: usize,
    pub column: usize,
}

/// The words that a cell may hold.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Choice {
    pub words: Vec<&'static str>,
    /// Those that are ticked, where there may be several
    pub ticked: Option<Vec<bool>>,
    pub cursor: usize,
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
            saved: editor.text().to_owned(),
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
            done: Vec::new(),
            undone: Vec::new(),
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
        self.editor.text() != self.saved
    }

    /// The text that the file had when it was read or written last.
    pub fn saved_text(&self) -> &str {
        &self.saved
    }

    pub fn findings(&self) -> &[Finding] {
        &self.editor.reading().findings
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

    /// Keeps the cursor on a place that there is.
    fn hold_cursor(&mut self) {
        let Cursor { row, column, .. } = self.cursor();
        let row = row.min(self.view.rows.len().saturating_sub(1));
        let places = self.view.rows.get(row).map_or(0, |row| row.places.len());
        let free = (0..places).filter(|&at| self.view.place(row, at).is_some());
        let column = free.min_by_key(|&at| at.abs_diff(column)).unwrap_or(0);
        let cursor = self.cursor_mut();
        (cursor.row, cursor.column) = (row, column);
    }

    pub fn move_rows(&mut self, by: isize) {
        let last = self.view.rows.len().saturating_sub(1);
        let cursor = self.cursor_mut();
        cursor.row = cursor.row.saturating_add_signed(by).min(last);
        self.hold_cursor();
    }

    /// A page; one row stays in sight.
    pub fn page(&self) -> isize {
        self.cursor().height.saturating_sub(1).max(1).cast_signed()
    }

    /// To the next place of the row that the row has, if there is one.
    pub fn move_columns(&mut self, by: isize) -> bool {
        let Cursor { row, column, .. } = self.cursor();
        let places = self.view.rows.get(row).map_or(0, |row| row.places.len());
        let is_there = |at: &usize| self.view.place(row, *at).is_some();
        let next =
            if by < 0 { (0..column.min(places)).rev().find(is_there) } else { (column + 1..places).find(is_there) };
        if let Some(next) = next {
            self.cursor_mut().column = next;
        }
        next.is_some()
    }

    pub fn move_to_end(&mut self, last: bool) {
        self.cursor_mut().column = if last { usize::MAX } else { 0 };
        self.hold_cursor();
    }

    /// To the next cell; after the last of a row to the first of the next row.
    pub fn next_cell(&mut self, by: isize) {
        if self.move_columns(by) {
            return;
        }
        let row = self.cursor().row;
        self.move_rows(by);
        if self.cursor().row != row {
            self.move_to_end(by < 0);
        }
    }

    /// Shows the value or the row of a key path with the cursor on it.
    pub fn go_to(&mut self, path: &KeyPath) {
        let (tab, side) = Tab::of(path);
        self.layer = None;
        self.show(tab, side.unwrap_or(self.side));
        if let Some((row, column)) = self.view.find(path) {
            let cursor = self.cursor_mut();
            cursor.row = row;
            cursor.column = column.unwrap_or(cursor.column);
        }
        self.hold_cursor();
    }

    pub fn say(&mut self, text: impl Into<String>) {
        self.notice = Some(Notice { is_error: false, text: text.into() });
    }

    pub fn warn(&mut self, text: impl Into<String>) {
        self.notice = Some(Notice { is_error: true, text: text.into() });
    }

    /// Makes an edit. Where the cursor goes is left to the caller.
    fn apply(&mut self, edit: &Edit) -> Result<Applied, String> {
        let applied = self.editor.apply(edit).map_err(|error| error.to_string())?;
        if applied.changed {
            self.done.push(applied.focus.clone());
            self.undone.clear();
            self.take_in_text();
        }
        Ok(applied)
    }

    /// Makes an edit and says why it cannot be made.
    fn make(&mut self, edit: &Edit) -> Option<Applied> {
        self.apply(edit).map_err(|error| self.warn(error)).ok()
    }

    pub fn undo(&mut self) {
        let Some(name) = self.editor.undo() else { return self.say("nothing to undo") };
        let focus = self.done.pop();
        self.step_taken("undo", &name, focus.clone());
        self.undone.extend(focus);
    }

    pub fn redo(&mut self) {
        let Some(name) = self.editor.redo() else { return self.say("nothing to redo") };
        let focus = self.undone.pop();
        self.step_taken("redo", &name, focus.clone());
        self.done.extend(focus);
    }

    fn step_taken(&mut self, what: &str, name: &EditName, focus: Option<KeyPath>) {
        let entry = match self.layer {
            Some(Layer::Matrix(entry)) => Some((entry, self.cursor().row)),
            _ => None,
        };
        self.take_in_text();
        if let Some(focus) = focus {
            self.go_to(&focus);
        }
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

    /// Opens what the cell under the cursor is edited with; `replace` drops its value.
    pub fn edit_cell(&mut self, replace: bool) {
        let cursor = self.cursor();
        if matches!(self.layer, Some(Layer::Matrix(_))) {
            if let Some(cell) = self.entry() {
                self.input = Some(Input::new(Target::Entry, cell.shown.text(), replace));
            }
            return;
        }
        match self.view.place(cursor.row, cursor.column) {
            Some(Place::Matrix) => self.layer = Some(Layer::Matrix(Entry::default())),
            Some(Place::Name) => {
                let name = self.view.row(cursor.row).map_or("", |row| &row.label).to_owned();
                self.input = Some(Input::new(Target::MaterialName, &name, replace));
            }
            Some(Place::Cell(_)) => {
                let Some(cell) = self.cell() else { return };
                match cell.kind {
                    CellKind::Choice(_) | CellKind::Model(_) => {
                        self.layer = Some(Layer::Choice(Choice::one(cell.kind.words(), cell.shown.text())));
                    }
                    CellKind::Flags(_) => {
                        self.layer = Some(Layer::Choice(Choice::several(cell.kind.words(), cell.shown.text())));
                    }
                    _ => self.input = Some(Input::new(Target::Cell, cell.shown.text(), replace)),
                }
            }
            None => self.say(if self.view.rows.is_empty() { "no row: a adds one" } else { "nothing to edit here" }),
        }
    }

    /// Begins to type in place of the value, if it is a number.
    pub fn type_number(&mut self, letter: char) {
        let is_number = self.target().is_some_and(|cell| {
            matches!(
                cell.kind,
                CellKind::Number(..) | CellKind::Whole(..) | CellKind::VectorEntry(_) | CellKind::MatrixEntry(..)
            )
        });
        if is_number {
            self.edit_cell(true);
            if let Some(input) = &mut self.input {
                input.line.insert(letter.encode_utf8(&mut [0; 4]));
            }
        }
    }

    /// The next word of a cell that may hold one of several; the list of one that may hold many.
    pub fn cycle_cell(&mut self) {
        let Some(cell) = self.cell() else { return };
        match cell.kind {
            CellKind::Choice(_) | CellKind::Model(_) => {
                let words = cell.kind.words();
                let at = words.iter().position(|word| *word == cell.shown.text()).map_or(0, |at| at + 1);
                if let Some(word) = words.get(at % words.len().max(1)).copied() {
                    self.write(word);
                }
            }
            CellKind::Flags(_) => self.edit_cell(false),
            _ => self.say("this cell is typed into: Enter"),
        }
    }

    /// Takes what is chosen in the list.
    pub fn choose(&mut self) {
        let Some(Layer::Choice(choice)) = self.layer.take() else { return };
        let text = choice.text();
        if !text.is_empty() {
            self.write(&text);
        } else if self.cell().is_some_and(|cell| cell.required) {
            self.layer = Some(Layer::Choice(choice));
            self.warn("at least one is wanted: Space ticks");
        } else {
            self.clear_cell();
        }
    }

    fn write(&mut self, text: &str) {
        let edit = self.cell().map(|cell| Edit::from_typed(cell, text));
        match edit {
            Some(Ok(edit)) => drop(self.make(&edit)),
            Some(Err(error)) => self.warn(error),
            None => {}
        }
    }

    pub fn clear_cell(&mut self) {
        let Some(cell) = self.target() else { return };
        if cell.required && !matches!(cell.kind, CellKind::MatrixEntry(..)) {
            return self.warn(format!("{} must be there", printable(&cell.column.label)));
        }
        let typed = if matches!(cell.kind, CellKind::MatrixEntry(..)) { "0.0" } else { "" };
        if !cell.shown.is_written() {
            return self.say("not written: the default holds");
        }
        match Edit::from_typed(cell, typed) {
            Ok(edit) => drop(self.make(&edit)),
            Err(error) => self.warn(error),
        }
    }

    /// Takes what was typed. False keeps the input open, with the reason.
    pub fn accept(&mut self) -> bool {
        let Some(mut input) = self.input.take() else { return true };
        if input.line.text() == input.before && input.target != Target::NewMaterial {
            return true;
        }
        let result = self.edit_of(&input).and_then(|edit| self.apply(&edit));
        match result {
            Ok(applied) => {
                if input.target == Target::NewMaterial {
                    self.go_to(&applied.focus);
                    self.move_to_end(false);
                } else if input.target == Target::MaterialName
                    && let Some((row, _)) = self.view.find(&applied.focus)
                {
                    self.cursor_mut().row = row;
                    self.hold_cursor();
                }
                true
            }
            Err(error) => {
                input.error = Some(error);
                self.input = Some(input);
                false
            }
        }
    }

    fn edit_of(&self, input: &Input) -> Result<Edit, String> {
        let typed = input.line.text();
        let name = typed.trim();
        let free_name = || match name {
            "" => Err("a name is wanted".to_owned()),
            _ => Ok(name.to_owned()),
        };
        match input.target {
            Target::Cell | Target::Entry => {
                let cell = self.target().ok_or("nothing to edit here")?;
                Edit::from_typed(cell, typed)
            }
            Target::MaterialName => {
                let from = self.view.row(self.cursor().row).map(|row| row.label.clone()).unwrap_or_default();
                Ok(Edit::RenameMaterial { from, to: free_name()? })
            }
            Target::NewMaterial => Ok(Edit::AddMaterial { name: free_name()? }),
        }
    }

    /// Adds a row beside the cursor.
    pub fn add_row(&mut self, after: bool) {
        let row = self.cursor().row;
        let Some(sheet) = self.view.sheet(row) else { return };
        match sheet.shape {
            Shape::List { .. } => {
                let place = if self.view.rows.is_empty() { 0 } else { row + usize::from(after) };
                let edit = Edit::InsertRow { list: sheet.path.clone(), place };
                if let Some(applied) = self.make(&edit) {
                    self.go_to(&applied.focus);
                    self.say(format!("added: {}", applied.name));
                }
            }
            Shape::Named => self.input = Some(Input::new(Target::NewMaterial, "", true)),
            Shape::Single => self.say("this table has no rows to add"),
        }
    }

    /// Does something to the row under the cursor.
    fn edit_row(&mut self, said: &str, edit: impl FnOnce(KeyPath) -> Edit) {
        let row = self.cursor().row;
        let is_list = matches!(self.view.shape, Shape::List { .. });
        let Some(path) = self.view.row(row).filter(|_| is_list).map(|row| row.path.clone()) else {
            return self.say("no row of a list");
        };
        if let Some(applied) = self.make(&edit(path)).filter(|applied| applied.changed) {
            let column = self.cursor().column;
            self.go_to(&applied.focus);
            self.cursor_mut().column = column;
            self.hold_cursor();
            self.say(format!("{said}: {}", applied.name));
        }
    }

    pub fn duplicate_row(&mut self) {
        self.edit_row("duplicated", |row| Edit::DuplicateRow { row });
    }

    pub fn delete_row(&mut self) {
        if self.view.shape != Shape::Named {
            return self.edit_row("deleted", |row| Edit::DeleteRow { row });
        }
        let Some(name) = self.view.row(self.cursor().row).map(|row| row.label.clone()) else { return };
        if let Some(applied) = self.make(&Edit::RemoveMaterial { name }) {
            self.say(format!("deleted: {}", applied.name));
        }
    }

    pub fn move_row(&mut self, towards: Towards) {
        self.edit_row("moved", |row| Edit::MoveRow { row, towards });
    }

    /// Takes over that a text is in the file now.
    pub fn saved(&mut self, text: String) {
        if self.editor.text() == text {
            self.editor.mark_saved();
            self.saved_design.clone_from(&self.design);
        } else {
            self.saved_design = crate::design::read(&text).design.map(Arc::new);
        }
        self.saved = text;
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
            (self.done, self.undone) = (Vec::new(), Vec::new());
            self.take_in_text();
        }
        self.path = path;
        self.layer = None;
        // what is under way would come for the other file
        self.solving.pending = None;
        self.saved(text);
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

impl Input {
    pub(super) fn new(target: Target, text: &str, replace: bool) -> Self {
        let line = Line::new(if replace { "" } else { text });
        // an empty text that was asked for is typed, not left as it was
        let before = if replace { "\u{0}".into() } else { text.to_owned() };
        Self { target, line, before, error: None }
    }
}

impl Choice {
    fn one(words: Vec<&'static str>, now: &str) -> Self {
        let cursor = words.iter().position(|word| *word == now).unwrap_or(0);
        Self { words, ticked: None, cursor }
    }

    fn several(words: Vec<&'static str>, now: &str) -> Self {
        let ticked = words.iter().map(|word| now.split(',').any(|part| part.trim() == *word)).collect();
        Self { words, ticked: Some(ticked), cursor: 0 }
    }

    pub fn move_by(&mut self, by: isize) {
        self.cursor = self.cursor.saturating_add_signed(by).min(self.words.len().saturating_sub(1));
    }

    /// Ticks the word under the cursor, or not; where one is taken only, goes to the next.
    pub fn tick(&mut self) {
        match &mut self.ticked {
            Some(ticked) => {
                if let Some(tick) = ticked.get_mut(self.cursor) {
                    *tick = !*tick;
                }
            }
            None => self.cursor = (self.cursor + 1) % self.words.len().max(1),
        }
    }

    /// What is taken, as it is typed.
    fn text(&self) -> String {
        match &self.ticked {
            Some(ticked) => {
                let words = self.words.iter().zip(ticked).filter(|(_, ticked)| **ticked).map(|(word, _)| *word);
                words.collect::<Vec<_>>().join(", ")
            }
            None => self.words.get(self.cursor).map_or(String::new(), |word| (*word).to_owned()),
        }
    }
}

impl Entry {
    pub fn move_by(&mut self, rows: isize, columns: isize) {
        self.row = self.row.saturating_add_signed(rows).min(5);
        self.column = self.column.saturating_add_signed(columns).min(5);
    }

    /// To the next entry, row by row.
    pub fn next(&mut self, by: isize) {
        let at = (self.row * 6 + self.column).saturating_add_signed(by).min(35);
        (self.row, self.column) = (at / 6, at % 6);
    }
}

/// The text of a place, harmless to show, with what is not written in brackets.
pub fn shown_text(shown: &Shown) -> String {
    match shown {
        Shown::Written(text) if text.is_empty() => "\"\"".into(),
        Shown::Written(text) => printable(text).into_owned(),
        Shown::Default(text) if text.is_empty() => "()".into(),
        Shown::Default(text) => format!("({})", printable(text)),
        Shown::Nothing => "-".into(),
    }
}
