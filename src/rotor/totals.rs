//! Mass and inertia of a whole rotor as one rigid body.

use super::{RotorError, Stations};
use crate::design::RotorDesign;

/// Rigid-body properties of shaft and bodies together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Totals {
    /// kg
    pub mass: f64,
    /// About the shaft's axis, kg m^2
    pub polar_inertia: f64,
    /// About a diameter through the centroid, kg m^2
    pub diametral_inertia: f64,
    /// m from the shaft's start
    pub centroid: f64,
}

impl Totals {
    pub fn new(rotor: &RotorDesign, stations: &Stations) -> Self {
        // (mass, own diametral inertia, polar inertia, place) of every element and body
        let elements = stations.sections.iter().enumerate().map(|(i, section)| {
            let length = stations.piece_length(i);
            let mass = section.mass * length;
            let diametral = section.diametral_inertia * length + mass * length * length / 12.0;
            (mass, diametral, section.polar_inertia * length, stations.positions[i] + length / 2.0)
        });
        let bodies = rotor.bodies.iter().zip(&stations.bodies);
        let bodies = bodies.map(|(body, &station)| {
            (body.mass, body.diametral_inertia, body.polar_inertia, stations.positions[station])
        });
        let parts: Vec<(f64, f64, f64, f64)> = elements.chain(bodies).collect();
        let mass = parts.iter().map(|part| part.0).sum();
        let centroid = parts.iter().map(|part| part.0 * part.3).sum::<f64>() / mass;
        Self {
            mass,
            polar_inertia: parts.iter().map(|part| part.2).sum(),
            diametral_inertia: parts.iter().map(|part| part.1 + part.0 * (part.3 - centroid).powi(2)).sum(),
            centroid,
        }
    }

    /// # Errors
    ///
    /// [`RotorError::NotFinite`] names the first sum that overflows.
    pub fn check_finite(&self) -> Result<(), RotorError> {
        let sums = [
            ("mass", self.mass),
            ("polar inertia", self.polar_inertia),
            ("centre of mass", self.centroid),
            ("diametral inertia", self.diametral_inertia),
        ];
        match sums.into_iter().find(|(_, value)| !value.is_finite()) {
            Some((what, _)) => Err(RotorError::NotFinite(what)),
            None => Ok(()),
        }
    }
}
