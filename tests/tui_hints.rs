//! What the screen says beside the values: marks, reasons, names that are cut no more than needed.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use bevelscope::tui::editor::Editing;
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::message::Message;
use tui_support::{MadeUp, Screen, Shelf, UNICODE};

/// The shipped designs with the tables of the first one open.
fn opened(width: u16, height: u16) -> Screen {
    let shelf = Shelf::shipped();
    let stems = shelf.stems();
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    let mut screen = Screen::with(&stems, width, height, UNICODE, shelf);
    screen.keys("e");
    screen
}

fn editing(screen: &Screen) -> &Editing {
    screen.app.editors.open().unwrap()
}

fn line(screen: &Screen, words: &str) -> String {
    let text = screen.text();
    text.lines().find(|line| line.contains(words)).unwrap_or_else(|| panic!("{words}: {text}")).to_owned()
}

/// How many cells are marked as changed.
fn changed(screen: &Screen) -> usize {
    let view = &editing(screen).view;
    let places = (0..view.rows.len()).flat_map(|row| (0..view.columns.len()).map(move |column| (row, column)));
    places.filter(|&(row, column)| view.is_changed(row, column)).count()
}

#[test]
fn cells_that_are_not_saved_are_marked_until_they_are() {
    let mut screen = opened(80, 24);
    assert_eq!(changed(&screen), 0);
    screen.keys("c60<Enter>");
    assert_eq!(changed(&screen), 1);
    assert!(line(&screen, " 60 ").contains("60 *"), "{}", screen.text());
    // a row more: its cells, and not those of the rows that it has moved
    screen.keys("gA");
    let columns = editing(&screen).view.columns.len();
    assert!(changed(&screen) <= columns + 1, "{}", screen.text());
    screen.keys("s");
    assert_eq!(changed(&screen), 0);
    assert!(!screen.text().contains("60 *"), "{}", screen.text());
    // and those of another table when it comes in sight
    screen.keys("uu<F2>");
    assert_eq!(changed(&screen), 0);
    screen.keys("lc7.5<Enter>");
    assert_eq!(changed(&screen), 1);
}

#[test]
fn the_question_before_leaving_counts_the_changes() {
    let mut screen = opened(80, 24);
    screen.keys("c60<Enter>c61<Enter>q");
    assert_eq!(screen.app.mode, Mode::Leave);
    assert!(screen.text().contains("overhung-elastic * 2 values"), "{}", screen.text());
}

#[test]
fn a_value_beyond_its_limits_is_explained_after_it_was_taken() {
    let mut screen = opened(120, 40);
    screen.keys("lc-5<Enter>");
    // the cursor is a row further
    assert_eq!(editing(&screen).cursor().row, 1);
    let finding = editing(&screen).findings()[0].message.clone();
    assert!(screen.text().contains(&format!("outer diameter of pinion segment 1: {finding}")), "{}", screen.text());
}

#[test]
fn what_was_done_is_named_once() {
    let mut screen = opened(80, 24);
    screen.keys("D");
    assert!(screen.text().contains("done: delete segment 1 of pinion"), "{}", screen.text());
}

#[test]
fn materials_are_taken_from_those_there_are() {
    let mut screen = opened(80, 24);
    screen.keys("<F7>abronze<Enter><F1>");
    let column = editing(&screen).view.columns.iter().position(|column| column.key == "material").unwrap();
    screen.keys(&"l".repeat(column));
    assert!(screen.text().contains("steel, bronze: Space takes the next, Enter types"), "{}", screen.text());
    let material = |screen: &Screen| editing(screen).cell().unwrap().shown.text().to_owned();
    let first = material(&screen);
    screen.keys(" ");
    assert_eq!((first.as_str(), material(&screen).as_str()), ("steel", "bronze"));
    screen.keys(" ");
    assert_eq!(material(&screen), "steel");
}

