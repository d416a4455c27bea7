//! Natural modes with the mesh, undamped: (K_s + k_m h h^T) phi = lambda M phi.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use nalgebra::{DMatrix, DVector};

use super::secular::{self, Eigenvalue};
use super::{ResponseError, both_rotor_modes};
use crate::model::{Model, RotorModel, RotorModes, WorkDone};
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

    /// As [`Modes::with_rotor_modes`]; `done` hears of each mode, from 0 to 1.
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
        let mut uncoupled = Uncoupled::new(model, rotors);
        uncoupled.join_equal();
        uncoupled.drop_uncoupled(model.mesh_stiffness);
        let Uncoupled { lambda, g, shapes } = &uncoupled;
        let found = secular::eigenvalues(lambda, g, model.mesh_stiffness);
        let mode = |eigenvalue: &Eigenvalue| -> Result<Mode, ResponseError> {
            let shape = match *eigenvalue {
                Eigenvalue::Kept(i) => shapes.column(i).into_owned(),
                Eigenvalue::Moved { origin, offset } => {
                    let weight =
                        |r: usize| if g[r] == 0.0 { 0.0 } else { g[r] / ((lambda[r] - lambda[origin]) - offset) };
                    let weights = DVector::from_fn(lambda.len(), |r, _| weight(r));
                    shapes * weights.normalize()
                }
            };
            let frequency_hz = eigenvalue.value(lambda).max(0.0).sqrt() / TAU;
            let (top, bottom) = (model.pinion.coordinates.len(), model.gear.coordinates.len());
            let pinion = energies(&model.pinion, &shape.rows(0, top).into_owned());
            let gear = energies(&model.gear, &shape.rows(top, bottom).into_owned());
            let total: f64 = pinion.iter().chain(&gear).map(|(_, energy)| energy).sum();
            let motions = [&pinion, &gear].map(|energies| shares(energies, total));
            let shape = shape / total.sqrt();
            let h_p = model.pinion.mesh_vector.dot(&shape.rows(0, top));
            let h_g = model.gear.mesh_vector.dot(&shape.rows(top, bottom));
            let participation = (h_p + h_g).powi(2);
            let lambda = eigenvalue.value(lambda);
            // the rigid rotation does not strain anything, and what rounding leaves of it is no share
            let at_rest = frequency_hz < RIGID_HZ;
            let mesh_strain_share =
                if at_rest { 0.0 } else { (model.mesh_stiffness * participation / lambda).clamp(0.0, 1.0) };
            let [pinion, gear] = motions.map(EnergyShare::from);
            let mode = Mode { frequency_hz, pinion, gear, motions, mesh_strain_share, participation, shape };
            if frequency_hz.is_finite() && total > 0.0 && mode.shape.iter().all(|entry| entry.is_finite()) {
                Ok(mode)
            } else {
                Err(ResponseError::ModesNotFinite)
            }
        };
        let count = found.len().min(most);
        let mut modes = Vec::with_capacity(count);
        for (i, eigenvalue) in found.iter().take(count).enumerate() {
            if done(i as f64 / count as f64).is_break() {
                return Err(ResponseError::Cancelled);
            }
            modes.push(mode(eigenvalue)?);
        }
        Ok(Self(modes))
    }
}

/// Kinetic energy phi_i (M phi)_i of each motion of a rotor; a reduced rotor's are those of the whole shaft that it stands for.
fn energies(rotor: &RotorModel, shape: &DVector<f64>) -> Vec<(Motion, f64)> {
    if let Some(reduction) = &rotor.reduction {
        return energies(&reduction.full, &(&reduction.basis * shape));
    }
    let products = shape.component_mul(&(&rotor.mass * shape));
    let motions = rotor.coordinates.iter().zip(products.iter());
    motions.filter_map(|(coordinate, energy)| Some((coordinate.motion()?, *energy))).collect()
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

/// Mass-normalised modes of both rotors without the mesh, ascending.
struct Uncoupled {
    lambda: Vec<f64>,
    /// phi . h
    g: Vec<f64>,
    /// One column a mode
    shapes: DMatrix<f64>,
}

impl Uncoupled {
    fn new(model: &Model, rotors: &[RotorModes; 2]) -> Self {
        let n = model.coordinates();
        let mut columns: Vec<(f64, f64, DVector<f64>)> = Vec::with_capacity(n);
        let mut at = 0;
        for (modes, rotor) in rotors.iter().zip(model.rotors()) {
            let g = modes.participation(&rotor.mesh_vector);
            for (r, (&kappa, &theta)) in modes.stiffness.iter().zip(&modes.mass).enumerate() {
                // no mass, no frequency
                if theta <= 0.0 {
                    continue;
                }
                let scale = 1.0 / theta.sqrt();
                let mut shape = DVector::zeros(n);
                shape.rows_mut(at, rotor.coordinates.len()).axpy(scale, &modes.shapes.column(r), 0.0);
                columns.push((kappa / theta, g[r] * scale, shape));
            }
            at += rotor.coordinates.len();
        }
        columns.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut shapes = DMatrix::zeros(n, columns.len());
        for (target, column) in columns.iter().enumerate() {
            shapes.set_column(target, &column.2);
        }
        Self {
            lambda: columns.iter().map(|column| column.0).collect(),
            g: columns.iter().map(|column| column.1).collect(),
            shapes,
        }
    }

    /// Of modes with one frequency (both planes of an isotropic shaft, both free rotations) any mixture is a mode: all of the mesh's grip goes to
    /// one of them, and the others stay as they are.
    fn join_equal(&mut self) {
        const EQUAL: f64 = 1e-13;
        /// rad^2/s^2: what rounding leaves of a frequency of a few hertz
        const FLOOR: f64 = 1e7;
        let mut gripped: Option<usize> = None;
        for i in 0..self.lambda.len() {
            if self.g[i] == 0.0 {
                continue;
            }
            let equal = |j: &usize| self.lambda[i] - self.lambda[*j] <= EQUAL * (self.lambda[i] + FLOOR);
            if let Some(j) = gripped.filter(equal) {
                let (a, b) = (self.g[i], self.g[j]);
                let length = a.hypot(b);
                let (first, second) = (self.shapes.column(i).into_owned(), self.shapes.column(j).into_owned());
                self.shapes.set_column(i, &((&first * a + &second * b) / length));
                self.shapes.set_column(j, &((&second * a - &first * b) / length));
                self.g[i] = length;
                self.g[j] = 0.0;
            }
            gripped = Some(i);
        }
    }

    /// Modes that the mesh cannot feel stay as they are.
    ///
    /// Judged by what the spring mixes into their shape, k g_i g_j / lambda_i: their frequency moves by the square of that only.
    fn drop_uncoupled(&mut self, mesh_stiffness: f64) {
        let all = self.g.iter().map(|g| g * g).sum::<f64>().sqrt();
        for (g, lambda) in self.g.iter_mut().zip(&self.lambda) {
            if mesh_stiffness * g.abs() * all <= f64::EPSILON * lambda {
                *g = 0.0;
            }
        }
    }
}
