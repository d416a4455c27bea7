//! How a model responds: natural modes, the exact shortcut to the mesh force, and the direct solve it is held against.

mod bearing_forces;
mod character;
mod compliance;
mod deflection;
mod direct;
mod modes;
mod refined;
mod rotor_modes;
mod secular;
mod solved;
mod spectrum;
mod uncoupled;

pub use bearing_forces::{BearingForces, BearingSpectrum};
pub use character::{Dominant, MotionGroup};
pub use compliance::Compliance;
pub use deflection::{StationShape, mode_shape, operating_deflection};
pub use direct::direct_spectrum;
pub use modes::{EnergyShare, Mode, Modes};
pub use refined::refined_lines;
pub use rotor_modes::{both_rotor_modes, rotor_modes, rotor_modes_over};
pub use solved::Solved;
pub use spectrum::{Spectrum, frequency_lines};

use crate::design::Side;

/// Why a model has no response.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ResponseError {
    #[error("{} shaft: the {what} is too large or too small to compute with", side.name())]
    NotFinite { side: Side, what: &'static str },
    #[error("{} shaft: the mass matrix or the stiffness cannot be factorised: values lie too many orders of magnitude apart", .0.name())]
    IllConditioned(Side),
    #[error("the natural modes with the mesh are too large or too small to compute with")]
    ModesNotFinite,
    #[error("the {what} is too large or too small to compute with at {at_hz:?} Hz")]
    LineNotFinite { what: &'static str, at_hz: f64 },
    #[error("cancelled")]
    Cancelled,
}
