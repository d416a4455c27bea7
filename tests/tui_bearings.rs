//! The screen of the bearings under load: what it says, what the torque does, what is solved again.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::Duration;

use bevelscope::bearing::{Contact, State, Vector};
use bevelscope::comparison::{Comparison, Observer, SolveError};
use bevelscope::design::library::SHIPPED;
use bevelscope::design::{Design, Edit, Editor, KeyPath, Side, Spelled};
use bevelscope::model::Rotors;
use bevelscope::number::grouped;
use bevelscope::tui::bearings::{self, BearingRow, BearingStates};
use bevelscope::tui::caps::{Capabilities, ColourDepth};
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::message::{Effect, Message};
use bevelscope::tui::solving::{EditedJob, Job, Ticket};
use bevelscope::tui::theme::Theme;
use bevelscope::tui::widgets::element_loads;
use bevelscope::tui::worker::Worker;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign};
use proptest::prelude::*;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use tui_support::{ASCII, Screen, Shelf, UNICODE};

const AXLE: &str = "tapered-axle";

fn opened(stem: &str, width: u16, height: u16, capabilities: Capabilities) -> Screen {
    let mut screen = Screen::with(&[stem], width, height, capabilities, Shelf::shipped());
    screen.keys("B");
    assert_eq!(screen.app.mode, Mode::Bearings);
    screen
}

fn axle() -> Screen {
    opened(AXLE, 120, 40, UNICODE)
}

/// A shipped design after some values were written.
fn edited(stem: &str, values: &[(&str, &str)]) -> String {
    let shipped = SHIPPED.iter().find(|one| one.file_name == format!("{stem}.toml")).unwrap();
    let mut editor = Editor::new(shipped.text).unwrap();
    for (path, value) in values {
        let path = path.parse::<KeyPath>().unwrap();
        editor.apply(&Edit::Set { path, value: Spelled::parse(value).unwrap() }).unwrap();
    }
    editor.text().to_owned()
}

/// What the screen shows of the design in sight.
fn states(screen: &Screen) -> Arc<BearingStates> {
    screen.app.editors.open().unwrap().solving.current.as_ref().unwrap().bearings.clone().unwrap()
}

fn torque(screen: &Screen) -> f64 {
    bearings::torque(screen.app.editors.open().unwrap().design.as_ref().unwrap()).unwrap()
}

#[test]
fn bearings_at_several_sizes() {
    insta::assert_snapshot!("bearings_80x24_ascii", opened(AXLE, 80, 24, ASCII).keys("++ll").text());
    insta::assert_snapshot!("state_80x24_ascii", opened(AXLE, 80, 24, ASCII).keys("jj<Tab>").text());
    insta::assert_snapshot!("bearings_120x40", axle().keys("jj++lll").text());
    insta::assert_snapshot!("bearings_60x18", opened(AXLE, 60, 18, UNICODE).text());
    insta::assert_snapshot!("state_60x18", opened(AXLE, 60, 18, UNICODE).keys("<Tab>").text());
    insta::assert_snapshot!("elements_60x18", opened(AXLE, 60, 18, UNICODE).keys("jj<Tab><Tab>").text());
}

#[test]
fn bearings_styles_monochrome() {
    let without = Capabilities { colour: ColourDepth::None, ..UNICODE };
    insta::assert_snapshot!(opened(AXLE, 80, 24, without).styles());
}

#[test]
fn a_linear_bearing_says_what_it_is_and_that_no_torque_changes_it() {
    let mut screen = opened("overhung-elastic", 120, 40, UNICODE);
    let text = screen.text();
    assert!(text.contains("A diagonal bearing is linear"), "{text}");
    assert!(text.contains("no bearing here follows the torque: the spectra do not depend on it"), "{text}");
    assert!(text.contains("6.0000e8") || text.contains("6.000e8"), "the stiffness is shown: {text}");
    screen.effects.clear();
    let text = screen.keys("t250<Enter>").text();
    assert!(text.contains("torque 250 N m: no bearing follows it, and neither do the spectra"), "{text}");
    assert!(!screen.effects.iter().any(|effect| matches!(effect, Effect::SolveEdited(_))), "nothing is solved");
    assert!(screen.keys("+").text().contains("torque 260 N m"));
    let rigid = opened("overhung-rigid", 120, 40, UNICODE).text();
    assert!(rigid.contains("rigid: holds x, y, z"), "{rigid}");
}

