//! No size panics, and nothing that a file says can act on the terminal.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use std::num::NonZero;
use std::path::Path;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

use bevelscope::comparison::{Comparison, Observer, SolveError};
use bevelscope::design::{Design, Difference, KeyPath};
use bevelscope::rotor::RotorError;
use bevelscope::tui::files::{FileDone, FileRequest};
use bevelscope::tui::message::Effect;
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign};
use num_complex::Complex64;
use tui_support::{ASCII, MadeUp, Screen, Shelf, UNICODE, design, not_solved};

/// Makes a screen that is to be drawn at every size.
type Make = Box<dyn Fn() -> Screen + Send + Sync>;

/// A screen after some keys.
fn after(keys: &'static str, make: impl Fn() -> Screen + Send + Sync + 'static) -> Make {
    Box::new(move || {
        let mut screen = make();
        screen.keys(keys);
        screen
    })
}

/// The states that are drawn at every size.
fn screens() -> Vec<Make> {
    let library = || Screen::new(80, 24, UNICODE);
    let tables = || Screen::with(&["overhung-elastic"], 80, 24, UNICODE, Shelf::shipped());
    let mut screens: Vec<Make> = [
        "",
        "jjj<Tab>",
        "?",
        "/e",
        "G",
        ":",
        "?/e<Enter>nnn",
        "r",
        "D",
        "!",
        "mjc",
        "w",
        "mjjjc",
        "mrx<Enter><Esc>!",
        "e:row",
        "e?/e<Enter>n",
        "M",
        "O",
        "Ossj/e",
        "OS?",
    ]
    .into_iter()
    .map(|keys| after(keys, library))
    .collect();
    for stem in ["tapered-hypoid", "straddle-helical"] {
        screens.push(after("Pj", move || Screen::with(&[stem], 80, 24, UNICODE, Shelf::shipped())));
    }
    screens.push(Box::new(|| Screen::new(80, 24, ASCII)));
    screens.push(Box::new(|| Screen::with(&[], 80, 24, UNICODE, MadeUp)));
    let in_tables = [
        "e<F2>j",
        "elc-5<Enter>f",
        "e<F2>lll l<Enter>c1 kg<Enter>",
        "e:row",
        "e?/e<Enter>n",
        "ea<Esc>q",
        "w",
        "wav4d",
        "wn<Enter>",
        "wiix<Tab><Tab>",
        "wE",
        "ew?",
        "Mjj",
        "Mjjx",
        "Mjjol ",
        "Mf12",
        "M<Tab>G?",
        "eMx",
        "P",
        "PK21.59",
        "Pf?",
        "PI<Enter>",
    ];
    screens.extend(in_tables.map(|keys| after(keys, tables)));
    let axle = || Screen::with(&["tapered-axle"], 80, 24, UNICODE, Shelf::shipped());
    screens.extend(
        ["B", "B<Tab>jj+", "B<Tab><Tab>ll", "Bt12", "Bt<Ctrl-u>0<Enter>", "e<F2>B?"].map(|keys| after(keys, axle)),
    );
    screens
}

/// Every width at three heights, every height at three widths, and a thousand at random.
fn sizes() -> Vec<(u16, u16)> {
    let mut sizes: Vec<(u16, u16)> = Vec::new();
    for height in [1, 24, 200] {
        sizes.extend((1..=200).map(|width| (width, height)));
    }
    for width in [1, 80, 200] {
        sizes.extend((1..=200).map(|height| (width, height)));
    }
    let mut state = 2012_u32;
    let mut random = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 16) as u16
    };
    sizes.extend((0..1000).map(|_| (random() % 220 + 1, random() % 90 + 1)));
    sizes
}

