//! Variants and the design that they came from, through the whole explorer.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod tui_support;

use tui_support::{Screen, Shelf, UNICODE};

const BASE: &str = bevelscope::design::library::SHIPPED[0].text;

/// A variant of `base` with a word in its note.
fn variant(note: &str) -> String {
    format!("parent = \"base\"\nnote = \"{note}\"\n{BASE}")
}

/// A design, three variants of it, and one of another design.
fn family() -> (Screen, Shelf) {
    let shelf = Shelf::new(&[
        ("base", BASE),
        ("one", &variant("first")),
        ("other", &variant("of another").replace("\"base\"", "\"bas\"")),
        ("stuck", &variant("locked")),
        ("two", &variant("second")),
    ]);
    let screen = Screen::with(&["base", "one", "other", "stuck", "two"], 80, 24, UNICODE, shelf.clone());
    (screen, shelf)
}

fn select(screen: &mut Screen, stem: &str) {
    screen.keys("g");
    while screen.selected() != stem {
        let before = screen.selected();
        screen.keys("j");
        assert_ne!(before, screen.selected(), "no {stem}");
    }
}

#[test]
fn variants_follow_the_new_name_of_their_parent_with_what_is_not_saved_in_them() {
    let (mut screen, shelf) = family();
    // one with an edit that is not saved, one that was only looked at
    select(&mut screen, "one");
    screen.keys("ec40<Enter><Esc>");
    select(&mut screen, "two");
    screen.keys("e<Esc>");
    select(&mut screen, "base");
    screen.keys("r<Ctrl-u>mother<Enter>");
    let said = screen.app.messages.text();
    assert!(said.contains("renamed base to mother; 2 variants follow"), "{said}");
    assert!(said.contains("stuck still names base as its parent: it is locked"), "{said}");
    assert_eq!(screen.selected(), "mother");
    for (stem, parent) in [("one", "mother"), ("two", "mother"), ("stuck", "base"), ("other", "bas")] {
        assert!(shelf.text(stem).unwrap().starts_with(&format!("parent = \"{parent}\"")), "{stem}");
    }
    // in the tree as well
    let tree: Vec<String> =
        screen.app.library.visible().map(|shown| format!("{}{}", shown.depth, shown.row.stem)).collect();
    assert_eq!(tree, ["0mother", "1one", "1two", "0other", "0stuck"]);
    let one = screen.app.editors.get(&tui_support::paths(&["one"])[0]).unwrap();
    assert!(one.is_modified() && one.editor.text().starts_with("parent = \"mother\""), "{}", one.editor.text());
    let two = screen.app.editors.get(&tui_support::paths(&["two"])[0]).unwrap();
    assert!(!two.is_modified() && two.editor.text() == shelf.text("two").unwrap());
    // the edit is still there, and saves on the file as it is now
    select(&mut screen, "one");
    screen.keys("es");
    assert_eq!(
        shelf.text("one").unwrap(),
        variant("first").replace("\"base\"", "\"mother\"").replacen("36.0", "40", 1)
    );
}
