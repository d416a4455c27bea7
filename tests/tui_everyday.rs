//! What one meets in an ordinary day with the explorer: keys, and what stands on the screen after them.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use bevelscope::tui::caps::Capabilities;
use bevelscope::tui::editor::Editing;
use bevelscope::tui::help::HelpLine;
use bevelscope::tui::message::{Effect, Ending, Message};
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
    let limit = now.split("trust to ").nth(1).unwrap().split(" Hz").next().unwrap().to_owned();
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

/// The second design with its first pinion bearing no longer holding z: nothing keeps the shaft from tilting.
fn unsolvable(width: u16, height: u16) -> Screen {
    let (mut screen, _) = library(width, height, UNICODE);
    screen.keys("je<F2>");
    let row = screen.app.editors.open().unwrap().view.columns.iter().position(|column| column.key == "hold").unwrap();
    screen.keys(&"l".repeat(row)).keys("<Enter>jj <Enter>");
    screen
}

#[test]
fn a_design_that_cannot_be_solved_is_a_finding_with_its_whole_text() {
    let mut screen = unsolvable(80, 24);
    let text = screen.text();
    assert!(text.contains("1 finding (f)") && text.contains("(f: in full)"), "{text}");
    // all of it over the spectra of the last state
    assert!(text.contains("nothing holds it") && text.contains("krx_n_m_per_rad"), "{text}");
    screen.keys("f");
    let text = screen.text();
    assert!(text.contains("cannot be solved: pinion shaft: nothing holds it"), "{text}");
    assert!(text.contains("krx_n_m_per_rad"), "{text}");
    screen.keys("<F1><Enter>");
    assert_eq!((editing(&screen).title().as_str(), editing(&screen).layer.is_none()), ("pinion bearings", true));
    screen.keys("s");
    assert!(screen.text().contains("with 1 error"), "{}", screen.text());
    screen.keys("!");
    assert!(screen.text().contains("saved overhung-rigid.toml, with 1 error"), "{}", screen.text());
    // undone, and it is solved again
    screen.keys("<Esc>u");
    assert!(!screen.text().contains("finding"), "{}", screen.text());
}

#[test]
fn what_is_not_solved_is_not_called_faultless() {
    let (mut screen, _) = opened(80, 24);
    screen.keys("Lc60<Enter>f");
    assert!(screen.text().contains("Whether it can be solved is"), "{}", screen.text());
}

#[test]
fn nothing_is_done_to_what_a_small_terminal_does_not_show() {
    let (mut screen, shelf) = opened(80, 24);
    let saved = shelf.text("overhung-elastic").unwrap();
    screen.resize(50, 12);
    assert!(screen.text().contains("(q quits)"), "{}", screen.text());
    screen.effects.clear();
    screen.keys("Dsc60<Enter>s");
    screen.send(Message::Paste("60".into()));
    assert!(screen.effects.is_empty() && !editing(&screen).is_modified(), "{:?}", screen.effects);
    assert_eq!(shelf.text("overhung-elastic").unwrap(), saved);
    // the question about edits is asked where it can be read, and only there
    screen.resize(80, 24);
    screen.keys("c60<Enter>");
    screen.resize(50, 12);
    screen.keys("q");
    let text = screen.text().replace('\n', " ");
    assert!(text.contains("1 design has unsaved edits") && text.contains("d: discard"), "{text}");
    screen.resize(30, 3);
    screen.keys("ds");
    assert!(!screen.effects.contains(&Effect::Quit(Ending::Quit)));
    screen.resize(50, 12);
    screen.keys("<Esc>");
    assert!(editing(&screen).is_modified() && screen.text().contains("(q quits)"), "{}", screen.text());
    screen.keys("qd");
    assert!(screen.effects.contains(&Effect::Quit(Ending::Quit)));
    assert_eq!(shelf.text("overhung-elastic").unwrap(), saved);
}

#[test]
fn a_row_passes_its_twin() {
    let (mut screen, shelf) = opened(80, 24);
    let before = shelf.text("overhung-elastic").unwrap();
    screen.keys("jY");
    assert_eq!(editing(&screen).cursor().row, 2);
    screen.keys("K");
    assert_eq!(editing(&screen).cursor().row, 1);
    assert!(screen.text().contains("done: move segment"), "{}", screen.text());
    screen.keys("K");
    assert_eq!(editing(&screen).cursor().row, 0);
    screen.keys("uu");
    assert_eq!(editing(&screen).editor.text(), before);
}

#[test]
fn a_model_says_what_it_has_no_place_for() {
    let (mut screen, _) = opened(80, 24);
    // diagonal, matrix with a coupling, rigid
    screen.keys("<F2>lll ");
    assert!(!screen.text().contains("has no place"), "{}", screen.text());
    screen.keys("l<Enter>l1e8<Enter><Esc>h ");
    assert!(screen.text().contains("rigid has no place for 6 stiffnesses"), "{}", screen.text());
    screen.keys("u");
    assert!(editing(&screen).editor.text().contains("1e8"));
    let column = editing(&screen).view.columns.iter().position(|column| column.key == "model").unwrap();
    assert_eq!(editing(&screen).cursor().column, column);
    screen.keys("<Enter>kk<Enter>");
    assert!(screen.text().contains("diagonal has no place for 1 stiffness"), "{}", screen.text());
}

