//! The mesh force of the three models over one another, the bands in which they disagree, and the difference below.

use super::axis::Axis;
use super::curve::places;
use super::frame::{Frame, MODELS, legend};
use super::{Anchor, Drawing, Picture, WIDTH, text_width};
use crate::agreement::{Agreement, Causes, Tolerance};
use crate::design::{Design, FrequencySpacing};
use crate::model::mesh_frequency_hz;
use crate::number::grouped;
use crate::number::ticks::round_step;
use crate::report::study::{Study, widest_difference_db};

const LEFT: f64 = 58.0;
const RIGHT: f64 = WIDTH - 14.0;
/// Upper and lower edge of the levels, then of the difference
const LEVELS: [f64; 2] = [54.0, 354.0];
const DIFFERENCE: [f64; 2] = [392.0, 512.0];
const HEIGHT: f64 = 552.0;

/// On the axis that the design's analysis asks for.
pub fn spectra(design: &Design, study: &Study) -> Picture {
    let analysis = &design.analysis;
    let (low, high) = (analysis.frequency_min, analysis.frequency_max);
    let log = analysis.frequency_spacing == FrequencySpacing::Log;
    let x = Axis { low, high, log, from: LEFT, to: RIGHT };
    let mut drawing = Drawing::default();
    legend(&mut drawing, [LEFT, 14.0], &format!("enhanced more than {} dB off, line by line", study.tolerance_db));
    let mesh = mesh_frequency_hz(design);
    levels(&mut drawing, x, study);
    harmonics(&mut drawing, x, mesh);
    difference(&mut drawing, x, study);
    drawing.text("label", [f64::midpoint(LEFT, RIGHT), HEIGHT - 6.0], Anchor::Middle, "frequency, Hz");
    Picture {
        name: "spectra",
        title: format!("Dynamic mesh force of {}", design.name),
        description: description(study, [low, high]) + &mesh.map_or_else(String::new, harmonics_in_words),
        height: HEIGHT,
        body: drawing.0,
    }
}

fn description(study: &Study, [low, high]: [f64; 2]) -> String {
    let Agreement { agreement_limit_hz, rms_db, .. } = study.comparison.enhanced_agreement;
    format!(
        "Level of the dynamic mesh force from {} to {} Hz by finite elements, the enhanced and the basic lumped model, and below it how \
         far the lumped ones are off. The enhanced model can be trusted up to {} Hz and is {rms_db:.2} dB RMS off; it is more than \
         {} dB off in {} {}.",
        grouped(low),
        grouped(high),
        grouped(agreement_limit_hz),
        study.tolerance_db,
        study.causes.len(),
        if study.causes.len() == 1 { "band" } else { "bands" }
    )
}

fn levels(drawing: &mut Drawing, x: Axis, study: &Study) {
    /// Antiresonances without damping have no end: they are cut off this far below the highest peak, dB.
    const DEEPEST: f64 = 140.0;
    let curves = [&study.curves.fe_db, &study.curves.enhanced_db, &study.curves.basic_db];
    let all = || curves.into_iter().flatten().copied();
    let highest = all().fold(f64::NEG_INFINITY, f64::max);
    let lowest = all().fold(f64::INFINITY, f64::min).max(highest - DEEPEST);
    let step = round_step((highest - lowest) / 10.0);
    let (low, high) = ((lowest / step).floor() * step, ((highest / step).floor() + 1.0) * step);
    let y = Axis { low, high, log: false, from: LEVELS[1], to: LEVELS[0] };
    bands(drawing, x, study, LEVELS, true);
    Frame { x, y }.draw(drawing, false);
    let frequency_hz = &study.curves.frequency_hz;
    for ((class, _), values) in MODELS.into_iter().zip(curves).rev() {
        let values = frequency_hz.iter().copied().zip(values.iter().copied());
        drawing.path(&format!("curve {class}"), &places(&x, &y, values), false);
    }
    limits(drawing, x, study);
    drawing.text("label", [4.0, LEVELS[0] - 8.0], Anchor::Start, "dB re 1 N");
}

/// Harmonics of the mesh frequency that are marked.
const HARMONICS: u32 = 9;

/// What the marks 1x, 2x and so on mean.
pub fn harmonics_in_words(mesh_hz: f64) -> String {
    format!(
        " The mesh frequency at the speed of the design, {} Hz, and its harmonics are marked 1\u{d7}, 2\u{d7} and so on.",
        grouped(mesh_hz)
    )
}

