//! The screen of the natural modes: what the table says, the shapes, the MAC, the deflection shape.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use bevelscope::design::library::SHIPPED;
use bevelscope::design::read;
use bevelscope::response::{EnergyShare, MotionGroup};
use bevelscope::tui::caps::{Capabilities, ColourDepth};
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::message::{Effect, Message};
use bevelscope::tui::modes::{self, ModesJob, Study, Wanted};
use tui_support::{ASCII, MadeUp, Screen, Shelf, UNICODE, dead_keys};

const MONOCHROME: Capabilities = Capabilities { colour: ColourDepth::None, ..UNICODE };

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
    // a comma is no decimal point
    let text = screen.keys("<Ctrl-u>12,5<Enter>").text();
    assert!(text.contains("wanted a frequency in Hz from 10"), "{text}");
    let text = screen.keys("<Ctrl-u>1,234.5 Hz<Enter>").text();
    assert!(text.contains("operating deflection at 1234.5 Hz") && text.contains("mesh force, N"), "{text}");
    let text = screen.keys("ogx").text();
    assert!(text.contains("with FE") && text.contains("MAC"), "{text}");
    let text = screen.keys("gllj<Tab>").text();
    assert!(text.contains("basic 2 ("), "{text}");
    // a level at a time: the table, then the list of designs
    assert!(screen.keys("<Esc>").text().contains("partners by MAC"), "{}", screen.text());
    assert!(screen.keys("<Esc>").text().contains("trust up to"));
}

#[test]
fn state_is_never_told_by_colour_alone() {
    let styles = |capabilities, keys: &str| modes(80, 24, capabilities).keys(keys).styles();
    insta::assert_snapshot!("modes_styles", styles(UNICODE, "jj"));
    insta::assert_snapshot!("modes_styles_monochrome", styles(MONOCHROME, "jj"));
    insta::assert_snapshot!("mac_styles_monochrome", styles(MONOCHROME, "jjx"));
    for keys in ["jj", "jjx", "jjo", "jj<Tab><Tab>", "jjf12"] {
        assert_eq!(modes(80, 24, UNICODE).keys(keys).text(), modes(80, 24, MONOCHROME).keys(keys).text(), "{keys}");
    }
}

/// The mode at 530 Hz has MAC 1.000 with its enhanced partner: both shapes lie on one another.
#[test]
fn both_curves_are_seen_where_they_lie_on_one_another() {
    for (capabilities, markers) in [(UNICODE, 4), (ASCII, 2)] {
        for marker in 0..markers {
            let text = modes(80, 24, capabilities).keys("jj").keys(&"b".repeat(marker)).text();
            let planes: Vec<String> =
                text.lines().skip(10).take(8).map(|line| line.chars().skip(26).collect()).collect();
            let planes = planes.join("\n");
            let partner = planes.matches('e').count();
            let fe = planes.chars().filter(|shown| !" e|│\n-─x×^△yz".contains(*shown)).count();
            assert!(partner >= 10 && fe >= 3 * partner / 2, "{partner} {fe}\n{text}");
        }
    }
}

#[test]
fn figures_of_all_drives_and_both_energies_are_there_where_there_is_room() {
    let text = modes(60, 18, UNICODE).keys("jj").text();
    assert_eq!(text.matches(" drive ").count(), 2, "{text}");
    assert!(text.contains("% of the strain in the mesh"), "{text}");
    let text = modes(80, 24, UNICODE).keys("jj").text();
    for line in [" FE    pinion lat", " enh.  pinion lat"] {
        assert!(text.contains(line), "{text}");
    }
    assert_eq!(text.matches(" mesh ").count(), 2, "{text}");
    assert!(!text.contains("-0.0"), "{text}");
}

/// A key that does nothing anywhere on the screen should not be in its help.
#[test]
fn every_key_of_the_screen_does_something() {
    let dead = dead_keys(Mode::Modes, || modes(80, 24, UNICODE), &["", "jjjj", "jjjjxl", "jjjjol", "jj<Tab><Tab>"]);
    assert!(dead.is_empty(), "{dead:?}");
}

#[test]
fn opened_from_the_spectra_it_shows_the_deflection_at_their_cursor_and_goes_back_to_them() {
    let mut screen = Screen::with(&["overhung-elastic"], 80, 24, UNICODE, Shelf::shipped());
    screen.keys("wLL");
    let at_hz = screen.app.spectra.as_ref().unwrap().at_hz().unwrap();
    let text = screen.keys("M").text();
    let view = screen.app.modes.as_ref().unwrap();
    assert_eq!((view.deflection_hz, view.deflection.as_ref().unwrap().as_ref().unwrap().at_hz), (Some(at_hz), at_hz));
    assert!(text.contains("operating deflection at"), "{text}");
    // the row next to it is chosen: modes 9 to 11 are the nearest to 2.2 kHz
    let (row, study) = (view.row().unwrap(), view.study().unwrap());
    let distance = |row: &modes::ModeRow| (row.mode(study).unwrap().frequency_hz - at_hz).abs();
    assert!(view.rows.iter().all(|other| distance(row) <= distance(other)));
    screen.keys("<Esc>");
    assert!(screen.text().contains("natural modes") && screen.app.mode == Mode::Modes);
    screen.keys("<Esc>");
    assert_eq!(screen.app.mode, Mode::Spectra);
}

