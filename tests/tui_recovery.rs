//! Unsaved edits of earlier runs, conflicts and locks: key scripts and pictures.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use std::path::PathBuf;
use std::sync::mpsc::{Receiver, channel};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use bevelscope::comparison::{Comparison, Observer, SolveError};
use bevelscope::design::Design;
use bevelscope::design::library::{LeftEdits, OnDisk, SHIPPED};
use bevelscope::tui::caps::{Background, Capabilities, ColourDepth};
use bevelscope::tui::editor::Editing;
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::message::{Effect, Ending, Message};
use bevelscope::tui::recovery::{FileState, Keeper, Kept};
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign};
use insta::assert_snapshot;
use tui_support::{ASCII, Screen, Shelf, UNICODE, paths};

const FIRST: &str = "overhung-elastic";
const COLOURS: Capabilities = Capabilities { colour: ColourDepth::True, background: Background::Dark, ascii: false };

fn base() -> &'static str {
    SHIPPED[0].text
}

fn with_length(length: &str) -> String {
    base().replacen("length_mm = 36.0", &format!("length_mm = {length}"), 1)
}

fn screen(width: u16, height: u16, capabilities: Capabilities, shelf: &Shelf) -> Screen {
    let stems = shelf.stems();
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    Screen::with(&stems, width, height, capabilities, shelf.clone())
}

fn editing(screen: &Screen) -> &Editing {
    screen.app.editors.open().unwrap()
}

fn path(stem: &str) -> PathBuf {
    paths(&[stem])[0].clone()
}

fn set(shelf: &Shelf, stem: &str, text: Option<&str>) {
    let mut texts = shelf.texts.lock().unwrap();
    match text {
        Some(text) => drop(texts.insert(path(stem), text.into())),
        None => drop(texts.remove(&path(stem))),
    }
}

fn kept(shelf: &Shelf) -> Vec<Kept> {
    std::mem::take(&mut *shelf.kept.lock().unwrap())
}

fn edits(base: &str, text: &str) -> Kept {
    Kept::Edits { path: path(FIRST), base: base.into(), text: text.into() }
}

fn nothing() -> Kept {
    Kept::Nothing { path: path(FIRST) }
}

/// Edits of the first design that an earlier run has left, over what its file holds now.
fn left(shelf: &Shelf, stem: &str, text: &str, on_disk: OnDisk) {
    let when = "2025-01-31 12:00:00 UTC, 3 hours ago".into();
    let journal = PathBuf::from(format!("/state/{stem}.journal"));
    let edits = LeftEdits { journal, path: path(stem), when, base: base().into(), text: text.into(), on_disk };
    shelf.left.lock().unwrap().edits.push(edits);
}

fn left_unchanged() -> Shelf {
    let shelf = Shelf::shipped();
    left(&shelf, FIRST, &with_length("35"), OnDisk::Text(base().into()));
    shelf
}

fn left_changed() -> Shelf {
    let shelf = Shelf::shipped();
    set(&shelf, FIRST, Some(&with_length("40.0")));
    left(&shelf, FIRST, &with_length("35"), OnDisk::Text(with_length("40.0")));
    shelf
}

fn left_gone() -> Shelf {
    let shelf = Shelf::shipped();
    set(&shelf, FIRST, None);
    left(&shelf, FIRST, &with_length("35"), OnDisk::Gone);
    shelf
}

/// Every accepted edit is kept at once, and goes when the text is as the file again.
#[test]
fn edits_are_kept_as_they_are_made() {
    let four = with_length("4");
    let five = with_length("5");
    let scripts: &[(&str, Vec<Kept>)] = &[
        ("", vec![]),
        ("c4", vec![]),
        ("c4<Esc>", vec![]),
        ("c4<Enter>", vec![edits(base(), &four)]),
        ("c4<Enter>jkp]", vec![edits(base(), &four)]),
        ("c4<Enter>kc5<Enter>", vec![edits(base(), &four), edits(base(), &five)]),
        ("c4<Enter>u", vec![edits(base(), &four), nothing()]),
        ("c4<Enter>u<Ctrl-r>", vec![edits(base(), &four), nothing(), edits(base(), &four)]),
        ("c4<Enter>s", vec![edits(base(), &four), nothing()]),
        ("c4<Enter>su", vec![edits(base(), &four), nothing(), edits(&four, base())]),
        ("c4<Enter><Esc>", vec![edits(base(), &four)]),
        ("c4<Enter>S<Ctrl-u>other<Enter>", vec![edits(base(), &four), nothing()]),
        ("c4<Enter><Esc>qd", vec![edits(base(), &four), Kept::Discarded { path: path(FIRST) }]),
        ("c4<Enter><Esc>qs", vec![edits(base(), &four), nothing()]),
    ];
    for (keys, expected) in scripts {
        let shelf = Shelf::shipped();
        let mut screen = screen(80, 24, UNICODE, &shelf);
        screen.keys("e").keys(keys);
        assert_eq!(kept(&shelf), *expected, "{keys}");
    }
}

