//! Keys, read on a thread of their own: crossterm's `poll` does not return when the terminal goes away.

use std::io;
use std::sync::mpsc::Sender;
use std::thread;

use ratatui::crossterm::event::{Event, read};

use super::message::Message;

/// Starts the reader.
///
/// # Errors
///
/// The system's, if it allows no more threads.
pub fn start(sender: Sender<Message>) -> io::Result<()> {
    let work = move || {
        loop {
            let message = match read() {
                Ok(Event::Key(key)) => Message::Key(key),
                Ok(Event::Paste(text)) => Message::Paste(text),
                Ok(Event::Resize(..)) => Message::Resized,
                Ok(_) => continue,
                Err(_) => Message::TerminalGone,
            };
            let ends = matches!(message, Message::TerminalGone);
            if sender.send(message).is_err() || ends {
                return;
            }
        }
    };
    thread::Builder::new().name("keys".into()).spawn(work).map(drop)
}
