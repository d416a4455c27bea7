//! The screen of the natural modes: what the table says, the shapes, the MAC, the deflection shape.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

mod tui_support;

use tui_support::{ASCII, Screen, UNICODE};

/// The modes of a made-up design, which are computed as they are for real ones.
fn modes(width: u16, height: u16, capabilities: bevelscope::tui::caps::Capabilities) -> Screen {
    let mut screen = Screen::with(&["overhung-elastic"], width, height, capabilities, tui_support::MadeUp);
    screen.keys("M");
    screen
}

#[test]
fn modes_at_several_sizes() {
    insta::assert_snapshot!("modes_80x24_ascii", modes(80, 24, ASCII).keys("jj").text());
    insta::assert_snapshot!("modes_120x40", modes(120, 40, UNICODE).keys("jj<Tab>").text());
    insta::assert_snapshot!("modes_60x18", modes(60, 18, UNICODE).keys("jj").text());
}

#[test]
fn mac_and_deflection() {
    insta::assert_snapshot!("mac_80x24_ascii", modes(80, 24, ASCII).keys("jjx").text());
    insta::assert_snapshot!("deflection_80x24_ascii", modes(80, 24, ASCII).keys("jjo l").text());
}
