//! A spectrum from its outline, as large as there is room.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::canvas::{Canvas, Pen};
use super::plot::{AXIS_ROWS, GUTTER, Range, draw_curve};
use super::spectrum::draw_frequencies;
use super::wide_plot::draw_scale;
use crate::design::{Analysis, FrequencySpacing};
use crate::tui::axis::FrequencyAxis;
use crate::tui::theme::Theme;
use crate::tui::traces::{envelope, range};

/// Draws the highest level in each of as many columns as the outline (dB re 1 N) has.
pub fn render(outline: &[f64], analysis: &Analysis, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if area.width <= GUTTER || area.height <= AXIS_ROWS || outline.len() < 2 {
        return;
    }
    let plot = Rect { x: area.x + GUTTER, width: area.width - GUTTER, height: area.height - AXIS_ROWS, ..area };
    let log = analysis.frequency_spacing == FrequencySpacing::Log;
    let axis = FrequencyAxis { min: analysis.frequency_min, max: analysis.frequency_max, log };
    let (low, high) = range(&[outline]);
    let range = Range { low, high };
    draw_scale(range, true, theme, plot, buffer);
    draw_frequencies(&axis, theme, plot, buffer);
    // lines are as far apart on their axis as the parts of the outline
    let places: Vec<f64> = (0..outline.len()).map(|at| at as f64).collect();
    let ends = FrequencyAxis { min: 0.0, max: (outline.len() - 1) as f64, log: false };
    let mut canvas = Canvas::new(plot.width, plot.height, theme.marker);
    let columns = envelope(&places, outline, &ends, canvas.dots_wide());
    let pen = Pen { style: theme.fe, letter: theme.glyphs.letters[0] };
    draw_curve(&mut canvas, &columns, range, theme.marker.dashes()[0], pen);
    canvas.render(plot, buffer);
}
