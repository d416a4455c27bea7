//! What the explorer leaves behind for those who mend it: the log, and the report of a crash; and what it hands to the
//! clipboard.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod terminal_support;
mod tui_support;

use std::path::{Path, PathBuf};
use std::thread;

use bevelscope::crash;
use bevelscope::tui::app::App;
use bevelscope::tui::message::Message;
use bevelscope::tui::terminal::Session;
use portable_pty::CommandBuilder;
use ratatui::crossterm::event::{KeyCode, KeyEvent};
use terminal_support::{DESIGNS, FRAME, LONG, Terminal, is_child};
use tui_support::{STEMS, UNICODE, paths};

const PURPOSE: &str = "on purpose\x1b[2J";

/// A terminal taken over, sixty actions done, a frame drawn.
fn crashing() -> (Session, App) {
    crash::install();
    crash::describe_terminal("TERM: xterm-256color\u{1b}".into());
    let mut session = Session::enter().unwrap();
    let mut app = App::new(paths(&STEMS), "~/designs".into(), UNICODE);
    for _ in 0..60 {
        app.update(Message::Key(KeyEvent::from(KeyCode::Char('j'))));
    }
    app.update(Message::Key(KeyEvent::from(KeyCode::Char('?'))));
    session.draw(&mut app).unwrap();
    (session, app)
}

#[test]
#[ignore = "started by other tests in a terminal"]
fn child_panics() {
    if is_child() {
        let _crashing = crashing();
        panic!("{PURPOSE}");
    }
}

#[test]
#[ignore = "started by other tests in a terminal"]
fn child_panics_in_another_thread() {
    if is_child() {
        let _crashing = crashing();
        let keys = thread::Builder::new().name("keys".into()).spawn(|| panic!("{PURPOSE}")).unwrap();
        drop(keys.join());
        thread::sleep(LONG);
    }
}

fn files(folder: &Path) -> Vec<PathBuf> {
    std::fs::read_dir(folder).map_or(Vec::new(), |entries| entries.map(|entry| entry.unwrap().path()).collect())
}

#[test]
fn a_crash_leaves_a_report_and_says_where_it_is() {
    for child in ["child_panics", "child_panics_in_another_thread"] {
        let home = tempfile::tempdir().unwrap();
        let state = home.path().display().to_string();
        let mut terminal = Terminal::start(child, &[("XDG_STATE_HOME", &state)]);
        assert_eq!(terminal.wait(LONG).exit_code(), 101, "{child}");
        terminal.assert_restored();
        let reports = files(&home.path().join("bevelscope"));
        let [report] = &reports[..] else { panic!("{reports:?}") };
        assert!(report.file_name().unwrap().to_string_lossy().starts_with("crash-2"), "{report:?}");
        let text = std::fs::read_to_string(report).unwrap();
        assert!(!text.contains('\x1b'));
        for part in [
            concat!("bevelscope ", env!("CARGO_PKG_VERSION"), " on ", "linux"),
            "on purpose\\u{1b}[2J",
            "tests/terminal_reports.rs:",
            "TERM: xterm-256color\\u{1b}",
            "library: move-down",
            "library: help\n",
            "Backtrace",
        ] {
            assert!(!cfg!(target_os = "linux") || text.contains(part), "no {part:?} in\n{text}");
        }
        let thread = if child == "child_panics" { "thread child_panics at" } else { "thread keys at" };
        assert!(text.contains(thread), "{text}");
        assert_eq!(text.matches("library: ").count(), 50, "{text}");
        let backtrace = text.split("Backtrace\n").nth(1).unwrap();
        assert!(backtrace.contains("terminal_reports") && backtrace.lines().count() > 5, "{backtrace}");
        // said after the terminal was given back, with nothing that steers it
        let output = String::from_utf8_lossy(&terminal.output()).into_owned();
        let said = &output[output.find("\x1b[?1049l").unwrap() + 8..];
        assert!(
            said.contains("bevelscope ended because of a mistake in the program: on purpose\\u{1b}[2J"),
            "{said:?}"
        );
        assert!(said.replace("\r\n", "").contains(&report.display().to_string()), "{said:?}");
    }
}

#[test]
fn a_report_that_cannot_be_saved_is_printed() {
    // a file where the folder should be: permissions would stop no one who is root
    let home = tempfile::tempdir().unwrap();
    std::fs::write(home.path().join("bevelscope"), "").unwrap();
    let state = home.path().display().to_string();
    let mut terminal = Terminal::start("child_panics", &[("XDG_STATE_HOME", &state)]);
    assert_eq!(terminal.wait(LONG).exit_code(), 101);
    terminal.assert_restored();
    let output = String::from_utf8_lossy(&terminal.output()).into_owned();
    let said = &output[output.find("\x1b[?1049l").unwrap() + 8..];
    assert!(said.contains("cannot be saved") && said.contains("Backtrace"), "{said:?}");
    assert!(said.contains("library: help"), "{said:?}");
}

