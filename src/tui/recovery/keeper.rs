//! The thread that keeps unsaved edits.

use std::collections::VecDeque;
use std::path::Path;
use std::sync::mpsc::Sender;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use super::Kept;
use crate::tui::backend::Backend;
use crate::tui::message::Message;
use crate::tui::solving::guarded;

/// How long the end of the program waits for what is still to be written.
const PATIENCE: Duration = Duration::from_millis(500);
/// How long until what could not be written is tried again.
const RETRY: Duration = Duration::from_secs(5);

/// Keeps unsaved edits, the latest of each design, on a thread of its own. When it is dropped, also by a panic, what is still to
/// be written gets a moment.
#[derive(Debug)]
pub struct Keeper {
    shared: Arc<Shared>,
}

#[derive(Debug, Default)]
struct Shared {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct State {
    waiting: VecDeque<Kept>,
    /// What could not be written and why, and what has to wait for it.
    failed: Vec<(Kept, String)>,
    is_busy: bool,
    closed: bool,
}

impl Shared {
    /// A thread that panicked while it held the lock has left whole values behind.
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Keeper {
    /// Starts the thread. It tells `sender` whenever edits cease to be protected, and when they are again.
    ///
    /// # Errors
    ///
    /// The system's, if it allows no more threads.
    pub fn start(backend: Arc<dyn Backend>, sender: Sender<Message>) -> std::io::Result<Self> {
        let shared = Arc::<Shared>::default();
        let of_thread = Arc::clone(&shared);
        let work = move || work(&of_thread, &*backend, &sender);
        thread::Builder::new().name("keeper".into()).spawn(work)?;
        Ok(Self { shared })
    }

    /// Asks for a change, in place of an earlier one of the same design that still waits.
    pub fn keep(&self, change: Kept) {
        let mut state = self.shared.lock();
        if edits_of(&change).is_some() {
            state.waiting.retain(|earlier| edits_of(earlier) != edits_of(&change));
            state.failed.retain(|(earlier, _)| edits_of(earlier) != edits_of(&change));
        }
        // edits are written before what they were taken from is removed
        let after = |waiting: &Kept| taken_by(waiting).is_some_and(|path| edits_of(&change) == Some(path));
        let place = state.waiting.iter().position(after).unwrap_or(state.waiting.len());
        state.waiting.insert(place, change);
        drop(state);
        self.shared.changed.notify_all();
    }
}

/// The design whose edits are replaced by a change.
fn edits_of(change: &Kept) -> Option<&Path> {
    match change {
        Kept::Edits { path, .. } | Kept::Nothing { path } => Some(path),
        Kept::Discarded { .. } | Kept::Taken { .. } | Kept::Unwanted { .. } => None,
    }
}

/// The design that edits of an earlier run belong to now.
fn taken_by(change: &Kept) -> Option<&Path> {
    if let Kept::Taken { path, .. } = change { Some(path) } else { None }
}

impl State {
    /// Carries on with a change that was not made, if it is worth it: what is only tidied up is found again anyway.
    fn failed(&mut self, change: Kept, error: String) -> Option<String> {
        if !matches!(change, Kept::Edits { .. }) {
            return Some(error);
        }
        if !self.waiting.iter().any(|newer| edits_of(newer) == edits_of(&change)) {
            self.failed.push((change, error));
        }
        None
    }

    /// What a change has to wait for.
    fn obstacle(&self, change: &Kept) -> Option<String> {
        let path = taken_by(change)?;
        self.failed.iter().find(|(failed, _)| edits_of(failed) == Some(path)).map(|(_, error)| error.clone())
    }

    fn try_again(&mut self) {
        self.failed.sort_by_key(|(change, _)| taken_by(change).is_some());
        let failed = std::mem::take(&mut self.failed);
        self.waiting.extend(failed.into_iter().map(|(change, _)| change));
    }
}

fn work(shared: &Shared, backend: &dyn Backend, sender: &Sender<Message>) {
    // a receiver that is gone means that the program ends: nobody is left to be told
    let tell = |message| drop(sender.send(message));
    let mut told: Option<String> = None;
    let mut state = shared.lock();
    loop {
        if let Some(change) = state.waiting.pop_front() {
            if let Some(obstacle) = state.obstacle(&change) {
                state.failed.push((change, obstacle));
                continue;
            }
            state.is_busy = true;
            drop(state);
            let result = guarded(|| backend.keep(&change)).unwrap_or_else(Err);
            state = shared.lock();
            state.is_busy = false;
            if let Some(untidy) = result.err().and_then(|error| state.failed(change, error)) {
                tell(Message::NotTidied(untidy));
            }
            if state.waiting.is_empty() {
                let problem = state.failed.first().map(|(_, error)| error.clone());
                if problem != told {
                    tell(Message::Protected(problem.clone().map_or(Ok(()), Err)));
                    told = problem;
                }
            }
            shared.changed.notify_all();
        } else if state.closed {
            return;
        } else if state.failed.is_empty() {
            state = shared.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        } else {
            let (after, timeout) = shared.changed.wait_timeout(state, RETRY).unwrap_or_else(PoisonError::into_inner);
            state = after;
            if timeout.timed_out() {
                state.try_again();
            }
        }
    }
}

impl Drop for Keeper {
    fn drop(&mut self) {
        let deadline = Instant::now() + PATIENCE;
        let mut state = self.shared.lock();
        state.closed = true;
        self.shared.changed.notify_all();
        while state.is_busy || !state.waiting.is_empty() {
            let left = deadline.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return;
            }
            state = self.shared.changed.wait_timeout(state, left).unwrap_or_else(PoisonError::into_inner).0;
        }
    }
}
