//! The wide screen: key scripts, its figures against the library's, and the order of results.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod tui_support;

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;
use std::sync::mpsc::{self, Sender};
use std::time::Duration;

use bevelscope::agreement::{ModalComparison, ModalError, disagreement_bands, pair_peaks, peaks};
use bevelscope::comparison::{Comparison, Observer, SolveError, solve, solve_with_bearings};
use bevelscope::design::library::SHIPPED;
use bevelscope::design::{self, Design};
use bevelscope::model::{Model, ModelKind, Rotors, mesh_frequency_hz, pinion_speed_rpm};
use bevelscope::response::{Modes, ResponseError, Solved, both_rotor_modes, frequency_lines};
use bevelscope::tui::caps::{Capabilities, ColourDepth};
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::message::{Effect, Message};
use bevelscope::tui::solving::Ticket;
use bevelscope::tui::spectra::{Labelled, ModelCurves, Part, Quantity, SpectraJob, SpectraView, Subject};
use bevelscope::tui::worker::Worker;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign};
use insta::assert_snapshot;
use num_complex::Complex64;
use tui_support::{ASCII, Screen, Shelf, UNICODE};

const STEM: &str = "overhung-elastic";

fn text() -> &'static str {
    SHIPPED.iter().find(|shipped| shipped.file_name.starts_with(STEM)).unwrap().text
}

fn subject() -> (Design, Rotors, Vec<f64>) {
    let design = design::read(text()).design.unwrap();
    let rotors = Rotors::new(&design).unwrap();
    let lines = frequency_lines(&design.analysis);
    (design, rotors, lines)
}

fn wide(width: u16, height: u16, capabilities: Capabilities, keys: &str) -> Screen {
    let mut screen = Screen::with(&[STEM], width, height, capabilities, Shelf::shipped());
    screen.keys("w").keys(keys);
    screen
}

fn view(screen: &Screen) -> &SpectraView {
    screen.app.spectra.as_ref().unwrap()
}

#[test]
fn spectra_80x24_ascii() {
    assert_snapshot!(wide(80, 24, ASCII, "n").text());
}

#[test]
fn spectra_120x40() {
    assert_snapshot!(wide(120, 40, UNICODE, "4pa<Tab>").text());
}

#[test]
fn spectra_60x18() {
    assert_snapshot!(wide(60, 18, UNICODE, "vvii").text());
}

#[test]
fn why_80x24_ascii() {
    assert_snapshot!(wide(80, 24, ASCII, "nn<Enter>").text());
}

#[test]
fn colours_change_no_text() {
    for keys in ["", "4a", "n<Enter>"] {
        let plain = wide(80, 24, Capabilities { colour: ColourDepth::None, ..UNICODE }, keys).text();
        assert_eq!(wide(80, 24, UNICODE, keys).text(), plain, "{keys}");
    }
}

#[test]
fn the_cursor_is_on_a_line_and_its_figures_are_the_librarys() {
    let (design, rotors, lines) = subject();
    let mut screen = wide(120, 40, UNICODE, "llH");
    for kind in [ModelKind::Fe, ModelKind::Enhanced, ModelKind::Basic] {
        let at = view(&screen).cursor;
        let force = solve(kind, &design, &rotors, &lines).unwrap().mesh_force[at];
        let db = format!("{:.2} dB", 20.0 * force.norm().log10());
        assert!(screen.text().contains(&db), "{kind:?} {db}\n{}", screen.text());
    }
    let speed = pinion_speed_rpm(&design, lines[view(&screen).cursor]).unwrap();
    assert!(screen.text().replace(',', "").contains(&format!("pinion {speed:.0} rpm")));
    // each of the bearings, in the design's order, and each part of its force
    let all = solve_with_bearings(ModelKind::Enhanced, &design, &rotors, &lines).unwrap();
    screen.keys("v");
    for bearing in &all.bearings {
        screen.keys("v");
        let parts: [fn(&[Complex64; 6]) -> f64; 5] = [
            |f| f[0].norm().hypot(f[1].norm()).hypot(f[2].norm()),
            |f| f[0].norm(),
            |f| f[1].norm(),
            |f| f[2].norm(),
            |f| f[0].norm().hypot(f[2].norm()),
        ];
        for part in parts {
            let view = view(&screen);
            let curve = view.curve(ModelKind::Enhanced, view.quantity).unwrap();
            for (at, force) in bearing.force.iter().enumerate().step_by(97) {
                let wanted = part(force);
                assert!((curve.lines[at].norm() - wanted).abs() <= 1e-9 * wanted, "{} {at}", bearing.name);
            }
            assert!(screen.text().contains("recovered by static shapes"), "{}", screen.text());
            screen.keys("r");
        }
    }
    screen.keys("v");
    assert!(screen.text().contains("Dynamic mesh force"), "{}", screen.text());
}

