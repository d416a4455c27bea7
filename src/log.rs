//! The log of `--log FILE`: a line for each thing that happened, with the time.
//!
//! A facade and a backend of their own crates would serve one program with one sink and one level; this is that sink. Lines
//! go through a queue to a thread that writes them, so that neither a slow disk nor a full one nor a reader that has gone
//! holds up anyone: what does not fit the queue is counted and left out.

use std::fmt::Display;
use std::fs::{File, OpenOptions};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, SystemTime};

use crate::moment;
use crate::text::printable;

/// Lines that may wait to be written.
const QUEUE: usize = 1024;
/// How long the end of the program waits for the last lines.
const PATIENCE: Duration = Duration::from_millis(300);

static QUEUED: Mutex<Option<SyncSender<String>>> = Mutex::new(None);
static LOST: AtomicUsize = AtomicUsize::new(0);

/// Why there is no log.
#[derive(Debug, thiserror::Error)]
pub enum LogError {
    #[error("{}: the log cannot be opened: {source}", printable(&.path.display().to_string()))]
    Open { path: PathBuf, source: io::Error },
    #[error("{}: this is a terminal: the log would go through the picture", printable(&.path.display().to_string()))]
    Terminal { path: PathBuf },
}

/// The log is open until this is dropped.
#[derive(Debug)]
pub struct Log {
    written: Receiver<()>,
}

/// Opens the log; lines are added to those that the file has.
///
/// # Errors
///
/// [`LogError`].
pub fn open(path: &Path) -> Result<Log, LogError> {
    let failed = |source| LogError::Open { path: path.into(), source };
    let file = OpenOptions::new().append(true).create(true).open(path).map_err(failed)?;
    if file.is_terminal() {
        return Err(LogError::Terminal { path: path.into() });
    }
    let (sender, lines) = sync_channel(QUEUE);
    let (done, written) = sync_channel(1);
    let work = move || {
        keep(file, &lines);
        // whoever waits may have given up
        let _ = done.send(());
    };
    thread::Builder::new().name("log".into()).spawn(work).map_err(failed)?;
    *queue() = Some(sender);
    Ok(Log { written })
}

/// Writes what comes; where that fails, the next line may fare better.
fn keep(mut file: File, lines: &Receiver<String>) {
    for line in lines {
        drop(file.write_all(line.as_bytes()));
    }
    // nothing follows that could say so
    if let Some(text) = lost() {
        drop(file.write_all(text.as_bytes()));
    }
}

/// A line about those that did not fit, and are told of now.
fn lost() -> Option<String> {
    let lost = LOST.swap(0, Ordering::Relaxed);
    (lost > 0).then(|| format!("{}\n", line(&format!("{lost} lines are missing here"))))
}

/// Adds a line, if there is a log.
pub fn write(text: impl Display) {
    let mut queue = queue();
    let Some(sender) = queue.as_mut() else { return };
    let lost = LOST.swap(0, Ordering::Relaxed);
    let before =
        if lost > 0 { format!("{}\n", line(&format!("{lost} lines are missing here"))) } else { String::new() };
    if sender.try_send(format!("{before}{}\n", line(&text.to_string()))).is_err() {
        LOST.fetch_add(lost + 1, Ordering::Relaxed);
    }
}

/// Whether there is a log.
pub fn is_open() -> bool {
    queue().is_some()
}

fn line(text: &str) -> String {
    format!("{} {}", moment::readable(SystemTime::now()), printable(text))
}

fn queue() -> MutexGuard<'static, Option<SyncSender<String>>> {
    QUEUED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Waits a moment for the last lines, and no longer than that.
pub fn close(log: Option<&Log>) {
    *queue() = None;
    if let Some(log) = log {
        let _ = log.written.recv_timeout(PATIENCE);
    }
}

impl Drop for Log {
    fn drop(&mut self) {
        close(Some(self));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_lost_at_the_end_are_told() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("log");
        let (sender, lines) = sync_channel(1);
        sender.send("one\n".to_owned()).expect("a reader");
        drop(sender);
        LOST.store(3, Ordering::Relaxed);
        keep(File::create(&path).expect("a file"), &lines);
        let text = std::fs::read_to_string(&path).expect("a text");
        assert!(text.starts_with("one\n") && text.ends_with("3 lines are missing here\n"), "{text}");
        assert_eq!(LOST.load(Ordering::Relaxed), 0);
    }
}
