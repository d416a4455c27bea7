//! Work in the background: reading and solving designs while keys are answered.
//!
//! A thread for each kind of work, so that the design under the cursor never waits behind the library, nor a file behind
//! a solution: the selected design and two designs to be compared have a single slot each, in which the latest request replaces
//! what was still waiting; changes of files are done in their order; the last one fills in the rows of the library.

use std::collections::VecDeque;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::mpsc::Sender;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use super::backend::{Backend, BrokenDesign, LoadedDesign};
use super::compare::CompareJob;
use super::files::FileRequest;
use super::message::Message;
use super::traces::Traces;
use crate::agreement::Agreement;

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

/// What the library and the header say about a solved design.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    pub fe_coordinates: usize,
    pub lumped_coordinates: usize,
    /// Time for solving the three models.
    pub elapsed: Duration,
    pub enhanced: Agreement,
    pub basic: Agreement,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Solved {
    pub summary: Summary,
    pub traces: Option<Box<Traces>>,
}

/// Does one job and reports the design as soon as it is read, then its solution.
///
/// A panic in the backend becomes the design's error: the rest of the library stays usable.
pub fn perform(job: &Job, backend: &dyn Backend, report: &mut dyn FnMut(Message)) {
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
    let result = guarded(|| solve(&loaded, backend, with_traces))
        .unwrap_or_else(|panic| Err(format!("Solving failed unexpectedly: {panic}")));
    report(Message::Solved { ticket, path, result });
}

/// Changes a file and says what became of it.
pub fn change_file(request: FileRequest, backend: &dyn Backend) -> Message {
    let result = guarded(|| backend.change_file(&request));
    let result = result.unwrap_or_else(|panic| Err(format!("failed unexpectedly: {panic}")));
    Message::FileChanged { request, result }
}

fn solve(loaded: &LoadedDesign, backend: &dyn Backend, with_traces: bool) -> Result<Solved, String> {
    let started = Instant::now();
    let comparison = backend.compare(&loaded.design).map_err(|error| error.to_string())?;
    let elapsed = started.elapsed();
    let traces = with_traces.then(|| Box::new(Traces::new(&comparison, &loaded.design.analysis)));
    let summary = Summary {
        fe_coordinates: comparison.fe.coordinates,
        lumped_coordinates: comparison.enhanced.coordinates,
        elapsed,
        enhanced: comparison.enhanced_agreement,
        basic: comparison.basic_agreement,
    };
    Ok(Solved { summary, traces })
}

pub(super) fn guarded<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(work)).map_err(|payload| {
        let text = payload.downcast_ref::<String>().cloned();
        text.or_else(|| payload.downcast_ref::<&str>().map(ToString::to_string)).unwrap_or_else(|| "no message".into())
    })
}

/// The background threads. They end when this is dropped, after the job they are at.
#[derive(Debug)]
pub struct Worker {
    shared: Arc<Shared>,
}

#[derive(Debug, Default)]
struct Shared {
    queues: Mutex<Queues>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct Queues {
    selected: Option<Job>,
    rows: VecDeque<Job>,
    list: bool,
    changes: VecDeque<FileRequest>,
    compare: Option<CompareJob>,
    closed: bool,
}

enum Task {
    Solve(Job),
    List,
    ChangeFile(FileRequest),
    Compare(Box<CompareJob>),
}

impl Shared {
    /// A thread that panicked while it held the lock has left whole values behind: they are only moved in and out.
    fn lock(&self) -> MutexGuard<'_, Queues> {
        self.queues.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits for something to do; `None` when there will be nothing more.
    fn next(&self, take: impl Fn(&mut Queues) -> Option<Task>) -> Option<Task> {
        let mut queues = self.lock();
        loop {
            if queues.closed {
                return None;
            }
            if let Some(task) = take(&mut queues) {
                return Some(task);
            }
            queues = self.changed.wait(queues).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

impl Worker {
    /// Starts the threads; they report to `sender`.
    ///
    /// # Errors
    ///
    /// The system's, if it allows no more threads.
    pub fn start(backend: Arc<dyn Backend>, sender: &Sender<Message>) -> std::io::Result<Self> {
        let worker = Self { shared: Arc::default() };
        worker.spawn("selected", Arc::clone(&backend), sender, |queues| queues.selected.take().map(Task::Solve))?;
        worker.spawn("changes", Arc::clone(&backend), sender, |queues| {
            queues.changes.pop_front().map(Task::ChangeFile)
        })?;
        worker.spawn("compare", Arc::clone(&backend), sender, |queues| {
            queues.compare.take().map(|job| Task::Compare(Box::new(job)))
        })?;
        worker.spawn("library", backend, sender, |queues| {
            if std::mem::take(&mut queues.list) { Some(Task::List) } else { queues.rows.pop_front().map(Task::Solve) }
        })?;
        Ok(worker)
    }

    fn spawn(
        &self,
        name: &str,
        backend: Arc<dyn Backend>,
        sender: &Sender<Message>,
        take: impl Fn(&mut Queues) -> Option<Task> + Send + 'static,
    ) -> std::io::Result<()> {
        let (shared, sender) = (Arc::clone(&self.shared), sender.clone());
        // a receiver that is gone means that the program ends: nothing is left to be told
        let mut report = move |message| drop(sender.send(message));
        let work = move || {
            while let Some(task) = shared.next(&take) {
                match task {
                    Task::Solve(job) => perform(&job, &*backend, &mut report),
                    Task::ChangeFile(request) => report(change_file(request, &*backend)),
                    Task::Compare(job) => {
                        let result = Box::new(super::compare::perform(&job, &*backend));
                        report(Message::Compared { ticket: job.ticket, result });
                    }
                    Task::List => {
                        if let Some(listed) = guarded(|| backend.list()).unwrap_or_else(|panic| Some(Err(panic))) {
                            report(Message::Listed(listed));
                        }
                    }
                }
            }
        };
        thread::Builder::new().name(name.into()).spawn(work).map(drop)
    }

    /// Asks for the selected design; what was still waiting in its place is dropped.
    pub fn solve(&self, job: Job) {
        self.shared.lock().selected = Some(job);
        self.shared.changed.notify_all();
    }

    /// Asks for the rows of the library in this order, in place of what was still waiting.
    pub fn fill(&self, jobs: Vec<Job>) {
        self.shared.lock().rows = jobs.into();
        self.shared.changed.notify_all();
    }

    /// Asks for a file to be changed; such requests are carried out one after the other.
    pub fn change_file(&self, request: FileRequest) {
        self.shared.lock().changes.push_back(request);
        self.shared.changed.notify_all();
    }

    /// Asks for two designs to be compared, in place of what was still waiting.
    pub fn compare(&self, job: CompareJob) {
        self.shared.lock().compare = Some(job);
        self.shared.changed.notify_all();
    }

    /// Asks for the list of files.
    pub fn list(&self) {
        self.shared.lock().list = true;
        self.shared.changed.notify_all();
    }
}

impl Drop for Worker {
    fn drop(&mut self) {
        self.shared.lock().closed = true;
        self.shared.changed.notify_all();
    }
}
