//! What is typed, chosen or cleared, and how it becomes an edit.

use super::Editing;
use super::editing::Layer;
use super::view::Place;
use crate::design::grid::{Cell, CellKind, Sheet, TypedError};
use crate::design::{Edit, EditError};
use crate::text::printable;
use crate::tui::text_field::TextField;
use crate::units::Quantity;

/// Said of a value that is shown and not written.
pub const FROM_GEOMETRY: &str = "From the gear data in [mesh.geometry]: change those, further down.";

/// A value while it is typed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Input {
    pub target: Target,
    pub line: TextField,
    /// The value as it was; nothing where it was dropped, so that an empty text is typed too.
    before: Option<String>,
    /// Nothing was typed yet: the next letter takes the place of the number.
    pub is_selected: bool,
    /// Why it was not taken.
    pub error: Option<String>,
}

/// Why what was typed is not taken.
#[derive(Debug, thiserror::Error)]
enum NotTaken {
    #[error("a name is wanted")]
    NoName,
    #[error("nothing to edit here")]
    NoCell,
    #[error(transparent)]
    Typed(#[from] TypedError),
    #[error(transparent)]
    Edit(#[from] EditError),
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

impl Editing {
    /// Opens what the cell under the cursor is edited with; `replace` drops its value.
    pub fn edit_cell(&mut self, replace: bool) {
        if self.is_derived() {
            return self.say(FROM_GEOMETRY);
        }
        let cursor = self.cursor();
        if matches!(self.layer, Some(Layer::Matrix(_))) {
            if let Some(cell) = self.entry() {
                self.input = Some(Input::number(Target::Entry, cell.shown.text(), replace));
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
                    CellKind::Number(..) | CellKind::Whole(..) | CellKind::VectorEntry(_) => {
                        self.input = Some(Input::number(Target::Cell, cell.shown.text(), replace));
                    }
                    _ => self.input = Some(Input::new(Target::Cell, cell.shown.text(), replace)),
                }
            }
            None => self.say(if self.view.rows.is_empty() { "no row yet" } else { "nothing to edit here" }),
        }
    }

    /// Whether the value under the cursor is shown and not to be written.
    fn is_derived(&self) -> bool {
        self.target().is_some_and(|cell| cell.shown.is_derived())
    }

    /// Begins to type in place of the value, if it is a number.
    pub fn type_number(&mut self, letter: char) {
        let is_number = self.target().is_some_and(|cell| {
            matches!(
                cell.kind,
                CellKind::Number(..) | CellKind::Whole(..) | CellKind::VectorEntry(_) | CellKind::MatrixEntry(..)
            )
        });
        if !is_number {
            return self.say("no number is typed here");
        }
        self.edit_cell(true);
        if let Some(input) = &mut self.input {
            input.line.insert(letter.encode_utf8(&mut [0; 4]));
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
            _ if cell.column.key == "material" => {
                let names = self.material_names();
                let at = names.iter().position(|name| name == cell.shown.text()).map_or(0, |at| at + 1);
                if let Some(name) = names.get(at % names.len().max(1)) {
                    self.write(name);
                }
            }
            _ => self.say("this cell has no words to choose from: a value is typed into it"),
        }
    }

    /// The materials that a segment can name.
    pub fn material_names(&self) -> Vec<String> {
        self.editor.grid(&Sheet::materials()).rows.into_iter().map(|row| row.label).collect()
    }

    /// Takes what is chosen in the list.
    pub fn choose(&mut self) {
        let Some(Layer::Choice(choice)) = self.layer.take() else { return };
        let text = choice.text();
        if !text.is_empty() {
            self.write(&text);
        } else if self.cell().is_some_and(|cell| cell.required) {
            self.layer = Some(Layer::Choice(choice));
            self.warn("at least one is wanted");
        } else {
            self.clear_cell();
        }
    }

    fn write(&mut self, text: &str) {
        let edit = self.cell().map(|cell| Edit::from_typed(cell, text));
        match edit {
            Some(Ok(edit)) => {
                let before = self.stiffnesses();
                if self.make(&edit).is_some() && matches!(edit, Edit::SetModel { .. }) {
                    match before.saturating_sub(self.stiffnesses()) {
                        0 => {}
                        1 => self.say(format!("{text} has no place for 1 stiffness: it is gone until this is undone")),
                        more => {
                            self.say(format!("{text} has no place for {more} stiffnesses: gone until this is undone"));
                        }
                    }
                }
            }
            Some(Err(error)) => self.warn(error.to_string()),
            None => {}
        }
    }

    /// How many springs and couplings the row under the cursor has.
    fn stiffnesses(&self) -> usize {
        let cells = self.view.row(self.cursor().row).map_or(&[][..], |row| &row.cells);
        let is_spring = |cell: &&Cell| match cell.kind {
            CellKind::MatrixEntry(row, column) => row <= column,
            CellKind::Number(Quantity::Stiffness | Quantity::AngularStiffness, _) => true,
            _ => false,
        };
        let is_there = |cell: &&Cell| {
            cell.shown.is_written() && cell.shown.text().replace('_', "").parse::<f64>().is_ok_and(|value| value != 0.0)
        };
        cells.iter().filter(is_spring).filter(is_there).count()
    }

    pub fn clear_cell(&mut self) {
        if self.is_derived() {
            return self.say(FROM_GEOMETRY);
        }
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
            Err(error) => self.warn(error.to_string()),
        }
    }

    /// Takes what was typed. False keeps the input open, with the reason.
    pub fn accept(&mut self) -> bool {
        let Some(mut input) = self.input.take() else { return true };
        if input.before.as_deref() == Some(input.line.text()) && input.target != Target::NewMaterial {
            return true;
        }
        let result = self.edit_of(&input).and_then(|edit| Ok(self.apply(&edit)?));
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
                input.error = Some(error.to_string());
                self.input = Some(input);
                false
            }
        }
    }

    fn edit_of(&self, input: &Input) -> Result<Edit, NotTaken> {
        let typed = input.line.text();
        let name = typed.trim();
        let free_name = || match name {
            "" => Err(NotTaken::NoName),
            _ => Ok(name.to_owned()),
        };
        match input.target {
            Target::Cell | Target::Entry => {
                let cell = self.target().ok_or(NotTaken::NoCell)?;
                Ok(Edit::from_typed(cell, typed)?)
            }
            Target::MaterialName => {
                let from = self.view.row(self.cursor().row).map(|row| row.label.clone()).unwrap_or_default();
                Ok(Edit::RenameMaterial { from, to: free_name()? })
            }
            Target::NewMaterial => Ok(Edit::AddMaterial { name: free_name()? }),
        }
    }
}

impl Input {
    pub(super) fn new(target: Target, text: &str, replace: bool) -> Self {
        let line = TextField::new(if replace { "" } else { text });
        let before = (!replace).then(|| text.to_owned());
        Self { target, line, before, is_selected: false, error: None }
    }

    /// A number in sight, that the first letter replaces: a unit typed behind it would else be taken for its own.
    fn number(target: Target, text: &str, replace: bool) -> Self {
        Self { is_selected: !replace && !text.is_empty(), ..Self::new(target, text, replace) }
    }

    /// Something is to be typed, or deleted: of what is selected nothing stays.
    pub(super) fn replace_selected(&mut self) {
        if std::mem::take(&mut self.is_selected) {
            self.line = TextField::default();
        }
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
