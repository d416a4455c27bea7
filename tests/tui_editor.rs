//! The editor: key scripts, pictures, results that come late, and every cell of every table.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{Sender, channel};
use std::time::Duration;

use bevelscope::comparison::{Comparison, Observer, SolveError, compare_over};
use bevelscope::design::Design;
use bevelscope::design::grid::{Cell, CellKind, Sheet};
use bevelscope::design::schema::{Kind, ROOT};
use bevelscope::tui::caps::{Background, Capabilities, ColourDepth};
use bevelscope::tui::editor::{Editing, Place, Tab};
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::message::{Effect, Ending, Message};
use bevelscope::tui::solving::EditedJob;
use bevelscope::tui::worker::Worker;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign};
use insta::assert_snapshot;
use tui_support::{ASCII, Screen, Shelf, UNICODE, paths};

/// The shipped designs with the tables of the first one open.
fn opened(width: u16, height: u16, capabilities: Capabilities) -> (Screen, Shelf) {
    let shelf = Shelf::shipped();
    let stems = shelf.stems();
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    let mut screen = Screen::with(&stems, width, height, capabilities, shelf.clone());
    screen.keys("e");
    (screen, shelf)
}

fn editing(screen: &Screen) -> &Editing {
    screen.app.editors.open().unwrap()
}

/// The lines that differ, as `-before` and `+after`.
fn changed(before: &str, after: &str) -> Vec<String> {
    let (before, after): (Vec<&str>, Vec<&str>) = (before.lines().collect(), after.lines().collect());
    let start = before.iter().zip(&after).take_while(|(a, b)| a == b).count();
    let rest = before.len().min(after.len()) - start;
    let end = before.iter().rev().zip(after.iter().rev()).take(rest).take_while(|(a, b)| a == b).count();
    let gone = before[start..before.len() - end].iter().map(|line| format!("-{line}"));
    gone.chain(after[start..after.len() - end].iter().map(|line| format!("+{line}"))).collect()
}

/// Keys, and what they change in the text.
const EDITS: &[(&str, &[&str])] = &[
    ("", &[]),
    // accepted with a unit, in the spelling of the file
    ("c35 mm<Enter>", &["-length_mm = 36.0", "+length_mm = 35"]),
    ("c1.4 in<Enter>", &["-length_mm = 36.0", "+length_mm = 35.56"]),
    ("<F2><Right><Right><Right><Right>c700 N/um<Enter>", &["-kx_n_per_m = 6.0e8", "+kx_n_per_m = 7e8"]),
    // a letter of a number begins to type
    (".5<Enter>", &["-length_mm = 36.0", "+length_mm = 0.5"]),
    ("0.5<Enter>", &["-length_mm = 36.0", "+length_mm = 0.5"]),
    ("9e1<Enter>", &["-length_mm = 36.0", "+length_mm = 9e1"]),
    ("35 mm<Enter>", &["-length_mm = 36.0", "+length_mm = 35"]),
    ("<F2>llll700 N/um<Enter>", &["-kx_n_per_m = 6.0e8", "+kx_n_per_m = 7e8"]),
    // and where no number is, nothing happens
    ("<F2>8", &[]),
    // Enter keeps what is there, with the cursor at its end
    ("<Enter><End><Backspace>5<Enter>", &["-length_mm = 36.0", "+length_mm = 36.5"]),
    // until a letter is typed, which replaces it
    ("<Enter>1.4 in<Enter>", &["-length_mm = 36.0", "+length_mm = 35.56"]),
    ("<Enter><Backspace>5<Enter>", &["-length_mm = 36.0", "+length_mm = 5"]),
    ("<F2>llll<Enter>700 N/um<Enter>", &["-kx_n_per_m = 6.0e8", "+kx_n_per_m = 7e8"]),
    ("<Enter><Home>1<Enter>", &["-length_mm = 36.0", "+length_mm = 136.0"]),
    ("<Enter><Left><Left><Backspace>7<Enter>", &["-length_mm = 36.0", "+length_mm = 37.0"]),
    ("<Enter><Ctrl-u>4<Enter>", &["-length_mm = 36.0", "+length_mm = 4"]),
    ("c4 mm<Ctrl-w>cm<Enter>", &["-length_mm = 36.0", "+length_mm = 40.0"]),
    ("<Enter><Home><Delete>4<Enter>", &["-length_mm = 36.0", "+length_mm = 46.0"]),
    // Esc leaves the cell as it was
    ("c99<Esc>", &[]),
    // a wrong input stays open
    ("c3 kg<Enter>", &[]),
    ("c3 kg<Enter><Backspace><Backspace>mm<Enter>", &["-length_mm = 36.0", "+length_mm = 3"]),
    // Enter goes down, Tab to the right, Shift-Tab to the left
    ("c4<Enter>", &["-length_mm = 36.0", "+length_mm = 4"]),
    (
        "lc5<Tab>c6<S-Tab>",
        &["-outer_diameter_mm = 44.0", "-inner_diameter_mm = 0.0", "+outer_diameter_mm = 5", "+inner_diameter_mm = 6"],
    ),
    // a default that is left as it is, is not written
    ("<End><Left><Enter><Enter>", &[]),
    ("<End>x", &["-elements = 1"]),
    ("<End><Delete>", &["-elements = 1"]),
    // a value that must be there is not cleared
    ("x", &[]),
    // letters are text while something is typed
    ("<F8>cqueen<Enter>", &["-name = \"Both overhung, elastic bearings\"", "+name = \"queen\""]),
    // words
    ("<F6>jjj ", &["-frequency_spacing = \"linear\"", "+frequency_spacing = \"log\""]),
    ("<F6>jjj<Enter>j<Enter>", &["-frequency_spacing = \"linear\"", "+frequency_spacing = \"log\""]),
    ("<F6>jjj<Enter>j<Esc>", &[]),
    // tables
    ("<F4>c7e8<Enter>", &["-stiffness_n_per_m = 6.4e8", "+stiffness_n_per_m = 7e8"]),
    ("<F5>pjc2e4<Enter>", &["-torsional_stiffness_n_m_per_rad = 1.0e4", "+torsional_stiffness_n_m_per_rad = 2e4"]),
    ("]c25<Enter>", &["-name = \"head bearing\"", "+name = \"25\""]),
    // undo and redo
    ("c4<Enter>u", &[]),
    ("c4<Enter>u<Ctrl-r>", &["-length_mm = 36.0", "+length_mm = 4"]),
    ("c4<Enter>c5<Enter>uu<Ctrl-r>", &["-length_mm = 36.0", "+length_mm = 4"]),
    ("a", &["+"]),
    ("D", &["-"]),
    ("aD", &[]),
    ("Yu", &[]),
    ("JK", &[]),
];

