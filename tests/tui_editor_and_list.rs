//! What tables and list of designs have to do with one another: which solution belongs to which state.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

mod tui_support;

use bevelscope::tui::editor::Editing;
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::message::{Effect, Message};
use bevelscope::tui::solving;
use tui_support::{Screen, Shelf, UNICODE, paths};

/// The shipped designs with the tables of the first one open.
fn opened() -> (Screen, Shelf) {
    let shelf = Shelf::shipped();
    let stems = shelf.stems();
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    let mut screen = Screen::with(&stems, 80, 24, UNICODE, shelf.clone());
    screen.keys("e");
    (screen, shelf)
}

fn editing(screen: &Screen) -> &Editing {
    screen.app.editors.open().unwrap()
}

/// The design on the shelf with its pinion's first segment 45 mm long.
fn written_by_someone_else(shelf: &Shelf) {
    let path = &paths(&["overhung-elastic"])[0];
    let mut texts = shelf.texts.lock().unwrap();
    let text = texts.get_mut(path).unwrap();
    let changed = text.replacen("length_mm = 36.0", "length_mm = 45.0", 1);
    assert!(*text != changed);
    *text = changed;
}

#[test]
fn a_picture_from_before_a_rereading_is_not_taken_for_the_new_design() {
    let (mut screen, shelf) = opened();
    screen.keys("<Esc>");
    written_by_someone_else(&shelf);
    screen.held = true;
    screen.effects.clear();
    screen.keys("R");
    let job = screen.effects.iter().find_map(|effect| match effect {
        Effect::Solve(job) => Some(job.clone()),
        _ => None,
    });
    // the file is read, but not solved yet
    solving::perform(&job.unwrap(), &shelf, &mut |message| {
        if matches!(message, Message::Loaded { .. }) {
            screen.app.update(message);
        }
    });
    screen.keys("e");
    let shown = editing(&screen).solving.current.as_ref().unwrap();
    assert_eq!(shown.design.pinion.segments[0].length, 0.036);
    assert!(screen.text().contains("stale"), "{}", screen.text());
}

#[test]
fn a_saved_design_is_shown_anew_when_its_tables_are_closed() {
    let (mut screen, _) = opened();
    let figures =
        |screen: &Screen| screen.text().lines().filter(|line| line.contains("trust up to")).collect::<String>();
    screen.keys("<Esc>");
    let before = figures(&screen);
    screen.keys("e<F2>llllc2e8<Enter>s<Esc>");
    assert_eq!(screen.app.mode, Mode::Library);
    assert_ne!(figures(&screen), before, "{}", screen.text());
}

#[test]
fn a_filter_that_no_longer_fits_leaves_the_open_tables_their_solution() {
    let (mut screen, _) = opened();
    screen.keys("<Esc>/both overhung<Enter>e");
    screen.held = true;
    screen.effects.clear();
    screen.keys("<F8>cother<Enter>s<F1>c41<Enter>");
    // as if the library had read it again before the solution came
    let fill = screen.effects.iter().find_map(|effect| match effect {
        Effect::Fill(jobs) => jobs.first().cloned(),
        _ => None,
    });
    screen.perform(&fill.unwrap());
    assert_eq!(screen.app.library.matches(), 1);
    assert!(!screen.effects.iter().any(|effect| matches!(effect, Effect::Solve(_))));
    screen.keys("<Esc>");
    assert_eq!(screen.selected(), "overhung-rigid");
    assert!(screen.effects.iter().any(|effect| matches!(effect, Effect::Solve(_))));
}
