//! Shafts whose axes cross: whether one would run through the other.

use super::pair::Pair;
use super::shaft::Shaft;
use crate::gear::Member;

/// Between the surfaces of both shafts, m: a designer's choice.
const CLEARANCE: f64 = 1e-3;

/// A stretch of a shaft along its axis, from where the axes are nearest; m.
#[derive(Debug, Clone, Copy)]
struct Cylinder {
    from: f64,
    to: f64,
    radius: f64,
    what: &'static str,
}

/// What of the pinion and what of the gear would meet, bearings with their outside diameters; nothing where the axes are parallel.
pub(super) fn collision(pair: &Pair, pinion: &Shaft, gear: &Shaft) -> Option<[&'static str; 2]> {
    let (of_pinion, of_gear) = (pair.cone(0)?, pair.cone(1)?);
    let geometry = pair.geometry();
    let across = geometry.pinion.axis.cross(&geometry.gear.axis).normalize();
    // where the common perpendicular meets an axis, along it from its apex: the axes are at a right angle
    let foot = |member: &Member, other: &Member| (other.origin - member.origin).dot(&member.axis);
    let feet = [foot(&geometry.pinion, &geometry.gear), foot(&geometry.gear, &geometry.pinion)];
    let offset = (geometry.gear.origin - geometry.pinion.origin).dot(&across).abs();
    let pinion = cylinders(pinion, pinion.mesh_position - of_pinion.1 + feet[0]);
    let gear = cylinders(gear, gear.mesh_position - of_gear.1 + feet[1]);
    let pairs = pinion.iter().flat_map(|one| gear.iter().map(move |other| (one, other)));
    let mut meeting = pairs.filter(|(one, other)| meet(one, other, offset));
    meeting.next().map(|(one, other)| [one.what, other.what])
}

/// Bearings first: they are what can be chosen. `foot`: where the axes are nearest, in the shaft's own coordinate.
fn cylinders(shaft: &Shaft, foot: f64) -> Vec<Cylinder> {
    let names = ["bearing B1", "bearing B2"];
    let mut all: Vec<Cylinder> = names
        .into_iter()
        .zip(&shaft.bearings)
        .map(|(what, placed)| {
            let [from, to] = [-0.5, 0.5].map(|share| placed.position + share * placed.bearing.width - foot);
            Cylinder { from, to, radius: placed.bearing.outside_diameter / 2.0, what }
        })
        .collect();
    let mut from = -foot;
    for piece in &shaft.pieces {
        let to = from + piece.length;
        all.push(Cylinder { from, to, radius: piece.diameter / 2.0, what: "shaft" });
        from = to;
    }
    all
}

/// Across both axes each cylinder reaches as far as its circle is wide where the other one is nearest.
fn meet(one: &Cylinder, other: &Cylinder, offset: f64) -> bool {
    let nearest = |cylinder: &Cylinder| cylinder.from.max(-cylinder.to).max(0.0);
    let reach = |cylinder: &Cylinder, apart: f64| {
        let radius = cylinder.radius + CLEARANCE / 2.0;
        (radius > apart).then(|| (radius * radius - apart * apart).sqrt())
    };
    let reaches = reach(one, nearest(other)).zip(reach(other, nearest(one)));
    reaches.is_some_and(|(one, other)| one + other > offset)
}
