//! The name of the file that is to be written.

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

use crate::text::wrap;
use crate::tui::app::App;
use crate::tui::widgets::panel::{self, Title};

const WIDTH: u16 = 72;

/// Draws the form and returns where the cursor stands.
pub fn render(app: &App, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let theme = app.theme;
    let form = app.export.as_ref()?;
    let (style, text) = match &form.refused {
        _ if form.pending => (theme.faint, format!("writing{}", theme.glyphs.ellipsis)),
        Some(error) => (theme.error, format!("{} {error}", theme.glyphs.broken)),
        None => (theme.faint, ".csv: the data; .svg: the picture; .html: a page of all. In the current folder, or with a path; nothing is overwritten."
            .into()),
    };
    let lines = wrap(&text, usize::from(area.width.min(WIDTH).saturating_sub(4)));
    let window = super::window(area, WIDTH, lines.len() as u16 + 3, buffer);
    let inner = panel::frame(window, buffer, &Title::left("Write what is shown"), true, &theme);
    for (line, y) in lines.iter().zip(inner.top() + 1..inner.bottom()) {
        buffer.set_stringn(inner.x + 1, y, line, usize::from(inner.width.saturating_sub(1)), style);
    }
    super::typed(" file: ", &form.field, &theme, inner, buffer)
}