#[test]
fn keys_change_the_text_and_nothing_else_of_it() {
    for (keys, expected) in EDITS {
        let (mut screen, shelf) = opened(80, 24, UNICODE);
        screen.keys(keys);
        let before = shelf.text("overhung-elastic").unwrap();
        let found = changed(&before, editing(&screen).editor.text());
        match *expected {
            ["+"] => assert!(!found.is_empty() && found.iter().all(|line| line.starts_with('+')), "{keys}: {found:#?}"),
            ["-"] => assert!(!found.is_empty() && found.iter().all(|line| line.starts_with('-')), "{keys}: {found:#?}"),
            expected => {
                // whatever else is on the line stays
                let cut = |line: &String| line.split(" #").next().unwrap_or_default().trim_end().to_owned();
                assert_eq!(found.iter().map(cut).collect::<Vec<_>>(), expected, "{keys}");
            }
        }
        assert_eq!(screen.text().lines().next().unwrap().contains('*'), !found.is_empty(), "{keys}");
    }
}

type At = (Tab, &'static str, usize, usize);

/// Keys, and where the cursor is after them: table, shaft, row, column.
const PLACES: &[(&str, At)] = &[
    ("", (Tab::Segments, "pinion", 0, 0)),
    ("j", (Tab::Segments, "pinion", 1, 0)),
    ("G", (Tab::Segments, "pinion", 3, 0)),
    ("Gjjj", (Tab::Segments, "pinion", 3, 0)),
    ("Gg", (Tab::Segments, "pinion", 0, 0)),
    ("<PgDn>", (Tab::Segments, "pinion", 3, 0)),
    ("<End>", (Tab::Segments, "pinion", 0, 4)),
    ("<End>lll", (Tab::Segments, "pinion", 0, 4)),
    ("<End><Home>", (Tab::Segments, "pinion", 0, 0)),
    ("<End><Tab>", (Tab::Segments, "pinion", 1, 0)),
    ("j<S-Tab>", (Tab::Segments, "pinion", 0, 4)),
    ("<S-Tab>", (Tab::Segments, "pinion", 0, 0)),
    ("p", (Tab::Segments, "gear", 0, 0)),
    ("jjppl", (Tab::Segments, "pinion", 2, 1)),
    ("<F2>", (Tab::Bearings, "pinion", 0, 0)),
    ("[", (Tab::Design, "pinion", 0, 0)),
    ("jj<F8>jj<F1>", (Tab::Segments, "pinion", 2, 0)),
    ("jj<F8>jjj<F1>l<F8>", (Tab::Design, "pinion", 3, 0)),
    // accepting moves on
    ("c4<Enter>", (Tab::Segments, "pinion", 1, 0)),
    ("c4<Tab>", (Tab::Segments, "pinion", 0, 1)),
    // undo and redo go where something changed
    ("jlc4<Enter><F8>u", (Tab::Segments, "pinion", 1, 1)),
    ("<F5>pjc4<Enter><F1>u<F1>p<Ctrl-r>", (Tab::Drives, "gear", 1, 0)),
    // rows stay under the cursor
    ("jJ", (Tab::Segments, "pinion", 2, 0)),
    ("jjKK", (Tab::Segments, "pinion", 0, 0)),
    ("jY", (Tab::Segments, "pinion", 2, 0)),
    ("ja", (Tab::Segments, "pinion", 2, 0)),
    ("jA", (Tab::Segments, "pinion", 1, 0)),
    ("GD", (Tab::Segments, "pinion", 2, 0)),
];

#[test]
fn keys_move_the_cursor() {
    for (keys, (tab, side, row, column)) in PLACES {
        let (mut screen, _) = opened(80, 24, UNICODE);
        screen.keys(keys);
        let editing = editing(&screen);
        let cursor = editing.cursor();
        assert_eq!(
            (editing.tab, editing.side.name(), cursor.row, cursor.column),
            (*tab, *side, *row, *column),
            "{keys}"
        );
    }
}

#[test]
fn escape_goes_back_one_level_and_edits_stay() {
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.keys("c4<Enter><F2>lll<Enter>");
    assert_eq!(screen.app.mode, Mode::Choice);
    screen.keys("<Esc>?");
    assert_eq!(screen.app.mode, Mode::Help);
    screen.keys("<Esc>");
    assert_eq!(screen.app.mode, Mode::Table);
    screen.keys("<Esc>");
    assert_eq!(screen.app.mode, Mode::Library);
    let row = screen.text().lines().find(|line| line.contains('▌')).unwrap().to_owned();
    assert!(row.contains("overhung-ela") && row.contains(" * "), "{row}");
    screen.keys("j<Enter><Esc>k<Enter>");
    assert!(editing(&screen).editor.text().contains("length_mm = 4"));
    assert_eq!(editing(&screen).tab, Tab::Bearings);
}

#[test]
fn an_edit_is_solved_at_once_over_the_saved_state() {
    let (mut screen, _) = opened(120, 40, UNICODE);
    assert!(screen.text().contains("trust up to 2,997 Hz,"), "{}", screen.text());
    assert!(!screen.text().contains("saved"), "{}", screen.text());
    screen.keys("<F2>llllc2e8<Enter>");
    let text = screen.text();
    assert!(text.contains("(was 2,997)") && text.contains("FE saved") && text.contains('·'), "{text}");
    assert!(!text.contains("stale"), "{text}");
    screen.keys("u");
    assert!(!screen.text().contains("was") && !screen.text().contains("stale"), "{}", screen.text());
    // a name has no mechanics
    screen.effects.clear();
    screen.keys("<F8>cother<Enter>");
    assert!(!screen.effects.iter().any(|effect| matches!(effect, Effect::SolveEdited(_))));
    assert!(!screen.text().contains("stale"), "{}", screen.text());
}

#[test]
fn errors_stop_solving_and_say_why() {
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.effects.clear();
    screen.keys("lc-5<Enter>k");
    let text = screen.text();
    assert!(text.contains("stale, not solved: 1 error") && text.contains("must be greater than 0"), "{text}");
    assert!(text.contains("-5]×"), "{text}");
    assert!(!screen.effects.iter().any(|effect| matches!(effect, Effect::SolveEdited(_))));
    screen.keys("=");
    assert!(screen.text().contains("not solved: 1 error in the design"), "{}", screen.text());
    // the list leads to the cell
    screen.keys("<F8>f");
    assert!(screen.text().contains("pinion.segment[0].outer_diameter_mm"), "{}", screen.text());
    screen.keys("<Enter>");
    assert_eq!((editing(&screen).tab, editing(&screen).cursor().column), (Tab::Segments, 1));
    screen.keys("c44<Enter>");
    assert!(!screen.text().contains("stale"), "{}", screen.text());
}

/// The job that some keys ask for.
fn job(screen: &mut Screen, keys: &str) -> EditedJob {
    screen.effects.clear();
    screen.keys(keys);
    let job = screen.effects.iter().rev().find_map(|effect| match effect {
        Effect::SolveEdited(job) => Some(job.clone()),
        _ => None,
    });
    job.unwrap()
}

#[test]
fn keys_are_answered_and_older_results_refused_while_the_solver_is_held() {
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.held = true;
    let older = job(&mut screen, "<F2>llllc2e8<Enter>");
    assert!(screen.text().contains("stale, solving 0 %"), "{}", screen.text());
    screen.send(Message::Progress { ticket: older.ticket, done: 0.37 });
    assert!(screen.text().contains("stale, solving 37 %"), "{}", screen.text());
    screen.keys("kc3");
    assert!(screen.text().contains("[3 "), "{}", screen.text());
    let newer = job(&mut screen, "e9<Enter>");
    assert!(newer.ticket > older.ticket);
    // the older one's progress and result come too late
    screen.send(Message::Progress { ticket: older.ticket, done: 0.99 });
    screen.perform_edited(&older);
    screen.draw();
    assert!(screen.text().contains("stale, solving 0 %"), "{}", screen.text());
    screen.perform_edited(&newer);
    screen.draw();
    assert!(!screen.text().contains("stale"), "{}", screen.text());
    let shown = editing(&screen).solving.current.as_ref().unwrap();
    assert_eq!(*shown.design, *newer.design);
    screen.perform_edited(&older);
    assert_eq!(*editing(&screen).solving.current.as_ref().unwrap().design, *newer.design);
}

#[test]
fn solving_can_be_stopped_turned_off_and_asked_for() {
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.held = true;
    let stopped = job(&mut screen, "lc45<Enter>");
    screen.keys("X");
    assert!(screen.effects.contains(&Effect::CancelSolve));
    assert!(screen.text().contains("stale: = solves"), "{}", screen.text());
    screen.perform_edited(&stopped);
    screen.draw();
    assert!(screen.text().contains("stale"), "{}", screen.text());
    screen.held = false;
    screen.keys("=");
    assert!(!screen.text().contains("stale"), "{}", screen.text());
    screen.keys("Lc41.5<Enter>");
    assert!(screen.text().contains("live off") && screen.text().contains("stale"), "{}", screen.text());
    screen.keys("=");
    assert!(!screen.text().contains("stale"), "{}", screen.text());
    screen.keys("c37<Enter>L");
    assert!(!screen.text().contains("stale") && !screen.text().contains("live off"), "{}", screen.text());
}

#[test]
fn saving_writes_the_text_and_never_over_what_someone_else_wrote() {
    let (mut screen, shelf) = opened(80, 24, UNICODE);
    screen.keys("s");
    assert!(screen.text().contains("nothing to save"));
    screen.keys("c40<Enter>s");
    assert!(screen.text().contains("saved overhung-elastic.toml"), "{}", screen.text());
    assert_eq!(shelf.text("overhung-elastic").unwrap(), editing(&screen).editor.text());
    assert!(!screen.text().lines().next().unwrap().contains('*'));
    // undo goes back behind the saving
    screen.keys("u");
    assert!(screen.text().lines().next().unwrap().contains('*'));
    shelf.texts.lock().unwrap().insert(paths(&["overhung-elastic"])[0].clone(), "# mine\n".into());
    screen.keys("s");
    assert!(
        screen.text().contains("changed on disk") && screen.text().contains("save these edits as a variant"),
        "{}",
        screen.text()
    );
    assert_eq!(shelf.text("overhung-elastic").unwrap(), "# mine\n");
}

#[test]
fn a_variant_is_written_beside_its_parent_and_opens() {
    let (mut screen, shelf) = opened(80, 24, UNICODE);
    screen.keys("c40<Enter>S<Ctrl-u>");
    assert!(screen.text().contains("a name is wanted"), "{}", screen.text());
    screen.keys("<Enter>straddle-elastic<Enter>");
    assert!(screen.text().contains("already"), "{}", screen.text());
    screen.keys("<Ctrl-u>longer<Tab>4 mm more<Enter>");
    let text = screen.text();
    assert!(text.contains("longer") && text.contains("a variant of overhung-elastic"), "{text}");
    assert!(!text.lines().next().unwrap().contains('*'), "{text}");
    let variant = shelf.text("longer").unwrap();
    assert!(variant.contains("length_mm = 40") && variant.contains("4 mm more"), "{variant}");
    assert!(!shelf.text("overhung-elastic").unwrap().contains("length_mm = 40\n"));
    // its history came along
    screen.keys("uu");
    assert_eq!(editing(&screen).editor.text(), shelf.text("overhung-elastic").unwrap());
    screen.keys("<Ctrl-r><Ctrl-r><Esc>");
    assert_eq!(screen.selected(), "longer");
    assert!(!screen.text().contains(" *"), "{}", screen.text());
}

#[test]
fn quitting_with_unsaved_edits_asks() {
    let quits = |screen: &Screen| screen.effects.contains(&Effect::Quit(Ending::Quit));
    for (keys, leaves, saved) in [
        ("q", true, false),
        ("c40<Enter>q", false, false),
        ("c40<Enter>q<Esc>", false, false),
        ("c40<Enter><Ctrl-c><Ctrl-c>", false, false),
        ("c40<Enter>qd", true, false),
        ("c40<Enter>qs", true, true),
        ("c40<Enter><Esc>qs", true, true),
        ("c40<Enter>uq", true, false),
        ("c4q", false, false),
    ] {
        let (mut screen, shelf) = opened(80, 24, UNICODE);
        screen.keys(keys);
        assert_eq!(quits(&screen), leaves, "{keys}");
        assert_eq!(shelf.text("overhung-elastic").unwrap().contains("length_mm = 40\n"), saved, "{keys}");
    }
    // one that cannot be saved keeps the program there
    let (mut screen, shelf) = opened(80, 24, UNICODE);
    screen.keys("c40<Enter>");
    shelf.texts.lock().unwrap().clear();
    screen.keys("qs");
    assert!(!quits(&screen) && screen.text().contains("not saved"), "{}", screen.text());
}

/// Solves until it is told to stop, unless the pinion's first segment is 42 mm long.
struct Endless {
    started: Sender<()>,
}

impl Backend for Endless {
    fn load(&self, _: &Path) -> Result<LoadedDesign, BrokenDesign> {
        panic!("an edited design is not read")
    }

    fn compare(&self, design: &Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        self.started.send(()).unwrap();
        if design.pinion.segments[0].length == 0.042 {
            return compare_over(design, None, observer);
        }
        while observer(0.5).is_continue() {
            std::thread::sleep(Duration::from_millis(1));
        }
        Err(SolveError::Cancelled)
    }
}

#[test]
fn a_newer_request_ends_the_older_one_and_so_does_the_key() {
    const LONG: Duration = Duration::from_secs(20);
    let (started, solving) = channel();
    let (sender, messages) = channel();
    let worker = Worker::start(Arc::new(Endless { started }), &sender).unwrap();
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.held = true;
    let hand_over = |screen: &mut Screen, keys: &str| {
        screen.effects.clear();
        screen.keys(keys);
        for effect in screen.effects.drain(..) {
            match effect {
                Effect::SolveEdited(job) => worker.solve_edited(job),
                Effect::CancelSolve => worker.cancel(),
                _ => {}
            }
        }
    };
    hand_over(&mut screen, "c41<Enter>k");
    solving.recv_timeout(LONG).unwrap();
    // it is followed in percent, and keys are answered meanwhile
    screen.send(messages.recv_timeout(LONG).unwrap());
    let text = screen.text();
    assert!(text.contains("stale, solving 50 %") && text.contains("X stop solving"), "{text}");
    hand_over(&mut screen, "lll");
    hand_over(&mut screen, "hhhX");
    assert!(screen.text().contains("stopped solving"), "{}", screen.text());
    hand_over(&mut screen, "c41.5<Enter>k");
    solving.recv_timeout(LONG).unwrap();
    hand_over(&mut screen, "c42<Enter>");
    solving.recv_timeout(LONG).unwrap();
    loop {
        let message = messages.recv_timeout(LONG).unwrap();
        let is_last = matches!(message, Message::SolvedEdited { .. });
        screen.send(message);
        if is_last {
            break;
        }
    }
    assert!(!screen.text().contains("stale"), "{}", screen.text());
    assert!(messages.try_recv().is_err());
}

/// Something else that the cell may hold.
fn another(cell: &Cell) -> String {
    let old = cell.shown.text();
    match cell.kind {
        CellKind::Number(_, limit) => if limit.allows(7.5) { "7.5" } else { "0.25" }.into(),
        CellKind::VectorEntry(_) | CellKind::MatrixEntry(..) => "0.5".into(),
        CellKind::Whole(low, high) => {
            [3, low].into_iter().find(|number| (low..=high).contains(number)).unwrap().to_string()
        }
        CellKind::Text | CellKind::Name => "quite \"another\" #1 = [x]".into(),
        CellKind::Texts => "one, two".into(),
        CellKind::Choice(_) | CellKind::Model(_) => {
            let words = cell.kind.words();
            let next = words.iter().position(|word| *word == old).map_or(0, |at| at + 1);
            words[next % words.len()].into()
        }
        CellKind::Flags(_) => "x".into(),
    }
}

/// Goes to a place by keys.
fn go(screen: &mut Screen, row: usize, column: usize) {
    screen.keys("g");
    screen.keys(&"j".repeat(row));
    screen.keys("<Home>");
    while editing(screen).cursor().column < column {
        screen.keys("l");
    }
    assert_eq!((editing(screen).cursor().row, editing(screen).cursor().column), (row, column));
}

/// Changes what is under the cursor by keys, sees it in the text, and takes it back.
fn change(screen: &mut Screen, cell: &Cell) {
    // the number of the format can be no other
    if matches!(cell.kind, CellKind::Whole(low, high) if low == high) {
        return;
    }
    // nor what follows from gear data
    if cell.shown.is_derived() {
        return;
    }
    // nor the only word that there is
    if matches!(cell.kind, CellKind::Choice(_)) && cell.kind.words() == [cell.shown.text()] {
        return;
    }
    let before = editing(screen).editor.text().to_owned();
    let new = another(cell);
    let keys = match cell.kind {
        CellKind::Choice(_) | CellKind::Model(_) => " ".to_owned(),
        CellKind::Flags(_) if cell.shown.text() == "x" => "<Enter>j <Enter>".into(),
        CellKind::Flags(_) => {
            // ticks off what is on, and x on
            let ticked = |word: &str| cell.shown.text().contains(word);
            let keys = [("x", !ticked("x")), ("y", ticked("y")), ("z", ticked("z"))];
            let keys: String = keys.iter().map(|(_, press)| if *press { " j" } else { "j" }).collect();
            format!("<Enter>{keys}<Enter>")
        }
        _ => format!("c{new}<Enter>"),
    };
    screen.keys(&keys);
    let path = &cell.path;
    let text = editing(screen).editor.text().to_owned();
    assert!(new != cell.shown.text() || !cell.shown.is_written(), "{path}: nothing else to type");
    assert_ne!(text, before, "{path}: {keys}: {}", screen.text());
    let sheet = Sheet::all().into_iter().find(|sheet| editing(screen).editor.grid(sheet).cell(path).is_some());
    let sheet = sheet.unwrap_or_else(|| panic!("{path}"));
    let shown = editing(screen).editor.grid(&sheet).cell(path).unwrap().shown.text().to_owned();
    if !matches!(cell.kind, CellKind::Flags(_)) {
        assert_eq!(shown, new, "{path}");
    }
    screen.keys("u");
    assert_eq!(editing(screen).editor.text(), before, "{path}");
}

#[test]
fn every_cell_of_every_table_is_reached_by_keys_changed_and_taken_back() {
    let mut seen = std::collections::BTreeSet::new();
    for (stem, prepare) in [
        ("overhung-elastic", ""),
        ("overhung-rigid", ""),
        ("overhung-elastic", "<F2>lll "),
        ("straddle-helical", ""),
        ("tapered-hypoid", ""),
    ] {
        let (mut screen, _) = opened(80, 24, ASCII);
        screen.keys("L<Esc>");
        while screen.selected() != stem {
            screen.keys("j");
        }
        screen.keys("e");
        screen.keys(prepare);
        for (tab, side) in ["<F1>", "<F2>", "<F3>", "<F4>", "<F5>", "<F6>", "<F7>", "<F8>"]
            .into_iter()
            .flat_map(|tab| ["", "p"].map(|side| (tab, side)))
        {
            screen.keys(tab).keys(side);
            let view = editing(&screen).view.clone();
            for (row, column) in
                (0..view.rows.len()).flat_map(|row| (0..view.rows[row].places.len()).map(move |column| (row, column)))
            {
                let cell = match view.place(row, column) {
                    None => continue,
                    Some(Place::Name) => {
                        go(&mut screen, row, column);
                        continue;
                    }
                    Some(Place::Matrix) => {
                        go(&mut screen, row, column);
                        screen.keys("<Enter>");
                        for at in 0..36 {
                            let cell = view.matrix_entry(row, (at / 6, at % 6)).unwrap();
                            screen.keys("g<Home>").keys(&"<Tab>".repeat(at));
                            assert_eq!(editing(&screen).entry().unwrap().path, cell.path);
                            change(&mut screen, cell);
                            seen.insert((cell.column.key, cell.column.label.clone()));
                        }
                        screen.keys("<Esc>");
                        continue;
                    }
                    Some(Place::Cell(_)) => view.cell(row, column).unwrap(),
                };
                go(&mut screen, row, column);
                change(&mut screen, cell);
                seen.insert((cell.column.key, cell.column.label.clone()));
            }
            screen.keys(side);
        }
    }
    let keys: std::collections::BTreeSet<&str> = seen.iter().map(|(key, _)| *key).collect();
    let fields = ROOT
        .walk()
        .into_iter()
        .flat_map(|table| table.fields)
        .filter(|field| !matches!(field.kind, Kind::Table(_) | Kind::Tables(..) | Kind::NamedTables(_)));
    assert_eq!(keys, fields.map(|field| field.key).collect());
    let entries = |wanted: &str| seen.iter().filter(|(key, _)| *key == wanted).count();
    assert_eq!((entries("stiffness"), entries("point_mm"), entries("line_of_action")), (36, 3, 3));
}

#[test]
fn both_mirrored_entries_change_and_what_is_no_stiffness_says_so() {
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.keys("<F2>lll l<Enter>lc1e8<Enter>");
    let text = editing(&screen).editor.text().to_owned();
    assert_eq!(text.matches("1e8").count(), 2, "{text}");
    assert!(!screen.text().contains("semidefinite"), "{}", screen.text());
    screen.keys("kc9e9<Enter>");
    assert!(screen.text().contains("semidefinite"), "{}", screen.text());
    screen.keys("u");
    assert_eq!(screen.app.mode, Mode::Matrix);
    assert!(!screen.text().contains("semidefinite"), "{}", screen.text());
}

#[test]
fn materials_come_get_names_and_go() {
    let (mut screen, _) = opened(80, 24, UNICODE);
    screen.keys("<F7>atitanium<Enter>");
    assert!(editing(&screen).editor.text().contains("[material.titanium]"), "{}", editing(&screen).editor.text());
    screen.keys("<F1><End>hctitanium<Enter><F7>j<Home><Enter><Ctrl-u>ti<Enter>");
    let text = editing(&screen).editor.text().to_owned();
    assert!(text.contains("[material.ti]") && text.contains("material = \"ti\""), "{text}");
    screen.keys("GD");
    assert!(screen.text().contains("1 finding"), "{}", screen.text());
    screen.keys("uuuu");
    assert!(!editing(&screen).is_modified());
}

#[test]
fn the_side_view_points_at_what_the_cursor_is_on() {
    for (keys, label) in [
        ("jj", "pinion segment 3"),
        ("<F2>j", "pinion tail bearing"),
        ("<F3>", "pinion head"),
        ("<F4>", "pinion mesh"),
        ("<F5>p", "gear drive"),
    ] {
        for (capabilities, pointer) in [(UNICODE, "▼"), (ASCII, "v")] {
            let (mut screen, _) = opened(120, 40, capabilities);
            let text = screen.keys(keys).text();
            let (_, below) = text.split_once(&format!("Side view: {label}")).unwrap_or_else(|| panic!("{text}"));
            assert!(below.contains(pointer), "{text}");
        }
    }
}

/// The states that are drawn at every size and in every colour.
const STATES: [&str; 16] = [
    "",
    "jj",
    "<F2>",
    "<F2><End>",
    "<F2>lllc4",
    "<F2>lll<Enter>",
    "<F2>lll l<Enter>",
    "<F2>lll l<Enter>c1 kg<Enter>",
    "<F4>jjj",
    "<F6><Enter>",
    "<F8>",
    "lc-5<Enter>f",
    "c3 kg<Enter>",
    "S",
    "c4<Enter>q",
    "<F7>a",
];

#[test]
fn no_size_panics_and_ascii_is_ascii() {
    for keys in STATES {
        for capabilities in [UNICODE, ASCII] {
            let (mut screen, _) = opened(80, 24, capabilities);
            screen.keys(keys);
            let sizes = (1..=130).step_by(3).flat_map(|width| [1, 18, 24, 50].map(|height| (width, height)));
            let sizes = sizes.chain((1..=60).flat_map(|height| [60, 80, 120].map(|width| (width, height))));
            for (width, height) in sizes {
                screen.resize(width, height);
                let text = screen.text();
                assert!(!capabilities.ascii || text.is_ascii(), "{keys}: {text}");
                assert_eq!(text.lines().count(), usize::from(height));
            }
        }
    }
}

#[test]
fn colours_change_no_text() {
    for keys in STATES {
        let text = |colour, background| {
            let (mut screen, _) = opened(80, 24, Capabilities { colour, background, ascii: false });
            screen.keys(keys).text()
        };
        let plain = text(ColourDepth::None, Background::Unknown);
        assert_eq!(text(ColourDepth::True, Background::Light), plain, "{keys}");
        assert_eq!(text(ColourDepth::Sixteen, Background::Dark), plain, "{keys}");
    }
}

#[test]
fn escape_sequences_in_values_never_reach_the_screen() {
    let text = Shelf::shipped().text("overhung-elastic").unwrap();
    let hostile = r#""a\u001b[31m\u009b2J\u202ec\rd\u200b\n""#;
    let text = text
        .replace("\"Both overhung, elastic bearings\"", hostile)
        .replace("\"head bearing\"", hostile)
        .replace("\"diagonal\"\nkx_n_per_m = 5.0e8", &format!("{hostile}\nkx_n_per_m = 5.0e8"))
        .replace("\"ring gear\"", hostile);
    let text = format!("{text}\n[material.{hostile}]\ndensity_kg_per_m3 = 1.0\n");
    let shelf = Shelf::new(&[("fine", &text)]);
    let mut screen = Screen::with(&["fine"], 120, 40, UNICODE, shelf);
    screen.keys("e");
    for keys in [
        "<F2>",
        "<Enter>",
        "x<Enter>",
        "u",
        "j",
        "<F8>",
        "<Enter>",
        "<Esc>",
        "<F3>p",
        "<F7>j",
        "<Enter><Esc>",
        "f",
        "j",
        "<Enter>",
        "q",
    ] {
        screen.keys(keys);
        for cell in screen.buffer().content() {
            let harmful = |letter: char| {
                letter.is_control() || matches!(letter, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}')
            };
            assert!(!cell.symbol().contains(harmful), "{keys}: {:?}", cell.symbol());
        }
    }
}

#[test]
fn a_file_that_is_no_toml_or_is_gone_is_not_opened() {
    let shelf = Shelf::new(&[("fine", "format = "), ("typo", "format = 1\nname = 3\n")]);
    let mut screen = Screen::with(&["fine", "gone", "typo"], 80, 24, UNICODE, shelf);
    for keys in ["e", "je"] {
        screen.keys(keys);
        assert!(screen.app.editors.open().is_none());
        assert!(screen.text().contains("no tables"), "{}", screen.text());
    }
    // one with errors is: that is what the editor is for
    screen.keys("je");
    assert!(screen.text().contains("findings (f)"), "{}", screen.text());
}

#[test]
fn segments_80x24_ascii() {
    assert_snapshot!(opened(80, 24, ASCII).0.keys("jjlc38<Tab>").text());
}

#[test]
fn bearings_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("<F2>llll<Enter><Ctrl-u>750 N/u").text());
}

#[test]
fn bearings_120x40() {
    assert_snapshot!(opened(120, 40, UNICODE).0.keys("<F2>llllc2e8<Enter>").text());
}

#[test]
fn mesh_80x24_ascii() {
    assert_snapshot!(opened(80, 24, ASCII).0.keys("<F4>jj").text());
}

#[test]
fn matrix_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("<F2>lll l<Enter>lc9e9<Enter>").text());
}

#[test]
fn findings_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("lc-5<Enter>c-6<Enter>fj").text());
}

#[test]
fn wrong_input_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("c3 kg<Enter>").text());
}

#[test]
fn variant_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("S<Ctrl-u>a/b").text());
}

#[test]
fn leave_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("c4<Enter>q").text());
}

#[test]
fn segments_60x18() {
    assert_snapshot!(opened(60, 18, UNICODE).0.text());
}

#[test]
fn design_120x40_ascii() {
    assert_snapshot!(opened(120, 40, ASCII).0.keys("<F8>").text());
}
