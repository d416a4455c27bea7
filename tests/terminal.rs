//! The explorer in a real pseudo-terminal: however it ends, the terminal is as it was.
//!
//! The program under test is this test binary itself, started again with one of the `child_` tests, so that the
//! explorer runs on made-up designs and can be made to panic.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use std::io::{Read, Write};
use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use bevelscope::comparison::{Comparison, Observer, SolveError};
use bevelscope::design::Design;
use bevelscope::tui::terminal::Session;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign, Options, TuiError, run};
use portable_pty::{Child, CommandBuilder, ExitStatus, MasterPty, PtySize, native_pty_system};
use tui_support::{MadeUp, STEMS, paths};

const CHILD: &str = "BEVELSCOPE_TEST_CHILD";
/// Nobody's unsaved edits are offered to the program.
const STATE: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/terminal-state");
const LONG: Duration = Duration::from_secs(20);

fn is_child() -> bool {
    std::env::var_os(CHILD).is_some()
}

fn explore(backend: impl Backend + 'static) -> ! {
    let result = run(paths(&STEMS), "~/designs".into(), Options::default(), Arc::new(backend));
    let status = match result {
        Ok(()) => 0,
        Err(error) => {
            // where the terminal is gone, there is nobody to tell
            let _ = writeln!(std::io::stderr(), "{error}");
            error.exit_status()
        }
    };
    std::process::exit(status.into())
}

#[test]
#[ignore = "started by other tests in a terminal"]
fn child_explorer() {
    if is_child() {
        explore(MadeUp);
    }
}

/// A backend that never comes back.
struct Stuck;

impl Backend for Stuck {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        MadeUp.load(path)
    }

    fn compare(&self, _: &Design, _: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        loop {
            thread::sleep(LONG);
        }
    }
}

#[test]
#[ignore = "started by other tests in a terminal"]
fn child_stuck() {
    if is_child() {
        explore(Stuck);
    }
}

#[test]
#[ignore = "started by other tests in a terminal"]
fn child_panics() {
    if is_child() {
        let _session = Session::enter().unwrap();
        panic!("on purpose");
    }
}

/// A child in a pseudo-terminal, and what it has written.
struct Terminal {
    child: Box<dyn Child + Send + Sync>,
    master: Option<Box<dyn MasterPty + Send>>,
    writer: Option<Box<dyn Write + Send>>,
    output: Arc<Mutex<Vec<u8>>>,
    /// Tells the reading thread to let go.
    closing: Arc<AtomicBool>,
    /// Hears of every piece of output.
    wrote: Receiver<()>,
}

impl Terminal {
    /// This binary again, as one of the `child_` tests.
    fn start(test: &str, environment: &[(&str, &str)]) -> Self {
        let mut command = CommandBuilder::new(std::env::current_exe().unwrap());
        command.args(["--exact", test, "--ignored", "--nocapture", "--test-threads=1"]);
        Self::run(command, environment)
    }

    /// The program itself.
    fn program(arguments: &[&str], environment: &[(&str, &str)]) -> Self {
        let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_bevelscope"));
        command.args(arguments);
        Self::run(command, environment)
    }

    fn run(mut command: CommandBuilder, environment: &[(&str, &str)]) -> Self {
        let size = PtySize { rows: 24, cols: 80, pixel_width: 0, pixel_height: 0 };
        let pair = native_pty_system().openpty(size).unwrap();
        command.env_clear();
        for (name, value) in [(CHILD, "1"), ("TERM", "xterm-256color"), ("LANG", "C.UTF-8"), ("XDG_STATE_HOME", STATE)]
            .iter()
            .chain(environment)
        {
            command.env(name, value);
        }
        let child = pair.slave.spawn_command(command).unwrap();
        drop(pair.slave);
        let mut reader = pair.master.try_clone_reader().unwrap();
        let writer = pair.master.take_writer().unwrap();
        let output = Arc::new(Mutex::new(Vec::new()));
        let (tell, wrote) = channel();
        let closing = Arc::new(AtomicBool::new(false));
        let (kept, ends) = (Arc::clone(&output), Arc::clone(&closing));
        thread::spawn(move || {
            let mut piece = [0; 4096];
            while let Ok(length @ 1..) = reader.read(&mut piece) {
                kept.lock().unwrap().extend_from_slice(&piece[..length]);
                if tell.send(()).is_err() || ends.load(Ordering::SeqCst) {
                    return;
                }
            }
        });
        Self { child, master: Some(pair.master), writer: Some(writer), output, closing, wrote }
    }