#[test]
fn zoom_keeps_the_cursor_and_fit_shows_all() {
    for keys in ["", "x"] {
        let mut screen = wide(80, 24, UNICODE, keys);
        screen.keys("LLl");
        let (at, all) = (view(&screen).cursor, view(&screen).axis().unwrap());
        screen.keys("iii");
        let near = view(&screen).axis().unwrap();
        assert_eq!(view(&screen).cursor, at);
        let hz = view(&screen).at_hz().unwrap();
        assert!((near.fraction(hz) - all.fraction(hz)).abs() < 1e-9, "the cursor stays in its column");
        let width = |axis: bevelscope::tui::axis::FrequencyAxis| all.fraction(axis.max) - all.fraction(axis.min);
        assert!((width(near) - 0.125).abs() < 1e-9);
        screen.keys("<PgUp>");
        let panned = view(&screen).axis().unwrap();
        assert!((all.fraction(panned.max) - all.fraction(near.min)).abs() < 1e-9, "a page back");
        let hz = view(&screen).at_hz().unwrap();
        assert!((panned.min..=panned.max).contains(&hz), "the cursor comes along");
        screen.keys("<Home>");
        assert_eq!(view(&screen).cursor, 0);
        assert!((view(&screen).axis().unwrap().min - all.min).abs() < 1e-9, "the window follows the cursor");
        screen.keys("oooo");
        assert_eq!(view(&screen).axis().unwrap(), all);
        screen.keys("iif");
        assert_eq!(view(&screen).axis().unwrap(), all);
        // no deeper than a few lines
        screen.keys(&"i".repeat(60));
        let axis = view(&screen).axis().unwrap();
        let inside = view(&screen).lines().iter().filter(|f| (axis.min..=axis.max).contains(*f)).count();
        assert!(inside >= 4, "{inside}");
        // zoomed in, a column may hold no line: the cursor moves on all the same
        let before = view(&screen).cursor;
        assert_eq!(view(screen.keys("l")).cursor, before + 1);
    }
}

#[test]
fn jumps_go_through_all_bands_of_the_tolerance_and_round() {
    let (design, rotors, lines) = subject();
    let force = |kind| solve(kind, &design, &rotors, &lines).unwrap().mesh_force;
    let (fe, enhanced) = (force(ModelKind::Fe), force(ModelKind::Enhanced));
    for (keys, tolerance) in [("", 3.0), ("]]", 5.0), ("[[[[", 1.0), ("]]]]]]]]]]]]", 10.0)] {
        let mut screen = wide(80, 24, UNICODE, keys);
        let wanted: Vec<f64> =
            disagreement_bands(&lines, &enhanced, &fe, tolerance).iter().map(|band| band.worst_at_hz).collect();
        screen.keys("<Home>");
        for place in wanted.iter().chain(&wanted[..1]) {
            screen.keys("n");
            assert_eq!(view(&screen).at_hz(), Some(*place), "{tolerance} dB");
        }
        screen.keys("N");
        assert_eq!(view(&screen).at_hz(), wanted.last().copied());
        assert!(screen.text().contains(&format!(">{tolerance} dB")));
    }
}

#[test]
fn the_reasons_are_those_of_the_band_at_the_cursor() {
    let mut screen = wide(80, 24, ASCII, "<Home>");
    assert!(view(&screen).band_under().is_none() && !view(&screen).findings().unwrap().bands.is_empty());
    let shown = screen.keys("<Enter>").text();
    assert_eq!(screen.app.mode, Mode::Spectra);
    assert!(shown.contains("no band here: n goes to the next"), "{shown}");
    // the list marks a band only where the cursor is in it
    assert!(!shown.lines().any(|line| line.starts_with("|>")), "{shown}");
    let shown = screen.keys("n").text();
    assert!(shown.lines().any(|line| line.starts_with("|>")), "{shown}");
    assert!(screen.keys("<Enter>").text().contains("Band 1 of"), "{}", screen.text());
    assert_eq!(screen.app.mode, Mode::Why);
}