#[test]
fn what_is_kept_is_asked_for_before_the_program_ends() {
    let shelf = Shelf::shipped();
    let mut screen = screen(80, 24, UNICODE, &shelf);
    screen.keys("ec4<Enter><Esc>q");
    screen.effects.clear();
    screen.keys("d");
    let discarded = Effect::Keep(Kept::Discarded { path: path(FIRST) });
    assert_eq!(screen.effects, [discarded, Effect::Quit(Ending::Quit)]);
}

/// Keys over the offer; what the file holds then; what the tables hold, if they are open; what was asked to be kept.
type OfferScript<'a> = (fn() -> Shelf, &'a str, Option<&'a str>, Option<&'a str>, Vec<Kept>);

#[test]
fn an_offer_is_taken_put_aside_or_left_for_later() {
    let journal = PathBuf::from("/state/overhung-elastic.journal");
    let taken = || Kept::Taken { path: path(FIRST), journal: journal.clone() };
    let mine = with_length("35");
    let theirs = with_length("40.0");
    let scripts: &[OfferScript] = &[
        (left_unchanged, "<Esc>", Some(base()), None, vec![]),
        (left_unchanged, "d", Some(base()), None, vec![Kept::Unwanted { journal: journal.clone() }]),
        (left_unchanged, "t", Some(base()), Some(&mine), vec![edits(base(), &mine), taken()]),
        (left_unchanged, "ts", Some(&mine), Some(&mine), vec![edits(base(), &mine), taken(), nothing()]),
        (left_unchanged, "tu", Some(base()), Some(base()), vec![edits(base(), &mine), taken(), nothing()]),
        (left_changed, "<Esc>", Some(&theirs), None, vec![]),
        (left_changed, "d", Some(&theirs), None, vec![Kept::Unwanted { journal: journal.clone() }]),
        // as edits over the file as it is now
        (left_changed, "t", Some(&theirs), Some(&mine), vec![edits(&theirs, &mine), taken()]),
        (left_changed, "tu", Some(&theirs), Some(&theirs), vec![edits(&theirs, &mine), taken(), nothing()]),
        (left_gone, "<Esc>", None, None, vec![]),
        (left_gone, "d", None, None, vec![Kept::Unwanted { journal: journal.clone() }]),
        (left_gone, "t", None, Some(&mine), vec![edits(base(), &mine), taken()]),
        // the file is gone, so saving asks
        (left_gone, "tsm", Some(&mine), Some(&mine), vec![edits(base(), &mine), taken(), nothing()]),
    ];
    for (made, keys, file, tables, expected) in scripts {
        let shelf = made();
        let mut screen = screen(80, 24, UNICODE, &shelf);
        assert_eq!(screen.app.mode, Mode::Recovery);
        screen.keys(keys);
        assert_eq!(shelf.text(FIRST).as_deref(), *file, "{keys}");
        assert_eq!(screen.app.editors.open().map(|editing| editing.editor.text()), *tables, "{keys}");
        assert_eq!(kept(&shelf), *expected, "{keys}");
        if keys.starts_with('t') && !keys.ends_with('u') {
            assert_eq!(editing(&screen).editor.undo_name().unwrap().as_str(), "recovered edits");
        }
    }
}

