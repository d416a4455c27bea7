//! The whole way of a design: three models, their spectra, and how they agree.

use std::ops::ControlFlow;

use crate::agreement::{Agreement, AgreementError, ModalError, Tolerance, difference_db};
use crate::design::Design;
use crate::model::{Caveat, Model, ModelError, ModelKind, Rotors, RotorsError, modes_work};
use crate::response::{BearingForces, ResponseError, Solved, frequency_lines};

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
    /// Of the enhanced model
    pub caveats: Vec<Caveat>,
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
    let failed = |error| SolveError::Response { kind, error };
    solved(kind, design, rotors)?.spectrum(frequency_hz).map_err(failed)
}

/// One model of a design with the modes of its rotors.
///
/// # Errors
///
/// [`SolveError::Response`] names the model.
pub fn solved(kind: ModelKind, design: &Design, rotors: &Rotors) -> Result<Solved, SolveError> {
    let model = Model::new(kind, design, rotors)?;
    Solved::new(model).map_err(|error| SolveError::Response { kind, error })
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
    let solved = solved(kind, design, rotors)?;
    let recovery = solved.model.recovery(design, rotors)?;
    let spectrum = solved.spectrum(frequency_hz).map_err(failed)?;
    let forces = BearingForces::new(&solved.model, &solved.rotor_modes, &recovery);
    let bearings = forces.spectra(&solved.model, frequency_hz, &spectrum.mesh_force);
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
    compare_rotors(design, &Rotors::new(design)?, band, observer)
}

/// As [`compare_over`], of a design whose rotors are there already.
///
/// # Errors
///
/// As [`compare_over`].
pub fn compare_rotors(
    design: &Design,
    rotors: &Rotors,
    band: Option<[f64; 2]>,
    observer: &mut Observer<'_>,
) -> Result<Comparison, SolveError> {
    Ok(compare_solved(design, rotors, band, observer)?.0)
}

/// As [`compare_rotors`], with what it rests on: finite elements, the enhanced and the basic model.
///
/// # Errors
///
/// As [`compare_over`].
pub fn compare_solved(
    design: &Design,
    rotors: &Rotors,
    band: Option<[f64; 2]>,
    observer: &mut Observer<'_>,
) -> Result<(Comparison, [Solved; 3]), SolveError> {
    // large matrices are filled before any is solved
    if observer(0.0).is_break() {
        return Err(SolveError::Cancelled);
    }
    let frequency_hz = frequency_lines(&design.analysis);
    let model = |kind| Model::new(kind, design, rotors);
    let models = [model(ModelKind::Fe)?, model(ModelKind::Enhanced)?, model(ModelKind::Basic)?];
    let mut progress = Progress::new(&models, frequency_hz.len(), observer);
    let mut spectrum = |model| observed_spectrum(model, &frequency_hz, &mut progress);
    let [fe, enhanced, basic] = models;
    let [(fe, of_fe), (enhanced, of_enhanced), (basic, of_basic)] =
        [spectrum(fe)?, spectrum(enhanced)?, spectrum(basic)?];
    let agreement = |lumped: &Spectrum| {
        Agreement::new(&frequency_hz, &lumped.mesh_force, &fe.mesh_force, band, Tolerance::default())
    };
    let (enhanced_agreement, basic_agreement) = (agreement(&enhanced)?, agreement(&basic)?);
    let caveats = rotors.caveats();
    let comparison = Comparison { frequency_hz, fe, enhanced, basic, enhanced_agreement, basic_agreement, caveats };
    Ok((comparison, [of_fe, of_enhanced, of_basic]))
}

/// A spectrum in steps that the observer can come between.
fn observed_spectrum(
    model: Model,
    frequency_hz: &[f64],
    progress: &mut Progress<'_, '_>,
) -> Result<(Spectrum, Solved), SolveError> {
    const LINES_A_STEP: usize = 8192;
    let kind = model.kind;
    let failed = |error| match error {
        ResponseError::Cancelled => SolveError::Cancelled,
        error => SolveError::Response { kind, error },
    };
    progress.add(0.0)?;
    let mut modes = |work| progress.hear(WORK_OF_MODES * work);
    let solved = Solved::over(model, &mut modes).map_err(failed)?;
    let (model, compliance) = (&*solved.model, solved.compliance());
    let mut spectrum = Spectrum::with_capacity(frequency_hz.len(), model.coordinates());
    for lines in frequency_hz.chunks(LINES_A_STEP) {
        spectrum.extend(model, &compliance, lines).map_err(failed)?;
        progress.add(lines_cost(model, lines.len()))?;
    }
    Ok((spectrum, solved))
}

