//! The program in a real pseudo-terminal: however it ends, the edits are there when it is started again.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::io::{Read, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use bevelscope::comparison::{Comparison, Observer, SolveError};
use bevelscope::design::Design;
use bevelscope::design::library::{Found, Journals, journals};
use bevelscope::tui::recovery::Kept;
use bevelscope::tui::worker::Worker;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign};
use portable_pty::{Child, CommandBuilder, MasterPty, PtySize, native_pty_system};

const LONG: Duration = Duration::from_secs(20);
/// The shipped design and the line that the tests edit.
const BEFORE: &str = "length_mm = 36.0";
const AFTER: &str = "length_mm = 36.5";

/// A library with one design, and a state folder of its own.
struct Place {
    folder: tempfile::TempDir,
    design: PathBuf,
}

impl Place {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let designs = folder.path().join("designs");
        std::fs::create_dir(&designs).unwrap();
        let design = designs.join("a.toml");
        std::fs::copy(concat!(env!("CARGO_MANIFEST_DIR"), "/designs/overhung-elastic.toml"), &design).unwrap();
        Self { folder, design }
    }

    fn state(&self) -> PathBuf {
        self.folder.path().join("state")
    }

    fn recovery(&self) -> PathBuf {
        self.state().join("bevelscope/recovery")
    }

    fn journals(&self) -> Vec<Found> {
        journals(&self.recovery())
    }

    fn text(&self) -> String {
        std::fs::read_to_string(&self.design).unwrap()
    }

    /// The program on the library, by a shell that says something first.
    fn start(&self, first: &str) -> Terminal {
        let mut command = CommandBuilder::new("/bin/sh");
        command.args(["-c", &format!("{first}exec \"$0\" \"$1\""), env!("CARGO_BIN_EXE_bevelscope")]);
        command.arg(self.design.parent().unwrap());
        command.env_clear();
        let variables =
            [("TERM", "xterm-256color".into()), ("LANG", "C.UTF-8".into()), ("XDG_STATE_HOME", self.state())];
        for (name, value) in variables {
            command.env(name, value.as_os_str() as &std::ffi::OsStr);
        }
        Terminal::run(command)
    }

    /// The program with one edit of a cell, which is in the journal.
    fn edited(&self, first: &str) -> Terminal {
        let mut terminal = self.start(first);
        terminal.wait_for("trust up to 2,997 Hz");
        terminal.press("e");
        terminal.wait_for("pinion segments");
        terminal.press("c36.5\r");
        terminal.wait_for("u: length of");
        let deadline = Instant::now() + LONG;
        while self.journals().is_empty() {
            assert!(Instant::now() < deadline, "no journal");
            thread::sleep(Duration::from_millis(20));
        }
        assert!(self.journals()[0].is_alive);
        terminal
    }

    /// After the end of an edited one: the edits are offered, taken and saved.
    fn recover(&self) {
        let found = self.journals();
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(!found[0].is_alive);
        assert!(found[0].journal.as_ref().unwrap().text.contains(AFTER));
        assert!(self.text().contains(BEFORE));
        let mut terminal = self.start("");
        terminal.wait_for("Unsaved edits of an earlier run");
        terminal.wait_for("36.0 → 36.5 mm");
        terminal.press("t");
        terminal.wait_for("u: recovered edits");
        terminal.press("s");
        terminal.wait_for("saved a.toml");
        assert_eq!(self.text().matches(AFTER).count(), 1);
        terminal.press("\x03");
        terminal.wait_end(LONG);
        assert!(self.journals().is_empty());
    }
}

struct Terminal {
    child: Box<dyn Child + Send + Sync>,
    master: Option<Box<dyn MasterPty + Send>>,
    writer: Option<Box<dyn Write + Send>>,
    screen: Arc<Mutex<vt100::Parser>>,
    /// Tells the reading thread to let go.
    closing: Arc<AtomicBool>,
    reading: thread::JoinHandle<()>,
}

impl Terminal {
    fn run(command: CommandBuilder) -> Self {
        let size = PtySize { rows: 24, cols: 80, pixel_width: 0, pixel_height: 0 };
        let pair = native_pty_system().openpty(size).unwrap();
        let child = pair.slave.spawn_command(command).unwrap();
        drop(pair.slave);
        let mut reader = pair.master.try_clone_reader().unwrap();
        let writer = pair.master.take_writer().unwrap();
        let screen = Arc::new(Mutex::new(vt100::Parser::new(24, 80, 0)));
        let closing = Arc::new(AtomicBool::new(false));
        let (shown, ends) = (Arc::clone(&screen), Arc::clone(&closing));
        let reading = thread::spawn(move || {
            let mut piece = [0; 4096];
            while let Ok(length @ 1..) = reader.read(&mut piece) {
                shown.lock().unwrap().process(&piece[..length]);
                if ends.load(Ordering::SeqCst) {
                    return;
                }
            }
        });
        Self { child, master: Some(pair.master), writer: Some(writer), screen, closing, reading }
    }

