//! While modes are being computed, keys are answered; what is no longer wanted is given up.
#![allow(clippy::unwrap_used, reason = "a test may")]

mod tui_support;

use std::path::Path;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use bevelscope::comparison::{Comparison, Observer, SolveError};
use bevelscope::design::Design;
use bevelscope::design::library::SHIPPED;
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::message::{Effect, Message};
use bevelscope::tui::modes::{ModesJob, Study};
use bevelscope::tui::worker::Worker;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign};
use tui_support::{Screen, UNICODE, comparison};

const LONG: Duration = Duration::from_secs(60);

/// Computes modes only when the gate is opened, or ends when they are no longer wanted.
struct Gated {
    /// Says that it has begun, and how it ended
    said: Sender<&'static str>,
    gate: Mutex<Receiver<()>>,
}

impl Backend for Gated {
    fn load(&self, _: &Path) -> Result<LoadedDesign, BrokenDesign> {
        Ok(bevelscope::design::read(SHIPPED[0].text).design.unwrap().into())
    }

    fn compare(&self, design: &Design, _: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        Ok(comparison(design))
    }

    fn modes(&self, design: &Design, reduced: usize, wanted: &dyn Fn() -> bool) -> Result<Study, SolveError> {
        self.said.send("begun").unwrap();
        let gate = self.gate.lock().unwrap();
        while gate.try_recv().is_err() {
            if !wanted() {
                self.said.send("given up").unwrap();
                return Err(SolveError::Cancelled);
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        Study::new(design, reduced, wanted)
    }
}

struct Held {
    worker: Worker,
    said: Receiver<&'static str>,
    gate: Sender<()>,
    messages: Receiver<Message>,
    screen: Screen,
}

fn held() -> Held {
    let ((say, said), (gate, opened), (sender, messages)) = (channel(), channel(), channel());
    let worker = Worker::start(Arc::new(Gated { said: say, gate: Mutex::new(opened) }), &sender).unwrap();
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.held = true;
    Held { worker, said, gate, messages, screen }
}

impl Held {
    /// Presses a key, and hands to the worker what it asks of it.
    fn keys(&mut self, keys: &str) {
        self.screen.effects.clear();
        self.screen.keys(keys);
        for effect in &self.screen.effects {
            match effect {
                Effect::Modes(job) => self.worker.modes(ModesJob::clone(job)),
                Effect::CancelModes => self.worker.cancel_modes(),
                _ => {}
            }
        }
    }

    fn hears(&self, word: &str) {
        assert_eq!(self.said.recv_timeout(LONG), Ok(word));
    }
}

#[test]
fn keys_have_their_frame_while_modes_are_computed() {
    let mut held = held();
    held.keys("M");
    held.hears("begun");
    assert!(held.screen.text().contains("Computing the modes"), "{}", held.screen.text());
    held.keys("?");
    assert!(held.screen.text().contains(" Help "), "{}", held.screen.text());
    held.keys("<Esc>");
    // none of these has anything to act on yet
    held.keys("jx o<Tab>+-fhlGgy");
    assert!(held.screen.text().contains("Computing the modes"), "{}", held.screen.text());
    held.gate.send(()).unwrap();
    let message = held.messages.recv_timeout(LONG).unwrap();
    held.screen.send(message);
    assert!(held.screen.text().contains("partners by MAC"), "{}", held.screen.text());
}

#[test]
fn escape_gives_them_up_and_reopening_starts_anew() {
    let mut held = held();
    held.keys("M");
    held.hears("begun");
    held.keys("<Esc>");
    assert_eq!(held.screen.app.mode, Mode::Library);
    held.hears("given up");
    held.keys("M");
    held.hears("begun");
    held.gate.send(()).unwrap();
    let message = held.messages.recv_timeout(LONG).unwrap();
    held.screen.send(message);
    assert!(held.screen.text().contains("partners by MAC"), "{}", held.screen.text());
    // nothing was said of what was given up
    assert!(held.messages.try_recv().is_err());
}

#[test]
fn the_latest_design_wins() {
    let mut held = held();
    held.keys("M");
    held.hears("begun");
    // another design before the first one is there: its modes are given up by the request itself
    held.screen.keys("<Esc>j");
    held.keys("M");
    held.hears("given up");
    held.hears("begun");
    held.gate.send(()).unwrap();
    let message = held.messages.recv_timeout(LONG).unwrap();
    held.screen.send(message);
    let text = held.screen.text();
    assert!(text.contains("overhung-rigid: natural modes") && text.contains("partners by MAC"), "{text}");
    assert!(held.messages.try_recv().is_err());
}
