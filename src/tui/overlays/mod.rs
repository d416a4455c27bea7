//! What lies over a screen: windows that take the keys until they are closed.

pub mod changes;
pub mod conflict;
pub mod export;
pub mod form;
pub mod help;
pub mod messages;
pub mod pair;
pub mod palette;
pub mod recovery;
pub mod spectra;

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;

use super::app::App;
use super::keymap::Mode;
use super::text_field::TextField;
use super::theme::Theme;
use super::widgets::leave;
use super::widgets::text_line::prompted;

/// Draws all windows over the body of a screen, the lowest first, and returns where the cursor stands, if something is typed.
pub fn render(app: &mut App, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let mut cursor = None;
    let layers: Vec<Mode> = app.layers().collect();
    for mode in layers {
        match mode {
            Mode::Help => drop(help::render(app, area, buffer)),
            // the same window, with the search being typed
            Mode::HelpSearch => cursor = help::render(app, area, buffer),
            Mode::Palette => cursor = palette::render(app, area, buffer),
            Mode::Name => cursor = form::render(app, area, buffer),
            Mode::Confirm => form::render_question(app, area, buffer),
            Mode::Messages => messages::render(app, area, buffer),
            Mode::Why => spectra::render_why(app, area, buffer),
            Mode::Export => cursor = export::render(app, area, buffer),
            Mode::FaceWidth => cursor = pair::render_estimate(app, area, buffer),
            Mode::MeshFile => cursor = pair::render_file(app, area, buffer),
            Mode::MeshImport => pair::render_import(app, area, buffer),
            Mode::Leave => leave::render(app, area, buffer),
            Mode::Recovery => recovery::render(app, area, buffer),
            Mode::Conflict => conflict::render(app, area, buffer),
            // screens, and what the editor draws itself
            _ => {}
        }
    }
    cursor
}

/// A window of at most this size in the middle of `area`, emptied.
pub fn window(area: Rect, width: u16, height: u16, buffer: &mut Buffer) -> Rect {
    let (width, height) = (width.min(area.width), height.min(area.height));
    let window = Rect { x: area.x + (area.width - width) / 2, y: area.y + (area.height - height) / 2, width, height };
    for y in window.top()..window.bottom() {
        for x in window.left()..window.right() {
            if let Some(cell) = buffer.cell_mut((x, y)) {
                cell.reset();
            }
        }
    }
    window
}

/// Draws a prompt and what is being typed into one line; returns where the cursor stands.
fn typed(prompt: &str, field: &TextField, theme: &Theme, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let drawn = prompted((prompt, theme.key), (field, Style::new()), theme, area, buffer);
    drawn.map(|(cursor, _)| cursor)
}
