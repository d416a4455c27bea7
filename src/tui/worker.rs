//! Work in the background: reading and solving designs while keys are answered.
//!
//! A thread for each kind of work, so that neither the design under the cursor nor a file ever waits behind the library. Of
//! the selected design, and of two to be compared, the latest request or edit replaces what was still waiting and ends what is
//! being solved; another thread fills in the rows of the library; the rest read, write and move files.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;

use super::backend::Backend;
use super::compare::CompareJob;
use super::file_jobs::{FileJob, perform_file};
use super::files::FileRequest;
use super::message::Message;
use super::modes::ModesJob;
use super::recovery::{Keeper, Kept};
use super::solving::{EditedJob, Job, Ticket, change_file, guarded, perform, perform_edited, perform_while};
use super::spectra::{self, SpectraJob};

/// The background threads. They end when this is dropped, after the job they are at.
#[derive(Debug)]
pub struct Worker {
    shared: Arc<Shared>,
    keeper: Keeper,
}

#[derive(Debug, Default)]
struct Shared {
    queues: Mutex<Queues>,
    changed: Condvar,
    /// The ticket of the selected design's latest request; an older one is given up.
    latest: AtomicU64,
    /// The same of the latest comparison.
    latest_compared: AtomicU64,
    /// The same of the wide screen.
    latest_spectra: AtomicU64,
    /// The same of the latest modes.
    latest_modes: AtomicU64,
}

#[derive(Debug, Default)]
struct Queues {
    selected: Option<Task>,
    rows: VecDeque<Job>,
    list: bool,
    changes: VecDeque<FileRequest>,
    compare: Option<CompareJob>,
    spectra: Option<SpectraJob>,
    modes: Option<ModesJob>,
    files: VecDeque<FileJob>,
    closed: bool,
}

