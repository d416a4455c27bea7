//! The direct solve of (14): one complex factorisation of the whole system a line. Slow, and the reference for the shortcut.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

use super::{ResponseError, Spectrum};
use crate::model::Model;

/// Response on the given lines (Hz, greater than 0) by solving H(w) x = h k_m* e, H = K_s (1 + j s zeta_s) - w^2 M + k_m* h h^T.
///
/// # Errors
///
/// A line whose system is singular to rounding or whose result overflows.
pub fn direct_spectrum(model: &Model, frequency_hz: &[f64]) -> Result<Spectrum, ResponseError> {
    let whole = Whole::new(model);
    let n = model.coordinates();
    let mut out = Spectrum::with_capacity(frequency_hz.len(), n);
    for &frequency in frequency_hz {
        let omega = TAU * frequency;
        let omega_squared = omega * omega;
        let structural = model.structural_factor(omega);
        let mesh = model.complex_mesh_stiffness(omega);
        let system = DMatrix::from_fn(n, n, |i, j| {
            whole.stiffness[(i, j)] * structural - omega_squared * whole.mass[(i, j)] + mesh * whole.h[i] * whole.h[j]
        });
        let load = whole.h.map(|h| h * mesh * model.transmission_error);
        let singular = ResponseError::LineNotFinite { what: "dynamic stiffness", at_hz: frequency };
        let x = system.lu().solve(&load).ok_or(singular)?;
        let delta: Complex64 = x.iter().zip(whole.h.iter()).map(|(x, h)| x * h).sum();
        out.push(frequency, mesh * (delta - model.transmission_error), delta)?;
    }
    Ok(out)
}

/// Both rotors in one system, scaled so that metres and radians weigh alike in the pivoting.
struct Whole {
    stiffness: DMatrix<f64>,
    mass: DMatrix<f64>,
    h: DVector<f64>,
}

impl Whole {
    fn new(model: &Model) -> Self {
        let n = model.coordinates();
        let (mut stiffness, mut mass) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
        let mut h = DVector::zeros(n);
        let mut at = 0;
        for rotor in model.rotors() {
            let size = rotor.coordinates.len();
            stiffness.view_mut((at, at), (size, size)).copy_from(&rotor.stiffness);
            mass.view_mut((at, at), (size, size)).copy_from(&rotor.mass);
            h.rows_mut(at, size).copy_from(&rotor.mesh_vector);
            at += size;
        }
        // any positive scaling leaves h^T x as it is
        let scale = DVector::from_fn(n, |i, _| 1.0 / (stiffness[(i, i)] + 1e6 * mass[(i, i)]).sqrt());
        for i in 0..n {
            for j in 0..n {
                stiffness[(i, j)] *= scale[i] * scale[j];
                mass[(i, j)] *= scale[i] * scale[j];
            }
        }
        h.component_mul_assign(&scale);
        Self { stiffness, mass, h }
    }
}