/// How long a unit of the modes' work takes, as a multiple of that of the lines; measured.
const WORK_OF_MODES: f64 = 1.3;

/// Terms of the shortcut on some lines.
fn lines_cost(model: &Model, lines: usize) -> f64 {
    lines as f64 * model.coordinates() as f64
}

/// How much of the work is done, and who wants to know.
struct Progress<'a, 'o> {
    done: f64,
    all: f64,
    observer: &'a mut Observer<'o>,
}

impl<'a, 'o> Progress<'a, 'o> {
    fn new(models: &[Model], lines: usize, observer: &'a mut Observer<'o>) -> Self {
        let modes = |model: &Model| model.rotors().into_iter().map(modes_work).sum::<f64>();
        let all = models.iter().map(|model| WORK_OF_MODES * modes(model) + lines_cost(model, lines)).sum();
        Self { done: 0.0, all, observer }
    }

    fn hear(&mut self, cost: f64) -> ControlFlow<()> {
        self.done += cost;
        // the sum of many steps may be beyond the whole by rounding
        (self.observer)((self.done / self.all).min(1.0))
    }

    fn add(&mut self, cost: f64) -> Result<(), SolveError> {
        if self.hear(cost).is_break() { Err(SolveError::Cancelled) } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::{BearingModel, Hold, library::SHIPPED, read};

    /// A shaft's coordinates as one group, which is the longest that a comparison can work without a word.
    fn coupled(elements: usize) -> Design {
        let mut design = read(SHIPPED[0].text).design.unwrap();
        for rotor in [&mut design.pinion, &mut design.gear] {
            for segment in &mut rotor.segments {
                segment.elements = elements;
            }
            for bearing in &mut rotor.bearings {
                let diagonal: [f64; 6] = [6e8, 2e8, 6e8, 2e5, 0.0, 2e5];
                let entry = |i: usize, j: usize| {
                    let geometric = (diagonal[i] * diagonal[j]).sqrt();
                    if i == j { geometric } else { 0.05 * geometric }
                };
                bearing.model = BearingModel::Matrix(std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))));
            }
        }
        design
    }

    #[test]
    fn no_step_of_a_large_design_is_long_and_a_break_is_heard_anywhere() {
        // as many as take a second: the shares do not depend on the number
        let design = coupled(12);
        let mut seen = vec![0.0];
        compare_over(&design, None, &mut |progress| {
            seen.push(progress);
            ControlFlow::Continue(())
        })
        .unwrap();
        let longest = seen.windows(2).map(|pair| pair[1] - pair[0]).fold(0.0, f64::max);
        assert!(longest < 0.1, "{longest}: {seen:?}");
        for part in [0.02, 0.3, 0.6, 0.9] {
            let mut after = 0;
            let ended = compare_over(&design, None, &mut |progress| {
                if progress < part {
                    return ControlFlow::Continue(());
                }
                after += 1;
                ControlFlow::Break(())
            });
            assert_eq!((ended, after), (Err(SolveError::Cancelled), 1), "{part}");
        }
    }

    #[test]
    fn what_is_wrong_with_both_shafts_is_said_of_both() {
        let mut design = read(SHIPPED[0].text).design.unwrap();
        for bearing in &mut design.gear.bearings {
            bearing.model = BearingModel::Matrix([[0.0; 6]; 6]);
        }
        let gear = compare(&design).unwrap_err().to_string();
        assert!(gear.starts_with("gear shaft: nothing holds it"), "{gear}");
        for bearing in &mut design.pinion.bearings {
            bearing.model = BearingModel::Rigid(Hold { x: true, y: false, z: true });
        }
        let both = compare(&design).unwrap_err().to_string();
        assert!(both.starts_with("pinion shaft: nothing holds it") && both.ends_with(&format!("; {gear}")), "{both}");
        for bearing in &mut design.pinion.bearings {
            bearing.model = BearingModel::Matrix([[0.0; 6]; 6]);
        }
        let alike = compare(&design).unwrap_err().to_string();
        assert_eq!(alike, gear.replace("gear shaft", "both shafts"));
    }

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
