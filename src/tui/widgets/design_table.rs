//! The table of all designs: marks, a spectrum in a line of text, and figures.
//!
//! ```text
//!                              enh.    enh.     basic   basic FE peak FE peak
//!  design       FE spectrum limit Hz RMS dB  limit Hz  RMS dB      Hz       N
//! ▌overhung *   ▁▁▂█▃▁▂▅▁▁     2,997   3.72       236   10.13   1,180  10,312
//!  worn !       ▁▁▂█▃▁▂▅▁▁     2,754   4.01       236   10.13   1,175  10,104
//!  typo         × line 14: unknown key
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::text::cut;
use crate::tui::app::App;
use crate::tui::library::{Row, RowState};
use crate::tui::overview::{Column, reason, sparks};
use crate::tui::solving::Summary;
use crate::tui::theme::Theme;

/// Rows of the heading.
pub const HEAD: u16 = 2;

/// The fewest columns in which a spectrum can be told from another one.
const LEAST_SPARKS: usize = 8;
/// The fewest columns of a name.
const LEAST_NAME: usize = 12;

/// One scale for the spectra of all designs, so that rows can be compared.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// The highest level, dB re 1 N; none where no design is solved
    pub top: Option<f64>,
    /// The frequencies, Hz, where all have the same
    pub band: Option<[f64; 2]>,
}

impl Scale {
    /// Of the designs that are listed.
    pub fn of(rows: &[&Row]) -> Self {
        let levels = rows.iter().filter_map(|row| solved(row)).flat_map(|summary| summary.fe_outline.iter().copied());
        let top = levels.filter(|level| level.is_finite()).fold(f64::NEG_INFINITY, f64::max);
        let mut bands = rows.iter().filter(|row| solved(row).is_some()).filter_map(|row| {
            let analysis = &row.loaded.as_ref()?.design.analysis;
            Some([analysis.frequency_min, analysis.frequency_max])
        });
        let band = bands.next().filter(|first| bands.all(|band| band == *first));
        Self { top: top.is_finite().then_some(top), band }
    }
}

/// What is known of a design that was solved.
pub fn solved(row: &Row) -> Option<&Summary> {
    match &row.state {
        RowState::Solved(summary) => Some(summary),
        _ => None,
    }
}

/// Whether something about it looks unintended.
pub fn is_warned(row: &Row) -> bool {
    row.warnings().next().is_some()
}

/// Whether a table of this width has spectra in it.
pub fn has_spectra(width: u16) -> bool {
    Widths::new(usize::from(width), LEAST_NAME).sparks > 0
}

/// Draws heading and rows; the scroll follows the cursor already.
pub fn render(app: &App, cursor: usize, scale: &Scale, area: Rect, buffer: &mut Buffer) {
    let theme = &app.theme;
    let width = usize::from(area.width);
    let rows = app.overview_rows();
    let longest = rows.iter().map(|row| row.stem.width() + marks(row).width()).max().unwrap_or(0);
    let widths = Widths::new(width, longest);
    for (line, y) in (0..2).zip(area.top()..area.bottom()) {
        buffer.set_stringn(area.x, y, widths.head(line, app), width, theme.faint);
    }
    if rows.is_empty() {
        let text = if app.library.is_empty() { " no designs" } else { " no design matches the filter" };
        buffer.set_stringn(area.x, area.y + HEAD, text, width, theme.faint);
    }
    for ((at, row), y) in rows.iter().enumerate().skip(app.overview.scroll.top).zip(area.y + HEAD..area.bottom()) {
        let is_selected = at == cursor;
        let style = match (&row.state, is_selected) {
            (_, true) => theme.selected,
            (RowState::Broken(_) | RowState::Unsolvable(_), false) => theme.error,
            (RowState::Pending | RowState::Loaded, false) => theme.faint,
            _ => Style::new(),
        };
        let marker = if is_selected { theme.glyphs.selected } else { " " };
        buffer.set_style(Rect::new(area.x, y, area.width, 1), style);
        buffer.set_stringn(area.x, y, format!("{marker}{}", widths.row(row, scale, theme)), width, style);
    }
}

