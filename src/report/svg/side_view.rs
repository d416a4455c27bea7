//! Both shafts from the side, to one scale. A body is drawn as the cylinder that has its mass and inertias.

use super::{Anchor, Drawing, Picture, WIDTH, text_width};
use crate::design::{BearingModel, Body, Design, RotorDesign, Side};
use crate::number::ticks::round_step;
use crate::text::cut;

const LEFT: f64 = 64.0;
const RIGHT: f64 = WIDTH - 20.0;
/// What both shafts together may take, px
const HIGHEST: f64 = 380.0;
/// Room for marks and names under each shaft, px
const MARKS: f64 = 62.0;
const TOP: f64 = 20.0;
const BASE: f64 = 34.0;

/// From both designs' data alone, without anything solved.
pub fn side_view(design: &Design) -> Picture {
    let shafts = Side::BOTH.map(|side| Shaft::new(design, side));
    let start = shafts.iter().map(|shaft| shaft.start).fold(0.0, f64::min);
    let end = shafts.iter().map(|shaft| shaft.end).fold(0.0, f64::max);
    let radii: f64 = shafts.iter().map(|shaft| shaft.radius).sum();
    let scale = ((RIGHT - LEFT) / (end - start)).min(HIGHEST / (2.0 * radii));
    let mut drawing = Drawing::default();
    let mut y = TOP;
    if scale.is_finite() && scale > 0.0 {
        for shaft in &shafts {
            shaft.draw(&mut drawing, Place { start, scale, axis: y + shaft.radius * scale });
            y += 2.0 * shaft.radius * scale + MARKS;
        }
        scale_bar(&mut drawing, scale, y);
    } else {
        drawing.text("label", [LEFT, y + 12.0], Anchor::Start, "lengths too far apart for a drawing to scale");
    }
    Picture {
        name: "side-view",
        title: format!("Side view of {}", design.name),
        description: format!(
            "Both shafts from the side to one scale, the pinion above, the gear below: segments, bodies as cylinders of equal mass and \
             inertia (dashed), bearings as triangles (filled where rigid), the mesh point as a cross, the drive as a circle. {} {}",
            shafts[0].in_words(),
            shafts[1].in_words()
        ),
        height: y + BASE,
        body: drawing.0,
    }
}

fn scale_bar(drawing: &mut Drawing, scale: f64, y: f64) {
    // at most a quarter of the width
    let longest = 1e3 * (RIGHT - LEFT) / 4.0 / scale;
    let step = round_step(longest / 2.5);
    let length = step * 1e-3 * scale;
    drawing.line("cross", [LEFT, y], [LEFT + length, y]);
    for x in [LEFT, LEFT + length] {
        drawing.line("cross", [x, y - 4.0], [x, y + 4.0]);
    }
    drawing.text("label", [LEFT + length + 8.0, y + 4.0], Anchor::Start, &format!("{step} mm"));
}

/// Where one shaft is in the picture: m at the left edge, px per m, px of its axis.
#[derive(Debug, Clone, Copy)]
struct Place {
    start: f64,
    scale: f64,
    axis: f64,
}

impl Place {
    fn at(&self, position: f64, radius: f64) -> [f64; 2] {
        let x = LEFT + (position - self.start) * self.scale;
        [x.clamp(LEFT, RIGHT), self.axis - radius * self.scale]
    }
}

struct Shaft<'a> {
    side: Side,
    rotor: &'a RotorDesign,
    /// Position along the shaft and height above its axis, m
    mesh: [f64; 2],
    start: f64,
    end: f64,
    radius: f64,
}

impl<'a> Shaft<'a> {
    fn new(design: &'a Design, side: Side) -> Self {
        let rotor = design.rotor(side);
        let [x, y, z] = design.mesh.vectors(side).point;
        // on the side of the other shaft
        let up = if side == Side::Pinion { -1.0 } else { 1.0 };
        let mesh = [rotor.mesh_position + y, up * x.hypot(z)];
        let (mut start, mut end, mut radius) = (mesh[0].min(0.0), mesh[0].max(rotor.length()), mesh[1].abs());
        for segment in &rotor.segments {
            radius = radius.max(segment.outer_diameter / 2.0);
        }
        for body in &rotor.bodies {
            let [half, outer] = cylinder(body);
            (start, end) = (start.min(body.position - half), end.max(body.position + half));
            radius = radius.max(outer);
        }
        Self { side, rotor, mesh, start, end, radius }
    }

