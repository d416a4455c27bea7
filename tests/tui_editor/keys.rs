//! Keys, and what they change in the text, where the cursor goes, and how Esc goes back.

use crate::tui_support::UNICODE;
use crate::{changed, editing, opened};
use bevelscope::tui::editor::Tab;
use bevelscope::tui::keymap::Mode;

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
