//! How well a lumped model agrees with the finite element model: differences, sixth-octave levels, peaks and modes.

mod bands;
mod causes;
mod differences;
mod disagreement;
mod modal;
mod pairing;
mod parts;
mod peaks;
mod reduction;

use num_complex::Complex64;

pub use bands::{Band, agreement_limit, band_level_db, sixth_octave_bands};
pub use causes::{Causes, LEAST_PARTICIPATION, PlaneFigures, RotorPlane, Shift, Unpaired};
pub use differences::{difference_db, frac};
pub use disagreement::{DisagreementBand, disagreement_bands};
pub use modal::{COMPARED_FE_MODES, ModalComparison, ModalError, Responsible};
pub use pairing::{LEAST_MAC, ModePair, mac_matrix, pair_modes};
pub use parts::{Part, Parts};
pub use peaks::{FARTHEST_PEAK, LEAST_PROMINENCE_DB, Peak, PeakPair, highest_peak, pair_peaks, peaks};
pub use reduction::reduced_modes_for;

/// A difference beyond which two levels disagree, where nothing else is asked for, dB.
pub const TOLERANCE_DB: f64 = 3.0;

/// How far the sixth-octave levels may differ for the agreement limit, dB.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    pub band_level_db: f64,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self { band_level_db: TOLERANCE_DB }
    }
}

/// Agreement of one lumped model with the finite element model, over a band of the analysis lines.
#[derive(Debug, Clone, PartialEq)]
pub struct Agreement {
    /// RMS of the difference in dB over the band
    pub rms_db: f64,
    /// Largest |difference| in dB over the band
    pub max_db: f64,
    /// Where it is
    pub max_at_hz: f64,
    /// Frequency response assurance criterion over the band, 0 to 1
    pub frac: f64,
    /// Up to where the sixth-octave levels differ by no more than the tolerance, over all lines; 0 if nowhere
    pub agreement_limit_hz: f64,
    /// By frequency, pairs and peaks without partner
    pub peaks: Vec<PeakPair>,
}

/// Why two spectra cannot be compared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum AgreementError {
    #[error("no frequency line lies in the band {low} to {high} Hz")]
    EmptyBand { low: f64, high: f64 },
}

impl Agreement {
    /// Compares two mesh force spectra on the same lines (Hz, ascending; forces in N, finite and not zero).
    ///
    /// The band (Hz, both ends included; all lines where `None`) restricts all figures but the agreement limit.
    ///
    /// # Errors
    ///
    /// [`AgreementError::EmptyBand`] where the band holds no line.
    pub fn new(
        frequency_hz: &[f64],
        lumped: &[Complex64],
        fe: &[Complex64],
        band: Option<[f64; 2]>,
        tolerance: Tolerance,
    ) -> Result<Self, AgreementError> {
        let [low, high] = band.unwrap_or([0.0, f64::INFINITY]);
        let from = frequency_hz.partition_point(|f| *f < low);
        let to = frequency_hz.partition_point(|f| *f <= high);
        if from >= to {
            return Err(AgreementError::EmptyBand { low, high });
        }
        let (lines, in_band, fe_in_band) = (&frequency_hz[from..to], &lumped[from..to], &fe[from..to]);
        let differences = difference_db(in_band, fe_in_band);
        let mean_square = differences.iter().map(|d| d * d).sum::<f64>() / differences.len() as f64;
        let mut worst = 0;
        for (i, difference) in differences.iter().enumerate() {
            if difference.abs() > differences[worst].abs() {
                worst = i;
            }
        }
        Ok(Self {
            rms_db: mean_square.sqrt(),
            max_db: differences[worst].abs(),
            max_at_hz: lines[worst],
            frac: frac(in_band, fe_in_band),
            agreement_limit_hz: agreement_limit(frequency_hz, lumped, fe, tolerance),
            peaks: pair_peaks(&peaks(lines, in_band), &peaks(lines, fe_in_band)),
        })
    }
}
