//! The state drawn into a frame.

use ratatui::Frame;
use ratatui::buffer::Buffer;

use super::app::App;
use super::screens::{editor, explorer};

/// Draws everything.
pub fn draw(app: &mut App, frame: &mut Frame) {
    if app.editors.open().is_some() {
        editor::render(app, frame);
    } else {
        explorer::render(app, frame);
    }
    sanitize(frame.buffer_mut(), app.theme.glyphs.ascii);
}

/// The last line of defence: whatever a widget let through, no control character reaches the terminal, and with ASCII
/// nothing beyond it.
fn sanitize(buffer: &mut Buffer, ascii: bool) {
    for cell in &mut buffer.content {
        let symbol = cell.symbol();
        if symbol.contains(char::is_control) || (ascii && !symbol.is_ascii()) {
            let shown = match symbol {
                "−" | "–" | "—" => '-',
                "·" | "•" => '*',
                "×" => 'x',
                "‘" | "’" => '\'',
                "“" | "”" => '"',
                "…" => '.',
                _ => '?',
            };
            cell.set_char(shown);
        }
    }
}
