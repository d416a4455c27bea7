//! Variants and the design that they came from, through the whole explorer.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod tui_support;

use bevelscope::tui::message::Effect;
use tui_support::{Screen, Shelf, UNICODE, paths};

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
    let one = screen.app.editors.get(&paths(&["one"])[0]).unwrap();
    assert!(one.is_modified() && one.editor.text().starts_with("parent = \"mother\""), "{}", one.editor.text());
    let two = screen.app.editors.get(&paths(&["two"])[0]).unwrap();
    assert!(!two.is_modified() && two.editor.text() == shelf.text("two").unwrap());
    // the edit is still there, and saves on the file as it is now
    select(&mut screen, "one");
    screen.keys("es");
    assert_eq!(
        shelf.text("one").unwrap(),
        variant("first").replace("\"base\"", "\"mother\"").replacen("36.0", "40", 1)
    );
}

#[test]
fn edits_that_are_not_saved_are_compared_and_named_so() {
    let (mut screen, _) = family();
    select(&mut screen, "one");
    screen.keys("c");
    assert!(screen.text().contains("A base   B one\n"), "{}", screen.text());
    assert!(!screen.text().contains("length"), "{}", screen.text());
    screen.keys("<Esc>ec40<Enter><Esc>c");
    assert!(screen.text().contains("A base   B one (unsaved edits)"), "{}", screen.text());
    let line = screen.text().lines().find(|line| line.contains("length")).map(str::to_owned);
    assert!(line.is_some_and(|line| line.contains("36.0") && line.contains("40 ")), "{}", screen.text());
    let result = screen.app.compare.as_ref().unwrap().result.clone().unwrap();
    assert!(result.fe_rms_db.unwrap() > 0.0, "solved as it is edited");
    // what cannot be solved as it is now says why, and what differs all the same
    screen.keys("<Esc>ec-4<Enter><Esc>c");
    let text = screen.text();
    assert!(text.contains("B: ") && text.contains("greater than 0") && text.contains("-4"), "{text}");
}

#[test]
fn the_two_that_are_compared_can_be_swapped_before_and_after_they_are_solved() {
    let (mut screen, _) = family();
    select(&mut screen, "one");
    screen.keys("ec40<Enter><Esc>c");
    let (before, figures) = (screen.app.compare.as_ref().unwrap().result.clone().unwrap(), screen.text());
    screen.keys("x");
    assert!(screen.text().contains("A one (unsaved edits)   B base\n"), "{}", screen.text());
    let after = screen.app.compare.as_ref().unwrap().result.clone().unwrap();
    assert_eq!([&after.sides[1], &after.sides[0]], [&before.sides[0], &before.sides[1]]);
    let values = |text: &str| {
        let line = text.lines().find(|line| line.contains("length")).unwrap().to_owned();
        line.find("36.0").unwrap() < line.find("40 ").unwrap()
    };
    assert!(values(&figures) && !values(&screen.text()), "{}", screen.text());
    assert_eq!(screen.keys("x").text(), figures);
    // what is still being solved is asked for the other way round
    screen.held = true;
    screen.keys("<Esc>cx");
    let Some(Effect::Compare(job)) = screen.effects.last() else { panic!("{:?}", screen.effects.last()) };
    assert_eq!(job.paths, [paths(&["one"])[0].clone(), paths(&["base"])[0].clone()]);
    assert!(job.unsaved[0].is_some() && job.unsaved[1].is_none());
}
