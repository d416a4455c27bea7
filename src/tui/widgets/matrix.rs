//! The stiffness matrix of a bearing.
//!
//! ```text
//! ┌ stiffness of pinion bearing B1 ───────────────────────────────┐
//! │            x        y        z      thx      thy      thz     │
//! │ x     [4.0e8]     0.0      0.0      0.0      0.0      0.0     │
//! │ y        0.0    2.5e8      0.0      0.0      0.0      0.0     │
//! └ row x, column x: N/m; the mirrored entry changes with it ─────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use super::panel::{self, Title};
use super::table::{mark, severity_mark};
use super::{cell_input, findings};
use crate::text::{cut, printable, wrap};
use crate::tui::editor::{Editing, Entry, shown_text};
use crate::tui::theme::Theme;

const NAMES: [&str; 6] = ["x", "y", "z", "thx", "thy", "thz"];
const LABEL: u16 = 5;

/// Draws the matrix of the bearing under the cursor at the top of `area`, so that the spectra stay in sight; returns where the cursor stands if an entry is
/// typed into.
pub fn render(editing: &Editing, entry: Entry, theme: &Theme, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let row = editing.cursor().row;
    let text = |i: usize, j: usize| {
        editing.view.matrix_entry(row, (i, j)).map_or(String::new(), |cell| shown_text(&cell.shown))
    };
    let widest = (0..36).map(|at| text(at / 6, at % 6).width()).max().unwrap_or(0);
    let room = area.width.saturating_sub(2 + LABEL) / 6;
    let column = (widest as u16 + 3).max(8).min(room).max(3);
    let width = (column * 6 + LABEL + 2).min(area.width);
    let mut about: Vec<(String, Style)> = Vec::new();
    for &at in &editing.view.findings(row, matrix_column(editing)) {
        let Some(finding) = editing.findings().get(at) else { continue };
        let (mark, style) = severity_mark(finding.severity, theme);
        let lines = wrap(&format!("{mark} {}", findings::sentence(finding)), usize::from(width.saturating_sub(4)));
        about.extend(lines.into_iter().map(|line| (line, style)));
    }
    let height = (9 + about.len() as u16).min(area.height);
    let window = Rect { x: area.x + (area.width - width) / 2, y: area.y, width, height };
    panel::clear(window, buffer);
    let name = editing.view.row(row).map_or(String::new(), |row| printable(&row.label).into_owned());
    let title = format!("stiffness of {} bearing {name}", editing.side.name());
    let inner = panel::frame(window, buffer, &Title::left(title), true, theme);

    let cell = |i: usize, j: usize| {
        let x = inner.x + LABEL + column * j as u16;
        Rect { x, y: inner.y + 1 + i as u16, width: column, height: 1 }.intersection(inner)
    };
    for (j, label) in NAMES.iter().enumerate() {
        let place = cell(0, j);
        let room = usize::from(place.width.saturating_sub(2));
        buffer.set_stringn(place.x + 1, inner.y, format!("{label:>room$}"), room, theme.faint);
    }
    let mut cursor = None;
    for (i, label) in NAMES.iter().enumerate() {
        if inner.y + 1 + i as u16 >= inner.bottom() {
            break;
        }
        buffer.set_stringn(inner.x + 1, inner.y + 1 + i as u16, label, 4, theme.faint);
        for j in 0..6 {
            let place = cell(i, j);
            let selected = (i, j) == (entry.row, entry.column);
            let mirrored = (j, i) == (entry.row, entry.column) && i != j;
            let room = usize::from(place.width.saturating_sub(3));
            let shown = cut(&text(i, j), room, theme.glyphs.ellipsis);
            let gap = " ".repeat(room.saturating_sub(shown.width()));
            let (open, close) = match (selected, mirrored) {
                (true, _) => ("[", "]"),
                // changes with the one under the cursor
                (_, true) => ("{", "}"),
                _ => (" ", " "),
            };
            let style = if selected { theme.selected } else { Style::new() };
            buffer.set_stringn(place.x, place.y, format!("{open}{gap}{shown}{close}"), room + 2, style);
            let cell = editing.view.matrix_entry(row, (i, j));
            // a finding about the matrix as a whole stands below it
            let own = cell.map_or(Vec::new(), |cell| {
                let own = |at: &usize| editing.findings().get(*at).is_some_and(|finding| finding.key_path == cell.path);
                cell.findings.iter().copied().filter(own).collect::<Vec<_>>()
            });
            if let Some((mark, style)) = mark(editing.findings(), &own, theme) {
                buffer.set_stringn(place.right().saturating_sub(1), place.y, mark, 1, style);
            }
        }
    }
    for ((line, style), y) in about.iter().zip(inner.y + 7..inner.bottom()) {
        buffer.set_stringn(inner.x + 1, y, line, usize::from(inner.width.saturating_sub(2)), *style);
    }
    let unit = editing.entry().map_or("", |cell| cell.column.unit);
    let place = format!("row {}, column {}: {unit}", NAMES[entry.row.min(5)], NAMES[entry.column.min(5)]);
    let left = vec![format!("{place}; the mirrored entry changes with it"), place];
    panel::bottom(window, buffer, &Title { left, right: Vec::new() }, true, theme);
    if let Some(input) = &editing.input {
        cursor = Some(cell_input::render(input, cell(entry.row, entry.column), theme, inner, buffer));
    }
    cursor
}

fn matrix_column(editing: &Editing) -> usize {
    let row = editing.cursor().row;
    let columns = 0..editing.view.columns.len();
    columns.into_iter().find(|&at| editing.view.place(row, at) == Some(crate::tui::editor::Place::Matrix)).unwrap_or(0)
}
