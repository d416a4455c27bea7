//! The rows of the table: the modes of finite elements with their partners, and lumped modes without one, by frequency.

use super::study::Study;
use crate::response::Mode;

/// One row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModeRow {
    /// Number among the finite element modes, from 0
    pub fe: Option<usize>,
    /// Partner in the enhanced and in the basic model, or the mode itself where the row has none of finite elements
    pub lumped: [Option<Partner>; 2],
}

/// A lumped mode.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Partner {
    /// Number among the lumped modes, from 0
    pub mode: usize,
    pub hz: f64,
    /// (lumped - FE) / FE in percent, and the MAC; nothing where it has no partner, the first also of the rigid rotation
    pub shift_percent: Option<f64>,
    pub mac: Option<f64>,
}

/// All rows.
pub fn rows(study: &Study) -> Vec<ModeRow> {
    let partner = |model: usize, fe: usize| {
        let pair = study.pairs[model].iter().find(|pair| pair.fe == fe)?;
        let (hz, fe_hz) = (study.lumped[model].modes.0[pair.lumped].frequency_hz, study.fe.modes.0[fe].frequency_hz);
        let shift_percent =
            Some(100.0 * (hz - fe_hz) / fe_hz).filter(|_| study.fe.modes.0[fe].mesh_strain_share > 0.0 || fe_hz > 1.0);
        Some(Partner { mode: pair.lumped, hz, shift_percent, mac: Some(pair.mac) })
    };
    let of_fe =
        (0..study.fe.modes.0.len()).map(|fe| ModeRow { fe: Some(fe), lumped: [partner(0, fe), partner(1, fe)] });
    let mut rows: Vec<ModeRow> = of_fe.collect();
    for model in 0..2 {
        for (at, mode) in study.lumped[model].modes.0.iter().enumerate() {
            if study.pairs[model].iter().all(|pair| pair.lumped != at) {
                let own = Partner { mode: at, hz: mode.frequency_hz, shift_percent: None, mac: None };
                let mut lumped = [None; 2];
                lumped[model] = Some(own);
                rows.push(ModeRow { fe: None, lumped });
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
        self.lumped.iter().zip(&study.lumped).find_map(|(partner, model)| model.modes.0.get(partner.as_ref()?.mode))
    }

    fn hz(&self, study: &Study) -> f64 {
        self.mode(study).map_or(0.0, |mode| mode.frequency_hz)
    }

    /// The model that the row is about: `fe`, `enhanced` or `basic`.
    pub fn model(&self) -> &'static str {
        match (self.fe, self.lumped) {
            (Some(_), _) => "FE",
            (None, [Some(_), _]) => "enhanced",
            _ => "basic",
        }
    }
}
