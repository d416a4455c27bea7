//! Designs as tables of cells, made from the schema: what a person sees and edits.

mod cell;
mod derived;
mod findings;
mod make;
mod sheet;
mod typed;

pub use cell::{Cell, CellKind, Column, Shown};
pub use sheet::{Shape, Sheet};
pub use typed::TypedError;

use super::document::Tree;
use super::{Finding, KeyPath};

/// A table of a design as rows of cells.
///
/// ```
/// use bevelscope::design::{Edit, Editor, Side, grid::Sheet, library::SHIPPED};
///
/// let mut editor = Editor::new(SHIPPED[0].text)?;
/// let grid = editor.grid(&Sheet::bearings(Side::Pinion));
/// let kx = grid.rows[0].cells.iter().find(|cell| cell.column.key == "kx_n_per_m").unwrap();
/// assert_eq!((kx.shown.text(), kx.column.unit), ("6.0e8", "N/m"));
/// editor.apply(&Edit::from_typed(kx, "650 N/um")?)?;
/// assert_eq!(editor.reading().design.as_ref().unwrap().pinion.bearings[0].name, "head bearing");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    pub sheet: Sheet,
    /// The columns that all rows have.
    pub columns: Vec<Column>,
    /// One row for a single table, also where it is not written; else one for each entry.
    pub rows: Vec<Row>,
    /// Which findings are about the list as a whole, as places in the list of findings: that it is missing or too short.
    pub findings: Vec<usize>,
}

/// One table as cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// By place: `pinion.bearing[0]`; materials by key: `material.steel`.
    pub path: KeyPath,
    /// `B1`, `segment 3`, `steel`: what people call it.
    pub label: String,
    /// Those of [`Grid::columns`] first, in that order; then those that only this row has (a bearing's model has its own).
    pub cells: Vec<Cell>,
    /// Which findings are about the row or anything in it, as places in the list of findings.
    pub findings: Vec<usize>,
}

impl Grid {
    /// The table as the text has it. A text that is no TOML gives what can be read of it.
    pub fn new(text: &str, findings: &[Finding], sheet: &Sheet) -> Self {
        let tree = Tree::read(text);
        let mut rows = make::rows(&tree, sheet);
        for row in &mut rows {
            findings::place_in_row(row, findings, sheet.shape);
        }
        let columns = make::columns(sheet.table);
        Self { sheet: sheet.clone(), columns, rows, findings: findings::about(&sheet.path, findings) }
    }

    /// The cell at that path.
    pub fn cell(&self, path: &KeyPath) -> Option<&Cell> {
        self.rows.iter().flat_map(|row| &row.cells).find(|cell| cell.path == *path)
    }
}
