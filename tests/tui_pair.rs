//! The screen of the gear pair: pictures of all kinds, the flank, the estimate, the import.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use std::path::PathBuf;

use bevelscope::design::read;
use bevelscope::gear::COLUMNS;
use bevelscope::pair::PairFigures;
use bevelscope::tui::caps::{Capabilities, ColourDepth};
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::message::Effect;
use tui_support::{ASCII, Screen, Shelf, UNICODE};

const MONOCHROME: Capabilities = Capabilities { colour: ColourDepth::None, ..UNICODE };

/// The gear pair of a shipped design.
fn pair(stem: &str, width: u16, height: u16, capabilities: Capabilities) -> Screen {
    let mut screen = Screen::with(&[stem], width, height, capabilities, Shelf::shipped());
    screen.keys("P");
    screen
}

/// Designs of the kinds that no shipped one has, made from the shipped ones.
fn others() -> Shelf {
    let shipped = Shelf::shipped();
    let (axle, helical) = (shipped.text("tapered-axle").unwrap(), shipped.text("straddle-helical").unwrap());
    let without = |text: &str, keys: &[&str]| {
        let is_kept = |line: &&str| !keys.iter().any(|key| line.starts_with(key));
        text.lines().filter(is_kept).collect::<Vec<_>>().join("\n")
    };
    let straight = without(&axle, &["hand =", "pinion_spiral_angle", "gear_spiral_angle"]);
    let spur = without(&helical, &["hand =", "helix_angle"]);
    Shelf::new(&[
        ("straight", &straight.replace("spiral-bevel", "straight-bevel")),
        ("spur", &spur.replace("\"helical\"", "\"spur\"")),
    ])
}

/// The text of the design in the tables.
fn text(screen: &Screen) -> String {
    screen.app.editors.open().unwrap().editor.text().to_owned()
}

#[test]
fn pairs_at_several_sizes() {
    insta::assert_snapshot!("spiral_bevel_80x24_ascii", pair("tapered-axle", 80, 24, ASCII).text());
    insta::assert_snapshot!("hypoid_120x40", pair("tapered-hypoid", 120, 40, UNICODE).text());
    insta::assert_snapshot!("spiral_bevel_60x18", pair("tapered-axle", 60, 18, UNICODE).text());
    insta::assert_snapshot!("helical_80x24", pair("straddle-helical", 80, 24, UNICODE).text());
    insta::assert_snapshot!("vectors_80x24", pair("overhung-elastic", 80, 24, UNICODE).text());
    let straight = Screen::with(&["straight"], 80, 24, MONOCHROME, others()).keys("Pf").text();
    insta::assert_snapshot!("straight_bevel_80x24_monochrome", straight);
    insta::assert_snapshot!("spur_80x24_ascii", Screen::with(&["spur"], 80, 24, ASCII, others()).keys("P").text());
}

#[test]
fn windows_of_the_pair() {
    insta::assert_snapshot!("estimate_80x24_ascii", pair("tapered-axle", 80, 24, ASCII).keys("K21.59 mm").text());
    insta::assert_snapshot!("import_80x24_ascii", importing("tapered-axle", ASCII).keys("Imesh.csv<Enter>").text());
    insta::assert_snapshot!("mesh_table_80x24", pair("tapered-axle", 80, 24, UNICODE).keys("<Esc>e<F4>jjj").text());
}