#[derive(Debug)]
enum Task {
    /// Of the library: always wanted.
    Fill(Job),
    /// Of the selected design: wanted while it is the latest.
    Solve(Job),
    SolveEdited(EditedJob),
    List,
    ChangeFile(FileRequest),
    Compare(Box<CompareJob>),
    Spectra(Box<SpectraJob>),
    Modes(ModesJob),
    File(FileJob),
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
        let keeper = Keeper::start(Arc::clone(&backend), sender.clone())?;
        let worker = Self { shared: Arc::default(), keeper };
        worker.spawn("selected", Arc::clone(&backend), sender, |queues| queues.selected.take())?;
        worker.spawn("changes", Arc::clone(&backend), sender, |queues| {
            queues.changes.pop_front().map(Task::ChangeFile)
        })?;
        worker.spawn("compare", Arc::clone(&backend), sender, |queues| {
            queues.compare.take().map(|job| Task::Compare(Box::new(job)))
        })?;
        worker.spawn("spectra", Arc::clone(&backend), sender, |queues| {
            queues.spectra.take().map(|job| Task::Spectra(Box::new(job)))
        })?;
        worker.spawn("modes", Arc::clone(&backend), sender, |queues| queues.modes.take().map(Task::Modes))?;
        worker.spawn("library", Arc::clone(&backend), sender, |queues| {
            if std::mem::take(&mut queues.list) { Some(Task::List) } else { queues.rows.pop_front().map(Task::Fill) }
        })?;
        worker.spawn("files", backend, sender, |queues| queues.files.pop_front().map(Task::File))?;
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
            let mut rotors = None;
            while let Some(task) = shared.next(&take) {
                let is_latest = |ticket: Ticket| shared.latest.load(Ordering::Relaxed) == ticket.0;
                match task {
                    Task::ChangeFile(request) => report(change_file(request, &*backend)),
                    Task::Compare(job) => {
                        let wanted = || shared.latest_compared.load(Ordering::Relaxed) == job.ticket.0;
                        let result = super::compare::perform(&job, &*backend, &wanted);
                        if let Some(result) = result.map(Box::new) {
                            report(Message::Compared { ticket: job.ticket, result });
                        }
                    }
                    Task::Spectra(job) => {
                        let ticket = job.ticket.0;
                        let wanted = || shared.latest_spectra.load(Ordering::Relaxed) == ticket;
                        spectra::perform(*job, &*backend, &wanted, &mut report);
                    }
                    Task::Modes(job) => {
                        let wanted = || shared.latest_modes.load(Ordering::Relaxed) == job.ticket.0;
                        super::modes::perform(&job, &*backend, &wanted).into_iter().for_each(&mut report);
                    }
                    Task::Fill(job) => perform(&job, &*backend, &mut report),
                    Task::Solve(job) => {
                        perform_while(&job, &*backend, &mut rotors, &|| is_latest(job.ticket), &mut report);
                    }
                    Task::SolveEdited(job) => {
                        perform_edited(&job, &*backend, &mut rotors, &|| is_latest(job.ticket), &mut report);
                    }
                    Task::File(job) => perform_file(job, &*backend).into_iter().for_each(&mut report),
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

    /// Asks for the selected design; what was waiting or being solved in its place is given up.
    pub fn solve(&self, job: Job) {
        self.select(job.ticket, Some(Task::Solve(job)));
    }

    /// Asks for a design as it is being edited, in the place of the selected one.
    pub fn solve_edited(&self, job: EditedJob) {
        self.select(job.ticket, Some(Task::SolveEdited(job)));
    }

    /// Gives up what is waiting or being solved in the place of the selected design.
    pub fn cancel(&self) {
        self.select(Ticket::default(), None);
    }

    fn select(&self, ticket: Ticket, task: Option<Task>) {
        let mut queues = self.shared.lock();
        queues.selected = task;
        self.shared.latest.store(ticket.0, Ordering::Relaxed);
        drop(queues);
        self.shared.changed.notify_all();
    }

    /// Asks for a file to be read or written, after those that were asked for before.
    pub fn file(&self, job: FileJob) {
        self.shared.lock().files.push_back(job);
        self.shared.changed.notify_all();
    }

    /// Asks for unsaved edits to be kept, or no longer.
    pub fn keep(&self, change: Kept) {
        self.keeper.keep(change);
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

    /// Asks for two designs to be compared; what was waiting or being solved for another comparison is given up.
    pub fn compare(&self, job: CompareJob) {
        self.set_compared(job.ticket, Some(job));
    }

    /// Gives up the comparison that is waiting or being made.
    pub fn cancel_compare(&self) {
        self.set_compared(Ticket::default(), None);
    }

    fn set_compared(&self, ticket: Ticket, job: Option<CompareJob>) {
        let mut queues = self.shared.lock();
        queues.compare = job;
        self.shared.latest_compared.store(ticket.0, Ordering::Relaxed);
        drop(queues);
        self.shared.changed.notify_all();
    }

    /// Asks for what the wide screen shows; what was waiting or being solved for it is given up.
    pub fn spectra(&self, job: SpectraJob) {
        self.set_spectra(job.ticket, Some(job));
    }

    /// Gives up what is waiting or being solved for the wide screen.
    pub fn cancel_spectra(&self) {
        self.set_spectra(Ticket::default(), None);
    }

    fn set_spectra(&self, ticket: Ticket, job: Option<SpectraJob>) {
        let mut queues = self.shared.lock();
        queues.spectra = job;
        self.shared.latest_spectra.store(ticket.0, Ordering::Relaxed);
        drop(queues);
        self.shared.changed.notify_all();
    }

    /// Asks for modes or a deflection shape; what was waiting or being computed in their place is given up.
    pub fn modes(&self, job: ModesJob) {
        self.set_modes(job.ticket, Some(job));
    }

    /// Gives up the modes that are waiting or being computed.
    pub fn cancel_modes(&self) {
        self.set_modes(Ticket::default(), None);
    }

    fn set_modes(&self, ticket: Ticket, job: Option<ModesJob>) {
        let mut queues = self.shared.lock();
        queues.modes = job;
        self.shared.latest_modes.store(ticket.0, Ordering::Relaxed);
        drop(queues);
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
