//! How many stations a shaft would have, before any is made.

use super::Checker;
use crate::design::key_path::KeyPath;
use crate::design::{MAX_STATIONS, RotorDesign, SAME_STATION};

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
    let stations = rotor.station_positions().map(|positions| positions.len());
    if stations.is_none_or(|stations| stations > MAX_STATIONS) {
        let shown = stations.map_or_else(|| format!("over {}", 10 * MAX_STATIONS), |stations| stations.to_string());
        let message = format!("the shaft has {shown} stations: at most {MAX_STATIONS} are allowed");
        checker.error(path, message, Some(HINT));
    }
}

const HINT: &str = "stations stand at segment ends, between elements, and at bodies, bearings, the mesh and the drive";
