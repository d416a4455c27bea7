//! A gear pair to scale.
//!
//! ```text
//!        gear
//!         ┆ ↑a
//!   ╲─────┼─────◆       ◆ mesh point   • apex
//!    ╲    ┆  ⊗ ╱╎
//! ┄┄┄┄•┄┄┄┆┄┄╱┄┄╎┄→a┄ pinion
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use super::canvas::{Canvas, Pen};
use super::panel::put;
use crate::design::Side;
use crate::pair::{Role, Scene, Shape};
use crate::tui::theme::Theme;

/// Dots of a dashed line that are set, and that are not.
const DASH: (usize, usize) = (4, 3);
/// More dots than a line has on any screen.
const MOST_DOTS: f64 = 4096.0;

/// The narrowest picture with names in it.
const SMALL: u16 = 24;

/// What the marks mean, the longest text first.
pub fn legend(theme: &Theme) -> Vec<String> {
    let [towards, away, mesh, _] = marks(theme);
    let forces = format!("a axial r radial t tangential on pinion, A R T on gear, {towards} to you {away} away");
    vec![
        format!("{forces}, {mesh} mesh point"),
        forces,
        format!("art pinion ART gear {towards} to you {away} away"),
        format!("{towards} to you {away} away"),
    ]
}

/// Towards the viewer, away, mesh point, apex
fn marks(theme: &Theme) -> [char; 4] {
    if theme.glyphs.ascii { ['O', 'X', '@', '*'] } else { ['⊙', '⊗', '◆', '•'] }
}

/// Draws one scene.
pub fn render(scene: &Scene, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let Some(map) = Map::new(scene, theme, area) else { return };
    let mut canvas = Canvas::new(area.width, area.height, theme.marker);
    for shape in &scene.shapes {
        match *shape {
            Shape::Line { from, to, role } => {
                let dash = if matches!(role, Role::Axis(_)) { DASH } else { (1, 0) };
                line(&mut canvas, map.dot(from.into()), map.dot(to.into()), dash, pen(role, theme));
            }
            Shape::Circle { centre, radius, role } => circle(&mut canvas, map, centre.into(), radius, pen(role, theme)),
            Shape::Force { from, to, side, letter } => {
                let pen = Pen { style: theme.warning, letter: of_side(letter, side) };
                line(&mut canvas, map.dot(from.into()), map.dot(to.into()), (1, 0), pen);
            }
            _ => {}
        }
    }
    canvas.render(area, buffer);
    // there is room for the marks, and not for what stands beside them
    let is_small = area.width < SMALL;
    let [towards, away, mesh, apex] = marks(theme);
    let mut mark = |at: [f64; 2], character: char, style: Style| {
        let (x, y) = map.cell(at);
        put(buffer, x, y, character, style);
    };
    for shape in &scene.shapes {
        match *shape {
            Shape::Apex(at) => mark(at.into(), apex, theme.fe),
            Shape::ForceAcross { at, towards_viewer, .. } => {
                mark(at.into(), if towards_viewer { towards } else { away }, theme.warning);
            }
            _ => {}
        }
    }
    // the names first: what lies over them is to scale
    for shape in &scene.shapes {
        if let Shape::Label { at, text } = *shape {
            // below its place, or above where that is the last row
            let (x, y) = map.cell(at.into());
            let y = if y + 1 < area.bottom() { y + 1 } else { y.saturating_sub(1) };
            map.write((x, y), text, theme.faint, buffer);
        }
    }
    for shape in &scene.shapes {
        match *shape {
            Shape::Force { from, to, side, letter } => {
                head(map, (from.into(), to.into()), of_side(letter, side), theme, buffer);
            }
            Shape::ForceAcross { at, side, letter, .. } if !is_small => {
                let (x, y) = map.cell(at.into());
                let letter = of_side(letter, side);
                map.write((x + 1, y), letter.encode_utf8(&mut [0; 4]), theme.warning, buffer);
            }
            _ => {}
        }
    }
    for shape in &scene.shapes {
        if let Shape::MeshPoint(at) = *shape {
            let (x, y) = map.cell(at.into());
            put(buffer, x, y, mesh, theme.title);
        }
    }
}

/// Forces on both members meet at the mesh point: those on the gear have capitals.
fn of_side(letter: char, side: Side) -> char {
    match side {
        Side::Pinion => letter,
        Side::Gear => letter.to_ascii_uppercase(),
    }
}

fn pen(role: Role, theme: &Theme) -> Pen {
    match role {
        Role::Pitch(Side::Pinion) => Pen { style: theme.enhanced, letter: 'p' },
        Role::Pitch(Side::Gear) => Pen { style: theme.basic, letter: 'g' },
        Role::Axis(_) => Pen { style: theme.faint, letter: '.' },
        Role::Action => Pen { style: theme.title, letter: 'n' },
    }
}

