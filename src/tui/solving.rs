//! Reading and solving one design, and what is reported of it.

use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};

use super::backend::{Backend, BrokenDesign};
use super::bearings::BearingStates;
use super::files::FileRequest;
use super::message::Message;
use super::overview::outline;
use super::traces::Traces;
use crate::agreement::{Agreement, Peak, highest_peak};
use crate::comparison::{Comparison, SolveError};
use crate::crash;
use crate::design::Design;
use crate::model::{Caveat, Rotors};

/// Numbers the requests: of two results for the same thing, the one with the higher ticket counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Ticket(pub u64);

/// A design to be read and solved.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Job {
    pub ticket: Ticket,
    pub path: PathBuf,
    /// Whether the spectra are wanted, not only the figures for the library.
    pub with_traces: bool,
}

/// A design to be solved as it is being edited.
#[derive(Debug, Clone, PartialEq)]
pub struct EditedJob {
    pub ticket: Ticket,
    pub path: PathBuf,
    pub design: Arc<Design>,
}

/// What the library and the header say about a solved design.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    pub fe_coordinates: usize,
    pub lumped_coordinates: usize,
    /// Time for solving the three models.
    pub elapsed: Duration,
    /// Of the finite element model
    pub fe_peak: Option<Peak>,
    /// Levels of its spectrum in few columns, dB re 1 N
    pub fe_outline: Vec<f64>,
    pub enhanced: Agreement,
    pub basic: Agreement,
    /// Of the enhanced model
    pub caveats: Vec<Caveat>,
    /// What is unusual about the mean states of its bearings, a line each
    pub warnings: Box<[String]>,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Solved {
    pub summary: Summary,
    pub traces: Option<Box<Traces>>,
    /// Of the rotors that it was solved with; nothing where only the figures are wanted
    pub bearings: Option<Arc<BearingStates>>,
}

/// Does one job and reports the design as soon as it is read, then its solution.
///
/// A panic in the backend becomes the design's error: the rest of the library stays usable.
pub fn perform(job: &Job, backend: &dyn Backend, report: &mut dyn FnMut(Message)) {
    perform_while(job, backend, &mut None, &|| true, report);
}

/// As [`perform`]; a solution that is no longer wanted is given up without a word. `rotors` are those that were solved before.
pub(super) fn perform_while(
    job: &Job,
    backend: &dyn Backend,
    rotors: &mut Option<Rotors>,
    wanted: &dyn Fn() -> bool,
    report: &mut dyn FnMut(Message),
) {
    let Job { ticket, path, with_traces } = job.clone();
    let loaded = guarded(|| backend.load(&path)).unwrap_or_else(|panic| {
        Err(BrokenDesign {
            one_line: "reading failed".into(),
            full_text: format!("Reading failed unexpectedly: {panic}"),
        })
    });
    let loaded = match loaded {
        Ok(loaded) => Arc::new(loaded),
        Err(broken) => return report(Message::Loaded { ticket, path, result: Err(broken) }),
    };
    report(Message::Loaded { ticket, path: path.clone(), result: Ok(Arc::clone(&loaded)) });
    let mut observer = |_| if wanted() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
    let design = &loaded.design;
    let compare = |rotors: &mut Option<Rotors>| backend.compare_edited(design, rotors, &mut observer);
    if let Some(result) = solve(design, with_traces, rotors, compare) {
        report(Message::Solved { ticket, path, result });
    }
}

/// Changes a file and says what became of it.
pub fn change_file(request: FileRequest, backend: &dyn Backend) -> Message {
    let result = guarded(|| backend.change_file(&request));
    let result = result.unwrap_or_else(|panic| Err(format!("failed unexpectedly: {panic}")));
    Message::FileChanged { request, result }
}

/// The shortest time between two reports of progress.
const PROGRESS: Duration = Duration::from_millis(100);

/// Solves a design as it is being edited, and reports progress where it takes long. `rotors` are those of the edit before.
pub fn perform_edited(
    job: &EditedJob,
    backend: &dyn Backend,
    rotors: &mut Option<Rotors>,
    wanted: &dyn Fn() -> bool,
    report: &mut dyn FnMut(Message),
) {
    let EditedJob { ticket, path, design } = job.clone();
    let mut last = Instant::now();
    let mut observer = |done| {
        if last.elapsed() >= PROGRESS {
            last = Instant::now();
            report(Message::Progress { ticket, done });
        }
        if wanted() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let compare = |rotors: &mut Option<Rotors>| backend.compare_edited(&design, rotors, &mut observer);
    if let Some(result) = solve(&design, true, rotors, compare) {
        report(Message::SolvedEdited { ticket, path, result });
    }
}

/// The solution or why there is none; nothing if the observer ended it.
fn solve(
    design: &Design,
    with_traces: bool,
    rotors: &mut Option<Rotors>,
    compare: impl FnOnce(&mut Option<Rotors>) -> Result<Comparison, SolveError>,
) -> Option<Result<Solved, String>> {
    let started = Instant::now();
    let solved = guarded(|| {
        let comparison = compare(rotors)?;
        let bearings = rotors.as_ref().filter(|_| with_traces).map(|rotors| Arc::new(BearingStates::of(rotors)));
        let elapsed = started.elapsed();
        let traces = with_traces.then(|| Box::new(Traces::new(&comparison, &design.analysis)));
        let summary = Summary {
            fe_coordinates: comparison.fe.coordinates,
            lumped_coordinates: comparison.enhanced.coordinates,
            elapsed,
            fe_peak: highest_peak(&comparison.frequency_hz, &comparison.fe.mesh_force),
            fe_outline: outline(&comparison.fe.mesh_force),
            enhanced: comparison.enhanced_agreement,
            basic: comparison.basic_agreement,
            caveats: comparison.caveats,
            warnings: rotors.as_ref().map_or_else(Box::default, |rotors| rotors.mean_state_warnings(design).into()),
        };
        Ok(Solved { summary, traces, bearings })
    });
    match solved {
        Ok(Ok(solved)) => Some(Ok(solved)),
        Ok(Err(SolveError::Cancelled)) => None,
        Ok(Err(error)) => Some(Err(error.to_string())),
        Err(panic) => Some(Err(format!("Solving failed unexpectedly: {panic}"))),
    }
}

pub(super) fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(|| crash::caught(work))).map_err(|payload| {
        let text = payload.downcast_ref::<String>().cloned();
        text.or_else(|| payload.downcast_ref::<&str>().map(ToString::to_string)).unwrap_or_else(|| "no message".into())
    })
}
