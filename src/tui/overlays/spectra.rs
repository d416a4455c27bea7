//! Over the wide screen: why models disagree in a band.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

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
