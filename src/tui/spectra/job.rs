//! What is asked of the background, and how it answers: in parts, each as soon as it is known.

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use super::quantity::Quantity;
use super::solve::{ModelCurves, Subject};
use super::why::Findings;
use crate::agreement::{ModalComparison, ModalError};
use crate::comparison::{Observer, SolveError};
use crate::design;
use crate::model::ModelKind;
use crate::tui::backend::Backend;
use crate::tui::message::Message;
use crate::tui::solving::{Ticket, guarded};
use crate::tui::widgets::findings::sentence;

/// The shortest time between two reports of progress.
const PROGRESS: Duration = Duration::from_millis(100);

/// What is to be shown, and what of it is known.
#[derive(Debug, Clone)]
pub struct SpectraJob {
    pub ticket: Ticket,
    pub path: PathBuf,
    /// What is to be solved in place of the file
    pub text: Option<String>,
    pub known: Known,
    /// Finite elements first
    pub kinds: Vec<ModelKind>,
    pub quantity: Quantity,
    /// Held against finite elements
    pub against: ModelKind,
    /// dB
    pub tolerance: f64,
}

/// A job is its ticket.
impl PartialEq for SpectraJob {
    fn eq(&self, other: &Self) -> bool {
        self.ticket == other.ticket
    }
}

/// What came so far.
#[derive(Debug, Clone, Default)]
pub struct Known {
    pub subject: Option<Arc<Subject>>,
    pub models: Vec<Arc<ModelCurves>>,
    pub modes: Vec<Arc<ModalComparison>>,
    pub findings: Option<Arc<Findings>>,
}

/// One more thing that is known.
#[derive(Debug)]
pub enum Part {
    Subject(Arc<Subject>),
    Model(Arc<ModelCurves>),
    Modes(Arc<ModalComparison>),
    Findings(Arc<Findings>),
    /// From 0 to 1, of one model
    Progress(f64),
    /// One model has none, and why; with nothing to name the design has none
    Failed(Option<ModelKind>, String),
    Done,
}

impl Known {
    pub fn model(&self, kind: ModelKind) -> Option<&Arc<ModelCurves>> {
        self.models.iter().find(|model| model.kind == kind)
    }

    pub fn modes_of(&self, kind: ModelKind) -> Option<&Arc<ModalComparison>> {
        self.modes.iter().find(|modes| modes.lumped_model.kind == kind)
    }

    /// Takes in what came, in the place of what it replaces.
    pub fn take(&mut self, part: &Part) {
        match part {
            Part::Subject(subject) => self.subject = Some(Arc::clone(subject)),
            Part::Model(model) => {
                self.models.retain(|other| other.kind != model.kind);
                self.models.push(Arc::clone(model));
            }
            Part::Modes(modes) => self.modes.push(Arc::clone(modes)),
            Part::Findings(findings) => self.findings = Some(Arc::clone(findings)),
            Part::Progress(_) | Part::Failed(..) | Part::Done => {}
        }
    }
}

/// Does a job as long as it is wanted. A panic in the backend becomes the job's error.
pub fn perform(mut job: SpectraJob, backend: &dyn Backend, wanted: &dyn Fn() -> bool, report: &mut dyn FnMut(Message)) {
    let ticket = job.ticket;
    let mut tell = |part: Part| report(Message::Spectra { ticket, part: Box::new(part) });
    let done = guarded(|| job.run(backend, wanted, &mut tell));
    match done {
        Ok(Ok(())) => tell(Part::Done),
        Ok(Err(Ended::Cancelled)) => {}
        Ok(Err(Ended::Failed(text))) => tell(Part::Failed(None, text)),
        Err(panic) => tell(Part::Failed(None, format!("Solving failed unexpectedly: {panic}"))),
    }
}

enum Ended {
    Cancelled,
    Failed(String),
}

impl From<SolveError> for Ended {
    fn from(error: SolveError) -> Self {
        if error == SolveError::Cancelled { Self::Cancelled } else { Self::Failed(error.to_string()) }
    }
}

