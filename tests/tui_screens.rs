//! What the explorer looks like, kept as pictures in tests/snapshots.

mod tui_support;

use bevelscope::tui::caps::{Background, Capabilities, ColourDepth};
use insta::assert_snapshot;
use tui_support::{ASCII, MadeUp, STEMS, Screen, UNICODE};

#[test]
fn explorer_80x24_ascii() {
    assert_snapshot!(Screen::new(80, 24, ASCII).text());
}

#[test]
fn explorer_80x24() {
    assert_snapshot!(Screen::new(80, 24, UNICODE).text());
}

#[test]
fn explorer_120x40() {
    assert_snapshot!(Screen::new(120, 40, UNICODE).text());
}

#[test]
fn explorer_60x18() {
    assert_snapshot!(Screen::new(60, 18, UNICODE).text());
}

#[test]
fn explorer_styles() {
    assert_snapshot!(Screen::new(80, 24, UNICODE).styles());
}

#[test]
fn explorer_styles_monochrome() {
    assert_snapshot!(Screen::new(80, 24, Capabilities { colour: ColourDepth::None, ..UNICODE }).styles());
}

#[test]
fn log_axis() {
    assert_snapshot!(Screen::with(&["variant-log"], 80, 24, UNICODE, MadeUp).text());
}

#[test]
fn before_anything_is_read() {
    assert_snapshot!(Screen::before_start(&STEMS, 80, 24, UNICODE, MadeUp).text());
}

#[test]
fn broken_design() {
    assert_snapshot!(Screen::new(80, 24, UNICODE).keys("jjj<Tab>").text());
}

#[test]
fn design_that_cannot_be_solved() {
    assert_snapshot!(Screen::new(80, 24, UNICODE).keys("jjjj").text());
}

#[test]
fn design_with_warnings() {
    assert_snapshot!(Screen::new(120, 30, UNICODE).keys("G").text());
}

#[test]
fn filter_while_typed() {
    assert_snapshot!(Screen::new(80, 24, UNICODE).keys("/rigid").text());
}

#[test]
fn no_match() {
    assert_snapshot!(Screen::new(80, 24, UNICODE).keys("/zebra").text());
}

#[test]
fn help() {
    assert_snapshot!(Screen::new(80, 24, UNICODE).keys("?").text());
}

#[test]
fn help_end_120x40_ascii() {
    assert_snapshot!(Screen::new(120, 40, ASCII).keys("?G").text());
}

#[test]
fn empty_library() {
    assert_snapshot!(Screen::with(&[], 80, 24, UNICODE, MadeUp).text());
}

#[test]
fn too_small() {
    assert_snapshot!(Screen::new(59, 18, UNICODE).text());
    assert_snapshot!("too_small_20x5", Screen::new(20, 5, UNICODE).text());
}

#[test]
fn colours_change_no_text() {
    for ascii in [false, true] {
        for keys in ["", "jjj", "?", "/e"] {
            let text =
                |colour, background| Screen::new(80, 24, Capabilities { colour, background, ascii }).keys(keys).text();
            let plain = text(ColourDepth::None, Background::Unknown);
            for colour in [ColourDepth::Sixteen, ColourDepth::Indexed, ColourDepth::True] {
                for background in [Background::Unknown, Background::Dark, Background::Light] {
                    assert_eq!(text(colour, background), plain, "{colour:?} {background:?} {keys}");
                }
            }
        }
    }
}

#[test]
fn monochrome_uses_no_colour() {
    let screen = Screen::new(120, 40, Capabilities { colour: ColourDepth::None, ..UNICODE });
    let plain = ratatui::style::Color::Reset;
    assert!(screen.buffer().content().iter().all(|cell| cell.fg == plain && cell.bg == plain));
}

#[test]
fn what_the_enhanced_model_rests_on_stands_beside_its_figures() {
    // `bevelscope inspect` says of the pinion of this design: taken from statics, inertia; of the other one nothing
    for (width, wanted) in
        [(80, ", ! static inertia"), (160, ", ! pinion: inertia from statics, limit by 1/6 octave, at worst")]
    {
        let mut screen =
            Screen::with(&["overhung-elastic", "straddle-elastic"], width, 24, ASCII, tui_support::Shelf::shipped());
        assert!(!screen.text().contains('!'), "{}", screen.text());
        let text = screen.keys("j").text();
        let line = text.lines().find(|line| line.contains("enhanced: trust")).unwrap();
        assert!(line.contains(wanted), "{line}");
        let text = screen.keys("e").text();
        assert!(text.lines().any(|line| line.contains("enhanced: trust") && line.contains(wanted)), "{text}");
    }
}
