//! What the screens say of themselves: footers, help, legends, and whose figures they show.
#![allow(clippy::unwrap_used, reason = "a test may")]

mod tui_support;

use bevelscope::tui::caps::Capabilities;
use bevelscope::tui::help::HelpLine;
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::spectra::SpectraView;
use tui_support::{ASCII, Screen, Shelf, UNICODE};

fn library(width: u16, height: u16, capabilities: Capabilities) -> Screen {
    let shelf = Shelf::shipped();
    let stems = shelf.stems();
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    Screen::with(&stems, width, height, capabilities, shelf)
}

fn wide(stem: &str, width: u16, height: u16, keys: &str) -> Screen {
    let mut screen = Screen::with(&[stem], width, height, UNICODE, Shelf::shipped());
    screen.keys("w").keys(keys);
    screen
}

fn view(screen: &Screen) -> &SpectraView {
    screen.app.spectra.as_ref().unwrap()
}

fn footer(screen: &Screen) -> String {
    screen.text().lines().last().unwrap().to_owned()
}

#[test]
fn the_footer_of_the_list_leads_to_the_screens() {
    for (capabilities, width) in [(UNICODE, 80), (ASCII, 80), (UNICODE, 120)] {
        let said = footer(&library(width, 24, capabilities));
        for hint in ["w wide", "B bearings", "P pair", "a new", "? help"] {
            assert!(said.contains(hint), "{hint}: {said}");
        }
    }
    assert!(footer(&library(80, 24, UNICODE)).contains("q quit"));
}

#[test]
fn the_footer_of_the_spectra_says_what_moves_the_cursor() {
    let said = footer(&wide("tapered-axle", 80, 24, ""));
    assert!(said.contains("←→ cursor") && !said.contains("↑↓ move"), "{said}");
}

#[test]
fn help_begins_with_what_the_keys_do_where_it_was_asked_for() {
    for (keys, place) in [
        ("w", Mode::Spectra),
        ("M", Mode::Modes),
        ("B", Mode::Bearings),
        ("P", Mode::Pair),
        ("O", Mode::Overview),
        ("e", Mode::Table),
        ("", Mode::Library),
    ] {
        let mut screen = library(80, 24, UNICODE);
        screen.keys(keys).keys("?");
        assert_eq!(screen.app.help_lines().first(), Some(&HelpLine::Title(place.place())), "{keys}");
    }
    let mut screen = library(80, 24, UNICODE);
    let shown = screen.keys("w?").text();
    assert!(shown.contains("the cursor a column to the left") && !shown.contains("a cell to the left"), "{shown}");
}

#[test]
fn a_key_writes_the_design_from_the_list_and_from_the_tables() {
    for keys in ["E", "eE"] {
        let mut screen = library(80, 24, UNICODE);
        screen.keys(keys);
        assert_eq!(screen.app.mode, Mode::Export, "{keys}");
        assert!(screen.text().contains(".html"), "{}", screen.text());
    }
}

#[test]
fn figures_of_the_file_beside_unsaved_edits_are_called_saved() {
    let mut screen = Screen::with(&["tapered-axle"], 80, 24, UNICODE, Shelf::shipped());
    assert!(!screen.text().contains("saved"));
    let shown = screen.keys("e5<Enter><Esc>").text();
    let row = shown.lines().find(|line| line.contains(" * ")).unwrap();
    assert!(row.contains(" *  saved"), "{shown}");
    assert!(shown.contains("┌ saved ─"), "{shown}");
    assert!(!screen.keys("es<Esc>").text().contains("┌ saved ─"), "{}", screen.text());
}

