//! Both shafts from the side, to one scale.
//!
//! ```text
//! ├ Side view ───────────────────┤
//! │      ⢠⣶⡄                     │
//! │pinion⣿⣿⣿⣿⣿⣿⣿⣿⣿⣿⣿⣿            │
//! │      ⠘×⠃ m △      △    E     │
//! │       ⣿                      │
//! │gear   ⣿⣿⣿⣿⣿⣿⣿                │
//! │       m  ▲   ▲  L            │
//! └ △ bearing  ▲ rigid  × mesh ──┘
//! ```
//!
//! A body is drawn as the cylinder with its mass and inertias. Under each shaft: its bearings, its mesh station `m`, its
//! drive. The mesh point of a shaft is on the side of the other one.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::canvas::{Canvas, Pen};
use super::panel::{Title, put};
use crate::design::{BearingModel, Body, Design, MeshVectors, RotorDesign, Side};
use crate::tui::theme::Theme;

const LABELS: u16 = 8;

/// What the marks mean, for the frame's last line.
pub fn legend(theme: &Theme) -> Title<'static> {
    let glyphs = theme.glyphs;
    let marks = format!("{} bearing  {} rigid  {} mesh", glyphs.bearing, glyphs.rigid_bearing, glyphs.mesh);
    Title { left: vec![format!("{marks}  E L drives"), marks], right: Vec::new() }
}

/// One thing on a shaft, by place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Element {
    Segment(usize),
    Bearing(usize),
    Body(usize),
    Mesh,
    Drive,
}

/// Draws both shafts.
pub fn render(design: &Design, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    render_with(design, None, theme, area, buffer);
}

/// Draws both shafts with one thing pointed out: an arrow above it, and brackets around a segment.
pub fn render_with(design: &Design, pointed: Option<(Side, Element)>, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let area = Rect { width: area.width.saturating_sub(1), ..area };
    // a row for the marks and at least one for the shaft, twice
    if area.height < 4 || area.width < LABELS + 4 {
        return;
    }
    let shafts = [
        Shaft::new("pinion", &design.pinion, &design.mesh.pinion, 'E', -1.0),
        Shaft::new("gear", &design.gear, &design.mesh.gear, 'L', 1.0),
    ];
    let picture = Rect { x: area.x + LABELS, width: area.width - LABELS, ..area };
    let rows = usize::from(area.height) - 2;
    let (start, end) =
        shafts.iter().fold((0.0_f64, 0.0_f64), |(start, end), shaft| (start.min(shaft.start), end.max(shaft.end)));
    let (across, down) = theme.marker.dots();
    // a cell is about twice as high as wide
    let aspect = 2.0 * across as f64 / down as f64;
    let radii: f64 = shafts.iter().map(|shaft| shaft.radius).sum();
    let across_scale = (f64::from(picture.width) * across as f64 - 1.0) / (end - start);
    let down_scale = (rows * down) as f64 * aspect / (2.0 * radii);
    let scale = across_scale.min(down_scale);
    if !(scale.is_finite() && scale > 0.0) {
        return;
    }
    let share = (rows as f64 * shafts[0].radius / radii).round() as usize;
    let heights = [share.clamp(1, rows - 1), rows - share.clamp(1, rows - 1)];
    let mut y = area.y;
    for (shaft, height) in shafts.iter().zip(heights) {
        let band = Rect { y, height: height as u16 + 1, ..picture };
        buffer.set_stringn(
            area.x,
            y + height as u16 / 2,
            format!(" {}", shaft.label),
            usize::from(LABELS),
            theme.faint,
        );
        let scale = Scale { start, across: scale, down: scale / aspect };
        shaft.render(scale, theme, band, buffer);
        if let Some((_, element)) = pointed.filter(|(side, _)| side.name() == shaft.label) {
            shaft.point_out(element, scale, theme, band, buffer);
        }
        y += height as u16 + 1;
    }
}

/// Dots per metre, and the position at the left edge.
#[derive(Debug, Clone, Copy)]
struct Scale {
    start: f64,
    across: f64,
    down: f64,
}

impl Scale {
    fn dot(&self, position: f64) -> f64 {
        (position - self.start) * self.across
    }
}

struct Shaft<'a> {
    label: &'static str,
    rotor: &'a RotorDesign,
    drive: char,
    /// Position along the shaft and distance from its axis, downwards, m
    mesh: (f64, f64),
    /// Ends and largest radius of all that is drawn, m
    start: f64,
    end: f64,
    radius: f64,
}

impl<'a> Shaft<'a> {
    fn new(label: &'static str, rotor: &'a RotorDesign, mesh: &MeshVectors, drive: char, side: f64) -> Self {
        let [x, y, z] = mesh.point;
        let mesh = (rotor.mesh_position + y, -side * x.hypot(z));
        let (mut start, mut end, mut radius) = (mesh.0.min(0.0), rotor.length().max(mesh.0), mesh.1.abs());
        for segment in &rotor.segments {
            radius = radius.max(segment.outer_diameter / 2.0);
        }
        for body in &rotor.bodies {
            let cylinder = Cylinder::of(body);
            start = start.min(body.position - cylinder.thickness / 2.0);
            end = end.max(body.position + cylinder.thickness / 2.0);
            radius = radius.max(cylinder.radius);
        }
        Self { label, rotor, drive, mesh, start, end, radius }
    }

