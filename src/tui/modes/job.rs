//! The work behind the screen of the modes, done on a thread of its own: the latest request counts.

use std::path::PathBuf;
use std::sync::Arc;

use super::study::{DeflectionShapes, Study};
use crate::comparison::SolveError;
use crate::tui::backend::Backend;
use crate::tui::message::Message;
use crate::tui::solving::{Ticket, guarded};
use crate::{design, tui};

/// A request.
#[derive(Debug, Clone)]
pub struct ModesJob {
    pub ticket: Ticket,
    pub wanted: Wanted,
}

/// Each request has a number of its own.
impl PartialEq for ModesJob {
    fn eq(&self, other: &Self) -> bool {
        self.ticket == other.ticket
    }
}

/// What is computed.
#[derive(Debug, Clone)]
pub enum Wanted {
    /// The modes of a design, with its text where that is not saved, and the fixed-interface modes a rotor of the reduced model.
    Modes { path: PathBuf, unsaved: Option<String>, reduced: usize },
    /// The same with another reduced model.
    Reduced { study: Arc<Study>, reduced: usize },
    /// The deflection shapes at a frequency (Hz, greater than 0).
    Deflection { study: Arc<Study>, at_hz: f64 },
}

/// What came of it.
#[derive(Debug, Clone)]
pub enum Answer {
    Modes(Arc<Study>),
    Deflection(Arc<DeflectionShapes>),
}

/// Does a request; nothing where it is no longer wanted. A panic becomes its error.
pub fn perform(job: &ModesJob, backend: &dyn Backend, wanted: &dyn Fn() -> bool) -> Option<Message> {
    // nobody waits to be told what was given up
    let in_words = |error: SolveError| (error != SolveError::Cancelled).then(|| error.to_string());
    let result = match &job.wanted {
        Wanted::Modes { path, unsaved, reduced } => guarded(|| {
            let (design, hash) = match unsaved {
                None => {
                    let loaded = backend.load(path).map_err(|broken| Some(broken.one_line))?;
                    (loaded.design, loaded.hash)
                }
                Some(text) => {
                    let reading = design::read(text);
                    let error = reading.errors().next().map(tui::widgets::findings::sentence).unwrap_or_default();
                    (reading.design.ok_or(Some(error))?, Some(design::hash(text.as_bytes())))
                }
            };
            let mut study = backend.modes(&design, *reduced, wanted).map_err(in_words)?;
            study.hash = hash;
            Ok(Answer::Modes(Arc::new(study)))
        }),
        Wanted::Reduced { study, reduced } => guarded(|| {
            let study = study.with_reduced(*reduced, wanted).map_err(in_words)?;
            Ok(Answer::Modes(Arc::new(study)))
        }),
        Wanted::Deflection { study, at_hz } => guarded(|| {
            let found = study.deflection(*at_hz).map_err(in_words)?;
            Ok(Answer::Deflection(Arc::new(found)))
        }),
    };
    let result = match result {
        Ok(Ok(answer)) => Ok(answer),
        Ok(Err(None)) => return None,
        Ok(Err(Some(error))) => Err(error),
        Err(panic) => Err(format!("failed unexpectedly: {panic}")),
    };
    Some(Message::ModesFound { ticket: job.ticket, result })
}
