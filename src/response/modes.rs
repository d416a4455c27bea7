//! Natural modes with the mesh, undamped: (K_s + k_m h h^T) phi = lambda M phi.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use nalgebra::{DMatrix, DVector, DVectorView};

use super::uncoupled::{Mixer, Uncoupled};
use super::{ResponseError, both_rotor_modes, secular};
use crate::model::{Coordinate, Model, RotorModel, RotorModes, WorkDone};
use crate::rotor::Motion;

/// Shares of a mode's kinetic energy in the motions of one rotor: phi_i (M phi)_i over phi^T M phi. Of motions that the mass matrix
/// couples, such as lateral and tilt of a shaft, one can be below 0; their sum never is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct EnergyShare {
    /// x and z
    pub lateral: f64,
    /// y
    pub axial: f64,
    /// thx and thz: tilt of the lumped point, bending of the shaft
    pub tilt: f64,
    /// thy and the drive
    pub torsion: f64,
}

/// Modes whose shapes are found together.
const MODES_A_STEP: usize = 32;

/// Below this a mode is the rigid rotation, Hz.
const RIGID_HZ: f64 = 0.01;

/// One natural mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    pub frequency_hz: f64,
    pub pinion: EnergyShare,
    pub gear: EnergyShare,
    /// Shares of the kinetic energy in each motion of a rotor, pinion first, in the order of [`Motion::ALL`]; the drive turns with thy
    pub motions: [[f64; 6]; 2],
    /// Share of the strain energy that sits in the mesh: k_m (h . phi)^2 / lambda; 0 for the rigid rotation
    pub mesh_strain_share: f64,
    /// (h . phi)^2: how strongly the mesh drives the mode
    pub participation: f64,
    /// phi^T M phi = 1; the pinion's coordinates, then the gear's
    pub shape: DVector<f64>,
}

impl Mode {
    /// Whether it is the rigid rotation, whose frequency is 0 but for rounding.
    pub fn is_rigid(&self) -> bool {
        self.frequency_hz < RIGID_HZ
    }
}

/// The lowest modes of a model, ascending; the rigid rotation first.
#[derive(Debug, Clone, PartialEq)]
pub struct Modes(pub Vec<Mode>);

impl Modes {
    /// The `most` lowest modes, or all where there are fewer.
    ///
    /// # Errors
    ///
    /// As [`both_rotor_modes`], or a mode whose frequency or shape overflows.
    pub fn new(model: &Model, most: usize) -> Result<Self, ResponseError> {
        Self::with_rotor_modes(model, &both_rotor_modes(model)?, most)
    }

    /// As [`Modes::new`], from modes of both rotors without the mesh that are known.
    ///
    /// # Errors
    ///
    /// A mode whose frequency or shape overflows.
    pub fn with_rotor_modes(model: &Model, rotors: &[RotorModes; 2], most: usize) -> Result<Self, ResponseError> {
        Self::with_rotor_modes_over(model, rotors, most, &mut |_| ControlFlow::Continue(()))
    }

    /// As [`Modes::with_rotor_modes`]; `done` hears how far it is, from 0 to 1, every few modes.
    ///
    /// # Errors
    ///
    /// As [`Modes::with_rotor_modes`]; [`ResponseError::Cancelled`] where `done` breaks.
    pub fn with_rotor_modes_over(
        model: &Model,
        rotors: &[RotorModes; 2],
        most: usize,
        done: &mut WorkDone<'_>,
    ) -> Result<Self, ResponseError> {
        let uncoupled = Uncoupled::new(model, rotors);
        let found = secular::eigenvalues(&uncoupled.lambda, &uncoupled.g, model.mesh_stiffness);
        let count = found.len().min(most);
        let mixer = Mixer::new(&uncoupled);
        let kinetic = model.rotors().map(Kinetic::new);
        let mut modes = Vec::with_capacity(count);
        for some in found[..count].chunks(MODES_A_STEP) {
            if done(modes.len() as f64 / count as f64).is_break() {
                return Err(ResponseError::Cancelled);
            }
            for (eigenvalue, shape) in some.iter().zip(mixer.shapes(some).column_iter()) {
                modes.push(Mode::new(model, &kinetic, eigenvalue.value(&uncoupled.lambda), &shape.into_owned())?);
            }
        }
        Ok(Self(modes))
    }