#[test]
fn peaks_are_listed_in_pairs_and_unpaired_ones_as_such() {
    let mut screen = wide(120, 40, UNICODE, "a<Home>p");
    let findings = view(&screen).findings().unwrap();
    let places: Vec<f64> = findings.peaks.iter().map(bevelscope::tui::spectra::Labelled::place).collect();
    assert!(places.len() > 3);
    let alone = findings.peaks.iter().filter(|peak| peak.pair.fe_hz.is_none() || peak.pair.lumped_hz.is_none());
    let alone = alone.count();
    assert_eq!(screen.text().matches("unpaired").count(), alone);
    assert_eq!(view(&screen).at_hz(), Some(places[0]));
    screen.keys("jj");
    assert_eq!(view(&screen).at_hz(), Some(places[2]));
    screen.keys("P");
    assert_eq!(view(&screen).at_hz(), Some(places[1]));
}

/// F_m = k_m* (error - e): the same modes make models differ in both. A bearing has its own.
#[test]
fn bands_of_every_quantity_have_a_mode_and_a_reason() {
    let mut screen = wide(120, 40, UNICODE, "v");
    let (design, rotors, _) = subject();
    let modes = ModalComparison::new(ModelKind::Enhanced, &design, &rotors).unwrap();
    let mut quantities = 0;
    let mut differ = false;
    while view(&screen).quantity != Quantity::MeshForce {
        quantities += 1;
        let view = view(&screen);
        let findings = view.findings().unwrap();
        assert!(findings.is_complete && !findings.bands.is_empty(), "{:?}", view.quantity);
        for band in &findings.bands {
            let hz = band.mode.as_ref().unwrap().0;
            assert!(band.sentences.len() > 1, "{:?}", band.sentences);
            let of_mesh = modes.responsible(band.band.worst_at_hz).unwrap();
            let same = modes.mode(&of_mesh).unwrap().frequency_hz.to_bits() == hz.to_bits();
            assert!(same || view.quantity != Quantity::TransmissionError, "{hz} {:?}", band.band);
            differ |= !same;
        }
        assert!(findings.peaks.iter().all(|peak| peak.mode.is_some()), "{:?}", view.quantity);
        screen.keys("v");
    }
    assert_eq!(quantities, 1 + design.pinion.bearings.len() + design.gear.bearings.len());
    assert!(differ, "a mode that shakes one bearing need not shake the mesh");
}

/// The highest mesh force of a design of few lines, as it is drawn, is that of a design of many.
#[test]
fn peaks_are_drawn_exact_however_coarse_the_analysis() {
    let (mut design, ..) = subject();
    let highest = |design: &Design| {
        let subject = Subject::new(design.clone(), None).unwrap();
        let mut observer = |_| std::ops::ControlFlow::Continue(());
        let model = ModelCurves::new(&subject, ModelKind::Fe, &mut observer).unwrap();
        let refined = model.refined(&subject, &mut observer).unwrap();
        let top = |model: &ModelCurves| model.curves[0].drawn_db.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert_eq!(refined.curves[0].lines, model.curves[0].lines, "figures are of the analysis lines");
        (top(&model), top(&refined))
    };
    design.analysis.frequency_lines = 200_000;
    let (fine, _) = highest(&design);
    design.analysis.frequency_lines = 20;
    let (coarse, drawn) = highest(&design);
    assert!(fine - coarse > 1.0, "{fine} {coarse}");
    assert!((fine - drawn).abs() < 0.01, "{fine} {drawn}");
}

#[test]
fn curves_are_switched_and_the_reduced_model_grows() {
    let mut screen = wide(120, 40, UNICODE, "23");
    let kinds = |screen: &Screen| view(screen).shown_kinds().collect::<Vec<_>>();
    assert_eq!(kinds(&screen), [ModelKind::Fe]);
    assert_eq!(kinds(screen.keys("4")), [ModelKind::Fe, ModelKind::Reduced(3)]);
    assert_eq!(kinds(screen.keys("++-+")), [ModelKind::Fe, ModelKind::Reduced(5)]);
    assert!(screen.text().contains("reduced:5"), "{}", screen.text());
    screen.keys("mm");
    assert_eq!(view(&screen).findings().unwrap().against, ModelKind::Reduced(5));
    assert!(view(&screen).findings().unwrap().is_complete);
    screen.keys(&"-".repeat(9));
    assert_eq!(view(&screen).against(), ModelKind::Reduced(0));
}

