//! How many modes a rotor a reduced model needs to be as good as finite elements.

use num_complex::Complex64;

use super::bands::{band_level_db, sixth_octave_bands};
use crate::design::{Design, Side};
use crate::model::{CraigBampton, Model, ModelKind, Rotors};
use crate::response::{Compliance, Spectrum};

/// Smallest number K of fixed-interface modes a rotor with which the level of every sixth-octave band (those of the agreement limit, all lines)
/// lies within `tolerance_db` of the finite element model's mesh force `fe` on the same lines (Hz).
///
/// `None` where no number is enough, all modes included, or where the matrices cannot be reduced to working precision. The modes of each rotor
/// are solved once.
pub fn reduced_modes_for(
    design: &Design,
    rotors: &Rotors,
    frequency_hz: &[f64],
    fe: &[Complex64],
    tolerance_db: f64,
) -> Option<usize> {
    let reduction = |side| CraigBampton::new(design, rotors.get(side), side).ok();
    let (pinion, gear) = (reduction(Side::Pinion)?, reduction(Side::Gear)?);
    let within = |modes: usize| -> Option<bool> {
        let kind = ModelKind::Reduced(modes);
        let model = Model::join(kind, design, pinion.keep(modes), gear.keep(modes));
        let compliance = Compliance::new(&model).ok()?;
        for band in sixth_octave_bands(frequency_hz) {
            // band by band: too few modes fail long before the last line
            let lines = &frequency_hz[band.lines.clone()];
            let mut spectrum = Spectrum::with_capacity(lines.len(), model.coordinates());
            spectrum.extend(&model, &compliance, lines).ok()?;
            let difference = band_level_db(&spectrum.mesh_force) - band_level_db(&fe[band.lines]);
            if difference.is_nan() || difference.abs() > tolerance_db {
                return Some(false);
            }
        }
        Some(true)
    };
    (0..=pinion.modes().max(gear.modes())).find(|&modes| within(modes) == Some(true))
}
