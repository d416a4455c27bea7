//! The table of all designs: order, filter, and the way to a design.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use tui_support::{ASCII, Screen, UNICODE};

#[test]
fn overview_at_several_sizes() {
    insta::assert_snapshot!("overview_80x24_ascii", Screen::new(80, 24, ASCII).keys("O").text());
    insta::assert_snapshot!("overview_120x40", Screen::new(120, 40, UNICODE).keys("Osj").text());
    insta::assert_snapshot!("overview_60x18", Screen::new(60, 18, UNICODE).keys("O/over").text());
}
