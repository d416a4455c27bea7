//! Single bearings: an independent computation's figures, published displacements, closed forms, and what holds for any bearing.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod closed_forms;
mod properties;
mod published;
mod refusals;
mod vectors;

use bevelscope::bearing::{Bearing, Data, Kind, Matrix};

pub(crate) fn ball(
    elements: usize,
    angle_deg: f64,
    contact_stiffness: f64,
    radius: f64,
    groove_distance: f64,
) -> Bearing {
    let kind = Kind::Ball { groove_distance };
    bearing(elements, angle_deg, contact_stiffness, radius, 0.0, kind)
}

pub(crate) fn roller(elements: usize, angle_deg: f64, contact_stiffness: f64, radius: f64, length: f64) -> Bearing {
    bearing(elements, angle_deg, contact_stiffness, radius, 0.0, Kind::Roller { length })
}

pub(crate) fn bearing(elements: usize, angle: f64, stiffness: f64, radius: f64, clearance: f64, kind: Kind) -> Bearing {
    let contact_angle = angle.to_radians();
    Bearing::new(Data { elements, contact_angle, clearance, radius, contact_stiffness: stiffness, kind }).unwrap()
}

/// Largest difference over the largest entry, tilts counted at the radius.
pub(crate) fn difference(found: &Matrix, expected: &Matrix, radius: f64) -> f64 {
    let scale = |i: usize| if i < 3 { 1.0 } else { 1.0 / radius };
    let size = |matrix: &Matrix| {
        let entries = (0..5).flat_map(|i| (0..5).map(move |j| (i, j)));
        entries.map(|(i, j)| matrix[(i, j)].abs() * scale(i) * scale(j)).fold(0.0, f64::max)
    };
    size(&(found - expected)) / size(expected)
}
