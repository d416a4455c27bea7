//! Motions that no plane shows: along and about the axis, beside the pictures of a shape.
//!
//! ```text
//!  pinion     FE  enh.       in three rows  p axial    0.12  0.11
//!  axial    0.12  0.11                       torsion  0.98  0.97
//!  torsion  0.98  0.97                       drive    0.30  0.30
//!  drive    0.30  0.30
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use crate::design::{RotorDesign, Side};
use crate::model::ModelKind;
use crate::response::StationShape;
use crate::tui::theme::Theme;

/// Columns that are taken.
pub const WIDTH: u16 = 22;

/// One motion of a shape.
type Value<'a> = dyn Fn(&StationShape<f64>) -> f64 + 'a;

/// Draws the motions at the mesh, and the drive's: parts of the largest displacement and of the largest rotation about an axis.
pub fn render(
    (side, rotor): (Side, &RotorDesign),
    shapes: &[(ModelKind, &StationShape<f64>)],
    largest: [f64; 2],
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) {
    let [across, about] = largest;
    let motions: [(&str, f64, &Value); 3] = [
        ("axial", across, &|shape| at_mesh(shape, rotor, 1)),
        ("torsion", about, &|shape| at_mesh(shape, rotor, 4)),
        ("drive", about, &|shape| shape.drive.unwrap_or_default()),
    ];
    let count = if rotor.drive.is_some() { motions.len() } else { motions.len() - 1 };
    let has_head = usize::from(area.height) > count;
    let mut lines = Vec::new();
    if has_head {
        let heads: Vec<String> = shapes.iter().map(|(of, _)| format!("{:>6}", short(*of))).collect();
        lines.push((format!(" {:<8}{}", side.name(), heads.concat()), theme.title));
    }
    for (at, (name, whole, value)) in motions.into_iter().take(count).enumerate() {
        let values: Vec<String> = shapes.iter().map(|(_, shape)| part(value(shape), whole)).collect();
        // without a head the shaft's first letter stands before its first line
        let initial = if has_head { "" } else { side.name().get(..1).filter(|_| at == 0).unwrap_or(" ") };
        let name = if has_head { format!(" {name:<8}") } else { format!("{initial} {name:<7}") };
        lines.push((name + &values.concat(), Style::new()));
    }
    for ((text, style), y) in lines.into_iter().zip(area.top()..area.bottom()) {
        buffer.set_stringn(area.x, y, text, usize::from(WIDTH), style);
    }
}

/// Of the station next to the mesh.
fn at_mesh(shape: &StationShape<f64>, rotor: &RotorDesign, component: usize) -> f64 {
    let distance = |position: f64| (position - rotor.mesh_position).abs();
    let stations = shape.positions.iter().zip(&shape.displacements);
    stations.min_by(|a, b| distance(*a.0).total_cmp(&distance(*b.0))).map_or(0.0, |(_, station)| station[component])
}

fn part(value: f64, whole: f64) -> String {
    // what rounds to nothing has no sign
    let hundredths = if whole > 0.0 { (100.0 * value / whole).round() + 0.0 } else { 0.0 };
    format!("{:>6.2}", hundredths / 100.0)
}

/// A model's name in a narrow column.
pub fn short(kind: ModelKind) -> &'static str {
    match kind {
        ModelKind::Fe => "FE",
        ModelKind::Enhanced => "enh.",
        ModelKind::Basic => "basic",
        ModelKind::Reduced(_) => "red.",
    }
}
