//! Saving, variants, and leaving with unsaved edits.

use crate::tui_support::{Screen, UNICODE, paths};
use crate::{editing, opened};
use bevelscope::tui::message::{Effect, Ending};

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