#[test]
fn the_log_says_what_happened_and_nothing_of_the_designs() {
    let home = tempfile::tempdir().unwrap();
    let designs = home.path().join("designs");
    std::fs::create_dir(&designs).unwrap();
    let text = std::fs::read_to_string(Path::new(DESIGNS).join("overhung-elastic.toml")).unwrap();
    std::fs::write(designs.join("a.toml"), &text).unwrap();
    std::fs::write(designs.join("b\u{1b}[31m.toml"), "no design").unwrap();
    std::fs::write(designs.join("c.toml"), format!("parent = \"a\"\n{text}")).unwrap();
    let log = home.path().join("log");
    std::fs::write(&log, "before\n").unwrap();
    let (named, shown) = (log.display().to_string(), designs.display().to_string());
    let mut terminal = Terminal::program(&["--log", &named, &shown], &[]);
    terminal.wait_for_text(FRAME);
    terminal.press("e");
    terminal.wait_for_text("pinion segments");
    terminal.press("\x1bOQ");
    terminal.wait_for_text("pinion bearings");
    terminal.press("lc0.0555\r");
    terminal.wait_for_text("a * ");
    terminal.press("s");
    terminal.wait_for("the design to be saved", |screen| !screen.contents().contains("a * "));
    // a variant follows
    terminal.press("\x1b");
    terminal.wait_for_text("Designs 1 of 3");
    terminal.press("ra2\r");
    terminal.wait_for_text("1 variant follows");
    terminal.signal("TERM");
    assert_eq!(terminal.wait(LONG).exit_code(), 128 + 15);
    let log = std::fs::read_to_string(log).unwrap();
    assert!(log.starts_with("before\n20"), "{log}");
    assert!(log.lines().skip(1).all(|line| line.len() > 25 && line.as_bytes()[23] == b'Z'), "{log}");
    for part in [
        concat!("start of bevelscope ", env!("CARGO_PKG_VERSION")),
        "TERM: xterm-256color",
        "a.toml in ",
        " ms",
        "cannot read ",
        "b\\u{1b}[31m.toml: ",
        "opened ",
        "saved ",
        "a2.toml, 1 of 1 variants follow",
        "signal 15",
        "end: bevelscope: ended by signal 15",
    ] {
        assert!(log.contains(part), "no {part:?} in\n{log}");
    }
    assert!(!log.contains('\x1b') && !log.contains("0.0555") && !log.contains("teeth"), "{log}");
}

#[test]
fn a_log_that_fails_stops_nothing_and_one_that_cannot_be_opened_is_an_error() {
    let home = tempfile::tempdir().unwrap();
    let none = home.path().join("none/log").display().to_string();
    for (log, says) in [(none.as_str(), "the log cannot be opened"), ("/dev/tty", "the log would go through")] {
        let mut terminal = Terminal::program(&["--log", log, DESIGNS], &[]);
        assert_eq!(terminal.wait(LONG).exit_code(), 2);
        terminal.wait_for_text("error: ");
        let output = String::from_utf8_lossy(&terminal.output()).replace("\r\n", "");
        assert!(output.contains(says) && !output.contains("\x1b[?1049h"), "{output:?}");
    }
    // a full disk, and a pipe whose reader has gone
    let mut full = CommandBuilder::new(env!("CARGO_BIN_EXE_bevelscope"));
    full.args(["--log", "/dev/full", DESIGNS]);
    let mut pipe = CommandBuilder::new("/bin/bash");
    pipe.args(["-c", &format!("exec {} --log >(true) {DESIGNS}", env!("CARGO_BIN_EXE_bevelscope"))]);
    for command in [full, pipe] {
        let mut terminal = Terminal::run(command, &[("PATH", "/usr/bin:/bin")]);
        terminal.wait_for_text(FRAME);
        terminal.press("j");
        terminal.wait_for_text("Designs 2 of 7");
        terminal.press("q");
        assert!(terminal.wait(LONG).success());
        terminal.assert_restored();
    }
}

// base64 by `printf %s "55.0 mm" | base64`
#[test]
fn a_copied_cell_goes_to_the_terminal_once() {
    for (environment, wrapped) in [(("A", "b"), false), (("TMUX", "/tmp/tmux,1,0"), true)] {
        let mut terminal = Terminal::program(&[DESIGNS], &[environment]);
        terminal.wait_for_text(FRAME);
        terminal.press("e");
        terminal.wait_for_text("pinion segments");
        terminal.press("\x1bOQ");
        terminal.wait_for_text("pinion bearings");
        terminal.press("ly");
        terminal.wait_for_text("sent to terminal: 55.0 mm");
        terminal.press("q");
        assert!(terminal.wait(LONG).success());
        terminal.assert_restored();
        let output = String::from_utf8_lossy(&terminal.output()).into_owned();
        let sequence = "\x1b]52;c;NTUuMCBtbQ==\x07";
        let inner = "\x1bPtmux;\x1b\x1b]52;c;NTUuMCBtbQ==\x07\x1b\\";
        assert_eq!(output.matches("]52;").count(), if wrapped { 2 } else { 1 }, "{output:?}");
        assert!(output.contains(sequence), "{output:?}");
        assert_eq!(output.contains(inner), wrapped);
    }
}
