//! Where the kinetic energy of a mode is: a bar for each motion of each rotor.
//!
//! ```text
//!  pinion: lateral ██   23 %  axial       2 %  tilt ███▌  41 %  torsion      0 %
//!    gear: lateral ▌     8 %  axial       1 %  tilt ██    25 %  torsion      0 %
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::response::{Mode, MotionGroup};
use crate::tui::theme::Theme;

const LABEL: usize = 9;
/// Of the share in percent, with a space.
const SHARE: usize = 3;

/// Draws a line a rotor, pinion first.
pub fn render(mode: &Mode, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width);
    let part = width.saturating_sub(LABEL) / MotionGroup::ALL.len();
    let name_room = if part >= 18 { 8 } else { 4 };
    let bar = part.saturating_sub(name_room + SHARE + 2);
    for ((label, share), y) in
        [("pinion", &mode.pinion), ("gear", &mode.gear)].into_iter().zip(area.top()..area.bottom())
    {
        let (mut x, _) = buffer.set_stringn(area.x, y, format!(" {label:>6}: "), width, theme.title);
        for group in MotionGroup::ALL {
            let share = group.of(share).clamp(0.0, 1.0);
            let name = if name_room >= 8 { group.name() } else { group.name().get(..3).unwrap_or_default() };
            let left = |x: u16| usize::from(area.right().saturating_sub(x));
            x = buffer.set_stringn(x, y, format!("{name:<name_room$}"), left(x), theme.faint).0;
            x = buffer.set_stringn(x, y, filled(share, bar, theme), left(x), theme.fe).0;
            x = buffer.set_stringn(x, y, format!("{:>SHARE$.0}% ", 100.0 * share), left(x), theme.title).0;
        }
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
