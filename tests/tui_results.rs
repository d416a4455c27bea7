//! Results come when they come: late, in any order, or never.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use std::path::Path;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use bevelscope::comparison::{Comparison, Observer, SolveError};
use bevelscope::design::Design;
use bevelscope::tui::message::{Effect, Message};
use bevelscope::tui::solving::{Job, Ticket};
use bevelscope::tui::worker::Worker;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign};
use tui_support::{MadeUp, STEMS, Screen, UNICODE, paths};

/// A solver that waits for the gate to be opened, once for each design.
struct Gated {
    started: Sender<String>,
    gate: Mutex<Receiver<()>>,
}

impl Backend for Gated {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        MadeUp.load(path)
    }

    fn compare(&self, design: &Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        self.started.send(design.name.clone()).unwrap();
        let _ = self.gate.lock().unwrap().recv();
        MadeUp.compare(design, observer)
    }
}

const LONG: Duration = Duration::from_secs(20);

#[test]
fn keys_are_answered_while_the_solver_is_held() {
    let (started, solving) = channel();
    let (open, gate) = channel();
    let (sender, messages) = channel();
    let worker = Worker::start(Arc::new(Gated { started, gate: Mutex::new(gate) }), &sender).unwrap();

    let mut screen = Screen::before_start(&STEMS, 80, 24, UNICODE, MadeUp);
    screen.held = true;
    let hand_over = |screen: &mut Screen| {
        for effect in screen.effects.drain(..) {
            if let Effect::Solve(job) = effect {
                worker.solve(job);
            }
        }
    };
    screen.effects = screen.app.start();
    hand_over(&mut screen);
    assert!(solving.recv_timeout(LONG).unwrap().contains("elastic"));
    screen.send(messages.recv_timeout(LONG).unwrap());
    assert!(screen.text().contains("Solving"), "{}", screen.text());
    // the side view needs no solution
    assert!(screen.text().contains("△ bearing"), "{}", screen.text());

    // the frame after each key is there although nothing is solved
    for (keys, selected) in [("j", "overhung-rigid"), ("j", "straddle-elastic"), ("k", "overhung-rigid")] {
        screen.keys(keys);
        hand_over(&mut screen);
        let marked = screen.text().lines().find(|line| line.contains('▌')).unwrap().to_owned();
        assert!(marked.contains(selected), "{marked}");
    }
    // the latest selection has replaced the one in between
    open.send(()).unwrap();
    assert!(solving.recv_timeout(LONG).unwrap().contains("rigid"));
    open.send(()).unwrap();
    loop {
        match messages.recv_timeout(Duration::from_secs(1)) {
            Ok(message) => screen.send(message),
            Err(RecvTimeoutError::Timeout) => break,
            Err(error) => panic!("{error}"),
        }
    }
    assert!(screen.text().contains("trust up to 3,364 Hz"), "{}", screen.text());
    assert!(solving.try_recv().is_err(), "a design that was left was solved");
}

/// The jobs that the explorer asks for after some keys.
fn solve_job(screen: &mut Screen, keys: &str) -> Job {
    screen.effects.clear();
    screen.keys(keys);
    let job = screen.effects.iter().find_map(|effect| match effect {
        Effect::Solve(job) => Some(job.clone()),
        _ => None,
    });
    job.unwrap()
}

#[test]
fn a_result_for_a_design_that_was_left_is_not_shown() {
    let mut screen = Screen::before_start(&STEMS, 80, 24, UNICODE, MadeUp);
    screen.held = true;
    let to_rigid = solve_job(&mut screen, "j");
    let to_straddle = solve_job(&mut screen, "j");
    screen.perform(&to_straddle);
    screen.perform(&to_rigid);
    screen.draw();
    assert!(screen.text().contains("trust up to 2,997 Hz"), "{}", screen.text());
    // but the library has learnt from it
    let row = screen.text().lines().find(|line| line.contains("overhung-rigid")).unwrap().to_owned();
    assert!(row.contains("3,364"), "{row}");
}

#[test]
fn an_older_result_never_overwrites_a_newer_one() {
    /// Reads and solves, to another limit for each ticket.
    fn deliver(screen: &mut Screen, job: &Job, limit: f64) {
        assert!(tui_support::design("overhung-elastic").analysis.frequency_max > limit);
        bevelscope::tui::solving::perform(job, &MadeUp, &mut |mut message| {
            if let Message::Solved { result: Ok(found), .. } = &mut message {
                found.summary.enhanced.agreement_limit_hz = limit;
            }
            screen.send(message);
        });
    }
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.held = true;
    let older = solve_job(&mut screen, "R");
    let newer = solve_job(&mut screen, "R");
    deliver(&mut screen, &newer, 1111.0);
    deliver(&mut screen, &older, 2222.0);
    assert!(screen.text().contains("trust up to 1,111 Hz"), "{}", screen.text());
    assert!(!screen.text().contains("2,222"), "{}", screen.text());
    // nor does it take the newer one's place while that is still to come
    let older = solve_job(&mut screen, "R");
    let newer = solve_job(&mut screen, "R");
    deliver(&mut screen, &older, 2222.0);
    assert!(screen.text().contains("1,111") && !screen.text().contains("2,222"), "{}", screen.text());
    deliver(&mut screen, &newer, 1112.0);
    assert!(screen.text().contains("trust up to 1,112 Hz"), "{}", screen.text());
    // one that was asked for before everything was marked to be read again
    let row = Job { ticket: Ticket(0), path: paths(&STEMS)[1].clone(), with_traces: false };
    deliver(&mut screen, &row, 2222.0);
    assert!(!screen.text().contains("2,222"), "{}", screen.text());
    // and a result for a file that is gone
    screen.send(Message::Listed(Ok(Vec::new())));
    deliver(&mut screen, &newer, 3333.0);
    assert!(screen.text().contains("No designs"));
}

#[test]
fn rows_in_sight_are_read_first() {
    let stems: Vec<String> = (0..100).map(|at| format!("design-{at:03}")).collect();
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    let mut screen = Screen::before_start(&stems, 80, 24, UNICODE, MadeUp);
    screen.held = true;
    screen.keys("G");
    let Some(Effect::Fill(jobs)) = screen.effects.iter().rev().find(|effect| matches!(effect, Effect::Fill(_))) else {
        panic!("{:?}", screen.effects)
    };
    assert_eq!(jobs.len(), 100);
    assert!(*jobs[0].path.to_string_lossy() > *"/designs/design-090", "{:?}", jobs[0]);
}

/// A backend with an error of its own.
struct Panics;

impl Backend for Panics {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        assert!(!path.to_string_lossy().contains("typo"), "the reader is broken");
        MadeUp.load(path)
    }

    fn compare(&self, _: &Design, _: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        panic!("the solver is {}", "broken");
    }
}

#[test]
fn a_panic_of_the_backend_becomes_the_error_of_its_design() {
    let mut screen = Screen::with(&["typo", "overhung-elastic"], 80, 24, UNICODE, Panics);
    assert!(screen.text().contains("the reader is"), "{}", screen.text());
    screen.keys("j");
    assert!(screen.text().contains("the solver is"), "{}", screen.text());
}
