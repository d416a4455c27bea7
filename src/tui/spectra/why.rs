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
        let labelled = |pair: PeakPair| Labelled { pair, beside_hz: beside_hz(&pair), mode: name(&pair) };
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
