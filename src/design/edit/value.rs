//! Setting and clearing one value, however it is written.

use super::bearing;
use super::steps::{Steps, row_of};
use crate::design::EditError;
use crate::design::document::{NewRow, Tree};
use crate::design::key_path::{KeyPath, Step};
use crate::design::schema::{Field, Kind, Presence, Written, target};

/// What stands in the places of a vector or of a matrix that nothing was said about.
const ZERO: &str = "0.0";

/// The field at a path by place, and the steps to an entry of its value.
fn field(path: &KeyPath) -> Option<(&'static Field, &[Step])> {
    let target = target(path)?;
    Some((target.field?, path.steps().get(target.steps + 1..)?))
}

fn kind(path: &KeyPath) -> Option<(Kind, &[Step])> {
    field(path).map(|(field, entry)| (field.kind, entry))
}

pub(super) fn set(steps: &mut Steps, path: &KeyPath, value: &str) -> Result<KeyPath, EditError> {
    match kind(path) {
        Some((Kind::Vector(_), [Step::Place(place @ 0..3)])) => set_in_vector(steps, path, *place, value)?,
        Some((Kind::Matrix, [Step::Place(row @ 0..6), Step::Place(column @ 0..6)])) => {
            set_in_matrix(steps, path, (*row, *column), value)?;
        }
        Some((Kind::Texts | Kind::Words(_), [])) => set_list(steps, path, value)?,
        Some((Kind::Variant(_), [])) => {
            let table = path.split_last().map(|(table, _)| table).unwrap_or_default();
            let word = Tree::read_value(value).text().ok_or_else(|| EditError::Refused("a word is wanted".into()))?;
            bearing::set_model(steps, &table, &word)?;
        }
        _ => steps.put(path, value)?,
    }
    Ok(path.clone())
}

pub(super) fn remove(steps: &mut Steps, path: &KeyPath) -> Result<KeyPath, EditError> {
    match field(path) {
        // its default holds already
        Some((_, [])) if steps.tree().at(path).is_none() => {}
        Some((Field { kind: Kind::Vector(_) | Kind::Matrix, .. }, [_, ..])) => {
            return Err(EditError::Refused(format!("{path} cannot be left empty")));
        }
        Some((Field { kind: Kind::Variant(_), presence: Presence::Default(Written::Text(word)), .. }, [])) => {
            // the keys of the other model go with it
            let table = path.split_last().map(|(table, _)| table).unwrap_or_default();
            bearing::set_model(steps, &table, word)?;
            steps.remove(path)?;
        }
        _ => match path.split_last() {
            Some((_, Step::Place(_))) => {
                let (list, place) = row_of(path)?;
                steps.delete_row(&list, place)?;
            }
            _ => steps.remove(path)?,
        },
    }
    Ok(path.clone())
}

/// The path without its last steps.
fn up(path: &KeyPath, steps: usize) -> KeyPath {
    (0..steps).fold(path.clone(), |path, _| path.split_last().map(|(path, _)| path).unwrap_or_default())
}

fn entry(tree: Option<&Tree>, place: usize) -> &str {
    tree.and_then(|tree| tree.entries().get(place)?.raw()).unwrap_or(ZERO)
}

fn set_in_vector(steps: &mut Steps, path: &KeyPath, place: usize, value: &str) -> Result<(), EditError> {
    let (tree, vector) = (steps.tree(), up(path, 1));
    let written = tree.at(&vector);
    if written.is_some_and(|vector| vector.entries().len() == 3) {
        return steps.put(path, value);
    }
    let entries: Vec<&str> = (0..3).map(|i| if i == place { value } else { entry(written, i) }).collect();
    steps.put(&vector, &format!("[{}]", entries.join(", ")))
}

fn set_in_matrix(steps: &mut Steps, path: &KeyPath, at: (usize, usize), value: &str) -> Result<(), EditError> {
    let (tree, matrix) = (steps.tree(), up(path, 2));
    let written = tree.at(&matrix);
    let whole = |rows: &Tree| rows.entries().len() == 6 && rows.entries().iter().all(|row| row.entries().len() == 6);
    if written.is_some_and(whole) {
        steps.put(path, value)?;
        return if at.0 == at.1 { Ok(()) } else { steps.put(&matrix.place(at.1).place(at.0), value) };
    }
    let rows = std::array::from_fn(|i| {
        let row = written.and_then(|rows| rows.entries().get(i));
        std::array::from_fn(|j| if (i, j) == at || (j, i) == at { value } else { entry(row, j) }.to_owned())
    });
    let text = bearing::matrix(steps, &up(&matrix, 1), &rows);
    steps.put(&matrix, &text)
}

/// Entries that stay are left as they are written.
fn set_list(steps: &mut Steps, path: &KeyPath, value: &str) -> Result<(), EditError> {
    let (tree, new) = (steps.tree(), Tree::read_value(value));
    let (Some(Tree::List(old)), Tree::List(new)) = (tree.at(path), &new) else { return steps.put(path, value) };
    let same = |(a, b): &(&Tree, &Tree)| a.text() == b.text() && a.text().is_some();
    let start = old.iter().zip(new).take_while(same).count();
    let end = old[start..].iter().rev().zip(new[start..].iter().rev()).take_while(same).count();
    let (old_end, new_end) = (old.len() - end, new.len() - end);
    let raw = |tree: &Tree| tree.raw().map(String::from).ok_or_else(|| EditError::NoPlace(path.clone()));
    for place in (new_end.max(start)..old_end).rev() {
        steps.delete_row(path, place)?;
    }
    for (place, entry) in new.iter().enumerate().take(new_end).skip(start) {
        if place < old_end {
            steps.put(&path.place(place), &raw(entry)?)?;
        } else {
            steps.insert_row(path, place, &NewRow::Entry(raw(entry)?))?;
        }
    }
    Ok(())
}