#[test]
fn the_torque_is_an_edit_like_any_other_and_the_spectra_follow() {
    let shelf = Shelf::shipped();
    let mut screen = Screen::with(&[AXLE], 120, 40, UNICODE, shelf.clone());
    screen.keys("B");
    let rms = |screen: &Screen| {
        let editing = screen.app.editors.open().unwrap();
        editing.solving.current.as_ref().unwrap().summary.enhanced.rms_db
    };
    let (before, load) = (rms(&screen), states(&screen).side(Side::Pinion).rolling[0].clone().unwrap().state.load);
    screen.keys("++");
    assert_eq!(torque(&screen), 320.0);
    let more = states(&screen).side(Side::Pinion).rolling[0].clone().unwrap().state.load;
    assert!(rms(&screen) != before && more.norm() > load.norm());
    let text = screen.text();
    assert!(text.contains("Bearings at 320 N m (saved: 300 N m)") && text.contains("FE saved"), "{text}");
    assert!(text.contains("(was 2.71)"), "{text}");
    // undone one by one, and saved from here
    screen.keys("u");
    assert_eq!(torque(&screen), 310.0);
    screen.keys("u");
    assert!(!screen.app.editors.open().unwrap().is_modified() && rms(&screen) == before);
    screen.keys("<Ctrl-r>>");
    assert_eq!(torque(&screen), 350.0);
    screen.keys("<-");
    assert_eq!(torque(&screen), 290.0);
    screen.keys("s");
    assert!(shelf.text(AXLE).unwrap().contains("\npinion_torque_n_m = 290.0\n"));
    assert!(!screen.app.editors.open().unwrap().is_modified());
    // typed, with another unit; what is no torque is refused and can be mended
    screen.keys("t<Ctrl-u>50 kg<Enter>");
    assert_eq!((screen.app.mode, torque(&screen)), (Mode::Torque, 290.0));
    screen.keys("<Ctrl-u>221.27 lbf ft<Enter>");
    assert_eq!(screen.app.mode, Mode::Bearings);
    // 1 lbf ft = 4.4482216152605 N times 0.3048 m
    assert!((torque(&screen) / (221.27 * 4.448_221_615_260_5 * 0.3048) - 1.0).abs() < 1e-9, "{}", torque(&screen));
}

/// The load and the stiffness beside those of the saved torque.
#[test]
fn what_a_torque_does_to_a_bearing_stands_beside_what_it_was() {
    let mut screen = axle();
    let greatest = |screen: &Screen| {
        let states = states(screen);
        let side = states.side(Side::Pinion);
        let support = &side.supports[0].stiffness;
        (side.rolling[0].as_ref().unwrap().state.greatest_load(), support[(0, 0)], support[(2, 2)])
    };
    let before = greatest(&screen);
    assert!(!screen.text().contains("(was"), "{}", screen.text());
    let shown = screen.keys("t600<Enter>").text();
    let now = greatest(&screen);
    let percent = |now: f64, before: f64| format!("{:+.1} %", 100.0 * (now / before - 1.0));
    let said = format!(
        "most {} N (was {}), kx {}, kz {}",
        grouped(now.0),
        grouped(before.0),
        percent(now.1, before.1),
        percent(now.2, before.2)
    );
    assert!(shown.contains(&format!("torque 600 N m: {said}")), "{said}: {shown}");
    assert!(screen.keys("j").text().contains("since saved: most "), "{}", screen.text());
    assert!(!screen.keys("u").text().contains("kx +"), "{}", screen.text());
}

