//! The modes of all models with their shapes and partners: all that the screen of the modes shows.

use std::ops::ControlFlow;
use std::sync::Arc;

use nalgebra::DMatrix;
use num_complex::Complex64;

use super::LEVER;
use crate::agreement::{COMPARED_FE_MODES, ModePair, mac_matrix, pair_modes};
use crate::comparison::SolveError;
use crate::design::Design;
use crate::model::{Model, ModelError, ModelKind, Recovery, Rotors};
use crate::response::{Modes, ResponseError, Solved, StationShape, mode_shape, operating_deflection};

/// How many models are held against finite elements.
pub const MODELS: usize = 3;

/// Finite element coordinates up to which the reduced model comes with the others: its fixed-interface modes take as long as theirs.
const AT_ONCE: usize = 400;

/// Modes of a design's models.
#[derive(Debug, Clone)]
pub struct Study {
    pub design: Design,
    /// Of its file, or of what that would be if it were saved; nothing where there is none
    pub hash: Option<String>,
    pub fe: Arc<ModelStudy>,
    lumped: [Arc<SmallStudy>; 2],
    reduced: Option<Arc<SmallStudy>>,
}

/// A small model's modes beside those of finite elements.
#[derive(Debug, Clone)]
pub struct SmallStudy {
    pub own: ModelStudy,
    /// Its modes with those of finite elements
    pub pairs: Vec<ModePair>,
    /// A row a mode, a column a finite element mode
    pub mac: DMatrix<f64>,
}

/// One model's modes.
#[derive(Debug, Clone)]
pub struct ModelStudy {
    /// The lowest; of finite elements no more than are compared
    pub modes: Modes,
    /// At the stations of both shafts, pinion first, phi^T M phi = 1 kg m^2
    pub shapes: Vec<[StationShape<f64>; 2]>,
    solved: Solved,
    recovery: [Recovery; 2],
}

/// Operating deflection shapes at one frequency, m and rad.
#[derive(Debug, Clone, PartialEq)]
pub struct DeflectionShapes {
    pub at_hz: f64,
    pub fe: Deflection,
    /// Enhanced, basic, and reduced where it is known
    pub small: Vec<Deflection>,
}

/// One model's.
#[derive(Debug, Clone, PartialEq)]
pub struct Deflection {
    /// Dynamic mesh force, N
    pub force: Complex64,
    /// Pinion, gear
    pub shapes: [StationShape<Complex64>; 2],
}

impl Study {
    /// Solves all models, the reduced one with `reduced` fixed-interface modes a rotor where that takes no long time; ends with
    /// [`SolveError::Cancelled`] as soon as `wanted` says no.
    ///
    /// # Errors
    ///
    /// [`SolveError`] says why there are no modes.
    pub fn new(design: &Design, reduced: usize, wanted: &dyn Fn() -> bool) -> Result<Self, SolveError> {
        let rotors = Rotors::new(design)?;
        let solved = |kind| ModelStudy::new(kind, design, &rotors, wanted);
        let mut fe = solved(ModelKind::Fe)?;
        fe.shapes.iter_mut().filter(|shape| largest_entry(shape) < 0.0).for_each(turn);
        let [enhanced, basic] = [solved(ModelKind::Enhanced)?, solved(ModelKind::Basic)?];
        let is_quick = fe.solved.model.coordinates() <= AT_ONCE;
        let reduced = is_quick.then(|| solved(ModelKind::Reduced(reduced))).transpose()?;
        let motions = Arc::clone(&enhanced.solved.model);
        let beside = |own| Arc::new(SmallStudy::new(own, &fe, &motions));
        let (lumped, reduced) = ([enhanced, basic].map(beside), reduced.map(beside));
        Ok(Self { design: design.clone(), hash: None, lumped, reduced, fe: Arc::new(fe) })
    }

    /// The same with another reduced model.
    ///
    /// # Errors
    ///
    /// As [`Study::new`].
    pub fn with_reduced(&self, reduced: usize, wanted: &dyn Fn() -> bool) -> Result<Self, SolveError> {
        let rotors = Rotors::new(&self.design)?;
        let own = ModelStudy::new(ModelKind::Reduced(reduced), &self.design, &rotors, wanted)?;
        let reduced = Some(Arc::new(SmallStudy::new(own, &self.fe, &self.lumped[0].own.solved.model)));
        Ok(Self { reduced, ..self.clone() })
    }

