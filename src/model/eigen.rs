//! Undamped modes of one rotor without the mesh, or with its interface held.
//!
//! A plain solve of K phi = lambda M phi errs by rounding times the largest eigenvalue, which buries the low modes of a finely divided
//! shaft. Instead M v = theta (K + s M) v is solved, with theta = 1/(lambda + s) largest for the lowest modes; and the free rotation,
//! whose shape is known, is put in exactly.

use std::ops::ControlFlow;

use nalgebra::{Cholesky, DMatrix, DVector, Dyn, SymmetricTridiagonal};

use super::RotorModel;
use super::tridiagonal::{QrError, diagonalise};

/// Shift s = (2 pi 500)^2 rad^2/s^2: near the frequencies of interest, any positive value is exact.
const SHIFT: f64 = 9.869_604_401_089_358e6;

/// Modes of one rotor; mode r has shape column r, modal stiffness kappa and modal mass theta, lambda = kappa / theta.
///
/// Shapes are scaled to kappa + s theta = 1, so that modes of nearly massless motion stay harmless: their theta is close to zero and
/// nothing is divided by it.
#[derive(Debug, Clone)]
pub struct RotorModes {
    /// phi^T K phi; exactly 0 for the free rotation
    pub stiffness: Vec<f64>,
    /// phi^T M phi
    pub mass: Vec<f64>,
    /// One column a mode, over the coordinates of the matrices
    pub shapes: DMatrix<f64>,
}

impl RotorModes {
    /// (phi . h) of every mode, in the order of the columns.
    pub fn participation(&self, h: &DVector<f64>) -> DVector<f64> {
        self.shapes.tr_mul(h)
    }
}

/// Hears of work that is done, in the unit of [`modes_work`], and may end it.
pub type WorkDone<'a> = dyn FnMut(f64) -> ControlFlow<()> + 'a;

/// How much work the modes of a rotor are: the cubes of the groups of coordinates that are solved apart.
pub fn modes_work(rotor: &RotorModel) -> f64 {
    uncoupled_parts(&rotor.stiffness, &rotor.mass).iter().map(|part| cube(part.len())).sum()
}

fn cube(n: usize) -> f64 {
    (n as f64).powi(3)
}

/// All modes of K phi = lambda M phi, in no particular order; K resists everything but `rotation` (zero where it is all held).
///
/// `None` where the values lie too far apart to be factorised, or overflow.
pub fn natural_modes(stiffness: &DMatrix<f64>, mass: &DMatrix<f64>, rotation: &DVector<f64>) -> Option<RotorModes> {
    natural_modes_over(stiffness, mass, rotation, &mut |_| ControlFlow::Continue(())).ok()
}

/// As [`natural_modes`]; `done` hears of the work between its steps, [`modes_work`] in all.
///
/// # Errors
///
/// [`QrError::NotConverged`] where the values lie too far apart to be factorised, or overflow; [`QrError::Ended`] where `done`
/// breaks.
pub fn natural_modes_over(
    stiffness: &DMatrix<f64>,
    mass: &DMatrix<f64>,
    rotation: &DVector<f64>,
    done: &mut WorkDone<'_>,
) -> Result<RotorModes, QrError> {
    let n = stiffness.nrows();
    let mut modes =
        RotorModes { stiffness: Vec::with_capacity(n), mass: Vec::with_capacity(n), shapes: DMatrix::zeros(n, n) };
    for part in uncoupled_parts(stiffness, mass) {
        let pick = |matrix: &DMatrix<f64>| matrix.select_rows(&part).select_columns(&part);
        let turning = rotation.select_rows(&part);
        let turning = (turning.norm_squared() > 0.0).then_some(turning);
        let all = cube(part.len());
        let mut heard = 0.0;
        let mut steps = |share: f64| {
            let work = (share - heard) * all;
            heard = share;
            done(work)
        };
        let (kappa, theta, shapes) = part_modes(&pick(stiffness), &pick(mass), turning, &mut steps)?;
        for (column, shape) in shapes.column_iter().enumerate() {
            let target = modes.stiffness.len();
            for (row, value) in part.iter().zip(shape.iter()) {
                modes.shapes[(*row, target)] = *value;
            }
            modes.stiffness.push(kappa[column]);
            modes.mass.push(theta[column]);
        }
    }
    Ok(modes)
}

/// Groups of coordinates that neither matrix couples: torsion, and often the axial motion and each plane of bending.
///
/// Solved apart they cost a fraction of the whole, and a symmetric shaft's modes stay in their planes.
pub fn uncoupled_parts(stiffness: &DMatrix<f64>, mass: &DMatrix<f64>) -> Vec<Vec<usize>> {
    let n = stiffness.nrows();
    let mut group: Vec<Option<usize>> = vec![None; n];
    let mut parts: Vec<Vec<usize>> = Vec::new();
    for start in 0..n {
        if group[start].is_some() {
            continue;
        }
        let label = parts.len();
        group[start] = Some(label);
        let mut part = vec![start];
        let mut visited = 0;
        while let Some(&i) = part.get(visited) {
            visited += 1;
            for j in 0..n {
                // down the columns of the symmetric matrices, as they lie in memory
                if group[j].is_none() && (stiffness[(j, i)] != 0.0 || mass[(j, i)] != 0.0) {
                    group[j] = Some(label);
                    part.push(j);
                }
            }
        }
        part.sort_unstable();
        parts.push(part);
    }
    parts
}