    fn render(&self, scale: Scale, theme: &Theme, area: Rect, buffer: &mut Buffer) {
        let picture = Rect { height: area.height - 1, ..area };
        let mut canvas = Canvas::new(picture.width, picture.height, theme.marker);
        let middle = (canvas.dots_high() as f64 - 1.0) / 2.0;
        for body in &self.rotor.bodies {
            let cylinder = Cylinder::of(body);
            let from = scale.dot(body.position - cylinder.thickness / 2.0);
            let to = scale.dot(body.position + cylinder.thickness / 2.0).max(from + 1.0);
            fill(
                &mut canvas,
                (from, to),
                (0.0, cylinder.radius * scale.down),
                middle,
                Pen { style: theme.enhanced, letter: 'H' },
            );
        }
        let mut from = 0.0;
        for segment in &self.rotor.segments {
            let to = from + segment.length;
            let radii = (segment.inner_diameter / 2.0 * scale.down, segment.outer_diameter / 2.0 * scale.down);
            fill(&mut canvas, (scale.dot(from), scale.dot(to)), radii, middle, Pen { style: theme.fe, letter: '=' });
            from = to;
        }
        canvas.render(picture, buffer);
        self.render_marks(scale, theme, area, middle, buffer);
    }

    fn render_marks(&self, scale: Scale, theme: &Theme, area: Rect, middle: f64, buffer: &mut Buffer) {
        let (across, down) = theme.marker.dots();
        let cell = |position: f64| ((scale.dot(position).max(0.0) as usize / across) as u16).min(area.width - 1);
        let row = ((middle + self.mesh.1 * scale.down).max(0.0) as usize / down) as u16;
        put(buffer, area.x + cell(self.mesh.0), area.y + row.min(area.height - 2), theme.glyphs.mesh, theme.warning);

        let mut marks = vec![' '; usize::from(area.width)];
        let mut mark = |position: f64, character: char| {
            let wanted = usize::from(cell(position));
            // where two marks meet, the later one moves to the nearest free place
            let free = (0..marks.len()).filter(|&at| marks[at] == ' ').min_by_key(|&at| at.abs_diff(wanted));
            if let Some(at) = free {
                marks[at] = character;
            }
        };
        for bearing in &self.rotor.bearings {
            let rigid = matches!(bearing.model, BearingModel::Rigid(_));
            mark(bearing.position, if rigid { theme.glyphs.rigid_bearing } else { theme.glyphs.bearing });
        }
        mark(self.rotor.mesh_position, 'm');
        if let Some(drive) = &self.rotor.drive {
            mark(drive.position, self.drive);
        }
        buffer.set_stringn(area.x, area.bottom() - 1, marks.iter().collect::<String>(), marks.len(), theme.title);
    }
}

impl Shaft<'_> {
    fn point_out(&self, element: Element, scale: Scale, theme: &Theme, area: Rect, buffer: &mut Buffer) {
        let rotor = self.rotor;
        let extent = match element {
            Element::Segment(at) => rotor.segments.get(at).map(|segment| {
                let start: f64 = rotor.segments[..at].iter().map(|segment| segment.length).sum();
                (start, start + segment.length)
            }),
            Element::Bearing(at) => rotor.bearings.get(at).map(|bearing| (bearing.position, bearing.position)),
            Element::Body(at) => rotor.bodies.get(at).map(|body| (body.position, body.position)),
            Element::Mesh => Some((rotor.mesh_position, rotor.mesh_position)),
            Element::Drive => rotor.drive.map(|drive| (drive.position, drive.position)),
        };
        let Some((from, to)) = extent else { return };
        let (across, _) = theme.marker.dots();
        let last = usize::from(area.width).saturating_sub(1);
        let cell = |position: f64| ((scale.dot(position).max(0.0) as usize / across).min(last)) as u16;
        let style = theme.title.patch(theme.selected);
        let (left, right) = (cell(from), cell(to).max(cell(from)));
        let high = area.height > 2;
        if right > left + 1 {
            let y = area.y + (area.height - 1) / 2;
            put(buffer, area.x + left, y, '[', style);
            put(buffer, area.x + right - 1, y, ']', style);
        }
        // above the middle of it, in the first row of the shaft's picture, if that has a row for both
        if !high && right > left + 1 {
            return;
        }
        put(
            buffer,
            area.x + u16::midpoint(left, right.saturating_sub(1).max(left)),
            area.y,
            theme.glyphs.pointer,
            style,
        );
    }
}

/// Sets the dots between two distances from the axis, at least one, above and below it.
fn fill(canvas: &mut Canvas, (from, to): (f64, f64), (inner, outer): (f64, f64), middle: f64, pen: Pen) {
    let last = (to.ceil() as usize).min(canvas.dots_wide());
    for x in (from.round().max(0.0) as usize)..last {
        for y in 0..canvas.dots_high() {
            let distance = (y as f64 - middle).abs();
            // a bore of less than a dot does not show
            if distance <= outer.max(0.5) && (distance >= inner || inner < 1.0) {
                canvas.set(x, y, pen);
            }
        }
    }
}

/// The cylinder with the mass and the inertias of a body.
struct Cylinder {
    radius: f64,
    thickness: f64,
}

impl Cylinder {
    fn of(body: &Body) -> Self {
        if body.mass <= 0.0 {
            return Self { radius: 0.0, thickness: 0.0 };
        }
        let square = 2.0 * body.polar_inertia / body.mass;
        let thickness = (12.0 * body.diametral_inertia / body.mass - 3.0 * square).max(0.0);
        Self { radius: square.sqrt(), thickness: thickness.sqrt() }
    }
}
