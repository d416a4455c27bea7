//! Following a key path through a parsed file.

use std::ops::Range;

use toml::de::{DeTable, DeValue};

use super::Value;
use crate::design::key_path::{KeyPath, Step};
use crate::design::schema::{Kind, Presence, ROOT, Table, Written};

/// The place in the text that a key path leads to, or that of the nearest table around it. Names are those written, or those
/// that follow from the place.
pub(crate) fn locate(root: &DeTable<'_>, path: &KeyPath) -> Range<usize> {
    let mut value: Option<&Value<'_>> = None;
    let mut schema = Some(ROOT);
    for step in path.steps() {
        let found = match (step, value.map(toml::Spanned::get_ref)) {
            (Step::Key(key), None) => root.get(key.as_str()),
            (Step::Key(key), Some(DeValue::Table(table))) => table.get(key.as_str()),
            (Step::Place(place), Some(DeValue::Array(entries))) => entries.get(*place),
            (Step::Name(name), Some(DeValue::Array(entries))) => {
                entries.iter().enumerate().find(|(place, entry)| is_named(entry, *place, name, schema)).map(|(_, e)| e)
            }
            _ => None,
        };
        let Some(found) = found else { break };
        schema = below(schema, step);
        value = Some(found);
    }
    value.map_or(0..0, toml::Spanned::span)
}

/// The schema after a step; entries of a list have that of the list.
fn below(schema: Option<&'static Table>, step: &Step) -> Option<&'static Table> {
    let Step::Key(key) = step else { return schema };
    match schema?.field(key)?.kind {
        Kind::Table(table) | Kind::Tables(table, _) => Some(table),
        _ => None,
    }
}

fn is_named(entry: &Value<'_>, place: usize, name: &str, schema: Option<&Table>) -> bool {
    let written = entry.get_ref().as_table().and_then(|table| table.get("name"));
    if let Some(written) = written {
        return written.get_ref().as_str() == Some(name);
    }
    let default = schema.and_then(|schema| schema.field("name")).map(|field| field.presence);
    match default {
        Some(Presence::Default(Written::ByPlace(prefix))) => {
            name.strip_prefix(prefix).is_some_and(|number| number == (place + 1).to_string())
        }
        _ => false,
    }
}
