//! The frame of a plot: grid, ticks, axis titles and the legend of the models.

use super::axis::Axis;
use super::{Anchor, Drawing, text_width};

/// A plot's two axes.
#[derive(Debug, Clone, Copy)]
pub struct Frame {
    pub x: Axis,
    pub y: Axis,
}

/// What a kind of line is called in style sheets and in the legend.
pub const MODELS: [(&str, &str); 3] = [("fe", "finite elements"), ("enhanced", "enhanced"), ("basic", "basic")];

impl Frame {
    /// The grid with the labels of the y axis; those of the x axis where `x_labels` is so.
    pub fn draw(&self, drawing: &mut Drawing, x_labels: bool) {
        let (left, right, bottom, top) = (self.x.from, self.x.to, self.y.from, self.y.to);
        for (value, label) in self.y.ticks() {
            let y = self.y.at(value);
            drawing.line("grid", [left, y], [right, y]);
            drawing.text("faint", [left - 6.0, y + 4.0], Anchor::End, &label);
        }
        for (value, label) in self.x.ticks() {
            let x = self.x.at(value);
            drawing.line("grid", [x, top], [x, bottom]);
            if x_labels {
                let anchor = if x + text_width(&label) / 2.0 > right + 8.0 { Anchor::End } else { Anchor::Middle };
                drawing.text("faint", [x, bottom + 15.0], anchor, &label);
            }
        }
        drawing.rect("frame", [left, top], [right, bottom], None);
    }
}

/// The models' line samples from a place on to the right, then a sample of a shaded band.
pub fn legend(drawing: &mut Drawing, place: [f64; 2], band: &str) {
    legend_of(drawing, place, &MODELS, band);
}

/// As [`legend`], of some lines; without a band where nothing is said of it.
pub fn legend_of(drawing: &mut Drawing, [x, y]: [f64; 2], lines: &[(&str, &str)], band: &str) {
    let mut x = x;
    for (class, name) in lines {
        drawing.line(&format!("curve {class}"), [x, y - 4.0], [x + 34.0, y - 4.0]);
        drawing.text("label", [x + 40.0, y], Anchor::Start, name);
        x += 40.0 + text_width(name) + 18.0;
    }
    if !band.is_empty() {
        drawing.rect("band", [x, y - 10.0], [x + 18.0, y + 1.0], None);
        drawing.text("label", [x + 24.0, y], Anchor::Start, band);
    }
}