/// The screen's numbers are those that `inspect` prints, in both hands and both ways to turn.
#[test]
fn the_other_flank_pulls_the_pinion_into_mesh_and_is_one_edit() {
    for hand in ["right", "left"] {
        let source =
            Shelf::shipped().text("tapered-axle").unwrap().replace("hand = \"right\"", &format!("hand = \"{hand}\""));
        let mut screen = Screen::with(&["axle"], 80, 24, UNICODE, Shelf::new(&[("axle", &source)]));
        for turns in ["positive", "negative", "positive"] {
            if turns == "positive" && screen.app.mode == Mode::Library {
                screen.keys("P");
            } else {
                screen.keys("f");
            }
            let shown = screen.text();
            let expected = source.replace("pinion_turns = \"positive\"", &format!("pinion_turns = \"{turns}\""));
            assert_eq!(text(&screen), expected);
            let figures = PairFigures::new(&read(&expected).design.unwrap());
            let pulls = (hand == "right") != (turns == "positive");
            assert_eq!(figures.pulls_into_mesh(), pulls);
            assert_eq!(shown.contains("! thrust pulls the pinion into mesh on this flank"), pulls, "{shown}");
            let axial = figures.pinion.force.unwrap().axial;
            assert!(shown.contains(if pulls { "-5559.9" } else { "+8840.2" }), "{axial} {shown}");
        }
        screen.keys("u");
        assert!(text(&screen).contains("pinion_turns = \"negative\""));
        screen.keys("<Ctrl-r>uu");
        assert_eq!(text(&screen), source);
        assert!(screen.keys("u").text().contains("nothing to undo"));
    }
}

#[test]
fn mesh_vectors_have_one_flank() {
    let mut screen = pair("overhung-elastic", 80, 24, UNICODE);
    let before = text(&screen);
    assert!(screen.keys("f").text().contains("mesh vectors are of one flank only"), "{}", screen.text());
    assert_eq!(text(&screen), before);
}

/// The flank is another one, and the pressure angle stays that of the first.
#[test]
fn a_flipped_flank_says_whose_pressure_angle_it_has() {
    let mut screen = pair("tapered-hypoid", 120, 40, UNICODE);
    assert!(screen.text().contains("pressure angle 17.747 deg as written"), "{}", screen.text());
    let shown = screen.keys("f").text();
    assert!(shown.contains("other flank; pressure angle as written, 17.7 deg: write its own"), "{shown}");
    assert!(!screen.keys("u").text().contains("other flank;"), "{}", screen.text());
}

#[test]
fn without_gear_data_it_is_said_what_would_tell_the_way_of_the_thrust() {
    let shown = pair("overhung-elastic", 120, 40, UNICODE).text().replace('\n', " ");
    assert!(shown.contains("add [mesh.geometry] for that"), "{shown}");
}

#[test]
fn the_sign_of_a_torque_is_said_not_to_count() {
    let mut screen = Screen::with(&["tapered-axle"], 120, 40, UNICODE, Shelf::shipped());
    let shown = screen.keys("Bt-300<Enter>").text();
    assert!(shown.contains("torque -300 N m, its sign does not count"), "{shown}");
    let shown = screen.keys("<Esc>P").text();
    assert!(shown.contains("sign of the torque"), "{shown}");
}

/// Both members have arrows at one mesh point: small letters are the pinion's, capitals the gear's.
#[test]
fn arrows_of_both_members_are_told_apart() {
    let screen = pair("straddle-helical", 130, 45, UNICODE);
    let text = screen.text();
    let picture: String = text.lines().skip(2).take(38).map(|line| line.chars().take(88).collect::<String>()).collect();
    for letter in ['t', 'T', 'r', 'R'] {
        let alone = |(at, _): (usize, char)| {
            let around = picture.chars().skip(at.saturating_sub(1)).take(3).collect::<String>();
            around.chars().filter(|near| near.is_alphabetic()).count() == 1
        };
        assert!(picture.chars().enumerate().filter(|(_, one)| *one == letter).any(alone), "{letter}: {text}");
    }
}

