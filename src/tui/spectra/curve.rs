//! One quantity of one model, made ready for drawing.

use num_complex::Complex64;

use super::quantity::Quantity;
use crate::agreement::{band_level_db, sixth_octave_bands};
use crate::tui::traces::levels;

/// Values over the frequency lines.
#[derive(Debug)]
pub struct Curve {
    pub quantity: Quantity,
    /// On the lines of the analysis, in the quantity's unit
    pub lines: Vec<Complex64>,
    /// Levels on the lines that are drawn, dB re 1 unit
    pub drawn_db: Vec<f64>,
    /// Sixth-octave bands of the analysis lines: edges in Hz, level in dB re 1 unit
    pub bands: Vec<(f64, f64, f64)>,
}

impl Curve {
    pub fn new(quantity: Quantity, lines: Vec<Complex64>, drawn: &[Complex64], frequency_hz: &[f64]) -> Self {
        let bands = sixth_octave_bands(frequency_hz).into_iter();
        let bands = bands.map(|band| (band.low_hz, band.high_hz, band_level_db(&lines[band.lines]))).collect();
        Self { quantity, drawn_db: levels(drawn), lines, bands }
    }
}
