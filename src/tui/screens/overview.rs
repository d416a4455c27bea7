//! All designs of the library with their figures.
//!
//! ```text
//!  header
//! ┌ Overview 2 of 7, by enhanced limit ─────────────────────────────┐
//! │                              enh.   enh.    basic  basic FE peak │
//! │ design       FE spectrum limit Hz RMS dB limit Hz RMS dB      Hz │
//! │▌overhung     ▁▁▂█▃▁▂▅▁▁     2,997   3.72      236  10.13   1,180 │
//! │ typo         × line 14: unknown key                              │
//! └──────────────────────────────────────────────────────────────────┘
//!  what is wrong with the design under the cursor, or its name
//!  footer
//! ```

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::text::{cut, printable, wrap};
use crate::tui::app::App;
use crate::tui::keymap::Mode;
use crate::tui::library::{Row, RowState};
use crate::tui::overview::{Column, reason, sparks};
use crate::tui::theme::Theme;
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::{figures, footer, header};

/// Draws the screen over the whole frame.
pub fn render(app: &mut App, frame: &mut Frame) -> Option<Position> {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    let row = |y: u16, height: u16| Rect { y: area.y + y, height, ..area };
    let theme = app.theme;
    header::render_named(&format!("overview of {}", printable(&app.shown_as)), &theme, row(0, 1), buffer);
    let body = super::body(area);
    let inner = panel::frame(body, buffer, &title(app), app.mode == Mode::Overview, &theme);
    let (cursor, count) = (app.overview_cursor(), app.library.matches());
    app.overview.scroll.fit(count, usize::from(inner.height).saturating_sub(2));
    app.overview.scroll.show(cursor);
    render_rows(app, cursor, inner, buffer);
    if let Some(chosen) = app.overview_rows().get(cursor) {
        let place = row(area.height - 1 - figures::HEIGHT, figures::HEIGHT);
        render_chosen(chosen, place, buffer);
    }
    footer::render(app, row(area.height - 1, 1), buffer)
}

fn title(app: &App) -> Title<'static> {
    let (count, filter) = (app.library.matches(), printable(app.library.filter()));
    let place = if count == 0 { 0 } else { app.overview_cursor() + 1 };
    let direction = match (app.overview.column == Column::Design, app.overview.reversed) {
        (true, false) | (false, true) => "ascending",
        _ => "descending",
    };
    let order = format!("by {}, {direction}", app.overview.column.name());
    let found = if filter.is_empty() && app.mode != Mode::Filter {
        format!("Overview {place} of {count}")
    } else {
        format!("Overview /{filter}  {place} of {count} matches")
    };
    Title { left: vec![format!("{found}, {order}"), order, "Overview".into()], right: Vec::new() }
}

/// Widths of name and spectrum, and the columns that there is room for.
struct Widths {
    name: usize,
    sparks: usize,
    figures: Vec<Column>,
}

impl Widths {
    fn new(all: usize) -> Self {
        let mut figures = Column::ALL[1..].to_vec();
        // with little room the least telling figure goes
        if all < 76 {
            figures.retain(|column| *column != Column::BasicRms);
        }
        let taken: usize = figures.iter().map(|column| column.width()).sum();
        let left = all.saturating_sub(1 + taken);
        let sparks = if left >= 20 { (left * 2 / 5).min(60) } else { 0 };
        Self { name: left.saturating_sub(sparks + usize::from(sparks > 0)), sparks, figures }
    }

    fn line(&self, name: &str, sparks: &str, figures: impl Iterator<Item = String>, theme: &Theme) -> String {
        let name = cut(name, self.name, theme.glyphs.ellipsis);
        let gap = " ".repeat(self.name.saturating_sub(name.width()) + usize::from(self.sparks > 0));
        let figures: Vec<String> =
            figures.zip(&self.figures).map(|(figure, column)| format!("{figure:>0$}", column.width())).collect();
        let figures = figures.concat();
        format!(" {name}{gap}{sparks:<0$}{figures}", self.sparks)
    }
}