#[test]
fn the_reduced_model_comes_with_more_modes_or_fewer_and_the_deflection_with_it() {
    let mut screen = modes(80, 24, UNICODE);
    assert!(screen.keys("jj<Tab><Tab>").text().contains("r reduced:3"), "{}", screen.text());
    assert!(screen.keys("+").text().contains("r reduced:4"), "{}", screen.text());
    assert!(screen.keys("---").text().contains("r reduced:1"), "{}", screen.text());
    assert!(screen.keys("--").text().contains("r reduced:0"), "{}", screen.text());
    screen.held = true;
    screen.effects.clear();
    assert!(screen.keys("+").text().contains("computing reduced:1"), "{}", screen.text());
    let job = latest(&screen);
    assert!(matches!(job.wanted, Wanted::Reduced { reduced: 1, .. }), "{job:?}");
    // the deflection waits for it, and is asked for then
    screen.keys("o");
    assert_eq!(latest(&screen), job);
    screen.send(modes::perform(&job, &Shelf::shipped(), &|| true).unwrap());
    assert!(matches!(latest(&screen).wanted, Wanted::Deflection { .. }));
    screen.send(modes::perform(&latest(&screen), &Shelf::shipped(), &|| true).unwrap());
    assert!(screen.text().contains("reduced:1") && screen.text().contains("mesh force, N"), "{}", screen.text());
}

/// Bars are parts of one whole: all motions of both rotors together are the kinetic energy.
#[test]
fn the_energies_of_every_mode_sum_up_and_the_mesh_has_a_part_of_the_strain() {
    for shipped in SHIPPED {
        let design = read(shipped.text).design.unwrap();
        let study = Study::new(&design, 2, &|| true).unwrap();
        let all = study.small().flat_map(|small| &small.own.modes.0).chain(&study.fe.modes.0);
        for mode in all {
            let of = |share: &EnergyShare| MotionGroup::ALL.map(|group| group.of(share)).iter().sum::<f64>();
            let sum = of(&mode.pinion) + of(&mode.gear);
            assert!((sum - 1.0).abs() < 1e-9, "{}: {} Hz: {sum}", shipped.file_name, mode.frequency_hz);
            assert!((0.0..=1.0).contains(&mode.mesh_strain_share));
        }
    }
}

/// Rows of the picture are the small model's modes and columns those of finite elements: what the table calls partners is dark there.
#[test]
fn partners_of_the_table_are_where_the_picture_says() {
    let mut screen = modes(120, 40, UNICODE);
    for model in ["", "<Tab>", "<Tab>"] {
        screen.keys(model);
        let view = screen.app.modes.as_ref().unwrap();
        let (at, rows) = (view.model, view.rows.clone());
        let study = view.study().unwrap().clone();
        let small = study.one(at).unwrap();
        assert_eq!(small.mac.shape(), (small.own.modes.0.len(), study.fe.modes.0.len()));
        let mut pairs = 0;
        for (place, row) in rows.iter().enumerate() {
            let (Some(fe), Some(partner)) = (row.fe, row.partners[at]) else { continue };
            screen.app.modes.as_mut().unwrap().cursor = place;
            let text = screen.keys("x").text();
            let fe_hz = study.fe.modes.0[fe].frequency_hz;
            let readout = format!("with FE {} (", fe + 1);
            let line = text.lines().find(|line| line.contains(&readout)).unwrap();
            assert!(line.contains(&format!(" {} (", partner.mode + 1)), "{line}");
            assert!(line.contains(&format!("MAC {:.3}", partner.mac.unwrap())), "{line}");
            if fe_hz > 1.0 {
                assert!(
                    line.contains(&format!("({fe_hz:.1} Hz)")) && line.contains(&format!("({:.1} Hz)", partner.hz))
                );
            }
            screen.keys("x");
            pairs += 1;
        }
        assert!(pairs >= 9, "{pairs}");
    }
}

#[test]
fn a_deflection_shape_is_never_drawn_under_another_frequency() {
    let mut screen = modes(80, 24, UNICODE);
    screen.keys("jjo");
    assert!(screen.app.modes.as_ref().unwrap().moment().is_some());
    screen.held = true;
    let text = screen.keys("l").text();
    assert!(screen.app.modes.as_ref().unwrap().moment().is_none(), "{text}");
    assert!(text.contains("operating deflection at") && text.contains("computing"), "{text}");
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
