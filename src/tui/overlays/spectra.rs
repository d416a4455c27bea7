//! Over the wide screen: why models disagree in a band, and the name of the file that is to be written.

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

use crate::text::{printable, wrap};
use crate::tui::app::App;
use crate::tui::widgets::panel::{self, Title};

const WIDTH: u16 = 72;

/// Draws the sentences about the band at the cursor.
pub fn render_why(app: &mut App, area: Rect, buffer: &mut Buffer) {
    let theme = app.theme;
    let Some(view) = &mut app.spectra else { return };
    let room = usize::from(area.width.min(WIDTH).saturating_sub(4));
    let lines: Vec<String> = view.why().iter().flat_map(|line| wrap(&printable(line), room)).collect();
    let window = super::window(area, WIDTH, u16::try_from(lines.len() + 2).unwrap_or(u16::MAX), buffer);
    let inner = panel::frame(window, buffer, &Title::left("Why"), true, &theme);
    view.scroll.fit(lines.len(), usize::from(inner.height));
    for (line, y) in lines.iter().skip(view.scroll.top).zip(inner.top()..inner.bottom()) {
        buffer.set_stringn(inner.x + 1, y, line, room, theme.fe);
    }
    if let Some(position) = view.scroll.position() {
        panel::bottom(window, buffer, &Title::left(format!("lines {position}")), true, &theme);
    }
}

/// Draws the form and returns where the cursor stands.
pub fn render_form(app: &App, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let theme = app.theme;
    let form = app.spectra.as_ref()?.form.as_ref()?;
    let (style, text) = match &form.refused {
        _ if form.pending => (theme.faint, format!("writing{}", theme.glyphs.ellipsis)),
        Some(error) => (theme.error, format!("{} {error}", theme.glyphs.broken)),
        None => (theme.faint, "in the current folder, or with a path; nothing is overwritten".into()),
    };
    let lines = wrap(&text, usize::from(area.width.min(WIDTH).saturating_sub(4)));
    let window = super::window(area, WIDTH, lines.len() as u16 + 3, buffer);
    let inner = panel::frame(window, buffer, &Title::left("Write what is shown as CSV"), true, &theme);
    for (line, y) in lines.iter().zip(inner.top() + 1..inner.bottom()) {
        buffer.set_stringn(inner.x + 1, y, line, usize::from(inner.width.saturating_sub(1)), style);
    }
    super::typed(" file: ", &form.field, &theme, inner, buffer)
}
