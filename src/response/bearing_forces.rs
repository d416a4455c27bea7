//! Forces of the bearings on their shafts, over the frequency lines.
//!
//! A bearing's force is linear in the displacements, x = - F_m sum_r phi_r (phi_r . h) / (kappa_r (1 + j s zeta) - w^2 theta_r), so that with
//! its part in every mode known once a line costs a sum over the modes, as the mesh force itself does.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::deflection::amplitude;
use crate::design::Side;
use crate::model::{Model, Recovery, RecoveryKind, RotorModes};

/// What each bearing makes of each mode.
#[derive(Debug, Clone)]
pub struct BearingForces {
    /// How the displacements at the bearings follow from the model
    pub recovery: RecoveryKind,
    /// Rotor and name of each bearing, pinion first, in the design's order
    pub bearings: Vec<(Side, String)>,
    rotors: [Terms; 2],
}

/// One rotor's modes that the mesh excites.
#[derive(Debug, Clone)]
struct Terms {
    /// (kappa, theta) of each mode
    modes: Vec<(f64, f64)>,
    /// Six components of every bearing
    components: usize,
    /// (phi . h) times force per unit of the mode: stiffness and mass part, all components of a mode together
    parts: Vec<(f64, f64)>,
}

/// Force of one bearing on its shaft, one value a line.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingSpectrum {
    pub side: Side,
    pub name: String,
    /// fx, fy, fz (N), mx, my, mz (N m)
    pub force: Vec<[Complex64; 6]>,
}

impl BearingSpectrum {
    /// sqrt(|fx|^2 + |fz|^2) of every line, N.
    pub fn radial(&self) -> impl Iterator<Item = f64> {
        self.force.iter().map(|f| f[0].norm().hypot(f[2].norm()))
    }

    /// sqrt(|fx|^2 + |fy|^2 + |fz|^2) of every line, N.
    pub fn total(&self) -> impl Iterator<Item = f64> {
        self.force.iter().map(|f| f[0].norm().hypot(f[1].norm()).hypot(f[2].norm()))
    }
}

impl BearingForces {
    /// `modes` are those of both rotors without the mesh; no further factorisation is needed.
    pub fn new(model: &Model, modes: &[RotorModes; 2], recovery: &[Recovery; 2]) -> Self {
        let terms = |rotor: usize| {
            let (modes, recovery) = (&modes[rotor], &recovery[rotor]);
            let participation = modes.participation(&model.rotors()[rotor].mesh_vector);
            let excited: Vec<usize> = (0..participation.len()).filter(|&r| participation[r] != 0.0).collect();
            let shapes = modes.shapes.select_columns(&excited);
            let forces = recovery.bearings().iter().map(|b| (&b.stiffness * &shapes, &b.mass * &shapes));
            let forces: Vec<_> = forces.collect();
            let mut parts = Vec::with_capacity(excited.len() * 6 * forces.len());
            for (column, &r) in excited.iter().enumerate() {
                for (stiffness, mass) in &forces {
                    let g = participation[r];
                    parts.extend((0..6).map(|i| (g * stiffness[(i, column)], g * mass[(i, column)])));
                }
            }
            Terms {
                modes: excited.iter().map(|&r| (modes.stiffness[r], modes.mass[r])).collect(),
                components: 6 * forces.len(),
                parts,
            }
        };
        let names = Side::BOTH.into_iter().zip(recovery);
        let names = names.flat_map(|(side, recovery)| recovery.bearings().iter().map(move |b| (side, b.name.clone())));
        Self { recovery: recovery[0].kind, bearings: names.collect(), rotors: [terms(0), terms(1)] }
    }

    /// Forces of all bearings at `omega` (rad/s, greater than 0) under the mesh force (N) there, into `out`: six components a bearing.
    pub fn at(&self, omega: f64, structural_factor: Complex64, mesh_force: Complex64, out: &mut [Complex64]) {
        let omega_squared = omega * omega;
        out.fill(Complex64::ZERO);
        let mut rest = out;
        for terms in &self.rotors {
            let (own, others) = rest.split_at_mut(terms.components.min(rest.len()));
            for (&(kappa, theta), parts) in terms.modes.iter().zip(terms.parts.chunks(terms.components.max(1))) {
                let q = -mesh_force * amplitude(kappa, theta, omega_squared, structural_factor);
                for (force, &(stiffness, mass)) in own.iter_mut().zip(parts) {
                    *force += q * (structural_factor * stiffness - omega_squared * mass);
                }
            }
            rest = others;
        }
    }

    /// Forces on the given lines (Hz, greater than 0) under the mesh force (N) of each.
    pub fn spectra(&self, model: &Model, frequency_hz: &[f64], mesh_force: &[Complex64]) -> Vec<BearingSpectrum> {
        let empty = |(side, name): &(Side, String)| BearingSpectrum {
            side: *side,
            name: name.clone(),
            force: Vec::with_capacity(frequency_hz.len()),
        };
        let mut spectra: Vec<BearingSpectrum> = self.bearings.iter().map(empty).collect();
        let mut line = vec![Complex64::ZERO; 6 * spectra.len()];
        for (&frequency, &force) in frequency_hz.iter().zip(mesh_force) {
            let omega = TAU * frequency;
            self.at(omega, model.structural_factor(omega), force, &mut line);
            for (spectrum, components) in spectra.iter_mut().zip(line.chunks(6)) {
                spectrum.force.push(std::array::from_fn(|i| components[i]));
            }
        }
        spectra
    }
}
