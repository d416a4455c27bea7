//! Few frequency lines of a design, and how far two spectra are apart.

use bevelscope::design::Design;
use bevelscope::response::frequency_lines;
use num_complex::Complex64;

/// So many lines over the design's range, Hz.
pub fn lines(design: &Design, count: usize) -> Vec<f64> {
    let mut analysis = design.analysis.clone();
    analysis.frequency_lines = count;
    frequency_lines(&analysis)
}

/// The largest |a - b| over the largest |b|.
pub fn error_of_peak(a: &[Complex64], b: &[Complex64]) -> f64 {
    let peak = b.iter().map(|value| value.norm()).fold(0.0, f64::max);
    a.iter().zip(b).map(|(a, b)| (a - b).norm() / peak).fold(0.0, f64::max)
}