#[test]
fn an_offer_can_be_saved_as_a_variant() {
    for made in [left_unchanged, left_changed, left_gone] {
        let shelf = made();
        let before = shelf.text(FIRST);
        let mut screen = screen(80, 24, UNICODE, &shelf);
        screen.keys("S");
        assert!(screen.text().contains("overhung-elastic-recovered"), "{}", screen.text());
        screen.keys("<Ctrl-u>mine<Enter>");
        assert_eq!(shelf.text(FIRST), before);
        assert!(shelf.text("mine").unwrap().ends_with(&with_length("35")));
        let kept = kept(&shelf);
        assert!(matches!(&kept[..], [Kept::Edits { .. }, Kept::Taken { .. }, Kept::Nothing { .. }]), "{kept:?}");
        assert!(!editing(&screen).is_modified());
    }
}

#[test]
fn an_offer_does_not_take_keys_that_are_meant_for_something_else() {
    let shelf = left_unchanged();
    let offered = shelf.left.lock().unwrap().clone();
    shelf.left.lock().unwrap().edits.clear();
    let mut screen = screen(80, 24, UNICODE, &shelf);
    screen.keys("/");
    screen.send(Message::Left(offered.clone()));
    assert_eq!(screen.app.mode, Mode::Filter);
    assert!(screen.app.notice.as_ref().unwrap().text.contains(":recover shows them"));
    // it is found again when it is asked for
    screen.keys("<Esc>U");
    assert_eq!(screen.app.mode, Mode::Library);
    assert!(screen.app.notice.as_ref().unwrap().text.contains("no unsaved edits"));
    *shelf.left.lock().unwrap() = offered;
    screen.keys(":recover<Enter>");
    assert_eq!(screen.app.mode, Mode::Recovery);
    // over the tables of another design as well
    screen.keys("<Esc>jeU");
    assert_eq!(screen.app.mode, Mode::Recovery);
    screen.keys("t");
    assert_eq!(editing(&screen).path, path(FIRST));
    assert_eq!(editing(&screen).editor.text(), with_length("35"));
}

/// What is unsaved in the tables already is below the recovered edits.
#[test]
fn taking_an_offer_loses_no_edits_of_this_run() {
    let shelf = Shelf::shipped();
    let mut screen = screen(80, 24, UNICODE, &shelf);
    screen.keys("ec7<Enter>");
    left(&shelf, FIRST, &with_length("35"), OnDisk::Text(base().into()));
    screen.keys("Ut");
    assert_eq!(editing(&screen).editor.text(), with_length("35"));
    screen.keys("u");
    assert_eq!(editing(&screen).editor.text(), with_length("7"));
}

#[test]
fn several_offers_are_answered_one_by_one() {
    let shelf = left_unchanged();
    left(&shelf, "overhung-rigid", "name = \"x\"", OnDisk::Text(SHIPPED[1].text.into()));
    let mut screen = screen(80, 24, UNICODE, &shelf);
    assert!(screen.text().contains("1 of 2"));
    screen.keys("n");
    assert!(screen.text().contains("2 of 2") && screen.text().contains("overhung-rigid, "));
    screen.keys("d");
    assert_eq!(kept(&shelf), [Kept::Unwanted { journal: "/state/overhung-rigid.journal".into() }]);
    assert!(screen.text().contains("overhung-elastic, "));
    screen.keys("d");
    assert_eq!(screen.app.mode, Mode::Library);
}

#[test]
fn what_is_elsewhere_and_what_is_damaged_is_said() {
    let shelf = Shelf::shipped();
    shelf.left.lock().unwrap().elsewhere = vec!["/other/\u{1b}a.toml".into()];
    let mut one = screen(80, 24, UNICODE, &shelf);
    assert!(one.text().contains("unsaved edits of 1 design elsewhere"), "{}", one.text());
    one.keys("!");
    assert!(one.text().contains("/other/\\u{1b}a.toml"), "{}", one.text());
    shelf.left.lock().unwrap().damaged = vec!["/state/1.journal cannot be used: it is damaged".into()];
    let mut two = screen(80, 24, UNICODE, &shelf);
    assert!(two.text().contains("a recovery journal cannot be used"), "{}", two.text());
    two.keys("!");
    assert!(two.text().contains("/state/1.journal cannot be used"), "{}", two.text());
}

/// The tables of the first design with one edit, while somebody else changes the file.
fn conflicting(theirs: Option<&str>) -> (Screen, Shelf) {
    let shelf = Shelf::shipped();
    let mut screen = screen(80, 24, UNICODE, &shelf);
    screen.keys("ec35<Enter>");
    set(&shelf, FIRST, theirs);
    screen.keys("s");
    assert_eq!(screen.app.mode, Mode::Conflict);
    (screen, shelf)
}

