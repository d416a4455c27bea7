//! From loads to displacement: the displacement where a bearing balances them.

use nalgebra::{DMatrix, DVector};

use super::{Bearing, Failure, Kind, Potential, State, Vector, minimise};

/// Displacements that are prescribed (m, rad), in the order of q; their loads are results.
pub type Held = [Option<f64>; 5];

/// Why loads have no displacement.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EquilibriumError {
    #[error("NO_CONTACT: no rolling element is in contact; give a preload or a load that closes the clearance")]
    NoContact,
    /// Told in the axes of the shaft, x, y and z.
    #[error(
        "UNSUPPORTED_LOAD: the bearing cannot balance {:.4e}, {:.4e} and {:.4e} N in x, y and z (y along the shaft) with {:.4e} and {:.4e} N m \
         about x and z within sensible displacements", .load[1], .load[2], .load[0], .load[4], .load[3]
    )]
    UnsupportedLoad {
        /// In the bearing's axes
        load: Vector,
    },
    #[error("NO_CONVERGENCE: no equilibrium was found; the loads are balanced to {residual:.1e} of their size only")]
    NoConvergence { residual: f64 },
}

/// The state of a bearing under given loads. Entries of `load` where the displacement is held say nothing.
///
/// The energy U(q) - f.q is convex, so where K is regular there is one such state. A roller bearing without load spread meets
/// moments with its apex only: hold its tilts.
///
/// # Errors
///
/// [`EquilibriumError`]; no stiffness comes with any of them.
pub fn equilibrium(bearing: &Bearing, load: &Vector, held: &Held) -> Result<State, EquilibriumError> {
    let free: Vec<usize> = (0..5).filter(|&i| held[i].is_none()).collect();
    let base = Vector::from_fn(|i, _| held[i].unwrap_or(0.0));
    let problem = Loaded { bearing, load, base, free };
    let size = problem.scaled_load().amax();
    let q = if problem.free.is_empty() || size == 0.0 && is_open(bearing, &base) {
        base
    } else {
        // what is held may press harder than the load
        let size = size.max(problem.gradient(&DVector::zeros(problem.free.len()), 1.0).amax());
        let trust = 10.0 * bearing.typical_deflection(size) + 2.0 * bearing.clearance();
        match minimise(&problem, problem.free.len(), size, trust) {
            Ok(q) => problem.displacement(&q),
            Err(Failure::RanAway(_)) => return Err(EquilibriumError::UnsupportedLoad { load: *load }),
            Err(Failure::Stalled { residual }) => return Err(problem.stalled(residual)),
        }
    };
    if is_open(bearing, &q) { Err(EquilibriumError::NoContact) } else { Ok(bearing.state(&q)) }
}

fn is_open(bearing: &Bearing, q: &Vector) -> bool {
    bearing.energy(q) == 0.0
}

struct Loaded<'a> {
    bearing: &'a Bearing,
    load: &'a Vector,
    base: Vector,
    free: Vec<usize>,
}

impl Loaded<'_> {
    /// Rotations count as displacements at the radius r.
    fn scale(&self, i: usize) -> f64 {
        if i < 3 { 1.0 } else { self.bearing.radius() }
    }

    fn displacement(&self, q: &DVector<f64>) -> Vector {
        let mut out = self.base;
        for (value, &i) in q.iter().zip(&self.free) {
            out[i] = value / self.scale(i);
        }
        out
    }

    fn scaled_load(&self) -> DVector<f64> {
        DVector::from_iterator(self.free.len(), self.free.iter().map(|&i| self.load[i] / self.scale(i)))
    }

    /// A roller bearing without spread cannot turn a moment into anything, so that the search stands still.
    fn stalled(&self, residual: f64) -> EquilibriumError {
        let tilts_are_free = self.free.iter().any(|&i| i >= 3);
        match self.bearing.0.kind {
            Kind::Roller { length } if length == 0.0 && tilts_are_free => {
                EquilibriumError::UnsupportedLoad { load: *self.load }
            }
            _ => EquilibriumError::NoConvergence { residual },
        }
    }
}

impl Potential for Loaded<'_> {
    fn energy(&self, q: &DVector<f64>, load_factor: f64) -> f64 {
        self.bearing.energy(&self.displacement(q)) - load_factor * self.scaled_load().dot(q)
    }

    fn gradient(&self, q: &DVector<f64>, load_factor: f64) -> DVector<f64> {
        let load = self.bearing.load(&self.displacement(q).into());
        let own = DVector::from_iterator(self.free.len(), self.free.iter().map(|&i| load[i] / self.scale(i)));
        own - self.scaled_load() * load_factor
    }

    fn hessian(&self, q: &DVector<f64>) -> DMatrix<f64> {
        let stiffness = self.bearing.stiffness(&self.displacement(q));
        let n = self.free.len();
        DMatrix::from_fn(n, n, |row, column| {
            let (i, j) = (self.free[row], self.free[column]);
            stiffness[(i, j)] / (self.scale(i) * self.scale(j))
        })
    }

    fn has_run_away(&self, q: &DVector<f64>) -> bool {
        q.amax() > self.bearing.radius() / 4.0
    }
}
