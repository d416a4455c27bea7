//! Aligned tables.

use unicode_width::UnicodeWidthStr;

use crate::text::{cut, printable};

/// A table whose columns are as wide as their content: the first column to the left, numbers to the right.
#[derive(Debug, Clone, Default)]
pub struct Table {
    heads: Vec<String>,
    rows: Vec<Vec<String>>,
    /// Widest first column
    widest_name: usize,
    gap: &'static str,
}

impl Table {
    /// A table with the given column heads; units belong into them. A head may have several lines.
    pub fn new<const N: usize>(heads: [&str; N]) -> Self {
        Self::with_heads(heads.map(str::to_owned).to_vec())
    }

    /// As [`Table::new`], for heads that are made at run time.
    pub fn with_heads(heads: Vec<String>) -> Self {
        Self { heads, rows: Vec::new(), widest_name: usize::MAX, gap: "  " }
    }

    /// Cuts the first column to at most this many columns of the terminal.
    #[must_use]
    pub fn widest_name(mut self, columns: usize) -> Self {
        self.widest_name = columns;
        self
    }

    /// One space between columns instead of two, for tables that would be wider than a terminal.
    #[must_use]
    pub fn tight(mut self) -> Self {
        self.gap = " ";
        self
    }

    /// Adds a row. Fewer cells than heads are allowed; the last cell of a short row is free text and does not widen its column.
    pub fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        let mut cells: Vec<String> = cells.into_iter().map(|cell| printable(&cell).into_owned()).collect();
        if let Some(name) = cells.first_mut() {
            *name = cut(name, self.widest_name, "..");
        }
        self.rows.push(cells);
    }

    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

impl std::fmt::Display for Table {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let columns = self.heads.len();
        let heads: Vec<Vec<&str>> = self.heads.iter().map(|head| head.split('\n').collect()).collect();
        let height = heads.iter().map(Vec::len).max().unwrap_or(0);
        let mut widths: Vec<usize> =
            heads.iter().map(|lines| lines.iter().map(|line| line.width()).max().unwrap_or(0)).collect();
        for row in &self.rows {
            let aligned = if row.len() < columns { row.len().saturating_sub(1).max(1) } else { columns };
            for (width, cell) in widths.iter_mut().zip(row.iter().take(aligned)) {
                *width = (*width).max(cell.width());
            }
        }
        let line = |cells: &[&str]| {
            let mut out = String::new();
            for (i, cell) in cells.iter().enumerate() {
                let free = cells.len() < columns && i + 1 == cells.len() && i > 0;
                let padding = " ".repeat(if free { 0 } else { widths[i].saturating_sub(cell.width()) });
                if i == 0 {
                    out.push_str(cell);
                    out.push_str(&padding);
                } else {
                    out.push_str(self.gap);
                    out.push_str(&padding);
                    out.push_str(cell);
                }
            }
            out.trim_end().to_owned()
        };
        for i in 0..height {
            // short heads stand on the last line, next to the numbers
            let cells: Vec<&str> =
                heads.iter().map(|lines| (i + lines.len()).checked_sub(height).map_or("", |i| lines[i])).collect();
            writeln!(f, "{}", line(&cells))?;
        }
        for row in &self.rows {
            let cells: Vec<&str> = row.iter().map(String::as_str).collect();
            writeln!(f, "{}", line(&cells))?;
        }
        Ok(())
    }
}