/// What the file holds; keys over the question; what the file and the tables hold then, and whether that is unsaved.
type ConflictScript<'a> = (Option<&'a str>, &'a str, Option<&'a str>, &'a str, bool);

#[test]
fn a_conflict_is_decided_by_the_user() {
    let mine = with_length("35");
    let theirs = with_length("40.0");
    let broken = "no = toml = here";
    let scripts: &[ConflictScript] = &[
        (Some(&theirs), "<Esc>", Some(&theirs), &mine, true),
        (Some(&theirs), "m", Some(&mine), &mine, false),
        (Some(&theirs), "t", Some(&theirs), &theirs, false),
        (Some(&theirs), "tu", Some(&theirs), &mine, true),
        (Some(&theirs), "tus", Some(&mine), &mine, false),
        (None, "<Esc>", None, &mine, true),
        (None, "m", Some(&mine), &mine, false),
        (None, "t", None, &mine, true),
        (Some(broken), "<Esc>", Some(broken), &mine, true),
        (Some(broken), "m", Some(&mine), &mine, false),
        (Some(broken), "t", Some(broken), &mine, true),
    ];
    for (there, keys, file, tables, unsaved) in scripts {
        let (mut screen, shelf) = conflicting(*there);
        screen.keys(keys);
        assert_eq!(shelf.text(FIRST).as_deref(), *file, "{there:?} {keys}");
        assert_eq!(editing(&screen).editor.text(), *tables, "{keys}");
        assert_eq!(editing(&screen).is_modified(), *unsaved, "{keys}");
        let is_kept = matches!(kept(&shelf).last(), Some(Kept::Edits { text, .. }) if text == tables);
        assert_eq!(is_kept, *unsaved, "{keys}");
    }
    let (mut screen, _) = conflicting(Some(&theirs));
    screen.keys("t");
    assert_eq!(editing(&screen).editor.undo_name().unwrap().as_str(), "took the file's version");
}

#[test]
fn a_file_that_changes_again_is_asked_about_again() {
    let (mut screen, shelf) = conflicting(Some(&with_length("40.0")));
    set(&shelf, FIRST, Some(&with_length("41.0")));
    screen.keys("m");
    assert_eq!(screen.app.mode, Mode::Conflict);
    assert_eq!(shelf.text(FIRST).unwrap(), with_length("41.0"));
    assert!(screen.text().contains("41.0"), "{}", screen.text());
    screen.keys("m");
    assert_eq!(shelf.text(FIRST).unwrap(), with_length("35"));
}

#[test]
fn a_conflict_can_end_as_a_variant() {
    let (mut screen, shelf) = conflicting(Some(&with_length("40.0")));
    screen.keys("S<Ctrl-u>mine<Enter>");
    assert_eq!(shelf.text(FIRST).unwrap(), with_length("40.0"));
    assert!(shelf.text("mine").unwrap().ends_with(&with_length("35")));
    assert_eq!(editing(&screen).path, path("mine"));
}

#[test]
fn saving_all_at_the_end_asks_for_each_conflict() {
    let two = |keys: &str| {
        let shelf = Shelf::shipped();
        let mut screen = screen(80, 24, UNICODE, &shelf);
        screen.keys("ec35<Enter><Esc>jec35<Enter><Esc>q");
        assert_eq!(screen.app.mode, Mode::Leave);
        set(&shelf, FIRST, Some(&with_length("40.0")));
        set(&shelf, "overhung-rigid", None);
        screen.keys("s");
        assert!(screen.text().contains("overhung-elastic has changed on disk"), "{}", screen.text());
        screen.keys(keys);
        let quits = screen.effects.contains(&Effect::Quit(Ending::Quit));
        (screen, shelf, quits)
    };
    let (_, shelf, quits) = two("mm");
    assert!(quits && shelf.text(FIRST).unwrap() == with_length("35") && shelf.text("overhung-rigid").is_some());
    let (_, shelf, quits) = two("tm");
    assert!(quits && shelf.text(FIRST).unwrap() == with_length("40.0"));
    let (screen, shelf, quits) = two("m<Esc>");
    assert!(!quits && screen.app.mode == Mode::Library && shelf.text("overhung-rigid").is_none());
    let (screen, _, quits) = two("S");
    assert!(!quits && screen.app.mode == Mode::Form && editing(&screen).path == path(FIRST));
}

