//! Line by line: the difference in dB, and one figure for the likeness of two complex spectra.

use num_complex::Complex64;

/// 20 log10(|lumped| / |fe|) of every line, dB.
pub fn difference_db(lumped: &[Complex64], fe: &[Complex64]) -> Vec<f64> {
    lumped.iter().zip(fe).map(|(a, b)| 20.0 * (a.norm() / b.norm()).log10()).collect()
}

/// Frequency response assurance criterion |sum a conj(b)|^2 / (sum |a|^2 sum |b|^2), 0 to 1.
pub fn frac(a: &[Complex64], b: &[Complex64]) -> f64 {
    // the criterion does not depend on scale; without it the squares of large forces would overflow
    let largest = |values: &[Complex64]| values.iter().map(|value| value.norm()).fold(f64::MIN_POSITIVE, f64::max);
    let (scale_a, scale_b) = (largest(a), largest(b));
    let (mut cross, mut square_a, mut square_b) = (Complex64::ZERO, 0.0, 0.0);
    for (a, b) in a.iter().zip(b) {
        let (a, b) = (a / scale_a, b / scale_b);
        cross += a * b.conj();
        square_a += a.norm_sqr();
        square_b += b.norm_sqr();
    }
    cross.norm_sqr() / (square_a * square_b)
}
