//! What a rotor measures as a whole, before anything is solved.

use std::f64::consts::PI;

use super::{Design, Side};

/// Sums over one rotor, in SI units. Inertias and the centroid are those of [`rotor::Totals`](crate::rotor::Totals).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Totals {
    /// Length of the shaft, m
    pub length: f64,
    /// Mass of the shaft alone, kg
    pub shaft_mass: f64,
    /// Mass of the bodies, kg
    pub bodies_mass: f64,
}

impl Totals {
    pub fn of(design: &Design, side: Side) -> Self {
        let rotor = design.rotor(side);
        let mass = |segment: &super::Segment| {
            let area = PI / 4.0 * (segment.outer_diameter.powi(2) - segment.inner_diameter.powi(2));
            let density = design.materials.get(&segment.material).map_or(f64::NAN, |material| material.density);
            area * segment.length * density
        };
        Self {
            length: rotor.length(),
            shaft_mass: rotor.segments.iter().map(mass).sum(),
            bodies_mass: rotor.bodies.iter().map(|body| body.mass).sum(),
        }
    }

    /// Shaft and bodies together, kg
    pub fn mass(&self) -> f64 {
        self.shaft_mass + self.bodies_mass
    }
}
