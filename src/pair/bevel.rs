//! Bevel and hypoid pairs, looked at along the common perpendicular of both axes: both are seen in true length, at the shaft angle.

use nalgebra::Vector3;

use super::scene::{Point, Role, Scene, Shape, View, force_scale};
use super::{PairFigures, ShaftFigures};
use crate::design::Side;
use crate::gear::{Member, Pair};
use crate::number::significant;

/// Of the largest size of the cones: the longest force, and what an axis shows of itself beyond its cone.
const LONGEST: f64 = 0.4;
const BEYOND: f64 = 0.12;

pub(super) fn pair(pair: &Pair, figures: &PairFigures) -> Scene {
    let right = pair.pinion.axis;
    let across = pair.gear.axis - right * pair.gear.axis.dot(&right);
    // any direction will do where the axes are parallel
    let up = if across.norm() > 1e-9 { across.normalize() } else { pair.pinion.across };
    let view = View { right, up };
    let members = [(Side::Pinion, &pair.pinion), (Side::Gear, &pair.gear)];
    let size = members.iter().map(|(_, member)| member.point.y.max(member.point.z)).fold(0.0, f64::max);
    let scale = force_scale(figures, LONGEST * size);
    let mut shapes = Vec::new();
    for (side, member) in members {
        shapes.extend(cone(view, member, side, size));
    }
    for (side, member) in members {
        shapes.extend(forces(view, member, figures.shaft(side), side, size, scale));
    }
    shapes.extend(members.map(|(_, member)| Shape::Apex(view.of(member.origin))));
    shapes.push(Shape::MeshPoint(view.of(mesh_point(&pair.pinion))));
    let kind = figures.kind.map_or("", |kind| kind.word());
    let offset = if pair.is_offset() {
        format!("along the offset, {} mm", significant(pair.offset * 1e3, 4))
    } else {
        "section through both axes".to_owned()
    };
    Scene {
        titles: vec![format!("{kind}: pitch cones, {offset}"), format!("{kind}: pitch cones"), kind.into()],
        shapes,
    }
}

fn radial(member: &Member) -> Vector3<f64> {
    member.across.cross(&member.axis)
}

fn mesh_point(member: &Member) -> Vector3<f64> {
    member.origin + member.axis * member.point.y + radial(member) * member.point.z
}

/// The cone up to its mean circle, and its axis.
fn cone(view: View, member: &Member, side: Side, size: f64) -> Vec<Shape> {
    let centre = member.origin + member.axis * member.point.y;
    let across = view.towards_viewer().cross(&member.axis) * member.point.z;
    let [apex, one, other] = [member.origin, centre + across, centre - across].map(|point| view.of(point));
    let role = Role::Pitch(side);
    let start = member.origin - member.axis * (BEYOND * size);
    let end = centre + member.axis * ((LONGEST + 2.0 * BEYOND) * size);
    vec![
        Shape::Line { from: view.of(start), to: view.of(end), role: Role::Axis(side) },
        Shape::Line { from: apex, to: one, role },
        Shape::Line { from: apex, to: other, role },
        Shape::Line { from: one, to: other, role },
        Shape::Label { at: view.of(end), text: side.name() },
    ]
}

/// The thrust on the axis beyond the cone, the radial force at the mesh point, the tangential one across the picture.
fn forces(view: View, member: &Member, shaft: &ShaftFigures, side: Side, size: f64, scale: f64) -> Vec<Shape> {
    let Some(force) = shaft.force else { return Vec::new() };
    let (at, centre) = (mesh_point(member), member.origin + member.axis * member.point.y);
    let near = centre + member.axis * (BEYOND * size);
    let far = near + member.axis * (force.axial.abs() * scale);
    let (from, to) = if force.axial < 0.0 { (far, near) } else { (near, far) };
    let inside: Point = view.of((member.origin + centre + at) / 3.0);
    let tangential = member.across * force.tangential;
    vec![
        Shape::Force { from: view.of(from), to: view.of(to), side, letter: 'a' },
        Shape::Force {
            from: view.of(at),
            to: view.of(at - radial(member) * (force.radial * scale)),
            side,
            letter: 'r',
        },
        Shape::ForceAcross {
            at: inside,
            towards_viewer: tangential.dot(&view.towards_viewer()) > 0.0,
            side,
            letter: 't',
        },
    ]
}
