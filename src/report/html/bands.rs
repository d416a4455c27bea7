//! Bands of disagreement with their reasons, and sixth-octave levels.

use std::fmt::Write as _;

use super::table::{Cell, Table};
use crate::number::grouped;
use crate::report::markup::escape;
use crate::report::study::Study;

pub fn render(study: &Study) -> String {
    let tolerance = study.tolerance_db;
    if study.causes.is_empty() {
        return format!(
            "<p>No line of the enhanced model differs from finite elements by more than {tolerance} dB.</p>\n"
        );
    }
    let caption = format!(
        "Bands in which line by line the difference is more than {tolerance} dB, with the mode held responsible"
    );
    let heads =
        ["band", "from, Hz#", "to, Hz#", "worst, dB#", "at, Hz#", "mode, Hz#", "shift, %#", "mode held responsible"];
    let mut table = Table::new(&caption, heads);
    let mut reasons = String::from("<ol class=\"reasons\">\n");
    for (i, causes) in study.causes.iter().enumerate() {
        let band = &causes.band;
        let mode = causes.mode.as_ref();
        table.row([
            Cell::text(&(i + 1).to_string()),
            Cell::number(&grouped(band.from_hz)),
            Cell::number(&grouped(band.to_hz)),
            Cell::number(&format!("{:+.1}", band.worst_db)),
            Cell::number(&grouped(band.worst_at_hz)),
            Cell::number_or_none(mode.map(|(_, hz, _)| grouped(*hz))),
            Cell::number_or_none(causes.shift.map(|shift| format!("{:+.1}", shift.percent))),
            mode.map_or_else(Cell::none, |(name, ..)| Cell::text(name)),
        ]);
        // writing to a String cannot fail
        let _ = writeln!(reasons, "<li>{}</li>", escape(&causes.sentences().join(" ")));
    }
    reasons.push_str("</ol>\n");
    table.render() + &reasons
}

pub fn levels(study: &Study) -> String {
    let heads = ["band, Hz#", "finite elements, dB#", "enhanced, dB#", "off by, dB#", "basic, dB#", "off by, dB#"];
    let mut table = Table::new("Sixth-octave levels of the mesh force, dB re 1 N", heads);
    for level in &study.levels {
        let db = |value: f64| Cell::number(&format!("{value:.1}"));
        let off = |value: f64| match value - level.fe_db {
            // no sign on what is rounded away
            -0.05..0.05 => Cell::number("0.0"),
            off => Cell::number(&format!("{off:+.1}")),
        };
        table.row([
            Cell::number(&format!("{} to {}", grouped(level.low_hz), grouped(level.high_hz))),
            db(level.fe_db),
            db(level.enhanced_db),
            off(level.enhanced_db),
            db(level.basic_db),
            off(level.basic_db),
        ]);
    }
    table.render()
}