#[test]
fn an_estimate_is_taken_only_when_it_is_asked_for() {
    let mut screen = pair("tapered-axle", 80, 24, UNICODE);
    let before = text(&screen);
    let shown = screen.keys("K").text();
    assert!(
        shown.contains("estimate  none without a face width") && shown.contains("now       6.400e8 N/m"),
        "{shown}"
    );
    // nothing typed, nothing taken
    assert!(screen.keys("<Enter>").text().contains("face width: a number is wanted in mm"), "{}", screen.text());
    assert_eq!(screen.app.mode, Mode::FaceWidth);
    // sample 1: 6.435e8 N/m; the angle comes from the gear data
    let shown = screen.keys("2.159 cm").text();
    assert!(shown.contains("estimate  6.435e8 N/m") && shown.contains("ISO 10300-1, method B"), "{shown}");
    screen.keys("<Esc>");
    assert_eq!((text(&screen), screen.app.mode), (before.clone(), Mode::Pair));
    // a wrong unit is named with those that are accepted
    let shown = screen.keys("K21 kg<Enter>").text();
    assert!(shown.contains("unknown unit `kg`; accepted: mm"), "{shown}");
    screen.keys("<Ctrl-u>21.59<Tab><Ctrl-u>95<Enter>");
    assert!(screen.text().contains("the spiral angle must be from 0"), "{}", screen.text());
    let shown = screen.keys("<Ctrl-u>35<Enter>").text();
    assert!(
        shown.contains("mesh stiffness 6.4e8 -> 6.435e8 N/m (estimate)") && shown.contains("unsaved edits"),
        "{shown}"
    );
    // the comment above the old number gives way to one that says where the new one comes from
    let comment = "# estimate: ISO 10300-1, method B, 20 N/(mm um) over the effective face width, 21.59 mm, along the tooth normal";
    let old = format!("{comment}\nstiffness_n_per_m = 6.4e8\n");
    let sum = "20 N/(mm um) x 21.590 mm / cos^2(35.000 deg)";
    let new = format!("stiffness_n_per_m = 6.435e8  # {}: {sum}\n", bevelscope::pair::METHOD);
    assert!(before.contains(&old));
    assert_eq!(text(&screen), before.replace(&old, &new));
    // it is solved like any edit
    assert!(screen.effects.iter().any(|effect| matches!(effect, Effect::SolveEdited(_))));
    assert!(screen.keys("u").text().contains("undo: stiffness of the mesh (estimate"), "{}", screen.text());
    assert_eq!(text(&screen), before);
}

const DRIVE: &str = "drive,6e8,3,0,0.1,27.46,0.76975,-0.62285,0.1398,0,0,76.49,-0.76975,0.1398,-0.62285";
const COAST: &str = "coast,5.1e8,4,0,0,27.46,-0.76975,0.39173,0.50401,0,0,76.49,0.76975,0.50401,0.39173";

/// The gear pair of a shipped design, with tables of mesh numbers at hand.
fn importing(stem: &str, capabilities: Capabilities) -> Screen {
    let shelf = Shelf::shipped();
    let head = COLUMNS.join(",");
    let both = format!("{head}\n{DRIVE}\n{COAST}\n");
    for (name, text) in [
        ("mesh.csv", both.clone()),
        ("coast.csv", format!("{head}\n{COAST}\n")),
        ("wrong.csv", both.replace("0,0.1,27.46", "0,0.1,x\u{1b}[2J")),
    ] {
        shelf.texts.lock().unwrap().insert(PathBuf::from(name), text);
    }
    let mut screen = Screen::with(&[stem], 80, 24, capabilities, shelf);
    screen.keys("P");
    screen
}

#[test]
fn an_import_shows_what_it_changes_and_is_one_edit() {
    for stem in ["tapered-axle", "overhung-elastic"] {
        let mut screen = importing(stem, UNICODE);
        let before = text(&screen);
        let shown = screen.keys("Imesh.csv<Enter>").text();
        assert!(shown.contains("the drive flank would change") && shown.contains("-> 6e8 N/m"), "{shown}");
        assert_eq!(text(&screen), before, "nothing is changed before it is asked for");
        // the other flank without reading again
        let shown = screen.keys("<Tab>").text();
        assert!(shown.contains("the coast flank would change"), "{shown}");
        screen.keys("<Esc>");
        assert_eq!((text(&screen), screen.app.mode), (before.clone(), Mode::Pair));
        let shown = screen.keys("I<Tab>mesh.csv<Enter><Enter>").text();
        assert!(shown.contains("done: averaged mesh numbers of the coast flank"), "{shown}");
        let design = read(&text(&screen)).design.unwrap();
        assert_eq!((design.mesh.stiffness, design.mesh.transmission_error), (5.1e8, 4e-6));
        assert!(design.mesh.geometry.is_none() && design.mesh.pinion.line_of_action[0] < 0.0);
        screen.keys("u");
        assert_eq!(text(&screen), before);
    }
}

