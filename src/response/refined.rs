//! Further lines near resonances and antiresonances, so that no peak falls between the lines of a coarse grid.
//!
//! F_m = - k e / (1 + alpha k) is largest near the natural frequencies with the mesh and smallest near the poles of alpha, those without it.
//! Around each of them |F_m| is sampled on the scale of the damping; every extremum of all samples together is then closed in on by golden
//! section.

use std::f64::consts::TAU;

use super::{Compliance, Solved};
use crate::model::Model;

/// Places around a mode at which |F_m| is looked at, in half-power half-widths.
const AROUND: [f64; 13] = [-8.0, -4.0, -2.5, -1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.5, 4.0, 8.0];
/// Lines beside each extremum, in half-power half-widths: enough to draw its flanks.
const FLANKS: [f64; 6] = [-2.0, -1.0, -0.5, 0.5, 1.0, 2.0];
/// Relative width at which the search ends: the height is then good to the square of it.
const CLOSE: f64 = 1e-8;

/// Lines (Hz, ascending) on the maxima and minima of the mesh force strictly inside `range` (Hz), and six on the flanks of each.
///
/// `with_mesh` are the frequencies of all modes with the mesh, Hz, and `compliance` is the model's. There are at most 13 extrema a mode with
/// or without mesh in the range, in practice about one.
pub fn refined_lines(
    solved: &Solved,
    compliance: &Compliance,
    with_mesh: impl IntoIterator<Item = f64>,
    range: [f64; 2],
) -> Vec<f64> {
    let ([low, high], model) = (range, &*solved.model);
    let without = solved.rotor_modes.iter().flat_map(|modes| modes.stiffness.iter().zip(&modes.mass));
    let without = without.map(|(kappa, theta)| (kappa / theta).max(0.0).sqrt() / TAU);
    let mut samples = vec![low, high];
    for frequency in with_mesh.into_iter().chain(without).filter(|f| f.is_finite() && *f > 0.0) {
        let width = half_width(model, frequency);
        samples.extend(AROUND.map(|place| frequency + place * width).into_iter().filter(|f| (low..=high).contains(f)));
    }
    samples.sort_by(f64::total_cmp);
    samples.dedup_by(|b, a| *b - *a <= CLOSE * *a);
    let level = |frequency: f64| force_per_error(model, compliance, frequency).ln();
    let levels: Vec<f64> = samples.iter().map(|&f| level(f)).collect();
    let mut lines = Vec::new();
    for i in 1..samples.len().saturating_sub(1) {
        let (before, here, after) = (levels[i - 1], levels[i], levels[i + 1]);
        let sign = if here > before && here >= after {
            1.0
        } else if here < before && here <= after {
            -1.0
        } else {
            continue;
        };
        let peak = golden_section([samples[i - 1], samples[i + 1]], |f| sign * level(f));
        let width = half_width(model, peak);
        lines.push(peak);
        lines.extend(FLANKS.map(|place| peak + place * width).into_iter().filter(|f| *f > low && *f < high));
    }
    lines.sort_by(f64::total_cmp);
    lines.dedup();
    lines
}

/// Half of the half-power width of a resonance: half the loss factor times the frequency, Hz; never next to nothing.
fn half_width(model: &Model, frequency: f64) -> f64 {
    const LEAST: f64 = 1e-6;
    let omega = TAU * frequency;
    let structure = model.structural_factor(omega).im;
    0.5 * frequency * structure.clamp(LEAST, 0.5)
}

/// |F_m / e|, N/m.
fn force_per_error(model: &Model, compliance: &Compliance, frequency: f64) -> f64 {
    let omega = TAU * frequency;
    let k = model.complex_mesh_stiffness(omega);
    let alpha = compliance.at(omega, model.structural_factor(omega));
    (k / (1.0 + alpha * k)).norm()
}

/// Where a function with one maximum between two places has it (Kiefer 1953).
fn golden_section([mut low, mut high]: [f64; 2], value: impl Fn(f64) -> f64) -> f64 {
    const RATIO: f64 = 0.618_033_988_749_894_9;
    let (mut left, mut right) = (high - RATIO * (high - low), low + RATIO * (high - low));
    let (mut at_left, mut at_right) = (value(left), value(right));
    while high - low > CLOSE * high {
        if at_left >= at_right {
            (high, right, at_right) = (right, left, at_left);
            left = high - RATIO * (high - low);
            at_left = value(left);
        } else {
            (low, left, at_left) = (left, right, at_right);
            right = low + RATIO * (high - low);
            at_right = value(right);
        }
    }
    f64::midpoint(low, high)
}
