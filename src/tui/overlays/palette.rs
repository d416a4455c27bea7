//! The command palette.
//!
//! ```text
//! ┌ Commands 1 of 3 ───────────────────────────────────────────┐
//! │ :re▏                                                       │
//! │▌reread           R     read the folder and the designs ag… │
//! │ rename           r     rename the design's file            │
//! │ restore-deleted  u     bring back what was deleted last    │
//! └────────────────────────────────────────────────────────────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::text::cut;
use crate::tui::app::App;
use crate::tui::widgets::panel::{self, Title};

/// Draws the palette over `area` and returns where the cursor stands.
pub fn render(app: &mut App, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let theme = app.theme;
    let entries = app.palette_entries();
    let window = super::window(area, area.width.saturating_sub(4).min(90), area.height.min(18), buffer);
    let inner_height = usize::from(window.height.saturating_sub(3));
    app.palette.fit(entries.len(), inner_height);
    let place = if entries.is_empty() { 0 } else { app.palette.cursor + 1 };
    let title = Title::left(format!("Commands {place} of {}", entries.len()));
    let inner = panel::frame(window, buffer, &title, true, &theme);
    let names = entries.iter().map(|entry| entry.about.name.width()).max().unwrap_or(0);
    let keys = entries.iter().map(|entry| entry.keys.width()).max().unwrap_or(0).min(18);
    let list = inner.top() + 1..inner.bottom();
    for ((at, entry), y) in entries.iter().enumerate().skip(app.palette.top).zip(list) {
        let chosen = at == app.palette.cursor;
        let room = usize::from(inner.width);
        let marker = if chosen { theme.glyphs.selected } else { " " };
        let name = format!("{marker}{:names$}  ", entry.about.name);
        let (x, _) = buffer.set_stringn(inner.x, y, name, room, Style::new());
        let left = |x: u16| usize::from(inner.right().saturating_sub(x));
        let shown = cut(&entry.keys, keys, theme.glyphs.ellipsis);
        let gap = " ".repeat(keys + 2 - shown.width());
        let (x, _) = buffer.set_stringn(x, y, shown + &gap, left(x), theme.key);
        let doc = cut(entry.about.doc, left(x).saturating_sub(1), theme.glyphs.ellipsis);
        buffer.set_stringn(x, y, doc, left(x), theme.faint);
        if chosen {
            buffer.set_style(Rect::new(inner.x, y, inner.width, 1), theme.selected);
        }
    }
    if entries.is_empty() && inner.height > 1 {
        let text = " no action here has these letters";
        buffer.set_stringn(inner.x, inner.y + 1, text, usize::from(inner.width), theme.faint);
    }
    super::typed(" :", &app.palette.typed, &theme, inner, buffer)
}