/// Of the FE curve, on the line of the peak.
#[test]
fn the_peak_list_has_levels_and_marks_the_highest() {
    let screen = wide("tapered-axle", 120, 40, "a");
    let text = screen.text();
    assert!(text.contains("FE dB  diff dB") && text.contains("* the highest"), "{text}");
    let view = view(&screen);
    let findings = view.findings().unwrap();
    let fe = view.curve(view.kinds()[0], view.quantity).unwrap();
    let level = |hz: f64| {
        let at = view.lines().iter().position(|line| line.to_bits() == hz.to_bits()).unwrap();
        20.0 * fe.lines[at].norm().log10()
    };
    let levels: Vec<Option<f64>> = findings.peaks.iter().map(|peak| peak.pair.fe_hz.map(level)).collect();
    assert_eq!(findings.peaks.iter().map(|peak| peak.fe_db).collect::<Vec<_>>(), levels);
    let highest = levels.iter().flatten().copied().fold(f64::NEG_INFINITY, f64::max);
    let marked: Vec<&str> = text.lines().filter(|line| line.contains(&format!(" {highest:.1}*"))).collect();
    assert_eq!(marked.len(), 1, "{text}");
    assert_eq!(text.matches("* ").count() - text.matches("; * ").count(), 1, "{text}");
}

#[test]
fn what_sets_the_trust_limit_is_said() {
    let screen = wide("tapered-axle", 80, 24, "<Tab><Tab><Tab>");
    let [long, short] = view(&screen).limit().unwrap();
    assert_eq!(long, "limit 1,682 Hz: the band 1,682 to 1,888 Hz is 3.3 dB low");
    assert!(short.starts_with("limit 1,682 Hz"));
    assert!(screen.text().contains("limit 1,682 Hz"), "{}", screen.text());
    // the basic model has another one
    let mut screen = screen;
    assert_ne!(view(screen.keys("m")).limit().map(|[long, _]| long), Some(long));
}

#[test]
fn harmonics_are_told_from_peaks_and_have_a_legend() {
    for (width, height) in [(80, 24), (120, 40)] {
        let mut screen = wide("tapered-axle", width, height, "");
        for _ in 0..6 {
            let text = screen.keys("p").text();
            assert!(text.contains("1x: mesh 280 Hz"), "{text}");
            let axis = text.lines().find(|line| line.contains("└─") && line.contains('┬')).unwrap();
            assert!(axis.contains("1x") && axis.contains("2x"), "{axis}");
        }
    }
}

#[test]
fn the_lower_strip_has_labelled_ends_where_it_is_low() {
    let text = wide("tapered-axle", 80, 24, "").text();
    let at = text.lines().position(|line| line.contains("enhanced − FE")).unwrap();
    let strip: Vec<&str> = text.lines().skip(at + 1).take(3).collect();
    assert!(strip[0].contains(" 20") && strip[1].contains(" 0") && strip[2].contains("-20"), "{text}");
}

#[test]
fn names_of_modes_are_not_cut_in_the_list() {
    for (width, height) in [(120, 40), (160, 45)] {
        for keys in ["", "a"] {
            let text = wide("tapered-axle", width, height, keys).text();
            let list: Vec<&str> =
                text.lines().skip_while(|line| !line.contains("worst dB") && !line.contains("diff dB")).collect();
            assert!(!list.is_empty() && !list.iter().take(10).any(|line| line.contains('…')), "{text}");
        }
    }
}

#[test]
fn without_any_curve_it_is_said_which_keys_show_one() {
    let mut screen = wide("tapered-axle", 80, 24, "12");
    assert!(!screen.text().contains("hidden"));
    assert!(screen.keys("3").text().contains("all models are hidden: 1 2 3 show them"), "{}", screen.text());
}

/// Whichever table has the focus, its tab and all others are where they were.
#[test]
fn tabs_stay_where_they_are() {
    let mut screen = Screen::with(&["tapered-axle"], 80, 24, UNICODE, Shelf::shipped());
    screen.keys("e");
    let place = |screen: &Screen| {
        let text = screen.text();
        let line = text.lines().find(|line| line.contains("F1 ") && line.contains("F8 ")).unwrap().to_owned();
        (1..=8).map(|tab| line.find(&format!("F{tab} ")).unwrap()).collect::<Vec<_>>()
    };
    let places = place(&screen);
    for tab in 2..=8 {
        screen.keys(&format!("<F{tab}>"));
        assert_eq!(place(&screen), places, "F{tab}");
    }
}
