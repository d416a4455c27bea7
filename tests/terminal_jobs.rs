//! The explorer under job control, in windows that change their size, and on lines that break.
#![cfg(unix)]
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod terminal_support;
mod tui_support;

use std::thread;
use std::time::Duration;

use portable_pty::CommandBuilder;
use terminal_support::{DESIGNS, FRAME, LONG, Terminal, explore, is_child};
use tui_support::MadeUp;

#[test]
#[ignore = "started by other tests in a terminal"]
fn child_explorer() {
    if is_child() {
        explore(MadeUp);
    }
}

/// Where the output has been written up to, once nothing comes any more.
fn quiet(terminal: &Terminal) -> usize {
    let mut length = terminal.output().len();
    loop {
        thread::sleep(Duration::from_millis(300));
        let now = terminal.output().len();
        if now == length {
            return now;
        }
        length = now;
    }
}

fn is_stopped(terminal: &Terminal) -> bool {
    terminal.state().is_none_or(|state| state == 'T')
}

#[test]
fn suspended_it_gives_the_terminal_back_and_continued_it_draws_all_again() {
    // as a key, and from outside
    for by_key in [true, false] {
        let mut terminal = Terminal::start("child_explorer", &[]);
        terminal.wait_for_text(FRAME);
        if by_key {
            terminal.press("\x1a");
        } else {
            terminal.signal("TSTP");
        }
        terminal.wait_until("stopped", || is_stopped(&terminal) && terminal.is_cooked());
        let parser = terminal.screen();
        assert!(!parser.screen().alternate_screen() && !parser.screen().hide_cursor());
        assert!(!parser.screen().bracketed_paste());
        // the window changes meanwhile
        terminal.resize(100, 30);
        let before = terminal.output().len();
        terminal.signal("CONT");
        let shows = |text: &str| terminal.screen_of((100, 30), before).screen().contents().contains(text);
        terminal.wait_until("drawn again", || shows(FRAME) && shows("bevelscope") && shows("quit"));
        quiet(&terminal);
        let parser = terminal.screen_of((100, 30), before);
        let screen = parser.screen();
        assert!(screen.alternate_screen() && screen.hide_cursor() && screen.bracketed_paste());
        // the frame is as wide as the window is now
        assert!(screen.contents().lines().any(|line| line.starts_with('┌') && line.chars().count() == 100));
        assert!(!terminal.is_cooked());
        terminal.press("q");
        assert!(terminal.wait(LONG).success());
        terminal.assert_restored();
    }
}

/// SIGSTOP cannot be caught: whoever had the terminal meanwhile has left it as it likes.
#[test]
fn stopped_without_being_asked_it_takes_the_terminal_again() {
    let mut terminal = Terminal::start("child_explorer", &[]);
    terminal.wait_for_text(FRAME);
    terminal.signal("STOP");
    terminal.wait_until("stopped", || is_stopped(&terminal));
    let before = terminal.output().len();
    terminal.signal("CONT");
    let shows = |text: &str| terminal.screen_of((80, 24), before).screen().contents().contains(text);
    terminal.wait_until("drawn again", || shows(FRAME) && shows("bevelscope") && shows("quit"));
    let parser = terminal.screen_of((80, 24), before);
    assert!(parser.screen().hide_cursor() && parser.screen().bracketed_paste());
    terminal.press("q");
    assert!(terminal.wait(LONG).success());
    terminal.assert_restored();
}

#[test]
fn a_storm_of_sizes_ends_in_the_right_picture() {
    let mut terminal = Terminal::start("child_explorer", &[]);
    terminal.wait_for_text(FRAME);
    quiet(&terminal);
    let picture = terminal.screen().screen().contents();
    for round in 0_u16..4 {
        for step in 1..100 {
            let size = (200 - 2 * step, 100 - step);
            let (columns, rows) = if round % 2 == 0 { size } else { (201 - size.0, 101 - size.1) };
            terminal.resize(columns.max(1), rows.max(1));
            if step % 10 == 0 {
                thread::sleep(Duration::from_millis(5));
            }
        }
        terminal.resize(1, 1);
    }
    terminal.resize(80, 24);
    quiet(&terminal);
    assert_eq!(terminal.screen().screen().contents(), picture);
    // away and back before anyone can have drawn: the size is the one known, but what stands there is not
    // often enough that the program is late at least once
    for _ in 0..5 {
        let before = terminal.output().len();
        terminal.resize(1, 1);
        terminal.resize(80, 24);
        let shows = || terminal.screen_of((80, 24), before).screen().contents();
        terminal.wait_until("drawn again", || shows().contains(FRAME));
        quiet(&terminal);
        assert_eq!(shows(), terminal.screen().screen().contents());
    }
    terminal.press("q");
    assert!(terminal.wait(LONG).success());
    terminal.assert_restored();
}

/// A shell's `nohup`, or a service manager, hands down a hang-up that is ignored.
#[test]
fn a_line_that_breaks_ends_the_program_also_where_hang_up_is_ignored() {
    for trap in ["", "trap '' HUP;"] {
        let mut command = CommandBuilder::new("/bin/sh");
        let script = format!("{trap} exec {} {DESIGNS}", env!("CARGO_BIN_EXE_bevelscope"));
        command.args(["-c", &script]);
        let mut terminal = Terminal::run(command, &[]);
        terminal.wait_for_text(FRAME);
        terminal.vanish("j");
        let status = terminal.wait(Duration::from_secs(2));
        assert!([128 + 1, 1].contains(&status.exit_code()), "{trap}: {status:?}");
    }
}

/// Runs beside the other tests of this binary.
#[test]
fn an_idle_minute_sends_nothing() {
    let mut terminal = Terminal::program(&[DESIGNS], &[]);
    terminal.wait_for_text(FRAME);
    let before = quiet(&terminal);
    thread::sleep(Duration::from_secs(60));
    assert_eq!(terminal.output().len(), before);
    terminal.press("q");
    assert!(terminal.wait(LONG).success());
}

/// Every screen with a picture, every way to draw it, and the help about them.
#[test]
fn ascii_stays_ascii_whatever_the_curves_are_drawn_with() {
    for asked in [true, false] {
        let arguments = if asked { vec!["--ascii", DESIGNS] } else { vec![DESIGNS] };
        let locale = if asked { "C.UTF-8" } else { "C" };
        let mut terminal = Terminal::program(&arguments, &[("LC_ALL", locale)]);
        terminal.wait_for_text(FRAME);
        terminal.press("b");
        terminal.wait_for_text("curves: ASCII points");
        terminal.press("mj");
        terminal.wait_for_text("Designs 2 of 7");
        terminal.press("c");
        terminal.wait_for_text("differences");
        terminal.press("b");
        terminal.wait_for_text("curves: ASCII letters");
        terminal.press("b");
        terminal.wait_for_text("curves: ASCII points");
        terminal.press("q");
        terminal.wait_for_text("Designs 2 of 7");
        terminal.press("e");
        terminal.wait_for_text("pinion segments");
        terminal.press("\x1bOQ");
        terminal.wait_for_text("pinion bearings");
        terminal.press("b");
        terminal.wait_for_text("curves: ASCII letters");
        terminal.press("?");
        terminal.wait_for_text("Help");
        assert!(terminal.output().is_ascii(), "{:?}", String::from_utf8_lossy(&terminal.output()));
        terminal.press("\x03");
        assert!(terminal.wait(LONG).success());
    }
}
