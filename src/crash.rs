//! What is left behind when the program fails through a mistake of its own: a report for whoever mends it.

use std::backtrace::Backtrace;
use std::cell::Cell;
use std::collections::VecDeque;
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::panic::{self, PanicHookInfo};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::SystemTime;

use crate::text::printable;
use crate::{log, moment};

/// As many actions are remembered.
const ACTIONS: usize = 50;

/// What a report says beside the panic.
struct Known {
    /// Facts of the terminal, a line each
    terminal: String,
    /// The latest last
    actions: VecDeque<String>,
}

static KNOWN: Mutex<Known> = Mutex::new(Known { terminal: String::new(), actions: VecDeque::new() });

thread_local! {
    static CAUGHT: Cell<bool> = const { Cell::new(false) };
}

fn known() -> MutexGuard<'static, Known> {
    KNOWN.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Remembers what the user asked for. Names only: nothing of what was typed.
pub fn remember(mode: &str, action: &str) {
    let actions = &mut known().actions;
    if actions.len() == ACTIONS {
        actions.pop_front();
    }
    actions.push_back(format!("{mode}: {action}"));
}

/// Tells what the terminal is, for the report.
pub fn describe_terminal(facts: String) {
    known().terminal = facts;
}

/// Runs work whose panic is caught by the caller and ends nothing: it leaves a line in the log and no report.
pub fn caught<T>(work: impl FnOnce() -> T) -> T {
    /// Also where the work panics.
    struct Back(bool);
    impl Drop for Back {
        fn drop(&mut self) {
            CAUGHT.set(self.0);
        }
    }
    let _back = Back(CAUGHT.replace(true));
    work()
}

/// Whether a panic of this thread is [caught].
pub fn is_caught() -> bool {
    CAUGHT.get()
}

/// The folder of the reports: `bevelscope` in the user's folder for state.
pub fn folder() -> Option<PathBuf> {
    dirs::state_dir().or_else(dirs::data_local_dir).map(|folder| folder.join("bevelscope"))
}

/// From now on, a panic that ends the program leaves a report, and says where it is.
pub fn install() {
    panic::set_hook(Box::new(|info| {
        let message = message(info);
        let place = info.location().map_or_else(|| "an unknown place".to_owned(), ToString::to_string);
        let thread = thread::current().name().unwrap_or("without a name").to_owned();
        log::write(format_args!("panic of thread {thread} at {place}: {message}"));
        if is_caught() {
            return;
        }
        let report = report(&message, &place, &thread, &Backtrace::force_capture().to_string());
        let whereabouts = match save(folder().as_deref(), &report) {
            Ok(path) => {
                log::write(format_args!("crash report {}", path.display()));
                format!("Please send the report to its makers: {}", printable(&path.display().to_string()))
            }
            Err(error) => format!("The report cannot be saved ({error}), so here it is:\n\n{report}"),
        };
        let why = printable(&message);
        let text = format!("bevelscope ended because of a mistake in the program: {why}\n{whereabouts}\n");
        // nobody may be there to read it
        let _ = io::stderr().write_all(text.as_bytes());
    }));
}

fn message(info: &PanicHookInfo<'_>) -> String {
    let payload = info.payload();
    let text = payload.downcast_ref::<String>().map(String::as_str).or_else(|| payload.downcast_ref::<&str>().copied());
    text.unwrap_or("no message").to_owned()
}

fn report(message: &str, place: &str, thread: &str, backtrace: &str) -> String {
    let Known { terminal, actions } = &*known();
    let actions = actions.iter().map(String::as_str).collect::<Vec<_>>().join("\n");
    let of = |title: &str, text: &str| format!("\n{title}\n{}\n", if text.is_empty() { "none" } else { text });
    let text = format!(
        "bevelscope {} on {} {}\nat {}\nthread {thread} at {place}\n{message}\n{}{}{}",
        env!("CARGO_PKG_VERSION"),
        std::env::consts::OS,
        std::env::consts::ARCH,
        moment::readable(SystemTime::now()),
        of("Terminal", terminal),
        of("Last actions, the latest last", &actions),
        of("Backtrace", backtrace.trim_end()),
    );
    text.lines().fold(String::new(), |all, line| all + &printable(line) + "\n")
}

fn save(folder: Option<&Path>, report: &str) -> io::Result<PathBuf> {
    let folder = folder.ok_or_else(|| io::Error::other("this system names no folder for the user's state"))?;
    fs::create_dir_all(folder)?;
    let name = format!("crash-{}-{}.txt", moment::stamp(SystemTime::now()), std::process::id());
    let path = folder.join(name);
    let mut file = OpenOptions::new().write(true).create_new(true).open(&path)?;
    file.write_all(report.as_bytes())?;
    Ok(path)
}