    fn contents(&self) -> String {
        self.screen.lock().unwrap().screen().contents()
    }

    fn wait_for(&self, text: &str) {
        let deadline = Instant::now() + LONG;
        while !self.contents().contains(text) {
            assert!(Instant::now() < deadline, "no {text}:\n{}", self.contents());
            thread::sleep(Duration::from_millis(10));
        }
    }

    fn press(&mut self, keys: &str) {
        let writer = self.writer.as_mut().unwrap();
        writer.write_all(keys.as_bytes()).unwrap();
        writer.flush().unwrap();
    }

    fn signal(&self, name: &str) {
        let process = self.child.process_id().unwrap().to_string();
        assert!(Command::new("kill").args(["-s", name, &process]).status().unwrap().success());
    }

    fn wait_end(&mut self, limit: Duration) {
        let deadline = Instant::now() + limit;
        while self.child.try_wait().unwrap().is_none() {
            if Instant::now() >= deadline {
                self.child.kill().unwrap();
                panic!("still running:\n{}", self.contents());
            }
            thread::sleep(Duration::from_millis(20));
        }
    }

    /// The terminal goes away under the program.
    fn close(&mut self) {
        self.closing.store(true, Ordering::SeqCst);
        // the reading thread holds the terminal open too: it lets go after the next frame
        self.press("k");
        let deadline = Instant::now() + LONG;
        while !self.reading.is_finished() {
            assert!(Instant::now() < deadline);
            thread::sleep(Duration::from_millis(10));
        }
        self.writer = None;
        self.master = None;
    }
}

/// Twice what the program has for it.
const END: Duration = Duration::from_secs(4);

#[test]
fn edits_survive_the_signals_that_end_a_program() {
    for signal in ["HUP", "TERM", "INT", "KILL"] {
        let place = Place::new();
        let mut terminal = place.edited("");
        terminal.signal(signal);
        terminal.wait_end(END);
        place.recover();
    }
}

#[test]
fn edits_survive_a_lost_connection() {
    for first in ["", "trap '' HUP; "] {
        let place = Place::new();
        let mut terminal = place.edited(first);
        terminal.close();
        terminal.wait_end(END);
        place.recover();
    }
}

/// An edit and the end of the program at once: what is still to be written gets its moment.
#[test]
fn the_last_edit_is_written_though_the_end_follows_at_once() {
    let place = Place::new();
    let mut terminal = place.start("");
    terminal.wait_for("trust up to 2,997 Hz");
    terminal.press("e");
    terminal.wait_for("pinion segments");
    terminal.press("c36.5\r");
    terminal.wait_for("u: length of");
    terminal.signal("TERM");
    terminal.wait_end(END);
    place.recover();
}

#[test]
fn later_is_offered_again_and_discarded_is_not() {
    let place = Place::new();
    let mut terminal = place.edited("");
    terminal.signal("KILL");
    terminal.wait_end(END);
    for answer in ["\x1b", "d"] {
        let mut terminal = place.start("");
        terminal.wait_for("Unsaved edits of an earlier run");
        terminal.press(answer);
        let said = if answer == "d" { "put aside the edits of a" } else { "kept for later" };
        terminal.wait_for(said);
        terminal.press("q");
        terminal.wait_end(LONG);
    }
    assert!(place.journals().is_empty());
    assert_eq!(std::fs::read_dir(place.recovery().join("discarded")).unwrap().count(), 1);
    assert!(place.text().contains(BEFORE));
}

#[test]
fn a_living_one_is_not_offered_but_named() {
    let place = Place::new();
    let mut first = place.edited("");
    let mut second = place.start("");
    second.wait_for("trust up to 2,997 Hz");
    second.press("e");
    if cfg!(target_os = "linux") {
        second.wait_for(&format!("process {} of", first.child.process_id().unwrap()));
    }
    second.wait_for("has this design open as well");
    assert!(!second.contents().contains("Unsaved edits"));
    // the first one saves; the second has another idea of the file
    first.press("s");
    first.wait_for("saved a.toml");
    second.press("c37\r");
    second.wait_for("changed on disk");
    second.press("s");
    second.wait_for("keep mine");
    second.wait_for("36.0 → 36.5 mm");
    second.press("t");
    second.wait_for("took the file's version of a");
    assert!(place.text().contains(AFTER));
    for terminal in [&mut first, &mut second] {
        terminal.press("\x03");
        terminal.wait_end(LONG);
    }
    assert!(place.journals().is_empty());
}

