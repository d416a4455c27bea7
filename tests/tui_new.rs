//! The form of a new design: what is typed, what follows, what cannot be, and the design in the list.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use bevelscope::design::read;
use bevelscope::tui::caps::{Capabilities, ColourDepth};
use bevelscope::tui::files::FileRequest;
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::library::RowState;
use bevelscope::tui::message::{Effect, Message};
use tui_support::{ASCII, Screen, Shelf, UNICODE};

/// An explorer without any design.
fn empty(width: u16, height: u16, capabilities: Capabilities) -> (Screen, Shelf) {
    let shelf = Shelf::new(&[]);
    (Screen::with(&[], width, height, capabilities, shelf.clone()), shelf)
}

#[test]
fn the_form_at_several_sizes() {
    let pictures = [("80x24_ascii", 80, 24, ASCII), ("120x40", 120, 40, UNICODE), ("60x18", 60, 18, UNICODE)];
    for (name, width, height, capabilities) in pictures {
        let (mut screen, _) = empty(width, height, capabilities);
        insta::assert_snapshot!(format!("new_{name}"), screen.keys("a<Down><Down>16").text());
    }
}

#[test]
fn a_hypoid_pair_with_something_wrong_and_the_empty_list() {
    let (mut screen, _) = empty(80, 24, UNICODE);
    assert!(screen.text().contains("a asks a few questions and makes one"), "{}", screen.text());
    screen.keys("a<Down>h<Down>30<Down>40");
    insta::assert_snapshot!("new_wrong_80x24", screen.text());
}

#[test]
fn without_colours_what_was_asked_for_still_stands_out() {
    let mono = Capabilities { colour: ColourDepth::None, ..UNICODE };
    let (mut screen, _) = empty(80, 24, mono);
    screen.keys("a<Down><Down>16<Down>");
    let bold = |screen: &Screen, text: &str| {
        let y = (0..24).find(|y| screen.line(*y).contains(text)).unwrap();
        let cell = &screen.buffer()[(19, y)];
        cell.modifier.contains(ratatui::style::Modifier::BOLD)
    };
    assert!(bold(&screen, "pinion teeth") && !bold(&screen, "pinion torque"), "{}", screen.text());
}

#[test]
fn the_design_is_made_listed_selected_and_solved() {
    let (mut screen, shelf) = empty(80, 24, UNICODE);
    screen.keys("a<Down> <Down>12<Down>41<Enter>");
    assert_eq!(
        (shelf.stems(), screen.selected()),
        (vec!["straight-bevel-12-41".to_owned()], "straight-bevel-12-41".into())
    );
    assert_eq!(screen.app.mode, Mode::Library);
    assert!(matches!(screen.app.library.selected().unwrap().state, RowState::Solved(_)), "{}", screen.text());
    let text = shelf.text("straight-bevel-12-41").unwrap();
    let design = read(&text).design.unwrap();
    assert_eq!((design.pinion.teeth, design.gear.teeth), (Some(12), Some(41)));
    // typed values are kept, and the next name is free
    screen.keys("a");
    assert!(screen.text().contains("straight-bevel-12-41-2"), "{}", screen.text());
    screen.keys("<Enter>");
    assert_eq!(shelf.stems(), ["straight-bevel-12-41-2", "straight-bevel-12-41"]);
    assert_eq!(shelf.text("straight-bevel-12-41-2").unwrap(), text);
}

#[test]
fn everything_is_answered_with_the_keys_and_follows_the_others() {
    let (mut screen, shelf) = empty(120, 40, UNICODE);
    // name, kind, teeth; then torque with another unit
    screen.keys("amine<Tab><Right><Right><Right><Right><Down>21<Down>64<Down>0.2 kN m");
    assert!(screen.text().contains("helical"), "{}", screen.text());
    // speed, module, face width, helix angle, pressure angle, hand
    screen.keys("<Down>2400<Down>3<Down>1 in<Down>25<Down>22<Down> ");
    assert!(screen.text().contains("25.4 mm") && screen.text().contains("left"), "{}", screen.text());
    // mountings, then bearings: angular contact ones by their first letter
    screen.keys("<Down>o<Down>s<Down>t<Right><Enter>");
    let text = shelf.text("mine").unwrap_or_else(|| panic!("{}", screen.text()));
    let design = read(&text).design.unwrap();
    let operating = design.operating.unwrap();
    assert_eq!(
        (operating.pinion_torque, operating.pinion_speed.map(|speed| (speed * 30.0 / std::f64::consts::PI).round())),
        (Some(200.0), Some(2400.0))
    );
    let geometry = design.mesh.geometry.unwrap();
    assert!((geometry.helix_angle.unwrap().to_degrees() - 25.0).abs() < 1e-9);
    assert!((geometry.pressure_angle.to_degrees() - 22.0).abs() < 1e-9);
    assert!(text.contains("hand = \"left\"") && text.contains("# tapered-"), "{text}");
    assert!(text.contains("face width 25.4 mm, asked for"), "{text}");
    assert!(text.contains("# ---- Pinion, overhung") && text.contains("# ---- Gear, straddle"), "{text}");
}

#[test]
fn what_cannot_be_is_said_beside_the_answer_and_nothing_is_made() {
    let (mut screen, shelf) = empty(80, 24, UNICODE);
    screen.keys("a<Down><Down>3<Down><Down><Enter>");
    assert!(screen.text().contains("× a whole number from 5 to 100"), "{}", screen.text());
    // the cursor goes to what is wrong
    assert_eq!(screen.app.new_design.cursor, 2);
    assert_eq!((shelf.stems().len(), screen.app.mode), (0, Mode::New));
    // what follows from all of it is wrong where it can be put right
    screen.keys("<Ctrl-u>20<Down>19");
    assert!(screen.text().contains("× must be at least the pinion's"), "{}", screen.text());
    // cleared, it follows again
    screen.keys("<Ctrl-u>");
    assert!(!screen.text().contains('×') || screen.app.new_design.error(screen.app.new_design.row()).is_none());
    screen.keys("<Enter>");
    assert_eq!(shelf.stems(), ["spiral-bevel-20-56"]);
}

