//! Displacements of the whole model at one frequency, as a sum over each rotor's modes.
//!
//! With the mesh force known, each rotor answers alone: x = - F_m A^-1 h.

use nalgebra::DVector;
use num_complex::Complex64;

use crate::model::{Model, Recovery, RotorModes};

/// Displacements of one shaft at its stations.
#[derive(Debug, Clone, PartialEq)]
pub struct StationShape<T> {
    /// m from the shaft's start
    pub positions: Vec<f64>,
    /// x, y, z (m), thx, thy, thz (rad) of every station
    pub displacements: Vec<[T; 6]>,
    /// Rotation of engine or load, rad; nothing where there is none
    pub drive: Option<T>,
}

/// Modal amplitude of (phi . h): 1 / (kappa (1 + j s zeta) - w^2 theta).
pub(super) fn amplitude(stiffness: f64, mass: f64, omega_squared: f64, factor: Complex64) -> Complex64 {
    (factor * stiffness - omega_squared * mass).inv()
}

/// A natural mode (scaled to phi^T M phi = 1 as it is) at the stations of both shafts, pinion first.
pub fn mode_shape(model: &Model, recovery: &[Recovery; 2], shape: &DVector<f64>) -> [StationShape<f64>; 2] {
    let top = model.pinion.coordinates.len();
    let parts = [shape.rows(0, top).into_owned(), shape.rows(top, shape.len() - top).into_owned()];
    [0, 1].map(|rotor| {
        let (displacements, drive) = recovery[rotor].stations(&parts[rotor]);
        StationShape { positions: recovery[rotor].positions.clone(), displacements, drive }
    })
}

/// Operating deflection shape at `omega` (rad/s, greater than 0): displacements of both shafts, pinion first, under the mesh force (N) there.
/// `modes` are those of both rotors without the mesh.
pub fn operating_deflection(
    model: &Model,
    modes: &[RotorModes; 2],
    recovery: &[Recovery; 2],
    omega: f64,
    mesh_force: Complex64,
) -> [StationShape<Complex64>; 2] {
    let factor = model.structural_factor(omega);
    [0, 1].map(|rotor| {
        let (modes, h) = (&modes[rotor], &model.rotors()[rotor].mesh_vector);
        let mut real = DVector::zeros(h.len());
        let mut imaginary = DVector::zeros(h.len());
        for (r, g) in modes.participation(h).iter().enumerate() {
            let q = -mesh_force * *g * amplitude(modes.stiffness[r], modes.mass[r], omega * omega, factor);
            real.axpy(q.re, &modes.shapes.column(r), 1.0);
            imaginary.axpy(q.im, &modes.shapes.column(r), 1.0);
        }
        let (re, im) = (recovery[rotor].stations(&real), recovery[rotor].stations(&imaginary));
        let both = |re: &[f64; 6], im: &[f64; 6]| std::array::from_fn(|i| Complex64::new(re[i], im[i]));
        StationShape {
            positions: recovery[rotor].positions.clone(),
            displacements: re.0.iter().zip(&im.0).map(|(re, im)| both(re, im)).collect(),
            drive: re.1.zip(im.1).map(|(re, im)| Complex64::new(re, im)),
        }
    })
}
