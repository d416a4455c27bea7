//! The words that a cell may hold, below it.
//!
//! ```text
//!   ┌───────────┐
//!   │> diagonal │
//!   │  matrix   │
//!   └───────────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use super::panel::{self, Title};
use crate::tui::editor::Choice;
use crate::tui::theme::Theme;

/// Draws the list below `cell`, inside of `area`, or above it where there is no room.
pub fn render(choice: &Choice, cell: Rect, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let ticks = if choice.ticked.is_some() { 4 } else { 0 };
    let widest = choice.words.iter().map(|word| word.width()).max().unwrap_or(0);
    let width = (widest + ticks + 5).min(usize::from(area.width)) as u16;
    let height = (choice.words.len() as u16 + 2).min(area.height);
    let x = cell.x.min(area.right().saturating_sub(width));
    let below = cell.y + 1 + height <= area.bottom();
    let y = if below { cell.y + 1 } else { cell.y.saturating_sub(height).max(area.y) };
    let window = Rect { x, y, width, height }.intersection(area);
    panel::clear(window, buffer);
    let inner = panel::frame(window, buffer, &Title::default(), true, theme);
    let top = (choice.cursor + 1).saturating_sub(usize::from(inner.height));
    for ((at, word), y) in choice.words.iter().enumerate().skip(top).zip(inner.top()..inner.bottom()) {
        let selected = at == choice.cursor;
        let marker = if selected { theme.glyphs.selected } else { " " };
        let tick = match choice.ticked.as_ref().and_then(|ticked| ticked.get(at)) {
            Some(true) => format!("[{}] ", theme.glyphs.ticked),
            Some(false) => "[ ] ".into(),
            None => String::new(),
        };
        let style = if selected { theme.selected } else { Style::new() };
        let room = usize::from(inner.width);
        let text = format!("{marker} {tick}{word}");
        buffer.set_stringn(inner.x, y, format!("{text:<room$}"), room, style);
    }
}
