//! The whole way of a design: three models, their spectra, and how they agree.

use std::ops::ControlFlow;

use crate::agreement::{Agreement, AgreementError, ModalError, Tolerance, difference_db};
use crate::design::Design;
use crate::model::{Model, ModelError, ModelKind, Rotors, RotorsError};
use crate::response::{BearingForces, Compliance, ResponseError, both_rotor_modes, frequency_lines};

pub use crate::model::RecoveryKind;
pub use crate::response::{BearingSpectrum, Spectrum};

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

impl Comparison {
    /// RMS of the difference between the finite element spectra of two designs, dB; nothing where their lines differ.
    pub fn fe_rms_db(&self, other: &Self) -> Option<f64> {
        if self.frequency_hz != other.frequency_hz || self.frequency_hz.is_empty() {
            return None;
        }
        let differences = difference_db(&other.fe.mesh_force, &self.fe.mesh_force);
        let mean_square = differences.iter().map(|d| d * d).sum::<f64>() / differences.len() as f64;
        Some(mean_square.sqrt()).filter(|rms| rms.is_finite())
    }
}

/// Why a design cannot be solved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SolveError {
    #[error(transparent)]
    Rotors(#[from] RotorsError),
    #[error(transparent)]
    Model(#[from] ModelError),
    #[error("{} model: {error}", kind.name())]
    Response { kind: ModelKind, error: ResponseError },
    #[error(transparent)]
    Modes(#[from] ModalError),
    #[error(transparent)]
    Agreement(#[from] AgreementError),
    #[error("cancelled")]
    Cancelled,
}

/// Hears how far a comparison is (0 to 1) between its steps, and may end it.
pub type Observer<'a> = dyn FnMut(f64) -> ControlFlow<()> + 'a;

/// Solves one model of a design on the given lines (Hz).
///
/// # Errors
///
/// [`SolveError::Response`] names the model and the result that cannot be computed.
pub fn solve(kind: ModelKind, design: &Design, rotors: &Rotors, frequency_hz: &[f64]) -> Result<Spectrum, SolveError> {
    let model = Model::new(kind, design, rotors)?;
    Spectrum::new(&model, frequency_hz).map_err(|error| SolveError::Response { kind, error })
}

/// One model with the forces of its bearings on their shafts.
#[derive(Debug, Clone, PartialEq)]
pub struct WithBearings {
    pub spectrum: Spectrum,
    /// Pinion first, in the design's order
    pub bearings: Vec<BearingSpectrum>,
    /// How the displacements at the bearings follow from the model
    pub recovery: RecoveryKind,
}

/// As [`solve`], with the forces of all bearings on the same lines.
///
/// # Errors
///
/// As [`solve`].
pub fn solve_with_bearings(
    kind: ModelKind,
    design: &Design,
    rotors: &Rotors,
    frequency_hz: &[f64],
) -> Result<WithBearings, SolveError> {
    let failed = |error| SolveError::Response { kind, error };
    let model = Model::new(kind, design, rotors)?;
    let modes = both_rotor_modes(&model).map_err(failed)?;
    let recovery = model.recovery(design, rotors)?;
    let mut spectrum = Spectrum::with_capacity(frequency_hz.len(), model.coordinates());
    spectrum.extend(&model, &Compliance::with_modes(&model, &modes), frequency_hz).map_err(failed)?;
    let forces = BearingForces::new(&model, &modes, &recovery);
    let bearings = forces.spectra(&model, frequency_hz, &spectrum.mesh_force);
    let finite = |bearing: &BearingSpectrum, line: usize| bearing.force[line].iter().all(|f| f.is_finite());
    match (0..frequency_hz.len()).find(|&line| !bearings.iter().all(|bearing| finite(bearing, line))) {
        Some(line) => {
            Err(failed(ResponseError::LineNotFinite { what: "force of a bearing", at_hz: frequency_hz[line] }))
        }
        None => Ok(WithBearings { spectrum, bearings, recovery: forces.recovery }),
    }
}

/// Solves the finite element, the enhanced and the basic lumped model of a design and compares them over all its lines.
///
/// # Errors
///
/// [`SolveError`] names the rotor and what is wrong with it.
pub fn compare(design: &Design) -> Result<Comparison, SolveError> {
    compare_over(design, None, &mut |_| ControlFlow::Continue(()))
}

/// As [`compare`], with all figures but the agreement limit over a band (Hz, both ends included), and with an observer.
///
/// # Errors
///
/// As [`compare`]; a band without a line; [`SolveError::Cancelled`] where the observer breaks.
pub fn compare_over(
    design: &Design,
    band: Option<[f64; 2]>,
    observer: &mut Observer<'_>,
) -> Result<Comparison, SolveError> {
    let rotors = Rotors::new(design)?;
    let frequency_hz = frequency_lines(&design.analysis);
    let model = |kind| Model::new(kind, design, &rotors);
    let models = [model(ModelKind::Fe)?, model(ModelKind::Enhanced)?, model(ModelKind::Basic)?];
    let mut progress = Progress::new(&models, frequency_hz.len(), observer);
    let mut solved = |model: &Model| observed_spectrum(model, &frequency_hz, &mut progress);
    let [fe, enhanced, basic] = &models;
    let (fe, enhanced, basic) = (solved(fe)?, solved(enhanced)?, solved(basic)?);
    let agreement = |lumped: &Spectrum| {
        Agreement::new(&frequency_hz, &lumped.mesh_force, &fe.mesh_force, band, Tolerance::default())
    };
    let (enhanced_agreement, basic_agreement) = (agreement(&enhanced)?, agreement(&basic)?);
    Ok(Comparison { frequency_hz, fe, enhanced, basic, enhanced_agreement, basic_agreement })
}

/// A spectrum in steps that the observer can come between.
fn observed_spectrum(
    model: &Model,
    frequency_hz: &[f64],
    progress: &mut Progress<'_, '_>,
) -> Result<Spectrum, SolveError> {
    const LINES_A_STEP: usize = 8192;
    let failed = |error| SolveError::Response { kind: model.kind, error };
    progress.add(0.0)?;
    let compliance = Compliance::new(model).map_err(failed)?;
    progress.add(modes_cost(model))?;
    let mut spectrum = Spectrum::with_capacity(frequency_hz.len(), model.coordinates());
    for lines in frequency_hz.chunks(LINES_A_STEP) {
        spectrum.extend(model, &compliance, lines).map_err(failed)?;
        progress.add(lines_cost(model, lines.len()))?;
    }
    Ok(spectrum)
}

/// Operations of the modes of both rotors, roughly.
fn modes_cost(model: &Model) -> f64 {
    model.rotors().iter().map(|rotor| (rotor.coordinates.len() as f64).powi(3)).sum()
}

/// Operations of some lines of the shortcut, roughly, in the unit of [`modes_cost`].
fn lines_cost(model: &Model, lines: usize) -> f64 {
    2.0 * lines as f64 * model.coordinates() as f64
}

/// How much of the work is done, and who wants to know.
struct Progress<'a, 'o> {
    done: f64,
    all: f64,
    observer: &'a mut Observer<'o>,
}

impl<'a, 'o> Progress<'a, 'o> {
    fn new(models: &[Model], lines: usize, observer: &'a mut Observer<'o>) -> Self {
        let all = models.iter().map(|model| modes_cost(model) + lines_cost(model, lines)).sum();
        Self { done: 0.0, all, observer }
    }

    fn add(&mut self, cost: f64) -> Result<(), SolveError> {
        self.done += cost;
        match (self.observer)(self.done / self.all) {
            ControlFlow::Continue(()) => Ok(()),
            ControlFlow::Break(()) => Err(SolveError::Cancelled),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::{library::SHIPPED, read};

    #[test]
    fn progress_rises_to_one_and_a_break_ends_the_work() {
        let mut design = read(SHIPPED[0].text).design.unwrap();
        design.analysis.frequency_lines = 20_000;
        let mut seen = Vec::new();
        let watched = compare_over(&design, None, &mut |progress| {
            seen.push(progress);
            ControlFlow::Continue(())
        });
        assert_eq!(watched, compare(&design));
        assert!(seen.len() > 10 && seen.is_sorted(), "{seen:?}");
        assert!((seen[seen.len() - 1] - 1.0).abs() < 1e-9, "{seen:?}");
        let mut steps = 0;
        let ended = compare_over(&design, None, &mut |_| {
            steps += 1;
            if steps < 4 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        assert_eq!((ended, steps), (Err(SolveError::Cancelled), 4));
    }
}
