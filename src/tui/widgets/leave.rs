//! What to do with edits that are not saved.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::panel::{self, Title};
use crate::design::Changes;
use crate::text::{cut, printable};
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::keymap::Mode;

/// Draws the question in the middle of `area`.
pub fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    let theme = &app.theme;
    let names: Vec<String> = app
        .editors
        .unsaved()
        .map(|editing| {
            let stem = editing.path.file_stem().unwrap_or_default().to_string_lossy();
            let errors = editing.errors();
            let errors = if errors == 0 { "" } else { " (with errors)" };
            let changes = Changes::between(editing.saved_text(), editing.editor.text()).count();
            format!("  {} * {changes}{errors}", printable(&stem))
        })
        .collect();
    let width = area.width.min(60);
    let height = (names.len() as u16 + 6).min(area.height);
    let window = Rect { x: area.x + (area.width - width) / 2, y: area.y + (area.height - height) / 2, width, height };
    panel::clear(window, buffer);
    let inner = panel::frame(window, buffer, &Title::left("Quit with edits that are not saved?"), true, theme);
    let room = usize::from(inner.width.saturating_sub(2));
    let listed = usize::from(inner.height).saturating_sub(4);
    let more = names.len().saturating_sub(listed);
    let mut lines: Vec<(String, Style)> =
        names.into_iter().take(listed).map(|name| (cut(&name, room, theme.glyphs.ellipsis), Style::new())).collect();
    if more > 0
        && let Some(last) = lines.last_mut()
    {
        last.0 = format!("  and {} more", more + 1);
    }
    lines.push((String::new(), Style::new()));
    for (action, text) in [
        (Action::SaveAll, "save all and quit"),
        (Action::DiscardAll, "discard the edits and quit"),
        (Action::Back, "stay"),
    ] {
        let keys = app.keys.of(Mode::Leave, action, theme.glyphs.ascii);
        lines.push((format!("{:>5}  {text}", keys.first().map_or("", String::as_str)), theme.title));
    }
    for ((line, style), y) in lines.iter().zip(inner.top()..inner.bottom()) {
        buffer.set_stringn(inner.x + 1, y, line, room, *style);
    }
}
