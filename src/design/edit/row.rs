//! Rows of lists of tables: new ones with starting values, copies, deletions.

use super::steps::{Steps, row_of};
use crate::design::EditError;
use crate::design::document::{NewRow, Tree};
use crate::design::edit::Spelled;
use crate::design::key_path::{KeyPath, Step};
use crate::design::schema::{Field, Kind, Limit, Presence, Table, Written, target};
use crate::units::Quantity;

const POSITION: &str = "position_mm";
const MASS: &str = "mass_kg";
const LENGTH: &str = "length_mm";
const MODEL: &str = "model";
/// The springs of a new bearing: they carry the shaft.
const CARRYING: [&str; 2] = ["kx_n_per_m", "kz_n_per_m"];

pub(super) fn insert(steps: &mut Steps, list: &KeyPath, place: usize) -> Result<KeyPath, EditError> {
    let tree = steps.tree();
    let count = tree.at(list).map_or(0, |list| list.entries().len());
    let table = table_of_rows(list).filter(|_| place <= count).ok_or_else(|| EditError::NotThere(list.place(place)))?;
    let row = NewRow::Keys(starting(&tree, list, place, table));
    steps.insert_row(list, place, &row)?;
    Ok(list.place(place))
}

/// The table that the rows of a list are; nothing where it is no list of tables.
fn table_of_rows(list: &KeyPath) -> Option<&'static Table> {
    let (around, Step::Key(key)) = list.split_last()? else { return None };
    match target(&around)?.table.field(key)?.kind {
        Kind::Tables(table, _) => Some(table),
        _ => None,
    }
}

pub(super) fn duplicate(steps: &mut Steps, row: &KeyPath) -> Result<KeyPath, EditError> {
    let (list, place) = row_of(row)?;
    let copy = list.place(place + 1);
    steps.insert_row(&list, place + 1, &NewRow::CopyOf(place))?;
    let tree = steps.tree();
    let table = target(&list).map(|target| target.table);
    let rows = tree.at(&list).map(Tree::entries).unwrap_or_default();
    let names: Vec<String> = rows.iter().enumerate().filter_map(|(place, row)| row.name(place, table)).collect();
    if let Some(name) = names.get(place + 1).filter(|name| names.iter().filter(|other| other == name).count() > 1) {
        let name = free_name(name, &names);
        steps.put(&copy.key("name"), Spelled::text(&name).as_str())?;
    }
    Ok(copy)
}

pub(super) fn delete(steps: &mut Steps, row: &KeyPath) -> Result<KeyPath, EditError> {
    let (list, place) = row_of(row)?;
    steps.delete_row(&list, place)?;
    let left = steps.tree().at(&list).map_or(0, |list| list.entries().len());
    Ok(list.place(place.min(left.saturating_sub(1))))
}

/// The name with the next number that is free: `B2` after `B1`, `ring gear 2` after `ring gear`.
fn free_name(name: &str, taken: &[String]) -> String {
    let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let number: Option<u64> = name[stem.len()..].parse().ok().filter(|_| !stem.is_empty());
    let (stem, first) = number.map_or((format!("{name} "), 2), |number| (stem.into(), number.saturating_add(1)));
    let names = (first..).map(|number| format!("{stem}{number}"));
    names.take(taken.len() + 1).find(|name| !taken.contains(name)).unwrap_or(stem)
}

/// The keys of a new row: all that are required, and a name where others have one.
fn starting(tree: &Tree, list: &KeyPath, place: usize, table: &'static Table) -> Vec<(String, String)> {
    let rows = tree.at(list).map(Tree::entries).unwrap_or_default();
    let neighbour = place.checked_sub(1).or(Some(place)).and_then(|place| rows.get(place));
    let value = |field: &'static Field| match (field.presence, field.kind) {
        (Presence::Default(Written::ByPlace(prefix)), _) => {
            let named = rows.iter().any(|row| row.get(field.key).is_some());
            named.then(|| Spelled::text(&name_by_place(rows, place, prefix, table)).as_str().into())
        }
        (Presence::Required, _) if field.key == POSITION => Some(position(tree, list, place)),
        // the shaft goes on as it was
        (Presence::Required, Kind::Number(Quantity::Length, _)) => {
            Some(neighbour.and_then(|row| row.get(field.key)?.raw()).map_or_else(|| first(field), String::from))
        }
        (Presence::Required, _) => Some(first(field)),
        (Presence::Default(Written::Text(_)), Kind::Name) => neighbour?.get(field.key)?.raw().map(String::from),
        _ => None,
    };
    let keys = table.fields.iter().filter_map(|field| Some((field.key.to_owned(), value(field)?)));
    let mut keys: Vec<(String, String)> = keys.collect();
    if table.field(MODEL).is_some() {
        keys.extend(CARRYING.map(|key| (key.into(), "1.0e8".into())));
    }
    keys
}

/// A value to start from, where nothing else says one.
pub(super) fn first(field: &Field) -> String {
    let number = match field.kind {
        Kind::Number(Quantity::Length, _) => "50.0",
        Kind::Number(Quantity::Inertia, _) => "0.001",
        Kind::Number(_, Limit::Any | Limit::NotNegative) if field.key != MASS => "0.0",
        Kind::Number(_, Limit::Between(..)) => "0.25",
        Kind::Number(..) => "1.0",
        Kind::Whole(low, _) => return low.to_string(),
        Kind::Word(words) => return Spelled::text(words.first().unwrap_or(&"")).as_str().into(),
        Kind::Table(_) => return "{}".into(),
        Kind::Words(words) => return Spelled::texts(words.iter().copied()).as_str().into(),
        Kind::Vector(_) => "[0.0, 0.0, 0.0]",
        _ => "\"\"",
    };
    number.into()
}

fn name_by_place(rows: &[Tree], place: usize, prefix: &str, table: &'static Table) -> String {
    let after = |other: usize| if other < place { other } else { other + 1 };
    let taken: Vec<String> = rows.iter().enumerate().filter_map(|(i, row)| row.name(after(i), Some(table))).collect();
    let name = format!("{prefix}{}", place + 1);
    if taken.contains(&name) { free_name(&name, &taken) } else { name }
}

/// Between the neighbours, or between the last one and the end of the shaft, in mm.
fn position(tree: &Tree, list: &KeyPath, place: usize) -> String {
    let rotor = list.split_last().map(|(rotor, _)| rotor).unwrap_or_default();
    let segments = tree.at(&rotor.key("segment")).map(Tree::entries).unwrap_or_default();
    let length: f64 = segments.iter().filter_map(|row| row.get(LENGTH)?.number()).sum();
    let position = |place: usize| tree.at(&list.place(place).key(POSITION))?.number();
    let before = place.checked_sub(1).and_then(position).unwrap_or(0.0);
    let after = position(place).unwrap_or(length);
    let middle = f64::midpoint(before, after).clamp(0.0, length.max(0.0));
    format!("{:?}", (middle * 1e3).round() / 1e3)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::{Bearing, Body, DiagonalBearing};

    // A key that has another name in the schema would give new rows that cannot be read, or lie at 50 mm.
    #[test]
    fn the_keys_here_are_those_of_the_schema() {
        for (table, keys) in [
            (Body::TABLE, &[POSITION, MASS][..]),
            (Bearing::TABLE, &[POSITION, MODEL][..]),
            (crate::design::Segment::TABLE, &[LENGTH][..]),
            (DiagonalBearing::TABLE, &CARRYING[..]),
        ] {
            assert!(keys.iter().all(|key| table.field(key).is_some()), "{keys:?} in {}", table.name);
        }
    }
}
