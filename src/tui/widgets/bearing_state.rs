//! One bearing in numbers: its mean load, where its inner ring stands, and the stiffness that follows.
//!
//! ```text
//!  mean load, N x -8,123 y 12,410 z 6,001, N m thx 12.3 thz -4.5
//!  inner ring, um x 4.21 y 10.53 z -0.84, mrad thx 0.012 thz 0.003
//!  17 of 17 loaded, most 1,400 N, contact angle 20.0 deg
//!            x        y        z      thx      thy      thz
//!  x    1.99e9   -1.2e7        0  ...
//! ```

use nalgebra::Matrix6;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use crate::bearing::State;
use crate::number::{grouped, significant};
use crate::text::wrap;
use crate::tui::bearings::{BearingRow, angles, displacement, load};
use crate::tui::theme::Theme;

const MOTIONS: [&str; 6] = ["x", "y", "z", "thx", "thy", "thz"];
const LABEL: usize = 4;

/// Rows that everything takes but the notes.
pub const HEIGHT: u16 = 10;

/// Units of the stiffness and which series springs are in it, the longest first.
pub fn stiffness_units(springs: &str) -> Vec<String> {
    vec![format!("6x6{springs}: N/m, N/rad = N, N m/rad"), "6x6: N/m, N/rad, N m/rad".into()]
}

/// Draws what is known of a bearing.
pub fn render(row: &BearingRow<'_>, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width);
    let mut lines: Vec<(String, Style)> = Vec::new();
    match (row.rolling, row.support) {
        (Some(rolling), _) => lines.extend(state_lines(row, &rolling.state, width)),
        (None, Some(_)) => {
            let word = row.bearing.model.word();
            let text = format!("A {word} bearing is linear: what it does is given, and no load changes it.");
            lines.extend(
                wrap(&text, width.saturating_sub(2)).into_iter().map(|line| (format!(" {line}"), Style::new())),
            );
        }
        (None, None) => lines.push((" not known yet".into(), theme.faint)),
    }
    let held: Vec<&str> = row.support.map_or(Vec::new(), |support| {
        let held = MOTIONS.into_iter().zip(support.held);
        held.filter(|(_, held)| *held).map(|(motion, _)| motion).collect()
    });
    match row.support {
        Some(_) if !held.is_empty() => lines.push((format!(" rigid: holds {}", held.join(", ")), Style::new())),
        Some(support) => {
            lines.push((heading(width), theme.faint));
            lines.extend((0..6).map(|i| (matrix_row(&support.stiffness, i, width), Style::new())));
        }
        None => {}
    }
    let state = row.rolling.map(|rolling| &rolling.state);
    lines.extend(state.and_then(State::note).map(|note| (format!(" note: {note}"), theme.faint)));
    let warnings = state.map_or(&[][..], |state| &state.warnings);
    lines.extend(warnings.iter().map(|warning| (format!(" ! {warning}"), theme.warning)));
    for ((text, style), y) in lines.iter().zip(area.top()..area.bottom()) {
        buffer.set_stringn(area.x, y, text, width, *style);
    }
}

/// Load, displacement and contacts.
fn state_lines(row: &BearingRow<'_>, state: &State, width: usize) -> Vec<(String, Style)> {
    let Some(rolling) = row.rolling else { return Vec::new() };
    let (load, moved) = (load(rolling), displacement(rolling));
    let is_wide = width >= 66;
    let (words, digits) = if is_wide { (["mean load, ", "inner ring, "], 4) } else { (["", ""], 3) };
    let line = |words: &str, units: [&str; 2], across: [String; 3], about: [f64; 2]| {
        let [x, y, z] = across;
        let [thx, thz] = about.map(|value| significant(value, digits - 1));
        let (unit, unit_about) = (units[0], units[1]);
        format!("{words}{unit} x {x} y {y} z {z}, {unit_about} thx {thx} thz {thz}")
    };
    let across = [0, 1, 2].map(|i| significant(moved[i] * 1e6, digits));
    let angle = if is_wide { "contact angle" } else { "angle" };
    let (loaded, most) = (state.loaded(), grouped(state.greatest_load()));
    let lines = [
        line(words[0], ["N", "N m"], [0, 1, 2].map(|i| grouped(load[i])), [load[3], load[5]]),
        line(words[1], ["um", "mrad"], across, [moved[3] * 1e3, moved[5] * 1e3]),
        format!("{loaded} of {} loaded, most {most} N, {angle} {} deg", state.contacts.len(), angles(state)),
    ];
    let room = width.saturating_sub(1);
    let wrapped = lines.iter().flat_map(|line| wrap(line, room));
    wrapped.map(|line| (format!(" {line}"), Style::new())).collect()
}

fn heading(width: usize) -> String {
    let column = column(width);
    let names = MOTIONS.map(|name| format!("{name:>column$}")).concat();
    format!("{:LABEL$}{names}", "")
}

fn column(width: usize) -> usize {
    (width.saturating_sub(LABEL) / 6).clamp(7, 11)
}

/// What is rounding beside the diagonal is shown as the zero it stands for.
fn matrix_row(matrix: &Matrix6<f64>, i: usize, width: usize) -> String {
    let column = column(width);
    let digits = column.saturating_sub(6).min(4);
    let negligible = |j: usize| matrix[(i, j)].abs() <= 1e-13 * (matrix[(i, i)] * matrix[(j, j)]).abs().sqrt();
    let entry = |j: usize| if negligible(j) { "0".to_owned() } else { format!("{:.*e}", digits, matrix[(i, j)]) };
    let entries = [0, 1, 2, 3, 4, 5].map(|j| format!("{:>column$}", entry(j))).concat();
    format!(" {:<1$}{entries}", MOTIONS[i], LABEL - 1)
}
