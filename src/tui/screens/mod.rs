//! The screens: each fills the terminal, with a header, a body, figures and the keys.

pub mod bearings;
pub mod compare;
pub mod editor;
pub mod explorer;
pub mod modes;
pub mod new_design;
pub mod overview;
pub mod pair;
pub mod spectra;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::action::Action;
use super::app::App;
use super::keymap::Mode;
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

/// Says how large the terminal must be, and asks what to do with unsaved edits if that is the question.
pub fn render_too_small(app: &mut App, area: Rect, buffer: &mut Buffer) {
    let keys = app.keys.names(app.mode, true);
    let size = format!(
        "bevelscope needs {MIN_WIDTH}x{MIN_HEIGHT} characters, this terminal has {}x{}",
        area.width, area.height
    );
    let text = if app.mode == Mode::Leave {
        let unsaved = app.editors.unsaved().count();
        let designs = if unsaved == 1 { "1 design has".to_owned() } else { format!("{unsaved} designs have") };
        let [save, discard, stay] = [Action::SaveAll, Action::DiscardAll, Action::Back].map(|action| keys.of(action));
        format!("{size}\n{designs} unsaved edits. {save}: save all and quit, {discard}: discard them, {stay}: stay")
    } else {
        format!("{size} ({} quits)", keys.of(Action::Quit))
    };
    let lines = crate::text::wrap(&text, usize::from(area.width));
    // a question is answered only where all of it can be read
    app.is_unseen = app.mode != Mode::Leave || lines.len() > usize::from(area.height);
    for (line, y) in lines.iter().zip(area.top()..area.bottom()) {
        buffer.set_stringn(area.x, y, line, usize::from(area.width), app.theme.fe);
    }
}