#[test]
fn a_change_by_somebody_else_is_said_before_saving() {
    let shelf = Shelf::shipped();
    let mut screen = screen(80, 24, UNICODE, &shelf);
    screen.keys("e");
    set(&shelf, FIRST, Some(&with_length("40.0")));
    screen.keys("c35<Enter>");
    assert_eq!(editing(&screen).look.state, FileState::Changed);
    assert!(screen.text().contains("saving will show how"), "{}", screen.text());
    screen.keys("j");
    assert!(screen.text().lines().next().unwrap().contains("changed on disk"), "{}", screen.text());
    set(&shelf, FIRST, None);
    screen.keys("c5<Enter>j");
    assert!(screen.text().lines().next().unwrap().contains("file gone"), "{}", screen.text());
    set(&shelf, FIRST, Some(base()));
    screen.keys("c6<Enter>j");
    assert_eq!(editing(&screen).look.state, FileState::Same);
}

#[test]
fn another_owner_is_named_until_it_is_gone() {
    let shelf = Shelf::shipped();
    *shelf.holder.lock().unwrap() = Some("process 12 of anna".into());
    let mut screen = screen(80, 24, UNICODE, &shelf);
    screen.keys("e");
    assert!(screen.text().contains("× process 12 of anna has this design open as well"), "{}", screen.text());
    screen.keys("j");
    let header = screen.text().lines().next().unwrap().to_owned();
    assert!(header.contains("also open: process 12 of anna"), "{header}");
    *shelf.holder.lock().unwrap() = None;
    screen.keys("c5<Enter>");
    assert!(screen.text().contains("held here now, no longer by process 12 of anna"), "{}", screen.text());
    // saving is never prevented
    *shelf.holder.lock().unwrap() = Some("process 13".into());
    screen.keys("c6<Enter>s");
    assert!(!editing(&screen).is_modified());
}

/// One lock while the tables are open or edits are unsaved.
#[test]
fn a_design_is_released_when_it_is_left_with_nothing_unsaved() {
    let released = |keys: &str| {
        let shelf = Shelf::shipped();
        let mut screen = screen(80, 24, UNICODE, &shelf);
        screen.keys("e").keys(keys);
        let released = |effect: &Effect| format!("{effect:?}").contains("Release");
        screen.effects.iter().filter(|effect| released(effect)).count()
    };
    assert_eq!(["", "<Esc>", "c5<Enter><Esc>", "c5<Enter>u<Esc>", "c5<Enter>s<Esc>"].map(released), [0, 1, 0, 1, 1]);
    assert_eq!(released("c5<Enter>S<Ctrl-u>other<Enter>"), 1, "the variant is open instead");
}

#[test]
fn edits_that_are_not_protected_are_said_to_be_so_as_long_as_that_is_so() {
    let shelf = Shelf::shipped();
    let mut screen = screen(120, 40, UNICODE, &shelf);
    let unprotected = "unsaved edits are not protected: the disk is full";
    screen.send(Message::Protected(Err("the disk is full".into())));
    for keys in ["j", "e", "l", "?<Esc>", "<Esc>", "k"] {
        screen.keys(keys);
        assert!(screen.text().contains(unprotected), "{keys}\n{}", screen.text());
    }
    screen.send(Message::Protected(Ok(())));
    assert!(screen.text().contains("protected again"));
    screen.keys("j");
    assert!(!screen.text().contains(unprotected));
}

/// A backend that keeps nothing until it is allowed to.
struct Refusing {
    allowed: Mutex<bool>,
    kept: Mutex<Vec<Kept>>,
}

impl Backend for Refusing {
    fn load(&self, _: &std::path::Path) -> Result<LoadedDesign, BrokenDesign> {
        unreachable!("nothing is read")
    }

    fn compare(&self, _: &Design, _: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        unreachable!("nothing is solved")
    }

    fn keep(&self, change: &Kept) -> Result<(), String> {
        if *self.allowed.lock().unwrap() {
            self.kept.lock().unwrap().push(change.clone());
            return Ok(());
        }
        Err("the disk is full".into())
    }
}

