//! Every size and colour, hostile values, files that are no designs.

use crate::opened;
use crate::tui_support::{ASCII, Screen, Shelf, UNICODE};
use bevelscope::tui::caps::{Background, Capabilities, ColourDepth};

#[test]
fn the_side_view_points_at_what_the_cursor_is_on() {
    for (keys, label) in [
        ("jj", "pinion segment 3"),
        ("<F2>j", "pinion tail bearing"),
        ("<F3>", "pinion head"),
        ("<F4>", "pinion mesh"),
        ("<F5>p", "gear drive"),
    ] {
        for (capabilities, pointer) in [(UNICODE, "▼"), (ASCII, "v")] {
            let (mut screen, _) = opened(120, 40, capabilities);
            let text = screen.keys(keys).text();
            let (_, below) = text.split_once(&format!("Side view: {label}")).unwrap_or_else(|| panic!("{text}"));
            assert!(below.contains(pointer), "{text}");
        }
    }
}

/// The states that are drawn at every size and in every colour.
const STATES: [&str; 16] = [
    "",
    "jj",
    "<F2>",
    "<F2><End>",
    "<F2>lllc4",
    "<F2>lll<Enter>",
    "<F2>lll l<Enter>",
    "<F2>lll l<Enter>c1 kg<Enter>",
    "<F4>jjj",
    "<F6><Enter>",
    "<F8>",
    "lc-5<Enter>f",
    "c3 kg<Enter>",
    "S",
    "c4<Enter>q",
    "<F7>a",
];

#[test]
fn no_size_panics_and_ascii_is_ascii() {
    for keys in STATES {
        for capabilities in [UNICODE, ASCII] {
            let (mut screen, _) = opened(80, 24, capabilities);
            screen.keys(keys);
            let sizes = (1..=130).step_by(3).flat_map(|width| [1, 18, 24, 50].map(|height| (width, height)));
            let sizes = sizes.chain((1..=60).flat_map(|height| [60, 80, 120].map(|width| (width, height))));
            for (width, height) in sizes {
                screen.resize(width, height);
                let text = screen.text();
                assert!(!capabilities.ascii || text.is_ascii(), "{keys}: {text}");
                assert_eq!(text.lines().count(), usize::from(height));
            }
        }
    }
}

#[test]
fn colours_change_no_text() {
    for keys in STATES {
        let text = |colour, background| {
            let (mut screen, _) = opened(80, 24, Capabilities { colour, background, ascii: false });
            screen.keys(keys).text()
        };
        let plain = text(ColourDepth::None, Background::Unknown);
        assert_eq!(text(ColourDepth::True, Background::Light), plain, "{keys}");
        assert_eq!(text(ColourDepth::Sixteen, Background::Dark), plain, "{keys}");
    }
}

#[test]
fn escape_sequences_in_values_never_reach_the_screen() {
    let text = Shelf::shipped().text("overhung-elastic").unwrap();
    let hostile = r#""a\u001b[31m\u009b2J\u202ec\rd\u200b\n""#;
    let text = text
        .replace("\"Both overhung, elastic bearings\"", hostile)
        .replace("\"head bearing\"", hostile)
        .replace("\"diagonal\"\nkx_n_per_m = 5.0e8", &format!("{hostile}\nkx_n_per_m = 5.0e8"))
        .replace("\"ring gear\"", hostile);
    let text = format!("{text}\n[material.{hostile}]\ndensity_kg_per_m3 = 1.0\n");
    let shelf = Shelf::new(&[("fine", &text)]);
    let mut screen = Screen::with(&["fine"], 120, 40, UNICODE, shelf);
    screen.keys("e");
    for keys in [
        "<F2>",
        "<Enter>",
        "x<Enter>",
        "u",
        "j",
        "<F8>",
        "<Enter>",
        "<Esc>",
        "<F3>p",
        "<F7>j",
        "<Enter><Esc>",
        "f",
        "j",
        "<Enter>",
        "q",
    ] {
        screen.keys(keys);
        for cell in screen.buffer().content() {
            let harmful = |letter: char| {
                letter.is_control() || matches!(letter, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}')
            };
            assert!(!cell.symbol().contains(harmful), "{keys}: {:?}", cell.symbol());
        }
    }
}

#[test]
fn a_file_that_is_no_toml_or_is_gone_is_not_opened() {
    let shelf = Shelf::new(&[("fine", "format = "), ("typo", "format = 1\nname = 3\n")]);
    let mut screen = Screen::with(&["fine", "gone", "typo"], 80, 24, UNICODE, shelf);
    for keys in ["e", "je"] {
        screen.keys(keys);
        assert!(screen.app.editors.open().is_none());
        assert!(screen.text().contains("no tables"), "{}", screen.text());
    }
    // one with errors is: that is what the editor is for
    screen.keys("je");
    assert!(screen.text().contains("findings (f)"), "{}", screen.text());
}