impl SpectraJob {
    fn run(
        &mut self,
        backend: &dyn Backend,
        wanted: &dyn Fn() -> bool,
        tell: &mut dyn FnMut(Part),
    ) -> Result<(), Ended> {
        let subject = self.subject(backend, tell)?;
        let mut last = Instant::now();
        let mut failed = Vec::new();
        // all curves first, then what makes them exact
        for refine in [false, true] {
            for kind in self.kinds.clone() {
                if failed.contains(&kind) {
                    continue;
                }
                let mut observer = |done| {
                    if last.elapsed() >= PROGRESS {
                        last = Instant::now();
                        tell(Part::Progress(done));
                    }
                    if wanted() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
                };
                match self.model(kind, refine, &subject, backend, &mut observer) {
                    Ok(Some(model)) => {
                        let part = Part::Model(Arc::new(model));
                        self.known.take(&part);
                        tell(part);
                    }
                    Ok(None) => {}
                    Err(SolveError::Cancelled) => return Err(Ended::Cancelled),
                    Err(error) => {
                        failed.push(kind);
                        tell(Part::Failed(Some(kind), error.to_string()));
                    }
                }
            }
            self.look(&subject, tell);
        }
        if !wanted() {
            return Err(Ended::Cancelled);
        }
        let solved = |kind| self.known.model(kind).map(|model| model.solved().clone());
        if self.known.modes_of(self.against).is_none()
            && !failed.contains(&self.against)
            && let (Some(fe), Some(lumped)) = (solved(ModelKind::Fe), solved(self.against))
        {
            let mut done = || if wanted() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
            let modes = match ModalComparison::of(&fe, &lumped, &subject.design, &subject.rotors, &mut done) {
                Err(ModalError::Cancelled) => return Err(Ended::Cancelled),
                modes => modes.map_err(SolveError::from)?,
            };
            let part = Part::Modes(Arc::new(modes));
            self.known.take(&part);
            tell(part);
            self.look(&subject, tell);
        }
        Ok(())
    }

    /// Reads the design, if that was not done.
    fn subject(&mut self, backend: &dyn Backend, tell: &mut dyn FnMut(Part)) -> Result<Arc<Subject>, Ended> {
        if let Some(subject) = &self.known.subject {
            return Ok(Arc::clone(subject));
        }
        let text = self.text.clone().or_else(|| backend.read(&self.path).ok());
        let (design, hash) = if let Some(text) = text {
            let reading = design::read(&text);
            let error = reading.errors().next().map(sentence).unwrap_or_default();
            (reading.design.ok_or(Ended::Failed(error))?, Some(design::hash(text.as_bytes())))
        } else {
            let loaded = backend.load(&self.path).map_err(|broken| Ended::Failed(broken.one_line))?;
            (loaded.design, None)
        };
        let subject = Arc::new(Subject::new(design, hash)?);
        self.known.subject = Some(Arc::clone(&subject));
        tell(Part::Subject(Arc::clone(&subject)));
        Ok(subject)
    }

    /// One more step of a model; nothing where it is as it is wanted.
    fn model(
        &self,
        kind: ModelKind,
        refine: bool,
        subject: &Subject,
        backend: &dyn Backend,
        observer: &mut Observer<'_>,
    ) -> Result<Option<ModelCurves>, SolveError> {
        let with = |model: &ModelCurves, observer: &mut Observer<'_>| match model.curve(self.quantity) {
            Some(_) => Ok(None),
            None => model.with(subject, self.quantity, observer).map(Some),
        };
        match self.known.model(kind) {
            None => {
                let model = backend.spectrum(subject, kind, observer)?;
                Ok(Some(with(&model, observer)?.unwrap_or(model)))
            }
            Some(known) if refine && !known.is_refined => {
                let model = known.refined(subject, observer)?;
                Ok(Some(with(&model, observer)?.unwrap_or(model)))
            }
            Some(known) => with(known, observer),
        }
    }

    /// Bands and peaks, if they are not those that are known.
    fn look(&mut self, subject: &Subject, tell: &mut dyn FnMut(Part)) {
        let modes = self.known.modes_of(self.against);
        let curve = |kind| self.known.model(kind).and_then(|model| model.curve(self.quantity));
        let other = if self.against == ModelKind::Enhanced { ModelKind::Basic } else { ModelKind::Enhanced };
        let beside = curve(other).map(|curve| (other, &**curve));
        let is_known = self.known.findings.as_ref().is_some_and(|known| {
            known.against == self.against
                && known.quantity == self.quantity
                && (known.tolerance - self.tolerance).abs() < f64::EPSILON
                && known.is_complete == modes.is_some()
                && known.beside.is_some() == beside.is_some()
        });
        let (Some(fe), Some(lumped)) = (curve(ModelKind::Fe), curve(self.against)) else { return };
        if is_known {
            return;
        }
        let findings = Findings::new(subject, fe, (self.against, lumped), beside, self.tolerance, modes);
        let part = Part::Findings(Arc::new(findings));
        self.known.take(&part);
        tell(part);
    }
}
