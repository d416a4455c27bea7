//! All bearings of a design under load, a row each.
//!
//! ```text
//!   bearing             mm  model     load by     Fx N     Fy N     Fz N    |F| N    loaded   most N  angle deg
//! ▌ pinion head bea   55.0  roller     torque   -8,123   12,410    6,001   16,000  17 of 17    1,400       20.0
//!   gear B1           85.0  diagonal        -        -        -        -        -         -        -          -
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::number::{grouped, significant};
use crate::text::{cut, printable};
use crate::tui::bearings::{BearingRow, BearingsView, angles, failure_of, load, resultant};
use crate::tui::theme::Theme;

/// The least columns for shaft and name.
const NAME: usize = 15;

/// A column: its heading, its width, and how soon it goes where there is little room (0 stays).
struct Column(&'static str, usize, u8);

const COLUMNS: [Column; 10] = [
    Column("mm", 8, 2),
    Column("model", 10, 3),
    Column("load by", 9, 6),
    Column("Fx N", 9, 0),
    Column("Fy N", 9, 0),
    Column("Fz N", 9, 0),
    Column("|F| N", 9, 1),
    Column("loaded", 10, 0),
    Column("most N", 8, 5),
    Column("angle deg", 11, 4),
];

/// Draws heading and rows; the view's scroll follows the cursor. `failure` is why the design cannot be solved.
pub fn render(
    view: &mut BearingsView,
    rows: &[BearingRow<'_>],
    failure: Option<&str>,
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) {
    if area.height == 0 {
        return;
    }
    view.scroll.fit(rows.len(), usize::from(area.height).saturating_sub(1));
    view.scroll.show(view.cursor);
    let width = usize::from(area.width);
    let shown = shown(width);
    let used: usize = shown.iter().map(|column| column.1).sum();
    let room = width.saturating_sub(used + 3);
    let heading: Vec<String> = shown.iter().map(|column| format!("{:>1$}", column.0, column.1)).collect();
    let heading = heading.concat();
    buffer.set_stringn(area.x, area.y, format!("  {:<room$}{heading}", "bearing"), width, theme.faint);
    for ((at, row), y) in rows.iter().enumerate().skip(view.scroll.top).zip(area.y + 1..area.bottom()) {
        let is_selected = at == view.cursor;
        let code = failure.and_then(|reason| failure_of(reason, row));
        let style = match (is_selected, code) {
            (true, _) => theme.selected,
            (false, Some(_)) => theme.error,
            _ => Style::new(),
        };
        let marker = match (is_selected, code) {
            (true, _) => theme.glyphs.selected,
            (false, Some(_)) => theme.glyphs.broken,
            _ => " ",
        };
        buffer.set_style(Rect::new(area.x, y, area.width, 1), style);
        let name = format!("{} {}", row.side.name(), printable(&row.bearing.name));
        let name = cut(&name, room, theme.glyphs.ellipsis);
        let gap = " ".repeat(room.saturating_sub(name.width()));
        let figures = || shown.iter().map(|column| format!("{:>1$}", figure(column.0, row), column.1)).collect();
        let figures = code.map_or_else(figures, |code| vec![format!("  {code}")]).concat();
        buffer.set_stringn(area.x, y, format!("{marker} {name}{gap}{figures}"), width, style);
    }
}

/// The columns that there is room for.
fn shown(width: usize) -> Vec<&'static Column> {
    let mut shown: Vec<&Column> = COLUMNS.iter().collect();
    let mut used: usize = shown.iter().map(|column| column.1).sum();
    for soon in 1..=6 {
        if used + NAME + 3 > width {
            shown.retain(|column| column.2 != soon);
            used = shown.iter().map(|column| column.1).sum();
        }
    }
    shown
}

fn figure(column: &str, row: &BearingRow<'_>) -> String {
    match column {
        "mm" => return significant(row.bearing.position * 1e3, 4),
        "model" => return row.bearing.model.word().into(),
        "load by" => return row.bearing.model.loaded_by().unwrap_or("-").into(),
        _ => {}
    }
    let Some(rolling) = row.rolling else { return "-".into() };
    let (load, state) = (load(rolling), &rolling.state);
    match column {
        "Fx N" => grouped(load[0]),
        "Fy N" => grouped(load[1]),
        "Fz N" => grouped(load[2]),
        "|F| N" => grouped(resultant(&load)),
        "loaded" => format!("{} of {}", state.loaded(), state.contacts.len()),
        "most N" => grouped(state.greatest_load()),
        _ => angles(state),
    }
}