    /// Their frequencies alone, Hz, ascending.
    pub fn frequencies(model: &Model, rotors: &[RotorModes; 2]) -> Vec<f64> {
        let Uncoupled { lambda, g, .. } = Uncoupled::new(model, rotors);
        let found = secular::eigenvalues(&lambda, &g, model.mesh_stiffness);
        found.iter().map(|eigenvalue| frequency_hz(eigenvalue.value(&lambda))).collect()
    }
}

fn frequency_hz(lambda: f64) -> f64 {
    lambda.max(0.0).sqrt() / TAU
}

impl Mode {
    /// With lambda (rad^2/s^2) and a shape of any scale.
    fn new(
        model: &Model,
        [pinion, gear]: &[Kinetic<'_>; 2],
        lambda: f64,
        shape: &DVector<f64>,
    ) -> Result<Self, ResponseError> {
        let frequency_hz = frequency_hz(lambda);
        let (top, bottom) = (model.pinion.coordinates.len(), model.gear.coordinates.len());
        let pinion = pinion.energies(&shape.rows(0, top).into_owned());
        let gear = gear.energies(&shape.rows(top, bottom).into_owned());
        let total: f64 = pinion.iter().chain(&gear).map(|(_, energy)| energy).sum();
        let motions = [&pinion, &gear].map(|energies| shares(energies, total));
        let shape = shape / total.sqrt();
        let h_p = model.pinion.mesh_vector.dot(&shape.rows(0, top));
        let h_g = model.gear.mesh_vector.dot(&shape.rows(top, bottom));
        let participation = (h_p + h_g).powi(2);
        // the rigid rotation does not strain anything, and what rounding leaves of it is no share
        let at_rest = frequency_hz < RIGID_HZ;
        let mesh_strain_share =
            if at_rest { 0.0 } else { (model.mesh_stiffness * participation / lambda).clamp(0.0, 1.0) };
        let [pinion, gear] = motions.map(EnergyShare::from);
        if !(frequency_hz.is_finite() && total > 0.0 && shape.iter().all(|entry| entry.is_finite())) {
            return Err(ResponseError::ModesNotFinite);
        }
        Ok(Self { frequency_hz, pinion, gear, motions, mesh_strain_share, participation, shape })
    }
}

/// Kinetic energy of one rotor; a reduced rotor's is that of the whole shaft that it stands for.
struct Kinetic<'a> {
    coordinates: &'a [Coordinate],
    basis: Option<&'a DMatrix<f64>>,
    /// Rows and entries of each column of M that are not zero: a station has mass in common with its neighbours only
    mass: Vec<Vec<(usize, f64)>>,
}

impl<'a> Kinetic<'a> {
    fn new(rotor: &'a RotorModel) -> Self {
        let reduction = rotor.reduction.as_deref();
        let RotorModel { mass, coordinates, .. } = reduction.map_or(rotor, |reduction| &reduction.full);
        let entries = |column: DVectorView<'_, f64>| {
            column.iter().copied().enumerate().filter(|(_, entry)| *entry != 0.0).collect()
        };
        Self {
            coordinates,
            basis: reduction.map(|reduction| &reduction.basis),
            mass: mass.column_iter().map(entries).collect(),
        }
    }

    /// phi_i (M phi)_i with the motion of each coordinate.
    fn energies(&self, shape: &DVector<f64>) -> Vec<(Motion, f64)> {
        let whole = self.basis.map(|basis| basis * shape);
        let shape = whole.as_ref().unwrap_or(shape);
        let mut momentum = vec![0.0; shape.len()];
        for (entries, value) in self.mass.iter().zip(shape.iter()) {
            for &(row, entry) in entries {
                momentum[row] += entry * value;
            }
        }
        let energies = shape.iter().zip(momentum).map(|(value, momentum)| value * momentum);
        self.coordinates
            .iter()
            .zip(energies)
            .filter_map(|(coordinate, energy)| Some((coordinate.motion()?, energy)))
            .collect()
    }
}

fn shares(energies: &[(Motion, f64)], total: f64) -> [f64; 6] {
    let mut out = [0.0; 6];
    for &(motion, energy) in energies {
        out[motion as usize] += energy / total;
    }
    out
}

impl From<[f64; 6]> for EnergyShare {
    fn from([x, y, z, thx, thy, thz]: [f64; 6]) -> Self {
        Self { lateral: x + z, axial: y, tilt: thx + thz, torsion: thy }
    }
}