/// From the scene to dots and cells.
#[derive(Debug, Clone, Copy)]
struct Map {
    area: Rect,
    /// Dots a metre, across and down
    scale: (f64, f64),
    /// The scene's left and top, m
    corner: [f64; 2],
    /// Where that is, dots
    start: (f64, f64),
    dots: (usize, usize),
}

impl Map {
    /// One scale for both directions, the scene in the middle; nothing where there is no room.
    fn new(scene: &Scene, theme: &Theme, area: Rect) -> Option<Self> {
        if area.width < 8 || area.height < 4 {
            return None;
        }
        let dots = theme.marker.dots();
        let (wide, high) = (usize::from(area.width) * dots.0, usize::from(area.height) * dots.1);
        // a cell is about twice as high as wide
        let aspect = 2.0 * dots.0 as f64 / dots.1 as f64;
        let [low, top] = scene.bounds();
        let size = top - low;
        // a cell on each side for what stands beside the lines
        let room = (wide.saturating_sub(4 * dots.0) as f64, high.saturating_sub(2 * dots.1) as f64);
        let fit = |room: f64, size: f64| if size > 0.0 { room / size } else { f64::INFINITY };
        let scale = fit(room.0, size.x).min(fit(room.1 * aspect, size.y));
        if !(scale.is_finite() && scale > 0.0) {
            return None;
        }
        let scale = (scale, scale / aspect);
        let start = ((wide as f64 - size.x * scale.0) / 2.0, (high as f64 - size.y * scale.1) / 2.0);
        Some(Self { area, scale, corner: [low.x, top.y], start, dots })
    }

    fn dot(&self, [x, y]: [f64; 2]) -> (f64, f64) {
        (self.start.0 + (x - self.corner[0]) * self.scale.0, self.start.1 + (self.corner[1] - y) * self.scale.1)
    }

    /// The cell of a place, on the screen.
    fn cell(&self, at: [f64; 2]) -> (u16, u16) {
        let (x, y) = self.dot(at);
        let cell =
            |dot: f64, dots: usize, last: u16| ((dot.max(0.0) as usize / dots) as u16).min(last.saturating_sub(1));
        (self.area.x + cell(x, self.dots.0, self.area.width), self.area.y + cell(y, self.dots.1, self.area.height))
    }

    /// Writes a text, moved to the left where it would not fit.
    fn write(&self, (x, y): (u16, u16), text: &str, style: Style, buffer: &mut Buffer) {
        let last = self.area.right().saturating_sub(text.width() as u16).max(self.area.x);
        if (self.area.top()..self.area.bottom()).contains(&y) {
            buffer.set_stringn(x.clamp(self.area.x, last), y, text, usize::from(self.area.width), style);
        }
    }
}

fn line(canvas: &mut Canvas, from: (f64, f64), to: (f64, f64), (on, off): (usize, usize), pen: Pen) {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let steps = dx.abs().max(dy.abs()).ceil().min(MOST_DOTS);
    for step in 0..=steps as usize {
        let part = if steps > 0.0 { step as f64 / steps } else { 0.0 };
        let (x, y) = (from.0 + dx * part, from.1 + dy * part);
        if step % (on + off) < on && x >= 0.0 && y >= 0.0 {
            canvas.set(x as usize, y as usize, pen);
        }
    }
}

fn circle(canvas: &mut Canvas, map: Map, [x, y]: [f64; 2], radius: f64, pen: Pen) {
    let around = std::f64::consts::TAU * radius * map.scale.0.max(map.scale.1);
    let steps = around.ceil().clamp(8.0, MOST_DOTS);
    for step in 0..steps as usize {
        let (sin, cos) = (std::f64::consts::TAU * step as f64 / steps).sin_cos();
        let (x, y) = map.dot([x + radius * cos, y + radius * sin]);
        if x >= 0.0 && y >= 0.0 {
            canvas.set(x as usize, y as usize, pen);
        }
    }
}

/// The head of an arrow and the letter of its force beyond; nothing of a force that is none.
fn head(map: Map, (from, to): ([f64; 2], [f64; 2]), letter: char, theme: &Theme, buffer: &mut Buffer) {
    let (right, up) = (to[0] - from[0], to[1] - from[1]);
    if right.hypot(up) * map.scale.0 < 0.5 {
        return;
    }
    let (x, y) = map.cell(to);
    // eighths of a turn, from the right upwards
    let eighth = (up.atan2(right) / std::f64::consts::FRAC_PI_4).round() as i32;
    let eighth = eighth.rem_euclid(8) as usize;
    let heads = if theme.glyphs.ascii {
        [">", "/", "^", "\\", "<", "/", "v", "\\"]
    } else {
        ["→", "↗", "↑", "↖", "←", "↙", "↓", "↘"]
    };
    map.write((x, y), heads[eighth], theme.warning, buffer);
    let beyond = if (3..=5).contains(&eighth) { (x.saturating_sub(1), y) } else { (x + 1, y) };
    map.write(beyond, letter.encode_utf8(&mut [0; 4]), theme.warning, buffer);
}
