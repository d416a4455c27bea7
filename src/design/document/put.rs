//! Writing a value: in place of the old one, or as a new key, in a table that is made where there is none.

use super::items::Items;
use super::splice::Splice;
use super::statement::{Kind, Statement, start};
use super::view::{Spot, View};
use super::{EditError, order, toml_key};
use crate::design::KeyPath;
use crate::design::key_path::Step;

/// Replaces the value at the path, or adds it.
pub(super) fn put(view: &View<'_>, path: &KeyPath, value: &str) -> Result<Vec<Splice>, EditError> {
    match view.find(path) {
        Spot::Inline(span) => return Ok(vec![Splice::new(span, value)]),
        Spot::Missing => {}
        _ => return Err(EditError::NoValue(path.clone())),
    }
    if let Some(row) = missing_row(view, path) {
        return Err(EditError::NotThere(row));
    }
    match path.split_last() {
        Some((table, Step::Key(key))) => {
            let key = NewKey { name: key, line: format!("{} = {value}", toml_key(key)) };
            add(view, &table, &key).ok_or_else(|| EditError::NoPlace(path.clone()))
        }
        _ => Err(EditError::NotThere(path.clone())),
    }
}

/// The first entry of a list on the way that is not there: those are not made.
fn missing_row(view: &View<'_>, path: &KeyPath) -> Option<KeyPath> {
    let mut at = KeyPath::root();
    for step in path.steps() {
        at = at.with(step.clone());
        if !matches!(step, Step::Key(_)) && view.tree.at(&at).is_none() {
            return Some(at);
        }
    }
    None
}

/// A key to add.
struct NewKey<'a> {
    /// The first key, which decides the place
    name: &'a str,
    /// `key = value`
    line: String,
}

/// Adds a key to a table; nothing where there is no place for it.
fn add(view: &View<'_>, table: &KeyPath, key: &NewKey<'_>) -> Option<Vec<Splice>> {
    match view.find(table) {
        Spot::Root => Some(add_to_section(view, None, table, key)),
        Spot::Header(header) => Some(add_to_section(view, Some(header), table, key)),
        Spot::Inline(span) => {
            let items = Items::new(view.text, span)?;
            let keys = items.entries.iter().map(|item| item.parts.first().map_or("", |part| &part.name));
            let keys: Vec<&str> = keys.collect();
            let place = match behind(table, key.name, &keys) {
                Behind::Nothing => 0,
                Behind::Key(before) => before + 1,
                Behind::All => keys.len(),
            };
            Some(items.insert(place, &key.line))
        }
        Spot::Dotted => add_dotted(view, table, key),
        Spot::Implied => Some(add_header(view, table, key)),
        Spot::Missing => add_table(view, table, key),
        Spot::InlineDotted | Spot::Rows => None,
    }
}

/// What a new key of a table goes behind.
enum Behind {
    /// It comes first
    Nothing,
    /// The last one of those that come before it in the schema
    Key(usize),
    /// The schema does not know it
    All,
}

fn behind(table: &KeyPath, key: &str, keys: &[&str]) -> Behind {
    let schema = order::table(table);
    let place = order::of_key(schema, key);
    let before = |(_, other): &(usize, &&str)| order::of_key(schema, other) < place;
    let before = keys.iter().enumerate().filter(before).max_by_key(|(i, other)| (order::of_key(schema, other), *i));
    match before {
        _ if place == order::UNKNOWN => Behind::All,
        Some((before, _)) => Behind::Key(before),
        // the number of the format stays at the top of the file
        None if table.steps().is_empty() => Behind::All,
        None => Behind::Nothing,
    }
}

/// A line behind the others of the section.
fn add_to_section(view: &View<'_>, header: Option<usize>, table: &KeyPath, key: &NewKey<'_>) -> Vec<Splice> {
    let steps = table.steps().len();
    let line_break = view.line_break();
    let next = view.statements.iter().skip(header.map_or(0, |header| header + 1)).position(Statement::is_header);
    let first = header.map_or(0, |header| header + 1);
    let end = next.map_or(view.statements.len(), |next| first + next);
    let pairs: Vec<(usize, &str)> = view.statements[..end]
        .iter()
        .enumerate()
        .skip(first)
        .filter(|(_, statement)| statement.is_pair())
        .map(|(i, statement)| (i, key_of(statement.address.steps().get(steps))))
        .collect();
    let keys: Vec<&str> = pairs.iter().map(|(_, key)| *key).collect();
    let anchor = match behind(table, key.name, &keys) {
        Behind::Nothing => None,
        Behind::Key(before) => Some(pairs[before].0),
        Behind::All => pairs.last().map(|(last, _)| *last),
    };
    let Some(above) = anchor.or(header) else {
        let header = view.statements.iter().position(Statement::is_header);
        let rest = if header.is_some_and(|header| view.lead(header) == 0) { line_break } else { "" };
        return vec![Splice::insert(start(view.text), format!("{}{line_break}{rest}", key.line))];
    };
    let beside = anchor.or(pairs.first().map(|(first, _)| *first)).unwrap_or(above);
    let line = format!("{line_break}{}{}", view.indent(beside), key.line);
    vec![Splice::insert(view.statements[above].lines.end, line)]
}