/// The torque is named where a bearing follows it, and each row says where its load comes from.
#[test]
fn the_title_and_the_rows_say_where_loads_come_from() {
    let shown = axle().text();
    assert!(
        shown.contains("Bearings at 300 N m") && shown.contains("load by") && shown.contains(" torque "),
        "{shown}"
    );
    let shown = opened("straddle-helical", 80, 24, UNICODE).text();
    assert!(shown.contains("Bearings: loads by preload") && shown.contains(" preload "), "{shown}");
    // beside 900 N, 1e-13 N is rounding
    assert!(!shown.contains("e-1"), "{shown}");
}

#[test]
fn a_small_terminal_shows_four_bearings() {
    let screen = opened(AXLE, 60, 18, UNICODE);
    let shown = screen.text();
    assert!(!shown.contains("1-1 of"), "{shown}");
    let rows = |text: &str| text.lines().filter(|line| line.contains("pinion ") || line.contains("gear ")).count();
    assert!(rows(&shown) >= 4, "{shown}");
}

#[test]
fn the_screen_leads_back_to_where_it_was_opened() {
    let mut screen = axle();
    screen.keys("+<Esc>");
    assert_eq!((screen.app.mode, screen.app.editors.open().is_none()), (Mode::Library, true));
    // the edit is kept, and opens with the screen
    let text = screen.keys("B").text();
    assert!(text.contains("Bearings at 310 N m (saved: 300 N m)"), "{text}");
    screen.keys("u<Esc>");
    // from the tables: on the bearing under the cursor, and back there
    screen.keys("e<F2>pjB");
    let text = screen.text();
    assert!(text.contains("Element loads of gear B2"), "{text}");
    screen.keys("q");
    assert_eq!(screen.app.mode, Mode::Table);
    // Enter leads to the row
    screen.keys("Bkk<Enter>");
    let editing = screen.app.editors.open().unwrap();
    assert_eq!((screen.app.mode, editing.title().as_str(), editing.cursor().row), (Mode::Table, "pinion bearings", 1));
}

#[test]
fn the_tables_say_what_a_bearing_carries() {
    let mut screen = Screen::with(&[AXLE], 120, 40, UNICODE, Shelf::shipped());
    let text = screen.keys("e<F2>").text();
    assert!(text.contains("load -13,902, 10,291, -61 N in x, y, z, 17 of 17 loaded at 20.0 deg (B)"), "{text}");
    let diagonal = Screen::with(&["overhung-elastic"], 120, 40, UNICODE, Shelf::shipped()).keys("e<F2>").text();
    assert!(!diagonal.contains(" loaded at "), "{diagonal}");
}

/// Counts how often mean states of each shaft were found anew, by the places that they are kept at.
#[derive(Default)]
struct Counter {
    last: Option<Arc<BearingStates>>,
    found: [usize; 2],
}

impl Counter {
    fn see(&mut self, now: Arc<BearingStates>) -> [usize; 2] {
        for side in Side::BOTH {
            let is_same = |last: &Arc<BearingStates>| Arc::ptr_eq(&last.side(side).rolling, &now.side(side).rolling);
            self.found[side as usize] += usize::from(!self.last.as_ref().is_some_and(is_same));
        }
        self.last = Some(now);
        self.found
    }
}

