//! What is typed into a cell, as an edit.

use super::cell::matrix_quantity;
use super::{Cell, CellKind};
use crate::design::document::Tree;
use crate::design::{Edit, Spelled};
use crate::text::excerpt;
use crate::units::{Quantity, UnitError, parse};

/// Why what was typed cannot be taken. The texts are harmless to show.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TypedError {
    /// The value of this label must be there.
    #[error("{0} cannot be left empty")]
    Empty(String),
    #[error(transparent)]
    Number(#[from] UnitError),
    #[error("a whole number is wanted; this is {0}")]
    NotWhole(String),
    #[error("a list is wanted: [\"a\", \"b\"], or a, b")]
    NoList,
    #[error("a list of texts is wanted: [\"a\", \"b\"], or a, b")]
    NotTexts,
    #[error("one of these is wanted: {}", .0.join(", "))]
    NoWord(Vec<&'static str>),
    #[error("any of these are wanted: {}", .0.join(", "))]
    NoWords(Vec<&'static str>),
}

impl Edit {
    /// What was typed into a cell, as an edit. Nothing typed clears the cell, so that its default holds.
    ///
    /// Limits are not looked at: a value beyond them can be written, and findings say so.
    ///
    /// # Errors
    ///
    /// [`TypedError`] says what can be typed.
    pub fn from_typed(cell: &Cell, typed: &str) -> Result<Self, TypedError> {
        let typed = typed.trim();
        if typed.is_empty() {
            return clear(cell);
        }
        let value = match cell.kind {
            CellKind::Number(quantity, _) | CellKind::VectorEntry(quantity) => number(typed, quantity)?,
            CellKind::MatrixEntry(row, column) => number(typed, matrix_quantity(row, column))?,
            CellKind::Whole(..) => whole(typed)?,
            CellKind::Text | CellKind::Name => Spelled::text(typed),
            CellKind::Texts => texts(typed)?,
            CellKind::Choice(words) => Spelled::text(choose(typed, words)?),
            CellKind::Flags(words) => flags(typed, words)?,
            CellKind::Model(_) => {
                let model = choose(typed, &cell.kind.words())?.to_owned();
                let bearing = cell.path.split_last().map(|(bearing, _)| bearing).unwrap_or_default();
                return Ok(Self::SetModel { bearing, model });
            }
        };
        Ok(Self::Set { path: cell.path.clone(), value })
    }
}

fn clear(cell: &Cell) -> Result<Edit, TypedError> {
    if cell.required {
        return Err(TypedError::Empty(cell.column.label.clone()));
    }
    Ok(Edit::Remove { path: cell.path.clone() })
}

fn number(typed: &str, quantity: Quantity) -> Result<Spelled, TypedError> {
    let typed = parse(typed, quantity)?;
    let no_number = UnitError::NoNumber { unit: quantity.unit(), example: quantity.example() };
    Spelled::parse(&typed.text).ok_or_else(|| no_number.into())
}

fn whole(typed: &str) -> Result<Spelled, TypedError> {
    let wanted = || TypedError::NotWhole(excerpt(typed, 40));
    let number = Spelled::parse(typed).ok_or_else(wanted)?;
    let value = Tree::read_value(number.as_str()).number().ok_or_else(wanted)?;
    if value.fract() == 0.0 { Ok(number) } else { Err(wanted()) }
}

/// `a, b`, or a list as in the file.
fn texts(typed: &str) -> Result<Spelled, TypedError> {
    if typed.starts_with('[') {
        let list = Spelled::parse(typed).ok_or(TypedError::NoList)?;
        let tree = Tree::read_value(list.as_str());
        if tree.entries().iter().any(|entry| entry.text().is_none()) {
            return Err(TypedError::NotTexts);
        }
        return Ok(list);
    }
    Ok(Spelled::texts(typed.split(',').map(str::trim).filter(|text| !text.is_empty())))
}

/// The word, or the only one that begins like that.
fn choose(typed: &str, words: &[&'static str]) -> Result<&'static str, TypedError> {
    let typed = typed.trim_matches('"').to_lowercase();
    if let Some(word) = words.iter().find(|word| **word == typed) {
        return Ok(word);
    }
    let mut alike = words.iter().filter(|word| word.starts_with(&typed));
    match (alike.next(), alike.next()) {
        (Some(word), None) => Ok(word),
        _ => Err(TypedError::NoWord(words.to_vec())),
    }
}

/// `x z`, `xz`, `x, z`, or a list as in the file; in the order of the words.
fn flags(typed: &str, words: &'static [&'static str]) -> Result<Spelled, TypedError> {
    let wanted = || TypedError::NoWords(words.to_vec());
    let plain = typed.replace(['[', ']', '"', '\''], " ");
    let parts: Vec<&str> = plain.split([',', ' ', '+']).filter(|part| !part.is_empty()).collect();
    let is_word = |part: &&str| words.contains(part);
    let letters = || plain.chars().filter(|c| c.is_alphanumeric()).map(|c| c.to_string()).collect::<Vec<_>>();
    let chosen: Vec<String> =
        if parts.iter().all(is_word) { parts.iter().map(ToString::to_string).collect() } else { letters() };
    if chosen.is_empty() || chosen.iter().any(|word| !words.contains(&word.as_str())) {
        return Err(wanted());
    }
    Ok(Spelled::texts(words.iter().copied().filter(|word| chosen.iter().any(|chosen| chosen == word))))
}
