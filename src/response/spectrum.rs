//! Mesh force and transmission error over the frequency lines.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::{Compliance, ResponseError};
use crate::design::{Analysis, FrequencySpacing};
use crate::model::Model;

/// Response of one model to the transmission error, one value a frequency line.
#[derive(Debug, Clone, PartialEq)]
pub struct Spectrum {
    /// Dynamic mesh force F_m, N
    pub mesh_force: Vec<Complex64>,
    /// Dynamic transmission error delta_d, m
    pub transmission_error: Vec<Complex64>,
    /// Number of coordinates of the model
    pub coordinates: usize,
}

impl Spectrum {
    /// Response on the given lines (Hz, all greater than 0) by the exact shortcut.
    ///
    /// # Errors
    ///
    /// As [`Compliance::new`], or a line whose result overflows.
    pub fn new(model: &Model, frequency_hz: &[f64]) -> Result<Self, ResponseError> {
        let compliance = Compliance::new(model)?;
        let mut out = Self::with_capacity(frequency_hz.len(), model.coordinates());
        out.extend(model, &compliance, frequency_hz)?;
        Ok(out)
    }

    /// Adds the response on further lines (Hz, all greater than 0); `compliance` is the model's.
    ///
    /// # Errors
    ///
    /// A line whose result overflows.
    pub fn extend(
        &mut self,
        model: &Model,
        compliance: &Compliance,
        frequency_hz: &[f64],
    ) -> Result<(), ResponseError> {
        for &frequency in frequency_hz {
            let omega = TAU * frequency;
            let alpha = compliance.at(omega, model.structural_factor(omega));
            let k = model.complex_mesh_stiffness(omega);
            let force = -k * model.transmission_error / (1.0 + alpha * k);
            self.push(frequency, force, -alpha * force)?;
        }
        Ok(())
    }

    /// No lines yet, and room for some.
    pub fn with_capacity(lines: usize, coordinates: usize) -> Self {
        Self { mesh_force: Vec::with_capacity(lines), transmission_error: Vec::with_capacity(lines), coordinates }
    }

    pub(super) fn push(&mut self, at_hz: f64, force: Complex64, error: Complex64) -> Result<(), ResponseError> {
        // a force is never exactly zero, and its square is used in levels: both ends of the range are out
        let usable = |value: Complex64| value.is_finite() && (1e-150..1e150).contains(&value.norm());
        if !usable(force) {
            return Err(ResponseError::LineNotFinite { what: "mesh force", at_hz });
        }
        if !error.is_finite() {
            return Err(ResponseError::LineNotFinite { what: "transmission error", at_hz });
        }
        self.mesh_force.push(force);
        self.transmission_error.push(error);
        Ok(())
    }
}

/// The lines of an analysis, Hz, ascending, both ends exact.
pub fn frequency_lines(analysis: &Analysis) -> Vec<f64> {
    let (low, high) = (analysis.frequency_min, analysis.frequency_max);
    // a design that was read has two at least
    let last = analysis.frequency_lines.max(2) - 1;
    let between = |i: usize| {
        let t = i as f64 / last as f64;
        match analysis.frequency_spacing {
            FrequencySpacing::Linear => low + (high - low) * t,
            FrequencySpacing::Log => low * ((high / low).ln() * t).exp(),
        }
    };
    (0..=last)
        .map(|i| match i {
            0 => low,
            _ if i == last => high,
            _ => between(i),
        })
        .collect()
}