#[test]
fn a_shaft_is_solved_again_only_where_something_it_depends_on_has_changed() {
    let mut screen = axle();
    let mut counter = Counter::default();
    screen.keys("+");
    assert_eq!(counter.see(states(&screen)), [1, 1]);
    // in the tables below, as a user does it
    screen.keys("<Enter>");
    let in_cell = |screen: &mut Screen, path: &str, typed: &str| {
        let editing = screen.app.editors.open_mut().unwrap();
        editing.go_to(&path.parse().unwrap());
        screen.keys("c").keys(typed).keys("<Enter>");
        assert!(!screen.app.editors.open().unwrap().wants_solution(), "{path}: solved");
    };
    for (path, typed) in [
        ("mesh.damping", "0.07"),
        ("name", "Another"),
        ("analysis.frequency_lines", "900"),
        ("analysis.structural_damping", "0.04"),
        ("mesh.stiffness_n_per_m", "7e8"),
        ("pinion.bearing[0].name", "front"),
        ("pinion.bearing[0].axial_series_stiffness_n_per_m", "5e9"),
        ("gear.body[0].mass_kg", "4"),
        ("operating.pinion_speed_rpm", "900"),
    ] {
        in_cell(&mut screen, path, typed);
        assert_eq!(counter.see(states(&screen)), [1, 1], "{path}");
    }
    in_cell(&mut screen, "gear.bearing[1].mounting_preload_um", "14");
    assert_eq!(counter.see(states(&screen)), [1, 2]);
    in_cell(&mut screen, "pinion.segment[2].outer_diameter_mm", "37");
    assert_eq!(counter.see(states(&screen)), [2, 2]);
    screen.keys("B-");
    assert_eq!(counter.see(states(&screen)), [3, 3]);
    // what was shown is what a fresh start finds
    let design = Arc::clone(screen.app.editors.open().unwrap().design.as_ref().unwrap());
    assert_eq!(*states(&screen), BearingStates::of(&Rotors::new(&design).unwrap()));
}

#[test]
fn what_the_list_has_solved_is_taken_over_by_the_tables() {
    let (sender, messages) = channel();
    let worker = Worker::start(Arc::new(Shelf::shipped()), &sender).unwrap();
    let path = PathBuf::from(format!("/designs/{AXLE}.toml"));
    let mut counter = Counter::default();
    let solved = |messages: &Receiver<Message>| loop {
        match messages.recv_timeout(Duration::from_secs(60)).unwrap() {
            Message::Solved { result, .. } | Message::SolvedEdited { result, .. } => {
                return result.unwrap().bearings.unwrap();
            }
            _ => {}
        }
    };
    worker.solve(Job { ticket: Ticket(1), path: path.clone(), with_traces: true });
    assert_eq!(counter.see(solved(&messages)), [1, 1]);
    let mut design = Shelf::shipped().load(&path).unwrap().design;
    design.mesh.damping *= 1.1;
    worker.solve_edited(EditedJob { ticket: Ticket(2), path: path.clone(), design: Arc::new(design.clone()) });
    assert_eq!(counter.see(solved(&messages)), [1, 1]);
    design.operating.as_mut().unwrap().pinion_torque = Some(310.0);
    worker.solve_edited(EditedJob { ticket: Ticket(3), path, design: Arc::new(design) });
    assert_eq!(counter.see(solved(&messages)), [2, 2]);
}

/// Solves edits only when it is let.
struct Gate {
    shelf: Shelf,
    started: Sender<f64>,
}

impl Backend for Gate {
    fn load(&self, path: &std::path::Path) -> Result<LoadedDesign, BrokenDesign> {
        self.shelf.load(path)
    }

    fn compare(&self, design: &Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        let torque = bearings::torque(design).unwrap();
        self.started.send(torque).unwrap();
        // the last one of the test is let through, the others until they are no longer wanted
        if torque < 400.0 {
            while observer(0.5).is_continue() {
                std::thread::sleep(Duration::from_millis(1));
            }
            return Err(SolveError::Cancelled);
        }
        self.shelf.compare(design, observer)
    }
}

