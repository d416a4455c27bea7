//! The screens: each fills the terminal, with a header, a body, figures and the keys.

pub mod compare;
pub mod editor;
pub mod explorer;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::action::Action;
use super::app::App;
use super::widgets::figures;

/// The smallest terminal that the screens are laid out for.
pub const MIN_WIDTH: u16 = 60;
pub const MIN_HEIGHT: u16 = 18;

/// Whether there is room for a screen.
pub fn fits(area: Rect) -> bool {
    area.width >= MIN_WIDTH && area.height >= MIN_HEIGHT
}

/// What lies between the header and the figures.
pub fn body(area: Rect) -> Rect {
    Rect { y: area.y + 1, height: area.height.saturating_sub(2 + figures::HEIGHT), ..area }
}

/// Says how large the terminal must be.
pub fn render_too_small(app: &App, area: Rect, buffer: &mut Buffer) {
    let text = format!(
        "bevelscope needs {MIN_WIDTH}x{MIN_HEIGHT} characters, this terminal has {}x{} ({} quits)",
        area.width,
        area.height,
        app.keys.names(app.mode, true).of(Action::Quit)
    );
    let lines = crate::text::wrap(&text, usize::from(area.width));
    for (line, y) in lines.iter().zip(area.top()..area.bottom()) {
        buffer.set_stringn(area.x, y, line, usize::from(area.width), app.theme.fe);
    }
}