fn key_of(step: Option<&Step>) -> &str {
    if let Some(Step::Key(key)) = step { key } else { "" }
}

/// A line with the dots of the others.
fn add_dotted(view: &View<'_>, table: &KeyPath, key: &NewKey<'_>) -> Option<Vec<Splice>> {
    let steps = table.steps().len();
    let dotted = view.statements.iter().enumerate().filter_map(|(i, statement)| match &statement.kind {
        Kind::Pair { parts, above, .. } if statement.address.starts_with(table) && *above < steps => {
            Some((i, &parts[..steps - above], key_of(statement.address.steps().get(steps))))
        }
        _ => None,
    });
    let dotted: Vec<_> = dotted.collect();
    let keys: Vec<&str> = dotted.iter().map(|(_, _, key)| *key).collect();
    let before = match behind(table, key.name, &keys) {
        Behind::Key(before) => before,
        Behind::Nothing | Behind::All => keys.len().checked_sub(1)?,
    };
    let (anchor, prefix, _) = dotted[before];
    let prefix = &view.text[prefix.first()?.span.start..prefix.last()?.span.end];
    let line = format!("{}{}{prefix}.{}", view.line_break(), view.indent(anchor), key.line);
    Some(vec![Splice::insert(view.statements[anchor].lines.end, line)])
}

/// A table that is not there, written like the one around it.
fn add_table(view: &View<'_>, table: &KeyPath, key: &NewKey<'_>) -> Option<Vec<Splice>> {
    let (around, Step::Key(name)) = table.split_last()? else { return None };
    let written = toml_key(name);
    let in_row = table.steps().iter().any(|step| !matches!(step, Step::Key(_)));
    match view.find(&around) {
        Spot::Dotted => add(view, &around, &NewKey { name, line: format!("{written}.{}", key.line) }),
        Spot::Inline(_) => add(view, &around, &NewKey { name, line: format!("{written} = {{ {} }}", key.line) }),
        Spot::Header(_) if in_row => {
            add(view, &around, &NewKey { name, line: format!("{written} = {{ {} }}", key.line) })
        }
        Spot::Missing if !is_free(view, &around) => {
            add(view, &around, &NewKey { name, line: format!("{written} = {{ {} }}", key.line) })
        }
        Spot::Root | Spot::Header(_) | Spot::Implied | Spot::Missing if !in_row => Some(add_header(view, table, key)),
        _ => None,
    }
}

/// Could a table with a header be below this one?
fn is_free(view: &View<'_>, table: &KeyPath) -> bool {
    match view.find(table) {
        Spot::Missing => table.split_last().is_some_and(|(around, _)| is_free(view, &around)),
        Spot::Root | Spot::Header(_) | Spot::Implied => true,
        _ => false,
    }
}

/// A `[table]` behind the tables that come before it in the schema.
fn add_header(view: &View<'_>, table: &KeyPath, key: &NewKey<'_>) -> Vec<Splice> {
    let line_break = view.line_break();
    let header: Vec<String> = table.steps().iter().map(|step| toml_key(key_of(Some(step)))).collect();
    let block = format!("[{}]{line_break}{}", header.join("."), key.line);
    vec![add_section(view, table, &block)]
}

/// A block with a header behind the sections that come before it in the schema.
pub(super) fn add_section(view: &View<'_>, table: &KeyPath, block: &str) -> Splice {
    let line_break = view.line_break();
    let space = if view.is_airy() { line_break } else { "" };
    let place = order::of_table(table);
    let comes_before = |statement: &Statement| statement.is_header() && order::of_table(&statement.address) <= place;
    let header = view.statements.iter().rposition(comes_before);
    // up to the next header of any table
    let section = view.section(header, &KeyPath::root());
    let end = view.content(&section);
    if end == section.start {
        let rest = if view.text.len() > start(view.text) { space } else { "" };
        return Splice::insert(start(view.text), format!("{block}{line_break}{rest}"));
    }
    let at = view.bytes(section.start..end).end;
    Splice::insert(at, format!("{line_break}{space}{block}"))
}