#[test]
fn while_a_key_is_held_down_keys_are_answered_and_the_latest_torque_wins() {
    const LONG: Duration = Duration::from_secs(60);
    let (started, solving) = channel();
    let (sender, messages) = channel();
    let worker = Worker::start(Arc::new(Gate { shelf: Shelf::shipped(), started }), &sender).unwrap();
    let mut screen = axle();
    screen.held = true;
    let mut pressed = 0;
    while torque(&screen) < 400.0 {
        screen.effects.clear();
        screen.keys("+");
        pressed += 1;
        // each press is seen at once, although nothing has been solved since the first
        let text = screen.text();
        assert!(text.contains(&format!("stale: Bearings at {} N m", torque(&screen))), "{text}");
        let jobs = screen.effects.iter().filter_map(|effect| match effect {
            Effect::SolveEdited(job) => Some(job.clone()),
            _ => None,
        });
        let jobs: Vec<EditedJob> = jobs.collect();
        assert_eq!(jobs.len(), 1);
        worker.solve_edited(jobs[0].clone());
        if pressed == 1 {
            assert_eq!(solving.recv_timeout(LONG), Ok(310.0));
        }
    }
    assert!(pressed >= 8, "{pressed}");
    // of those that were held none is reported
    let (ticket, path, result) = loop {
        if let Message::SolvedEdited { ticket, path, result } = messages.recv_timeout(LONG).unwrap() {
            break (ticket, path, result);
        }
    };
    screen.send(Message::SolvedEdited { ticket, path, result });
    let editing = screen.app.editors.open().unwrap();
    let solution = editing.solving.current.as_ref().unwrap();
    assert_eq!(bearings::torque(&solution.design), Some(torque(&screen)));
    assert!(!editing.is_stale() && editing.solving.pending.is_none());
    assert!(!messages.try_iter().any(|message| matches!(message, Message::SolvedEdited { .. })));
}

#[test]
fn a_result_that_comes_late_is_not_taken_for_the_latest() {
    let mut screen = axle();
    screen.held = true;
    screen.effects.clear();
    screen.keys("++");
    let jobs: Vec<EditedJob> = screen
        .effects
        .iter()
        .filter_map(|effect| if let Effect::SolveEdited(job) = effect { Some(job.clone()) } else { None })
        .collect();
    assert_eq!(jobs.len(), 2);
    screen.perform_edited(&jobs[0]);
    screen.draw();
    assert!(screen.text().contains("stale: Bearings at 320 N m"));
    screen.perform_edited(&jobs[1]);
    screen.draw();
    assert!(screen.text().contains("┌ Bearings at 320 N m (saved: 300 N m)"), "{}", screen.text());
}

#[test]
fn what_cannot_be_solved_is_said_with_the_name_of_the_bearing() {
    let shelf = Shelf::new(&[
        // both tapers of the gear lift off as soon as nothing presses them together
        (
            "no-contact",
            &edited(
                AXLE,
                &[("gear.bearing[0].mounting_preload_um", "0.0"), ("gear.bearing[1].mounting_preload_um", "0.0")],
            ),
        ),
        (
            "backwards",
            &edited(
                AXLE,
                &[("pinion.bearing[0].contact_angle_deg", "-20.0"), ("pinion.bearing[1].contact_angle_deg", "-16.0")],
            ),
        ),
    ]);
    let mut screen = Screen::with(&["no-contact"], 120, 40, UNICODE, shelf.clone());
    let text = screen.keys("Bt<Ctrl-u>0<Enter>").text();
    assert!(text.contains("gear shaft: bearing \"B1\": NO_CONTACT:"), "{text}");
    let row = text.lines().find(|line| line.contains("gear B1")).unwrap();
    assert!(row.contains("× gear B1") && row.contains("NO_CONTACT"), "{row}");
    assert!(!text.lines().any(|line| line.contains("pinion head bearing") && line.contains("NO_CONTACT")), "{text}");
    assert!(text.contains("stale: Bearings at 0 N m"), "{text}");
    // with the torque back everything is there again
    let text = screen.keys("u").text();
    assert!(!text.contains("NO_CONTACT") && !text.contains("stale"), "{text}");

    let text = Screen::with(&["backwards"], 80, 24, UNICODE, shelf).keys("B").text();
    assert!(text.contains("UNSUPPORTED_LOAD"), "{text}");
    assert!(text.lines().any(|line| line.contains("pinion") && line.contains("UNSUPPORTED_LOAD")), "{text}");
}

#[test]
fn without_a_torque_the_keys_say_how_one_is_given() {
    let mut screen = opened("overhung-elastic", 80, 24, UNICODE);
    let text = screen.keys("+").text();
    assert!(text.contains("no torque is given: t types a torque"), "{text}");
    assert!(!screen.app.editors.open().unwrap().is_modified());
}

