//! How far the enhanced model is off, column by column.
//!
//! ```text
//! ├ enhanced − FE, dB (tolerance 3) ─────────────┤
//! │ +20│              ⣿                          │
//! │   0│⡀⡀⡀⡀⡀⣀⣀⣀⡀⡀⡀⡀⣠⣿⣷⡀⡀⡀⡀⡀⡀⡀⢸⣿⡇⡀⡀⡀           │
//! │ -20│                       ⢸⣿⡇               │
//! ```
//!
//! Two dotted lines are the tolerance. Within it a bar is one dot wide, beyond it two; where there is one dot a cell, a
//! letter says which, or of a bar within it only the end is drawn: so it shows without colour.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::canvas::{Canvas, Pen};
use super::panel::{Title, put};
use super::plot::{GUTTER, curve_width};
use crate::agreement::TOLERANCE_DB;
use crate::tui::app::Picture;
use crate::tui::marker::Marker;
use crate::tui::theme::Theme;

/// The scales, dB, few, so that two designs can be compared by eye; what is beyond the largest is drawn to the edge.
const LIMITS: [f64; 3] = [10.0, 20.0, LARGEST];
const LARGEST: f64 = 40.0;

/// Title of the divider above.
pub fn title(theme: &Theme) -> Title<'static> {
    let minus = theme.glyphs.minus;
    let long = format!("enhanced {minus} FE, dB (tolerance {TOLERANCE_DB})");
    Title { left: vec![long, format!("enhanced {minus} FE, dB")], right: Vec::new() }
}

/// Draws the bars into the inside of the frame.
pub fn render(picture: &Picture, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let plot = Rect { x: area.x + GUTTER.min(area.width), width: curve_width(area), ..area };
    let (across, down) = theme.marker.dots();
    let Some(columns) = picture.columns(usize::from(plot.width), across).filter(|_| !plot.is_empty()) else { return };
    let largest = picture.traces.largest_difference;
    let limit = LIMITS.into_iter().find(|limit| *limit >= largest).unwrap_or(LARGEST);

    let mut canvas = Canvas::new(plot.width, plot.height, theme.marker);
    let zero = usize::from(plot.height / 2) * down + down / 2;
    // the same scale on both sides of zero
    let reach = zero.min(canvas.dots_high() - 1 - zero);
    // the tolerance as two dotted lines, where they can be told from the zero line
    let tolerance = (TOLERANCE_DB / limit * reach as f64).round() as usize;
    if tolerance > 1 {
        let pen = Pen { style: theme.faint, letter: '.' };
        for x in (0..canvas.dots_wide()).step_by(4) {
            canvas.set(x, zero - tolerance, pen);
            canvas.set(x, zero + tolerance, pen);
        }
    }
    for (x, difference) in columns.difference.iter().enumerate() {
        let Some(difference) = difference else { continue };
        let beyond = difference.abs() > TOLERANCE_DB;
        let pen =
            Pen { style: if beyond { theme.beyond } else { theme.enhanced }, letter: if beyond { '#' } else { '-' } };
        let dots = (difference.abs() / limit * reach as f64).round() as usize;
        // what is beyond the tolerance never vanishes in the zero line
        let dots = if beyond { dots.clamp(1, reach.max(1)) } else { dots.min(reach) };
        let (top, bottom) = if *difference > 0.0 { (zero.saturating_sub(dots), zero) } else { (zero, zero + dots) };
        let ends_only = across == 1 && !beyond && theme.marker != Marker::Letters;
        let (top, bottom) = match (ends_only, *difference > 0.0) {
            (false, _) => (top, bottom),
            (true, true) => (top, top),
            (true, false) => (bottom, bottom),
        };
        for dot in 0..across {
            if dot == 0 || beyond {
                canvas.set_column(x * across + dot, top, bottom, pen);
            }
        }
    }
    canvas.render(plot, buffer);
    draw_scale(limit, zero / down, reach / down, theme, plot, buffer);
}

fn draw_scale(limit: f64, zero: usize, reach: usize, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    let axis = plot.x - 1;
    for y in plot.top()..plot.bottom() {
        put(buffer, axis, y, theme.glyphs.vertical, theme.border);
    }
    let mut tick = |row: usize, label: String| {
        let y = plot.y + row as u16;
        if y < plot.bottom() {
            let x = axis.saturating_sub(label.len() as u16);
            buffer.set_stringn(x, y, label, usize::from(GUTTER - 1), theme.faint);
            put(buffer, axis, y, theme.glyphs.tick_left, theme.border);
        }
    };
    tick(zero, "0".into());
    if reach > 0 {
        tick(zero - reach, format!("+{limit:.0}"));
        tick(zero + reach, format!("-{limit:.0}"));
    }
}
