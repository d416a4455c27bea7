//! What spectrum and strip share: the gutter for the labels, and how a curve becomes dots.

use ratatui::layout::Rect;

use super::canvas::{Canvas, Pen};
use crate::tui::traces::Envelope;

/// Columns for the labels of the vertical axis, and one for the axis.
pub const GUTTER: u16 = 5;

/// Rows of the frequency axis with its labels.
pub const AXIS_ROWS: u16 = 2;

/// Width in cells of the curves in a pane.
pub fn curve_width(inner: Rect) -> u16 {
    inner.width.saturating_sub(GUTTER)
}

/// How a curve is told from others without colour: `on` columns of dots drawn, then `off` left out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Dash {
    pub on: usize,
    pub off: usize,
}

/// The values at the lower and the upper edge of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    pub low: f64,
    pub high: f64,
}

impl Range {
    /// The row, of `rows`, that a value lies in: negative above the picture, `rows` or more below it.
    pub fn row(&self, value: f64, rows: usize) -> i64 {
        ((self.high - value) / (self.high - self.low) * rows.saturating_sub(1) as f64).round() as i64
    }
}

/// Draws a curve. Only flat parts are dashed: of a resonance nothing is left out.
pub fn draw_curve(canvas: &mut Canvas, envelope: &Envelope, range: Range, dash: Dash, pen: Pen) {
    let rows = canvas.dots_high();
    if rows == 0 {
        return;
    }
    for (x, column) in envelope.iter().enumerate() {
        let Some((low, high)) = column else { continue };
        let (top, bottom) = (range.row(*high, rows), range.row(*low, rows));
        if bottom < 0 || top >= rows.cast_signed() as i64 {
            continue;
        }
        let flat = bottom - top <= 1;
        if flat && x % (dash.on + dash.off) >= dash.on {
            continue;
        }
        canvas.set_column(x, top.max(0) as usize, bottom as usize, pen);
    }
}
