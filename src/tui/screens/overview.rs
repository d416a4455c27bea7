//! All designs of the library with their figures.
//!
//! ```text
//!  header
//! ┌ Overview 2 of 7, by enhanced limit ─────────────────────────────┐
//! │                              enh.   enh.    basic  basic FE peak │
//! │ design       FE spectrum limit Hz RMS dB limit Hz RMS dB      Hz │
//! │▌overhung     ▁▁▂█▃▁▂▅▁▁     2,997   3.72      236  10.13   1,180 │
//! │ typo         × line 14: unknown key                              │
//! ├ overhung: FE mesh force, dB re 1 N ─────────────────────────────┤
//! │ its spectrum, where the list leaves room                         │
//! └ spectra: 41 to 81 dB re 1 N, each over its own frequencies ─────┘
//!  enhanced: trust up to ...
//!     basic: ...            or what is wrong with the design under the cursor
//!  footer
//! ```

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;

use crate::text::{printable, wrap};
use crate::tui::app::App;
use crate::tui::keymap::Mode;
use crate::tui::library::{Row, RowState};
use crate::tui::overview::{Column, SPAN_DB, reason};
use crate::tui::theme::Theme;
use crate::tui::widgets::design_table::{self, Scale, is_warned, solved};
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::{figures, footer, header, outline_plot};

/// The fewest and the most rows that the picture of one spectrum takes.
const PICTURE: std::ops::RangeInclusive<u16> = 7..=16;

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
    // one line more than the rows: whatever is selected, the picture stays
    let wanted = (count + 1).min(usize::from(u16::MAX)) as u16 + design_table::HEAD;
    let picture = inner.height.saturating_sub(wanted).min(*PICTURE.end());
    let picture = if PICTURE.contains(&picture) { picture } else { 0 };
    let table = Rect { height: inner.height - picture, ..inner };
    app.overview.scroll.fit(count, usize::from(table.height.saturating_sub(design_table::HEAD)));
    app.overview.scroll.show(cursor);
    let scale = Scale::of(&app.overview_rows());
    design_table::render(app, cursor, &scale, table, buffer);
    if let Some(chosen) = app.overview_rows().get(cursor) {
        render_picture(chosen, &theme, (body, Rect { y: table.bottom(), height: picture, ..inner }), buffer);
        render_chosen(chosen, &theme, row(area.height - 1 - figures::HEIGHT, figures::HEIGHT), buffer);
        panel::bottom(body, buffer, &bottom(chosen, &scale, &theme, inner.width), app.mode == Mode::Overview, &theme);
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

/// What the lines of shades mean, and what the marks of the chosen design say.
fn bottom(chosen: &Row, scale: &Scale, theme: &Theme, width: u16) -> Title<'static> {
    let Some(top) = scale.top else { return Title::default() };
    let levels = format!("{:.0} to {top:.0} dB re 1 N", top - SPAN_DB);
    let over = match scale.band {
        Some([low, high]) => format!("{} to {} Hz", crate::number::grouped(low), crate::number::grouped(high)),
        None => "each over its own frequencies".into(),
    };
    let long = format!("spectra: {levels}, {over}");
    let mut marks = Vec::new();
    if chosen.unsaved {
        marks.push("* edits not saved, not in the figures".to_owned());
    }
    if is_warned(chosen) {
        marks.push(format!("! {}", warnings(chosen).join("; ")));
    }
    let mut left = Vec::new();
    // the marks explain what stands in the row; the scale is the same for all
    if !marks.is_empty() {
        let marks = marks.join("; ");
        left.extend([format!("{long} {} {marks}", theme.glyphs.separator), marks]);
    } else if design_table::has_spectra(width) {
        left.extend([long, levels]);
    }
    Title { left, right: Vec::new() }
}

fn warnings(row: &Row) -> Vec<String> {
    row.warnings().map(|warning| printable(warning).into_owned()).collect()
}

/// The chosen design's spectrum, where there is room.
fn render_picture(row: &Row, theme: &Theme, (frame, area): (Rect, Rect), buffer: &mut Buffer) {
    if area.height == 0 {
        return;
    }
    let name = if row.name() == row.stem { row.stem.clone() } else { format!("{}: {}", row.stem, row.name()) };
    let what = if solved(row).is_some() { "FE mesh force, dB re 1 N" } else { "no spectrum" };
    let title = Title { left: vec![format!("{name}, {what}"), what.to_owned()], right: Vec::new() };
    panel::divider(frame, buffer, area.y, &title, theme);
    if let Some(summary) = solved(row)
        && let Some(loaded) = &row.loaded
    {
        let below = Rect { y: area.y + 1, height: area.height - 1, ..area };
        outline_plot::render(&summary.fe_outline, &loaded.design.analysis, theme, below, buffer);
    }
}

/// How far its models can be trusted, or the whole reason why it has no figures.
fn render_chosen(row: &Row, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if let Some(summary) = solved(row) {
        return figures::render_models(summary, None, theme, area, buffer);
    }
    let text = match &row.state {
        RowState::Broken(broken) => broken.one_line.clone(),
        RowState::Unsolvable(message) => message.clone(),
        _ => reason(row).unwrap_or_else(|| row.name()),
    };
    for (line, y) in wrap(&text, usize::from(area.width).saturating_sub(2)).iter().zip(area.top()..area.bottom()) {
        buffer.set_stringn(area.x + 1, y, printable(line), usize::from(area.width.saturating_sub(1)), Style::new());
    }
}
