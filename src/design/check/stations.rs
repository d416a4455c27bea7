//! How many stations a shaft would have, before any is made.

use super::Checker;
use crate::design::key_path::KeyPath;
use crate::design::rotor::RotorDesign;

/// Most stations that a shaft may have.
pub const MAX_STATIONS: usize = 400;

/// Positions closer than this are one station, m.
const SAME_STATION: f64 = 1e-9;

pub(super) fn check(rotor: &RotorDesign, path: &KeyPath, checker: &Checker<'_>) {
    for (place, segment) in rotor.segments.iter().enumerate() {
        if segment.length / (segment.elements as f64) < SAME_STATION && segment.elements <= MAX_STATIONS {
            let message = "its elements are shorter than 1e-6 mm, where two stations are one";
            checker.error(&path.key("segment").place(place).key("length_mm"), message, None);
        }
    }
    // the points of one segment alone, so that no list gets long
    let most = rotor.segments.iter().enumerate().max_by_key(|(_, segment)| segment.elements);
    if let Some((place, segment)) = most.filter(|(_, segment)| segment.elements >= MAX_STATIONS) {
        let message =
            format!("{} elements are too many: a shaft may have at most {MAX_STATIONS} stations", segment.elements);
        checker.error(&path.key("segment").place(place).key("elements"), message, Some(HINT));
        return;
    }
    let stations = count(rotor);
    if stations > MAX_STATIONS {
        let shown =
            if stations > 10 * MAX_STATIONS { format!("over {}", 10 * MAX_STATIONS) } else { stations.to_string() };
        let message = format!("the shaft has {shown} stations: at most {MAX_STATIONS} are allowed");
        checker.error(path, message, Some(HINT));
    }
}

const HINT: &str = "stations stand at segment ends, between elements, and at bodies, bearings, the mesh and the drive";

/// Number of stations, or some number beyond ten times [`MAX_STATIONS`].
fn count(rotor: &RotorDesign) -> usize {
    let inner: usize = rotor.segments.iter().map(|segment| segment.elements).fold(0, usize::saturating_add);
    let places = rotor.bodies.len() + rotor.bearings.len();
    if inner > 10 * MAX_STATIONS {
        return inner;
    }
    let mut positions = Vec::with_capacity(inner + places + 3);
    let mut start = 0.0;
    positions.push(start);
    for segment in &rotor.segments {
        let elements = segment.elements as f64;
        positions.extend((1..=segment.elements).map(|i| start + segment.length * (i as f64 / elements)));
        start += segment.length;
    }
    positions.extend(rotor.bodies.iter().map(|body| body.position));
    positions.extend(rotor.bearings.iter().map(|bearing| bearing.position));
    positions.extend([rotor.mesh_position, rotor.drive.position]);
    positions.retain(|position| position.is_finite());
    positions.sort_by(f64::total_cmp);
    let mut stations = 0;
    let mut last = f64::NEG_INFINITY;
    for position in positions {
        if position - last > SAME_STATION {
            stations += 1;
            last = position;
        }
    }
    stations
}
