//! How well a lumped model agrees with the finite element model.

/// Agreement of one lumped model with the finite element model, over a band of the analysis lines.
#[derive(Debug, Clone, PartialEq)]
pub struct Agreement {
    /// RMS of the difference in dB over the band.
    pub rms_db: f64,
    /// Largest |difference| in dB over the band, and where it is.
    pub max_db: f64,
    pub max_at_hz: f64,
    /// Frequency response assurance criterion over the band, 0 to 1.
    pub frac: f64,
    /// Up to where the sixth-octave levels differ by no more than the tolerance, over all lines; 0 if nowhere.
    pub agreement_limit_hz: f64,
    pub peaks: Vec<PeakPair>,
}

/// A resonance peak of the finite element model and its partner; one side is `None` where it has none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakPair {
    pub fe_hz: Option<f64>,
    pub lumped_hz: Option<f64>,
    /// (lumped - FE) / FE, in percent
    pub shift_percent: Option<f64>,
    /// lumped over FE, in dB
    pub height_db: Option<f64>,
}
