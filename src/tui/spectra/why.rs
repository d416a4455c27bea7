//! Where the curves disagree and which modes make them: figures of the analysis lines.

use std::sync::Arc;

use super::quantity::Quantity;
use super::solve::Subject;
use crate::agreement::{Causes, DisagreementBand, ModalComparison, PeakPair, disagreement_bands, pair_peaks, peaks};
use crate::model::ModelKind;
use crate::response::Mode;

use super::curve::Curve;

/// All bands and peaks of one model against finite elements.
#[derive(Debug)]
pub struct Findings {
    pub against: ModelKind,
    /// Another lumped model, whose peaks stand beside
    pub beside: Option<ModelKind>,
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
    /// Of the other lumped model, the peak that belongs to that of finite elements, Hz
    pub beside_hz: Option<f64>,
    pub mode: Option<String>,
    /// Level of finite elements at their peak, dB re 1 unit
    pub fe_db: Option<f64>,
}

impl Labelled {
    /// Where it is: of finite elements, else of the other model, Hz.
    pub fn place(&self) -> f64 {
        self.pair.fe_hz.or(self.pair.lumped_hz).unwrap_or(0.0)
    }
}

impl Findings {
    /// The place of the highest peak of finite elements.
    pub fn highest_peak(&self) -> Option<usize> {
        let levels = self.peaks.iter().enumerate().filter_map(|(at, peak)| Some((at, peak.fe_db?)));
        levels.max_by(|a, b| a.1.total_cmp(&b.1)).map(|(at, _)| at)
    }

    pub fn new(
        subject: &Subject,
        fe: &Curve,
        (against, lumped): (ModelKind, &Curve),
        beside: Option<(ModelKind, &Curve)>,
        tolerance: f64,
        modes: Option<&Arc<ModalComparison>>,
    ) -> Self {
        let lines = &subject.frequency_hz;
        let quantity = fe.quantity;
        // without static shapes of a shaft there is no part to speak of
        let parts = modes.and_then(|modes| Some((modes, quantity.parts(modes, subject)?)));
        let band = |band: DisagreementBand| {
            let Some((modes, parts)) = &parts else { return Band { band, mode: None, sentences: Vec::new() } };
            let causes = Causes::in_parts(modes, parts, &subject.rotors, band);
            let mode = causes.mode.as_ref().map(|(name, hz, dominant)| {
                let dominant = dominant.to_string();
                // most names are that of the motion that dominates
                (*hz, if dominant.starts_with(name.as_str()) { dominant } else { format!("{name}; {dominant}") })
            });
            Band { band, mode, sentences: causes.sentences() }
        };
        let bands = disagreement_bands(lines, &lumped.lines, &fe.lines, tolerance).into_iter().map(band).collect();
        let fe_peaks = peaks(lines, &fe.lines);
        let pairs = pair_peaks(&peaks(lines, &lumped.lines), &fe_peaks);
        let others = beside.map_or_else(Vec::new, |(_, curve)| pair_peaks(&peaks(lines, &curve.lines), &fe_peaks));
        // both are the same lines, bit by bit
        let bits = |hz: Option<f64>| hz.map(f64::to_bits);
        let beside_hz = |pair: &PeakPair| {
            let same = |other: &&PeakPair| pair.fe_hz.is_some() && bits(other.fe_hz) == bits(pair.fe_hz);
            others.iter().find(same)?.lumped_hz
        };
        let name = |pair: &PeakPair| {
            let (modes, parts) = parts.as_ref()?;
            let hz = pair.fe_hz.or(pair.lumped_hz)?;
            modes.behind_peak(parts, pair.fe_hz.is_none(), hz, lines).map(Mode::name)
        };
        let fe_db = |pair: &PeakPair| {
            let hz = pair.fe_hz?;
            let at = lines.partition_point(|line| *line < hz);
            fe.lines.get(at).map(|value| 20.0 * value.norm().log10())
        };
        let labelled =
            |pair: PeakPair| Labelled { pair, beside_hz: beside_hz(&pair), mode: name(&pair), fe_db: fe_db(&pair) };
        let peaks = pairs.into_iter().map(labelled).collect();
        Self {
            against,
            beside: beside.map(|(kind, _)| kind),
            quantity,
            tolerance,
            bands,
            peaks,
            is_complete: modes.is_some(),
        }
    }
}