/// Unsaved edits and warnings, after the name.
fn marks(row: &Row) -> String {
    let unsaved = if row.unsaved { " *" } else { "" };
    let warned = if is_warned(row) { " !" } else { "" };
    format!("{unsaved}{warned}")
}

/// Widths of name and spectrum, and the columns that there is room for.
struct Widths {
    name: usize,
    /// None where names need the room.
    sparks: usize,
    figures: Vec<Column>,
    all: usize,
}

impl Widths {
    fn new(all: usize, longest_name: usize) -> Self {
        let mut figures = Column::ALL[1..].to_vec();
        // with little room the least telling figure goes
        if all < 76 {
            figures.retain(|column| *column != Column::BasicRms);
        }
        let taken: usize = figures.iter().map(|column| column.width()).sum();
        let left = all.saturating_sub(1 + taken);
        if left <= LEAST_NAME + LEAST_SPARKS {
            return Self { name: left, sparks: 0, figures, all };
        }
        // names give way to the spectrum down to three fifths
        let most = (left * 3 / 5).clamp(LEAST_NAME, left - 1 - LEAST_SPARKS);
        let name = longest_name.clamp(LEAST_NAME, most);
        Self { name, sparks: left - name - 1, figures, all }
    }

    fn line(&self, name: &str, sparks: &str, figures: impl Iterator<Item = String>) -> String {
        let gap = " ".repeat(self.name.saturating_sub(name.width()) + usize::from(self.sparks > 0));
        let figures: Vec<String> =
            figures.zip(&self.figures).map(|(figure, column)| format!("{figure:>0$}", column.width())).collect();
        format!("{name}{gap}{sparks:<0$}{1}", self.sparks, figures.concat())
    }

    fn head(&self, line: usize, app: &App) -> String {
        let mark = |column: Column| {
            if line == 1 && column == app.overview.column { direction_mark(app) } else { "" }
        };
        let figures = self.figures.iter().map(|column| format!("{}{}", mark(*column), column.heads()[line]));
        let name = format!("{}{}", Column::Design.heads()[line], mark(Column::Design));
        let sparks = ["FE spectrum", "FE"].into_iter().find(|head| line == 1 && head.len() <= self.sparks);
        format!(" {}", self.line(&name, sparks.unwrap_or_default(), figures))
    }

    fn row(&self, row: &Row, scale: &Scale, theme: &Theme) -> String {
        let (ellipsis, marks) = (theme.glyphs.ellipsis, marks(row));
        // the marks are never cut off
        let name = format!("{}{marks}", cut(&row.stem, self.name.saturating_sub(marks.width()), ellipsis));
        match (solved(row), reason(row)) {
            (Some(summary), _) => {
                let top = scale.top.unwrap_or_default();
                let sparks = sparks(&summary.fe_outline, top, self.sparks, theme.glyphs.ascii);
                self.line(&name, &sparks, self.figures.iter().map(|column| column.shown(row)))
            }
            (_, Some(reason)) => {
                let gap = " ".repeat(self.name.saturating_sub(name.width()) + 1);
                let room = self.all.saturating_sub(1 + name.width() + gap.len());
                let reason = cut(&format!("{} {reason}", theme.glyphs.broken), room, ellipsis);
                format!("{name}{gap}{reason}")
            }
            _ => self.line(&name, "", self.figures.iter().map(|_| ellipsis.to_owned())),
        }
    }
}

fn direction_mark(app: &App) -> &'static str {
    let is_up = (app.overview.column == Column::Design) != app.overview.reversed;
    match (app.theme.glyphs.ascii, is_up) {
        (true, true) => "^",
        (true, false) => "v",
        (false, true) => "▲",
        (false, false) => "▼",
    }
}