fn render_rows(app: &App, cursor: usize, area: Rect, buffer: &mut Buffer) {
    let theme = &app.theme;
    let width = usize::from(area.width);
    let widths = Widths::new(width);
    let rows = app.overview_rows();
    for (line, y) in (0..2).zip(area.top()..area.bottom()) {
        let heads = widths.figures.iter().map(|column| {
            let mark = if line == 1 && *column == app.overview.column { direction_mark(app) } else { "" };
            format!("{mark}{}", column.heads()[line])
        });
        let own = if app.overview.column == Column::Design && line == 1 { direction_mark(app) } else { "" };
        let name = format!("{}{own}", Column::Design.heads()[line]);
        let sparks = if line == 1 { cut("FE spectrum", widths.sparks, "") } else { String::new() };
        buffer.set_stringn(area.x, y, widths.line(&name, &sparks, heads, theme), width, theme.faint);
    }
    // one scale for all, so that rows can be compared
    let outlines = rows.iter().filter_map(|row| solved(row)).flat_map(|summary| summary.fe_outline.iter().copied());
    let top = outlines.filter(|level| level.is_finite()).fold(f64::NEG_INFINITY, f64::max);
    if rows.is_empty() {
        let text = if app.library.is_empty() { " no designs" } else { " no design matches the filter" };
        buffer.set_stringn(area.x, area.y + 2, text, width, theme.faint);
    }
    for ((at, row), y) in rows.iter().enumerate().skip(app.overview.scroll.top).zip(area.y + 2..area.bottom()) {
        let is_selected = at == cursor;
        let style = match (&row.state, is_selected) {
            (_, true) => theme.selected,
            (RowState::Broken(_) | RowState::Unsolvable(_), false) => theme.error,
            (RowState::Pending | RowState::Loaded, false) => theme.faint,
            _ => Style::new(),
        };
        let name = if row.unsaved { format!("{} *", row.stem) } else { row.stem.clone() };
        let text = match (solved(row), reason(row)) {
            (Some(summary), _) => {
                let sparks = sparks(&summary.fe_outline, top, widths.sparks, theme.glyphs.ascii);
                widths.line(&name, &sparks, widths.figures.iter().map(|column| column.shown(row)), theme)
            }
            (_, Some(reason)) => {
                let line = widths.line(&name, "", std::iter::empty(), theme);
                let reason = format!("{} {reason}", theme.glyphs.broken);
                let start = line.trim_end().width() + 1;
                let start = start.max(widths.name + 2);
                let gap = " ".repeat(start.saturating_sub(line.trim_end().width()));
                format!("{}{gap}{}", line.trim_end(), cut(&reason, width.saturating_sub(start), theme.glyphs.ellipsis))
            }
            _ => {
                let dots = widths.figures.iter().map(|_| theme.glyphs.ellipsis.to_owned());
                widths.line(&name, "", dots, theme)
            }
        };
        let marker = if is_selected { theme.glyphs.selected } else { " " };
        buffer.set_style(Rect::new(area.x, y, area.width, 1), style);
        buffer.set_stringn(area.x, y, format!("{marker}{}", text.get(1..).unwrap_or_default()), width, style);
    }
}

fn solved(row: &Row) -> Option<&crate::tui::solving::Summary> {
    match &row.state {
        RowState::Solved(summary) => Some(summary),
        _ => None,
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

/// The whole reason where a design has no figures, else what it is called.
fn render_chosen(row: &Row, area: Rect, buffer: &mut Buffer) {
    let text = match &row.state {
        RowState::Broken(broken) => broken.one_line.clone(),
        RowState::Unsolvable(message) => message.clone(),
        _ => row.name(),
    };
    for (line, y) in wrap(&text, usize::from(area.width).saturating_sub(2)).iter().zip(area.top()..area.bottom()) {
        buffer.set_stringn(area.x + 1, y, printable(line), usize::from(area.width.saturating_sub(1)), Style::new());
    }
}
