//! What a shaft's cross-section brings to the beams.

use std::f64::consts::PI;

use crate::design::{BeamTheory, Material, Segment};

/// Properties per unit length of a uniform round shaft piece.
///
/// The beam theory is settled here: under Euler-Bernoulli the shear flexibility and the rotary inertia are zero, and
/// everything downstream is the same code for both.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// EA, N
    pub axial_stiffness: f64,
    /// EI, N m^2
    pub bending_stiffness: f64,
    /// GJ, N m^2
    pub torsional_stiffness: f64,
    /// 1/(kappa G A), 1/N
    pub shear_flexibility: f64,
    /// rho A, kg/m
    pub mass: f64,
    /// rho I in the equations of motion, kg m
    pub rotary_inertia: f64,
    /// rho I of the material that is there, kg m
    pub diametral_inertia: f64,
    /// rho J, kg m
    pub polar_inertia: f64,
}

impl Section {
    /// Section of a segment made of the given material.
    pub fn new(segment: &Segment, material: &Material, theory: BeamTheory) -> Self {
        let (outer, inner) = (segment.outer_diameter, segment.inner_diameter);
        // factored, so that thin tubes keep their digits
        let area = PI / 4.0 * (outer - inner) * (outer + inner);
        let second_moment = area / 16.0 * (outer * outer + inner * inner);
        let shear_modulus = material.shear_modulus();
        let (shear_flexibility, rotary_inertia) = match theory {
            BeamTheory::EulerBernoulli => (0.0, 0.0),
            BeamTheory::Timoshenko => {
                let factor = shear_factor(material.poissons_ratio, inner / outer);
                (1.0 / (factor * shear_modulus * area), material.density * second_moment)
            }
        };
        Self {
            axial_stiffness: material.youngs_modulus * area,
            bending_stiffness: material.youngs_modulus * second_moment,
            torsional_stiffness: shear_modulus * 2.0 * second_moment,
            shear_flexibility,
            mass: material.density * area,
            rotary_inertia,
            diametral_inertia: material.density * second_moment,
            polar_inertia: material.density * 2.0 * second_moment,
        }
    }

    /// The same section of a material that weighs nothing.
    #[must_use]
    pub fn without_mass(&self) -> Self {
        Self { mass: 0.0, rotary_inertia: 0.0, diametral_inertia: 0.0, polar_inertia: 0.0, ..*self }
    }
}

/// Shear coefficient kappa of a round section with diameter ratio `r` = inner / outer (Cowper 1966).
fn shear_factor(poissons_ratio: f64, r: f64) -> f64 {
    let nu = poissons_ratio;
    let a = (1.0 + r * r).powi(2);
    6.0 * (1.0 + nu) * a / ((7.0 + 6.0 * nu) * a + (20.0 + 12.0 * nu) * r * r)
}
