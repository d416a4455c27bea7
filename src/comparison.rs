//! The whole way of a design: three models, their spectra, and how they agree.

use num_complex::Complex64;

use crate::agreement::Agreement;
use crate::design::Design;

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

/// The three models of a design solved on the lines of its analysis.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// Lines, Hz, ascending
    pub frequency_hz: Vec<f64>,
    pub fe: Spectrum,
    pub enhanced: Spectrum,
    pub basic: Spectrum,
    pub enhanced_agreement: Agreement,
    pub basic_agreement: Agreement,
}

/// Why a design cannot be solved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{message}")]
pub struct SolveError {
    pub message: String,
}

/// Solves the finite element, the enhanced and the basic lumped model of a design and compares them.
///
/// # Errors
///
/// [`SolveError`] names the rotor and what is wrong with it.
pub fn compare(design: &Design) -> Result<Comparison, SolveError> {
    let _ = design;
    Err(SolveError { message: "not written yet".into() })
}
