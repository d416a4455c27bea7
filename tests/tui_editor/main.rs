//! The editor: key scripts, pictures, results that come late, and every cell of every table.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

#[path = "../tui_support/mod.rs"]
mod tui_support;

mod cells;
mod drawing;
mod keys;
mod saving;
mod solving;

use bevelscope::tui::caps::Capabilities;
use bevelscope::tui::editor::Editing;
use insta::assert_snapshot;
use tui_support::{ASCII, Screen, Shelf, UNICODE};

/// The shipped designs with the tables of the first one open.
fn opened(width: u16, height: u16, capabilities: Capabilities) -> (Screen, Shelf) {
    let shelf = Shelf::shipped();
    let stems = shelf.stems();
    let stems: Vec<&str> = stems.iter().map(String::as_str).collect();
    let mut screen = Screen::with(&stems, width, height, capabilities, shelf.clone());
    screen.keys("e");
    (screen, shelf)
}

fn editing(screen: &Screen) -> &Editing {
    screen.app.editors.open().unwrap()
}

/// The lines that differ, as `-before` and `+after`.
fn changed(before: &str, after: &str) -> Vec<String> {
    let (before, after): (Vec<&str>, Vec<&str>) = (before.lines().collect(), after.lines().collect());
    let start = before.iter().zip(&after).take_while(|(a, b)| a == b).count();
    let rest = before.len().min(after.len()) - start;
    let end = before.iter().rev().zip(after.iter().rev()).take(rest).take_while(|(a, b)| a == b).count();
    let gone = before[start..before.len() - end].iter().map(|line| format!("-{line}"));
    gone.chain(after[start..after.len() - end].iter().map(|line| format!("+{line}"))).collect()
}

#[test]
fn segments_80x24_ascii() {
    assert_snapshot!(opened(80, 24, ASCII).0.keys("jjlc38<Tab>").text());
}

#[test]
fn bearings_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("<F2>llll<Enter><Ctrl-u>750 N/u").text());
}

#[test]
fn bearings_120x40() {
    assert_snapshot!(opened(120, 40, UNICODE).0.keys("<F2>llllc2e8<Enter>").text());
}

#[test]
fn mesh_80x24_ascii() {
    assert_snapshot!(opened(80, 24, ASCII).0.keys("<F4>jj").text());
}

#[test]
fn matrix_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("<F2>lll l<Enter>lc9e9<Enter>").text());
}

#[test]
fn findings_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("lc-5<Enter>c-6<Enter>fj").text());
}

#[test]
fn wrong_input_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("c3 kg<Enter>").text());
}

#[test]
fn variant_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("S<Ctrl-u>a/b").text());
}

#[test]
fn leave_80x24() {
    assert_snapshot!(opened(80, 24, UNICODE).0.keys("c4<Enter>q").text());
}

#[test]
fn segments_60x18() {
    assert_snapshot!(opened(60, 18, UNICODE).0.text());
}

#[test]
fn design_120x40_ascii() {
    assert_snapshot!(opened(120, 40, ASCII).0.keys("<F8>").text());
}