/// A limit on the size of files stops everybody, as a full disk does: nothing can be kept or saved, and all goes on.
#[test]
fn a_full_disk_is_said_and_nothing_is_lost() {
    let place = Place::new();
    let mut terminal = place.start("ulimit -f 1; ");
    terminal.wait_for("trust up to 2,997 Hz");
    terminal.press("e");
    terminal.wait_for("pinion segments");
    terminal.press("c36.5\r");
    terminal.wait_for("unsaved edits are not protected");
    terminal.press("s");
    terminal.wait_for("not saved: ");
    terminal.wait_for("a *");
    assert!(place.text().contains(BEFORE));
    let left = std::fs::read_dir(place.design.parent().unwrap()).unwrap().count();
    assert_eq!((left, std::fs::read_dir(place.recovery()).unwrap().count()), (1, 0));
    terminal.press("u");
    terminal.wait_for("undo: length of");
    terminal.press("\x03");
    terminal.wait_end(LONG);
}

/// Ways in which the folder of journals cannot be written, also for the superuser, whom permissions do not stop.
const NO_FOLDER: [fn(&Place); 5] = [
    |place| std::fs::write(place.state(), "").unwrap(),
    |place| {
        std::fs::create_dir(place.state()).unwrap();
        std::fs::write(place.state().join("bevelscope"), "").unwrap();
    },
    |place| {
        std::fs::create_dir_all(place.state().join("bevelscope")).unwrap();
        std::fs::write(place.recovery(), "").unwrap();
    },
    // what takes nothing, and what is nowhere
    |place| {
        std::fs::create_dir_all(place.state().join("bevelscope")).unwrap();
        std::os::unix::fs::symlink("/dev/full", place.recovery()).unwrap();
    },
    |place| {
        std::fs::create_dir_all(place.state().join("bevelscope")).unwrap();
        std::os::unix::fs::symlink("/dev/full/recovery", place.recovery()).unwrap();
    },
];

#[test]
fn a_folder_that_cannot_be_written_is_said_and_nothing_is_lost() {
    for spoil in NO_FOLDER {
        let place = Place::new();
        spoil(&place);
        let mut terminal = place.start("");
        terminal.wait_for("trust up to 2,997 Hz");
        terminal.press("e");
        terminal.wait_for("pinion segments");
        terminal.press("c36.5\r");
        terminal.wait_for("unsaved edits are not protected");
        terminal.press("s");
        terminal.wait_for("saved a.toml");
        assert!(place.text().contains(AFTER));
        terminal.press("\x03");
        terminal.wait_end(LONG);
    }
}

const CHILD: &str = "BEVELSCOPE_TEST_PANICS";

/// Keeps edits as the explorer does.
struct Keeps(Mutex<Journals>);

impl Backend for Keeps {
    fn load(&self, _: &Path) -> Result<LoadedDesign, BrokenDesign> {
        Err(BrokenDesign { one_line: String::new(), full_text: String::new() })
    }

    fn compare(&self, _: &Design, _: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        Err(SolveError::Cancelled)
    }

    fn keep(&self, change: &Kept) -> Result<(), String> {
        let Kept::Edits { path, base, text } = change else { return Ok(()) };
        // as slow as a disk may be
        thread::sleep(Duration::from_millis(100));
        self.0.lock().unwrap().keep(path, base, text).map_err(|error| error.to_string())
    }
}

#[test]
#[ignore = "started by another test"]
fn child_panics() {
    let Ok(folder) = std::env::var(CHILD) else { return };
    let folder = PathBuf::from(folder);
    let panics = move || {
        let backend = Keeps(Mutex::new(Journals::new(folder.join("recovery"))));
        let worker = Worker::start(Arc::new(backend), &std::sync::mpsc::channel().0).unwrap();
        worker.keep(Kept::Edits { path: folder.join("a.toml"), base: "old".into(), text: "mine".into() });
        panic!("on purpose");
    };
    let _ = std::panic::catch_unwind(panics);
    // at once: nothing else is waited for
    std::process::exit(1);
}

#[test]
fn edits_survive_a_panic() {
    let folder = tempfile::tempdir().unwrap();
    let mut command = Command::new(std::env::current_exe().unwrap());
    command
        .args(["--exact", "child_panics", "--ignored", "--test-threads=1"])
        .env(CHILD, folder.path())
        .env("RUST_BACKTRACE", "0");
    let status = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null()).status().unwrap();
    assert!(!status.success());
    let found = journals(&folder.path().join("recovery"));
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].journal.as_ref().unwrap().text, "mine");
    assert!(!found[0].is_alive);
}
