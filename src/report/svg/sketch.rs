//! Pictures to scale.

use super::{Anchor, Drawing, WIDTH, px, text_width};
use crate::document::{Ink, Place, Sketch, SketchFrame, Stroke};

/// Around the lines of a frame, px: room for the names at their ends.
const EDGE: f64 = 34.0;
const TOP: f64 = 24.0;
/// The highest a frame's lines are, px.
const HIGHEST: f64 = 340.0;

/// Description, height in px, drawing.
pub fn draw(sketch: &Sketch) -> (String, f64, Drawing) {
    let mut drawing = Drawing::default();
    let width = WIDTH / sketch.frames.len().max(1) as f64;
    let mut height: f64 = 0.0;
    for (at, frame) in sketch.frames.iter().enumerate() {
        let left = width * at as f64;
        drawing.text("strong", [left + 4.0, 14.0], Anchor::Start, &frame.title);
        if let Some(map) = Map::new(frame, left, width) {
            frame.strokes.iter().for_each(|stroke| map.draw(&mut drawing, stroke));
            height = height.max(map.height);
        }
    }
    let titles: Vec<&str> = sketch.frames.iter().map(|frame| frame.title.as_str()).collect();
    let bottom = TOP + height + 2.0 * EDGE;
    (format!("{}. {}", titles.join("; "), sketch.legend), bottom, drawing)
}

fn class(ink: Ink) -> &'static str {
    match ink {
        Ink::Pinion => "curve pinion",
        Ink::Gear => "curve gear",
        Ink::Axis => "axis",
        Ink::Action => "curve action",
        Ink::Force => "curve force",
    }
}

/// One scale for both directions, the lines in the middle.
struct Map {
    /// px a unit
    scale: f64,
    /// The frame's left and top, and where that is, px
    corner: Place,
    start: Place,
    /// Of the lines, px
    height: f64,
}

impl Map {
    /// Nothing where there is nothing to draw.
    fn new(frame: &SketchFrame, left: f64, width: f64) -> Option<Self> {
        let [low, high] = frame.bounds();
        let [wide, tall] = [high[0] - low[0], high[1] - low[1]];
        let fit = |room: f64, size: f64| if size > 0.0 { room / size } else { f64::INFINITY };
        let scale = fit(width - 2.0 * EDGE, wide).min(fit(HIGHEST, tall));
        (scale.is_finite() && scale > 0.0).then(|| Self {
            scale,
            corner: [low[0], high[1]],
            start: [left + (width - wide * scale) / 2.0, TOP + EDGE],
            height: tall * scale,
        })
    }

    fn at(&self, [x, y]: Place) -> Place {
        [self.start[0] + (x - self.corner[0]) * self.scale, self.start[1] + (self.corner[1] - y) * self.scale]
    }

    fn draw(&self, drawing: &mut Drawing, stroke: &Stroke) {
        match stroke {
            Stroke::Line { from, to, ink } => drawing.line(class(*ink), self.at(*from), self.at(*to)),
            Stroke::Circle { centre, radius, ink } => {
                circle(drawing, class(*ink), self.at(*centre), radius * self.scale);
            }
            Stroke::Arrow { from, to, name } => arrow(drawing, self.at(*from), self.at(*to), name),
            Stroke::Across { at, towards_viewer, name } => {
                let [x, y] = self.at(*at);
                circle(drawing, "mark", [x, y], 6.0);
                if *towards_viewer {
                    circle(drawing, "full", [x, y], 2.0);
                } else {
                    drawing.line("cross", [x - 4.0, y - 4.0], [x + 4.0, y + 4.0]);
                    drawing.line("cross", [x - 4.0, y + 4.0], [x + 4.0, y - 4.0]);
                }
                drawing.text("label", [x + 9.0, y + 4.0], Anchor::Start, name);
            }
            Stroke::Dot { at, filled } => circle(drawing, if *filled { "full" } else { "mark" }, self.at(*at), 4.0),
            Stroke::Name { at, text, below } => {
                let [x, y] = self.at(*at);
                let half = text_width(text) / 2.0;
                drawing.text(
                    "faint",
                    [x.clamp(half, WIDTH - half), y + if *below { 16.0 } else { 4.0 }],
                    Anchor::Middle,
                    text,
                );
            }
        }
    }
}

fn circle(drawing: &mut Drawing, class: &str, [x, y]: Place, radius: f64) {
    let hollow = if class.starts_with("curve") { " fill=\"none\"" } else { "" };
    drawing.put(&format!("<circle class=\"{class}\" cx=\"{}\" cy=\"{}\" r=\"{}\"{hollow}/>", px(x), px(y), px(radius)));
}

/// With its head and name; nothing of one that is shorter than a pixel.
fn arrow(drawing: &mut Drawing, from: Place, to: Place, name: &str) {
    const HEAD: f64 = 8.0;
    let [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    let length = dx.hypot(dy);
    if length < 1.0 {
        return;
    }
    let [ux, uy] = [dx / length, dy / length];
    drawing.line("curve force", from, to);
    let behind = [to[0] - HEAD * ux, to[1] - HEAD * uy];
    let side = [-uy * HEAD / 2.5, ux * HEAD / 2.5];
    let corners = [to, [behind[0] + side[0], behind[1] + side[1]], [behind[0] - side[0], behind[1] - side[1]]];
    drawing.path("full", &corners, true);
    drawing.text("label", [to[0] + 10.0 * ux, to[1] + 10.0 * uy + 4.0], Anchor::Middle, name);
}
