//! Does what the state asks for.

use std::io;

use super::message::{Effect, Ending};
use super::terminal::Session;
use super::worker::Worker;

/// Carries out the effects of a message. `Some` when the explorer ends.
///
/// # Errors
///
/// The terminal cannot be used.
pub fn perform(effects: Vec<Effect>, worker: &Worker, session: &mut Session) -> io::Result<Option<Ending>> {
    for effect in effects {
        match effect {
            Effect::Solve(job) => worker.solve(job),
            Effect::Fill(jobs) => worker.fill(jobs),
            Effect::SolveEdited(job) => worker.solve_edited(job),
            Effect::CancelSolve => worker.cancel(),
            Effect::File(job) => worker.file(job),
            Effect::Keep(change) => worker.keep(change),
            Effect::List => worker.list(),
            Effect::ChangeFile(request) => worker.change_file(request),
            Effect::Compare(job) => worker.compare(job),
            Effect::CancelCompare => worker.cancel_compare(),
            Effect::Spectra(job) => worker.spectra(*job),
            Effect::CancelSpectra => worker.cancel_spectra(),
            Effect::Modes(job) => worker.modes(job),
            Effect::CancelModes => worker.cancel_modes(),
            Effect::Redraw => session.clear()?,
            Effect::Copy(bytes) => session.send(&bytes)?,
            Effect::Suspend => session.suspend()?,
            Effect::TakeAgain => session.take_again()?,
            Effect::Quit(ending) => return Ok(Some(ending)),
        }
    }
    Ok(None)
}
