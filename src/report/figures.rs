//! How a lumped model agrees with finite elements, as JSON.

use crate::agreement::{Agreement, PeakPair};

/// The figures of one lumped model.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Figures {
    pub rms_db: f64,
    pub max_db: f64,
    pub max_at_hz: f64,
    pub frac: f64,
    pub agreement_limit_hz: f64,
    pub peaks: Vec<Peak>,
}

/// A resonance of the finite element model beside that of the lumped model; null where one has no partner.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Peak {
    pub fe_hz: Option<f64>,
    pub lumped_hz: Option<f64>,
    pub shift_percent: Option<f64>,
    pub height_db: Option<f64>,
}

impl From<&Agreement> for Figures {
    fn from(agreement: &Agreement) -> Self {
        let Agreement { rms_db, max_db, max_at_hz, frac, agreement_limit_hz, ref peaks } = *agreement;
        let peak = |&PeakPair { fe_hz, lumped_hz, shift_percent, height_db }: &PeakPair| Peak {
            fe_hz,
            lumped_hz,
            shift_percent,
            height_db,
        };
        Self { rms_db, max_db, max_at_hz, frac, agreement_limit_hz, peaks: peaks.iter().map(peak).collect() }
    }
}