    /// The models beside finite elements: enhanced, basic, and reduced where it is known.
    pub fn small(&self) -> impl Iterator<Item = &SmallStudy> {
        self.lumped.iter().chain(&self.reduced).map(|small| &**small)
    }

    /// One of them.
    pub fn one(&self, model: usize) -> Option<&SmallStudy> {
        self.small().nth(model)
    }

    /// Fixed-interface modes a rotor of the reduced model, where that is known.
    pub fn reduced(&self) -> Option<usize> {
        match self.reduced.as_ref()?.own.kind() {
            ModelKind::Reduced(modes) => Some(modes),
            _ => None,
        }
    }

    /// Displacements under the mesh force at `at_hz` (Hz, greater than 0).
    ///
    /// # Errors
    ///
    /// A mesh force that overflows there.
    pub fn deflection(&self, at_hz: f64) -> Result<DeflectionShapes, SolveError> {
        let small = self.small().map(|small| small.own.deflection(at_hz)).collect::<Result<_, _>>()?;
        Ok(DeflectionShapes { at_hz, fe: self.fe.deflection(at_hz)?, small })
    }
}

impl SmallStudy {
    /// `motions` is the enhanced model, whose coordinates all models have in common.
    fn new(mut own: ModelStudy, fe: &ModelStudy, motions: &Model) -> Self {
        let pairs = pair_modes(own.both(), fe.both(), motions);
        let mac = mac_matrix(own.both(), fe.both(), motions);
        for (at, shape) in own.shapes.iter_mut().enumerate() {
            let partner = pairs.iter().find(|pair| pair.lumped == at).map(|pair| &fe.shapes[pair.fe]);
            // a shape and its negative are the same mode: partners are drawn to the same side
            let is_turned = partner.map_or_else(|| largest_entry(shape) < 0.0, |fe| likeness(shape, fe) < 0.0);
            if is_turned {
                turn(shape);
            }
        }
        Self { own, pairs, mac }
    }
}

impl ModelStudy {
    fn new(kind: ModelKind, design: &Design, rotors: &Rotors, wanted: &dyn Fn() -> bool) -> Result<Self, SolveError> {
        let failed = |error| match error {
            ResponseError::Cancelled => SolveError::Cancelled,
            error => SolveError::Response { kind, error },
        };
        let mut done = |_| if wanted() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
        let model = Model::new_over(kind, design, rotors, &mut done).map_err(|error| match error {
            ModelError::Cancelled => SolveError::Cancelled,
            error @ ModelError::IllConditioned(_) => error.into(),
        })?;
        if done(0.0).is_break() {
            return Err(SolveError::Cancelled);
        }
        let solved = Solved::over(model, &mut done).map_err(failed)?;
        let Solved { model, rotor_modes } = &solved;
        let modes = Modes::with_rotor_modes(model, rotor_modes, COMPARED_FE_MODES).map_err(failed)?;
        if done(0.0).is_break() {
            return Err(SolveError::Cancelled);
        }
        let recovery = model.recovery(design, rotors)?;
        let shapes = modes.0.iter().map(|mode| mode_shape(model, &recovery, &mode.shape)).collect();
        Ok(Self { modes, shapes, solved, recovery })
    }

    pub fn kind(&self) -> ModelKind {
        self.solved.model.kind
    }

    fn both(&self) -> (&Model, &Modes) {
        (&self.solved.model, &self.modes)
    }

    /// Mesh force and displacements.
    fn deflection(&self, at_hz: f64) -> Result<Deflection, SolveError> {
        let Solved { model, rotor_modes } = &self.solved;
        let line = self.solved.spectrum(&[at_hz]);
        let force = line.map_err(|error| SolveError::Response { kind: model.kind, error })?.mesh_force[0];
        let omega = std::f64::consts::TAU * at_hz;
        let shapes = operating_deflection(model, rotor_modes, &self.recovery, omega, force);
        Ok(Deflection { force, shapes })
    }
}

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