fn is_drawn_at(screen: &mut Screen, sizes: &[(u16, u16)]) {
    for &(width, height) in sizes {
        screen.resize(width, height);
        let area = screen.buffer().area;
        assert_eq!((area.width, area.height), (width, height));
        if width >= 60 && height >= 18 {
            assert!(screen.line(0).starts_with(" bevelscope"), "{width}x{height}");
            assert!(!screen.line(height - 1).is_empty(), "{width}x{height}");
        } else if width >= 20 && height >= 6 {
            assert!(screen.text().replace('\n', "").contains("60x18"), "{width}x{height}");
        }
    }
}

#[test]
fn no_size_panics() {
    let (screens, sizes, next) = (screens(), sizes(), AtomicUsize::new(0));
    let work = || {
        while let Some(make) = screens.get(next.fetch_add(1, Ordering::Relaxed)) {
            is_drawn_at(&mut make(), &sizes);
        }
    };
    thread::scope(|scope| {
        for _ in 0..thread::available_parallelism().map_or(1, NonZero::get) {
            scope.spawn(work);
        }
    });
}

/// The terminal may have been smaller in between, and has lost what stood there then.
#[test]
fn a_size_that_is_the_known_one_again_is_drawn_whole() {
    let mut screen = Screen::new(80, 24, UNICODE);
    for (width, height) in [(80, 24), (1, 1), (80, 24)] {
        screen.effects.clear();
        screen.resize(width, height);
        assert!(matches!(screen.effects[..], [Effect::Redraw]), "{:?}", screen.effects);
    }
}

/// Everything that a file can say, with escape sequences in it.
struct Hostile;

const ESCAPES: &str = "a\x1b[31m\x1b]0;b\x07\u{9b}2J\u{202e}c\rd\u{200b}";

impl Backend for Hostile {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        if path.to_string_lossy().contains("broken") {
            return Err(BrokenDesign { one_line: ESCAPES.into(), full_text: format!("{ESCAPES}\n\t{ESCAPES}") });
        }
        let mut design = design("overhung-elastic");
        design.name = if path.to_string_lossy().contains("unsolvable") { "unsolvable".into() } else { ESCAPES.into() };
        Ok(LoadedDesign { warnings: vec![ESCAPES.into()], ..LoadedDesign::from(design) })
    }

    fn differences(&self, _: &Path, _: &Path) -> Result<Vec<Difference>, String> {
        Ok(vec![Difference {
            is_number: false,
            is_row: false,
            path: KeyPath::root().key(ESCAPES),
            path_in_b: KeyPath::root().key(ESCAPES),
            label: ESCAPES.into(),
            label_in_b: ESCAPES.into(),
            a: Some(ESCAPES.into()),
            b: Some(ESCAPES.into()),
            unit: "N/m",
        }])
    }

    fn change_file(&self, _: &FileRequest) -> Result<FileDone, String> {
        Err(ESCAPES.into())
    }

    fn compare(&self, design: &Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        if design.name == "unsolvable" {
            Err(not_solved(RotorError::UnknownMaterial(ESCAPES.into())))
        } else {
            MadeUp.compare(design, observer)
        }
    }
}

#[test]
fn escape_sequences_never_reach_the_screen() {
    let stems = ["fine", "broken", "unsolvable", "stem\x1b[31m\u{202e}"];
    for capabilities in [UNICODE, ASCII] {
        let mut screen = Screen::with(&stems, 120, 40, capabilities, Hostile);
        screen.app.shown_as = ESCAPES.into();
        screen.app.notice = Some(ESCAPES.into());
        screen.app.complain_at_length(ESCAPES, format!("{ESCAPES}\n{ESCAPES}"));
        let scripts = [
            "",
            "j",
            "<Tab>",
            "<Tab>j",
            "j",
            "!",
            "<Esc>r",
            "\u{7}\u{9b}",
            "<Enter>",
            "<Esc>D",
            "<Esc>Y<Enter>",
            "<Esc>m",
            "gw",
            "<Enter>",
            "<Esc><Esc>c",
            "<Esc>jc",
            "<Esc>M",
            "<Esc>O",
            "sj/\u{1b}\u{7}",
            "<Esc><Esc><Esc>",
            ":\u{1b}\u{202e}",
            "<Esc><Esc>?/\x1b\u{7}",
            "<Enter>n",
            "<Esc><Esc><Esc>G/\x1b\u{7}",
        ];
        for keys in scripts {
            screen.keys(keys);
            for cell in screen.buffer().content() {
                let harmful = |letter: char| {
                    letter.is_control() || matches!(letter, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}')
                };
                assert!(!cell.symbol().contains(harmful), "{:?}", cell.symbol());
            }
        }
        screen.keys("<Esc>g");
        assert!(screen.text().contains("\\u{1b}[31m"), "{}", screen.text());
    }
}

