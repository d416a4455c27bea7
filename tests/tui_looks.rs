//! How things are drawn: every marker, and colours that can be read on any background.

#![allow(clippy::panic, reason = "a helper of tests")]

mod tui_support;

use bevelscope::tui::caps::{Background, Capabilities, ColourDepth};
use bevelscope::tui::marker::Marker;
use bevelscope::tui::theme::Theme;
use insta::assert_snapshot;
use ratatui::style::{Color, Modifier, Style};
use tui_support::{ASCII, Screen, Shelf, UNICODE};

#[test]
fn blocks_80x24() {
    assert_snapshot!(Screen::new(80, 24, UNICODE).keys("b").text());
}

#[test]
fn dots_80x24() {
    assert_snapshot!(Screen::new(80, 24, UNICODE).keys("bb").text());
}

#[test]
fn letters_80x24() {
    assert_snapshot!(Screen::new(80, 24, UNICODE).keys("bbb").text());
}

#[test]
fn points_80x24_ascii() {
    assert_snapshot!(Screen::new(80, 24, ASCII).keys("b").text());
}

#[test]
fn blocks_in_the_tables_120x40() {
    let stems = ["overhung-elastic"];
    assert_snapshot!(Screen::with(&stems, 120, 40, UNICODE, Shelf::shipped()).keys("e<F2>bllllc2e8<Enter>").text());
}

/// The cycle says what it has come to, on every screen, and all of it changes.
#[test]
fn the_marker_is_in_force_on_every_screen_with_a_picture() {
    let stems = ["overhung-elastic", "overhung-rigid"];
    let has_braille = |text: &str| text.chars().any(|shown| ('\u{2801}'..='\u{28ff}').contains(&shown));
    for keys in ["", "mjc", "e<F2>", "e<F2>?<Esc>"] {
        let mut screen = Screen::with(&stems, 120, 40, UNICODE, Shelf::shipped());
        screen.keys(keys);
        assert!(has_braille(&screen.text()), "{}", screen.text());
        for name in ["blocks", "dots", "ASCII letters"] {
            let text = screen.keys("b").text();
            assert!(text.contains(&format!("curves: {name}")), "{text}");
            assert!(!has_braille(&text), "{text}");
        }
        assert!(has_braille(&screen.keys("b").text()));
        assert!(screen.text().contains("curves: braille"));
    }
    assert!(Screen::new(80, 24, UNICODE).keys(":curves").text().contains("cycle-marker"));
    assert!(
        Screen::new(120, 40, UNICODE).keys("?/braille").text().contains("curves of braille, blocks, dots or ASCII")
    );
}

/// `--ascii` is about every byte: whatever is cycled, nothing beyond it is drawn.
#[test]
fn ascii_has_markers_of_its_own() {
    let mut screen = Screen::with(&["overhung-elastic", "overhung-rigid"], 100, 30, ASCII, Shelf::shipped());
    let mut pictures = Vec::new();
    for _ in Marker::all(true) {
        let text = screen.keys("b").text();
        assert!(text.is_ascii(), "{text}");
        assert!(!pictures.contains(&text));
        pictures.push(text);
    }
    for keys in ["mjc", "b", "<Esc>e2", "b", "?"] {
        let text = screen.keys(keys).text();
        assert!(text.is_ascii(), "{keys}: {text}");
    }
}

#[test]
fn the_background_is_switched_by_the_palette() {
    let capabilities = Capabilities { colour: ColourDepth::Indexed, ..UNICODE };
    let mut screen = Screen::new(80, 24, capabilities);
    let theme = |background| Theme::new(Capabilities { background, ..capabilities });
    for (background, name) in [(Background::Light, "light"), (Background::Dark, "dark"), (Background::Light, "light")] {
        screen.keys("b:toggle-background<Enter>");
        assert!(screen.text().contains(&format!("colours for a {name} background")), "{}", screen.text());
        assert_eq!(Theme { marker: screen.app.theme.marker, ..theme(background) }, screen.app.theme);
    }
    // what curves are drawn with stays: cycled three times
    assert_eq!(screen.app.theme.marker, Marker::Letters);
}

/// Red, green and blue of a colour of the 256-colour palette of xterm, whose first 16 are the user's.
fn rgb(colour: Color) -> [f64; 3] {
    let cube = |step: u8| if step == 0 { 0.0 } else { f64::from(55 + 40 * step) };
    match colour {
        Color::Rgb(red, green, blue) => [red, green, blue].map(f64::from),
        Color::Indexed(place @ 232..) => [f64::from(8 + 10 * (place - 232)); 3],
        Color::Indexed(place @ 16..) => {
            let place = place - 16;
            [place / 36, place / 6 % 6, place % 6].map(cube)
        }
        other => panic!("{other} looks otherwise in every terminal"),
    }
}

