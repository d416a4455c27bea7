//! A shape at one moment: both shafts in two planes over their undeformed lines.
//!
//! ```text
//!  pinion    FE  enh │x-y      ⣀⠤⠒⠉      │y-z
//!  axial   0.12 0.11 │──×─⣀⠤△⠒⠉─△────    │──×──△────△────
//!  torsion 0.98 0.97 │⠒⠉
//!  drive   0.30 0.30 │
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::canvas::{Canvas, Pen};
use super::panel::put;
use super::plot::{Range, draw_curve};
use crate::design::{BearingModel, RotorDesign, Side};
use crate::response::StationShape;
use crate::tui::axis::FrequencyAxis;
use crate::tui::modes::{Moment, ShapeOf};
use crate::tui::theme::Theme;
use crate::tui::traces::envelope;

/// Columns of the numbers beside the planes.
const NUMBERS: u16 = 20;

/// The planes: name, and the displacement that is drawn.
const PLANES: [(&str, usize); 2] = [("x-y", 0), ("y-z", 2)];

/// Draws both shafts, each in half of the rows.
pub fn render(moment: &Moment, design: &crate::design::Design, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let half = area.height / 2;
    if half == 0 || area.width < NUMBERS + 4 {
        return;
    }
    for (at, side) in Side::BOTH.into_iter().enumerate() {
        let band = Rect { y: area.y + half * at as u16, height: half, ..area };
        let rotor = design.rotor(side);
        let shapes: Vec<(ShapeOf, &StationShape<f64>)> =
            moment.shapes.iter().map(|(of, both)| (*of, &both[at])).collect();
        render_numbers(side, rotor, &shapes, moment.largest, theme, band, buffer);
        let width = (band.width - NUMBERS) / 2;
        for (plane, (name, component)) in PLANES.into_iter().enumerate() {
            let place = Rect { x: band.x + NUMBERS + width * plane as u16, width: width.saturating_sub(1), ..band };
            render_plane(name, component, rotor, &shapes, moment.largest[0], theme, place, buffer);
        }
    }
}

/// Motions along and about the axis at the mesh, and the drive's: of the largest displacement, and of the largest rotation about an axis.
fn render_numbers(
    side: Side,
    rotor: &RotorDesign,
    shapes: &[(ShapeOf, &StationShape<f64>)],
    largest: [f64; 2],
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) {
    let heads: Vec<String> = shapes.iter().map(|(of, _)| format!("{:>6}", short(*of))).collect();
    let heads = heads.concat();
    let part =
        |value: f64, whole: f64| if whole > 0.0 { format!("{:>6.2}", value / whole) } else { format!("{:>6}", "-") };
    let at_mesh = |shape: &StationShape<f64>, component: usize| {
        let distance = |position: f64| (position - rotor.mesh_position).abs();
        let stations = shape.positions.iter().zip(&shape.displacements);
        stations.min_by(|a, b| distance(*a.0).total_cmp(&distance(*b.0))).map_or(0.0, |(_, station)| station[component])
    };
    let line = |value: &dyn Fn(&StationShape<f64>) -> f64, whole: f64| -> String {
        shapes.iter().map(|(_, shape)| part(value(shape), whole)).collect()
    };
    let [across, about] = largest;
    let lines = [
        (format!(" {:<7}{heads}", side.name()), theme.title),
        (format!(" axial  {}", line(&|shape| at_mesh(shape, 1), across)), Style::new()),
        (format!(" torsion{}", line(&|shape| at_mesh(shape, 4), about)), Style::new()),
        (format!(" drive  {}", line(&|shape| shape.drive.unwrap_or_default(), about)), Style::new()),
    ];
    let count = if rotor.drive.is_some() { lines.len() } else { lines.len() - 1 };
    for ((text, style), y) in lines.into_iter().take(count).zip(area.top()..area.bottom()) {
        buffer.set_stringn(area.x, y, text, usize::from(NUMBERS), style);
    }
}

#[allow(clippy::too_many_arguments, reason = "what is drawn, and where")]
fn render_plane(
    name: &str,
    component: usize,
    rotor: &RotorDesign,
    shapes: &[(ShapeOf, &StationShape<f64>)],
    largest: f64,
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) {
    if area.is_empty() {
        return;
    }
    let length = shapes.iter().filter_map(|(_, shape)| shape.positions.last().copied()).fold(0.0, f64::max);
    let start = shapes.iter().filter_map(|(_, shape)| shape.positions.first().copied()).fold(0.0, f64::min);
    let axis = FrequencyAxis { min: start, max: length, log: false };
    let mut canvas = Canvas::new(area.width, area.height, theme.marker);
    let range = Range { low: -1.0, high: 1.0 };
    let (_, down) = theme.marker.dots();
    let middle = area.y + (range.row(0.0, canvas.dots_high()).max(0) as usize / down) as u16;
    for x in area.left()..area.right() {
        put(buffer, x, middle, theme.glyphs.horizontal, theme.border);
    }
    buffer.set_stringn(area.x, area.y, name, usize::from(area.width), theme.faint);
    // a shaft without length has nothing to draw along
    if length.partial_cmp(&start) != Some(std::cmp::Ordering::Greater)
        || largest.partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater)
    {
        return;
    }
    let [solid, enhanced, basic] = theme.marker.dashes();
    for (of, shape) in shapes.iter().rev() {
        let values: Vec<f64> = shape.displacements.iter().map(|station| station[component] / largest).collect();
        let columns = envelope(&shape.positions, &values, &axis, canvas.dots_wide());
        let letters = theme.glyphs.letters;
        let (dash, style, letter) = match of {
            ShapeOf::Fe => (solid, theme.fe, letters[0]),
            ShapeOf::Lumped(0) => (enhanced, theme.enhanced, letters[1]),
            ShapeOf::Lumped(_) => (basic, theme.basic, letters[2]),
        };
        draw_curve(&mut canvas, &columns, range, dash, Pen { style, letter });
    }
    canvas.render(area, buffer);
    let mut mark = |position: f64, character: char| {
        let fraction = axis.fraction(position);
        if (0.0..=1.0).contains(&fraction) {
            let x = area.x + ((fraction * f64::from(area.width)) as u16).min(area.width - 1);
            put(buffer, x, middle, character, theme.title);
        }
    };
    for bearing in &rotor.bearings {
        let is_rigid = matches!(bearing.model, BearingModel::Rigid(_));
        mark(bearing.position, if is_rigid { theme.glyphs.rigid_bearing } else { theme.glyphs.bearing });
    }
    mark(rotor.mesh_position, theme.glyphs.mesh);
}

fn short(of: ShapeOf) -> &'static str {
    match of {
        ShapeOf::Fe => "FE",
        ShapeOf::Lumped(0) => "enh.",
        ShapeOf::Lumped(_) => "basic",
    }
}