#[test]
fn a_drive_is_removed_and_added_in_its_table() {
    let shelf = Shelf::shipped();
    let mut screen = Screen::with(&["overhung-elastic"], 120, 40, UNICODE, shelf.clone());
    screen.keys("e<F5>");
    let has_drive = |screen: &Screen| {
        let editing = screen.app.editors.open().unwrap();
        editing.design.as_ref().map(|design| design.pinion.drive.is_some())
    };
    assert_eq!(has_drive(&screen), Some(true));
    let text = screen.keys("D").text();
    assert!(has_drive(&screen) == Some(false) && text.contains("turns freely"), "{text}");
    assert!(screen.keys("D").text().contains("this shaft has no drive"));
    // the gear's is its own
    assert!(screen.app.editors.open().unwrap().design.as_ref().unwrap().gear.drive.is_some());
    let text = screen.keys("a").text();
    assert!(text.contains("stiffness and inertia are still wanted") && has_drive(&screen).is_none(), "{text}");
    let findings = screen.app.editors.open().unwrap().sentences(&screen.app.editors.open().unwrap().problems());
    assert!(findings.iter().filter(|finding| finding.contains("missing")).count() == 2, "{findings:?}");
    let editing = screen.app.editors.open_mut().unwrap();
    editing.go_to(&"pinion.drive.torsional_stiffness_n_m_per_rad".parse().unwrap());
    screen.keys("c1.2e4<Enter>c0.02<Enter>");
    let design = Arc::clone(screen.app.editors.open().unwrap().design.as_ref().unwrap());
    assert!((design.pinion.drive.unwrap().position - design.pinion.length()).abs() < 1e-12);
    // all of it is taken back, to the byte
    screen.keys("uuuu");
    let editing = screen.app.editors.open().unwrap();
    assert_eq!(editing.editor.text(), shelf.text("overhung-elastic").unwrap());
}

fn state(contacts: Vec<Contact>, load: [f64; 5]) -> State {
    State {
        displacement: Vector::zeros(),
        load: Vector::from(load),
        stiffness: bevelscope::bearing::Matrix::zeros(),
        contacts,
        warnings: Vec::new(),
    }
}

/// Loads of any size, also none and what is no number.
fn any_load() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), 0.0..1e5_f64, Just(f64::MAX), Just(f64::MIN_POSITIVE), Just(f64::NAN), Just(f64::INFINITY)]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// One to a hundred elements, any loads, any window, any marker: drawn inside its place and nowhere else.
    #[test]
    fn the_picture_draws_anything_inside_its_place(
        loads in prop::collection::vec(any_load(), 0..=100),
        resultant in [any_load(), any_load()],
        (width, height) in (0..120_u16, 0..60_u16),
        selected in 0..120_usize,
        steps in 0..4_usize,
        is_ascii in any::<bool>(),
    ) {
        let count = loads.len();
        let contact = |(at, load): (usize, &f64)| Contact {
            position: std::f64::consts::TAU * at as f64 / count as f64,
            load: *load,
            deflection: 1e-6,
            angle: 0.3,
        };
        let contacts = loads.iter().enumerate().map(contact).collect();
        let state = state(contacts, [resultant[0], resultant[1], 0.0, 0.0, 0.0]);
        let mut theme = Theme::new(if is_ascii { ASCII } else { UNICODE });
        for _ in 0..steps {
            theme.marker = theme.marker.next(is_ascii);
        }
        let whole = Rect::new(0, 0, width + 4, height + 2);
        let mut buffer = Buffer::empty(whole);
        element_loads::render(&state, selected, &theme, Rect::new(2, 1, width, height), &mut buffer);
        for y in 0..whole.height {
            for x in 0..whole.width {
                let is_inside = (2..2 + width).contains(&x) && (1..=height).contains(&y);
                prop_assert!(is_inside || buffer[(x, y)].symbol() == " ", "{x} {y}");
            }
        }
    }
}

