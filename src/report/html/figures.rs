//! The figures of agreement, and the peaks behind them.

use super::table::{Cell, Table};
use crate::agreement::{Agreement, FARTHEST_PEAK, LEAST_PROMINENCE_DB, PeakPair, Tolerance};
use crate::number::{grouped, significant};
use crate::report::markup::escape;
use crate::report::study::Study;

/// What a reader wants to know first.
pub fn trust(study: &Study) -> String {
    let hz = study.comparison.enhanced_agreement.agreement_limit_hz;
    if hz > 0.0 {
        format!("trust the enhanced model up to {} Hz", grouped(hz))
    } else {
        "do not trust the enhanced model at any frequency".into()
    }
}

pub fn render(study: &Study) -> String {
    let comparison = &study.comparison;
    let lines = &comparison.frequency_hz;
    let (low, high) = (lines.first().copied().unwrap_or(0.0), lines.last().copied().unwrap_or(0.0));
    let caption = format!(
        "Lumped models against finite elements ({} coordinates) over {} lines from {} to {} Hz",
        comparison.fe.coordinates,
        grouped(lines.len() as f64),
        grouped(low),
        grouped(high)
    );
    let heads = ["model", "coordinates#", "trust up to, Hz#", "RMS, dB#", "largest, dB#", "at, Hz#", "FRAC (0 to 1)#"];
    let mut table = Table::new(&caption, heads);
    let models = [
        ("enhanced", &comparison.enhanced, &comparison.enhanced_agreement),
        ("basic", &comparison.basic, &comparison.basic_agreement),
    ];
    for (name, spectrum, agreement) in models {
        let &Agreement { rms_db, max_db, max_at_hz, frac, agreement_limit_hz, .. } = agreement;
        table.row([
            Cell::text(name),
            Cell::number(&spectrum.coordinates.to_string()),
            Cell::number(&grouped(agreement_limit_hz)),
            Cell::number(&format!("{rms_db:.2}")),
            Cell::number(&format!("{max_db:.2}")),
            Cell::number(&grouped(max_at_hz)),
            Cell::number(&format!("{frac:.3}")),
        ]);
    }
    let sentence = trust(study);
    let mut first = sentence.chars();
    let sentence: String = first.next().into_iter().flat_map(char::to_uppercase).chain(first).collect();
    format!(
        "<p class=\"trust\">{}</p>\n{}<p>Up to the trust limit every sixth-octave level of a lumped model lies within {} dB of finite \
         elements; single lines may differ by more. RMS is the root mean square of the difference in dB over all lines: 0 where both are equal. FRAC is the likeness of both \
         complex spectra over all lines: 1 where they differ by a factor only, 0 where they have nothing in common.</p>\n",
        escape(&sentence),
        table.render(),
        Tolerance::default().band_level_db,
    )
}

pub fn peaks(study: &Study) -> String {
    let comparison = &study.comparison;
    let of = |name, agreement: &Agreement| {
        let caption = format!(
            "Peaks of at least {LEAST_PROMINENCE_DB} dB prominence, finite elements and {name}, paired by frequency within {:.0} %; a dash: no partner",
            100.0 * FARTHEST_PEAK
        );
        let mut table =
            Table::new(&caption, ["finite elements, Hz#", &format!("{name}, Hz#"), "shift, %#", "height, dB#"]);
        for PeakPair { fe_hz, lumped_hz, shift_percent, height_db } in &agreement.peaks {
            let hz = |hz: &Option<f64>| Cell::number_or_none(hz.map(|hz| significant(hz, 5)));
            let signed = |value: &Option<f64>| Cell::number_or_none(value.map(|value| format!("{value:+.2}")));
            table.row([hz(fe_hz), hz(lumped_hz), signed(shift_percent), signed(height_db)]);
        }
        if agreement.peaks.is_empty() {
            return format!(
                "<p>No peak of at least {LEAST_PROMINENCE_DB} dB prominence, finite elements and {name}.</p>\n"
            );
        }
        table.render()
    };
    of("enhanced", &comparison.enhanced_agreement) + &of("basic", &comparison.basic_agreement)
}