#[test]
fn the_design_as_it_is_now_is_drawn_from_the_tables_and_the_keys_go_back() {
    let mut screen = Screen::with(&[STEM], 80, 24, UNICODE, Shelf::shipped());
    screen.keys("elc39<Enter>w");
    assert_eq!(screen.app.mode, Mode::Spectra);
    assert!(screen.text().contains("unsaved edits"), "{}", screen.text());
    let shown = view(&screen).known.subject.as_ref().unwrap().design.clone();
    assert_ne!(shown, subject().0);
    assert_eq!(Some(&shown), screen.app.editors.open().unwrap().design.as_deref());
    screen.effects.clear();
    screen.keys("?<Esc><Esc>");
    assert!(screen.effects.contains(&Effect::CancelSpectra));
    assert_eq!(screen.app.mode, Mode::Table);
    screen.keys("<Esc>w<Esc>");
    assert_eq!(screen.app.mode, Mode::Library);
}

/// What is listed and shaded is of the tolerance that is shown.
#[test]
fn bands_of_another_tolerance_are_not_shown() {
    let mut screen = wide(120, 40, UNICODE, "");
    let before = view(&screen).findings().unwrap().bands.len();
    screen.held = true;
    screen.keys("]");
    assert!(before > 0 && view(&screen).tolerance > 3.0 && view(&screen).findings().is_none());
    // back at the one that they were found with
    screen.keys("[");
    assert_eq!(view(&screen).findings().unwrap().bands.len(), before);
}

#[test]
fn the_frame_comes_at_once_and_older_results_are_refused() {
    let mut screen = Screen::with(&[STEM], 80, 24, UNICODE, Shelf::shipped());
    screen.held = true;
    screen.keys("w");
    assert!(screen.text().contains("Solving"), "{}", screen.text());
    let old = view(&screen).ticket;
    screen.keys("]");
    assert!(view(&screen).ticket > old);
    screen.send(Message::Spectra { ticket: old, part: Box::new(Part::Failed(None, "too late".into())) });
    assert!(view(&screen).failure.is_none());
    let ticket = view(&screen).ticket;
    screen.send(Message::Spectra { ticket, part: Box::new(Part::Failed(None, "the reason".into())) });
    assert!(screen.text().contains("the reason"), "{}", screen.text());
}

/// Solves the basic model of nothing and the enhanced one without end.
struct Endless(Sender<()>);

impl Backend for Endless {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        Shelf::shipped().load(path)
    }

    fn compare(&self, design: &Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        Shelf::shipped().compare(design, observer)
    }

    fn spectrum(
        &self,
        subject: &Subject,
        kind: ModelKind,
        observer: &mut Observer<'_>,
    ) -> Result<ModelCurves, SolveError> {
        if kind == ModelKind::Enhanced {
            // nobody may be listening any more
            let _ = self.0.send(());
            while observer(0.5).is_continue() {
                std::thread::sleep(Duration::from_millis(1));
            }
            return Err(SolveError::Cancelled);
        }
        ModelCurves::new(subject, kind, observer)
    }
}

#[test]
fn the_latest_job_ends_what_is_being_solved() {
    const LONG: Duration = Duration::from_secs(60);
    let (begun, solving) = mpsc::channel();
    let (sender, messages) = mpsc::channel();
    let worker = Worker::start(Arc::new(Endless(begun)), &sender).unwrap();
    let mut screen = Screen::with(&[STEM], 80, 24, UNICODE, Shelf::shipped());
    screen.held = true;
    screen.keys("w");
    let job = |screen: &Screen| -> SpectraJob {
        let jobs =
            screen.effects.iter().filter_map(|effect| if let Effect::Spectra(job) = effect { Some(job) } else { None });
        (**jobs.collect::<Vec<_>>()[0]).clone()
    };
    worker.spectra(job(&screen));
    solving.recv_timeout(LONG).unwrap();
    let mut next = job(&screen);
    next.ticket = Ticket(next.ticket.0 + 1);
    next.against = ModelKind::Basic;
    next.kinds = vec![ModelKind::Fe, ModelKind::Basic];
    worker.spectra(next.clone());
    loop {
        match messages.recv_timeout(LONG).unwrap() {
            Message::Spectra { ticket, part } if ticket == next.ticket && matches!(*part, Part::Done) => break,
            Message::Spectra { ticket, part } if ticket != next.ticket => {
                assert!(!matches!(*part, Part::Done | Part::Failed(..)), "{part:?}");
            }
            _ => {}
        }
    }
}

