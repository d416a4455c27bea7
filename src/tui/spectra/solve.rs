//! What the wide screen shows, computed in the background: one model after the other, each shown as soon as it is there.

use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::sync::Arc;

use num_complex::Complex64;

use super::curve::Curve;
use super::quantity::{Part, Quantity};
use crate::comparison::{Observer, SolveError};
use crate::design::Design;
use crate::model::{Model, ModelKind, RecoveryKind, Rotors};
use crate::response::{BearingForces, ResponseError, Solved, Spectrum, frequency_lines, refined_lines};

/// The design that is looked at.
#[derive(Debug)]
pub struct Subject {
    pub design: Design,
    pub rotors: Rotors,
    /// Of the file's bytes, or of what they would be if it were saved; nothing where there is no file
    pub hash: Option<String>,
    /// Lines of the analysis, Hz, ascending
    pub frequency_hz: Vec<f64>,
}

impl Subject {
    /// # Errors
    ///
    /// Rotors that cannot be solved.
    pub fn new(design: Design, hash: Option<String>) -> Result<Self, SolveError> {
        let rotors = Rotors::new(&design)?;
        let frequency_hz = frequency_lines(&design.analysis);
        Ok(Self { design, rotors, hash, frequency_hz })
    }
}

/// One model, solved.
#[derive(Debug)]
pub struct ModelCurves {
    pub kind: ModelKind,
    pub recovery: RecoveryKind,
    /// Lines of the analysis and those near resonances, Hz, ascending
    pub drawn_hz: Arc<Vec<f64>>,
    /// Whether the latter are in it.
    pub is_refined: bool,
    pub curves: Vec<Arc<Curve>>,
    solved: Solved,
    /// On the analysis lines
    spectrum: Arc<Spectrum>,
    /// On those that are drawn
    drawn: Arc<Spectrum>,
}

impl ModelCurves {
    /// The model that the curves are of.
    pub fn solved(&self) -> &Solved {
        &self.solved
    }

    pub fn curve(&self, quantity: Quantity) -> Option<&Arc<Curve>> {
        self.curves.iter().find(|curve| curve.quantity == quantity)
    }

    /// Solves a model on the lines of the analysis.
    ///
    /// # Errors
    ///
    /// [`SolveError`]; [`SolveError::Cancelled`] where the observer breaks.
    pub fn new(subject: &Subject, kind: ModelKind, observer: &mut Observer<'_>) -> Result<Self, SolveError> {
        let failed = |error| failed(kind, error);
        let model = Model::new(kind, &subject.design, &subject.rotors)?;
        let solved = Solved::over(model, &mut |_| observer(0.0)).map_err(failed)?;
        let spectrum = Arc::new(spectrum(&solved, &subject.frequency_hz, observer)?);
        let drawn_hz = Arc::new(subject.frequency_hz.clone());
        let mut out = Self {
            kind,
            recovery: RecoveryKind::of(kind),
            drawn_hz,
            is_refined: false,
            curves: Vec::new(),
            solved,
            drawn: Arc::clone(&spectrum),
            spectrum,
        };
        out.add_mesh_curves(subject);
        Ok(out)
    }

    /// The same with further lines on resonances and antiresonances, which are drawn only.
    ///
    /// # Errors
    ///
    /// As [`Self::new`].
    pub fn refined(&self, subject: &Subject, observer: &mut Observer<'_>) -> Result<Self, SolveError> {
        let lines = &subject.frequency_hz;
        let range = [lines.first().copied().unwrap_or(0.0), lines.last().copied().unwrap_or(0.0)];
        let mut drawn = refined_lines(&self.solved, &self.solved.compliance(), self.solved.frequencies(), range);
        drawn.extend(lines);
        drawn.sort_by(f64::total_cmp);
        drawn.dedup();
        let spectrum = spectrum(&self.solved, &drawn, observer)?;
        let mut out = Self {
            drawn_hz: Arc::new(drawn),
            drawn: Arc::new(spectrum),
            is_refined: true,
            curves: Vec::new(),
            ..self.shared()
        };
        out.add_mesh_curves(subject);
        Ok(out)
    }

