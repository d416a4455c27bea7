//! The rows of the table: the modes of finite elements with their partners, and lumped modes without one, by frequency.

use super::study::{MODELS, Study};
use crate::model::ModelKind;
use crate::response::Mode;

/// One row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModeRow {
    /// Number among the finite element modes, from 0
    pub fe: Option<usize>,
    /// Partner in the enhanced, the basic and the reduced model, or the mode itself where the row has none of finite elements
    pub partners: [Option<Partner>; MODELS],
}

/// A small model's mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Partner {
    /// Number among its modes, from 0
    pub mode: usize,
    pub hz: f64,
    /// (its own - FE) / FE in percent, and the MAC; nothing where it has no partner, the first also of the rigid rotation
    pub shift_percent: Option<f64>,
    pub mac: Option<f64>,
}

/// Models whose modes without a partner have rows of their own: of a reduced model those lie far above what it was made for.
const LUMPED: usize = 2;

/// All rows.
pub fn rows(study: &Study) -> Vec<ModeRow> {
    let partner = |model: usize, fe: usize| {
        let small = study.one(model)?;
        let pair = small.pairs.iter().find(|pair| pair.fe == fe)?;
        let (hz, fe_hz) = (small.own.modes.0[pair.lumped].frequency_hz, study.fe.modes.0[fe].frequency_hz);
        let shift_percent = Some(100.0 * (hz - fe_hz) / fe_hz).filter(|_| !study.fe.modes.0[fe].is_rigid());
        Some(Partner { mode: pair.lumped, hz, shift_percent, mac: Some(pair.mac) })
    };
    let of_fe = (0..study.fe.modes.0.len())
        .map(|fe| ModeRow { fe: Some(fe), partners: std::array::from_fn(|model| partner(model, fe)) });
    let mut rows: Vec<ModeRow> = of_fe.collect();
    for (model, small) in study.small().enumerate().take(LUMPED) {
        for (at, mode) in small.own.modes.0.iter().enumerate() {
            if small.pairs.iter().all(|pair| pair.lumped != at) {
                let own = Partner { mode: at, hz: mode.frequency_hz, shift_percent: None, mac: None };
                let mut partners = [None; MODELS];
                partners[model] = Some(own);
                rows.push(ModeRow { fe: None, partners });
            }
        }
    }
    rows.sort_by(|a, b| a.hz(study).total_cmp(&b.hz(study)));
    rows
}

impl ModeRow {
    /// The mode that the row is about: that of finite elements, where it has one.
    pub fn mode<'a>(&self, study: &'a Study) -> Option<&'a Mode> {
        if let Some(fe) = self.fe {
            return study.fe.modes.0.get(fe);
        }
        self.partner_mode(self.model()?, study)
    }

    /// Its partner in one of the small models, or itself.
    pub fn partner_mode<'a>(&self, model: usize, study: &'a Study) -> Option<&'a Mode> {
        study.one(model)?.own.modes.0.get(self.partners.get(model)?.as_ref()?.mode)
    }

    pub(super) fn hz(&self, study: &Study) -> f64 {
        self.mode(study).map_or(0.0, |mode| mode.frequency_hz)
    }

    /// The small model whose own mode it is, where it has none of finite elements.
    pub fn model(&self) -> Option<usize> {
        self.partners.iter().position(Option::is_some).filter(|_| self.fe.is_none())
    }

    /// The model that the row is about.
    pub fn kind(&self, study: &Study) -> ModelKind {
        self.model().and_then(|model| study.one(model)).map_or(ModelKind::Fe, |small| small.own.kind())
    }
}
