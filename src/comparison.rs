//! The whole way of a design: three models, their spectra, and how they agree.

use crate::agreement::{Agreement, AgreementError, Tolerance};
use crate::design::Design;
use crate::model::{Model, ModelKind, Rotors, RotorsError};
use crate::response::{ResponseError, frequency_lines};

pub use crate::response::Spectrum;

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
pub enum SolveError {
    #[error(transparent)]
    Rotors(#[from] RotorsError),
    #[error("{} model: {error}", kind.name())]
    Response { kind: ModelKind, error: ResponseError },
    #[error(transparent)]
    Agreement(#[from] AgreementError),
}

/// Solves one model of a design on the given lines (Hz).
///
/// # Errors
///
/// [`SolveError::Response`] names the model and the result that cannot be computed.
pub fn solve(kind: ModelKind, design: &Design, rotors: &Rotors, frequency_hz: &[f64]) -> Result<Spectrum, SolveError> {
    let model = Model::new(kind, design, rotors);
    Spectrum::new(&model, frequency_hz).map_err(|error| SolveError::Response { kind, error })
}

/// Solves the finite element, the enhanced and the basic lumped model of a design and compares them over all its lines.
///
/// # Errors
///
/// [`SolveError`] names the rotor and what is wrong with it.
pub fn compare(design: &Design) -> Result<Comparison, SolveError> {
    compare_over(design, None)
}

/// As [`compare`], with all figures but the agreement limit over a band (Hz, both ends included).
///
/// # Errors
///
/// As [`compare`], or a band without a line.
pub fn compare_over(design: &Design, band: Option<[f64; 2]>) -> Result<Comparison, SolveError> {
    let rotors = Rotors::new(design)?;
    let frequency_hz = frequency_lines(&design.analysis);
    let solved = |kind| solve(kind, design, &rotors, &frequency_hz);
    let (fe, enhanced, basic) = (solved(ModelKind::Fe)?, solved(ModelKind::Enhanced)?, solved(ModelKind::Basic)?);
    let agreement = |lumped: &Spectrum| {
        Agreement::new(&frequency_hz, &lumped.mesh_force, &fe.mesh_force, band, Tolerance::default())
    };
    let (enhanced_agreement, basic_agreement) = (agreement(&enhanced)?, agreement(&basic)?);
    Ok(Comparison { frequency_hz, fe, enhanced, basic, enhanced_agreement, basic_agreement })
}