/// WCAG 2.2, "relative luminance" and "contrast ratio".
fn contrast(one: [f64; 3], other: [f64; 3]) -> f64 {
    let luminance = |colour: [f64; 3]| {
        let linear = colour
            .map(|value| value / 255.0)
            .map(|value| if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    };
    let (one, other) = (luminance(one), luminance(other));
    (one.max(other) + 0.05) / (one.min(other) + 0.05)
}

// the two ends of what the formula can give, as WCAG says them
#[test]
fn contrast_is_from_1_to_21() {
    assert!((contrast([0.0; 3], [255.0; 3]) - 21.0).abs() < 1e-9);
    assert!((contrast([9.0; 3], [9.0; 3]) - 1.0).abs() < 1e-9);
}

const BLACK: [f64; 3] = [0.0; 3];
const WHITE: [f64; 3] = [255.0; 3];
/// The usual greys that stand in for black and white
const NEARLY_BLACK: [f64; 3] = [30.0; 3];
const NEARLY_WHITE: [f64; 3] = [238.0; 3];

/// Least contrast of text (WCAG 2.2, 1.4.3), and of what is no text (1.4.11). A colour that is as far from black as from white
/// has at most 4.58 to both: where the background is not known, 4.1 is asked of text.
#[test]
fn every_style_can_be_read_on_its_background() {
    const TEXT: f64 = 4.5;
    const LINES: f64 = 3.0;
    let cases: [(Background, &[[f64; 3]], f64); 3] = [
        (Background::Dark, &[BLACK, NEARLY_BLACK], TEXT),
        (Background::Light, &[WHITE, NEARLY_WHITE], TEXT),
        (Background::Unknown, &[BLACK, WHITE], 4.1),
    ];
    for colour in [ColourDepth::Indexed, ColourDepth::True] {
        for (background, behind, text) in cases {
            let theme = Theme::new(Capabilities { colour, background, ascii: false });
            let on_band: Option<[f64; 3]> = theme.band.bg.map(rgb);
            let styles = [
                ("enhanced", theme.enhanced, text),
                ("basic", theme.basic, text),
                ("beyond", theme.beyond, text),
                ("faint", theme.faint, text),
                ("error", theme.error, text),
                ("warning", theme.warning, text),
                ("key", theme.key, text),
                ("border", theme.border, LINES),
                ("focused border", theme.border_focused, LINES),
            ];
            for (name, style, least) in styles {
                assert!(!style.add_modifier.contains(Modifier::DIM), "{name}");
                for &behind in behind {
                    let found = style.fg.map(|colour| contrast(rgb(colour), behind));
                    assert!(found.is_none_or(|found| found >= least), "{background:?} {name}: {found:?}");
                }
            }
            // the curves cross the band, also the one in the terminal's own colour
            let own = if background == Background::Light { BLACK } else { WHITE };
            for colour in [theme.enhanced.fg.map(rgb), theme.basic.fg.map(rgb), Some(own)].into_iter().flatten() {
                assert!(on_band.is_none_or(|band| contrast(colour, band) >= LINES), "{background:?}");
            }
        }
    }
}

/// Of the user's own colours nothing is known but their names: those that are pale in the usual palettes, and dimmed text, are
/// for dark backgrounds.
#[test]
fn nothing_is_dim_or_pale_on_a_light_background() {
    let capabilities = Capabilities { colour: ColourDepth::Sixteen, background: Background::Light, ascii: false };
    let theme = Theme::new(capabilities);
    let styles = |theme: &Theme| -> Vec<Style> {
        let Theme { enhanced, basic, beyond, faint, error, warning, key, border, border_focused, .. } = *theme;
        vec![enhanced, basic, beyond, faint, error, warning, key, border, border_focused, theme.band]
    };
    for style in styles(&theme) {
        assert!(!style.add_modifier.contains(Modifier::DIM), "{style:?}");
        assert!(matches!(style.fg, None | Some(Color::Blue | Color::Magenta | Color::Red)), "{style:?}");
    }
    // text is dimmed only where it is known to be on dark
    let unknown = Theme::new(Capabilities { background: Background::Unknown, ..capabilities });
    assert!(!unknown.faint.add_modifier.contains(Modifier::DIM));
    // and without colours nothing is
    let monochrome = Theme::new(Capabilities { colour: ColourDepth::None, ..capabilities });
    assert!(styles(&monochrome).iter().all(|style| style.fg.is_none() && !style.add_modifier.contains(Modifier::DIM)));
}