    fn in_words(&self) -> String {
        let mm = |position: f64| format!("{} mm", rounded_mm(position));
        let name = self.side.name();
        let bearings: Vec<String> = self.rotor.bearings.iter().map(|bearing| mm(bearing.position)).collect();
        format!(
            "The {name} shaft is {} long, its mesh station lies at {}, its bearings at {}{}.",
            mm(self.rotor.length()),
            mm(self.rotor.mesh_position),
            bearings.join(", "),
            self.rotor.drive.map_or(String::new(), |drive| format!(", its drive at {}", mm(drive.position)))
        )
    }

    fn draw(&self, drawing: &mut Drawing, place: Place) {
        let rotor = self.rotor;
        drawing.text("strong", [4.0, place.axis + 4.0], Anchor::Start, self.side.name());
        let shapes = rotor.bodies.iter().map(|body| (body, cylinder(body)));
        for (body, [half, outer]) in shapes {
            let [from, to] = [body.position - half, body.position + half];
            drawing.rect("body", place.at(from, outer), place.at(to, -outer), Some(&format!("body {}", body.name)));
        }
        let mut from = 0.0;
        for (i, segment) in rotor.segments.iter().enumerate() {
            let (to, outer, inner) =
                (from + segment.length, segment.outer_diameter / 2.0, segment.inner_diameter / 2.0);
            let title = format!("segment {}", i + 1);
            drawing.rect("steel", place.at(from, outer), place.at(to, -outer), Some(&title));
            if inner > 0.0 {
                for radius in [inner, -inner] {
                    drawing.line("bore", place.at(from, radius), place.at(to, radius));
                }
            }
            from = to;
        }
        drawing.line("axis", place.at(self.start, 0.0), place.at(self.end, 0.0));
        let [x, y] = place.at(self.mesh[0], self.mesh[1]);
        drawing.line("cross", [x - 5.0, y - 5.0], [x + 5.0, y + 5.0]);
        drawing.line("cross", [x - 5.0, y + 5.0], [x + 5.0, y - 5.0]);
        self.draw_marks(drawing, place);
    }

    /// Bearings, mesh station and drive under the shaft, with names in up to three lines where there is room.
    fn draw_marks(&self, drawing: &mut Drawing, place: Place) {
        const LONGEST: usize = 28;
        let base = place.axis + self.radius * place.scale;
        let x_of = |position: f64| place.at(position, 0.0)[0];
        let mut labels: Vec<(f64, String)> = Vec::new();
        for bearing in &self.rotor.bearings {
            let x = x_of(bearing.position);
            let class = if matches!(bearing.model, BearingModel::Rigid(_)) { "full" } else { "mark" };
            drawing.path(class, &[[x, base + 3.0], [x - 6.0, base + 14.0], [x + 6.0, base + 14.0]], true);
            labels.push((x, cut(&crate::text::printable(&bearing.name), LONGEST, "…")));
        }
        let mesh = x_of(self.rotor.mesh_position);
        drawing.line("cross", [mesh, base + 3.0], [mesh, base + 14.0]);
        labels.push((mesh, "mesh".into()));
        if let Some(drive) = self.rotor.drive {
            let drive = x_of(drive.position);
            drawing.put(&format!(
                "<circle class=\"mark\" cx=\"{}\" cy=\"{}\" r=\"5\"/>",
                super::px(drive),
                super::px(base + 9.0)
            ));
            labels.push((drive, if self.side == Side::Pinion { "engine" } else { "load" }.into()));
        }
        labels.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut free = [0.0_f64; 3];
        for (x, label) in labels {
            let half = text_width(&label) / 2.0;
            let x = x.clamp(half.min(WIDTH / 2.0), (WIDTH - half).max(WIDTH / 2.0));
            let line = free.iter().position(|free| x - half >= *free);
            if let Some(line) = line {
                drawing.text("label", [x, base + 27.0 + 12.0 * line as f64], Anchor::Middle, &label);
                free[line] = x + half + 6.0;
            }
        }
    }
}

/// Half the length and the radius of the cylinder with a body's mass and inertias, m; a body without mass has neither.
fn cylinder(body: &Body) -> [f64; 2] {
    if body.mass <= 0.0 {
        return [0.0; 2];
    }
    let square = 2.0 * body.polar_inertia / body.mass;
    let thickness = (12.0 * body.diametral_inertia / body.mass - 3.0 * square).max(0.0).sqrt();
    [thickness / 2.0, square.sqrt()]
}

/// As a person would write it: 18, 27.46
fn rounded_mm(position: f64) -> f64 {
    (position * 1e5).round() / 100.0 + 0.0
}
