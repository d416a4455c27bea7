//! Numbers as people type them, with or without a unit.

use super::Quantity;

/// A number that was typed, in the unit of design files.
#[derive(Debug, Clone, PartialEq)]
pub struct Typed {
    /// As it goes into a file: exactly as typed where no conversion was needed, else the shortest decimal that is right
    /// to 15 digits.
    pub text: String,
    /// The same as a number, in the file's unit.
    pub value: f64,
}

/// Why what was typed is no number of the quantity.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum UnitError {
    #[error("a number is wanted{}, e.g. {example}", in_unit(.unit))]
    NoNumber { unit: &'static str, example: &'static str },
    #[error("write {suggestion}: the decimal separator is a point")]
    Comma { suggestion: String },
    #[error("{number} is too large for a number")]
    TooLarge { number: String },
    /// `accepted` are the units of the quantity, the file's own first; empty where the quantity has none.
    #[error("unknown unit `{unit}`{}", accepted_units(.accepted))]
    UnknownUnit { unit: String, accepted: Vec<&'static str> },
}

fn in_unit(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" in {unit}") }
}

fn accepted_units(units: &[&str]) -> String {
    if units.is_empty() { ": this is a plain number".into() } else { format!("; accepted: {}", units.join(", ")) }
}

/// Reads a number as people type it, and gives it in the file's unit.
///
/// # Errors
///
/// [`UnitError`] says what is wanted.
pub fn parse(text: &str, quantity: Quantity) -> Result<Typed, UnitError> {
    let value = text.trim().parse().map_err(|_| UnitError::NoNumber { unit: quantity.unit(), example: "1.5e3" })?;
    Ok(Typed { text: text.trim().into(), value })
}
