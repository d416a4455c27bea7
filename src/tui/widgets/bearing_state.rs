//! One bearing in numbers: its mean load, where its inner ring stands, and the stiffness that follows.
//!
//! ```text
//!  load N    -8,123  12,410  6,001   N m  12.3  -4.5
//!  moved um  4.21  10.53  -0.84   mrad  0.012  0.003
//!  17 of 17 loaded, most 1,400 N, contact angle 20.0 deg
//!            x        y        z      thx      thy      thz
//!  x    1.99e9   -1.2e7        0  ...
//! ```

use nalgebra::Matrix6;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::bearing_table::angles;
use crate::bearing::State;
use crate::number::{grouped, significant};
use crate::text::wrap;
use crate::tui::bearings::{BearingRow, displacement, load};
use crate::tui::theme::Theme;

const MOTIONS: [&str; 6] = ["x", "y", "z", "thx", "thy", "thz"];
const LABEL: usize = 4;

/// Rows that everything takes but the notes.
pub const HEIGHT: u16 = 10;

/// Units of the stiffness and what is in it, the longest first.
pub const STIFFNESS: [&str; 2] = ["6x6 with Kc, before Khb: N/m, N/rad = N, N m/rad", "6x6: N/m, N/rad, N m/rad"];

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
    let three = |of: &dyn Fn(usize) -> String| {
        ["x", "y", "z"].iter().enumerate().map(|(i, name)| format!("{name} {}", of(i))).collect::<Vec<_>>().join("  ")
    };
    let figure = |value: f64| significant(value, 4);
    let angles = format!("contact angle {} deg", angles(state));
    let most = grouped(state.greatest_load());
    let loaded = format!("{} of {} loaded, most {most} N, {angles}", state.loaded(), state.contacts.len());
    let words = if width >= 66 { ["mean load ", "inner ring "] } else { ["", ""] };
    let lines = [
        format!(
            " {}N: {}; N m: thx {} thz {}",
            words[0],
            three(&|i| grouped(load[i])),
            significant(load[3], 3),
            significant(load[5], 3)
        ),
        format!(
            " {}um: {}; mrad: thx {} thz {}",
            words[1],
            three(&|i| figure(moved[i] * 1e6)),
            significant(moved[3] * 1e3, 3),
            significant(moved[5] * 1e3, 3)
        ),
        format!(" {loaded}"),
    ];
    lines.into_iter().map(|line| (line, Style::new())).collect()
}

fn heading(width: usize) -> String {
    let column = column(width);
    let names: String = MOTIONS.iter().map(|name| format!("{name:>column$}")).collect();
    format!("{:LABEL$}{names}", "")
}

fn column(width: usize) -> usize {
    (width.saturating_sub(LABEL) / 6).clamp(8, 12)
}

/// What is rounding beside the diagonal is shown as the zero it stands for.
fn matrix_row(matrix: &Matrix6<f64>, i: usize, width: usize) -> String {
    let column = column(width);
    let digits = column.saturating_sub(7).min(4);
    let negligible = |j: usize| matrix[(i, j)].abs() <= 1e-13 * (matrix[(i, i)] * matrix[(j, j)]).abs().sqrt();
    let entry = |j: usize| if negligible(j) { "0".to_owned() } else { format!("{:.*e}", digits, matrix[(i, j)]) };
    let entries: String = (0..6).map(|j| format!("{:>column$}", entry(j))).collect();
    format!(" {:<1$}{entries}", MOTIONS[i], LABEL - 1)
}
