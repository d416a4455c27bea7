//! The modes of the three models with their shapes and partners: all that the screen of the modes shows.

use std::ops::ControlFlow;

use nalgebra::DMatrix;
use num_complex::Complex64;

use crate::agreement::{COMPARED_FE_MODES, ModePair, mac_matrix, pair_modes};
use crate::comparison::SolveError;
use crate::design::{Design, Side};
use crate::model::{Model, ModelKind, Recovery, RotorModes, Rotors};
use crate::response::{
    Compliance, Modes, ResponseError, Spectrum, StationShape, mode_shape, operating_deflection, rotor_modes_over,
};

/// Modes of the finite element, the enhanced and the basic model of a design.
#[derive(Debug, Clone)]
pub struct Study {
    pub design: Design,
    /// Of its file, or of what that would be if it were saved; nothing where there is none
    pub hash: Option<String>,
    pub fe: ModelStudy,
    /// Enhanced, basic
    pub lumped: [ModelStudy; 2],
    /// Of each lumped model with finite elements
    pub pairs: [Vec<ModePair>; 2],
    /// Of each lumped model, a row a mode, a column a finite element mode
    pub mac: [DMatrix<f64>; 2],
}

/// One model's modes.
#[derive(Debug, Clone)]
pub struct ModelStudy {
    /// The lowest; of finite elements no more than are compared
    pub modes: Modes,
    /// At the stations of both shafts, pinion first, phi^T M phi = 1 kg m^2
    pub shapes: Vec<[StationShape<f64>; 2]>,
    model: Model,
    rotor_modes: [RotorModes; 2],
    recovery: [Recovery; 2],
}

/// Operating deflection shapes at one frequency, m and rad.
#[derive(Debug, Clone, PartialEq)]
pub struct DeflectionShapes {
    pub at_hz: f64,
    /// Dynamic mesh force of finite elements, N
    pub fe_force: f64,
    pub fe: [StationShape<Complex64>; 2],
    /// Enhanced, basic
    pub lumped: [[StationShape<Complex64>; 2]; 2],
}

impl Study {
    /// Solves all three models; ends with [`SolveError::Cancelled`] as soon as `wanted` says no.
    ///
    /// # Errors
    ///
    /// [`SolveError`] says why there are no modes.
    pub fn new(design: &Design, wanted: &dyn Fn() -> bool) -> Result<Self, SolveError> {
        let rotors = Rotors::new(design)?;
        let solved = |kind| ModelStudy::new(kind, design, &rotors, wanted);
        let mut fe = solved(ModelKind::Fe)?;
        let mut lumped = [solved(ModelKind::Enhanced)?, solved(ModelKind::Basic)?];
        let enhanced = lumped[0].model.clone();
        let with_fe = |one: &ModelStudy| {
            (pair_modes(one.both(), fe.both(), &enhanced), mac_matrix(one.both(), fe.both(), &enhanced))
        };
        let [(enhanced_pairs, enhanced_mac), (basic_pairs, basic_mac)] = lumped.each_ref().map(with_fe);
        fe.shapes.iter_mut().filter(|shape| largest_entry(shape) < 0.0).for_each(turn);
        let pairs = [enhanced_pairs, basic_pairs];
        for (one, pairs) in lumped.iter_mut().zip(&pairs) {
            for (at, shape) in one.shapes.iter_mut().enumerate() {
                let partner = pairs.iter().find(|pair| pair.lumped == at).map(|pair| &fe.shapes[pair.fe]);
                // a shape and its negative are the same mode: partners are drawn to the same side
                let is_turned = partner.map_or_else(|| largest_entry(shape) < 0.0, |fe| likeness(shape, fe) < 0.0);
                if is_turned {
                    turn(shape);
                }
            }
        }
        Ok(Self { design: design.clone(), hash: None, fe, lumped, pairs, mac: [enhanced_mac, basic_mac] })
    }

