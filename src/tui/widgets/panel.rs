//! Frames around the panes, with dividers where two panes share one.
//!
//! ```text
//! ┌ title ──────────────── right ┐
//! │                              │
//! ├ divider ─────────────────────┤
//! │                              │
//! └ bottom ──────────────────────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use ratatui::text::{Line, Span};
use unicode_width::UnicodeWidthStr;

use crate::text::cut;
use crate::tui::theme::Theme;

/// What stands in a line of the frame: the longest text on the left that fits beside what is on the right.
#[derive(Debug, Default)]
pub struct Title<'a> {
    /// Longest first.
    pub left: Vec<String>,
    pub right: Vec<Span<'a>>,
}

impl Title<'_> {
    /// A title with text on the left only.
    pub fn left(text: impl Into<String>) -> Self {
        Self { left: vec![text.into()], right: Vec::new() }
    }
}

/// Empties an area, for what is drawn over it.
pub fn clear(area: Rect, buffer: &mut Buffer) {
    let area = area.intersection(buffer.area);
    for y in area.top()..area.bottom() {
        for x in area.left()..area.right() {
            if let Some(cell) = buffer.cell_mut((x, y)) {
                cell.reset();
            }
        }
    }
}

/// Draws a frame and returns what is inside.
pub fn frame(area: Rect, buffer: &mut Buffer, title: &Title, focused: bool, theme: &Theme) -> Rect {
    if area.width < 2 || area.height < 2 {
        return Rect::new(area.x, area.y, 0, 0);
    }
    let style = if focused { theme.border_focused } else { theme.border };
    let glyphs = theme.glyphs;
    for y in area.top() + 1..area.bottom() - 1 {
        put(buffer, area.left(), y, glyphs.vertical, style);
        put(buffer, area.right() - 1, y, glyphs.vertical, style);
    }
    rule(area, buffer, area.top(), (glyphs.top_left, glyphs.top_right), title, style, theme);
    rule(area, buffer, area.bottom() - 1, (glyphs.bottom_left, glyphs.bottom_right), &Title::default(), style, theme);
    Rect::new(area.x + 1, area.y + 1, area.width - 2, area.height - 2)
}

/// Draws a line across the frame `area` at row `y`.
pub fn divider(area: Rect, buffer: &mut Buffer, y: u16, title: &Title, theme: &Theme) {
    if area.width >= 2 && (area.top()..area.bottom()).contains(&y) {
        let glyphs = theme.glyphs;
        rule(area, buffer, y, (glyphs.tee_left, glyphs.tee_right), title, theme.border, theme);
    }
}

/// Puts text into the frame's last line.
pub fn bottom(area: Rect, buffer: &mut Buffer, title: &Title, focused: bool, theme: &Theme) {
    if area.width >= 2 && area.height >= 2 {
        let style = if focused { theme.border_focused } else { theme.border };
        let ends = (theme.glyphs.bottom_left, theme.glyphs.bottom_right);
        rule(area, buffer, area.bottom() - 1, ends, title, style, theme);
    }
}

fn rule(area: Rect, buffer: &mut Buffer, y: u16, ends: (char, char), title: &Title, style: Style, theme: &Theme) {
    put(buffer, area.left(), y, ends.0, style);
    for x in area.left() + 1..area.right() - 1 {
        put(buffer, x, y, theme.glyphs.horizontal, style);
    }
    put(buffer, area.right() - 1, y, ends.1, style);
    let room = usize::from(area.width - 2);
    let right = Line::from(title.right.clone());
    let right_width = if title.right.is_empty() { 0 } else { right.width() + 2 };
    let fits = title.left.iter().find(|text| text.width() + 2 + right_width <= room);
    let (left, right_shown) = match fits {
        Some(text) => (text.clone(), right_width > 0),
        // what is on the right is a legend and useless in parts
        None if right_width > 0 && right_width <= room => (String::new(), true),
        None => (
            title.left.last().map_or(String::new(), |text| cut(text, room.saturating_sub(2), theme.glyphs.ellipsis)),
            false,
        ),
    };
    if !left.is_empty() {
        buffer.set_stringn(area.x + 1, y, format!(" {left} "), room, theme.title);
    }
    if right_shown {
        let x = area.right() - 1 - right_width as u16;
        put(buffer, x, y, ' ', style);
        buffer.set_line(x + 1, y, &right, right_width as u16 - 2);
        put(buffer, area.right() - 2, y, ' ', style);
    }
}

/// Sets one character, if it lies on the screen.
pub fn put(buffer: &mut Buffer, x: u16, y: u16, character: char, style: Style) {
    if let Some(cell) = buffer.cell_mut((x, y)) {
        cell.set_char(character).set_style(style);
    }
}