/// Seen from +y the azimuth runs against the clock: the bar of the loaded element at a quarter turn from +z, which is +x, is on the left.
#[test]
fn a_bar_stands_where_its_element_is() {
    let elements = 8;
    for loaded in 0..elements {
        let contact = |at: usize| Contact {
            position: std::f64::consts::TAU * at as f64 / f64::from(elements as u32),
            load: if at == loaded { 1000.0 } else { 0.0 },
            deflection: 0.0,
            angle: 0.0,
        };
        let state = state((0..elements).map(contact).collect(), [0.0; 5]);
        // too low for a list of the elements
        let area = Rect::new(0, 0, 31, 13);
        let mut buffer = Buffer::empty(area);
        let selected = (loaded + 4) % elements;
        element_loads::render(&state, selected, &Theme::new(ASCII), area, &mut buffer);
        let bars: Vec<(f64, f64)> = (0..area.height)
            .flat_map(|y| (0..area.width).map(move |x| (x, y)))
            .filter(|place| buffer[*place].symbol() == "#")
            .map(|(x, y)| (f64::from(x) + 0.5 - 15.5, 2.0 * (f64::from(y) + 0.5) - 13.0))
            .collect();
        assert!(bars.len() >= 3, "{loaded}");
        let azimuth = contact(loaded).position;
        for (x, y) in bars {
            let off = (-x * azimuth.cos() + y * azimuth.sin()).abs();
            let out = -x * azimuth.sin() - y * azimuth.cos();
            assert!(off < 2.0 && out > 5.5, "{loaded}: {x} {y}");
        }
    }
}

/// The vector sum of what is drawn is the load that stands beside it: to 1e-9 of its size, for every shipped design.
#[test]
fn the_elements_that_are_drawn_add_up_to_the_load() {
    let mut seen = 0;
    for shipped in SHIPPED {
        let design = bevelscope::design::read(shipped.text).design.unwrap();
        for torque in [100.0, 300.0, 900.0] {
            let mut design = design.clone();
            if let Some(operating) = &mut design.operating {
                operating.pinion_torque = Some(torque);
            }
            let Ok(rotors) = Rotors::new(&design) else { continue };
            let states = BearingStates::of(&rotors);
            for rolling in Side::BOTH.into_iter().flat_map(|side| states.side(side).rolling.iter().flatten()) {
                let load = bearings::load(rolling);
                let mut sum = nalgebra::Vector3::zeros();
                for contact in &rolling.state.contacts {
                    let radial = contact.load * contact.angle.cos();
                    let (sin, cos) = contact.position.sin_cos();
                    sum += nalgebra::Vector3::new(radial * sin, contact.load * contact.angle.sin(), radial * cos);
                }
                let off = (sum - load.fixed_rows::<3>(0)).amax();
                assert!(off <= 1e-9 * bearings::resultant(&load), "{}: {off}", shipped.file_name);
                seen += 1;
            }
        }
    }
    assert!(seen >= 20, "{seen}");
}

#[test]
fn a_failure_is_about_the_bearings_that_it_names_or_about_all_of_a_shaft_under_torque() {
    let design = bevelscope::design::read(&edited(AXLE, &[])).design.unwrap();
    let row = |side: Side, place: usize| BearingRow {
        side,
        place,
        bearing: &design.rotor(side).bearings[place],
        support: None,
        rolling: None,
    };
    let found = |reason: &str| {
        let places = [(Side::Pinion, 0), (Side::Pinion, 1), (Side::Gear, 0), (Side::Gear, 1)];
        places.map(|(side, place)| bearings::failure_of(reason, &row(side, place)).unwrap_or("").to_owned())
    };
    let named = "pinion shaft: bearing \"tail bearing\": NO_CONTACT: no element; gear shaft: UNSUPPORTED_LOAD: bearing \"B1\" gives way";
    assert_eq!(found(named), ["", "NO_CONTACT", "UNSUPPORTED_LOAD", ""]);
    assert_eq!(found("gear shaft: NO_CONVERGENCE: no mean state"), ["", "", "NO_CONVERGENCE", "NO_CONVERGENCE"]);
    assert_eq!(found("both shafts: SINGULAR: even with all"), ["SINGULAR"; 4]);
    assert_eq!(found("gear shaft: nothing holds it in y"), [""; 4]);
}
