//! How a model responds: natural modes, the exact shortcut to the mesh force, and the direct solve it is held against.

mod compliance;
mod direct;
mod eigen;
mod modes;
mod secular;
mod spectrum;
mod tridiagonal;

pub use compliance::Compliance;
pub use direct::direct_spectrum;
pub use eigen::{RotorModes, WorkDone, modes_work, rotor_modes, rotor_modes_over};
pub use modes::{EnergyShare, Mode, Modes};
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
