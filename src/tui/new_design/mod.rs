//! The form of a new design: what was typed, what follows from it, and what cannot be.
//!
//! ```text
//! typed texts ─> Wishes ─> Proposal ─> text of the file, and a design for the picture
//! ```

mod keys;

use std::collections::BTreeMap;

use super::app::Scroll;
use super::text_field::TextField;
use crate::design::new::{Answer, Field, Proposal, Refusal, TypicalBearing, Value, Wishes, shown};
use crate::design::{Design, read};

/// A line of the form.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Row {
    /// The file's name
    Name,
    Field(Field),
}

/// The form. It is kept while the program runs, so that it can be left and opened again.
#[derive(Debug, Default)]
pub struct NewDesign {
    pub name: TextField,
    /// A name that is free, for where none is typed
    pub free_name: String,
    typed: BTreeMap<Field, TextField>,
    pub cursor: usize,
    pub scroll: Scroll,
    wishes: Wishes,
    /// What is typed and cannot be
    refusals: Vec<Refusal>,
    /// The latest that could be, with its design
    pub proposal: Option<(Proposal, Box<Design>)>,
    /// What the file system had against it
    pub refused: Option<String>,
    /// It is being written
    pub pending: bool,
}

impl NewDesign {
    /// The name and the questions that the kind of pair has.
    pub fn rows(&self) -> Vec<Row> {
        let kind = self.wishes.kind();
        let fields = Field::ALL.into_iter().filter(|field| field.belongs_to(kind)).map(Row::Field);
        std::iter::once(Row::Name).chain(fields).collect()
    }

    pub fn row(&self) -> Row {
        self.rows().get(self.cursor).copied().unwrap_or(Row::Name)
    }

    /// What is typed into a line; nothing where it is left to the others.
    pub fn typed(&self, row: Row) -> Option<&TextField> {
        let field = match row {
            Row::Name => Some(&self.name),
            Row::Field(field) => self.typed.get(&field),
        };
        field.filter(|field| !field.text().trim().is_empty())
    }

    /// What holds where nothing is typed.
    pub fn follows(&self, row: Row) -> Option<String> {
        match row {
            Row::Name => Some(self.free_name.clone()),
            Row::Field(field) => {
                let (proposal, _) = self.proposal.as_ref()?;
                proposal.answers().get(&field).map(|value| shown(field, value))
            }
        }
    }

    /// What is wrong with a line.
    pub fn error(&self, row: Row) -> Option<&str> {
        match row {
            Row::Name => self.refused.as_deref(),
            Row::Field(field) => {
                self.refusals.iter().find(|refusal| refusal.field == field).map(|refusal| refusal.message.as_str())
            }
        }
    }

    /// The first line with something wrong.
    fn first_error(&self) -> Option<usize> {
        self.rows().iter().position(|row| self.error(*row).is_some())
    }

    /// The words that a line may hold; nothing where a text or a number is typed.
    pub fn words(row: Row) -> Option<Vec<String>> {
        let Row::Field(field) = row else { return None };
        match field.answer() {
            Answer::Word(words) => Some(words.iter().map(ToString::to_string).collect()),
            Answer::Bearing => Some(TypicalBearing::all().map(|bearing| bearing.name()).collect()),
            Answer::Whole(..) | Answer::Number(..) => None,
        }
    }

    /// The word so many places further on, or the next one with that first letter.
    fn cycle(&mut self, by: isize, letter: Option<char>) {
        let row = self.row();
        let (Row::Field(field), Some(words)) = (row, Self::words(row)) else { return };
        let now = self.typed(row).map(|field| field.text().to_owned()).or_else(|| self.follows(row));
        let at = words.iter().position(|word| Some(word) == now.as_ref()).unwrap_or(0);
        let count = words.len().cast_signed();
        let next = |steps: isize| (at.cast_signed() + steps).rem_euclid(count).cast_unsigned();
        let found = match letter {
            // another kind of bearing has the same bore
            Some(letter) if field.answer() == Answer::Bearing => {
                let bore = words[at].rsplit('-').next().unwrap_or_default();
                words.iter().position(|word| word.starts_with(letter) && word.rsplit('-').next() == Some(bore))
            }
            Some(letter) => (1..=count).map(next).find(|&at| words[at].starts_with(letter)),
            None => Some(next(by)),
        };
        if let Some(at) = found {
            self.typed.insert(field, TextField::new(words[at].clone()));
            self.refresh();
        }
    }

    /// Leaves a line to the others.
    fn clear(&mut self) {
        if let Row::Field(field) = self.row() {
            self.typed.remove(&field);
        }
        self.refresh();
    }

    fn edit(&mut self, edit: impl FnOnce(&mut TextField)) {
        match self.row() {
            Row::Name => edit(&mut self.name),
            Row::Field(field) => edit(self.typed.entry(field).or_default()),
        }
        self.refresh();
    }

    /// Works out what follows from what is typed.
    fn refresh(&mut self) {
        self.refused = None;
        self.refusals.clear();
        self.wishes = Wishes::default();
        for field in Field::ALL {
            let Some(text) = self.typed.get(&field).filter(|_| field.belongs_to(self.wishes.kind())) else { continue };
            if let Err(refusal) = self.wishes.answer(field, text.text()) {
                self.refusals.push(refusal);
            }
        }
        match Proposal::new(&self.wishes) {
            Ok(proposal) => match read(&proposal.text(&proposal.title())).design {
                Some(design) => self.proposal = Some((proposal, Box::new(design))),
                None => self.refusals.push(Refusal {
                    field: Field::Kind,
                    message: "these answers together make no design that can be read".into(),
                }),
            },
            Err(refusal) => self.refusals.push(refusal),
        }
        self.cursor = self.cursor.min(self.rows().len().saturating_sub(1));
    }

    /// The file's text, if nothing is wrong.
    fn text(&self) -> Option<String> {
        let (proposal, _) = self.proposal.as_ref().filter(|_| self.refusals.is_empty())?;
        Some(proposal.text(&proposal.title()))
    }

    /// Whether an answer is refused, so that what follows is still that of the answers before.
    pub fn is_stale(&self) -> bool {
        !self.refusals.is_empty()
    }

    /// Sizes that follow, for reading.
    pub fn facts(&self) -> Vec<(&'static str, String)> {
        self.proposal.as_ref().map_or_else(Vec::new, |(proposal, _)| proposal.facts())
    }

    /// Whether the answer of a line was typed and is shown as it was.
    pub fn is_asked(&self, row: Row) -> bool {
        self.typed(row).is_some()
    }

    /// The answer that holds for a line, as it is shown.
    pub fn value(&self, row: Row) -> String {
        let with_unit = |typed: &TextField| match row {
            Row::Field(field) => match self.wishes.number(field) {
                Some(value) => shown(field, &Value::Number(value)),
                None => typed.text().trim().to_owned(),
            },
            Row::Name => typed.text().trim().to_owned(),
        };
        self.typed(row).map(with_unit).or_else(|| self.follows(row)).unwrap_or_default()
    }
}
