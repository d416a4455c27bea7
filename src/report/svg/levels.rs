//! Sixth-octave levels of the three models as steps over a logarithmic axis.

use super::axis::Axis;
use super::frame::{Frame, MODELS, legend};
use super::{Anchor, Drawing, Picture, WIDTH};
use crate::agreement::Tolerance;
use crate::design::Design;
use crate::number::ticks::round_step;
use crate::report::study::{Levels, Study};

const LEFT: f64 = 58.0;
const RIGHT: f64 = WIDTH - 14.0;
const TOP: f64 = 34.0;
const BOTTOM: f64 = 254.0;
const HEIGHT: f64 = 294.0;

/// With the bands shaded in which the enhanced model's level is not within the tolerance of the trust limit.
pub fn levels(design: &Design, study: &Study) -> Picture {
    let tolerance_db = Tolerance::default().band_level_db;
    let all = &study.levels;
    let ends = (all.first().map_or(1.0, |band| band.low_hz), all.last().map_or(2.0, |band| band.high_hz));
    let x = Axis { low: ends.0, high: ends.1, log: true, from: LEFT, to: RIGHT };
    let values = || all.iter().flat_map(|band| [band.fe_db, band.enhanced_db, band.basic_db]);
    let (lowest, highest) = (values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max));
    let step = round_step((highest - lowest) / 8.0);
    let (low, high) = ((lowest / step).floor() * step, ((highest / step).floor() + 1.0) * step);
    let y = Axis { low, high, log: false, from: BOTTOM, to: TOP };
    let mut drawing = Drawing::default();
    legend(&mut drawing, [LEFT, 14.0], &format!("sixth-octave level more than {tolerance_db} dB off"));
    let beyond = |band: &&Levels| (band.enhanced_db - band.fe_db).abs() > tolerance_db;
    for band in all.iter().filter(beyond) {
        drawing.rect("band", [x.at(band.low_hz), TOP], [x.at(band.high_hz), BOTTOM], None);
    }
    Frame { x, y }.draw(&mut drawing, true);
    let level: [fn(&Levels) -> f64; 3] = [|band| band.fe_db, |band| band.enhanced_db, |band| band.basic_db];
    for ((class, _), level) in MODELS.into_iter().zip(level).rev() {
        let steps = all.iter().flat_map(|band| [band.low_hz, band.high_hz].map(|hz| [x.at(hz), y.at(level(band))]));
        drawing.path(&format!("curve {class}"), &steps.collect::<Vec<_>>(), false);
    }
    drawing.text("label", [4.0, TOP - 8.0], Anchor::Start, "dB re 1 N");
    drawing.text("label", [f64::midpoint(LEFT, RIGHT), HEIGHT - 6.0], Anchor::Middle, "frequency, Hz");
    let outside = all.iter().filter(beyond).count();
    Picture {
        name: "levels",
        title: format!("Sixth-octave levels of {}", design.name),
        description: format!(
            "Levels of the dynamic mesh force in {} sixth-octave bands by finite elements, the enhanced and the basic lumped model. \
             The enhanced model is more than {tolerance_db} dB off in {outside} of them.",
            all.len()
        ),
        height: HEIGHT,
        body: drawing.0,
    }
}
