//! Name and note of a variant.
//!
//! ```text
//! ┌ Save as a variant of overhung-elastic ─────────┐
//! │ name [stiffer-b1           ] .toml             │
//! │ note [B1 25 % stiffer      ]                   │
//! │ × there is a file of that name already         │
//! └────────────────────────────────────────────────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

use super::panel::{self, Title};
use super::text_line::bracketed;
use crate::text::{printable, wrap};
use crate::tui::editor::Form;
use crate::tui::theme::Theme;

/// Draws the form in the middle of `area`; returns where the cursor stands.
pub fn render(form: &Form, parent: &str, theme: &Theme, area: Rect, buffer: &mut Buffer) -> Position {
    let width = area.width.min(64);
    let height = 6.min(area.height);
    let window = Rect { x: area.x + (area.width - width) / 2, y: area.y + (area.height - height) / 2, width, height };
    panel::clear(window, buffer);
    let title = format!("Save as a variant of {}", printable(parent));
    let inner = panel::frame(window, buffer, &Title::left(title), true, theme);
    if inner.width < 20 || inner.height < 2 {
        return Position::new(inner.x, inner.y);
    }
    let line = |row: u16| Rect { x: inner.x + 6, y: inner.y + row, width: inner.width - 7, height: 1 };
    for (row, label) in ["name", "note"].into_iter().enumerate() {
        let style = if form.on_note == (row == 1) { theme.title } else { theme.faint };
        buffer.set_stringn(inner.x + 1, inner.y + row as u16, label, 5, style);
    }
    let name = bracketed(&form.name, theme, Rect { width: inner.width - 13, ..line(0) }, buffer);
    buffer.set_stringn(inner.right() - 6, inner.y, ".toml", 5, theme.faint);
    let note = bracketed(&form.note, theme, line(1), buffer);
    let problem = form.error.clone().or_else(|| form.checked_name().err().map(|error| error.to_string()));
    if let Some(problem) = problem {
        let text = format!("{} {}", theme.glyphs.broken, printable(&problem));
        let lines = wrap(&text, usize::from(inner.width.saturating_sub(2)));
        for (line, y) in lines.iter().zip(inner.y + 2..inner.bottom()) {
            buffer.set_stringn(inner.x + 1, y, line, usize::from(inner.width - 2), theme.error);
        }
    } else if inner.height > 2 {
        let text = "a new file beside the design, with it as its parent";
        buffer.set_stringn(inner.x + 1, inner.y + 2, text, usize::from(inner.width - 2), theme.faint);
    }
    if form.on_note { note } else { name }
}