/// The first design with something else in place of some of its text, and its tables open.
fn with_text(from: &str, to: &str) -> Screen {
    let text = Shelf::shipped().text("overhung-elastic").unwrap();
    assert!(text.contains(from));
    let shelf = Shelf::new(&[("odd", &text.replacen(from, to, 1))]);
    let mut screen = Screen::with(&["odd"], 80, 24, UNICODE, shelf);
    screen.keys("e");
    screen
}

#[test]
fn a_key_that_no_table_has_is_seen_and_taken_out_from_the_findings() {
    let mut screen = with_text("\nteeth = ", "\nteth = 14\nteeth = ");
    screen.keys("f");
    assert!(screen.text().contains("pinion.teth: unknown key"), "{}", screen.text());
    screen.keys("<Enter>");
    // its table, which says what is wrong and is marked
    let text = screen.text();
    assert!(text.contains("pinion mesh") && line(&screen, "[F4").contains("mesh×]"), "{text}");
    assert!(text.contains("× unknown key"), "{text}");
    screen.keys("fx");
    assert!(!editing(&screen).editor.text().contains("teth ="), "{}", screen.text());
    assert!(screen.text().contains("No findings"), "{}", screen.text());
    screen.keys("<Esc>u");
    assert!(editing(&screen).editor.text().contains("teth = 14"));
    // what a table has is not taken out here
    let mut screen = with_text("length_mm = 36.0", "length_mm = -36.0");
    let before = editing(&screen).editor.text().to_owned();
    screen.keys("fx");
    assert_eq!(editing(&screen).editor.text(), before);
    assert!(screen.text().contains("it is changed there"), "{}", screen.text());
}

#[test]
fn findings_are_called_as_the_tables_call_their_rows() {
    let mut screen = with_text("length_mm = 36.0", "length_mm = -36.0");
    screen.keys("f");
    let text = screen.text();
    assert!(text.contains("length of pinion segment 1: ") && text.contains("[pinion.segment[0].length_mm]"), "{text}");
}

/// The lines of the help below a title.
fn help_of(screen: &Screen, title: &str) -> Vec<(String, &'static str)> {
    let lines = screen.app.help_lines();
    let below = lines.iter().skip_while(|line| !matches!(line, HelpLine::Title(found) if *found == title)).skip(1);
    let entries = below.map_while(|line| match line {
        HelpLine::Entry { keys, name, .. } => Some((keys.clone(), *name)),
        HelpLine::Title(_) => None,
    });
    entries.collect()
}

#[test]
fn help_says_of_a_key_only_what_it_does_here_and_names_other_places() {
    let (mut screen, _) = library(80, 24, UNICODE);
    screen.keys("?");
    let has = |entries: &[(String, &str)], keys: &str, name: &str| entries.contains(&(keys.to_owned(), name));
    let program = help_of(&screen, "Program");
    assert_eq!(program.iter().filter(|(keys, _)| keys.split(' ').any(|key| key == "q")).count(), 1, "{program:?}");
    assert!(has(&program, "Esc", "back"), "{program:?}");
    assert!(!help_of(&screen, "Editing").iter().any(|(_, name)| name.ends_with("-all")));
    assert!(has(&help_of(&screen, "When asked about unsaved edits"), "s", "save-all"));
    let (mut screen, _) = opened(80, 24);
    screen.keys("?");
    let moving = help_of(&screen, "Moving");
    assert!(has(&moving, "g", "first"), "{moving:?}");
    assert!(has(&help_of(&screen, "In the tables"), "Home", "first-cell"));
    assert!(!help_of(&screen, "Finding").iter().any(|(_, name)| *name == "filter"));
    assert!(has(&help_of(&screen, "While a cell is typed into"), "Enter", "accept-cell"));
    assert!(has(&help_of(&screen, "In a list of words"), "Enter", "choose"));
}

#[test]
fn a_message_has_the_room_of_the_hints() {
    let (mut screen, _) = opened(80, 24);
    screen.keys("c60<Enter><Esc>r");
    assert!(
        screen.text().contains("overhung-elastic has edits that are not saved: save them first"),
        "{}",
        screen.text()
    );
}

#[test]
fn a_copy_says_that_unsaved_edits_stay_behind() {
    let (mut screen, _) = opened(80, 24);
    screen.keys("<Esc>Y");
    assert!(!screen.text().contains("without unsaved edits"), "{}", screen.text());
    screen.keys("<Esc>ec60<Enter><Esc>Y");
    assert!(screen.text().contains("without unsaved edits"), "{}", screen.text());
}
