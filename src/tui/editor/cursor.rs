//! Where one is in a table.

use super::Editing;
use super::view::Tab;
use crate::design::KeyPath;

/// Where one is in a table, and what of it is in sight.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Cursor {
    pub row: usize,
    pub column: usize,
    /// The first line and the first column in sight, known after the first frame
    pub top: usize,
    pub left: usize,
    /// Rows in sight
    pub height: usize,
}

impl Editing {
    /// Keeps the cursor on a place that there is.
    pub(super) fn hold_cursor(&mut self) {
        let Cursor { row, column, .. } = self.cursor();
        let row = row.min(self.view.rows.len().saturating_sub(1));
        let places = self.view.rows.get(row).map_or(0, |row| row.places.len());
        let free = (0..places).filter(|&at| self.view.place(row, at).is_some());
        let column = free.min_by_key(|&at| at.abs_diff(column)).unwrap_or(0);
        let cursor = self.cursor_mut();
        (cursor.row, cursor.column) = (row, column);
    }

    pub fn move_rows(&mut self, by: isize) {
        let last = self.view.rows.len().saturating_sub(1);
        let cursor = self.cursor_mut();
        cursor.row = cursor.row.saturating_add_signed(by).min(last);
        self.hold_cursor();
    }

    /// A page; one row stays in sight.
    pub fn page(&self) -> isize {
        self.cursor().height.saturating_sub(1).max(1).cast_signed()
    }

    /// To the next place of the row that the row has, if there is one.
    pub fn move_columns(&mut self, by: isize) -> bool {
        let Cursor { row, column, .. } = self.cursor();
        let places = self.view.rows.get(row).map_or(0, |row| row.places.len());
        let is_there = |at: &usize| self.view.place(row, *at).is_some();
        let next =
            if by < 0 { (0..column.min(places)).rev().find(is_there) } else { (column + 1..places).find(is_there) };
        if let Some(next) = next {
            self.cursor_mut().column = next;
        }
        next.is_some()
    }

    pub fn move_to_end(&mut self, last: bool) {
        self.cursor_mut().column = if last { usize::MAX } else { 0 };
        self.hold_cursor();
    }

    /// To the next cell; after the last of a row to the first of the next row.
    pub fn next_cell(&mut self, by: isize) {
        if self.move_columns(by) {
            return;
        }
        let row = self.cursor().row;
        self.move_rows(by);
        if self.cursor().row != row {
            self.move_to_end(by < 0);
        }
    }

    /// Shows the value or the row of a key path with the cursor on it.
    pub fn go_to(&mut self, path: &KeyPath) {
        let (tab, side) = Tab::of(path);
        self.layer = None;
        self.show(tab, side.unwrap_or(self.side));
        if let Some((row, column)) = self.view.find(path) {
            let cursor = self.cursor_mut();
            cursor.row = row;
            cursor.column = column.unwrap_or(cursor.column);
        }
        self.hold_cursor();
    }
}
