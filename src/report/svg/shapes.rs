//! Shapes of shafts, small spectra in rows, and values in squares.

use super::axis::Axis;
use super::curve::places;
use super::frame::legend_of;
use super::panels::class;
use super::{Anchor, Drawing, WIDTH};
use crate::document::{Curve, Matrix, Plane, Rows, Shaft, Shafts};
use crate::text::{cut, printable};

const LEFT: f64 = 64.0;
const RIGHT: f64 = WIDTH - 20.0;

/// A row a shaft, a column a plane.
pub fn shafts(shafts: &Shafts) -> (String, f64, Drawing) {
    const ROW: f64 = 150.0;
    const TOP: f64 = 30.0;
    let mut drawing = Drawing::default();
    let first = shafts.shafts.first().and_then(|shaft| shaft.planes.first());
    let curves = || first.into_iter().flat_map(|plane| &plane.curves);
    let lines: Vec<(&str, &str)> = curves().map(|curve| (class(curve.line), curve.name.as_str())).collect();
    legend_of(&mut drawing, [LEFT, 14.0], &lines, "");
    for (row, shaft) in shafts.shafts.iter().enumerate() {
        let middle = TOP + ROW * (row as f64 + 0.5);
        drawing.text("strong", [4.0, middle + 4.0], Anchor::Start, &shaft.name);
        let count = shaft.planes.len().max(1) as f64;
        let width = (RIGHT - LEFT) / count;
        for (column, plane) in shaft.planes.iter().enumerate() {
            let from = LEFT + width * column as f64;
            draw_plane(&mut drawing, shaft, plane, [from, from + width - 20.0], [middle, ROW / 2.0 - 18.0]);
        }
    }
    let names: Vec<&str> = curves().map(|curve| curve.name.as_str()).collect();
    let text = format!(
        "Displacement across the axis of both shafts in two planes, of the largest displacement of all: {}. Triangles are bearings, filled \
         where rigid; the cross is the mesh.",
        names.join(", ")
    );
    (text, TOP + ROW * shafts.shafts.len() as f64, drawing)
}

fn draw_plane(drawing: &mut Drawing, shaft: &Shaft, plane: &Plane, [from, to]: [f64; 2], [middle, half]: [f64; 2]) {
    let (start, end) = shaft.ends;
    drawing.text("faint", [from, middle - half - 4.0], Anchor::Start, &plane.name);
    drawing.line("axis", [from, middle], [to, middle]);
    if end.partial_cmp(&start) != Some(std::cmp::Ordering::Greater) {
        return;
    }
    let x = Axis { low: start, high: end, log: false, from, to };
    let y = Axis { low: -1.0, high: 1.0, log: false, from: middle + half, to: middle - half };
    for &(position, is_rigid) in &shaft.bearings {
        let (at, class) = (x.at(position), if is_rigid { "full" } else { "mark" });
        drawing.path(class, &[[at, middle + 2.0], [at - 5.0, middle + 11.0], [at + 5.0, middle + 11.0]], true);
    }
    let at = x.at(shaft.mesh);
    drawing.line("cross", [at - 4.0, middle - 4.0], [at + 4.0, middle + 4.0]);
    drawing.line("cross", [at - 4.0, middle + 4.0], [at + 4.0, middle - 4.0]);
    for Curve { line, points, .. } in plane.curves.iter().rev() {
        drawing.path(&format!("curve {}", class(*line)), &places(&x, &y, points.iter().copied()), false);
    }
}

/// A name and a small spectrum in each row, all at one scale.
pub fn rows(rows: &Rows) -> (String, f64, Drawing) {
    const ROW: f64 = 34.0;
    const TOP: f64 = 26.0;
    const NAMES: f64 = 220.0;
    const LONGEST: usize = 32;
    let mut drawing = Drawing::default();
    drawing.text("label", [NAMES, 14.0], Anchor::Start, &rows.label);
    for (at, (name, levels)) in rows.rows.iter().enumerate() {
        let bottom = TOP + ROW * (at as f64 + 1.0) - 4.0;
        drawing.text("label", [4.0, bottom - 6.0], Anchor::Start, &cut(&printable(name), LONGEST, "…"));
        drawing.line("grid", [NAMES, bottom], [RIGHT, bottom]);
        let x =
            Axis { low: 0.0, high: levels.len().saturating_sub(1).max(1) as f64, log: false, from: NAMES, to: RIGHT };
        let y = Axis { low: rows.range.0, high: rows.range.1, log: false, from: bottom, to: bottom - ROW + 8.0 };
        let points = levels.iter().enumerate().map(|(i, level)| (i as f64, *level));
        drawing.path("curve fe", &places(&x, &y, points.filter(|point| point.1.is_finite())), false);
    }
    let text = format!("{}, {} designs, all at one scale.", rows.label, rows.rows.len());
    (text, TOP + ROW * rows.rows.len() as f64 + 6.0, drawing)
}

/// The darker a square, the nearer its value is to 1.
pub fn matrix(matrix: &Matrix) -> (String, f64, Drawing) {
    const TOP: f64 = 40.0;
    const WIDEST: f64 = 18.0;
    let columns = matrix.rows.iter().map(Vec::len).max().unwrap_or(0);
    let side = ((RIGHT - LEFT) / columns.max(1) as f64).min(WIDEST);
    let mut drawing = Drawing::default();
    let labels = format!("rows: {}, columns: {}", matrix.row_label, matrix.column_label);
    drawing.text("label", [4.0, 14.0], Anchor::Start, &labels);
    for (row, values) in matrix.rows.iter().enumerate() {
        let top = TOP + side * row as f64;
        drawing.text("faint", [LEFT - 6.0, top + side * 0.8], Anchor::End, &(row + 1).to_string());
        for (column, value) in values.iter().enumerate() {
            let left = LEFT + side * column as f64;
            if row == 0 && column % 5 == 0 {
                drawing.text("faint", [left, TOP - 8.0], Anchor::Start, &(column + 1).to_string());
            }
            // a square of the same area as the value: told apart without shades
            let half = side / 2.0 * value.clamp(0.0, 1.0).sqrt() * 0.95;
            if half > 0.2 {
                let (x, y) = (left + side / 2.0, top + side / 2.0);
                let text = format!("{}, {}: {value:.3}", row + 1, column + 1);
                drawing.rect("shade", [x - half, y - half], [x + half, y + half], Some(&text));
            }
        }
    }
    let height = TOP + side * matrix.rows.len() as f64 + 10.0;
    drawing.rect("frame", [LEFT, TOP], [LEFT + side * columns as f64, height - 10.0], None);
    (format!("{} by {}: the larger a square, the nearer to 1.", matrix.row_label, matrix.column_label), height, drawing)
}
