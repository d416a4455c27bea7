//! Spur and helical pairs, and single shafts of which only the mesh vectors are known, looked at from the +y end: a positive rotation is
//! counter-clockwise.

use nalgebra::Vector3;

use super::scene::{Point, Role, Scene, Shape, View, force_scale};
use super::{PairFigures, ShaftFigures};
use crate::design::Side;
use crate::gear::Pair;

/// Of the smaller pitch radius: the longest force, and the line of action on both sides of the mesh point.
const LONGEST: f64 = 0.8;
const ACTION: f64 = 1.1;

pub(super) fn pair(pair: &Pair, figures: &PairFigures) -> Scene {
    // from the pinion's axis towards the gear's
    let right = pair.pinion.across.cross(&pair.pinion.axis);
    let view = View { right, up: pair.pinion.axis.cross(&right) };
    let radius = pair.pinion.point.z.min(pair.gear.point.z);
    let mut shapes = Vec::new();
    for (side, member) in [(Side::Pinion, &pair.pinion), (Side::Gear, &pair.gear)] {
        let frame = Frame {
            view,
            axis: member.axis,
            across: member.across,
            inwards: member.axis.cross(&member.across),
            centre: member.origin,
            radius: member.point.z,
        };
        shapes.extend(frame.shapes(side, figures.shaft(side), force_scale(figures, LONGEST * radius)));
        if side == Side::Pinion {
            shapes.extend(frame.action(member.line_of_action.x, member.line_of_action.z, ACTION * radius));
        }
    }
    let kind = figures.kind.map_or("", |kind| kind.word());
    let title = format!("{kind}: pitch cylinders from their +y end");
    Scene { titles: vec![title, format!("{kind}: from the +y end"), kind.into()], shapes }
}

/// One shaft in its own frame: z upwards, x to the left.
pub(super) fn shaft(side: Side, figures: &PairFigures) -> Scene {
    let shaft = figures.shaft(side);
    let view = View { right: -Vector3::x(), up: Vector3::z() };
    let ([x, _, z], [nx, _, nz]) = (shaft.vectors.point, shaft.vectors.line_of_action);
    let radius = x.hypot(z);
    let outwards = Vector3::new(x, 0.0, z) / radius;
    let frame = Frame {
        view,
        axis: Vector3::y(),
        across: Vector3::y().cross(&outwards),
        inwards: -outwards,
        centre: Vector3::zeros(),
        radius,
    };
    let mut shapes = frame.shapes(side, shaft, force_scale(figures, LONGEST * radius));
    let line = Vector3::new(nx, 0.0, nz);
    shapes.extend(frame.action(line.dot(&frame.across), line.dot(&outwards), ACTION * radius));
    let short = format!("{}: z up, x left", side.name());
    Scene { titles: vec![format!("{} from its +y end: z up, x left", side.name()), short], shapes }
}

/// A shaft as it is seen from its end: which way is what in space.
struct Frame {
    view: View,
    axis: Vector3<f64>,
    /// Where a force at the mesh point turns the shaft positively
    across: Vector3<f64>,
    /// From the mesh point to the axis
    inwards: Vector3<f64>,
    centre: Vector3<f64>,
    /// Of the mesh point, m
    radius: f64,
}

impl Frame {
    fn mesh_point(&self) -> Vector3<f64> {
        self.centre - self.inwards * self.radius
    }

    fn shapes(&self, side: Side, shaft: &ShaftFigures, scale: f64) -> Vec<Shape> {
        let (centre, at) = (self.view.of(self.centre), self.view.of(self.mesh_point()));
        let mut shapes = vec![
            Shape::Circle { centre, radius: self.radius, role: Role::Pitch(side) },
            Shape::Line { from: centre, to: at, role: Role::Axis(side) },
            Shape::Label { at: centre - Point::new(0.0, self.radius), text: side.name() },
        ];
        if let Some(force) = shaft.force {
            let arrow = |along: Vector3<f64>, letter: char| Shape::Force {
                from: at,
                to: self.view.of(self.mesh_point() + along * scale),
                side,
                letter,
            };
            let towards_viewer = force.axial * self.axis.dot(&self.view.towards_viewer()) > 0.0;
            shapes.push(arrow(self.across * force.tangential, 't'));
            shapes.push(arrow(self.inwards * force.radial, 'r'));
            if force.axial.abs() > 1e-9 * force.tangential.abs() {
                shapes.push(Shape::ForceAcross { at: centre, towards_viewer, side, letter: 'a' });
            }
        }
        shapes.push(Shape::MeshPoint(at));
        shapes
    }

    /// The line of action through the mesh point, and its arm about the axis. Its components across and outwards.
    fn action(&self, across: f64, outwards: f64, reach: f64) -> Vec<Shape> {
        let along = self.across * across - self.inwards * outwards;
        let Some(along) = along.try_normalize(1e-9) else { return Vec::new() };
        let at = self.mesh_point();
        let foot = at - along * (at - self.centre).dot(&along);
        let [from, to, centre, foot] =
            [at - along * reach, at + along * reach, self.centre, foot].map(|point| self.view.of(point));
        vec![Shape::Line { from, to, role: Role::Action }, Shape::Line { from: centre, to: foot, role: Role::Action }]
    }
}