#[test]
fn ascii_means_no_byte_beyond_127() {
    let stems = ["傘歯車", "Überhang", "typo-é", "fine"];
    let mut screen = Screen::with(&stems, 80, 24, ASCII, MadeUp);
    screen.app.shown_as = "~/Entwürfe".into();
    for keys in ["", "j", "j", "<Tab>", "?", "<Esc>:ü", "<Esc>gmjc", "<Esc>rü", "<Esc>D", "<Esc><Esc>/ü"] {
        let text = screen.keys(keys).text();
        assert!(text.is_ascii(), "{text}");
    }
    for (width, height) in [(60, 18), (59, 18), (200, 60)] {
        screen.resize(width, height);
        assert!(screen.text().is_ascii());
    }
}

/// Solutions that are no numbers, or none at all.
struct Strange;

impl Backend for Strange {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        let mut design = design("overhung-elastic");
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        design.name = stem.to_string();
        match &*stem {
            "point" => {
                design.pinion.segments.clear();
                design.pinion.bodies.clear();
                design.gear.bodies[0].mass = 0.0;
            }
            "huge" => design.gear.bodies[0].polar_inertia = 1e300,
            "beside" => design.pinion.bearings[0].position = -7.0,
            _ => {}
        }
        Ok(design.into())
    }

    fn compare(&self, design: &Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        let mut comparison = MadeUp.compare(design, observer)?;
        let force = &mut comparison.enhanced.mesh_force;
        match design.name.as_str() {
            "nan" => force.fill(Complex64::new(f64::NAN, 0.0)),
            "zero" => force.fill(Complex64::new(0.0, 0.0)),
            "infinite" => force[500] = Complex64::new(f64::INFINITY, 0.0),
            "two-lines" => {
                comparison.frequency_hz = vec![10.0, 5000.0];
                for spectrum in [&mut comparison.fe, &mut comparison.enhanced, &mut comparison.basic] {
                    spectrum.mesh_force.truncate(2);
                }
            }
            "empty" => comparison.frequency_hz.clear(),
            "nowhere" => comparison.enhanced_agreement.agreement_limit_hz = 0.0,
            "no-figures" => {
                comparison.enhanced_agreement.rms_db = f64::NAN;
                comparison.enhanced_agreement.max_at_hz = f64::INFINITY;
                comparison.enhanced_agreement.agreement_limit_hz = f64::NAN;
            }
            _ => {}
        }
        Ok(comparison)
    }
}

#[test]
fn strange_designs_and_solutions_are_drawn() {
    let stems = ["nan", "zero", "infinite", "two-lines", "empty", "nowhere", "no-figures", "point", "huge", "beside"];
    for capabilities in [UNICODE, ASCII] {
        let mut screen = Screen::with(&stems, 80, 24, capabilities, Strange);
        for stem in stems {
            assert_eq!(screen.selected(), stem);
            assert!(screen.text().contains(stem), "{}", screen.text());
            for keys in ["O", "s"] {
                assert!(screen.keys(keys).text().contains(stem), "{}", screen.text());
            }
            screen.keys("<Esc>");
            screen.keys("j");
        }
    }
}
