//! Words for what is written in a file and for what is wanted.

use toml::de::DeValue;

use super::{Value, listed};
use crate::design::schema::{Field, Kind};
use crate::text::excerpt;
use crate::units::Quantity;

/// The value as written in the text, shortened.
pub(super) fn raw(text: &str, value: &Value<'_>) -> String {
    excerpt(text.get(value.span()).unwrap_or_default(), 40)
}

/// What is written: `the text "42"`.
pub(super) fn what(text: &str, value: &Value<'_>) -> String {
    let raw = raw(text, value);
    match value.get_ref() {
        DeValue::String(_) => format!("the text {raw}"),
        DeValue::Integer(_) | DeValue::Float(_) => format!("the number {raw}"),
        DeValue::Boolean(_) => raw,
        DeValue::Datetime(_) => format!("the date {raw}"),
        DeValue::Array(_) => format!("a list, {raw}"),
        DeValue::Table(_) => "a table".into(),
    }
}

/// What a field is, and what it wants: `Length. Write a number in mm, greater than 0 mm.`
pub(super) fn describe(field: &Field) -> String {
    let limit = match field.kind {
        Kind::Number(quantity, limit) => limit.describe(quantity),
        _ => String::new(),
    };
    let comma = if limit.is_empty() { "" } else { ", " };
    format!("{} Write {}{comma}{limit}.", field.doc, wanted(field))
}

/// What may be written: `a number in mm`.
pub(super) fn wanted(field: &Field) -> String {
    match field.kind {
        Kind::Number(quantity, _) => number(quantity),
        Kind::Whole(..) => "a whole number".into(),
        Kind::Text | Kind::Name => "a text in quotes".into(),
        Kind::Texts => "a list of texts in quotes".into(),
        Kind::Word(words) => format!("one of {}", quoted(words)),
        Kind::Words(words) => format!("a list of {}", quoted(words)),
        Kind::Vector(quantity) => format!("three numbers{}, [x, y, z]", in_unit(quantity)),
        Kind::Matrix => "six rows of six numbers".into(),
        Kind::Variant(variants) => {
            let words: Vec<&str> = variants.iter().map(|variant| variant.word).collect();
            format!("one of {}", quoted(&words))
        }
        Kind::Table(_) | Kind::NamedTables(_) => "a table".into(),
        Kind::Tables(..) => "a list of tables".into(),
    }
}

pub(super) fn number(quantity: Quantity) -> String {
    format!("a number{}", in_unit(quantity))
}

fn in_unit(quantity: Quantity) -> String {
    let unit = quantity.unit();
    if unit.is_empty() { String::new() } else { format!(" in {unit}") }
}

pub(super) fn quoted(words: &[&str]) -> String {
    let words: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
    listed(words.iter().map(String::as_str))
}
