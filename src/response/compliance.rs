//! The exact shortcut: the two shafts are uncoupled but for the mesh, so one scalar says all.
//!
//! With alpha(w) = h^T A^-1 h of both rotors without the mesh, delta_d = alpha k_m* e / (1 + alpha k_m*) and
//! F_m = - k_m* e / (1 + alpha k_m*). In the real modes of each rotor alpha is a sum of one term a mode, whatever the damping ratios,
//! the mesh stiffness or e.

use num_complex::Complex64;

use super::{ResponseError, both_rotor_modes};
use crate::model::{Model, RotorModes};

/// Compliance of both rotors at the mesh as a sum over their modes.
#[derive(Debug, Clone)]
pub struct Compliance {
    terms: Vec<Term>,
}

/// (phi . h)^2 / (kappa (1 + j s zeta_s) - w^2 theta)
#[derive(Debug, Clone, Copy)]
struct Term {
    participation: f64,
    stiffness: f64,
    mass: f64,
}

impl Compliance {
    /// Solves the modes of both rotors once.
    ///
    /// # Errors
    ///
    /// As [`super::rotor_modes`].
    pub fn new(model: &Model) -> Result<Self, ResponseError> {
        Ok(Self::with_modes(model, &both_rotor_modes(model)?))
    }

    /// From modes that are known.
    pub fn with_modes(model: &Model, modes: &[RotorModes; 2]) -> Self {
        let mut terms = Vec::with_capacity(model.coordinates());
        for (modes, rotor) in modes.iter().zip(model.rotors()) {
            let participation = modes.participation(&rotor.mesh_vector);
            for ((g, &stiffness), &mass) in participation.iter().zip(&modes.stiffness).zip(&modes.mass) {
                if *g != 0.0 {
                    terms.push(Term { participation: g * g, stiffness, mass });
                }
            }
        }
        Self { terms }
    }

    /// alpha(w), m/N, at `omega` (rad/s, greater than 0) under the factor 1 + j s zeta_s on the stiffness.
    pub fn at(&self, omega: f64, structural_factor: Complex64) -> Complex64 {
        let omega_squared = omega * omega;
        let (mut real, mut imaginary) = (0.0, 0.0);
        for term in &self.terms {
            let a = term.stiffness * structural_factor.re - omega_squared * term.mass;
            let b = term.stiffness * structural_factor.im;
            let scale = term.participation / (a * a + b * b);
            real += a * scale;
            imaginary -= b * scale;
        }
        Complex64::new(real, imaginary)
    }
}
