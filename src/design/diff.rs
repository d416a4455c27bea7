//! Where two designs differ.

use super::KeyPath;
use super::align::{align, is_named};
use super::document::Tree;
use super::grid::{Cell, CellKind, Grid, Row, Shape, Sheet, Shown};
use super::label;

/// One value, or one row, that is not the same in two designs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// In the first design, by name where rows have names (`pinion.bearing[B1].kx_n_per_m`), else by place. Of a row
    /// that only the second one has, there.
    pub path: KeyPath,
    /// In words: `kx of pinion bearing B1`
    pub label: String,
    /// The path in the second design: another one where the row has moved or has another name.
    pub path_in_b: KeyPath,
    pub label_in_b: String,
    /// As spelled in the first design, texts without quotes; nothing where it has no such value or row. Defaults count.
    pub a: Option<String>,
    /// So in the second.
    pub b: Option<String>,
    /// As people read it; empty where there is none.
    pub unit: &'static str,
    /// Whether the values are numbers, by what the schema says and not by how they look
    pub is_number: bool,
    /// Whether it is a whole row that only one design has
    pub is_row: bool,
}

impl Difference {
    /// Both values to be shown, with what became of a row from the first to the second design. Make them
    /// [printable](crate::text::printable).
    pub fn shown(&self) -> [&str; 2] {
        match (self.is_row, &self.a) {
            (true, Some(_)) => ["", "removed"],
            (true, None) => ["", "added"],
            (false, _) => [&self.a, &self.b].map(|value| value.as_deref().unwrap_or("-")),
        }
    }

    /// The same, seen from the other design.
    pub fn swap(&mut self) {
        std::mem::swap(&mut self.a, &mut self.b);
        std::mem::swap(&mut self.path, &mut self.path_in_b);
        std::mem::swap(&mut self.label, &mut self.label_in_b);
    }

    /// Both values where they are numbers, in [`unit`](Self::unit).
    pub fn numbers(&self) -> [Option<f64>; 2] {
        let number = |text: &Option<String>| Tree::Value(text.clone()?).number();
        if self.is_number { [&self.a, &self.b].map(number) } else { [None, None] }
    }
}

/// What stands for a row that only one design has.
const ROW: &str = "row";

/// Everything that differs, in the order of the schema. Numbers are compared as numbers. Rows are the same by name where
/// they have names, also if they differ in nothing else; others are paired so that as little as possible differs. A row that
/// only one has is one difference, with `row` in place of its values.
pub fn diff(a: &str, b: &str) -> Vec<Difference> {
    let trees = (Tree::read(a), Tree::read(b));
    let mut found = Vec::new();
    for sheet in Sheet::all() {
        let (grid_a, grid_b) = (Grid::new(a, &[], &sheet), Grid::new(b, &[], &sheet));
        for (in_a, in_b) in align(&sheet, &grid_a, &grid_b, is_same) {
            let (in_a, in_b) = (in_a.map(|at| &grid_a.rows[at]), in_b.map(|at| &grid_b.rows[at]));
            match (in_a, in_b) {
                (Some(a), Some(b)) => {
                    let paths = (path_of(&sheet, a), path_of(&sheet, b));
                    if sheet.shape == Shape::Named && a.label != b.label {
                        found.push(renamed(&trees, (a, b)));
                    }
                    rows(&trees, (a, b), &paths, &mut found);
                }
                (Some(a), None) => found.push(only_one(&trees.0, a, path_of(&sheet, a), (Some(ROW), None))),
                (None, Some(b)) => found.push(only_one(&trees.1, b, path_of(&sheet, b), (None, Some(ROW)))),
                (None, None) => {}
            }
        }
    }
    found
}

/// The cells of a table that are not as they were in an earlier text.
pub fn changed_cells(before: &str, now: &Grid) -> Vec<KeyPath> {
    let before = Grid::new(before, &[], &now.sheet);
    let mut changed = Vec::new();
    for (was, is) in align(&now.sheet, &before, now, is_same) {
        let Some(row) = is.map(|at| &now.rows[at]) else { continue };
        let was = was.map(|at| &before.rows[at]);
        let is_as_before = |cell: &&Cell| {
            was.is_some_and(|was| {
                let below = &cell.path.steps()[row.path.steps().len()..];
                let mut others =
                    was.cells.iter().filter(|other| other.path.steps()[was.path.steps().len()..] == *below);
                others.next().is_some_and(|other| is_same(other, cell))
            })
        };
        changed.extend(
            row.cells
                .iter()
                .filter(|cell| !cell.shown.is_derived() && !is_as_before(cell))
                .map(|cell| cell.path.clone()),
        );
    }
    changed
}

fn path_of(sheet: &Sheet, row: &Row) -> KeyPath {
    match sheet.shape {
        Shape::List { .. } if is_named(sheet) => sheet.path.name(&row.label),
        _ => row.path.clone(),
    }
}

fn only_one(tree: &Tree, row: &Row, path: KeyPath, (a, b): (Option<&str>, Option<&str>)) -> Difference {
    let (a, b) = (a.map(String::from), b.map(String::from));
    let label = label::of_table(tree, &row.path);
    let (path_in_b, label_in_b) = (path.clone(), label.clone());
    Difference { path, label, path_in_b, label_in_b, a, b, unit: "", is_number: false, is_row: true }
}

/// A table that is called by its key.
fn renamed(trees: &(Tree, Tree), (a, b): (&Row, &Row)) -> Difference {
    let label = |tree: &Tree, row: &Row| format!("name of {}", label::of_table(tree, &row.path));
    Difference {
        path: a.path.clone(),
        label: label(&trees.0, a),
        path_in_b: b.path.clone(),
        label_in_b: label(&trees.1, b),
        a: Some(a.label.clone()),
        b: Some(b.label.clone()),
        unit: "",
        is_number: false,
        is_row: false,
    }
}

fn rows(trees: &(Tree, Tree), (a, b): (&Row, &Row), paths: &(KeyPath, KeyPath), found: &mut Vec<Difference>) {
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
        let Some((cell, row)) = cell_a.map(|c| (c, a)).or(cell_b.map(|c| (c, b))) else { continue };
        if value_a == value_b || is_mirrored(cell, (a, &value_a), (b, &value_b)) {
            continue;
        }
        let within = |path: &KeyPath| below(row, cell).into_iter().fold(path.clone(), |path, step| path.with(step));
        let label = |tree: &Tree, row: &Row| label::of_value(tree, &within(&row.path));
        found.push(Difference {
            path: within(&paths.0),
            label: label(&trees.0, a),
            path_in_b: within(&paths.1),
            label_in_b: label(&trees.1, b),
            a: value_a,
            b: value_b,
            unit: cell.column.unit,
            is_number: is_number(cell),
            is_row: false,
        });
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
