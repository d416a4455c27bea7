//! A picture of the pair to scale, as lines in a plane: what draws it decides on characters or strokes.

use nalgebra::{Vector2, Vector3};

use super::{PairFigures, bevel, parallel};
use crate::design::{Design, Side};

/// A place in the picture, m; x to the right, y upwards.
pub type Point = Vector2<f64>;

/// What a line belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// Pitch surface of that side
    Pitch(Side),
    /// Axis of that side
    Axis(Side),
    /// Line of action, and its arm about the axis
    Action,
}

/// One thing in the picture.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    Line {
        from: Point,
        to: Point,
        role: Role,
    },
    Circle {
        centre: Point,
        radius: f64,
        role: Role,
    },
    /// A component of the tooth force on a shaft: `a` axial, `r` radial, `t` tangential.
    Force {
        from: Point,
        to: Point,
        side: Side,
        letter: char,
    },
    /// The same across the picture.
    ForceAcross {
        at: Point,
        towards_viewer: bool,
        side: Side,
        letter: char,
    },
    MeshPoint(Point),
    Apex(Point),
    Label {
        at: Point,
        text: &'static str,
    },
}

/// One picture, and what it shows, in words.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// The longest first
    pub titles: Vec<String>,
    pub shapes: Vec<Shape>,
}

impl Scene {
    /// The corners of all that is to scale: left and bottom, right and top.
    pub fn bounds(&self) -> [Point; 2] {
        let mut bounds = [Point::repeat(f64::INFINITY), Point::repeat(f64::NEG_INFINITY)];
        let mut add = |point: Point| bounds = [bounds[0].inf(&point), bounds[1].sup(&point)];
        for shape in &self.shapes {
            let [one, other] = match *shape {
                Shape::Line { from, to, .. } | Shape::Force { from, to, .. } => [from, to],
                Shape::Circle { centre, radius, .. } => [-radius, radius].map(|radius| centre + Point::repeat(radius)),
                Shape::ForceAcross { at, .. } | Shape::MeshPoint(at) | Shape::Apex(at) | Shape::Label { at, .. } => {
                    [at, at]
                }
            };
            add(one);
            add(other);
        }
        bounds
    }
}

/// The pictures of a design: one of a pair with gear data, one a shaft where mesh vectors are all that is known. Empty where a size is none.
pub fn scenes(design: &Design, figures: &PairFigures) -> Vec<Scene> {
    let scenes = match (&figures.pair, design.mesh.geometry.as_ref()) {
        (Some(pair), Some(geometry)) if geometry.kind.is_parallel() => vec![parallel::pair(pair, figures)],
        (Some(pair), Some(_)) => vec![bevel::pair(pair, figures)],
        _ => Side::BOTH.map(|side| parallel::shaft(side, figures)).into(),
    };
    let is_drawable = |scene: &Scene| {
        let [low, high] = scene.bounds();
        let size = high - low;
        size.iter().all(|size| size.is_finite()) && size.max() > 0.0
    };
    scenes.into_iter().filter(is_drawable).collect()
}

/// A plane that is looked at: its right, its up, and towards the viewer.
#[derive(Debug, Clone, Copy)]
pub(super) struct View {
    pub right: Vector3<f64>,
    pub up: Vector3<f64>,
}

impl View {
    pub fn towards_viewer(&self) -> Vector3<f64> {
        self.right.cross(&self.up)
    }

    pub fn of(&self, point: Vector3<f64>) -> Point {
        Point::new(point.dot(&self.right), point.dot(&self.up))
    }
}

/// Metres a newton, so that the largest of all components is that long.
pub(super) fn force_scale(figures: &PairFigures, longest: f64) -> f64 {
    let forces = [figures.pinion.force, figures.gear.force].into_iter().flatten();
    let largest =
        forces.flat_map(|force| [force.axial, force.radial, force.tangential]).fold(0.0, |a: f64, b| a.max(b.abs()));
    if largest > 0.0 { longest / largest } else { 0.0 }
}