#[test]
fn of_several_lines_the_first_is_taken_and_that_is_said() {
    let said = "only the first line was taken";
    let mut screen = opened(80, 24);
    screen.keys("c");
    screen.send(Message::Paste("41\n42\n".into()));
    assert!(editing(&screen).input.as_ref().unwrap().line.text() == "41", "{}", screen.text());
    assert!(screen.text().contains(said), "{}", screen.text());
    screen.keys("<Esc>c");
    screen.send(Message::Paste("41\n".into()));
    assert!(!screen.text().contains(said), "{}", screen.text());
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.keys("/");
    screen.send(Message::Paste("over\nhung".into()));
    assert!(screen.app.library.filter() == "over" && screen.text().contains(said), "{}", screen.text());
}

#[test]
fn a_name_is_not_refused_before_it_is_asked_for() {
    let mut screen = Screen::new(80, 24, UNICODE);
    let refused = "this is its name now";
    screen.keys("r");
    assert!(!screen.text().contains(refused), "{}", screen.text());
    screen.keys("<Left>");
    assert!(!screen.text().contains(refused), "{}", screen.text());
    screen.keys("<Enter>");
    assert!(screen.text().contains(refused), "{}", screen.text());
    screen.keys("<Esc>r<End>x<Backspace>");
    assert!(screen.text().contains(refused), "{}", screen.text());
}

#[test]
fn both_lines_of_figures_have_the_same_columns() {
    let mut screen = opened(80, 24);
    screen.keys("c60<Enter>");
    let [enhanced, basic] = ["enhanced:", "basic:"].map(|words| line(&screen, words));
    assert!(enhanced.contains("(was") || basic.contains("(was"), "{}", screen.text());
    assert_eq!(enhanced.find("FRAC"), basic.find("FRAC"), "{}", screen.text());
    assert!(basic.contains("FRAC"), "{}", screen.text());
}

#[test]
fn warnings_are_read_to_their_end() {
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.keys("G");
    let text = screen.text();
    for words in ["! the polar inertia of", "diametral one (and 1 more)"] {
        assert!(text.contains(words), "{words}: {text}");
    }
}

#[test]
fn the_list_says_why_a_design_matches() {
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.keys("/rigid bea");
    assert!(line(&screen, "▌overhu").contains("\"rig"), "{}", screen.text());
    screen.keys("<Esc>/rigid");
    assert!(!line(&screen, "▌overhung-rigid").contains('"'), "{}", screen.text());
}

#[test]
fn a_large_terminal_has_room_for_names() {
    let stem = "overhung-elastic-stiffer-head";
    let screen = Screen::with(&[stem], 120, 40, UNICODE, MadeUp);
    assert!(screen.text().contains(stem), "{}", screen.text());
    let screen = Screen::with(&["a"], 120, 40, UNICODE, MadeUp);
    assert!(line(&screen, "Designs 1 of 1").chars().take(38).last() == Some('┐'), "{}", screen.text());
}

#[test]
fn no_line_of_the_help_is_cut() {
    for (width, height) in [(80, 24), (130, 40), (60, 18)] {
        let mut screen = opened(width, height);
        screen.keys("?");
        let mut seen = Vec::new();
        for _ in 0..60 {
            let text = screen.text();
            let inside = text.lines().skip(2).take(usize::from(height) - 4);
            seen.extend(
                inside.filter(|line| line.trim_end().ends_with("…│") || line.contains("… │")).map(str::to_owned),
            );
            screen.keys("<PgDn>");
        }
        assert_eq!(seen, [""; 0], "{width}");
    }
}

#[test]
fn nothing_of_a_value_stays_behind_the_box_that_is_typed_into() {
    let mut screen = opened(80, 24);
    screen.keys("<F7>l");
    screen.keys("c");
    for letters in ["2700 kg/m3", "0"] {
        screen.keys(letters);
        let row = line(&screen, "steel");
        let behind = row.split_once(']').unwrap().1;
        assert!(!behind.trim_start_matches(' ').starts_with(')'), "{row}");
        assert_eq!(behind.matches(')').count(), behind.matches('(').count(), "{row}");
    }
}
