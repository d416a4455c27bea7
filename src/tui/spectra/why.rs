//! Where the curves disagree and which modes make them: figures of the analysis lines.

use std::sync::Arc;

use super::quantity::Quantity;
use super::solve::Subject;
use crate::agreement::{
    Causes, DisagreementBand, LEAST_PARTICIPATION, ModalComparison, PeakPair, disagreement_bands, pair_peaks, peaks,
};
use crate::model::ModelKind;

use super::curve::Curve;

/// All bands and peaks of one model against finite elements.
#[derive(Debug)]
pub struct Findings {
    pub against: ModelKind,
    pub quantity: Quantity,
    /// dB
    pub tolerance: f64,
    pub bands: Vec<Band>,
    pub peaks: Vec<Labelled>,
    /// Modes are named.
    pub is_complete: bool,
}

#[derive(Debug)]
pub struct Band {
    pub band: DisagreementBand,
    /// Of the mode held responsible: Hz, and its name with the motion that has most of its energy
    pub mode: Option<(f64, String)>,
    pub sentences: Vec<String>,
}

/// Two peaks that belong together, or one alone, with the mode that makes it.
#[derive(Debug)]
pub struct Labelled {
    pub pair: PeakPair,
    pub mode: Option<String>,
}

impl Labelled {
    /// Where it is: of finite elements, else of the other model, Hz.
    pub fn place(&self) -> f64 {
        self.pair.fe_hz.or(self.pair.lumped_hz).unwrap_or(0.0)
    }
}

impl Findings {
    pub fn new(
        subject: &Subject,
        fe: &Curve,
        (against, lumped): (ModelKind, &Curve),
        tolerance: f64,
        modes: Option<&Arc<ModalComparison>>,
    ) -> Self {
        let lines = &subject.frequency_hz;
        let quantity = fe.quantity;
        let band = |band: DisagreementBand| {
            // the modes' parts are those in the mesh force
            let modes = modes.filter(|_| quantity == Quantity::MeshForce);
            let Some(modes) = modes else { return Band { band, mode: None, sentences: Vec::new() } };
            let causes = Causes::new(modes, &subject.rotors, band);
            let mode = causes.mode.as_ref().map(|(name, hz, dominant)| (*hz, format!("{name}; {dominant}")));
            Band { band, mode, sentences: causes.sentences() }
        };
        let bands = disagreement_bands(lines, &lumped.lines, &fe.lines, tolerance).into_iter().map(band).collect();
        let pairs = pair_peaks(&peaks(lines, &lumped.lines), &peaks(lines, &fe.lines));
        let labelled = |pair: PeakPair| Labelled { pair, mode: modes.and_then(|modes| mode_at(modes, &pair)) };
        let peaks = pairs.into_iter().map(labelled).collect();
        Self { against, quantity, tolerance, bands, peaks, is_complete: modes.is_some() }
    }
}

/// The mode next to a peak, of those that the mesh drives; nothing where none is near.
fn mode_at(modes: &ModalComparison, pair: &PeakPair) -> Option<String> {
    const NEAR: f64 = 0.03;
    let (modes, hz) = match (pair.fe_hz, pair.lumped_hz) {
        (Some(hz), _) => (&modes.fe, hz),
        (None, Some(hz)) => (&modes.lumped, hz),
        (None, None) => return None,
    };
    let largest = modes.0.iter().map(|mode| mode.participation).fold(f64::MIN_POSITIVE, f64::max);
    let driven = modes.0.iter().filter(|mode| mode.participation >= LEAST_PARTICIPATION * largest);
    let distance = |hz_of_mode: f64| (hz_of_mode - hz).abs();
    let nearest = driven.min_by(|a, b| distance(a.frequency_hz).total_cmp(&distance(b.frequency_hz)))?;
    (distance(nearest.frequency_hz) <= NEAR * hz).then(|| nearest.name())
}
