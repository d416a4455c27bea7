//! One rotor: sections, materials, names, and positions on the shaft.

use std::collections::{BTreeMap, HashMap};

use super::{Checker, matrix, rolling, stations, supports};
use crate::design::SAME_STATION;
use crate::design::key_path::KeyPath;
use crate::design::model::Material;
use crate::design::read::{did_you_mean, listed};
use crate::design::rotor::{BearingModel, RotorDesign, Segment};

pub(super) fn check(
    rotor: &mut RotorDesign,
    materials: &BTreeMap<String, Material>,
    path: &KeyPath,
    checker: &Checker<'_>,
) {
    for (place, segment) in rotor.segments.iter().enumerate() {
        check_segment(segment, materials, &path.key("segment").place(place), checker);
    }
    let bodies = rotor.bodies.iter().map(|body| body.name.as_str());
    check_names(bodies, &path.key("body"), checker);
    let bearings = rotor.bearings.iter().map(|bearing| bearing.name.as_str());
    check_names(bearings, &path.key("bearing"), checker);
    check_inertias(rotor, path, checker);
    check_positions(rotor, path, checker);
    stations::check(rotor, path, checker);
    supports::check(rotor, path, checker);
    for (place, bearing) in rotor.bearings.iter().enumerate() {
        rolling::check(bearing, &path.key("bearing").place(place), checker);
    }
    for (place, bearing) in rotor.bearings.iter_mut().enumerate() {
        if let BearingModel::Matrix(stiffness) = &mut bearing.model {
            matrix::check(stiffness, &path.key("bearing").place(place).key("stiffness"), checker);
        }
    }
}

fn check_segment(segment: &Segment, materials: &BTreeMap<String, Material>, path: &KeyPath, checker: &Checker<'_>) {
    let (inner, outer) = (segment.inner_diameter, segment.outer_diameter);
    if inner >= outer {
        let message = format!("must be less than outer_diameter_mm, {:?} mm; it is {:?} mm", outer * 1e3, inner * 1e3);
        checker.error(&path.key("inner_diameter_mm"), message, None);
    }
    let material = segment.material.as_str();
    if !material.is_empty() && !materials.contains_key(material) && !checker.findings.is_full() {
        let known = || materials.keys().map(String::as_str);
        let hint = format!("{}there is: {}", did_you_mean(material, known()), listed(known()));
        checker.error(&path.key("material"), format!("there is no material `{material}`"), Some(&hint));
    }
}

fn check_names<'a>(names: impl Iterator<Item = &'a str>, path: &KeyPath, checker: &Checker<'_>) {
    let mut first: HashMap<&str, usize> = HashMap::new();
    for (place, name) in names.enumerate().filter(|(_, name)| !name.is_empty()) {
        if let Some(first) = first.get(name) {
            let message = format!("the name \"{name}\" is taken by {}", path.place(*first));
            let hint = "names are unique within a rotor; where none is written, it follows from the place";
            checker.error(&path.place(place).key("name"), message, Some(hint));
        } else {
            first.insert(name, place);
        }
    }
}

fn check_inertias(rotor: &RotorDesign, path: &KeyPath, checker: &Checker<'_>) {
    for (place, body) in rotor.bodies.iter().enumerate() {
        // a flat disc has exactly twice, everything else less; the written digits may be rounded
        if body.polar_inertia > 2.0 * body.diametral_inertia * (1.0 + 1e-9) {
            let message = format!(
                "{:?} kg m^2 is more than twice the diametral inertia, {:?} kg m^2: no rigid body has that",
                body.polar_inertia, body.diametral_inertia
            );
            checker.warn(&path.key("body").place(place).key("polar_inertia_kg_m2"), message, None);
        }
    }
}

fn check_positions(rotor: &RotorDesign, path: &KeyPath, checker: &Checker<'_>) {
    let length = rotor.length();
    // without a segment, or with one that could not be read, there is no length to compare with; lengths only add up to
    // infinity with more segments than a shaft may have stations
    if !(length > 0.0 && length.is_finite()) {
        return;
    }
    let bodies = rotor.bodies.iter().enumerate().map(|(i, body)| (path.key("body").place(i), body.position));
    let bearings = rotor.bearings.iter().enumerate().map(|(i, b)| (path.key("bearing").place(i), b.position));
    let positions = bodies.chain(bearings).chain(rotor.drive.map(|drive| (path.key("drive"), drive.position)));
    let positions = positions.map(|(path, position)| (path.key("position_mm"), position));
    for (path, position) in positions.chain([(path.key("mesh_position_mm"), rotor.mesh_position)]) {
        if position < -SAME_STATION || position > length + SAME_STATION {
            let message =
                format!("must lie on the shaft, from 0 to {} mm; it is {}", millimetres(length), millimetres(position));
            checker.error(&path, message, None);
        }
    }
}

/// Without the last digits that adding up leaves behind.
fn millimetres(metres: f64) -> String {
    let value = metres * 1e3;
    if value.abs() < 1e9 { format!("{}", (value * 1e6).round() / 1e6) } else { format!("{value:e}") }
}
