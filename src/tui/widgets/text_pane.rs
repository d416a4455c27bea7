//! A text in a frame: why a design cannot be used, or what to do where there is none.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::panel::{self, Title};
use crate::text::wrap;
use crate::tui::app::Scroll;
use crate::tui::theme::Theme;

/// Draws a frame with a text that scrolls. The frame's last line says where one is, and how to get on.
pub fn render(
    (title, text, style): (&str, &str, Style),
    scroll: &mut Scroll,
    focused: bool,
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) {
    let inner = panel::frame(area, buffer, &Title::left(title), focused, theme);
    let text_area = Rect { x: inner.x + 1, width: inner.width.saturating_sub(2), ..inner };
    if text_area.is_empty() {
        return;
    }
    let lines = wrap(text, usize::from(text_area.width));
    scroll.fit(lines.len(), usize::from(text_area.height));
    for (line, y) in lines.iter().skip(scroll.top).zip(text_area.top()..text_area.bottom()) {
        buffer.set_stringn(text_area.x, y, line, usize::from(text_area.width), style);
    }
    if let Some(position) = scroll.position() {
        let how = if focused { String::new() } else { format!("lines {position}, Tab to scroll") };
        let title = Title { left: vec![how, format!("lines {position}"), position], right: Vec::new() };
        let title = if focused { Title { left: title.left[1..].to_vec(), ..title } } else { title };
        panel::bottom(area, buffer, &title, focused, theme);
    }
}
