//! A value while it is typed, over its cell, with what is wrong with it.
//!
//! ```text
//!    [7.5e8 N/m▏   ]
//!    unknown unit `x`; accepted: N/m, N/mm
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use unicode_width::UnicodeWidthStr;

use super::text_line::bracketed;
use crate::text::{cut, printable, wrap};
use crate::tui::editor::Input;
use crate::tui::theme::Theme;

/// Narrowest box, so that there is room for a unit.
const NARROWEST: u16 = 18;

/// Draws the box over `cell`, inside of `area`; returns where the cursor stands.
pub fn render(input: &Input, cell: Rect, theme: &Theme, area: Rect, buffer: &mut Buffer) -> Position {
    let width = cell.width.max(NARROWEST).min(area.width);
    let x = cell.x.min(area.right().saturating_sub(width));
    let place = Rect { x, y: cell.y, width, height: 1 };
    clear_remnant(place, area, buffer);
    let cursor = bracketed(&input.line, theme, place, buffer);
    if input.is_selected {
        let text = input.line.text().width().min(usize::from(width.saturating_sub(2)));
        buffer.set_style(Rect { x: x + 1, width: text as u16, ..place }.intersection(area), theme.selected);
    }
    if let Some(error) = &input.error {
        draw_error(error, place, theme, area, buffer);
    }
    cursor
}

/// Of a value that the box covers in part nothing stays behind it.
fn clear_remnant(place: Rect, area: Rect, buffer: &mut Buffer) {
    let is_blank = |x: u16| buffer.cell((x, place.y)).is_none_or(|cell| cell.symbol() == " ");
    let right = place.right();
    if right >= area.right() || is_blank(right - 1) {
        return;
    }
    // between two values there are more blanks than within one
    let end = (right..area.right()).find(|&x| is_blank(x) && (x + 1 >= area.right() || is_blank(x + 1)));
    for x in right..end.unwrap_or(area.right()) {
        if let Some(cell) = buffer.cell_mut((x, place.y)) {
            cell.reset();
        }
    }
}

/// Beside the box if there is room, else below or above it.
fn draw_error(error: &str, place: Rect, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let text = format!(" {} {} ", theme.glyphs.broken, printable(error));
    let beside = usize::from(area.right().saturating_sub(place.right()));
    if text.width() <= beside {
        buffer.set_stringn(place.right(), place.y, text, beside, theme.error);
        return;
    }
    let width = usize::from(area.width);
    let lines: Vec<String> = wrap(text.trim(), width.saturating_sub(2)).into_iter().take(3).collect();
    let widest = lines.iter().map(|line| line.width()).max().unwrap_or(0) + 2;
    let x = place.x.min(area.right().saturating_sub(widest as u16)).max(area.x);
    let below = place.y + 1 + lines.len() as u16 <= area.bottom();
    let first = if below { place.y + 1 } else { place.y.saturating_sub(lines.len() as u16) };
    for (line, y) in lines.iter().zip(first..area.bottom()) {
        if y >= area.y {
            let line = format!(" {} ", cut(line, width.saturating_sub(2), theme.glyphs.ellipsis));
            buffer.set_stringn(x, y, format!("{line:<widest$}"), width, theme.error);
        }
    }
}
