//! The terminal explorer.
//!
//! ```text
//! keys, signals, results ──> Message ──> App::update ──> Effects ──> worker, terminal
//!                                            │
//!                                           App ──> view::draw ──> one frame
//! ```
//!
//! All of the state is in [`app::App`]; it changes by messages only, and touches neither terminal nor files. Drawing
//! reads the state. Designs are read and solved on background threads ([`worker`]), behind the [`Backend`] trait.
//! Nothing is drawn unless a message came in: an idle explorer writes nothing.

use std::io::{self, IsTerminal};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::{Duration, Instant};

pub mod action;
pub mod app;
pub mod axis;
pub mod backend;
pub mod bearings;
pub mod caps;
pub mod clipboard;
pub mod colours;
pub mod compare;
pub mod conflict;
mod copy;
pub mod editor;
pub mod effects;
pub mod export;
pub mod facts;
pub mod file_jobs;
pub mod files;
pub mod fuzzy;
pub mod help;
mod input;
pub mod keymap;
pub mod keys;
mod layers;
pub mod library;
mod looks;
pub mod marker;
pub mod message;
pub mod modes;
mod moving;
pub mod new_design;
pub mod notice;
pub mod overlays;
pub mod overview;
pub mod painter;
pub mod pair;
pub mod palette;
mod pen;
mod record;
pub mod recovery;
pub mod screens;
mod signals;
pub mod solving;
pub mod spectra;
pub mod terminal;
pub mod text;
pub mod text_field;
pub mod theme;
pub mod traces;
pub mod update;
pub mod view;
pub mod widgets;
pub mod worker;

pub use backend::{Backend, BrokenDesign, LoadedDesign, NotSaved};

use app::App;
use caps::Capabilities;
use clipboard::Route;
use keys::Keys;
use message::{Effect, Ending, Message};
use terminal::Session;
use worker::Worker;

/// What the command line asks of the explorer.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Options {
    /// Draw with ASCII only.
    pub ascii: bool,
    pub keys: Keys,
    /// What is wrong with the user's keys, a few words and in full.
    pub keys_report: Option<(String, String)>,
    /// What is to be known at the start.
    pub notice: Option<String>,
}

/// Why the explorer did not end by the user's wish.
#[derive(Debug, thiserror::Error)]
pub enum TuiError {
    #[error(
        "stdout is not a terminal, so there is nothing to show the explorer on; use `bevelscope check` or `bevelscope solve`"
    )]
    NotATerminal,
    #[error("the terminal is gone")]
    TerminalGone,
    #[error("ended by signal {0}")]
    Signal(i32),
    #[error("the terminal cannot be used: {0}")]
    Terminal(#[from] io::Error),
}

impl TuiError {
    /// The program's exit status after this error.
    pub fn exit_status(&self) -> u8 {
        match self {
            Self::NotATerminal => 2,
            Self::TerminalGone | Self::Terminal(_) => 1,
            Self::Signal(number) => u8::try_from(128 + number).unwrap_or(1),
        }
    }
}

/// How long a frame waits for the result that would replace it at once.
const SETTLE: Duration = Duration::from_millis(15);

/// Opens the explorer on the design files of `library`, in this order, and returns when the user quits. `shown_as` is
/// the library as the user names it. Nothing is read or solved before the first frame.
///
/// # Errors
///
/// [`TuiError`]; in any case the terminal is as it was before.
pub fn run(
    library: Vec<PathBuf>,
    shown_as: String,
    options: Options,
    backend: Arc<dyn Backend>,
) -> Result<(), TuiError> {
    if !io::stdout().is_terminal() {
        return Err(TuiError::NotATerminal);
    }
    let capabilities = Capabilities::detect(options.ascii, |name| std::env::var(name).ok());
    let mut app = App::new(library, shown_as, capabilities);
    app.clipboard = Route::detect(|name| std::env::var(name).ok());
    app.keys = options.keys;
    if let Some(notice) = options.notice {
        app.say(notice);
    }
    if let Some((short, full)) = options.keys_report {
        app.complain_at_length(short, full);
    }
    let (sender, receiver) = mpsc::channel();
    // before the terminal is taken over: a signal that comes in between is not lost
    signals::watch(sender.clone())?;
    let mut session = Session::enter()?;
    session.draw(&mut app)?;
    input::start(sender.clone())?;
    signals::watch_terminal(sender.clone())?;
    let worker = Worker::start(backend, &sender)?;
    drop(sender);
    let ending = run_loop(&mut app, &receiver, &worker, &mut session)?;
    drop(session);
    match ending {
        Ending::Quit => Ok(()),
        Ending::Signal(number) => Err(TuiError::Signal(number)),
        Ending::TerminalGone => Err(TuiError::TerminalGone),
    }
}

fn take_in(app: &mut App, message: Message) -> Vec<Effect> {
    record::record(&message);
    app.update(message)
}

fn run_loop(app: &mut App, receiver: &Receiver<Message>, worker: &Worker, session: &mut Session) -> io::Result<Ending> {
    let mut effects = app.start();
    loop {
        if let Some(ending) = effects::perform(effects, worker, session)? {
            return Ok(ending);
        }
        let Ok(message) = receiver.recv() else { return Ok(Ending::TerminalGone) };
        effects = take_in(app, message);
        // everything that is there already goes into the same frame; and where the selected design will be solved in a
        // moment, there is no flash of an empty pane
        let deadline = Instant::now() + SETTLE;
        loop {
            if let Some(ending) = effects::perform(std::mem::take(&mut effects), worker, session)? {
                return Ok(ending);
            }
            let patience =
                if app.is_settling() { deadline.saturating_duration_since(Instant::now()) } else { Duration::ZERO };
            match receiver.recv_timeout(patience) {
                Ok(message) => effects = take_in(app, message),
                Err(RecvTimeoutError::Timeout | RecvTimeoutError::Disconnected) => break,
            }
        }
        session.draw(app)?;
        effects = app.after_frame();
    }
}