/// Whichever key gives the answer, the name is that of the pair which is made.
#[test]
fn the_proposed_name_follows_every_answer() {
    let (mut screen, shelf) = empty(80, 24, UNICODE);
    assert!(screen.keys("a<Down><Right><Right>").text().contains("hypoid-13-42"), "{}", screen.text());
    assert!(screen.keys("<Left>").text().contains("straight-bevel-"), "{}", screen.text());
    for key in ["<Backspace>", "<Delete>", "<Ctrl-w>", "<Ctrl-u>"] {
        screen.keys("h");
        let shown = screen.keys(key).text();
        assert!(shown.contains("spiral-bevel-14-39"), "{key}: {shown}");
    }
    screen.keys("<Right><Right><Enter>");
    assert_eq!(shelf.stems(), ["hypoid-13-42"]);
}

#[test]
fn what_followed_before_a_refused_answer_is_called_stale_and_never_written() {
    let (mut screen, shelf) = empty(120, 40, UNICODE);
    assert!(!screen.keys("a<Down><Down>").text().contains("stale"));
    let shown = screen.keys("3").text();
    assert!(shown.contains("stale: Side view") && shown.contains("stale: What follows"), "{shown}");
    screen.keys("<Enter>");
    assert_eq!((shelf.stems().len(), screen.app.mode), (0, Mode::New));
    assert!(!screen.keys("<Ctrl-u>").text().contains("stale"), "{}", screen.text());
}

#[test]
fn a_name_that_is_taken_or_refused_is_said_beside_it() {
    let (mut screen, shelf) = empty(80, 24, UNICODE);
    screen.keys("a<Enter>a<Up>spiral-bevel-14-39<Enter>");
    assert!(screen.text().contains("× there is a design of that name"), "{}", screen.text());
    screen.keys("<Ctrl-u>a/b<Enter>");
    assert!(screen.text().contains("× a name must not have '/'"), "{}", screen.text());
    screen.keys("<Ctrl-u>locked<Enter>");
    assert!(screen.text().contains("× the folder is locked"), "{}", screen.text());
    assert_eq!((shelf.stems().len(), screen.app.mode), (1, Mode::New));
    // the answer is another one: it is no longer said
    screen.keys("<Backspace>");
    assert!(!screen.text().contains("locked"), "{}", screen.text());
    screen.keys("<Enter>");
    assert_eq!(shelf.stems(), ["locke", "spiral-bevel-14-39"]);
}

#[test]
fn what_is_typed_is_kept_when_the_form_is_left() {
    let (mut screen, shelf) = empty(80, 24, UNICODE);
    screen.keys("a<Down><Down>17<Esc>");
    assert_eq!((screen.app.mode, shelf.stems().len()), (Mode::Library, 0));
    screen.keys("a");
    assert!(screen.text().contains("spiral-bevel-17-47"), "{}", screen.text());
    // letters are text here, and nothing quits
    screen.keys("<Up><Up>q?:");
    assert!(screen.text().contains("[q?:"), "{}", screen.text());
    assert!(!screen.effects.iter().any(|effect| matches!(effect, Effect::Quit(_))));
}

#[test]
fn a_design_is_asked_for_once() {
    let (mut screen, _) = empty(80, 24, UNICODE);
    screen.held = true;
    screen.keys("a<Enter><Enter>x<Down>");
    let asked: Vec<&FileRequest> = screen
        .effects
        .iter()
        .filter_map(|effect| if let Effect::ChangeFile(request) = effect { Some(request) } else { None })
        .collect();
    assert_eq!(asked.len(), 1);
    let request = asked[0].clone();
    assert!(screen.text().contains("writing"), "{}", screen.text());
    // the form may be left meanwhile; what went wrong is said all the same
    screen.keys("<Esc>");
    screen.send(Message::FileChanged { request, result: Err("the disk is full".into()) });
    assert!(screen.text().contains("the disk is full"), "{}", screen.text());
    assert_eq!(screen.app.mode, Mode::Library);
}

#[test]
fn a_pasted_text_is_an_answer_and_no_keys() {
    let (mut screen, _) = empty(80, 24, UNICODE);
    screen.keys("a");
    screen.send(Message::Paste("my design\nq".into()));
    assert!(screen.text().contains("my design"), "{}", screen.text());
    screen.keys("<Down><Down>");
    screen.send(Message::Paste("\u{1b}[2J".into()));
    assert!(!screen.text().contains('\u{1b}'));
}

/// In the smallest terminal, every sentence of help and every label is there in full.
#[test]
fn every_question_can_be_read_in_the_smallest_terminal() {
    for kind in ["spi", "h", "hel"] {
        let (mut screen, _) = empty(60, 18, UNICODE);
        screen.keys("a<Down>");
        screen.keys(&kind[..1]);
        if kind == "hel" {
            screen.keys("h");
        }
        for row in screen.app.new_design.rows() {
            if let bevelscope::tui::new_design::Row::Field(field) = row {
                screen.app.new_design.cursor =
                    screen.app.new_design.rows().iter().position(|other| *other == row).unwrap();
                screen.draw();
                let text = screen.text().replace('\n', " ");
                let words: Vec<&str> = text.split_whitespace().collect();
                assert!(words.join(" ").contains(field.help()), "{field:?}: {}", screen.text());
                assert!(text.contains(field.label()), "{field:?}");
            }
        }
    }
}
