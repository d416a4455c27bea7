//! All messages in full, the latest first.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::text::wrap;
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::keymap::Mode;
use crate::tui::widgets::panel::{self, Title};

/// Draws the messages over `area`.
pub fn render(app: &mut App, area: Rect, buffer: &mut Buffer) {
    let theme = app.theme;
    let width = area.width.saturating_sub(4).min(100);
    let lines = wrap(&app.messages.text(), usize::from(width.saturating_sub(4)));
    let window = super::window(area, width, lines.len() as u16 + 2, buffer);
    let inner = panel::frame(window, buffer, &Title::left("Messages"), true, &theme);
    app.messages.scroll.fit(lines.len(), usize::from(inner.height));
    for (line, y) in lines.iter().skip(app.messages.scroll.top).zip(inner.top()..inner.bottom()) {
        buffer.set_stringn(inner.x + 1, y, line, usize::from(inner.width.saturating_sub(1)), theme.fe);
    }
    if let Some(position) = app.messages.scroll.position() {
        let back = app.keys.names(Mode::Messages, theme.glyphs.ascii).of(Action::Back);
        let left = vec![format!("lines {position}, {back} closes"), position];
        panel::bottom(window, buffer, &Title { left, right: Vec::new() }, true, &theme);
    }
}
