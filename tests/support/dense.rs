//! The whole model in one dense matrix, solved by textbook methods only.
//!
//! Shares the matrices K and M of the two rotors with the program, and nothing that comes after them: no split into uncoupled parts,
//! no modal sum, no secular equation.

use bevelscope::design::DampingModel;
use bevelscope::model::Model;
use nalgebra::{Cholesky, DMatrix, DVector};
use num_complex::Complex64;

/// K without the mesh, M and h of both rotors, pinion first.
pub fn matrices(model: &Model) -> (DMatrix<f64>, DMatrix<f64>, DVector<f64>) {
    let n = model.coordinates();
    let (mut k, mut m, mut h) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n), DVector::zeros(n));
    let mut at = 0;
    for rotor in model.rotors() {
        let size = rotor.coordinates.len();
        k.view_mut((at, at), (size, size)).copy_from(&rotor.stiffness);
        m.view_mut((at, at), (size, size)).copy_from(&rotor.mass);
        h.rows_mut(at, size).copy_from(&rotor.mesh_vector);
        at += size;
    }
    (k, m, h)
}

/// K phi = lambda M phi for symmetric K and positive definite M: eigenvalues ascending, mass-normalised shapes as columns.
///
/// Shifted and inverted about `shift` (rad^2/s^2, K + shift M positive definite), so that the low ones are good to rounding.
pub fn generalized(k: &DMatrix<f64>, m: &DMatrix<f64>, shift: f64) -> (Vec<f64>, DMatrix<f64>) {
    let n = k.nrows();
    let shifted = k + m * shift;
    let scale = DVector::from_fn(n, |i, _| 1.0 / shifted[(i, i)].sqrt());
    let scaled = |a: &DMatrix<f64>| DMatrix::from_fn(n, n, |i, j| scale[i] * a[(i, j)] * scale[j]);
    let l = Cholesky::new(scaled(&shifted)).unwrap().l();
    let half = l.solve_lower_triangular(&scaled(m)).unwrap();
    let c = l.solve_lower_triangular(&half.transpose()).unwrap();
    let eigen = ((&c + c.transpose()) * 0.5).symmetric_eigen();
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let shapes = l.tr_solve_lower_triangular(&eigen.eigenvectors).unwrap();
    let mut lambda = Vec::with_capacity(n);
    let mut out = DMatrix::zeros(n, n);
    for (column, &i) in order.iter().enumerate() {
        let theta = eigen.eigenvalues[i];
        lambda.push(1.0 / theta - shift);
        out.set_column(column, &(shapes.column(i).component_mul(&scale) / theta.sqrt()));
    }
    (lambda, out)
}

/// Dynamic stiffness H(w) = K (1 + j s zeta_s) - w^2 M + k_m (1 + j s zeta_m) h h^T (Hua et al. 2012, eqs. 11-14).
pub fn dynamic_stiffness(model: &Model, omega: f64) -> DMatrix<Complex64> {
    let (k, m, h) = matrices(model);
    let s = match model.damping_model {
        DampingModel::Hysteretic => 1.0,
        DampingModel::Viscous => omega,
    };
    let structure = Complex64::new(1.0, s * model.structural_damping);
    let mesh = model.mesh_stiffness * Complex64::new(1.0, s * model.mesh_damping);
    DMatrix::from_fn(k.nrows(), k.nrows(), |i, j| {
        structure * k[(i, j)] - omega * omega * m[(i, j)] + mesh * h[i] * h[j]
    })
}