#[test]
fn panning_moves_the_window_by_a_quarter_and_stops_at_the_ends() {
    for keys in ["", "x"] {
        let mut screen = wide(80, 24, UNICODE, keys);
        let all = view(&screen).axis().unwrap();
        assert_eq!(view(screen.keys("<").keys(">")).axis().unwrap(), all, "all is in sight");
        screen.keys("ii");
        let place = |screen: &Screen| {
            let axis = view(screen).axis().unwrap();
            (all.fraction(axis.min), all.fraction(axis.max))
        };
        let (from, to) = place(&screen);
        let quarter = (to - from) / 4.0;
        for (key, by) in [(">", quarter), ("<", 0.0), ("<", -quarter), (">>", quarter)] {
            let found = place(screen.keys(key));
            assert!((found.0 - from - by).abs() < 1e-9 && (found.1 - to - by).abs() < 1e-9, "{key} {found:?}");
            let (hz, axis) = (view(&screen).at_hz().unwrap(), view(&screen).axis().unwrap());
            assert!((axis.min..=axis.max).contains(&hz), "the cursor comes along");
        }
        assert!(place(screen.keys(&"<".repeat(40))).0.abs() < 1e-9);
        let end = place(screen.keys(&">".repeat(40)));
        assert!((end.1 - 1.0).abs() < 1e-9 && (end.1 - end.0 - 0.25).abs() < 1e-9, "{end:?}");
    }
}

#[test]
fn jumps_bring_the_window_along_on_either_axis() {
    for keys in ["", "x"] {
        let mut screen = wide(120, 40, UNICODE, keys);
        screen.keys("<Home>iiii");
        let bands: Vec<f64> =
            view(&screen).findings().unwrap().bands.iter().map(|band| band.band.worst_at_hz).collect();
        let peaks: Vec<f64> = view(&screen).findings().unwrap().peaks.iter().map(Labelled::place).collect();
        for (key, places) in [("n", &bands), ("p", &peaks)] {
            screen.keys("<Home>");
            let first = view(&screen).at_hz().unwrap();
            for place in places.iter().filter(|place| **place > first) {
                screen.keys(key);
                assert_eq!(view(&screen).at_hz(), Some(*place), "{keys} {key}");
                let axis = view(&screen).axis().unwrap();
                assert!((axis.min..=axis.max).contains(place), "{keys} {key} {place}");
            }
        }
        // columns of the cursor are those of the axis
        let mut screen = wide(120, 40, UNICODE, keys);
        let axis = view(&screen).axis().unwrap();
        let before = axis.fraction(view(&screen).at_hz().unwrap());
        let width = view(&screen).drawn().unwrap().difference.len() as f64;
        let after = axis.fraction(view(screen.keys("H")).at_hz().unwrap());
        let columns = (before - after) * width;
        assert!((9.0..=11.0).contains(&columns), "{keys} {columns}");
    }
}

#[test]
fn the_readout_is_copied() {
    let mut screen = wide(80, 24, UNICODE, "");
    screen.effects.clear();
    screen.keys("y");
    assert!(screen.effects.iter().any(|effect| matches!(effect, Effect::Copy(_))), "{:?}", screen.effects);
    assert!(screen.text().contains("sent to terminal: Dynamic mesh force"), "{}", screen.text());
    assert!(view(&screen).readout_text().unwrap().contains("dB"));
}

#[test]
fn monochrome_and_sixteen_colours_80x24() {
    assert_snapshot!("spectra_sixteen", wide(80, 24, UNICODE, "n").styles());
    assert_snapshot!(
        "spectra_monochrome",
        wide(80, 24, Capabilities { colour: ColourDepth::None, ..UNICODE }, "n").styles()
    );
}

/// Where plots and list have no room together, the list takes the place of the plots.
#[test]
fn the_list_alone_60x18() {
    let mut screen = wide(60, 18, UNICODE, "");
    assert!(!screen.text().contains("from Hz"));
    screen.keys("an");
    assert_snapshot!("spectra_list_60x18", screen.text());
    assert!(screen.keys("a").text().contains("peaks, FE and enhanced"), "{}", screen.text());
    assert!(!screen.keys("a").text().contains("FE Hz"), "the plots again");
    // one level back at a time
    screen.keys("a<Esc>");
    assert_eq!(screen.app.mode, Mode::Spectra);
    assert!(!screen.text().contains("from Hz"));
    assert_ne!(screen.keys("<Esc>").app.mode, Mode::Spectra);
}

