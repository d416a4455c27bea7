//! The table of all designs: order, filter, and the way to a design.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use bevelscope::tui::overview::Column;
use tui_support::{ASCII, Screen, UNICODE};

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
