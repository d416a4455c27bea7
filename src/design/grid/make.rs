//! From the schema and what the text says to rows of cells.

use super::cell::matrix_quantity;
use super::{Cell, CellKind, Column, Row, Shape, Sheet, Shown};
use crate::design::document::Tree;
use crate::design::key_path::{KeyPath, Step};
use crate::design::label;
use crate::design::schema::{Field, Kind, Presence, Table, Variant, Written};

/// One table of the text while its cells are made.
struct At<'t> {
    tree: Option<&'t Tree>,
    path: KeyPath,
    /// In a list, from 0
    place: usize,
    /// Of a named table
    name: &'t str,
}

pub(super) fn rows(tree: &Tree, sheet: &Sheet) -> Vec<Row> {
    let at = tree.at(&sheet.path);
    let row = |place: At<'_>, label: String| {
        let mut cells = cells(&place, sheet.table, sheet.shape != Shape::Single);
        // those of the row's own come last
        cells.sort_by_key(|(own, _)| *own);
        let cells = cells.into_iter().map(|(_, cell)| cell).collect();
        Row { path: place.path, label, cells, findings: Vec::new() }
    };
    match sheet.shape {
        Shape::Single => {
            let path = sheet.path.clone();
            vec![row(At { tree: at, path, place: 0, name: "" }, label::of_table(tree, &sheet.path))]
        }
        Shape::List { .. } => {
            let entries = at.map(Tree::entries).unwrap_or_default().iter().enumerate();
            let entries = entries.map(|(place, entry)| {
                let path = sheet.path.place(place);
                row(At { tree: Some(entry), path, place, name: "" }, label::of_row(tree, &sheet.path, place))
            });
            entries.collect()
        }
        Shape::Named => {
            let written = at.into_iter().flat_map(Tree::pairs).map(|(name, entry)| (name, Some(entry)));
            let default = sheet.table.fields.iter().find_map(|field| match field.presence {
                Presence::DefaultIn(name, _) => Some(name),
                _ => None,
            });
            let default = default.filter(|name| at.is_none_or(|at| at.get(name).is_none()));
            // the one that is always there comes first, as long as nothing is written about it
            let named = default.map(|name| (name, None)).into_iter().chain(written);
            let named =
                named.map(|(name, tree)| row(At { tree, path: sheet.path.key(name), place: 0, name }, name.into()));
            named.collect()
        }
    }
}

pub(super) fn columns(table: &'static Table) -> Vec<Column> {
    let nothing = At { tree: None, path: KeyPath::root(), place: 0, name: "" };
    let cells = cells(&nothing, table, false).into_iter();
    cells.filter(|(own, _)| !own).map(|(_, cell)| cell.column).collect()
}

/// The cells of a table, each with whether only this row has it. Tables below come along in rows only: otherwise they have
/// sheets of their own.
fn cells(place: &At<'_>, table: &'static Table, in_row: bool) -> Vec<(bool, Cell)> {
    table.fields.iter().flat_map(|field| cells_of_field(place, field, in_row)).collect()
}

