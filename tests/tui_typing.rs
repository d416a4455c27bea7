//! Typing is the same wherever something is typed.
#![allow(clippy::unwrap_used, reason = "a test may")]

mod tui_support;

use bevelscope::tui::caps::{Capabilities, ColourDepth};
use bevelscope::tui::editor::Layer;
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::message::Message;
use ratatui::style::Modifier;
use tui_support::{Screen, Shelf, UNICODE};

fn screen() -> Screen {
    let shelf = Shelf::shipped();
    let stems = shelf.stems();
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    Screen::with(&stems, 80, 24, UNICODE, shelf)
}

/// What is being typed.
fn typed(screen: &Screen) -> String {
    let app = &screen.app;
    let editing = app.editors.open();
    let text = match app.mode {
        Mode::Filter => app.library.filter(),
        Mode::HelpSearch => app.help_search.field.text(),
        Mode::Palette => app.palette.typed.text(),
        Mode::Name => app.form.as_ref().unwrap().field.text(),
        Mode::Cell => editing.unwrap().input.as_ref().unwrap().line.text(),
        Mode::Form => {
            let Some(Layer::Form(form)) = &editing.unwrap().layer else { return String::new() };
            form.name.text()
        }
        mode => return format!("nothing in {mode:?}"),
    };
    text.to_owned()
}

#[test]
fn every_line_has_the_same_keys() {
    for (mode, open) in [
        (Mode::Filter, "/"),
        (Mode::HelpSearch, "?/"),
        (Mode::Palette, ":"),
        (Mode::Name, "r"),
        (Mode::Cell, "ec"),
        (Mode::Form, "eS"),
    ] {
        let mut screen = screen();
        screen.keys(open).keys("<Ctrl-u>");
        assert_eq!((screen.app.mode, typed(&screen).as_str()), (mode, ""));
        for (keys, text) in [
            ("one two", "one two"),
            // what is before the cursor goes, and no more
            ("<Left><Left><Ctrl-u>", "wo"),
            ("<End>x<Home>t", "twox"),
            ("<Delete>", "tox"),
            ("<Right><Backspace>", "tx"),
            ("<Ctrl-e> and<Ctrl-a>s", "stx and"),
            ("<Ctrl-e><Ctrl-w>", "stx "),
            ("<Ctrl-w><Ctrl-w>", ""),
        ] {
            assert_eq!(typed(screen.keys(keys)), text, "{mode:?} {keys}");
        }
    }
}

#[test]
fn the_cursor_of_the_filter_is_where_it_types() {
    let mut screen = screen();
    screen.keys("/ovhg<Left><Left>er");
    let cursor = screen.terminal.get_cursor_position().unwrap();
    assert_eq!((cursor.x, cursor.y), (2 + 4, 23));
    assert!(screen.text().contains(" /overhg"), "{}", screen.text());
}

/// In the tables and in the matrix alike.
#[test]
fn any_digit_begins_a_number() {
    let mut screen = screen();
    screen.keys("e<F2>lll l<Enter>5");
    assert_eq!((screen.app.mode, typed(&screen).as_str()), (Mode::Cell, "5"));
    screen.keys("<Esc><Esc>9");
    assert_eq!(screen.app.mode, Mode::Table, "the name of a model is no number");
    screen.keys("<F1>19");
    assert_eq!((screen.app.mode, typed(&screen).as_str()), (Mode::Cell, "19"));
}

/// Keys that open a prompt with a text in it, that text, and another one.
const PROPOSED: [[&str; 3]; 7] = [
    ["Bt", "300.0", "600"],
    ["Mf<Ctrl-u>1500<Enter>f", "1500.00", "900"],
    ["r", "tapered-axle", "soft"],
    ["Y", "tapered-axle-2", "soft"],
    [":export-shown<Enter>", "tapered-axle.html", "boss.html"],
    ["eS", "tapered-axle-variant", "soft"],
    ["PK<Tab>", " deg", "20"],
];

fn in_prompt(keys: &str) -> Screen {
    let without = Capabilities { colour: ColourDepth::None, ..UNICODE };
    let mut screen = Screen::with(&["tapered-axle"], 80, 24, without, Shelf::shipped());
    screen.keys(keys);
    screen
}

/// The line that the cursor is in, and whether what stands before the cursor is shown as selected.
fn prompt(screen: &mut Screen) -> (String, bool) {
    let cursor = screen.terminal.get_cursor_position().unwrap();
    assert!(cursor.x > 0, "no cursor in {:?}: {}", screen.app.mode, screen.text());
    let before = screen.buffer().cell((cursor.x - 1, cursor.y)).unwrap().modifier;
    (screen.line(cursor.y), before.contains(Modifier::REVERSED))
}

#[test]
fn what_is_typed_or_pasted_first_takes_the_place_of_what_a_prompt_proposes() {
    for [open, proposed, other] in PROPOSED {
        let mut screen = in_prompt(open);
        let (line, is_selected) = prompt(&mut screen);
        assert!(line.contains(proposed) && is_selected, "{open}: {line}");
        let (line, is_selected) = prompt(screen.keys(other));
        assert!(line.contains(other) && !line.contains(proposed) && !is_selected, "{open}: {line}");
        let mut screen = in_prompt(open);
        screen.send(Message::Paste(other.into()));
        let (line, _) = prompt(&mut screen);
        assert!(line.contains(other) && !line.contains(proposed), "{open}: {line}");
    }
}

#[test]
fn what_a_prompt_proposes_is_kept_by_any_other_key() {
    for [open, proposed, _] in PROPOSED {
        for (keys, kept) in [("<Left><Right>7", proposed), ("<Home>7", proposed), ("<Backspace>7", &proposed[..3])] {
            let mut screen = in_prompt(open);
            let (line, is_selected) = prompt(screen.keys(keys));
            assert!(line.contains(kept) && line.contains('7') && !is_selected, "{open} {keys}: {line}");
        }
    }
    // what was typed and refused is not taken for a proposal
    let mut screen = in_prompt("Bt600 kg<Enter>");
    let (line, _) = prompt(screen.keys("m"));
    assert!(line.contains("600 kgm"), "{line}");
}

#[test]
fn between_two_lines_the_one_with_the_cursor_is_selected() {
    let mut screen = in_prompt("eSsoft<Tab>a note<Tab>hard");
    assert_eq!(typed(&screen), "hard");
    screen.keys("<Tab>b");
    let text = screen.text();
    assert!(text.contains("[hard") && text.contains("note [b "), "{text}");
}
