//! Modes of one rotor of a model, with the side in the error.

use super::ResponseError;
use crate::design::Side;
use crate::model::{Model, RotorModel, RotorModes, natural_modes};

/// All modes of a rotor, in no particular order.
///
/// # Errors
///
/// Values that overflow, or lie too far apart to be factorised.
pub fn rotor_modes(rotor: &RotorModel, side: Side) -> Result<RotorModes, ResponseError> {
    for (matrix, what) in [(&rotor.stiffness, "stiffness"), (&rotor.mass, "mass")] {
        if !matrix.iter().all(|entry| entry.is_finite()) {
            return Err(ResponseError::NotFinite { side, what });
        }
    }
    natural_modes(&rotor.stiffness, &rotor.mass, &rotor.rotation()).ok_or(ResponseError::IllConditioned(side))
}

/// All modes of both rotors of a model without the mesh, pinion first.
///
/// # Errors
///
/// As [`rotor_modes`].
pub fn both_rotor_modes(model: &Model) -> Result<[RotorModes; 2], ResponseError> {
    Ok([rotor_modes(&model.pinion, Side::Pinion)?, rotor_modes(&model.gear, Side::Gear)?])
}
