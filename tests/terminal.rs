//! The explorer in a real pseudo-terminal: however it ends, the terminal is as it was.
//!
//! The program under test is this test binary itself, started again with one of the `child_` tests, so that the
//! explorer runs on made-up designs and can be made to panic.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod terminal_support;
mod tui_support;

use std::path::Path;
use std::process::{Command, Stdio};
use std::sync::atomic::Ordering;
use std::thread;
use std::time::Duration;

use bevelscope::comparison::{Comparison, Observer, SolveError};
use bevelscope::design::Design;
use bevelscope::tui::terminal::Session;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign, TuiError};
use portable_pty::CommandBuilder;
use terminal_support::{CHILD, DESIGNS, FRAME, LONG, Terminal, explore, is_child};
use tui_support::MadeUp;

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

/// The figures are those of the shipped designs, as `tests/cases.rs` has them.
#[test]
fn the_program_shows_the_shipped_designs() {
    let mut terminal = Terminal::program(&[DESIGNS], &[]);
    terminal.wait_for_text("enhanced: trust up to 2,997 Hz,  3.72 dB RMS");
    terminal.press("jj");
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
    let mut terminal = Terminal::program(&[DESIGNS], &[]);
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
    terminal.vanish("j");
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
    terminal.wait_for_text("Designs 2 of 2");
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
