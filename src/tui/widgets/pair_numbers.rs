//! The numbers of a gear pair.
//!
//! ```text
//!                 pinion       gear
//!  axial force     +8840      +1984 N
//!  axial +: away from the apex
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use crate::text::wrap;
use crate::tui::app::Scroll;
use crate::tui::pair::{Line, Shown, lines};
use crate::tui::theme::Theme;

const LABEL: usize = 13;
const VALUE: usize = 10;

/// Draws the heading and the lines in sight.
pub fn render(shown: &Shown, scroll: &mut Scroll, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width);
    if area.height == 0 {
        return;
    }
    let head = format!(" {:LABEL$}{:>VALUE$} {:>VALUE$}", "", "pinion", "gear");
    buffer.set_stringn(area.x, area.y, head, width, theme.title);
    let room = width.saturating_sub(2);
    let mut drawn: Vec<(String, Style)> = Vec::new();
    for line in lines(shown) {
        match line {
            Line::Both(name, [pinion, gear], unit) => {
                drawn.push((format!("{name:LABEL$}{pinion:>VALUE$} {gear:>VALUE$} {unit}"), theme.fe));
            }
            Line::Single(text) => drawn.extend(wrap(&text, room).into_iter().map(|line| (line, theme.fe))),
            Line::Note(text) => drawn.extend(wrap(&text, room).into_iter().map(|line| (line, theme.faint))),
        }
    }
    scroll.fit(drawn.len(), usize::from(area.height - 1));
    for ((text, style), y) in drawn.into_iter().skip(scroll.top).zip(area.top() + 1..area.bottom()) {
        buffer.set_stringn(area.x + 1, y, text, width.saturating_sub(1), style);
    }
}
