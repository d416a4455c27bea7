//! Where two spectra disagree: ranges of lines beyond a tolerance.

use num_complex::Complex64;

use super::difference_db;

/// Neighbouring lines on all of which two spectra differ by more than a tolerance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DisagreementBand {
    /// First and last line beyond the tolerance, Hz
    pub from_hz: f64,
    pub to_hz: f64,
    /// Largest difference, lumped over finite elements, with its sign
    pub worst_db: f64,
    /// Where it is
    pub worst_at_hz: f64,
}

/// All of them, ascending; lines in Hz, forces in N, tolerance in dB.
pub fn disagreement_bands(
    frequency_hz: &[f64],
    lumped: &[Complex64],
    fe: &[Complex64],
    tolerance_db: f64,
) -> Vec<DisagreementBand> {
    let mut bands: Vec<DisagreementBand> = Vec::new();
    let mut open = false;
    for (&f, d) in frequency_hz.iter().zip(difference_db(lumped, fe)) {
        let beyond = d.abs() > tolerance_db;
        match bands.last_mut() {
            Some(band) if beyond && open => {
                band.to_hz = f;
                if d.abs() > band.worst_db.abs() {
                    (band.worst_db, band.worst_at_hz) = (d, f);
                }
            }
            _ if beyond => bands.push(DisagreementBand { from_hz: f, to_hz: f, worst_db: d, worst_at_hz: f }),
            _ => {}
        }
        open = beyond;
    }
    bands
}
