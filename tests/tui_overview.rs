//! The table of all designs: order, filter, and the way to a design.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use bevelscope::tui::caps::{Capabilities, ColourDepth};
use bevelscope::tui::keymap::Mode;
use bevelscope::tui::overview::Column;
use tui_support::{ASCII, Screen, Shelf, UNICODE, dead_keys};

const MONOCHROME: Capabilities = Capabilities { colour: ColourDepth::None, ..UNICODE };

#[test]
fn overview_at_several_sizes() {
    insta::assert_snapshot!("overview_80x24_ascii", Screen::new(80, 24, ASCII).keys("O").text());
    insta::assert_snapshot!("overview_120x40", Screen::new(120, 40, UNICODE).keys("Osj").text());
    insta::assert_snapshot!("overview_60x18", Screen::new(60, 18, UNICODE).keys("O/over").text());
}

#[test]
fn every_column_orders_in_both_directions_and_designs_without_figures_come_last() {
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.keys("O");
    for column in Column::ALL {
        assert_eq!(screen.app.overview.column, column);
        for falls in [true, false] {
            let rows = screen.app.overview_rows();
            let figures: Vec<Option<f64>> = rows.iter().map(|row| column.figure(row)).collect();
            let known: Vec<f64> = figures.iter().flatten().copied().collect();
            assert!(figures[known.len()..].iter().all(Option::is_none), "{column:?}: {figures:?}");
            assert!(known.is_sorted_by(|a, b| if falls { a >= b } else { a <= b }), "{column:?}: {known:?}");
            assert_eq!(known.len(), if column == Column::Design { 0 } else { 4 });
            let names: Vec<&str> = rows.iter().map(|row| row.stem.as_str()).collect();
            if column == Column::Design {
                assert!(names.is_sorted_by(|a, b| if falls { a <= b } else { a >= b }), "{names:?}");
            }
            screen.keys("S");
        }
        screen.keys("s");
    }
    assert_eq!(screen.app.overview.column, Column::Design);
}

#[test]
fn a_filter_and_the_way_to_a_design() {
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.keys("O/rigid<Enter>");
    assert!(screen.text().contains("Overview /rigid  1 of 1 matches"), "{}", screen.text());
    // the filter goes first, then the screen
    screen.keys("<Esc>");
    assert!(screen.text().contains("of 6"), "{}", screen.text());
    let text = screen.keys("sGkk<Enter>").text();
    assert!(!text.contains("overview of"), "{text}");
    assert_eq!(screen.selected(), "warned");
    screen.keys("O<Esc>");
    assert_eq!(screen.selected(), "warned");
}

#[test]
fn state_is_never_told_by_colour_alone() {
    insta::assert_snapshot!("overview_styles", Screen::new(80, 24, UNICODE).keys("Ojj").styles());
    insta::assert_snapshot!("overview_styles_monochrome", Screen::new(80, 24, MONOCHROME).keys("Ojj").styles());
    for keys in ["O", "Ojss", "OG", "O/rigid"] {
        let text = |capabilities| Screen::new(80, 24, capabilities).keys(keys).text();
        assert_eq!(text(UNICODE), text(MONOCHROME), "{keys}");
    }
}

/// Warnings, unsaved edits and what is wrong are marks in the row, at every size, however long the name is.
#[test]
fn marks_of_the_rows_are_never_cut_off() {
    let files = [
        ("a-design-with-a-name-that-nobody-would-type-in-a-hurry", bevelscope::design::library::SHIPPED[0].text),
        ("broken", "format = 1\nname = "),
    ];
    for (width, height) in [(60, 18), (80, 24), (120, 40)] {
        let mut screen = Screen::with(&[files[0].0, files[1].0], width, height, UNICODE, Shelf::new(&files));
        let text = screen.keys("ec77<Enter><Esc>O").text();
        let row = text.lines().nth(4).unwrap();
        assert!(row.contains("a-design") && row.contains(" * "), "{text}");
        assert!(text.lines().nth(5).unwrap().contains("broken") && text.contains('×'), "{text}");
        assert!(text.contains("edits not saved"), "{text}");
        let text = Screen::new(width, height, UNICODE).keys("OG").text();
        assert!(text.lines().any(|line| line.contains("▌warned !")), "{text}");
    }
}

#[test]
fn spectra_have_a_scale_and_the_chosen_one_a_picture_where_there_is_room() {
    for (width, height) in [(60, 18), (80, 24), (120, 40)] {
        let text = Screen::new(width, height, ASCII).keys("O").text();
        // at 60 columns there is no room for them
        assert_eq!(text.contains("spectra: 42 to 82 dB re 1 N, 10 to 5,000 Hz"), width >= 80, "{text}");
        assert_eq!(text.contains("FE mesh force, dB re 1 N"), height > 18, "{text}");
    }
    let mut screen = Screen::with(&["overhung-elastic", "turbine-generator"], 80, 24, ASCII, Shelf::shipped());
    let text = screen.keys("O").text();
    assert!(text.contains("each over its own frequencies"), "{text}");
    let text = screen.keys("/over").text();
    assert!(text.contains("10 to 4,000 Hz"), "{text}");
}

/// A key that does nothing anywhere on the screen should not be in its help.
#[test]
fn every_key_of_the_screen_does_something() {
    let dead = dead_keys(Mode::Overview, || Screen::new(80, 24, UNICODE), &["O", "Ojjj", "OG", "Os"]);
    assert!(dead.is_empty(), "{dead:?}");
}

#[test]
fn columns_are_gone_through_in_both_directions() {
    let mut screen = Screen::new(80, 24, UNICODE);
    screen.keys("O");
    for column in Column::ALL.into_iter().rev() {
        screen.keys("h");
        assert_eq!(screen.app.overview.column, column);
        assert_eq!(column.next().previous(), column);
    }
    screen.keys("<Right><Left>");
    assert_eq!(screen.app.overview.column, Column::Design);
}

#[test]
fn from_the_tables_it_leads_to_the_tables_of_another_design_and_edits_stay() {
    let stems = ["overhung-elastic", "overhung-rigid"];
    let mut screen = Screen::with(&stems, 80, 24, UNICODE, Shelf::shipped());
    let text = screen.keys("ec77<Enter>O").text();
    assert!(text.contains("Overview 1 of 2") && text.contains("▌overhung-ela… *"), "{text}");
    // back where it came from
    screen.keys("<Esc>");
    assert_eq!(screen.app.mode, Mode::Table);
    screen.keys("O<Enter>");
    assert_eq!(screen.app.mode, Mode::Table);
    let text = screen.keys("Oj<Enter>").text();
    assert_eq!(screen.app.mode, Mode::Table);
    let open = screen.app.editors.open().unwrap();
    assert!(open.path.ends_with("overhung-rigid.toml"), "{text}");
    // the edits of the first are still there
    let text = screen.keys("Ok<Enter>").text();
    assert!(text.contains("77.0") || text.contains("77"), "{text}");
    assert_eq!(screen.app.editors.unsaved().count(), 1);
}
