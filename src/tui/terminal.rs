//! The terminal: taken over, drawn to, and always given back.
//!
//! It is given back when [`Session`] is dropped, before a panic prints its message, and before the program is suspended
//! or ended by a signal.

use std::io::{self, Stdout, Write};
use std::mem::ManuallyDrop;
use std::panic;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Once, mpsc};
use std::thread::{self, ThreadId};
use std::time::Duration;

use ratatui::Terminal;
use ratatui::crossterm::cursor::{Hide, Show};
use ratatui::crossterm::event::{DisableBracketedPaste, EnableBracketedPaste};
use ratatui::crossterm::execute;
use ratatui::crossterm::style::{Attribute, SetAttribute};
use ratatui::crossterm::terminal::{
    EndSynchronizedUpdate, EnterAlternateScreen, LeaveAlternateScreen, disable_raw_mode, enable_raw_mode, size,
};

use super::app::App;
use super::painter::Painter;
use super::view;
use crate::{crash, log};

/// Whether the terminal is ours at the moment.
static TAKEN: AtomicBool = AtomicBool::new(false);
/// Whether the program has suspended itself.
static SUSPENDED: AtomicBool = AtomicBool::new(false);

/// A terminal that is ours until this is dropped.
pub struct Session {
    /// Never dropped: ratatui would show the cursor once more, and where the terminal is gone panic over it.
    terminal: ManuallyDrop<Terminal<Painter<Stdout>>>,
}

impl std::fmt::Debug for Session {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        formatter.write_str("Session")
    }
}

impl Session {
    /// Takes over the terminal.
    ///
    /// # Errors
    ///
    /// The system's; the terminal is as it was.
    pub fn enter() -> io::Result<Self> {
        restore_before_panic(thread::current().id());
        let backend = Painter::new(io::stdout(), size);
        let session = Self { terminal: ManuallyDrop::new(Terminal::new(backend)?) };
        take()?;
        Ok(session)
    }

    /// Draws one frame; the terminal shows it whole or not at all.
    ///
    /// # Errors
    ///
    /// The terminal cannot be written to.
    pub fn draw(&mut self, app: &mut App) -> io::Result<()> {
        self.terminal.draw(|frame| view::draw(app, frame)).map(drop)
    }

    /// Writes a sequence that draws nothing, between two frames.
    ///
    /// # Errors
    ///
    /// The terminal cannot be written to.
    pub fn send(&mut self, sequence: &[u8]) -> io::Result<()> {
        let out = self.terminal.backend_mut().writer_mut();
        out.write_all(sequence)?;
        out.flush()
    }

    /// Forgets what the terminal shows: the next frame is drawn whole.
    ///
    /// # Errors
    ///
    /// The terminal cannot be written to.
    pub fn clear(&mut self) -> io::Result<()> {
        self.terminal.backend_mut().forget();
        let size = self.terminal.size()?;
        self.terminal.resize(size.into())
    }

    /// Gives the terminal back to the shell until the program is continued.
    ///
    /// # Errors
    ///
    /// The terminal cannot be taken over again.
    pub fn suspend(&mut self) -> io::Result<()> {
        #[cfg(unix)]
        {
            restore();
            log::write("suspended");
            SUSPENDED.store(true, Ordering::SeqCst);
            let stopped = signal_hook::low_level::emulate_default_handler(signal_hook::consts::SIGTSTP);
            log::write("continued");
            let taken = take().and_then(|()| self.clear());
            // the signal that continued the program may come later than this, and does no more than draw once again
            SUSPENDED.store(false, Ordering::SeqCst);
            stopped.and(taken)
        }
        #[cfg(not(unix))]
        Ok(())
    }

    /// Takes the terminal over once more after the program was stopped with the terminal in its hands: whoever had it
    /// meanwhile has left it in another state.
    ///
    /// # Errors
    ///
    /// The terminal cannot be taken over again.
    pub fn take_again(&mut self) -> io::Result<()> {
        // crossterm believes that it is still raw
        disable_raw_mode()?;
        enable_raw_mode()?;
        // the cursor that was saved when the terminal was taken over is the one to go back to: it is not saved again
        self.send(b"\x1b[?1047h")?;
        execute!(io::stdout(), Hide, EnableBracketedPaste)?;
        self.clear()
    }
}

impl Drop for Session {
    fn drop(&mut self) {
        restore();
    }
}

fn take() -> io::Result<()> {
    enable_raw_mode()?;
    TAKEN.store(true, Ordering::SeqCst);
    // bracketed paste: text from the clipboard must not act as keys
    execute!(io::stdout(), EnterAlternateScreen, Hide, EnableBracketedPaste).inspect_err(|_| restore())
}

/// The exit status of a Rust program that panicked.
const PANICKED: i32 = 101;

/// Gives the terminal back, once. Errors are of no use here: the terminal may be what is gone.
pub fn restore() {
    if TAKEN.swap(false, Ordering::SeqCst) {
        leave();
        drop(disable_raw_mode());
    }
}

/// As [`restore`], where the thread that draws may hang in a write: the echo comes back at once, and what has to be
/// written gets a moment, no more.
pub fn restore_in_passing() {
    const MOMENT: Duration = Duration::from_millis(200);
    if TAKEN.swap(false, Ordering::SeqCst) {
        drop(disable_raw_mode());
        let (sender, receiver) = mpsc::channel();
        let work = move || {
            leave();
            let _ = sender.send(());
        };
        if thread::Builder::new().spawn(work).is_ok() {
            let _ = receiver.recv_timeout(MOMENT);
        }
    }
}

fn leave() {
    drop(execute!(
        io::stdout(),
        EndSynchronizedUpdate,
        SetAttribute(Attribute::Reset),
        DisableBracketedPaste,
        Show,
        LeaveAlternateScreen
    ));
    drop(io::stdout().flush());
}

/// Whether the terminal is taken over.
pub fn is_taken() -> bool {
    TAKEN.load(Ordering::SeqCst)
}

/// Whether the program has suspended itself, and has not yet taken the terminal over again.
pub fn is_suspended() -> bool {
    SUSPENDED.load(Ordering::SeqCst)
}

/// A panic that ends the program gives the terminal back before its message is printed, and ends it wherever it happens: an
/// explorer without its keys would be of no use. One that is caught says nothing, which would go through the picture.
fn restore_before_panic(drawing: ThreadId) {
    static INSTALLED: Once = Once::new();
    INSTALLED.call_once(|| {
        let previous = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            if crash::is_caught() {
                return previous(info);
            }
            let draws = thread::current().id() == drawing;
            let taken = is_taken();
            // the thread that draws may hang, or be in the middle of a frame
            if draws {
                restore();
            } else {
                restore_in_passing();
            }
            previous(info);
            if taken && !draws {
                std::process::exit(PANICKED);
            }
        }));
    });
}
