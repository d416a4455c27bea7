//! Typing is the same wherever something is typed.
#![allow(clippy::unwrap_used, reason = "a test may")]

mod tui_support;

use bevelscope::tui::editor::Layer;
use bevelscope::tui::keymap::Mode;
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
