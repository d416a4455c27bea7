//! Edits are solved at once, over the saved state, and the latest wins.

use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{Sender, channel};
use std::time::Duration;

use crate::tui_support::{Screen, UNICODE};
use crate::{editing, opened};
use bevelscope::comparison::{Comparison, Observer, SolveError, compare_over};
use bevelscope::design::Design;
use bevelscope::tui::editor::Tab;
use bevelscope::tui::message::{Effect, Message};
use bevelscope::tui::solving::EditedJob;
use bevelscope::tui::worker::Worker;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign};

#[test]
fn an_edit_is_solved_at_once_over_the_saved_state() {
    let (mut screen, _) = opened(120, 40, UNICODE);
    assert!(screen.text().contains("trust up to 2,997 Hz,"), "{}", screen.text());
    assert!(!screen.text().contains("saved"), "{}", screen.text());
    screen.keys("<F2>llllc2e8<Enter>");
    let text = screen.text();
    assert!(text.contains("(was 2,997)") && text.contains("FE saved") && text.contains('·'), "{text}");
    assert!(!text.contains("stale"), "{text}");
    screen.keys("u");
    assert!(!screen.text().contains("was") && !screen.text().contains("stale"), "{}", screen.text());
    // a name has no mechanics
    screen.effects.clear();
    screen.keys("<F8>cother<Enter>");
    assert!(!screen.effects.iter().any(|effect| matches!(effect, Effect::SolveEdited(_))));
    assert!(!screen.text().contains("stale"), "{}", screen.text());
}

#[test]
fn errors_stop_solving_and_say_why() {
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.effects.clear();
    screen.keys("lc-5<Enter>k");
    let text = screen.text();
    assert!(text.contains("stale, not solved: 1 error") && text.contains("must be greater than 0"), "{text}");
    assert!(text.contains("-5]×"), "{text}");
    assert!(!screen.effects.iter().any(|effect| matches!(effect, Effect::SolveEdited(_))));
    screen.keys("=");
    assert!(screen.text().contains("not solved: 1 error in the design"), "{}", screen.text());
    // the list leads to the cell
    screen.keys("<F8>f");
    assert!(screen.text().contains("pinion.segment[0].outer_diameter_mm"), "{}", screen.text());
    screen.keys("<Enter>");
    assert_eq!((editing(&screen).tab, editing(&screen).cursor().column), (Tab::Segments, 1));
    screen.keys("c44<Enter>");
    assert!(!screen.text().contains("stale"), "{}", screen.text());
}

/// The job that some keys ask for.
fn job(screen: &mut Screen, keys: &str) -> EditedJob {
    screen.effects.clear();
    screen.keys(keys);
    let job = screen.effects.iter().rev().find_map(|effect| match effect {
        Effect::SolveEdited(job) => Some(job.clone()),
        _ => None,
    });
    job.unwrap()
}

#[test]
fn keys_are_answered_and_older_results_refused_while_the_solver_is_held() {
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.held = true;
    let older = job(&mut screen, "<F2>llllc2e8<Enter>");
    assert!(screen.text().contains("stale, solving 0 %"), "{}", screen.text());
    screen.send(Message::Progress { ticket: older.ticket, done: 0.37 });
    assert!(screen.text().contains("stale, solving 37 %"), "{}", screen.text());
    screen.keys("kc3");
    assert!(screen.text().contains("[3 "), "{}", screen.text());
    let newer = job(&mut screen, "e9<Enter>");
    assert!(newer.ticket > older.ticket);
    // the older one's progress and result come too late
    screen.send(Message::Progress { ticket: older.ticket, done: 0.99 });
    screen.perform_edited(&older);
    screen.draw();
    assert!(screen.text().contains("stale, solving 0 %"), "{}", screen.text());
    screen.perform_edited(&newer);
    screen.draw();
    assert!(!screen.text().contains("stale"), "{}", screen.text());
    let shown = editing(&screen).solving.current.as_ref().unwrap();
    assert_eq!(*shown.design, *newer.design);
    screen.perform_edited(&older);
    assert_eq!(*editing(&screen).solving.current.as_ref().unwrap().design, *newer.design);
}

#[test]
fn solving_can_be_stopped_turned_off_and_asked_for() {
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.held = true;
    let stopped = job(&mut screen, "lc45<Enter>");
    screen.keys("X");
    assert!(screen.effects.contains(&Effect::CancelSolve));
    assert!(screen.text().contains("stale: = solves"), "{}", screen.text());
    screen.perform_edited(&stopped);
    screen.draw();
    assert!(screen.text().contains("stale"), "{}", screen.text());
    screen.held = false;
    screen.keys("=");
    assert!(!screen.text().contains("stale"), "{}", screen.text());
    screen.keys("Lc41.5<Enter>");
    assert!(screen.text().contains("live off") && screen.text().contains("stale"), "{}", screen.text());
    screen.keys("=");
    assert!(!screen.text().contains("stale"), "{}", screen.text());
    screen.keys("c37<Enter>L");
    assert!(!screen.text().contains("stale") && !screen.text().contains("live off"), "{}", screen.text());
}

/// Solves until it is told to stop, unless the pinion's first segment is 42 mm long.
struct Endless {
    started: Sender<()>,
}

impl Backend for Endless {
    fn load(&self, _: &Path) -> Result<LoadedDesign, BrokenDesign> {
        panic!("an edited design is not read")
    }

    fn compare(&self, design: &Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        self.started.send(()).unwrap();
        if design.pinion.segments[0].length == 0.042 {
            return compare_over(design, None, observer);
        }
        while observer(0.5).is_continue() {
            std::thread::sleep(Duration::from_millis(1));
        }
        Err(SolveError::Cancelled)
    }
}

#[test]
fn a_newer_request_ends_the_older_one_and_so_does_the_key() {
    const LONG: Duration = Duration::from_secs(20);
    let (started, solving) = channel();
    let (sender, messages) = channel();
    let worker = Worker::start(Arc::new(Endless { started }), &sender).unwrap();
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.held = true;
    let hand_over = |screen: &mut Screen, keys: &str| {
        screen.effects.clear();
        screen.keys(keys);
        for effect in screen.effects.drain(..) {
            match effect {
                Effect::SolveEdited(job) => worker.solve_edited(job),
                Effect::CancelSolve => worker.cancel(),
                _ => {}
            }
        }
    };
    hand_over(&mut screen, "c41<Enter>k");
    solving.recv_timeout(LONG).unwrap();
    // it is followed in percent, and keys are answered meanwhile
    screen.send(messages.recv_timeout(LONG).unwrap());
    let text = screen.text();
    assert!(text.contains("stale, solving 50 %") && text.contains("X stop solving"), "{text}");
    hand_over(&mut screen, "lll");
    hand_over(&mut screen, "hhhX");
    assert!(screen.text().contains("stopped solving"), "{}", screen.text());
    hand_over(&mut screen, "c41.5<Enter>k");
    solving.recv_timeout(LONG).unwrap();
    hand_over(&mut screen, "c42<Enter>");
    solving.recv_timeout(LONG).unwrap();
    loop {
        let message = messages.recv_timeout(LONG).unwrap();
        let is_last = matches!(message, Message::SolvedEdited { .. });
        screen.send(message);
        if is_last {
            break;
        }
    }
    assert!(!screen.text().contains("stale"), "{}", screen.text());
    assert!(messages.try_recv().is_err());
}
