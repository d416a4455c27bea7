//! A text in a frame: why a design cannot be used, or what to do where there is none.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::panel::{self, Title};
use crate::text::wrap_quoted;
use crate::tui::app::Scroll;
use crate::tui::theme::Theme;

/// Draws a frame with a text that scrolls. The frame's last line says where one is, and which key leads here from another
/// pane; without one the pane has the keys.
pub fn render(
    (title, text, style): (&str, &str, Style),
    scroll: &mut Scroll,
    way_here: Option<&str>,
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) {
    let focused = way_here.is_none();
    let inner = panel::frame(area, buffer, &Title::left(title), focused, theme);
    let text_area = Rect { x: inner.x + 1, width: inner.width.saturating_sub(2), ..inner };
    if text_area.is_empty() {
        return;
    }
    let lines = wrap_quoted(text, usize::from(text_area.width), theme.glyphs.ellipsis);
    scroll.fit(lines.len(), usize::from(text_area.height));
    for (line, y) in lines.iter().skip(scroll.top).zip(text_area.top()..text_area.bottom()) {
        buffer.set_stringn(text_area.x, y, line, usize::from(text_area.width), style);
    }
    if let Some(position) = scroll.position() {
        let how = way_here.map(|key| format!("lines {position}, {key} to scroll"));
        let left = how.into_iter().chain([format!("lines {position}"), position]).collect();
        panel::bottom(area, buffer, &Title { left, right: Vec::new() }, focused, theme);
    }
}
