//! The state drawn into a frame.

use ratatui::Frame;
use ratatui::buffer::Buffer;

use super::app::App;
use super::keymap::{Mode, SCREENS};
use super::overlays;
use super::screens::{
    bearings, body, compare, editor, explorer, fits, modes, new_design, overview, pair, render_too_small, spectra,
};

/// Draws everything.
pub fn draw(app: &mut App, frame: &mut Frame) {
    render(app, frame);
    sanitize(frame.buffer_mut(), app.theme.glyphs.ascii);
}

/// The screen of the lowest layer, and the windows over it.
fn render(app: &mut App, frame: &mut Frame) {
    let area = frame.area();
    app.is_unseen = !fits(area);
    if app.is_unseen {
        return render_too_small(app, area, frame.buffer_mut());
    }
    let screen = app.layers().filter(|mode| SCREENS.contains(mode) || *mode == Mode::New).last();
    let cursor = match screen {
        Some(Mode::Compare) => compare::render(app, frame),
        Some(Mode::Spectra) => spectra::render(app, frame),
        Some(Mode::Modes) => modes::render(app, frame),
        Some(Mode::Bearings) => bearings::render(app, frame),
        Some(Mode::Pair) => pair::render(app, frame),
        Some(Mode::New) => new_design::render(app, frame),
        Some(Mode::Overview) => overview::render(app, frame),
        _ if app.editors.open().is_some() => editor::render(app, frame),
        _ => explorer::render(app, frame),
    };
    // the form is a screen that is typed into; a number is typed in the last line of its screen
    let is_of_screen = matches!(app.mode, Mode::New | Mode::Torque | Mode::Frequency);
    let covered = !app.below.is_empty() && !is_of_screen;
    let over = overlays::render(app, body(area), frame.buffer_mut());
    if let Some(cursor) = over.or(cursor.filter(|_| !covered)) {
        frame.set_cursor_position(cursor);
    }
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
