//! Sixth-octave levels, and up to where two models share them.
//!
//! Bands and not lines: a limit found line by line would trip over the shift of an antiresonance far below the peaks.

use num_complex::Complex64;

use super::Tolerance;

/// A sixth-octave band with at least one line in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Band {
    /// Lower edge, Hz, included
    pub low_hz: f64,
    /// Upper edge, Hz, excluded
    pub high_hz: f64,
    /// Indices of the lines inside
    pub lines: std::ops::Range<usize>,
}

/// Edge below band `k`: 1000 * 2^((2k - 1)/12) Hz.
fn lower_edge(k: i32) -> f64 {
    1000.0 * (f64::from(2 * k - 1) / 12.0).exp2()
}

/// Bands of the given lines (Hz, ascending, positive) that hold a line; centres 1000 * 2^(k/6) Hz.
pub fn sixth_octave_bands(frequency_hz: &[f64]) -> Vec<Band> {
    let mut bands = Vec::new();
    let mut start = 0;
    while let Some(&first) = frequency_hz.get(start) {
        let mut k = (6.0 * (first / 1000.0).log2()).round() as i32;
        // the logarithm's rounding must not move a line that stands on an edge
        while first < lower_edge(k) {
            k -= 1;
        }
        while first >= lower_edge(k + 1) {
            k += 1;
        }
        let high_hz = lower_edge(k + 1);
        let end = frequency_hz.partition_point(|f| *f < high_hz);
        bands.push(Band { low_hz: lower_edge(k), high_hz, lines: start..end });
        start = end;
    }
    bands
}

/// Level of the lines of a band: 10 log10 mean |F|^2, dB re 1 N.
pub fn band_level_db(force: &[Complex64]) -> f64 {
    10.0 * (force.iter().map(Complex64::norm_sqr).sum::<f64>() / force.len() as f64).log10()
}

/// Upper edge of the last band, from below, up to which all band levels differ by no more than the tolerance; at most the highest line.
pub fn agreement_limit(frequency_hz: &[f64], lumped: &[Complex64], fe: &[Complex64], tolerance: Tolerance) -> f64 {
    let highest = frequency_hz.last().copied().unwrap_or(0.0);
    let mut limit = 0.0;
    for band in sixth_octave_bands(frequency_hz) {
        let difference = band_level_db(&lumped[band.lines.clone()]) - band_level_db(&fe[band.lines.clone()]);
        if difference.is_nan() || difference.abs() > tolerance.band_level_db {
            break;
        }
        limit = band.high_hz.min(highest);
    }
    limit
}
