//! What somebody wants of a new design, as far as it was said.

use std::collections::BTreeMap;

use super::bearings::TypicalBearing;
use super::field::{Answer, Field};
use crate::design::PairKind;
use crate::number::significant;
use crate::text::excerpt;
use crate::units::{Quantity, parse};

/// An answer.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// In SI units; teeth as they are
    Number(f64),
    Word(String),
}

/// Answers so far. Everything else follows from them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Wishes {
    values: BTreeMap<Field, Value>,
}

/// Why there is no such design.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct Refusal {
    pub field: Field,
    /// A sentence that names the limit
    pub message: String,
}

impl Refusal {
    pub(super) fn new(field: Field, message: impl Into<String>) -> Self {
        Self { field, message: message.into() }
    }
}

impl Wishes {
    pub fn is_given(&self, field: Field) -> bool {
        self.values.contains_key(&field)
    }

    /// In SI units.
    pub fn number(&self, field: Field) -> Option<f64> {
        match self.values.get(&field) {
            Some(Value::Number(value)) => Some(*value),
            _ => None,
        }
    }

    pub fn word(&self, field: Field) -> Option<&str> {
        match self.values.get(&field) {
            Some(Value::Word(word)) => Some(word),
            _ => None,
        }
    }

    /// Of the pair; spiral bevel where nothing else was asked for.
    pub fn kind(&self) -> PairKind {
        match self.word(Field::Kind) {
            Some("straight-bevel") => PairKind::StraightBevel,
            Some("hypoid") => PairKind::Hypoid,
            Some("spur") => PairKind::Spur,
            Some("helical") => PairKind::Helical,
            _ => PairKind::SpiralBevel,
        }
    }

    /// Leaves the answer to what follows from the others.
    pub fn clear(&mut self, field: Field) {
        self.values.remove(&field);
    }

    /// Takes an answer as it is typed: a number with or without a unit, or a word. Nothing leaves it to the others.
    ///
    /// # Errors
    ///
    /// [`Refusal`] with what is wanted; the answer is as before then.
    pub fn answer(&mut self, field: Field, text: &str) -> Result<(), Refusal> {
        let text = text.trim();
        if text.is_empty() {
            self.clear(field);
            return Ok(());
        }
        let refused = |message: String| Refusal::new(field, message);
        let value = match field.answer() {
            Answer::Word(words) => {
                if !words.contains(&text) {
                    return Err(refused(format!("`{}` is none of {}", excerpt(text, 40), words.join(", "))));
                }
                Value::Word(text.into())
            }
            Answer::Bearing => {
                let named = TypicalBearing::named(text).ok_or_else(|| {
                    let example = "for example tapered-35 (bevelscope new --list-bearings)";
                    refused(format!("`{}` is no bearing of the list; {example}", excerpt(text, 40)))
                })?;
                Value::Word(named.name())
            }
            Answer::Whole(low, high) => {
                let wanted = || refused(format!("a whole number from {low} to {high} is wanted"));
                let number: u32 = text.parse().map_err(|_| wanted())?;
                if !(low..=high).contains(&number) {
                    return Err(wanted());
                }
                Value::Number(f64::from(number))
            }
            Answer::Number(quantity, low, high) => {
                let typed = parse(text, quantity).map_err(|error| refused(error.to_string()))?;
                if !(low..=high).contains(&typed.value) {
                    let [low, high] = [low, high].map(plain);
                    return Err(refused(format!("must be from {low} to {high} {}", quantity.unit())));
                }
                Value::Number(quantity.to_si(typed.value))
            }
        };
        self.values.insert(field, value);
        Ok(())
    }
}

/// A value as people read it, with its unit.
pub fn shown(field: Field, value: &Value) -> String {
    match (value, field.answer()) {
        (Value::Word(word), _) => word.clone(),
        (Value::Number(value), Answer::Number(quantity, ..)) => {
            format!("{} {}", plain(in_files_unit(*value, quantity)), quantity.unit())
        }
        (Value::Number(value), _) => plain(*value),
    }
}

/// From SI to the unit of design files.
pub(super) fn in_files_unit(value: f64, quantity: Quantity) -> f64 {
    value / quantity.to_si(1.0)
}

/// At most five significant digits, without zeros at the end.
fn plain(value: f64) -> String {
    let text = significant(value, 5);
    if text.contains('.') && !text.contains('e') {
        text.trim_end_matches('0').trim_end_matches('.').into()
    } else {
        text
    }
}