    fn output(&self) -> Vec<u8> {
        self.output.lock().unwrap().clone()
    }

    fn screen(&self) -> vt100::Parser {
        let mut parser = vt100::Parser::new(24, 80, 0);
        parser.process(&self.output());
        parser
    }

    fn wait_for(&self, what: &str, found: impl Fn(&vt100::Screen) -> bool) {
        let deadline = Instant::now() + LONG;
        while !found(self.screen().screen()) {
            assert!(Instant::now() < deadline, "no {what}:\n{}", self.screen().screen().contents());
            let _ = self.wrote.recv_timeout(Duration::from_millis(50));
        }
    }

    fn wait_for_text(&self, text: &str) {
        self.wait_for(text, |screen| screen.contents().contains(text));
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

    fn wait(&mut self, limit: Duration) -> ExitStatus {
        let deadline = Instant::now() + limit;
        loop {
            if let Some(status) = self.child.try_wait().unwrap() {
                return status;
            }
            if Instant::now() >= deadline {
                self.child.kill().unwrap();
                panic!("still running:\n{}", self.screen().screen().contents());
            }
            thread::sleep(Duration::from_millis(20));
        }
    }

    /// Waits for what was written last, and looks whether the terminal is as it was.
    fn assert_restored(&self) {
        loop {
            match self.wrote.recv_timeout(LONG) {
                Ok(()) => {}
                Err(RecvTimeoutError::Disconnected) => break,
                Err(RecvTimeoutError::Timeout) => panic!("the terminal is still open"),
            }
        }
        let output = String::from_utf8_lossy(&self.output()).into_owned();
        let parser = self.screen();
        assert!(!parser.screen().alternate_screen(), "{output:?}");
        assert!(!parser.screen().hide_cursor(), "{output:?}");
        assert!(!parser.screen().bracketed_paste(), "{output:?}");
        assert!(output.matches("\x1b[?2026h").count() <= output.matches("\x1b[?2026l").count(), "{output:?}");
        let mode = self.master.as_ref().and_then(|master| master.get_termios());
        let local = mode.map(|mode| format!("{:?}", mode.local_flags)).unwrap_or_default();
        assert!(local.contains("ECHO") && local.contains("ICANON"), "{local}");
    }
}

const FRAME: &str = "trust up to 2,997 Hz";

/// The figures are those of the shipped designs, as `tests/cases.rs` has them.
#[test]
fn the_program_shows_the_shipped_designs() {
    let mut terminal = Terminal::program(&[concat!(env!("CARGO_MANIFEST_DIR"), "/designs")], &[]);
    terminal.wait_for_text("enhanced: trust up to 2,997 Hz,  3.72 dB RMS");
    terminal.press("G");
    terminal.wait_for_text("enhanced: trust up to 3,364 Hz,  2.79 dB RMS");
    terminal.press("?");
    // all of its frame, or the Esc and the q after it come as one key
    terminal.wait_for("the help", |screen| {
        screen.contents().contains("Moving") && !screen.contents().contains("Side view")
    });
    terminal.press("\x1b");
    terminal.wait_for("the help to close", |screen| screen.contents().contains("Side view"));
    terminal.press("q");
    assert!(terminal.wait(LONG).success());
    terminal.assert_restored();
}

/// On first use the library is in the user's data folder, filled with the shipped designs.
#[test]
fn the_first_use_has_a_library() {
    let home = tempfile::tempdir().unwrap();
    let data = home.path().join("data").display().to_string();
    let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_bevelscope"));
    command.cwd(home.path());
    let mut terminal = Terminal::run(command, &[("XDG_DATA_HOME", &data), ("HOME", &data)]);
    terminal.wait_for_text("straddle-elastic");
    terminal.wait_for_text(FRAME);
    terminal.press("q");
    assert!(terminal.wait(LONG).success());
    assert!(home.path().join("data/bevelscope/designs/overhung-rigid.toml").is_file());
}

#[test]
fn a_folder_without_designs_explains_itself() {
    let folder = tempfile::tempdir().unwrap();
    let mut terminal = Terminal::program(&[folder.path().to_str().unwrap()], &[]);
    terminal.wait_for_text(".toml");
    terminal.press("q");
    assert!(terminal.wait(LONG).success());
    terminal.assert_restored();
}

#[test]
fn quitting_restores_the_terminal() {
    for keys in ["q", "\x03", "jjjj?\x03"] {
        let mut terminal = Terminal::start("child_explorer", &[]);
        terminal.wait_for_text(FRAME);
        assert!(terminal.screen().screen().alternate_screen());
        terminal.press(keys);
        assert!(terminal.wait(LONG).success(), "{keys:?}");
        terminal.assert_restored();
    }
}

#[test]
fn signals_restore_the_terminal_and_end_the_program_in_time() {
    for (signal, number) in [("TERM", 15), ("HUP", 1), ("INT", 2)] {
        for child in ["child_explorer", "child_stuck"] {
            let mut terminal = Terminal::start(child, &[]);
            terminal.wait_for_text(if child == "child_stuck" { "Solving" } else { FRAME });
            terminal.signal(signal);
            let status = terminal.wait(Duration::from_secs(2));
            assert_eq!(status.exit_code(), 128 + number, "{signal} {child}");
            terminal.assert_restored();
        }
    }
}

/// The program hangs in a write that nobody reads; the shell still gets the terminal back.
#[test]
fn a_signal_ends_the_program_though_nobody_reads() {
    let mut terminal = Terminal::program(&[concat!(env!("CARGO_MANIFEST_DIR"), "/designs")], &[]);
    terminal.wait_for_text(FRAME);
    terminal.closing.store(true, Ordering::SeqCst);
    // far more redraws than a pseudo-terminal keeps
    for _ in 0..50 {
        terminal.press("\x0c");
        thread::sleep(Duration::from_millis(20));
    }
    terminal.signal("TERM");
    let status = terminal.wait(Duration::from_secs(4));
    assert!(!status.success(), "{status:?}");
}

#[test]
fn the_whole_screen_can_be_drawn_again() {
    let mut terminal = Terminal::start("child_explorer", &[]);
    terminal.wait_for_text(FRAME);
    let before = terminal.output().len();
    terminal.press("\x0c");
    terminal.wait_for("another frame", |_| terminal.output().len() > before + 2000);
    // the terminal is asked nothing: its answer would be read as keys
    assert!(!String::from_utf8_lossy(&terminal.output()).contains("\x1b[6n"));
    terminal.press("j");
    terminal.wait_for_text("trust up to 3,364 Hz");
    terminal.press("q");
    assert!(terminal.wait(LONG).success());
}

#[test]
fn arguments_do_not_steer_the_terminal() {
    let mut terminal = Terminal::program(&["solve", "a.toml", "x\x1b[31mRED"], &[]);
    assert_eq!(terminal.wait(LONG).exit_code(), 2);
    terminal.wait_for_text("RED");
    let output = String::from_utf8_lossy(&terminal.output()).into_owned();
    assert!(!output.contains("\x1b[31m"), "{output:?}");
}

#[test]
fn a_panic_restores_the_terminal_before_its_message() {
    let mut terminal = Terminal::start("child_panics", &[]);
    assert!(!terminal.wait(LONG).success());
    terminal.assert_restored();
    let output = String::from_utf8_lossy(&terminal.output()).into_owned();
    let left = output.find("\x1b[?1049l").unwrap();
    assert!(output.find("on purpose").unwrap() > left, "{output:?}");
}

#[test]
fn the_program_ends_when_the_terminal_goes_away() {
    let mut terminal = Terminal::start("child_explorer", &[]);
    terminal.wait_for_text(FRAME);
    // the reading thread holds the terminal open too: it lets go after the next frame
    terminal.closing.store(true, Ordering::SeqCst);
    terminal.press("j");
    while terminal.wrote.recv_timeout(LONG).is_ok() {}
    terminal.writer = None;
    terminal.master = None;
    let status = terminal.wait(Duration::from_secs(2));
    // whichever is noticed first: the signal, or that nothing can be read or written any more
    assert!([128 + 1, 1].contains(&status.exit_code()), "{status:?}");
}

/// Files of a real folder, with keys of the user's own.
#[test]
fn files_are_renamed_copied_deleted_and_brought_back() {
    let folder = tempfile::tempdir().unwrap();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("designs/overhung-elastic.toml");
    let designs = folder.path().join("designs");
    std::fs::create_dir(&designs).unwrap();
    std::fs::copy(&shipped, designs.join("first.toml")).unwrap();
    let keys = folder.path().join("keys.toml");
    std::fs::write(&keys, "[library]\n\"ctrl-y\" = \"duplicate\"\nx = \"nothing\"\n").unwrap();
    let files = || {
        let entries = std::fs::read_dir(&designs).unwrap();
        let mut names: Vec<String> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.retain(|name| !name.starts_with('.'));
        names.sort();
        names
    };
    let (keys, shown) = (keys.display().to_string(), designs.display().to_string());
    let mut terminal = Terminal::program(&["--keys", &keys, &shown], &[]);
    terminal.wait_for_text("line 3: there is no action `nothing`");
    terminal.wait_for_text(FRAME);
    terminal.press("r\x15second\r");
    terminal.wait_for_text("renamed first to second");
    assert_eq!(files(), ["second.toml"]);
    terminal.press("\x19\r");
    terminal.wait_for_text("Designs 1 of 2");
    assert_eq!(files(), ["second-2.toml", "second.toml"]);
    terminal.press("Dy");
    terminal.wait_for_text("deleted second-2");
    assert_eq!(files(), ["second.toml"]);
    terminal.press("u");
    terminal.wait_for_text("second-2 is back");
    let copy = std::fs::read(designs.join("second-2.toml")).unwrap();
    assert_eq!(copy, std::fs::read(&shipped).unwrap());
    // something else has taken the name meanwhile: nothing is lost
    terminal.press("Dy");
    terminal.wait_for_text("deleted second-2");
    std::fs::write(designs.join("second-2.toml"), "another").unwrap();
    terminal.press("u");
    terminal.wait_for_text("there is a file of that name");
    assert_eq!(std::fs::read_to_string(designs.join("second-2.toml")).unwrap(), "another");
    terminal.press("\x03");
    assert!(terminal.wait(LONG).success());
}

#[test]
fn keys_reach_the_explorer_and_an_idle_one_writes_nothing() {
    let mut terminal = Terminal::start("child_explorer", &[]);
    terminal.wait_for_text(FRAME);
    terminal.press("j");
    terminal.wait_for_text("trust up to 3,364 Hz");
    terminal.press("\x1b[B\x1b[B");
    terminal.wait_for_text("This design cannot be read");
    terminal.press("/");
    terminal.press("\x1b[200~straddle\x1b[201~");
    terminal.wait_for_text("1 of 1 matches");
    // until all rows are filled in
    thread::sleep(Duration::from_millis(500));
    let before = terminal.output().len();
    thread::sleep(Duration::from_millis(2500));
    assert_eq!(terminal.output().len(), before);
    // on its own, or the terminal's reader takes Esc and the next key for one
    terminal.press("\x1b");
    terminal.wait_for_text("Designs 3 of 6");
    // each frame is one synchronized update; the end of the last one may still be on its way
    terminal.wait_for("the end of the frame", |_| {
        let output = String::from_utf8_lossy(&terminal.output()).into_owned();
        output.matches("\x1b[?2026h").count() == output.matches("\x1b[?2026l").count()
    });
    let output = String::from_utf8_lossy(&terminal.output()).into_owned();
    // the terminal's own selection works: the mouse is never asked for
    for mouse in ["\x1b[?1000h", "\x1b[?1002h", "\x1b[?1003h", "\x1b[?1006h"] {
        assert!(!output.contains(mouse));
    }
    terminal.press("\x03");
    assert!(terminal.wait(LONG).success());
}

#[test]
fn the_selected_row_stays_marked_without_colour() {
    let mut terminal = Terminal::start("child_explorer", &[("NO_COLOR", "1")]);
    terminal.wait_for_text(FRAME);
    let parser = terminal.screen();
    let row = (0..24).find(|&row| parser.screen().cell(row, 1).is_some_and(|cell| cell.contents() == "▌")).unwrap();
    assert!((1..30).all(|column| parser.screen().cell(row, column).is_some_and(vt100::Cell::inverse)));
    let coloured = (0..24).flat_map(|row| (0..80).map(move |column| (row, column))).any(|(row, column)| {
        let cell = parser.screen().cell(row, column).unwrap();
        cell.fgcolor() != vt100::Color::Default || cell.bgcolor() != vt100::Color::Default
    });
    assert!(!coloured);
    terminal.press("q");
    terminal.wait(LONG);
}

#[test]
fn a_locale_without_utf8_gets_ascii() {
    let mut terminal = Terminal::start("child_explorer", &[("LC_ALL", "C")]);
    terminal.wait_for_text(FRAME);
    assert!(terminal.screen().screen().contents().is_ascii());
    terminal.press("q");
    terminal.wait(LONG);
}

#[test]
fn without_a_terminal_the_program_says_what_to_use() {
    let output = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "child_explorer", "--ignored", "--nocapture"])
        .env(CHILD, "1")
        .stdin(Stdio::null())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(2));
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("stdout is not a terminal") && message.contains("bevelscope check"), "{message}");
    assert!(!String::from_utf8_lossy(&output.stdout).contains('\x1b'));
    assert_eq!(TuiError::NotATerminal.exit_status(), 2);
}
