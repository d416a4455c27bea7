//! Pictures to scale, as lines in a plane.

/// A place, in any unit that all of a frame share; x to the right, y upwards.
pub type Place = [f64; 2];

/// Frames beside one another, each to its own scale.
#[derive(Debug, Clone, Default)]
pub struct Sketch {
    /// What the marks mean, in words
    pub legend: String,
    pub frames: Vec<SketchFrame>,
}

#[derive(Debug, Clone)]
pub struct SketchFrame {
    pub title: String,
    pub strokes: Vec<Stroke>,
}

/// What a line is, for colours and dashes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ink {
    Pinion,
    Gear,
    Axis,
    Action,
    Force,
}

/// One thing in a frame.
#[derive(Debug, Clone, PartialEq)]
pub enum Stroke {
    Line {
        from: Place,
        to: Place,
        ink: Ink,
    },
    Circle {
        centre: Place,
        radius: f64,
        ink: Ink,
    },
    /// With its name at the head
    Arrow {
        from: Place,
        to: Place,
        name: String,
    },
    /// An arrow towards the viewer, or away
    Across {
        at: Place,
        towards_viewer: bool,
        name: String,
    },
    /// Filled or not
    Dot {
        at: Place,
        filled: bool,
    },
    /// At its place, or below it
    Name {
        at: Place,
        text: String,
        below: bool,
    },
}

impl SketchFrame {
    /// The corners of all that is in it: left and bottom, right and top. Infinite where there is nothing.
    pub fn bounds(&self) -> [Place; 2] {
        let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        let mut add = |[x, y]: Place| {
            bounds = [[bounds[0][0].min(x), bounds[0][1].min(y)], [bounds[1][0].max(x), bounds[1][1].max(y)]];
        };
        for stroke in &self.strokes {
            match *stroke {
                Stroke::Line { from, to, .. } | Stroke::Arrow { from, to, .. } => {
                    add(from);
                    add(to);
                }
                Stroke::Circle { centre: [x, y], radius, .. } => {
                    add([x - radius, y - radius]);
                    add([x + radius, y + radius]);
                }
                Stroke::Across { at, .. } | Stroke::Dot { at, .. } | Stroke::Name { at, .. } => add(at),
            }
        }
        bounds
    }
}