#[test]
fn peaks_of_the_other_lumped_model_stand_beside() {
    let (design, rotors, lines) = subject();
    let force = |kind| solve(kind, &design, &rotors, &lines).unwrap().mesh_force;
    let of = |kind| peaks(&lines, &force(kind));
    for (keys, other) in [("", ModelKind::Basic), ("m", ModelKind::Enhanced)] {
        let screen = wide(120, 40, UNICODE, keys);
        let findings = view(&screen).findings().unwrap();
        assert_eq!(findings.beside, Some(other));
        let wanted: Vec<(f64, Option<f64>)> = pair_peaks(&of(other), &of(ModelKind::Fe))
            .iter()
            .filter_map(|pair| Some((pair.fe_hz?, pair.lumped_hz)))
            .collect();
        let found: Vec<(f64, Option<f64>)> =
            findings.peaks.iter().filter_map(|peak| Some((peak.pair.fe_hz?, peak.beside_hz))).collect();
        assert_eq!(found, wanted);
        assert!(found.iter().any(|(_, beside)| beside.is_some()));
    }
    // a model that is not solved has none
    let mut screen = wide(160, 40, UNICODE, "a");
    assert!(screen.text().contains("basic Hz"), "{}", screen.text());
    let peak = screen.keys("<Home>p");
    assert!(peak.text().contains("peak: torsion of both"), "{}", peak.text());
}

/// f = N n / 60: 14 teeth at 1,500 rpm are 350 Hz.
#[test]
fn mesh_frequency_and_harmonics_are_marked_where_a_speed_is_given() {
    let mut screen = Screen::with(&[STEM], 120, 40, UNICODE, Shelf::shipped());
    let axis_row = |screen: &Screen| {
        let row = screen.text().lines().position(|line| line.contains("  Hz ")).unwrap() - 1;
        screen.line(u16::try_from(row).unwrap())
    };
    assert!(!axis_row(screen.keys("w")).contains('1'));
    screen.keys("<Esc>");
    let text = format!("{}\n[operating]\npinion_speed_rpm = 1500.0\n", text());
    let mut design = design::read(&text).design.unwrap();
    assert_eq!(design.pinion.teeth, Some(14));
    assert!((mesh_frequency_hz(&design).unwrap() - 350.0).abs() < 1e-9);
    screen.keys("w");
    let view = screen.app.spectra.as_mut().unwrap();
    view.known.subject = Some(Arc::new(Subject::new(design.clone(), None).unwrap()));
    screen.draw();
    let row = axis_row(&screen);
    for order in 1..=9_u32 {
        let axis = screen.app.spectra.as_ref().unwrap().axis().unwrap();
        let column = row.chars().position(|letter| Some(letter) == char::from_digit(order, 10)).unwrap();
        let first = row.chars().position(|letter| letter == '1').unwrap();
        let each = (row.chars().position(|letter| letter == '9').unwrap() - first) as f64 / 8.0;
        assert!((column as f64 - first as f64 - each * f64::from(order - 1)).abs() <= 1.0, "{order}: {row}");
        assert!(f64::from(order) * 350.0 < axis.max);
    }
    assert!(screen.text().contains("mesh 350 Hz at 1,500 rpm"), "{}", screen.text());
    design.operating = None;
    assert_eq!(mesh_frequency_hz(&design), None);
}

#[test]
fn looking_for_modes_can_be_given_up() {
    let (design, rotors, _) = subject();
    let mut asked = 0;
    let mut done = || {
        asked += 1;
        if asked > 2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let solved = |kind| Solved::new(Model::new(kind, &design, &rotors).unwrap()).unwrap();
    let (fe, enhanced) = (solved(ModelKind::Fe), solved(ModelKind::Enhanced));
    let ended = ModalComparison::of(&fe, &enhanced, &design, &rotors, &mut done);
    assert!(matches!(ended, Err(ModalError::Cancelled)));
    assert_eq!(asked, 3, "at once");
    // also while the modes with the mesh are made from those without
    let model = Model::new(ModelKind::Fe, &design, &rotors).unwrap();
    let uncoupled = both_rotor_modes(&model).unwrap();
    let mut left = 3;
    let mut done = |_| {
        left -= 1;
        if left > 0 { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
    };
    let ended = Modes::with_rotor_modes_over(&model, &uncoupled, usize::MAX, &mut done);
    assert_eq!((ended, left), (Err(ResponseError::Cancelled), 0));
}