fn cells_of_field(place: &At<'_>, field: &'static Field, in_row: bool) -> Vec<(bool, Cell)> {
    let path = place.path.key(field.key);
    let written = place.tree.and_then(|tree| tree.get(field.key));
    let unit = field.quantity().map_or("", |quantity| quantity.unit());
    let whole = |kind| {
        let shown = written.map_or_else(|| default(place, field), |written| Shown::Written(shown(written)));
        let column = Column { key: field.key, label: field.label(), unit, doc: field.doc };
        vec![(false, cell(column, path.clone(), shown, kind, required(place, field)))]
    };
    let entries = |kinds: Vec<(Vec<usize>, &'static str, CellKind)>| {
        let entry = |(steps, unit, kind): (Vec<usize>, &'static str, CellKind)| {
            let names = steps.iter().map(|step| label::entry(field.kind, &Step::Place(*step)));
            let label = if matches!(kind, CellKind::MatrixEntry(..)) {
                names.collect::<Vec<_>>().join(" ")
            } else {
                std::iter::once(field.label()).chain(names).collect::<Vec<_>>().join(" ")
            };
            let value = steps.iter().try_fold(written, |tree, step| Some(tree?.entries().get(*step))).flatten();
            let shown = value.map_or(Shown::Nothing, |value| Shown::Written(shown(value)));
            let path = steps.iter().fold(path.clone(), |path, step| path.place(*step));
            (false, cell(Column { key: field.key, label, unit, doc: field.doc }, path, shown, kind, true))
        };
        kinds.into_iter().map(entry).collect()
    };
    match field.kind {
        Kind::Number(quantity, limit) => whole(CellKind::Number(quantity, limit)),
        Kind::Whole(low, high) => whole(CellKind::Whole(low, high)),
        Kind::Text => whole(CellKind::Text),
        Kind::Name => whole(CellKind::Name),
        Kind::Texts => whole(CellKind::Texts),
        Kind::Word(words) => whole(CellKind::Choice(words)),
        Kind::Words(words) => whole(CellKind::Flags(words)),
        Kind::Vector(quantity) => entries((0..3).map(|i| (vec![i], unit, CellKind::VectorEntry(quantity))).collect()),
        Kind::Matrix => {
            let places = (0..6).flat_map(|i| (0..6).map(move |j| (i, j)));
            entries(
                places.map(|(i, j)| (vec![i, j], matrix_quantity(i, j).unit(), CellKind::MatrixEntry(i, j))).collect(),
            )
        }
        Kind::Variant(variants) => {
            let mut cells = whole(CellKind::Model(variants));
            cells.extend(chosen(place, field, variants).into_iter().flat_map(|table| {
                table.fields.iter().flat_map(|field| cells_of_field(place, field, in_row)).map(|(_, cell)| (true, cell))
            }));
            cells
        }
        Kind::Table(table) if in_row => {
            let mut cells = cells(&At { tree: written, path, place: 0, name: "" }, table, true);
            for (_, cell) in &mut cells {
                // several tables have an x, and one that is left out has no values
                cell.column.label = format!("{} {}", field.label(), cell.column.label);
                if written.is_none() && field.presence == Presence::Optional {
                    cell.shown = Shown::Nothing;
                }
            }
            cells
        }
        Kind::Table(_) | Kind::Tables(..) | Kind::NamedTables(_) => Vec::new(),
    }
}

/// The keys that the chosen word brings.
fn chosen(place: &At<'_>, field: &Field, variants: &'static [Variant]) -> Option<&'static Table> {
    // of no table in particular
    place.tree?;
    let word = match place.tree.and_then(|tree| tree.get(field.key)) {
        Some(written) => written.text(),
        None => match field.presence {
            Presence::Default(Written::Text(word)) => Some(word.into()),
            _ => None,
        },
    }?;
    Some(variants.iter().find(|variant| variant.word == word)?.table)
}

fn cell(column: Column, path: KeyPath, shown: Shown, kind: CellKind, required: bool) -> Cell {
    Cell { column, path, shown, kind, required, findings: Vec::new() }
}

fn required(place: &At<'_>, field: &Field) -> bool {
    match field.presence {
        Presence::Required | Presence::Unless(_) => true,
        Presence::DefaultIn(name, _) => name != place.name,
        Presence::Optional | Presence::Default(_) => false,
    }
}

fn default(place: &At<'_>, field: &Field) -> Shown {
    let written = match field.presence {
        Presence::Default(written) => written,
        Presence::DefaultIn(name, written) if name == place.name => written,
        _ => return Shown::Nothing,
    };
    default_text(written, place.place).map_or(Shown::Nothing, Shown::Default)
}

/// A default as it could be written, texts without quotes; nothing for an empty list.
pub(in crate::design) fn default_text(written: Written, place: usize) -> Option<String> {
    match written {
        Written::Number(number) => Some(format!("{number:?}")),
        Written::Whole(number) => Some(number.to_string()),
        Written::Text(text) => Some(text.into()),
        Written::ByPlace(prefix) => Some(format!("{prefix}{}", place + 1)),
        Written::Empty => None,
    }
}

/// A value as people read it: texts without quotes, lists with commas.
pub(in crate::design) fn shown(tree: &Tree) -> String {
    match tree {
        Tree::Value(raw) => tree.text().unwrap_or_else(|| raw.clone()),
        Tree::List(entries) => entries.iter().map(shown).collect::<Vec<_>>().join(", "),
        Tree::Table(_) => "{...}".into(),
    }
}
