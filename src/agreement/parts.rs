//! The part of each mode in what is looked at: the mesh force, or the force of a bearing.

use nalgebra::DVector;
use num_complex::Complex64;

use super::ModalComparison;
use crate::design::{Design, Side};
use crate::model::{Model, ModelError, Recovery, Rotors};
use crate::response::{Mode, Modes};

/// What is looked at, as linear in the modes' amplitudes.
///
/// x = k_m* e sum_r phi_r (phi_r . h) / (lambda_r (1 + j eta_r) - w^2), so mode r gives R phi_r (phi_r . h) over that, where R is what is looked
/// at for a displacement x. R x = h . x is the dynamic transmission error, and F_m = k_m* (h . x - e): both models have the same k_m*, so the
/// same modes make them differ in either.
#[derive(Debug, Clone)]
pub struct Parts {
    /// Of each mode of finite elements
    pub fe: Vec<Vec<Part>>,
    /// Of each lumped one
    pub lumped: Vec<Vec<Part>>,
}

/// R phi (phi . h) of one component: `constant` + `stiffness` x (1 + j s zeta) - w^2 `mass`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Part {
    pub constant: f64,
    pub stiffness: f64,
    pub mass: f64,
}

impl Part {
    /// At `omega` (rad/s).
    pub fn at(&self, omega: f64, structural_factor: Complex64) -> Complex64 {
        structural_factor * self.stiffness + (self.constant - omega * omega * self.mass)
    }
}

impl Parts {
    /// In mesh force and transmission error: (phi . h)^2.
    pub fn of_mesh(modes: &ModalComparison) -> Self {
        let parts = |modes: &Modes| {
            let part = |mode: &Mode| vec![Part { constant: mode.participation, ..Part::default() }];
            modes.0.iter().map(part).collect()
        };
        Self { fe: parts(&modes.fe), lumped: parts(&modes.lumped) }
    }

    /// In components (0 to 5: fx, fy, fz, mx, my, mz) of the force of a bearing on its shaft, counted on that shaft.
    ///
    /// # Errors
    ///
    /// [`ModelError`] where the static shapes of a lumped model's shaft cannot be solved.
    pub fn of_bearing(
        modes: &ModalComparison,
        design: &Design,
        rotors: &Rotors,
        (side, bearing): (Side, usize),
        components: &[usize],
    ) -> Result<Self, ModelError> {
        let parts = |model: &Model, modes: &Modes| -> Result<Vec<Vec<Part>>, ModelError> {
            let own = model.rotors()[side as usize];
            let recovery = Recovery::new(model.kind, design, rotors.get(side), side, own)?;
            let Some(bearing) = recovery.bearings().get(bearing) else { return Ok(vec![Vec::new(); modes.0.len()]) };
            let top = model.pinion.coordinates.len();
            let part = |mode: &Mode| {
                let [pinion, gear] = split(mode, top);
                let driven = model.pinion.mesh_vector.dot(&pinion) + model.gear.mesh_vector.dot(&gear);
                let shape = if side == Side::Pinion { pinion } else { gear };
                let (stiffness, mass) = (&bearing.stiffness * &shape, &bearing.mass * &shape);
                let component =
                    |&i: &usize| Part { constant: 0.0, stiffness: driven * stiffness[i], mass: driven * mass[i] };
                components.iter().map(component).collect()
            };
            Ok(modes.0.iter().map(part).collect())
        };
        Ok(Self { fe: parts(&modes.fe_model, &modes.fe)?, lumped: parts(&modes.lumped_model, &modes.lumped)? })
    }
}

/// Coordinates of the pinion, of which there are `top`, and of the gear.
fn split(mode: &Mode, top: usize) -> [DVector<f64>; 2] {
    [mode.shape.rows(0, top).into_owned(), mode.shape.rows(top, mode.shape.len() - top).into_owned()]
}
