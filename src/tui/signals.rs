//! TERM, HUP and INT, TSTP and CONT, a limit on the size of files, and a terminal that goes away without a signal.

use std::io;
#[cfg(unix)]
use std::sync::Arc;
use std::sync::mpsc::Sender;
use std::thread;
use std::time::Duration;

use ratatui::crossterm::terminal::window_size;

use super::message::Message;
use super::terminal;

/// How long the explorer has for ending by itself.
const PATIENCE: Duration = Duration::from_secs(1);

/// Turns the signals that end, stop and continue a program into messages. If the program has not ended a second after it was
/// asked to, because it hangs in a write to a dead terminal, it is ended here.
///
/// # Errors
///
/// The system's, if the signals cannot be caught.
#[cfg(unix)]
pub fn watch(sender: Sender<Message>) -> io::Result<()> {
    use signal_hook::consts::{SIGCONT, SIGHUP, SIGINT, SIGTERM, SIGTSTP, SIGXFSZ};
    use signal_hook::iterator::Signals;

    // a limit on the size of files is then an error of writing, and not the end
    signal_hook::flag::register(SIGXFSZ, Arc::default())?;

    let mut signals = Signals::new([SIGTERM, SIGHUP, SIGINT, SIGTSTP, SIGCONT])?;
    let work = move || {
        for number in signals.forever() {
            let message = match number {
                SIGTSTP => Message::Suspend,
                // where the program has suspended itself, it comes back by itself
                SIGCONT if terminal::is_suspended() => continue,
                SIGCONT => Message::Continued,
                _ => Message::Signal(number),
            };
            let ends = matches!(message, Message::Signal(_));
            let told = sender.send(message).is_ok();
            if !ends {
                continue;
            }
            if told {
                thread::sleep(PATIENCE);
            }
            if !told || terminal::is_taken() {
                terminal::restore_in_passing();
                end_by(number);
            }
        }
    };
    thread::Builder::new().name("signals".into()).spawn(work).map(drop)
}

/// There are no such signals.
///
/// # Errors
///
/// None.
#[cfg(not(unix))]
pub fn watch(_sender: Sender<Message>) -> io::Result<()> {
    Ok(())
}

/// Ends the program as the signal would have done.
pub fn end_by(number: i32) {
    #[cfg(unix)]
    drop(signal_hook::low_level::emulate_default_handler(number));
    std::process::exit(128 + number);
}

/// The watchdog: notices that the terminal is gone. crossterm 0.29 does not, its reader spins instead
/// (crossterm-rs/crossterm#793).
///
/// # Errors
///
/// The system's, if it allows no more threads.
pub fn watch_terminal(sender: Sender<Message>) -> io::Result<()> {
    if window_size().is_err() {
        // it cannot be asked here: it would seem gone from the start
        return Ok(());
    }
    let work = move || {
        while window_size().is_ok() {
            thread::sleep(PATIENCE);
        }
        // a receiver that is gone means that the program ends anyway
        drop(sender.send(Message::TerminalGone));
    };
    thread::Builder::new().name("watchdog".into()).spawn(work).map(drop)
}
