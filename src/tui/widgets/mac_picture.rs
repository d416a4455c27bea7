//! The MAC of all modes of a small model with those of finite elements, as shades.
//!
//! ```text
//!            FE  1    5    10   15
//!  enhanced               ▼
//!    1     0.0   █
//! ▌  2   236.1    ▓░      █
//!  0 ' '  0.1 '·'  0.3 '░'  0.5 '▒'  0.7 '▓'  0.9 '█'
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::mode_table::hertz;
use crate::tui::modes::ModesView;
use crate::tui::spectra::legend_name;
use crate::tui::theme::Theme;

/// Columns of number and frequency.
const LABEL: u16 = 15;

/// Lower bounds of the shades.
const BOUNDS: [f64; 6] = [0.0, 0.1, 0.3, 0.5, 0.7, 0.9];

/// The shade of a MAC: the darker, the more alike.
pub fn shade(mac: f64, ascii: bool) -> char {
    let shades = if ascii { [' ', '.', ':', '+', '%', '#'] } else { [' ', '·', '░', '▒', '▓', '█'] };
    let at = BOUNDS.iter().rposition(|bound| mac >= *bound).unwrap_or(0);
    shades[at]
}

/// What the shades mean.
pub fn legend(ascii: bool) -> String {
    let shades = BOUNDS.iter().skip(1).map(|bound| format!("{} {bound:.1}", shade(*bound, ascii)));
    format!("MAC from {}", shades.collect::<Vec<_>>().join("  "))
}

/// Draws the picture with its cursor.
pub fn render(view: &ModesView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let (Some(study), Some((row, column))) = (view.study(), view.mac) else { return };
    if area.height < 3 || area.width <= LABEL {
        return;
    }
    let Some(small) = study.one(view.model) else { return };
    let mac = &small.mac;
    let room = usize::from(area.width - LABEL);
    let cell = (room / mac.ncols().max(1)).clamp(1, 3);
    let (across, down) = (room / cell, usize::from(area.height - 2));
    let left = (column + 1).saturating_sub(across);
    let top = (row + 1).saturating_sub(down);
    let x_of = |at: usize| area.x + LABEL + ((at - left) * cell) as u16;
    let model = legend_name(small.own.kind());
    buffer.set_stringn(area.x, area.y, format!(" {model:>8} \\ FE"), usize::from(LABEL), theme.faint);
    for at in (left..mac.ncols().min(left + across)).filter(|at| *at == 0 || (at + 1) % 5 == 0) {
        let x = x_of(at);
        buffer.set_stringn(x, area.y, (at + 1).to_string(), usize::from(area.right().saturating_sub(x)), theme.faint);
    }
    buffer.set_stringn(x_of(column), area.y + 1, theme.glyphs.pointer.to_string(), 1, theme.title);
    for (at, y) in (top..mac.nrows()).zip(area.y + 2..area.bottom()) {
        let is_selected = at == row;
        let marker = if is_selected { theme.glyphs.selected } else { " " };
        let hz = small.own.modes.0.get(at).map_or(0.0, |mode| mode.frequency_hz);
        let style = if is_selected { theme.title } else { Style::new() };
        buffer.set_stringn(area.x, y, format!("{marker}{:>3}{:>9}", at + 1, hertz(hz)), usize::from(LABEL), style);
        for other in left..mac.ncols().min(left + across) {
            let shade = shade(mac[(at, other)], theme.glyphs.ascii);
            let style = if is_selected && other == column { theme.selected } else { Style::new() };
            buffer.set_stringn(x_of(other), y, shade.to_string().repeat(cell), cell, style);
        }
    }
}
