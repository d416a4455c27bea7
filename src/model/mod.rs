//! What can be solved: two rotors that only the mesh joins.
//!
//! The finite element model and both lumped models end up as the same small struct [`Model`]; damping, excitation and response are
//! written once for all of them.

mod caveat;
mod fe;
mod lumped;
mod mesh;

use nalgebra::{DMatrix, DVector};
use num_complex::Complex64;

pub use caveat::{Caveat, CaveatKind};
pub use lumped::LumpedMass;
pub use mesh::mesh_vector;

use crate::design::{DampingModel, Design, Side};
use crate::rotor::{Motion, Rotor, RotorError};

/// The models that are solved side by side.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ModelKind {
    /// Dynamic finite element model, section 2 of Hua et al. (2012)
    Fe,
    /// Lumped model with effective masses from the first bending modes, section 3.2
    Enhanced,
    /// Lumped model with the rotors' whole masses, "previous" in the paper
    Basic,
}

impl ModelKind {
    pub const ALL: [Self; 3] = [Self::Fe, Self::Enhanced, Self::Basic];

    /// Name on the command line and in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fe => "fe",
            Self::Enhanced => "enhanced",
            Self::Basic => "basic",
        }
    }

    /// Name in headings.
    pub fn title(self) -> &'static str {
        match self {
            Self::Fe => "Finite element model",
            Self::Enhanced => "Enhanced lumped model",
            Self::Basic => "Basic lumped model",
        }
    }
}

/// Where a coordinate of a rotor sits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Coordinate {
    pub place: Place,
    pub motion: Motion,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// Station number; the mesh station is the only one of a lumped model
    Station(usize),
    /// Engine or load
    Drive,
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
}

impl RotorModel {
    /// Free rotation of the whole rotor about its axis: 1 on every thy, and the one motion that K does not resist.
    pub fn rotation(&self) -> DVector<f64> {
        let turns = |coordinate: &Coordinate| f64::from(u8::from(coordinate.motion == Motion::ThY));
        DVector::from_iterator(self.coordinates.len(), self.coordinates.iter().map(turns))
    }

    /// Index of a motion of the mesh station.
    pub fn at_mesh(&self, motion: Motion) -> Option<usize> {
        let wanted = Coordinate { place: Place::Station(self.mesh_station), motion };
        self.coordinates.iter().position(|coordinate| *coordinate == wanted)
    }

    /// Index of the drive's coordinate.
    pub fn drive(&self) -> Option<usize> {
        self.coordinates.iter().position(|coordinate| coordinate.place == Place::Drive)
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
    pub fn new(kind: ModelKind, design: &Design, rotors: &Rotors) -> Self {
        let rotor = |side: Side| match (kind, side) {
            (ModelKind::Fe, _) => fe::rotor(design, rotors.get(side), side),
            (ModelKind::Enhanced, _) => lumped::rotor(design, rotors.get(side), side, LumpedMass::Enhanced),
            (ModelKind::Basic, _) => lumped::rotor(design, rotors.get(side), side, LumpedMass::Basic),
        };
        Self {
            kind,
            pinion: rotor(Side::Pinion),
            gear: rotor(Side::Gear),
            mesh_stiffness: design.mesh.stiffness,
            mesh_damping: design.mesh.damping,
            structural_damping: design.analysis.structural_damping,
            damping_model: design.analysis.damping_model,
            transmission_error: design.mesh.transmission_error,
        }
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
        match [&design.pinion, &design.gear].map(|rotor| Rotor::new(design, rotor)) {
            [Ok(pinion), Ok(gear)] => Ok(Self { pinion, gear }),
            [pinion, gear] => {
                let errors = [(Side::Pinion, pinion.err()), (Side::Gear, gear.err())];
                Err(RotorsError(errors.into_iter().filter_map(|(side, error)| Some((side, error?))).collect()))
            }
        }
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