/// The mesh frequency and its harmonics, named where there is room.
fn harmonics(drawing: &mut Drawing, x: Axis, mesh_hz: Option<f64>) {
    let Some(mesh_hz) = mesh_hz else { return };
    let mut free = f64::NEG_INFINITY;
    let orders = (1..=HARMONICS).map(|order| (order, f64::from(order) * mesh_hz));
    for (order, hz) in orders.filter(|(_, hz)| (x.low..=x.high).contains(hz)) {
        let at = x.at(hz);
        for [top, bottom] in [LEVELS, DIFFERENCE] {
            drawing.line("place", [at, top], [at, bottom]);
        }
        let text = format!("{order}\u{d7}");
        let width = text_width(&text);
        if at > free && at + 3.0 + width <= x.to {
            drawing.text("faint", [at + 3.0, LEVELS[0] + 13.0], Anchor::Start, &text);
            free = at + 3.0 + width;
        }
    }
}

/// The shaded bands, numbered as in the list where there is room.
fn bands(drawing: &mut Drawing, x: Axis, study: &Study, [top, bottom]: [f64; 2], numbered: bool) {
    let mut free = f64::NEG_INFINITY;
    for (i, Causes { band, .. }) in study.causes.iter().enumerate() {
        let (from, to) = (x.at(band.from_hz), x.at(band.to_hz));
        let wider = (1.0 - (to - from)).max(0.0) / 2.0;
        let (from, to) = ((from - wider).max(x.from), (to + wider).min(x.to));
        let title = format!(
            "band {}: {} to {} Hz, {:+.1} dB at {} Hz",
            i + 1,
            grouped(band.from_hz),
            grouped(band.to_hz),
            band.worst_db,
            grouped(band.worst_at_hz)
        );
        drawing.rect("band", [from, top], [to, bottom], Some(&title));
        let number = (i + 1).to_string();
        let (middle, half) = (f64::midpoint(from, to), text_width(&number) / 2.0);
        if numbered && middle - half > free {
            drawing.text("strong", [middle, bottom - 6.0], Anchor::Middle, &number);
            free = middle + half + 3.0;
        }
    }
}

/// Up to where each lumped model can be trusted.
fn limits(drawing: &mut Drawing, x: Axis, study: &Study) {
    let comparison = &study.comparison;
    let limits = [
        ("limit", "enhanced", &comparison.enhanced_agreement, 28.0),
        ("limit-basic", "basic", &comparison.basic_agreement, 41.0),
    ];
    for (class, model, agreement, baseline) in limits {
        let hz = agreement.agreement_limit_hz;
        let text = format!("trust {model} up to {} Hz", grouped(hz));
        let at = x.at(hz);
        drawing.line(class, [at, baseline - 8.0], [at, LEVELS[1]]);
        let fits = at + 5.0 + text_width(&text) <= WIDTH;
        let (shift, anchor) = if fits { (5.0, Anchor::Start) } else { (-5.0, Anchor::End) };
        drawing.text("label", [at + shift, baseline], anchor, &text);
    }
}

fn difference(drawing: &mut Drawing, x: Axis, study: &Study) {
    /// What is farther off is drawn at the edge, dB.
    const WIDEST: f64 = 40.0;
    let widest = widest_difference_db(&study.comparison).max(study.tolerance_db).min(WIDEST);
    let step = round_step(widest / 4.0);
    let high = ((widest / step).floor() + 1.0) * step;
    let y = Axis { low: -high, high, log: false, from: DIFFERENCE[1], to: DIFFERENCE[0] };
    bands(drawing, x, study, DIFFERENCE, false);
    Frame { x, y }.draw(drawing, true);
    drawing.line("zero", [x.from, y.at(0.0)], [x.to, y.at(0.0)]);
    for edge in [study.tolerance_db, -study.tolerance_db] {
        if edge.abs() < high {
            drawing.line("tolerance", [x.from, y.at(edge)], [x.to, y.at(edge)]);
        }
    }
    let curves = &study.curves;
    for (class, values) in [("basic", &curves.basic_db), ("enhanced", &curves.enhanced_db)] {
        let differences = values.iter().zip(&curves.fe_db).map(|(lumped, fe)| lumped - fe);
        let values = curves.frequency_hz.iter().copied().zip(differences);
        drawing.path(&format!("curve {class}"), &places(&x, &y, values), false);
    }
    let over = format!(
        "lumped over finite elements, dB (trust: sixth-octave levels within {} dB)",
        Tolerance::default().band_level_db
    );
    drawing.text("label", [LEFT, DIFFERENCE[0] - 8.0], Anchor::Start, &over);
}
