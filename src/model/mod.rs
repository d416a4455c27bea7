//! What can be solved: two rotors that only the mesh joins.
//!
//! The finite element model and both lumped models end up as the same small struct [`Model`]; damping, excitation and response are
//! written once for all of them.

mod caveat;
mod eigen;
mod fe;
mod kind;
mod lumped;
mod recovery;
mod reduced;
mod tridiagonal;

use std::ops::ControlFlow;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

pub use crate::rotor::{mesh_frequency_hz, mesh_vector, pinion_speed_rpm};
pub use caveat::{Caveat, CaveatKind};
pub use eigen::{RotorModes, WorkDone, modes_work, natural_modes, natural_modes_over};
pub use kind::{ModelKind, UnknownModel};
pub use lumped::LumpedMass;
pub use recovery::{Bearing, Recovery, RecoveryKind};
pub use reduced::CraigBampton;
pub use tridiagonal::QrError;

use crate::design::{DampingModel, Design, Side};
use crate::rotor::{Motion, Rotor, RotorError};

/// What a coordinate of a rotor measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coordinate {
    /// Motion of a station, by its number; the mesh station is the only one of a lumped model
    Station(usize, Motion),
    /// Rotation of engine or load, where there is one
    Drive,
    /// Amplitude of a mode of the rotor with mesh station and drive held, by its number from the lowest
    FixedInterfaceMode(usize),
}

impl Coordinate {
    /// The motion, where the coordinate is one.
    pub fn motion(self) -> Option<Motion> {
        match self {
            Self::Station(_, motion) => Some(motion),
            Self::Drive => Some(Motion::ThY),
            Self::FixedInterfaceMode(_) => None,
        }
    }
}

/// Where a reduced rotor comes from.
#[derive(Debug, Clone)]
pub struct Reduction {
    /// The finite element rotor
    pub full: Arc<RotorModel>,
    /// Displacements of its coordinates for a unit of each reduced one
    pub basis: DMatrix<f64>,
}

/// Why a model cannot be built.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ModelError {
    #[error(
        "{} shaft: the matrices cannot be reduced to the mesh station: values lie too many orders of magnitude apart",
        .0.name()
    )]
    IllConditioned(Side),
    #[error("cancelled")]
    Cancelled,
}

/// One rotor of a model without the mesh: K, M and the mesh vector over its free coordinates.
#[derive(Debug, Clone)]
pub struct RotorModel {
    /// N/m, N, N m/rad
    pub stiffness: DMatrix<f64>,
    /// kg, kg m, kg m^2
    pub mass: DMatrix<f64>,
    /// h of the mesh spring on this rotor with its sign: + on the pinion, - on the gear (8)
    pub mesh_vector: DVector<f64>,
    pub coordinates: Vec<Coordinate>,
    /// Station of the mesh
    pub mesh_station: usize,
    /// The rotor that this one is reduced from, and how; `None` where its coordinates are motions
    pub reduction: Option<Box<Reduction>>,
}

impl RotorModel {
    /// Free rotation of the whole rotor about its axis: 1 on every thy, and the one motion that K does not resist.
    pub fn rotation(&self) -> DVector<f64> {
        let turns = |coordinate: &Coordinate| f64::from(u8::from(coordinate.motion() == Some(Motion::ThY)));
        DVector::from_iterator(self.coordinates.len(), self.coordinates.iter().map(turns))
    }

    /// Index of a motion of the mesh station.
    pub fn at_mesh(&self, motion: Motion) -> Option<usize> {
        let wanted = Coordinate::Station(self.mesh_station, motion);
        self.coordinates.iter().position(|coordinate| *coordinate == wanted)
    }

    /// Index of the drive's coordinate.
    pub fn drive(&self) -> Option<usize> {
        self.coordinates.iter().position(|coordinate| *coordinate == Coordinate::Drive)
    }
}

/// Everything that is solved: two rotors, the mesh spring between them, damping and excitation.
#[derive(Debug, Clone)]
pub struct Model {
    pub kind: ModelKind,
    pub pinion: RotorModel,
    pub gear: RotorModel,
    /// k_m, N/m
    pub mesh_stiffness: f64,
    /// zeta_m
    pub mesh_damping: f64,
    /// zeta_s
    pub structural_damping: f64,
    pub damping_model: DampingModel,
    /// e, m
    pub transmission_error: f64,
}

impl Model {
    /// Builds one of the models from the two solved rotors.
    ///
    /// # Errors
    ///
    /// [`ModelError`] where a reduced model's rotor cannot be factorised; the others always exist.
    pub fn new(kind: ModelKind, design: &Design, rotors: &Rotors) -> Result<Self, ModelError> {
        Self::new_over(kind, design, rotors, &mut |_| ControlFlow::Continue(()))
    }

