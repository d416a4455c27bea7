//! What one meets in an ordinary day with the explorer: keys, and what stands on the screen after them.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use bevelscope::tui::caps::Capabilities;
use bevelscope::tui::editor::Editing;
use tui_support::{Screen, Shelf, UNICODE};

/// The shipped designs, the first one selected.
fn library(width: u16, height: u16, capabilities: Capabilities) -> (Screen, Shelf) {
    let shelf = Shelf::shipped();
    let stems = shelf.stems();
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    (Screen::with(&stems, width, height, capabilities, shelf.clone()), shelf)
}

/// The same with the tables of the first one open.
fn opened(width: u16, height: u16) -> (Screen, Shelf) {
    let (mut screen, shelf) = library(width, height, UNICODE);
    screen.keys("e");
    (screen, shelf)
}

fn editing(screen: &Screen) -> &Editing {
    screen.app.editors.open().unwrap()
}

/// The line of the screen with these words.
fn line(screen: &Screen, words: &str) -> String {
    let text = screen.text();
    text.lines().find(|line| line.contains(words)).unwrap_or_else(|| panic!("{words}: {text}")).to_owned()
}

#[test]
fn what_was_saved_is_what_the_library_shows_at_once() {
    let (mut screen, _) = opened(80, 24);
    assert!(screen.text().contains("trust up to 2,997 Hz"), "{}", screen.text());
    screen.keys("c60<Enter>");
    let now = line(&screen, "enhanced:").replace(" (was 2,997)", "");
    let limit = now.split("trust up to ").nth(1).unwrap().split(" Hz").next().unwrap().to_owned();
    assert_ne!(limit, "2,997");
    // nothing is solved any more, and the figures are there all the same
    screen.keys("s");
    screen.held = true;
    screen.effects.clear();
    screen.keys("<Esc>");
    let text = screen.text();
    assert!(line(&screen, "enhanced:").contains(&format!("trust up to {limit} Hz")), "{text}");
    assert!(line(&screen, "overhung-elastic").contains(&format!(" {limit}")), "{text}");
    assert!(!text.contains("2,997 Hz,"), "{text}");
    // and they are those of the file, once it is solved
    screen.held = false;
    screen.keys("R");
    assert!(line(&screen, "enhanced:").contains(&format!("trust up to {limit} Hz")), "{}", screen.text());
}

#[test]
fn a_design_saved_with_errors_has_no_figures_in_the_library() {
    let (mut screen, _) = opened(80, 24);
    screen.keys("lc-5<Enter>s<Esc>");
    let text = screen.text();
    assert!(!text.contains("trust up to"), "{text}");
    assert!(text.contains("cannot be read"), "{text}");
}
