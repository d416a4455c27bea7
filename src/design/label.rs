//! Key paths in words, from the names of the schema.

use super::document::Tree;
use super::key_path::{KeyPath, Step};
use super::schema::{Kind, Table, target};

/// Coordinates of bearings' matrices.
pub(super) const COORDINATES: [&str; 6] = ["x", "y", "z", "thx", "thy", "thz"];

const OPERATING: &str = "operating";

/// `outer diameter of pinion segment 3`, `point z of mesh pinion`, `name of design`, `pinion torque`.
pub(super) fn of_value(tree: &Tree, path: &KeyPath) -> String {
    let Some(target) = target(path) else { return path.to_string() };
    let Some(field) = target.field else { return of_table(tree, path) };
    let mut table = KeyPath::root();
    for step in &path.steps()[..target.steps] {
        table = table.with(step.clone());
    }
    let entries: Vec<String> = path.steps()[target.steps + 1..].iter().map(|step| entry(field.kind, step)).collect();
    let label = std::iter::once(field.label()).chain(entries).collect::<Vec<_>>().join(" ");
    match of_table(tree, &table) {
        // no part of the gearbox: its torque and speed say what they are
        table if table == OPERATING => label,
        table => format!("{label} of {table}"),
    }
}

/// `point z`, `stiffness x thz`
pub(super) fn entry(kind: Kind, step: &Step) -> String {
    match (kind, step) {
        (Kind::Vector(_) | Kind::Matrix, Step::Place(place)) => COORDINATES.get(*place).copied().unwrap_or("?").into(),
        (_, Step::Place(place)) => (place + 1).to_string(),
        (_, Step::Key(name) | Step::Name(name)) => name.clone(),
    }
}

/// `pinion segment 3`, `material steel`, `mesh`; `design` for the whole file.
pub(super) fn of_table(tree: &Tree, path: &KeyPath) -> String {
    let mut words: Vec<String> = Vec::new();
    let mut at = KeyPath::root();
    for step in path.steps() {
        match step {
            Step::Key(key) => words.push(key.clone()),
            Step::Name(name) => words.push(name.clone()),
            Step::Place(place) => {
                let row = of_row(tree, &at, *place);
                // rows without names of their own are called after their table
                if words.last().is_some_and(|table| row.starts_with(&format!("{table} "))) {
                    words.pop();
                }
                words.push(row);
            }
        }
        at = at.with(step.clone());
    }
    if words.is_empty() { "design".into() } else { words.join(" ") }
}

/// What people call the row: its name, or its number with the name of the table: `B1`, `segment 3`.
pub(super) fn of_row(tree: &Tree, list: &KeyPath, place: usize) -> String {
    let table: Option<&'static Table> = target(list).map(|target| target.table);
    let row = tree.at(&list.place(place)).cloned().unwrap_or_else(Tree::table);
    row.name(place, table).unwrap_or_else(|| format!("{} {}", table.map_or("row", |table| table.name), place + 1))
}

/// `bearing B1 of pinion`
pub(super) fn of_row_in_words(tree: &Tree, row: &KeyPath) -> String {
    let Some((list, Step::Place(place))) = row.split_last() else { return of_table(tree, row) };
    let name = of_row(tree, &list, *place);
    let Some((around, Step::Key(key))) = list.split_last() else { return name };
    let table = target(&list).map_or(key.as_str(), |target| target.table.name);
    let name = if name.starts_with(&format!("{table} ")) { name } else { format!("{table} {name}") };
    format!("{name} of {}", of_table(tree, &around))
}
