//! Newton's method for the minimum of a convex energy that has corners in its second derivative: contacts open and close.

use nalgebra::{Cholesky, DMatrix, DVector};

/// A convex function of coordinates that weigh alike.
pub trait Potential {
    /// Where the load is to be scaled (0 to 1), in place.
    fn energy(&self, q: &DVector<f64>, load_factor: f64) -> f64;
    fn gradient(&self, q: &DVector<f64>, load_factor: f64) -> DVector<f64>;
    fn hessian(&self, q: &DVector<f64>) -> DMatrix<f64>;
    /// Has something moved so far that no equilibrium is near?
    fn has_run_away(&self, q: &DVector<f64>) -> bool;
}

/// Why there is no minimum.
#[derive(Debug, Clone, PartialEq)]
pub enum Failure {
    /// The coordinates when they were too far off
    RanAway(DVector<f64>),
    /// Largest entry of the gradient over the load
    Stalled { residual: f64 },
}

const ASKED: f64 = 1e-12;
const ACCEPTED: f64 = 1e-9;
const ITERATIONS: usize = 200;

/// The coordinates where the gradient vanishes to 1e-12 of `load`, or to 1e-9 where rounding allows no more.
///
/// Starts from zero with steps no longer than `trust`, which doubles after each full step. If that fails, the load comes in steps of
/// a twentieth.
///
/// # Errors
///
/// [`Failure`] of the last attempt.
pub fn minimise(potential: &impl Potential, size: usize, load: f64, trust: f64) -> Result<DVector<f64>, Failure> {
    let at_once = attempt(potential, DVector::zeros(size), 1.0, load, trust);
    if at_once.is_ok() {
        return at_once;
    }
    let mut q = DVector::zeros(size);
    for step in 1..=20 {
        q = attempt(potential, q, f64::from(step) / 20.0, load, trust)?;
    }
    Ok(q)
}

fn attempt(
    potential: &impl Potential,
    start: DVector<f64>,
    factor: f64,
    load: f64,
    mut trust: f64,
) -> Result<DVector<f64>, Failure> {
    let mut q = start;
    let mut gradient = potential.gradient(&q, factor);
    for _ in 0..ITERATIONS {
        let residual = gradient.amax();
        if residual <= ASKED * load {
            return Ok(q);
        }
        let hessian = potential.hessian(&q);
        let mut damping = 1e-14;
        let step = loop {
            let step = direction(&hessian, &gradient, damping, trust)
                .and_then(|step| line_search(potential, &q, &step, &gradient, factor));
            match step {
                Some(step) => break Some(step),
                None if damping < 1e3 => damping *= 1e3,
                None => break None,
            }
        };
        let Some((step, is_full)) = step else { break };
        if is_full {
            trust *= 2.0;
        }
        q += step;
        if potential.has_run_away(&q) {
            return Err(Failure::RanAway(q));
        }
        gradient = potential.gradient(&q, factor);
    }
    let residual = gradient.amax() / load;
    if residual <= ACCEPTED { Ok(q) } else { Err(Failure::Stalled { residual }) }
}

/// A direction of descent no longer than `trust`; nothing where the factorisation fails.
fn direction(hessian: &DMatrix<f64>, gradient: &DVector<f64>, damping: f64, trust: f64) -> Option<DVector<f64>> {
    let n = gradient.len();
    let mean = hessian.trace() / n as f64;
    if mean == 0.0 {
        // nothing is in contact yet
        return Some(gradient * (-trust / gradient.amax()));
    }
    let mut damped = hessian.clone();
    for i in 0..n {
        damped[(i, i)] += damping * mean;
    }
    let step = -Cholesky::new(damped)?.solve(gradient);
    let length = step.amax();
    if !length.is_finite() || step.dot(gradient) >= 0.0 {
        return None;
    }
    Some(if length > trust { step * (trust / length) } else { step })
}

/// Halves the step until the energy falls enough or the gradient halves; also says whether it never had to.
fn line_search(
    potential: &impl Potential,
    q: &DVector<f64>,
    step: &DVector<f64>,
    gradient: &DVector<f64>,
    factor: f64,
) -> Option<(DVector<f64>, bool)> {
    const ENOUGH: f64 = 1e-4;
    let (energy, slope, residual) = (potential.energy(q, factor), step.dot(gradient), gradient.amax());
    let mut share = 1.0;
    for _ in 0..40 {
        let tried = q + step * share;
        // near round-off the energy says nothing any more
        if potential.energy(&tried, factor) <= energy + ENOUGH * share * slope
            && energy + ENOUGH * share * slope < energy
            || potential.gradient(&tried, factor).amax() <= 0.5 * residual
        {
            return Some((step * share, share == 1.0));
        }
        share /= 2.0;
    }
    None
}
