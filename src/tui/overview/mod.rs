//! All designs of the library in one table: what the library knows of each, in an order of its own.

mod column;
mod outline;

use std::cmp::Ordering;
use std::path::{Path, PathBuf};

pub use column::Column;
pub use outline::{SPAN_DB, outline, sparks};

use super::action::Action;
use super::app::{App, Scroll};
use super::keymap::Mode;
use super::library::{Row, RowState};
use super::message::Effect;
use super::text_field::TextField;
use crate::text::printable;

/// The order of the table, and where the cursor is.
#[derive(Debug, Default)]
pub struct Overview {
    /// What the designs are ordered by.
    pub column: Column,
    /// Whether in the direction that the column is not read in first.
    pub reversed: bool,
    cursor: Option<PathBuf>,
    pub scroll: Scroll,
}

impl Overview {
    /// Rows of a page.
    pub fn page(&self) -> isize {
        self.scroll.page()
    }
}

impl App {
    /// Does an action of the screen, or opens it; nothing where the action is another's.
    pub(super) fn act_in_overview(&mut self, action: Action) -> Option<Vec<Effect>> {
        let is_filtering = self.mode == Mode::Filter && self.below.contains(&Mode::Overview);
        match (action, self.mode) {
            (Action::Overview, _) => {
                self.overview.cursor = self.library.selected().map(|row| row.path.clone());
                self.open(Mode::Overview);
            }
            (Action::SortColumn, Mode::Overview) => {
                self.overview.column = self.overview.column.next();
                self.overview.reversed = false;
            }
            (Action::SortDirection, Mode::Overview) => self.overview.reversed = !self.overview.reversed,
            (Action::ShowDesign, Mode::Overview) => {
                let path = self.overview_rows().get(self.overview_cursor()).map(|row| row.path.clone());
                self.library.select(&path?);
                self.close();
                return Some(self.follow_selection());
            }
            (Action::Filter, Mode::Overview) => {
                self.open(Mode::Filter);
                return Some(self.edit_filter(TextField::end));
            }
            (Action::KeepFilter, _) if is_filtering => self.close(),
            // the filter goes first, as in the list of designs
            (Action::Back, Mode::Overview) if self.library.filter().is_empty() => self.close(),
            (Action::Back, mode) if is_filtering || mode == Mode::Overview => {
                if is_filtering {
                    self.close();
                }
                return Some(self.edit_filter(|filter| *filter = TextField::default()));
            }
            _ => return None,
        }
        Some(Vec::new())
    }

    /// The designs that match the library's filter, as they are ordered; those without the figure come last.
    pub fn overview_rows(&self) -> Vec<&Row> {
        let Overview { column, reversed, .. } = self.overview;
        let mut rows: Vec<&Row> = self.library.matching().collect();
        rows.sort_by(|a, b| match (column.figure(a), column.figure(b)) {
            (Some(a), Some(b)) if reversed => a.total_cmp(&b),
            (Some(a), Some(b)) => b.total_cmp(&a),
            (Some(_), None) => Ordering::Less,
            (None, Some(_)) => Ordering::Greater,
            (None, None) if column == Column::Design && reversed => b.stem.cmp(&a.stem),
            (None, None) => a.stem.cmp(&b.stem),
        });
        rows
    }

    /// Place of the cursor among the rows: the design that was chosen, else the first.
    pub fn overview_cursor(&self) -> usize {
        let chosen: Option<&Path> = self.overview.cursor.as_deref();
        self.overview_rows().iter().position(|row| Some(row.path.as_path()) == chosen).unwrap_or(0)
    }

    pub(super) fn move_in_overview(&mut self, by: isize) {
        let rows = self.overview_rows();
        let place = self.overview_cursor().saturating_add_signed(by).min(rows.len().saturating_sub(1));
        self.overview.cursor = rows.get(place).map(|row| row.path.clone());
    }

    /// The table as lines with tabs, for a spreadsheet.
    pub(super) fn overview_text(&self) -> String {
        let head = Column::ALL.map(Column::name).join("\t");
        let lines = self.overview_rows().into_iter().map(|row| match reason(row) {
            Some(reason) => format!("{}\t{reason}", row.stem),
            None => Column::ALL.map(|column| column.shown(row)).join("\t"),
        });
        std::iter::once(head).chain(lines).collect::<Vec<_>>().join("\n")
    }
}

/// Why a design has no figures, in one line that is safe to show.
pub fn reason(row: &Row) -> Option<String> {
    let text = match &row.state {
        RowState::Broken(broken) => &broken.one_line,
        RowState::Unsolvable(message) => message,
        _ => return None,
    };
    Some(printable(text.lines().next().unwrap_or_default()).into_owned())
}
