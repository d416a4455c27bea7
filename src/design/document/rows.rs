//! Lists of tables, with a header for each row or inline: rows come, go and change places.

use std::ops::Range;

use super::items::Items;
use super::splice::Splice;
use super::statement::{Kind, Statement};
use super::take::with_break;
use super::tree::Tree;
use super::view::{Spot, View};
use super::{EditError, put, toml_key};
use crate::design::KeyPath;
use crate::design::key_path::Step;

/// A new row.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum NewRow {
    /// Keys with their values in TOML
    Keys(Vec<(String, String)>),
    /// An entry of a list of values, in TOML
    Entry(String),
    /// A copy of the row at that place, with its comments
    CopyOf(usize),
}

/// Puts a row at a place of a list.
pub(super) fn insert(view: &View<'_>, list: &KeyPath, place: usize, row: &NewRow) -> Result<Vec<Splice>, EditError> {
    let no_place = || EditError::NoPlace(list.clone());
    match view.find(list) {
        Spot::Inline(span) => {
            let items = Items::new(view.text, span).ok_or_else(no_place)?;
            let row = match row {
                NewRow::Keys(keys) => inline(keys),
                NewRow::Entry(value) => value.clone(),
                NewRow::CopyOf(other) => view.text[items.entries.get(*other).ok_or_else(no_place)?.span.clone()].into(),
            };
            Ok(items.insert(place, &row))
        }
        Spot::Rows => {
            let block = match row {
                NewRow::Keys(keys) => block(view, list, keys),
                NewRow::Entry(_) => return Err(no_place()),
                NewRow::CopyOf(other) => copied(view, &list.place(*other)).ok_or_else(no_place)?,
            };
            insert_block(view, list, place, &block).ok_or_else(no_place)
        }
        Spot::Missing => {
            let NewRow::Keys(keys) = row else { return Err(no_place()) };
            if is_inline_here(view, list) {
                return put::put(view, list, &format!("[{}]", inline(keys)));
            }
            Ok(vec![put::add_section(view, list, &block(view, list, keys))])
        }
        _ => Err(no_place()),
    }
}

/// Takes a row out.
pub(super) fn delete(view: &View<'_>, row: &KeyPath) -> Result<Vec<Splice>, EditError> {
    if let Some((items, place)) = view.container(row) {
        return Ok(items.remove(place));
    }
    let block = rows_block(view, row).ok_or_else(|| EditError::NotThere(row.clone()))?;
    Ok(vec![Splice::remove(with_break(view, block))])
}

/// Swaps a row with the one after it.
pub(super) fn swap(view: &View<'_>, list: &KeyPath, place: usize) -> Result<Vec<Splice>, EditError> {
    if let Some((items, _)) = view.container(&list.place(place + 1)) {
        return Ok(items.swap(place));
    }
    let bytes = |place: usize| {
        let block = rows_block(view, &list.place(place)).ok_or_else(|| EditError::NotThere(list.place(place)))?;
        Ok(view.bytes(block))
    };
    let (a, b) = (bytes(place)?, bytes(place + 1)?);
    Ok(vec![Splice::new(a.clone(), &view.text[b.clone()]), Splice::new(b, &view.text[a])])
}

/// The statements of a row with a header, from the comments above it on.
fn rows_block(view: &View<'_>, row: &KeyPath) -> Option<Range<usize>> {
    let header = view.header(row)?;
    Some(view.lead(header)..view.content(&view.section(Some(header), row)))
}

/// The same without the comments above: those are about the first one.
fn copied(view: &View<'_>, row: &KeyPath) -> Option<String> {
    let header = view.header(row)?;
    let content = view.content(&view.section(Some(header), row));
    Some(view.text[view.bytes(header..content)].into())
}

fn insert_block(view: &View<'_>, list: &KeyPath, place: usize, block: &str) -> Option<Vec<Splice>> {
    let line_break = view.line_break();
    // as far from its neighbour as the rows are from each other
    let second = view.header(&list.place(1)).or_else(|| view.header(&list.place(0)));
    let space = if second.is_some_and(|header| view.is_apart(header)) { line_break } else { "" };
    if let Some(before) = place.checked_sub(1) {
        let end = view.bytes(rows_block(view, &list.place(before))?).end;
        return Some(vec![Splice::insert(end, format!("{line_break}{space}{block}"))]);
    }
    let start = view.bytes(rows_block(view, &list.place(0))?).start;
    Some(vec![Splice::insert(start, format!("{block}{line_break}{space}"))])
}

fn inline(keys: &[(String, String)]) -> String {
    let keys: Vec<String> = keys.iter().map(|(key, value)| format!("{} = {value}", toml_key(key))).collect();
    format!("{{ {} }}", keys.join(", "))
}

/// A header and a line for each key, indented like the other rows.
fn block(view: &View<'_>, list: &KeyPath, keys: &[(String, String)]) -> String {
    let path: Vec<String> = list.steps().iter().map(|step| toml_key(step_key(step))).collect();
    let header = view.header(&list.place(0));
    let outer = header.map_or("", |header| view.indent(header));
    let inner = header.and_then(|header| {
        let pair =
            view.statements.get(header + 1..)?.iter().take_while(|s| !s.is_header()).position(Statement::is_pair)?;
        Some(view.indent(header + 1 + pair))
    });
    let inner = inner.unwrap_or_default();
    let line_break = view.line_break();
    let lines = keys.iter().map(|(key, value)| format!("{line_break}{inner}{} = {value}", toml_key(key)));
    format!("{outer}[[{}]]{}", path.join("."), lines.collect::<String>())
}

fn step_key(step: &Step) -> &str {
    if let Step::Key(key) = step { key } else { "" }
}

/// Is the table around it inline or dotted, or are its other lists inline?
fn is_inline_here(view: &View<'_>, list: &KeyPath) -> bool {
    let Some((around, _)) = list.split_last() else { return false };
    if !matches!(view.find(&around), Spot::Root | Spot::Header(_) | Spot::Implied | Spot::Missing) {
        return true;
    }
    view.statements.iter().any(|statement| {
        matches!(statement.kind, Kind::Pair { above, .. } if above == around.steps().len())
            && statement.address.starts_with(&around)
            && is_list_of_tables(view.tree.at(&statement.address))
    })
}

fn is_list_of_tables(tree: Option<&Tree>) -> bool {
    tree.is_some_and(|tree| tree.entries().iter().any(|row| matches!(row, Tree::Table(_))))
}
