//! Where two designs differ.

use super::KeyPath;
use super::document::Tree;
use super::grid::{Cell, CellKind, Grid, Row, Shape, Sheet, Shown};
use super::label;

/// One value, or one row, that is not the same in two designs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// By name where rows have names (`pinion.bearing[B1].kx_n_per_m`), else by place.
    pub path: KeyPath,
    /// In words: `kx of pinion bearing B1`
    pub label: String,
    /// As spelled in the first design, texts without quotes; nothing where it has no such value or row. Defaults count.
    pub a: Option<String>,
    /// So in the second.
    pub b: Option<String>,
    /// As people read it; empty where there is none.
    pub unit: &'static str,
    /// Whether the values are numbers, by what the schema says and not by how they look
    pub is_number: bool,
}

impl Difference {
    /// Both values where they are numbers, in [`unit`](Self::unit).
    pub fn numbers(&self) -> [Option<f64>; 2] {
        let number = |text: &Option<String>| Tree::Value(text.clone()?).number();
        if self.is_number { [&self.a, &self.b].map(number) } else { [None, None] }
    }
}

/// What stands for a row that only one design has.
const ROW: &str = "row";

/// Everything that differs, in the order of the schema. Numbers are compared as numbers, rows by name where they have
/// names, else by place. A row that only one has is one difference, with `row` in place of its values.
pub fn diff(a: &str, b: &str) -> Vec<Difference> {
    let trees = (Tree::read(a), Tree::read(b));
    let mut found = Vec::new();
    for sheet in Sheet::all() {
        let (grid_a, grid_b) = (Grid::new(a, &[], &sheet), Grid::new(b, &[], &sheet));
        let mut taken = vec![false; grid_b.rows.len()];
        for (place, row) in grid_a.rows.iter().enumerate() {
            let same = grid_b.rows.iter().enumerate().position(|(other_place, other)| {
                !taken[other_place] && if is_named(&sheet) { other.label == row.label } else { other_place == place }
            });
            let path = path_of(&sheet, row);
            match same {
                Some(other) => {
                    taken[other] = true;
                    rows(&trees, (row, &grid_b.rows[other]), &path, &mut found);
                }
                None => found.push(only_one(&trees.0, row, path, (Some(ROW), None))),
            }
        }
        for row in grid_b.rows.iter().zip(&taken).filter(|(_, taken)| !**taken).map(|(row, _)| row) {
            found.push(only_one(&trees.1, row, path_of(&sheet, row), (None, Some(ROW))));
        }
    }
    found
}

/// Have its rows names that mean the same in both designs?
fn is_named(sheet: &Sheet) -> bool {
    match sheet.shape {
        Shape::List { .. } => sheet.table.field("name").is_some(),
        Shape::Single | Shape::Named => true,
    }
}

fn path_of(sheet: &Sheet, row: &Row) -> KeyPath {
    match sheet.shape {
        Shape::List { .. } if is_named(sheet) => sheet.path.name(&row.label),
        _ => row.path.clone(),
    }
}

fn only_one(tree: &Tree, row: &Row, path: KeyPath, (a, b): (Option<&str>, Option<&str>)) -> Difference {
    let (a, b) = (a.map(String::from), b.map(String::from));
    Difference { path, label: label::of_table(tree, &row.path), a, b, unit: "", is_number: false }
}

fn rows(trees: &(Tree, Tree), (a, b): (&Row, &Row), path: &KeyPath, found: &mut Vec<Difference>) {
    let below = |row: &Row, cell: &Cell| cell.path.steps()[row.path.steps().len()..].to_vec();
    let in_b = |cell: &Cell| b.cells.iter().find(|other| below(b, other) == below(a, cell));
    let of_both = a.cells.iter().map(|cell| (Some(cell), in_b(cell)));
    let in_a = |cell: &Cell| a.cells.iter().any(|other| below(a, other) == below(b, cell));
    let only_in_b = b.cells.iter().filter(|cell| !in_a(cell)).map(|cell| (None, Some(cell)));
    for (cell_a, cell_b) in of_both.chain(only_in_b) {
        if cell_a.is_some() && cell_b.is_some_and(|b| cell_a.is_some_and(|a| is_same(a, b))) {
            continue;
        }
        let (value_a, value_b) = (cell_a.and_then(value), cell_b.and_then(value));
        let Some((cell, row, tree)) = cell_a.map(|c| (c, a, &trees.0)).or(cell_b.map(|c| (c, b, &trees.1))) else {
            continue;
        };
        if value_a == value_b || is_mirrored(cell, (a, &value_a), (b, &value_b)) {
            continue;
        }
        let path = below(row, cell).into_iter().fold(path.clone(), |path, step| path.with(step));
        let label = label::of_value(tree, &cell.path);
        let (unit, is_number) = (cell.column.unit, is_number(cell));
        found.push(Difference { path, label, a: value_a, b: value_b, unit, is_number });
    }
}

/// Below a matrix's diagonal, is it what was found above it?
fn is_mirrored(cell: &Cell, a: (&Row, &Option<String>), b: (&Row, &Option<String>)) -> bool {
    let CellKind::MatrixEntry(row, column) = cell.kind else { return false };
    let mirror = CellKind::MatrixEntry(column, row);
    let above = |row: &Row| row.cells.iter().find(|cell| cell.kind == mirror).and_then(value);
    row > column && [a, b].into_iter().all(|(row, value)| above(row) == *value)
}

fn value(cell: &Cell) -> Option<String> {
    (cell.shown != Shown::Nothing).then(|| cell.shown.text().to_owned())
}

fn is_same(a: &Cell, b: &Cell) -> bool {
    let number = |cell: &Cell| {
        let text = || cell.shown.text().to_owned();
        is_number(cell).then(text).and_then(|text| Tree::Value(text).number())
    };
    match (number(a), number(b)) {
        (Some(a), Some(b)) => a == b,
        _ => value(a) == value(b),
    }
}

fn is_number(cell: &Cell) -> bool {
    use CellKind::{MatrixEntry, Number, VectorEntry, Whole};
    matches!(cell.kind, Number(..) | Whole(..) | VectorEntry(_) | MatrixEntry(..))
}
