//! A real pseudo-terminal, and the explorer in it.
//!
//! The program under test is `bevelscope` itself, or the test binary started again as one of its `child_` tests.
#![allow(dead_code, reason = "each test uses its own part")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use std::io::{Read, Write};
use std::process::Command;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use bevelscope::tui::{Backend, Options, run};
use portable_pty::{Child, CommandBuilder, ExitStatus, MasterPty, PtySize, native_pty_system};

use crate::tui_support::{STEMS, paths};

/// Set in the program under test.
pub const CHILD: &str = "BEVELSCOPE_TEST_CHILD";
/// Nobody's unsaved edits are offered to the program.
const STATE: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/terminal-state");
/// Longer than anything takes.
pub const LONG: Duration = Duration::from_secs(20);

/// Whether this is the program under test.
pub fn is_child() -> bool {
    std::env::var_os(CHILD).is_some()
}

/// Runs the explorer on made-up designs, and ends with its status.
pub fn explore(backend: impl Backend + 'static) -> ! {
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

/// What the explorer says once the first design is solved.
pub const FRAME: &str = "trust up to 2,997 Hz";
/// The folder of the shipped designs.
pub const DESIGNS: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/designs");

/// A child in a pseudo-terminal, and what it has written.
pub struct Terminal {
    pub child: Box<dyn Child + Send + Sync>,
    pub master: Option<Box<dyn MasterPty + Send>>,
    pub writer: Option<Box<dyn Write + Send>>,
    output: Arc<Mutex<Vec<u8>>>,
    /// Tells the reading thread to let go.
    pub closing: Arc<AtomicBool>,
    /// Hears of every piece of output.
    pub wrote: Receiver<()>,
}

impl Terminal {
    /// This binary again, as one of the `child_` tests.
    pub fn start(test: &str, environment: &[(&str, &str)]) -> Self {
        let mut command = CommandBuilder::new(std::env::current_exe().unwrap());
        command.args(["--exact", test, "--ignored", "--nocapture", "--test-threads=1"]);
        Self::run(command, environment)
    }

    /// The program itself.
    pub fn program(arguments: &[&str], environment: &[(&str, &str)]) -> Self {
        let mut command = CommandBuilder::new(env!("CARGO_BIN_EXE_bevelscope"));
        command.args(arguments);
        Self::run(command, environment)
    }

    pub fn run(mut command: CommandBuilder, environment: &[(&str, &str)]) -> Self {
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

    pub fn output(&self) -> Vec<u8> {
        self.output.lock().unwrap().clone()
    }

    pub fn screen(&self) -> vt100::Parser {
        let mut parser = vt100::Parser::new(24, 80, 0);
        parser.process(&self.output());
        parser
    }

    /// Another size, as when the user pulls at the window.
    pub fn resize(&self, columns: u16, rows: u16) {
        let size = PtySize { rows, cols: columns, pixel_width: 0, pixel_height: 0 };
        self.master.as_ref().unwrap().resize(size).unwrap();
    }

    /// What a terminal of that size shows of what was written from a place in the output on.
    pub fn screen_of(&self, (columns, rows): (u16, u16), from: usize) -> vt100::Parser {
        let mut parser = vt100::Parser::new(rows, columns, 0);
        parser.process(&self.output()[from..]);
        parser
    }

    /// The letter of the process's state: R, S, T for stopped; nothing where the system does not tell.
    pub fn state(&self) -> Option<char> {
        let process = self.child.process_id().unwrap();
        let status = std::fs::read_to_string(format!("/proc/{process}/stat")).ok()?;
        status.rsplit(')').next()?.trim_start().chars().next()
    }

    pub fn wait_until(&self, what: &str, is_so: impl Fn() -> bool) {
        let deadline = Instant::now() + LONG;
        while !is_so() {
            assert!(Instant::now() < deadline, "not {what}:\n{}", self.screen().screen().contents());
            thread::sleep(Duration::from_millis(10));
        }
    }

    /// Closes the terminal, as when its window is closed or the line breaks.
    pub fn vanish(&mut self, key: &str) {
        // the reading thread holds the terminal open too: it lets go after the next frame
        self.closing.store(true, Ordering::SeqCst);
        self.press(key);
        while self.wrote.recv_timeout(LONG).is_ok() {}
        self.writer = None;
        self.master = None;
    }

    /// Whether echo and lines are on, as a shell leaves them.
    pub fn is_cooked(&self) -> bool {
        let mode = self.master.as_ref().and_then(|master| master.get_termios());
        let local = mode.map(|mode| format!("{:?}", mode.local_flags)).unwrap_or_default();
        local.contains("ECHO") && local.contains("ICANON")
    }

    pub fn wait_for(&self, what: &str, found: impl Fn(&vt100::Screen) -> bool) {
        let deadline = Instant::now() + LONG;
        while !found(self.screen().screen()) {
            assert!(Instant::now() < deadline, "no {what}:\n{}", self.screen().screen().contents());
            let _ = self.wrote.recv_timeout(Duration::from_millis(50));
        }
    }

    pub fn wait_for_text(&self, text: &str) {
        self.wait_for(text, |screen| screen.contents().contains(text));
    }

    pub fn press(&mut self, keys: &str) {
        let writer = self.writer.as_mut().unwrap();
        writer.write_all(keys.as_bytes()).unwrap();
        writer.flush().unwrap();
    }

    pub fn signal(&self, name: &str) {
        let process = self.child.process_id().unwrap().to_string();
        assert!(Command::new("kill").args(["-s", name, &process]).status().unwrap().success());
    }

    pub fn wait(&mut self, limit: Duration) -> ExitStatus {
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
    pub fn assert_restored(&self) {
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
        assert!(self.is_cooked());
    }
}
