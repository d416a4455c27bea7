//! Modes of one rotor of a model, with the side in the error.

use std::ops::ControlFlow;

use super::ResponseError;
use crate::design::Side;
use crate::model::{Model, QrError, RotorModel, RotorModes, WorkDone, natural_modes_over};

/// All modes of a rotor, in no particular order.
///
/// # Errors
///
/// Values that overflow, or lie too far apart to be factorised.
pub fn rotor_modes(rotor: &RotorModel, side: Side) -> Result<RotorModes, ResponseError> {
    rotor_modes_over(rotor, side, &mut |_| ControlFlow::Continue(()))
}

/// As [`rotor_modes`]; `done` hears of the work between its steps, [`crate::model::modes_work`] in all.
///
/// # Errors
///
/// As [`rotor_modes`]; [`ResponseError::Cancelled`] where `done` breaks.
pub fn rotor_modes_over(rotor: &RotorModel, side: Side, done: &mut WorkDone<'_>) -> Result<RotorModes, ResponseError> {
    for (matrix, what) in [(&rotor.stiffness, "stiffness"), (&rotor.mass, "mass")] {
        if !matrix.iter().all(|entry| entry.is_finite()) {
            return Err(ResponseError::NotFinite { side, what });
        }
    }
    natural_modes_over(&rotor.stiffness, &rotor.mass, &rotor.rotation(), done).map_err(|error| match error {
        QrError::NotConverged => ResponseError::IllConditioned(side),
        QrError::Ended => ResponseError::Cancelled,
    })
}

/// All modes of both rotors of a model without the mesh, pinion first.
///
/// # Errors
///
/// As [`rotor_modes`].
pub fn both_rotor_modes(model: &Model) -> Result<[RotorModes; 2], ResponseError> {
    Ok([rotor_modes(&model.pinion, Side::Pinion)?, rotor_modes(&model.gear, Side::Gear)?])
}
