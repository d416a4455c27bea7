//! A line of text while it is typed: `/over▏`, `[7.5e8 N/m▏   ]`.

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::tui::text_field::TextField;
use crate::tui::theme::Theme;

/// Draws a prompt and the text after it; returns where the cursor stands, and the column after the text.
pub fn prompted(
    (prompt, prompt_style): (&str, Style),
    (field, style): (&TextField, Style),
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) -> Option<(Position, u16)> {
    if area.is_empty() {
        return None;
    }
    let (x, y) = buffer.set_stringn(area.x, area.y, prompt, usize::from(area.width), prompt_style);
    let room = usize::from(area.right().saturating_sub(x));
    let (shown, column) = field.shown(room, theme.glyphs.ellipsis);
    let style = if field.is_selected() { theme.selected } else { style };
    let (end, _) = buffer.set_stringn(x, y, shown, room, style);
    Some((Position::new((x + column as u16).min(area.right() - 1), y), end))
}

/// Draws the text in brackets; returns where the cursor stands.
pub fn bracketed(field: &TextField, theme: &Theme, area: Rect, buffer: &mut Buffer) -> Position {
    let room = usize::from(area.width).saturating_sub(2);
    let (shown, column) = field.shown(room, theme.glyphs.ellipsis);
    let gap = " ".repeat(room.saturating_sub(shown.width()));
    buffer.set_stringn(area.x, area.y, format!("[{shown}{gap}]"), usize::from(area.width), theme.title);
    if field.is_selected() {
        let text = Rect { x: area.x + 1, width: shown.width() as u16, height: 1, ..area };
        buffer.set_style(text.intersection(area), theme.selected);
    }
    Position::new(area.x + (1 + column as u16).min(area.width.saturating_sub(1)), area.y)
}
