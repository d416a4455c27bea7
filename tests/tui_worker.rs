//! What is no longer wanted is given up, and what comes after it does not wait.
#![allow(clippy::unwrap_used, reason = "a test may")]

mod tui_support;

use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use bevelscope::comparison::{Comparison, Observer, SolveError};
use bevelscope::design::Design;
use bevelscope::design::library::SHIPPED;
use bevelscope::model::Rotors;
use bevelscope::tui::compare::CompareJob;
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::message::{Effect, Message};
use bevelscope::tui::solving::{EditedJob, Ticket};
use bevelscope::tui::worker::Worker;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign};
use tui_support::{Screen, UNICODE, comparison, design, paths};

const LONG: Duration = Duration::from_secs(20);

/// Solves designs called `endless` until it is told to stop, and the others at once.
struct Endless {
    started: Sender<String>,
}

impl Backend for Endless {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        Ok(design(&path.file_stem().unwrap().to_string_lossy()).into())
    }

    fn compare(&self, design: &Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        self.started.send(design.name.clone()).unwrap();
        while design.name.starts_with("endless") {
            if observer(0.5).is_break() {
                return Err(SolveError::Cancelled);
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        Ok(comparison(design))
    }
}

/// Says whether rotors of an earlier edit were there.
struct Reusing(Sender<bool>);

impl Backend for Reusing {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        Ok(design(&path.file_stem().unwrap().to_string_lossy()).into())
    }

    fn compare(&self, design: &Design, _: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        Ok(comparison(design))
    }

    fn compare_edited(
        &self,
        design: &Design,
        rotors: &mut Option<Rotors>,
        _: &mut Observer<'_>,
    ) -> Result<Comparison, SolveError> {
        self.0.send(rotors.is_some()).unwrap();
        let solvable = bevelscope::design::read(SHIPPED[0].text).design.unwrap();
        *rotors = Some(Rotors::new(&solvable)?);
        Ok(comparison(design))
    }
}

#[test]
fn an_edit_is_solved_with_the_rotors_of_the_one_before() {
    let (seen, had_rotors) = channel();
    let (sender, _messages) = channel();
    let worker = Worker::start(Arc::new(Reusing(seen)), &sender).unwrap();
    for (ticket, expected) in [(1, false), (2, true), (3, true)] {
        let path = paths(&["a"])[0].clone();
        worker.solve_edited(EditedJob { ticket: Ticket(ticket), path, design: Arc::new(design("a")) });
        assert_eq!(had_rotors.recv_timeout(LONG), Ok(expected), "{ticket}");
    }
}

fn started() -> (Worker, Receiver<String>, Receiver<Message>) {
    let (started, solving) = channel();
    let (sender, messages) = channel();
    (Worker::start(Arc::new(Endless { started }), &sender).unwrap(), solving, messages)
}

fn job(ticket: u64, stems: [&str; 2]) -> CompareJob {
    CompareJob { ticket: Ticket(ticket), paths: paths(&stems).try_into().unwrap(), unsaved: [None, None] }
}

#[test]
fn a_newer_comparison_ends_the_older_one() {
    let (worker, solving, messages) = started();
    worker.compare(job(1, ["endless-a", "endless-b"]));
    assert!(solving.recv_timeout(LONG).unwrap().starts_with("endless-a"));
    worker.compare(job(2, ["c", "d"]));
    // neither the rest of the first nor its second design
    assert!(solving.recv_timeout(LONG).unwrap().starts_with('c'));
    let Message::Compared { ticket, result } = messages.recv_timeout(LONG).unwrap() else { unreachable!() };
    assert!(ticket == Ticket(2) && result.sides.iter().all(Result::is_ok));
    assert!(messages.try_recv().is_err());
}

#[test]
fn closing_the_view_ends_the_comparison() {
    let (worker, solving, _messages) = started();
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.held = true;
    screen.keys("mjc");
    assert_eq!(screen.app.mode, Mode::Compare);
    worker.compare(job(1, ["endless-a", "endless-b"]));
    solving.recv_timeout(LONG).unwrap();
    screen.effects.clear();
    screen.keys("<Esc>");
    assert!(screen.effects.contains(&Effect::CancelCompare));
    worker.cancel_compare();
    // whatever is compared next comes at once
    worker.compare(job(2, ["c", "d"]));
    assert!(solving.recv_timeout(LONG).unwrap().starts_with('c'));
}