#[test]
fn a_table_that_is_wrong_says_where_and_changes_nothing() {
    let mut screen = importing("tapered-axle", UNICODE);
    let before = text(&screen);
    for (keys, said) in [
        ("I<Enter>", "the name of a CSV file is wanted"),
        ("none.csv<Enter>", "there is no such file"),
        ("<Ctrl-u>wrong.csv<Enter>", "line 2: pinion_point_z_mm must be a number"),
        ("<Ctrl-u>coast.csv<Enter>", "there is no line for the flank drive"),
    ] {
        let shown = screen.keys(keys).text();
        assert!(shown.replace('\n', "").contains(said) && !shown.contains('\u{1b}'), "{said}: {shown}");
        assert_eq!(screen.app.mode, Mode::MeshFile);
    }
    let shown = screen.keys("<Tab><Enter>").text();
    assert!(shown.contains("the coast flank would change"), "{shown}");
    // the flank that the table has not
    assert!(screen.keys("<Tab>").text().contains("there is no line for the flank drive"));
    screen.keys("<Enter><Esc>");
    assert_eq!(text(&screen), before);
}

#[test]
fn an_answer_that_nobody_waits_for_any_more_is_dropped() {
    let mut screen = importing("tapered-axle", UNICODE);
    screen.keys("Imesh.csv");
    let ticket = bevelscope::tui::solving::Ticket(u64::MAX);
    let result = Err("of another file".to_owned());
    screen.send(bevelscope::tui::message::Message::MeshTable { ticket, result });
    assert!(!screen.text().contains("of another file") && screen.app.mode == Mode::MeshFile);
}

#[test]
fn back_goes_where_it_was_opened() {
    let mut screen = pair("tapered-axle", 80, 24, UNICODE);
    screen.keys("f<Esc>");
    assert_eq!(screen.app.mode, Mode::Library);
    assert!(screen.app.editors.open().is_none() && screen.app.editors.unsaved().count() == 1);
    // with the edits, from the list and from the tables
    assert!(screen.keys("P").text().contains("thrust pulls the pinion into mesh"));
    screen.keys("<Esc>e<F4>P");
    assert!(screen.text().contains("thrust pulls the pinion into mesh"));
    screen.keys("q");
    assert_eq!(screen.app.mode, Mode::Table);
    assert!(screen.keys("Ps").text().contains("saved tapered-axle"), "{}", screen.text());
}

#[test]
fn a_text_that_is_no_design_says_what_is_wrong() {
    let broken = Shelf::shipped().text("tapered-axle").unwrap().replace("hand = \"right\"", "hand = \"both\"");
    let files = [("broken", broken.as_str()), ("no-toml", "name = ")];
    let mut screen = Screen::with(&["broken", "no-toml"], 80, 24, UNICODE, Shelf::new(&files));
    let shown = screen.keys("P").text();
    assert!(shown.contains("No gear pair: the design has errors") && shown.contains("hand"), "{shown}");
    for key in ["f", "K", "<Esc>", "I", "<Esc>", "y"] {
        screen.keys(key);
    }
    screen.keys("<Esc>jP");
    assert!(screen.app.mode == Mode::Library && screen.text().contains("no tables"), "{}", screen.text());
    assert!(screen.app.pair.is_none());
}

#[test]
fn vectors_from_gear_data_are_not_typed_into() {
    let mut screen = Screen::with(&["tapered-axle"], 80, 24, UNICODE, Shelf::shipped());
    screen.keys("e<F4>jjj");
    let before = text(&screen);
    for key in ["<Enter>", "c", "7", "x"] {
        let shown = screen.keys(key).text();
        assert!(shown.contains("From the gear data in [mesh.geometry]"), "{key}: {shown}");
        assert_eq!((screen.app.mode, text(&screen)), (Mode::Table, before.clone()));
    }
    // beside the values, readable without colour
    screen.keys("jj");
    assert!(screen.text().contains("= 27.459") && screen.text().contains("from the gear data"), "{}", screen.text());
}
