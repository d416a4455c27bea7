//! A shape at one moment: both shafts in two planes over their undeformed lines.
//!
//! ```text
//!  pinion    FE  enh.          ⣀⠤e⠒⠉⠉e
//!  axial   0.12 0.11 x-y e─×─⣀e△⠒⠉─△────  y-z ──×──△────△────
//!  torsion 0.98 0.97     ⠒e⠒⠉
//!  drive   0.30 0.30
//! ```
//!
//! Finite elements are a line, the partner a broken line with its letter in every fourth column: where both lie on one another, both are seen.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::canvas::Canvas;
use super::panel::put;
use super::plot::{Range, draw_curve};
use super::shape_numbers;
use super::wide_plot::pen;
use crate::design::{BearingModel, RotorDesign, Side};
use crate::model::ModelKind;
use crate::response::StationShape;
use crate::tui::axis::FrequencyAxis;
use crate::tui::modes::Moment;
use crate::tui::theme::Theme;
use crate::tui::traces::envelope;

/// Columns of a plane's name beside it.
const NAME: u16 = 4;

/// The planes: name, and the displacement that is drawn.
const PLANES: [(&str, usize); 2] = [("x-y", 0), ("y-z", 2)];

/// Columns from one letter of a partner's curve to the next.
const LETTERS_APART: u16 = 4;

/// The fewest rows in which curves are told from a straight line.
const LEAST_ROWS: u16 = 2;

/// Draws both shafts, each in half of the rows.
pub fn render(moment: &Moment, design: &crate::design::Design, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let half = area.height / 2;
    if half < LEAST_ROWS || area.width < shape_numbers::WIDTH + 2 * (NAME + 2) {
        return;
    }
    for (at, side) in Side::BOTH.into_iter().enumerate() {
        let band = Rect { y: area.y + half * at as u16, height: half, ..area };
        let rotor = design.rotor(side);
        let shapes: Vec<(ModelKind, &StationShape<f64>)> =
            moment.shapes.iter().map(|(of, both)| (*of, &both[at])).collect();
        shape_numbers::render((side, rotor), &shapes, moment.largest, theme, band, buffer);
        let width = (band.width - shape_numbers::WIDTH) / 2;
        for (plane, (name, component)) in PLANES.into_iter().enumerate() {
            let left = band.x + shape_numbers::WIDTH + width * plane as u16;
            let place = Rect { x: left + NAME, width: width.saturating_sub(NAME + 1), ..band };
            let middle = Plane { rotor, component, largest: moment.largest[0] }.render(&shapes, theme, place, buffer);
            buffer.set_stringn(left, middle, name, usize::from(NAME), theme.faint);
        }
    }
}

/// One plane of a shaft.
struct Plane<'a> {
    rotor: &'a RotorDesign,
    /// The displacement that is drawn
    component: usize,
    /// m, at the edge of the picture
    largest: f64,
}

impl Plane<'_> {
    /// Draws the plane, and says in which row its axis is.
    fn render(
        &self,
        shapes: &[(ModelKind, &StationShape<f64>)],
        theme: &Theme,
        area: Rect,
        buffer: &mut Buffer,
    ) -> u16 {
        let length = shapes.iter().filter_map(|(_, shape)| shape.positions.last().copied()).fold(0.0, f64::max);
        let start = shapes.iter().filter_map(|(_, shape)| shape.positions.first().copied()).fold(0.0, f64::min);
        let axis = FrequencyAxis { min: start, max: length, log: false };
        let mut canvas = Canvas::new(area.width, area.height, theme.marker);
        let range = Range { low: -1.0, high: 1.0 };
        let (dots, down) = (canvas.dots_high(), theme.marker.dots().1);
        let row = |value: f64| {
            let dot = range.row(value, dots).max(0) as usize;
            area.y + ((dot / down) as u16).min(area.height.saturating_sub(1))
        };
        let middle = row(0.0);
        for x in area.left()..area.right() {
            put(buffer, x, middle, theme.glyphs.horizontal, theme.border);
        }
        // a shaft without length has nothing to draw along
        if area.is_empty()
            || length.partial_cmp(&start) != Some(std::cmp::Ordering::Greater)
            || self.largest.partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater)
        {
            return middle;
        }
        let mut letters = Vec::new();
        for (of, shape) in shapes.iter().rev() {
            let values: Vec<f64> =
                shape.displacements.iter().map(|station| station[self.component] / self.largest).collect();
            let (dash, pen) = pen(*of, theme);
            if *of != ModelKind::Fe {
                let cells = envelope(&shape.positions, &values, &axis, usize::from(area.width));
                let places = (area.left()..area.right()).zip(cells).skip(1).step_by(usize::from(LETTERS_APART));
                letters
                    .extend(places.filter_map(|(x, cell)| cell.map(|(low, high)| (x, row(0.5 * (low + high)), pen))));
            }
            let columns = envelope(&shape.positions, &values, &axis, canvas.dots_wide());
            draw_curve(&mut canvas, &columns, range, dash, pen);
        }
        canvas.render(area, buffer);
        for (x, y, pen) in letters {
            put(buffer, x, y, pen.letter, pen.style);
        }
        self.render_supports(&axis, theme, Rect { y: middle, height: 1, ..area }, buffer);
        middle
    }

    /// The bearings and the mesh, on the axis.
    fn render_supports(&self, axis: &FrequencyAxis, theme: &Theme, area: Rect, buffer: &mut Buffer) {
        let mut mark = |position: f64, character: char| {
            let fraction = axis.fraction(position);
            if (0.0..=1.0).contains(&fraction) {
                let x = area.x + ((fraction * f64::from(area.width)) as u16).min(area.width - 1);
                put(buffer, x, area.y, character, theme.title);
            }
        };
        for bearing in &self.rotor.bearings {
            let is_rigid = matches!(bearing.model, BearingModel::Rigid(_));
            mark(bearing.position, if is_rigid { theme.glyphs.rigid_bearing } else { theme.glyphs.bearing });
        }
        mark(self.rotor.mesh_position, theme.glyphs.mesh);
    }
}

/// What the legend says of a model's curve.
pub fn sample(of: ModelKind, theme: &Theme) -> (String, Style) {
    let (_, pen) = pen(of, theme);
    let sample = if of == ModelKind::Fe { theme.marker.samples()[0].to_owned() } else { pen.letter.to_string() };
    (sample, pen.style)
}