fn protected(receiver: &Receiver<Message>) -> Result<(), String> {
    match receiver.recv_timeout(Duration::from_secs(20)).unwrap() {
        Message::Protected(result) => result,
        other => panic!("{other:?}"),
    }
}

#[test]
fn what_could_not_be_kept_is_tried_again_in_the_right_order() {
    let backend = Arc::new(Refusing { allowed: Mutex::new(false), kept: Mutex::default() });
    let (sender, receiver) = channel();
    let keeper = Keeper::start(Arc::clone(&backend) as Arc<dyn Backend>, sender).unwrap();
    keeper.keep(edits("0", "1"));
    assert_eq!(protected(&receiver), Err("the disk is full".into()));
    // what the edits were taken from must not go before they are kept
    let taken = Kept::Taken { path: path(FIRST), journal: "/state/1.journal".into() };
    keeper.keep(taken.clone());
    keeper.keep(edits("0", "2"));
    *backend.allowed.lock().unwrap() = true;
    assert_eq!(protected(&receiver), Ok(()));
    drop(keeper);
    let kept = backend.kept.lock().unwrap().clone();
    assert_eq!(kept.first(), Some(&edits("0", "2")), "the latest, and first: {kept:?}");
    assert!(!kept.contains(&edits("0", "1")), "{kept:?}");
}

#[test]
fn the_end_waits_for_what_is_still_to_be_written() {
    let backend = Arc::new(Refusing { allowed: Mutex::new(true), kept: Mutex::default() });
    let keeper = Keeper::start(Arc::clone(&backend) as Arc<dyn Backend>, channel().0).unwrap();
    let all: Vec<Kept> = (0..50)
        .map(|number| Kept::Edits { path: format!("/{number}").into(), base: String::new(), text: String::new() })
        .collect();
    for change in &all {
        keeper.keep(change.clone());
    }
    drop(keeper);
    assert_eq!(*backend.kept.lock().unwrap(), all);
}

#[test]
fn the_windows_fit_every_size() {
    for made in [left_unchanged, left_changed, left_gone] {
        let shelf = made();
        let mut screen = screen(80, 24, UNICODE, &shelf);
        for (width, height) in [(60, 18), (61, 19), (1, 1), (200, 60), (60, 200), (200, 18)] {
            screen.resize(width, height);
            if width >= 60 && height >= 18 {
                let text = screen.text();
                assert!(text.contains(" t  ") && text.contains(" d  discard") && text.contains("Esc  later"), "{text}");
            }
        }
    }
    let (mut screen, _) = conflicting(Some(&with_length("40.0")));
    screen.resize(60, 18);
    let text = screen.text();
    assert!(text.contains("m  keep mine") && text.contains("t  take theirs") && text.contains("do nothing"), "{text}");
    assert!(text.contains("40.0"), "{text}");
}

#[test]
fn long_changes_scroll() {
    let (mut screen, _) = conflicting(Some("# another\n# file\n"));
    screen.resize(80, 24);
    let first = screen.text();
    assert!(first.contains("lines 1-"), "{first}");
    screen.keys("G");
    assert_ne!(screen.text(), first);
    screen.keys("g");
    assert_eq!(screen.text(), first);
}

#[test]
fn offer_80x24_ascii() {
    assert_snapshot!(screen(80, 24, ASCII, &left_changed()).text());
}

#[test]
fn offer_120x40() {
    let screen = screen(120, 40, COLOURS, &left_unchanged());
    assert_snapshot!(screen.text() + &screen.styles());
}

#[test]
fn offer_gone_60x18() {
    assert_snapshot!(screen(60, 18, UNICODE, &left_gone()).text());
}

#[test]
fn conflict_80x24_ascii() {
    let shelf = Shelf::shipped();
    let mut screen = screen(80, 24, ASCII, &shelf);
    screen.keys("ec35<Enter>");
    set(&shelf, FIRST, Some(&format!("# a comment\n{}", base())));
    assert_snapshot!(screen.keys("s").text());
}

#[test]
fn conflict_120x40() {
    let (mut screen, _) = conflicting(Some(&with_length("40.0")));
    screen.resize(120, 40);
    assert_snapshot!(screen.text());
}