    /// The same with the curve of a quantity.
    ///
    /// # Errors
    ///
    /// As [`Self::new`].
    pub fn with(&self, subject: &Subject, quantity: Quantity, observer: &mut Observer<'_>) -> Result<Self, SolveError> {
        let mut out = self.shared();
        let Quantity::Bearing { bearing, part } = quantity else { return Ok(out) };
        let Solved { model, rotor_modes } = &self.solved;
        let recovery = model.recovery(&subject.design, &subject.rotors)?;
        let forces = BearingForces::new(model, rotor_modes, &recovery);
        let mut all = vec![Complex64::ZERO; 6 * forces.bearings.len()];
        let mut values = |lines: &[f64], spectrum: &Spectrum| -> Result<Vec<Complex64>, SolveError> {
            const LINES_A_STEP: usize = 8192;
            let mut out = Vec::with_capacity(lines.len());
            for (i, (&frequency, &force)) in lines.iter().zip(&spectrum.mesh_force).enumerate() {
                if i % LINES_A_STEP == 0 && observer(0.0).is_break() {
                    return Err(SolveError::Cancelled);
                }
                let omega = TAU * frequency;
                forces.at(omega, model.structural_factor(omega), force, &mut all);
                out.push(component(all.get(6 * bearing..).unwrap_or_default(), part));
            }
            Ok(out)
        };
        let lines = values(&subject.frequency_hz, &self.spectrum)?;
        let drawn = values(&self.drawn_hz, &self.drawn)?;
        out.curves.push(Arc::new(Curve::new(quantity, lines, &drawn, &subject.frequency_hz)));
        Ok(out)
    }

    fn shared(&self) -> Self {
        Self {
            kind: self.kind,
            recovery: self.recovery,
            drawn_hz: Arc::clone(&self.drawn_hz),
            is_refined: self.is_refined,
            curves: self.curves.clone(),
            solved: self.solved.clone(),
            spectrum: Arc::clone(&self.spectrum),
            drawn: Arc::clone(&self.drawn),
        }
    }

    fn add_mesh_curves(&mut self, subject: &Subject) {
        let lines = &subject.frequency_hz;
        let um = |error: &[Complex64]| error.iter().map(|value| value * 1e6).collect::<Vec<_>>();
        let force = self.spectrum.mesh_force.clone();
        let error = um(&self.spectrum.transmission_error);
        self.curves.push(Arc::new(Curve::new(Quantity::MeshForce, force, &self.drawn.mesh_force, lines)));
        let drawn = um(&self.drawn.transmission_error);
        self.curves.push(Arc::new(Curve::new(Quantity::TransmissionError, error, &drawn, lines)));
    }
}

fn component(force: &[Complex64], part: Part) -> Complex64 {
    let &[x, y, z, ..] = force else { return Complex64::new(f64::NAN, 0.0) };
    match part {
        Part::X => x,
        Part::Y => y,
        Part::Z => z,
        Part::Radial => x.norm().hypot(z.norm()).into(),
        Part::Resultant => x.norm().hypot(y.norm()).hypot(z.norm()).into(),
    }
}

fn spectrum(solved: &Solved, lines: &[f64], observer: &mut Observer<'_>) -> Result<Spectrum, SolveError> {
    const LINES_A_STEP: usize = 8192;
    let (model, compliance) = (&*solved.model, solved.compliance());
    let mut spectrum = Spectrum::with_capacity(lines.len(), model.coordinates());
    for (i, chunk) in lines.chunks(LINES_A_STEP).enumerate() {
        let done = (i * LINES_A_STEP) as f64 / lines.len() as f64;
        if observer(done) == ControlFlow::Break(()) {
            return Err(SolveError::Cancelled);
        }
        spectrum.extend(model, &compliance, chunk).map_err(|error| failed(model.kind, error))?;
    }
    Ok(spectrum)
}

fn failed(kind: ModelKind, error: ResponseError) -> SolveError {
    match error {
        ResponseError::Cancelled => SolveError::Cancelled,
        error => SolveError::Response { kind, error },
    }
}
