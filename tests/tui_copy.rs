//! What `y` hands to the terminal, wherever the cursor is.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod tui_support;

use bevelscope::tui::message::Effect;
use tui_support::{Screen, Shelf, UNICODE};

const BASE: &str = bevelscope::design::library::SHIPPED[0].text;

/// A design, and one with a longer first segment, after some keys and `y`.
fn after(keys: &str) -> Screen {
    let shelf = Shelf::new(&[("base", BASE), ("one", &BASE.replacen("36.0", "40", 1))]);
    let mut screen = Screen::with(&["base", "one"], 80, 24, UNICODE, shelf);
    screen.keys(keys).keys("y");
    screen
}

/// The text in the one sequence that was sent.
fn copied(screen: &Screen) -> String {
    let sent: Vec<&Vec<u8>> = screen
        .effects
        .iter()
        .filter_map(|effect| if let Effect::Copy(bytes) = effect { Some(bytes) } else { None })
        .collect();
    let [bytes] = sent[..] else { panic!("{} were sent", sent.len()) };
    let coded = bytes.strip_prefix(b"\x1b]52;c;").unwrap().strip_suffix(b"\x07").unwrap();
    String::from_utf8(decoded(coded)).unwrap()
}

/// RFC 4648, section 4.
fn decoded(coded: &[u8]) -> Vec<u8> {
    let value = |letter: &u8| match letter {
        b'A'..=b'Z' => Some(u32::from(letter - b'A')),
        b'a'..=b'z' => Some(u32::from(letter - b'a') + 26),
        b'0'..=b'9' => Some(u32::from(letter - b'0') + 52),
        b'+' => Some(62),
        b'/' => Some(63),
        _ => None,
    };
    let piece = |piece: &[u8]| {
        let values: Vec<u32> = piece.iter().filter_map(value).collect();
        let bits = (0..4).fold(0, |bits, at| bits << 6 | values.get(at).copied().unwrap_or(0));
        bits.to_be_bytes()[1..values.len()].to_vec()
    };
    coded.chunks(4).flat_map(piece).collect()
}

#[test]
fn a_comparison_is_lines_with_tabs_for_a_spreadsheet() {
    let screen = after("mjc");
    let expected = "value\tbase\tone\tunit\nlength of pinion segment 1\t36.0\t40\tmm";
    assert_eq!(copied(&screen), expected);
    assert!(screen.text().contains("sent to terminal: 2 lines, value base one unit"), "{}", screen.text());
    // the other way round
    let expected = "value\tone\tbase\tunit\nlength of pinion segment 1\t40\t36.0\tmm";
    assert_eq!(copied(&after("mjcx")), expected);
}

#[test]
fn the_help_is_copied_as_far_as_it_was_searched_for() {
    let all = copied(&after("?"));
    assert!(all.starts_with("In the list of designs\n"), "{all}");
    assert!(all.contains("\nMoving\n↑ k\ta design, row or line up\n"), "{all}");
    assert!(all.contains("\ny\t"), "{all}");
    let some = copied(&after("?/unmark<Enter>"));
    assert!(some.lines().count() < all.lines().count(), "{some}");
    assert!(some.lines().any(|line| line.starts_with("m\t") && line.contains("unmark")), "{some}");
    assert!(all.contains(some.lines().last().unwrap()), "{some}");
}

#[test]
fn messages_are_copied_whole() {
    let screen = after("rother<Enter>!");
    assert_eq!(copied(&screen), "renamed base to other");
    // that it was is a message as well
    assert!(screen.app.messages.text().contains("sent to terminal: renamed base"), "{}", screen.app.messages.text());
}

#[test]
fn a_finding_is_copied_with_where_it_stands() {
    let screen = after("elc-5<Enter>f");
    assert_eq!(copied(&screen), "error pinion.segment[0].outer_diameter_mm: must be greater than 0 mm; it is -5");
    assert!(screen.text().contains("sent to terminal: error pinion.segment"), "{}", screen.text());
}

/// The diagonal bearing of the shipped design, made a matrix one.
#[test]
fn an_entry_of_a_matrix_has_its_unit_and_the_matrix_is_six_lines() {
    let matrix = "e<F2>lll l<Enter>";
    assert_eq!(copied(&after(matrix)), "6.0e8 N/m");
    assert_eq!(copied(&after(&format!("{matrix}jjjlll"))), "1.5e5 N m/rad");
    let zero = "0.0";
    let lines = ["6.0e8", "2.5e8", "6.0e8", "1.5e5", zero, "1.5e5"].into_iter().enumerate();
    let lines = lines.map(|(row, entry)| {
        let entries: Vec<&str> = (0..6).map(|column| if column == row { entry } else { zero }).collect();
        entries.join("\t")
    });
    assert_eq!(copied(&after(&format!("{matrix}<Esc>"))), lines.collect::<Vec<_>>().join("\n"));
}