    /// As [`Model::new`]; `done` hears of the work for a reduced model between its steps, and may end it.
    ///
    /// # Errors
    ///
    /// As [`Model::new`]; [`ModelError::Cancelled`] where `done` breaks.
    pub fn new_over(
        kind: ModelKind,
        design: &Design,
        rotors: &Rotors,
        done: &mut WorkDone<'_>,
    ) -> Result<Self, ModelError> {
        let mut rotor = |side: Side| match kind {
            ModelKind::Fe => Ok(fe::rotor(design, rotors.get(side), side)),
            ModelKind::Enhanced => Ok(lumped::rotor(design, rotors.get(side), side, LumpedMass::Enhanced)),
            ModelKind::Basic => Ok(lumped::rotor(design, rotors.get(side), side, LumpedMass::Basic)),
            ModelKind::Reduced(modes) => Ok(CraigBampton::new_over(design, rotors.get(side), side, done)?.keep(modes)),
        };
        Ok(Self::join(kind, design, rotor(Side::Pinion)?, rotor(Side::Gear)?))
    }

    /// Two rotors of one kind on the mesh of a design.
    pub fn join(kind: ModelKind, design: &Design, pinion: RotorModel, gear: RotorModel) -> Self {
        Self {
            kind,
            pinion,
            gear,
            mesh_stiffness: design.mesh.stiffness,
            mesh_damping: design.mesh.damping,
            structural_damping: design.analysis.structural_damping,
            damping_model: design.analysis.damping_model,
            transmission_error: design.mesh.transmission_error,
        }
    }

    /// How the whole shafts, pinion first, follow from the coordinates of this model of the design.
    ///
    /// # Errors
    ///
    /// As [`Recovery::new`].
    pub fn recovery(&self, design: &Design, rotors: &Rotors) -> Result<[Recovery; 2], ModelError> {
        let of = |side: Side, model: &RotorModel| Recovery::new(self.kind, design, rotors.get(side), side, model);
        Ok([of(Side::Pinion, &self.pinion)?, of(Side::Gear, &self.gear)?])
    }

    pub fn rotors(&self) -> [&RotorModel; 2] {
        [&self.pinion, &self.gear]
    }

    /// Number of coordinates of both rotors.
    pub fn coordinates(&self) -> usize {
        self.pinion.coordinates.len() + self.gear.coordinates.len()
    }

    /// The factor (1 + j s zeta_s) on the structural stiffness at `omega` (rad/s), eqs. 11-14.
    pub fn structural_factor(&self, omega: f64) -> Complex64 {
        Complex64::new(1.0, self.damping_scale(omega) * self.structural_damping)
    }

    /// Complex mesh stiffness k_m (1 + j s zeta_m), N/m.
    pub fn complex_mesh_stiffness(&self, omega: f64) -> Complex64 {
        self.mesh_stiffness * Complex64::new(1.0, self.damping_scale(omega) * self.mesh_damping)
    }

    fn damping_scale(&self, omega: f64) -> f64 {
        match self.damping_model {
            DampingModel::Hysteretic => 1.0,
            DampingModel::Viscous => omega,
        }
    }
}

/// Both rotors of a design, built and held.
#[derive(Debug, Clone)]
pub struct Rotors {
    pub pinion: Rotor,
    pub gear: Rotor,
}

/// What is wrong with one rotor, or with both.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{}", sentences(.0))]
pub struct RotorsError(pub Vec<(Side, RotorError)>);

fn sentences(errors: &[(Side, RotorError)]) -> String {
    if let [(_, pinion), (_, gear)] = errors
        && pinion == gear
    {
        return format!("both shafts: {pinion}");
    }
    let sentence = |(side, error): &(Side, RotorError)| format!("{} shaft: {error}", side.name());
    errors.iter().map(sentence).collect::<Vec<_>>().join("; ")
}

impl Rotors {
    /// # Errors
    ///
    /// [`RotorsError`] names each rotor that cannot be built or is not held.
    pub fn new(design: &Design) -> Result<Self, RotorsError> {
        Self::reusing(design, None)
    }

    /// As [`new`](Self::new); mean states of bearings are taken over from earlier rotors where nothing that they depend on differs.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn reusing(design: &Design, earlier: Option<&Self>) -> Result<Self, RotorsError> {
        let build = |side| Rotor::reusing(design, side, earlier.map(|rotors| &rotors.get(side).mean_states));
        match Side::BOTH.map(build) {
            [Ok(pinion), Ok(gear)] => Ok(Self { pinion, gear }),
            [pinion, gear] => {
                let errors = [(Side::Pinion, pinion.err()), (Side::Gear, gear.err())];
                Err(RotorsError(errors.into_iter().filter_map(|(side, error)| Some((side, error?))).collect()))
            }
        }
    }

    /// What is unusual about the mean states of the bearings, a line each: `pinion.bearing[0]: "B1" in its mean state: ...`. Names are as the
    /// design has them.
    pub fn mean_state_warnings(&self, design: &Design) -> Vec<String> {
        let of = |side: Side| {
            self.get(side).mean_states.warnings().map(move |(place, warning)| {
                let name = &design.rotor(side).bearings[place].name;
                format!("{}.bearing[{place}]: \"{name}\" in its mean state: {warning}", side.name())
            })
        };
        Side::BOTH.into_iter().flat_map(of).collect()
    }

    /// What the enhanced model rests on besides the first bending modes.
    pub fn caveats(&self) -> Vec<Caveat> {
        caveat::of(self)
    }

    pub fn get(&self, side: Side) -> &Rotor {
        match side {
            Side::Pinion => &self.pinion,
            Side::Gear => &self.gear,
        }
    }
}
