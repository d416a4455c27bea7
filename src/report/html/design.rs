//! What the file says, table by table as the schema declares them, and what is worth a second look.

use std::fmt::Write as _;

use super::table::{Cell, Table};
use crate::design::grid::{CellKind, Column, Grid, Row, Shape, Sheet, Shown};
use crate::design::{Loaded, Source, grid};
use crate::report::markup::escape;
use crate::report::study::Study;
use crate::text::printable;

/// All tables that have anything in them.
pub fn render(loaded: &Loaded) -> String {
    let mut out = String::from("<p>Values in <i>italics</i> are not written in the file and hold by default.</p>\n");
    for sheet in Sheet::all() {
        // name and note stand at the top of the page
        if sheet == Sheet::design() {
            continue;
        }
        // without it the file has mesh vectors, and defaults of a table that is not there say nothing
        if sheet == Sheet::mesh_geometry() && loaded.design.mesh.geometry.is_none() {
            continue;
        }
        let grid = Grid::new(&loaded.text, &[], &sheet);
        out.push_str(&match sheet.shape {
            Shape::Single => values(&grid),
            Shape::List { .. } | Shape::Named => rows(&grid),
        });
    }
    out
}

/// A single table: a row a value.
fn values(grid: &Grid) -> String {
    let Some(row) = grid.rows.first() else { return String::new() };
    let mut table = Table::new(&row.label, ["value of", "value#", "unit"]);
    for cell in row.cells.iter().filter(|cell| cell.shown != Shown::Nothing) {
        table.row([Cell::text(&cell.column.label), shown(cell), Cell::text(cell.column.unit)]);
    }
    if row.cells.iter().all(|cell| cell.shown == Shown::Nothing) { String::new() } else { table.render() }
}

/// A list: a row an entry. Keys that only some entries have are columns of all, but for matrices, which follow.
fn rows(grid: &Grid) -> String {
    if grid.rows.is_empty() {
        return String::new();
    }
    let mut columns: Vec<&Column> = Vec::new();
    for cell in grid.rows.iter().flat_map(|row| &row.cells).filter(|cell| !is_entry(cell)) {
        if !columns.iter().any(|column| column.key == cell.column.key) {
            columns.push(&cell.column);
        }
    }
    let used = |column: &&Column| {
        let mut cells = grid.rows.iter().filter_map(|row| find(row, column.key));
        column.key != "name" && cells.any(|cell| cell.shown != Shown::Nothing)
    };
    columns.retain(used);
    let numeric = |column: &Column| grid.rows.iter().filter_map(|row| find(row, column.key)).any(is_number);
    let head = |column: &&Column| {
        let unit = if column.unit.is_empty() { String::new() } else { format!(", {}", column.unit) };
        format!("{}{unit}{}", column.label, if numeric(column) { "#" } else { "" })
    };
    let path = grid.sheet.path.to_string().replace('.', " ");
    let heads = std::iter::once(String::new()).chain(columns.iter().map(head));
    let mut table = Table::new(&path, heads.map(|head| if head.is_empty() { "name".into() } else { head }));
    let mut matrices = String::new();
    for row in &grid.rows {
        let cells = columns.iter().map(|column| find(row, column.key).map_or_else(Cell::none, shown));
        table.row(std::iter::once(Cell::name(&row.label)).chain(cells));
        matrices.push_str(&matrix(&path, row));
    }
    table.render() + &matrices
}

/// The stiffness matrix of a row that has one.
fn matrix(path: &str, row: &Row) -> String {
    const MOTIONS: [&str; 6] = ["x", "y", "z", "thx", "thy", "thz"];
    let mut table = Table::new(
        &format!("{path} {}: stiffness, N/m, N/rad; N, N m/rad", row.label),
        std::iter::once("motion".to_owned()).chain(MOTIONS.map(|motion| format!("{motion}#"))),
    );
    let mut any = false;
    for (i, motion) in MOTIONS.into_iter().enumerate() {
        let entries: Vec<Cell> = row
            .cells
            .iter()
            .filter(|cell| matches!(cell.kind, CellKind::MatrixEntry(at, _) if at == i))
            .map(shown)
            .collect();
        any |= !entries.is_empty();
        table.row(std::iter::once(Cell::text(motion)).chain(entries));
    }
    if any { table.render() } else { String::new() }
}

fn is_entry(cell: &grid::Cell) -> bool {
    matches!(cell.kind, CellKind::MatrixEntry(..))
}

fn is_number(cell: &grid::Cell) -> bool {
    cell.kind.quantity().is_some() || matches!(cell.kind, CellKind::Whole(..))
}

fn find<'r>(row: &'r Row, key: &str) -> Option<&'r grid::Cell> {
    row.cells.iter().find(|cell| cell.column.key == key)
}

fn shown(cell: &grid::Cell) -> Cell {
    let text = cell.shown.text();
    let content = if is_number(cell) { Cell::number(text) } else { Cell::name(text) };
    match cell.shown {
        Shown::Written(_) => content,
        Shown::Default(_) | Shown::Derived(_) => content.default(),
        Shown::Nothing => Cell::none(),
    }
}

pub fn warnings(loaded: &Loaded, study: &Study) -> String {
    let caveats = &study.comparison.caveats;
    let mut out = String::new();
    let of_states = study.rotors.mean_state_warnings(&loaded.design);
    if loaded.warnings.is_empty() && of_states.is_empty() {
        out.push_str("<p>The file raises no warning.</p>\n");
    } else {
        let file = loaded.file_name();
        let mut rendered = Source::new(&file, &loaded.text).render_all(&loaded.warnings);
        for warning in of_states {
            // writing to a String cannot fail
            let _ = writeln!(rendered, "{}: warning: {}", printable(&file), printable(&warning));
        }
        let lines: Vec<String> = rendered.trim_end().lines().map(escape).collect();
        // writing to a String cannot fail
        let _ = writeln!(out, "<pre>{}</pre>", lines.join("\n"));
    }
    if caveats.is_empty() {
        out.push_str("<p>The enhanced model rests on the first bending modes alone.</p>\n");
    } else {
        out.push_str("<p>What the enhanced model rests on besides first bending modes:</p>\n<ul>\n");
        for caveat in caveats {
            let _ = writeln!(out, "<li>{}</li>", escape(&caveat.long()));
        }
        out.push_str("</ul>\n");
    }
    out
}
