//! Where the energy of a mode is: a bar for each motion of each rotor, and the mesh's share of the strain.
//!
//! ```text
//!    FE  pinion lat ██   23% axi       2% til ███▌  41% tor       0% mesh ▌   12%
//!          gear lat ▌     8% axi       1% til ██    25% tor       0%
//!  enh.  pinion ...
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::shape_numbers::short;
use super::wide_plot::style;
use crate::model::ModelKind;
use crate::response::{Mode, MotionGroup};
use crate::tui::theme::Theme;

/// Rows of one mode.
pub const ROWS: u16 = 2;

/// The width from which models and the mesh's share have columns of their own; below it that is told elsewhere.
pub const WHOLE: u16 = 76;

/// Of a share in percent, with a space after it.
const SHARE: usize = 5;
/// Columns of a part in which names are whole.
const WIDE: usize = 20;

/// Draws two lines a mode, the pinion first; what there is no room for is left out.
pub fn render(modes: &[(ModelKind, &Mode)], theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let fitting = usize::from(area.height / ROWS);
    for ((kind, mode), y) in modes.iter().take(fitting).zip((area.y..).step_by(usize::from(ROWS))) {
        let strain = Some(mode.mesh_strain_share);
        for (side, share, strain, y) in [("pinion", &mode.pinion, strain, y), ("gear", &mode.gear, None, y + 1)] {
            let label = if side == "pinion" { short(*kind) } else { "" };
            let (label, strain) =
                if area.width >= WHOLE { (format!(" {label:<5}"), Some(strain)) } else { (String::new(), None) };
            let x =
                buffer.set_stringn(area.x, y, label + &format!(" {side:>6} "), usize::from(area.width), theme.title).0;
            let groups = MotionGroup::ALL.map(|group| Some((group.name(), group.of(share))));
            let parts: Vec<_> =
                groups.into_iter().chain(strain.map(|strain| strain.map(|strain| ("mesh strain", strain)))).collect();
            let place = Rect { x, y, width: area.right() - x, height: 1 };
            render_parts(&parts, style(*kind, theme), theme, place, buffer);
        }
    }
}

fn render_parts(parts: &[Option<(&str, f64)>], style: Style, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let part = usize::from(area.width) / parts.len().max(1);
    let name_room = if part >= WIDE { 8 } else { 4 };
    for (at, (name, share)) in parts.iter().enumerate().filter_map(|(at, part)| Some((at, (*part)?))) {
        let (name, name_room) = match (name, part >= WIDE) {
            ("mesh strain", true) => (name, 12),
            ("mesh strain", false) => ("mesh", 5),
            (name, true) => (name, name_room),
            (name, false) => (name.get(..3).unwrap_or_default(), name_room),
        };
        let share = share.clamp(0.0, 1.0);
        let bar = part.saturating_sub(name_room + SHARE);
        let x = area.x + (at * part) as u16;
        let left = |x: u16| usize::from(area.right().saturating_sub(x));
        let x = buffer.set_stringn(x, area.y, format!("{name:<name_room$}"), left(x), theme.faint).0;
        let x = buffer.set_stringn(x, area.y, filled(share, bar, theme), left(x), style).0;
        buffer.set_stringn(x, area.y, format!("{:>3.0}% ", 100.0 * share), left(x), Style::new());
    }
}

/// A bar of `width` cells.
pub fn filled(share: f64, width: usize, theme: &Theme) -> String {
    const EIGHTHS: [char; 8] = [' ', '▏', '▎', '▍', '▌', '▋', '▊', '▉'];
    if theme.glyphs.ascii {
        let full = (share * width as f64).round() as usize;
        return format!("{:<width$}", "#".repeat(full.min(width)));
    }
    let eighths = (share * width as f64 * 8.0).round() as usize;
    let mut bar = "█".repeat((eighths / 8).min(width));
    if eighths / 8 < width {
        bar.push(EIGHTHS[eighths % 8]);
        bar.push_str(&" ".repeat(width - eighths / 8 - 1));
    }
    bar
}