    /// Displacements under the mesh force at `at_hz` (Hz, greater than 0).
    ///
    /// # Errors
    ///
    /// A mesh force that overflows there.
    pub fn deflection(&self, at_hz: f64) -> Result<DeflectionShapes, SolveError> {
        let (fe_force, fe) = self.fe.deflection(at_hz)?;
        let [(_, enhanced), (_, basic)] = [self.lumped[0].deflection(at_hz)?, self.lumped[1].deflection(at_hz)?];
        Ok(DeflectionShapes { at_hz, fe_force: fe_force.norm(), fe, lumped: [enhanced, basic] })
    }
}

impl ModelStudy {
    fn new(kind: ModelKind, design: &Design, rotors: &Rotors, wanted: &dyn Fn() -> bool) -> Result<Self, SolveError> {
        let failed = |error| match error {
            ResponseError::Cancelled => SolveError::Cancelled,
            error => SolveError::Response { kind, error },
        };
        let mut done = |_| if wanted() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
        let model = Model::new(kind, design, rotors)?;
        if done(0.0).is_break() {
            return Err(SolveError::Cancelled);
        }
        let pinion = rotor_modes_over(&model.pinion, Side::Pinion, &mut done).map_err(failed)?;
        let rotor_modes = [pinion, rotor_modes_over(&model.gear, Side::Gear, &mut done).map_err(failed)?];
        let modes = Modes::with_rotor_modes(&model, &rotor_modes, COMPARED_FE_MODES).map_err(failed)?;
        if done(0.0).is_break() {
            return Err(SolveError::Cancelled);
        }
        let recovery = model.recovery(design, rotors)?;
        let shapes = modes.0.iter().map(|mode| mode_shape(&model, &recovery, &mode.shape)).collect();
        Ok(Self { modes, shapes, model, rotor_modes, recovery })
    }

    fn both(&self) -> (&Model, &Modes) {
        (&self.model, &self.modes)
    }

    /// Mesh force and displacements.
    fn deflection(&self, at_hz: f64) -> Result<(Complex64, [StationShape<Complex64>; 2]), SolveError> {
        let kind = self.model.kind;
        let mut line = Spectrum::with_capacity(1, self.model.coordinates());
        line.extend(&self.model, &Compliance::with_modes(&self.model, &self.rotor_modes), &[at_hz])
            .map_err(|error| SolveError::Response { kind, error })?;
        let force = line.mesh_force[0];
        let omega = std::f64::consts::TAU * at_hz;
        Ok((force, operating_deflection(&self.model, &self.rotor_modes, &self.recovery, omega, force)))
    }
}

/// m: makes an angle comparable with a displacement, for signs only.
const LEVER: f64 = 0.1;

fn entries(shape: &[StationShape<f64>; 2]) -> impl Iterator<Item = f64> {
    shape.iter().flat_map(|shaft| {
        let stations =
            shaft.displacements.iter().flat_map(|d| [d[0], d[1], d[2], LEVER * d[3], LEVER * d[4], LEVER * d[5]]);
        stations.chain(shaft.drive.map(|turn| LEVER * turn))
    })
}

fn largest_entry(shape: &[StationShape<f64>; 2]) -> f64 {
    // of two that rounding alone tells apart the first counts
    entries(shape)
        .fold(0.0, |largest: f64, entry| if entry.abs() > 1.000_001 * largest.abs() { entry } else { largest })
}

fn likeness(a: &[StationShape<f64>; 2], b: &[StationShape<f64>; 2]) -> f64 {
    entries(a).zip(entries(b)).map(|(a, b)| a * b).sum()
}

fn turn(shape: &mut [StationShape<f64>; 2]) {
    for shaft in shape {
        shaft.drive = shaft.drive.map(|turn| -turn);
        shaft.displacements.iter_mut().flatten().for_each(|entry| *entry = -*entry);
    }
}
