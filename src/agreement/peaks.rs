//! Resonance peaks of two spectra, paired.

use num_complex::Complex64;

/// A line higher than its neighbours that stands out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    pub frequency_hz: f64,
    /// dB re 1 N
    pub level_db: f64,
}

impl Peak {
    /// |`F_m`|, N.
    pub fn force(&self) -> f64 {
        10.0_f64.powf(self.level_db / 20.0)
    }
}

/// A peak of the finite element model and its partner; one side is `None` where it has none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PeakPair {
    pub fe_hz: Option<f64>,
    pub lumped_hz: Option<f64>,
    /// (lumped - FE) / FE, in percent
    pub shift_percent: Option<f64>,
    /// lumped over FE, in dB
    pub height_db: Option<f64>,
}

/// Peaks that stand out less are none, dB.
pub const LEAST_PROMINENCE_DB: f64 = 3.0;
/// Peaks farther apart are no pair: a part of the finite element peak's frequency.
pub const FARTHEST_PEAK: f64 = 0.15;

/// Peaks strictly inside the lines with at least [`LEAST_PROMINENCE_DB`] of prominence; of a plateau the first line counts.
pub fn peaks(frequency_hz: &[f64], force: &[Complex64]) -> Vec<Peak> {
    let level: Vec<f64> = force.iter().map(|force| 20.0 * force.norm().log10()).collect();
    // lowest level between each line and the nearest higher one before it (or the start)
    let before = lowest_since_higher(level.iter().copied());
    let after = lowest_since_higher(level.iter().rev().copied());
    let mut found = Vec::new();
    for i in 1..level.len().saturating_sub(1) {
        if level[i - 1] >= level[i] {
            continue;
        }
        // only from the first line of a plateau: each line is looked at once
        let falls = level[i + 1..].iter().find(|next| **next != level[i]).is_some_and(|next| *next < level[i]);
        // how far the spectrum falls on both sides before it rises higher
        let prominence_db = level[i] - before[i].max(after[level.len() - 1 - i]);
        if falls && prominence_db >= LEAST_PROMINENCE_DB {
            found.push(Peak { frequency_hz: frequency_hz[i], level_db: level[i] });
        }
    }
    found
}

/// The highest of the [`peaks`].
pub fn highest_peak(frequency_hz: &[f64], force: &[Complex64]) -> Option<Peak> {
    peaks(frequency_hz, force).into_iter().max_by(|a, b| a.level_db.total_cmp(&b.level_db))
}

/// For every value, the lowest one seen since the last strictly higher value; one pass with a stack of falling values.
fn lowest_since_higher(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut stack: Vec<(f64, f64)> = Vec::new();
    let mut out = Vec::new();
    for value in values {
        let mut lowest = value;
        while let Some(&(top, valley)) = stack.last() {
            if top > value {
                break;
            }
            lowest = lowest.min(valley);
            stack.pop();
        }
        stack.push((value, lowest));
        out.push(lowest);
    }
    out
}

/// Pairs peaks one to one, smallest relative distance first, at most [`FARTHEST_PEAK`]; unpaired ones follow in their place by frequency.
pub fn pair_peaks(lumped: &[Peak], fe: &[Peak]) -> Vec<PeakPair> {
    let mut candidates: Vec<(f64, usize, usize)> = Vec::new();
    for (i, f) in fe.iter().enumerate() {
        for (j, l) in lumped.iter().enumerate() {
            let distance = (l.frequency_hz - f.frequency_hz).abs() / f.frequency_hz;
            if distance <= FARTHEST_PEAK {
                candidates.push((distance, i, j));
            }
        }
    }
    candidates.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut partner: Vec<Option<usize>> = vec![None; fe.len()];
    let mut taken = vec![false; lumped.len()];
    for (_, i, j) in candidates {
        if partner[i].is_none() && !taken[j] {
            partner[i] = Some(j);
            taken[j] = true;
        }
    }
    let paired = fe.iter().zip(partner).map(|(f, partner)| {
        let l = partner.map(|j| lumped[j]);
        PeakPair {
            fe_hz: Some(f.frequency_hz),
            lumped_hz: l.map(|l| l.frequency_hz),
            shift_percent: l.map(|l| 100.0 * (l.frequency_hz - f.frequency_hz) / f.frequency_hz),
            height_db: l.map(|l| l.level_db - f.level_db),
        }
    });
    let alone = lumped.iter().zip(taken).filter(|(_, taken)| !taken);
    let alone = alone.map(|(l, _)| PeakPair {
        fe_hz: None,
        lumped_hz: Some(l.frequency_hz),
        shift_percent: None,
        height_db: None,
    });
    let mut out: Vec<PeakPair> = paired.chain(alone).collect();
    let place = |pair: &PeakPair| pair.fe_hz.or(pair.lumped_hz).unwrap_or(0.0);
    out.sort_by(|a, b| place(a).total_cmp(&place(b)));
    out
}
