//! The screen of the natural modes: what the table says, the shapes, the MAC, the deflection shape.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use bevelscope::tui::caps::Capabilities;
use bevelscope::tui::message::{Effect, Message};
use bevelscope::tui::modes::{self, ModesJob};
use tui_support::{ASCII, MadeUp, Screen, Shelf, UNICODE};

/// A shipped design with its modes.
fn modes(width: u16, height: u16, capabilities: Capabilities) -> Screen {
    let mut screen = Screen::with(&["overhung-elastic"], width, height, capabilities, Shelf::shipped());
    screen.keys("M");
    screen
}

#[test]
fn modes_at_several_sizes() {
    insta::assert_snapshot!("modes_80x24_ascii", modes(80, 24, ASCII).keys("jj").text());
    insta::assert_snapshot!("modes_120x40", modes(120, 40, UNICODE).keys("jj<Tab>").text());
    insta::assert_snapshot!("modes_60x18", modes(60, 18, UNICODE).keys("jj").text());
}

#[test]
fn mac_and_deflection() {
    insta::assert_snapshot!("mac_80x24_ascii", modes(80, 24, ASCII).keys("jjx").text());
    insta::assert_snapshot!("deflection_80x24_ascii", modes(80, 24, ASCII).keys("jjo l").text());
}

#[test]
fn after_half_a_period_a_shape_is_its_negative_and_after_a_whole_one_itself() {
    let mut screen = modes(80, 24, ASCII);
    screen.keys("jjf200<Enter>");
    let moment = |screen: &Screen| screen.app.modes.as_ref().unwrap().moment().unwrap();
    let first = moment(&screen);
    let entries = |moment: &modes::Moment| -> Vec<f64> {
        let shafts = moment.shapes.iter().flat_map(|(_, shape)| shape);
        shafts.flat_map(|shaft| shaft.displacements.iter().flatten().copied()).collect()
    };
    screen.keys("    ");
    for (now, before) in entries(&moment(&screen)).into_iter().zip(entries(&first)) {
        assert!((now + before).abs() <= 1e-12 * first.largest[1].max(first.largest[0]), "{now} {before}");
    }
    // a quarter in between is no multiple of the first: the deflection is complex
    screen.keys("      ");
    let (quarter, first_entries) = (entries(&moment(&screen)), entries(&first));
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let likeness =
        dot(&quarter, &first_entries).powi(2) / (dot(&quarter, &quarter) * dot(&first_entries, &first_entries));
    assert!(dot(&quarter, &quarter) > 0.0 && likeness < 0.999_999, "{likeness}");
}

#[test]
fn a_typed_frequency_is_checked_and_the_cursor_of_the_mac_says_where_it_is() {
    let mut screen = modes(80, 24, UNICODE);
    let text = screen.keys("f99999999<Enter>").text();
    assert!(text.contains("wanted a frequency in Hz from 10"), "{text}");
    let text = screen.keys("<Ctrl-u>1,234.5 Hz<Enter>").text();
    assert!(text.contains("deflection at 1234.5 Hz, FE mesh force"), "{text}");
    let text = screen.keys("ogx").text();
    assert!(text.contains("with FE") && text.contains("MAC"), "{text}");
    let text = screen.keys("gllj<Tab>").text();
    assert!(text.contains("basic 2 ("), "{text}");
    assert!(screen.keys("x<Esc>").text().contains("trust up to"));
}

#[test]
fn modes_of_unsaved_edits_and_back_to_the_tables() {
    let mut screen = Screen::with(&["overhung-elastic"], 80, 24, UNICODE, Shelf::shipped());
    let text = screen.keys("ec77<Enter>M").text();
    assert!(text.contains("(unsaved edits)") && text.contains("FE Hz"), "{text}");
    assert!(!screen.keys("<Esc>").text().contains("natural modes"));
    assert!(screen.app.editors.open().is_some());
}

#[test]
fn a_design_that_cannot_be_solved_says_why() {
    let mut screen = Screen::with(&["typo", "fine"], 80, 24, UNICODE, MadeUp);
    assert!(screen.keys("M").text().contains("line 14: unknown key"));
    assert!(screen.keys("<Esc>jM").text().contains("there is no material"));
}

/// The latest request for modes.
fn latest(screen: &Screen) -> ModesJob {
    let jobs = screen.effects.iter().rev();
    let mut jobs = jobs.filter_map(|effect| match effect {
        Effect::Modes(job) => Some(job.clone()),
        _ => None,
    });
    jobs.next().unwrap()
}

#[test]
fn an_older_answer_is_not_shown_and_leaving_gives_up_the_work() {
    let mut screen = Screen::with(&["overhung-elastic"], 80, 24, UNICODE, Shelf::shipped());
    screen.held = true;
    screen.keys("M");
    let older = latest(&screen);
    screen.keys("<Esc>");
    assert!(matches!(screen.effects.last(), Some(Effect::CancelModes)), "{:?}", screen.effects.last());
    screen.keys("M");
    let newer = latest(&screen);
    assert!(older != newer);
    let answer = |job: &ModesJob| modes::perform(job, &Shelf::shipped(), &|| true).unwrap();
    screen.send(answer(&older));
    assert!(screen.text().contains("Computing the modes"), "{}", screen.text());
    let message = answer(&newer);
    assert!(matches!(message, Message::ModesFound { .. }));
    screen.send(message);
    assert!(screen.text().contains("FE Hz"), "{}", screen.text());
    // what is no longer wanted ends without a word
    assert!(modes::perform(&newer, &Shelf::shipped(), &|| false).is_none());
}