/// Share of a group's work that is done after each step, measured on 800 and on 2,000 coordinates.
mod share {
    pub const HALF_REDUCED: f64 = 0.17;
    pub const REDUCED: f64 = 0.29;
    pub const TRIDIAGONAL: f64 = 0.49;
    pub const TURNED: f64 = 0.65;
    pub const DIAGONAL: f64 = 0.83;
}

/// (kappa, theta, shapes) of one group.
type PartModes = (Vec<f64>, Vec<f64>, DMatrix<f64>);

/// Solves one group; `rotation` is its free rotation where it has one. `done` hears the share of the work.
fn part_modes(
    stiffness: &DMatrix<f64>,
    mass: &DMatrix<f64>,
    rotation: Option<DVector<f64>>,
    done: &mut WorkDone<'_>,
) -> Result<PartModes, QrError> {
    const FAILED: QrError = QrError::NotConverged;
    let mut step = |share: f64| if done(share).is_break() { Err(QrError::Ended) } else { Ok(()) };
    let n = stiffness.nrows();
    let shifted = stiffness + mass * SHIFT;
    let scale = DVector::from_fn(n, |i, _| 1.0 / shifted[(i, i)].sqrt());
    let scaled = |matrix: &DMatrix<f64>| {
        DMatrix::from_fn(n, n, |i, j| scale[i] * f64::midpoint(matrix[(i, j)], matrix[(j, i)]) * scale[j])
    };
    let factor: Cholesky<f64, Dyn> = Cholesky::new(scaled(&shifted)).ok_or(FAILED)?;
    let lower = factor.l();
    // C = L^-1 M L^-T has the eigenvalues theta
    let half = lower.solve_lower_triangular(&scaled(mass)).ok_or(FAILED)?;
    step(share::HALF_REDUCED)?;
    let mut c = lower.solve_lower_triangular(&half.transpose()).ok_or(FAILED)?;
    c = (&c + c.transpose()) * 0.5;
    step(share::REDUCED)?;
    let mut theta = Vec::with_capacity(n);
    let mut kappa = Vec::with_capacity(n);
    let mut vectors = DMatrix::zeros(n, n);
    let mut reflector = None;
    if let Some(rotation) = rotation {
        // a reflection turns the known eigenvector onto the first axis; the rest is orthogonal to it to rounding
        let known = lower.tr_mul(&rotation.component_div(&scale));
        let mut axis = known.normalize();
        axis[0] += 1.0_f64.copysign(axis[0]);
        let axis = axis.normalize();
        c = reflect_right(&reflect_right(&c, &axis).transpose(), &axis);
        c = c.remove_row(0).remove_column(0);
        vectors[(0, 0)] = 1.0;
        theta.push(1.0 / SHIFT);
        kappa.push(0.0);
        reflector = Some(axis);
    }
    let first = theta.len();
    if !c.iter().all(|entry| entry.is_finite()) {
        return Err(FAILED);
    }
    let (values, eigenvectors) = eigen(c, &mut step)?;
    for value in values {
        // M is positive definite: below zero there is only rounding
        let value = value.clamp(0.0, 1.0 / SHIFT);
        theta.push(value);
        kappa.push(1.0 - SHIFT * value);
    }
    vectors.view_mut((first, first), eigenvectors.shape()).copy_from(&eigenvectors);
    if let Some(axis) = reflector {
        vectors = reflect_right(&vectors.transpose(), &axis).transpose();
    }
    let mut shapes = lower.tr_solve_lower_triangular(&vectors).ok_or(FAILED)?;
    for mut column in shapes.column_iter_mut() {
        column.component_mul_assign(&scale);
    }
    step(1.0)?;
    Ok((kappa, theta, shapes))
}

/// Eigenvalues and, as columns, eigenvectors of a symmetric matrix of finite entries.
fn eigen(
    mut c: DMatrix<f64>,
    step: &mut impl FnMut(f64) -> Result<(), QrError>,
) -> Result<(Vec<f64>, DMatrix<f64>), QrError> {
    let n = c.nrows();
    if n == 0 {
        return Ok((Vec::new(), c));
    }
    // squares of the entries neither overflow nor vanish
    let largest = c.amax();
    if largest > 0.0 {
        c.unscale_mut(largest);
    }
    let tridiagonal = SymmetricTridiagonal::new(c);
    step(share::TRIDIAGONAL)?;
    let (mut vectors, diagonal, below) = tridiagonal.unpack();
    step(share::TURNED)?;
    let (mut values, mut below) = (diagonal.as_slice().to_vec(), below.as_slice().to_vec());
    diagonalise(&mut values, &mut below, &mut vectors, &mut |wanted| {
        // the fewer are wanted, the shorter are the sweeps
        let left = wanted as f64 / n as f64;
        match step(share::DIAGONAL - (share::DIAGONAL - share::TURNED) * left * left) {
            Ok(()) => ControlFlow::Continue(()),
            Err(_) => ControlFlow::Break(()),
        }
    })?;
    if largest > 0.0 {
        for value in &mut values {
            *value *= largest;
        }
    }
    Ok((values, vectors))
}

/// A (I - 2 v v^T) for a unit vector v.
fn reflect_right(a: &DMatrix<f64>, v: &DVector<f64>) -> DMatrix<f64> {
    let mut out = a.clone();
    out.ger(-2.0, &(a * v), v, 1.0);
    out
}
