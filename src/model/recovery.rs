//! From a model's coordinates back to the whole shaft: displacements of all stations, and the forces of the bearings on it.

use nalgebra::{DMatrix, DVector};

use super::reduced::static_shapes;
use super::{Coordinate, ModelError, ModelKind, RotorModel, fe};
use crate::design::{Design, Side};
use crate::rotor::{Rotor, ShaftMatrices};

/// How the displacements of the whole shaft follow from a model's coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RecoveryKind {
    /// They are its coordinates
    Exact,
    /// By the shapes that the model was reduced to
    OwnBasis,
    /// By the static shapes for unit motion of each coordinate of the mesh station and the drive, those behind `K_ll` (Hua et al. 2012,
    /// eqs. 28-35)
    StaticShapes,
}

impl RecoveryKind {
    /// For [`ModelKind`]s.
    pub fn of(kind: ModelKind) -> Self {
        match kind {
            ModelKind::Fe => Self::Exact,
            ModelKind::Reduced(_) => Self::OwnBasis,
            ModelKind::Enhanced | ModelKind::Basic => Self::StaticShapes,
        }
    }

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Exact => "exact",
            Self::OwnBasis => "recovered by the reduced model's own shapes",
            Self::StaticShapes => "recovered by static shapes",
        }
    }
}

/// One rotor of a model seen as the whole shaft.
#[derive(Debug, Clone)]
pub struct Recovery {
    pub kind: RecoveryKind,
    /// m from the shaft's start
    pub positions: Vec<f64>,
    /// Finite element coordinates
    coordinates: Vec<Coordinate>,
    /// Their displacements for a unit of each of the model's; `None` where they are the same
    basis: Option<DMatrix<f64>>,
    bearings: Vec<Bearing>,
}

/// Force of one bearing on the shaft: `stiffness` x (1 + j s zeta) - w^2 `mass` x, x the displacements of the model's coordinates.
///
/// Rows fx, fy, fz (N), mx, my, mz (N m).
#[derive(Debug, Clone)]
pub struct Bearing {
    pub name: String,
    pub stiffness: DMatrix<f64>,
    /// Of the shaft's mass that a held coordinate would accelerate; zero for static shapes, which carry no inertia
    pub mass: DMatrix<f64>,
}

impl Recovery {
    /// `model` is the rotor of one side of a model of the given kind.
    ///
    /// # Errors
    ///
    /// [`ModelError`] where the static shapes of a lumped model's shaft cannot be solved.
    pub fn new(
        kind: ModelKind,
        design: &Design,
        rotor: &Rotor,
        side: Side,
        model: &RotorModel,
    ) -> Result<Self, ModelError> {
        let kind = RecoveryKind::of(kind);
        let (basis, coordinates) = match (kind, &model.reduction) {
            (RecoveryKind::Exact, _) => (None, model.coordinates.clone()),
            (RecoveryKind::OwnBasis, Some(reduction)) => {
                (Some(reduction.basis.clone()), reduction.full.coordinates.clone())
            }
            _ => {
                let full = fe::rotor(design, rotor, side);
                (Some(static_shapes(&full, side)?), full.coordinates)
            }
        };
        let mut out =
            Self { kind, positions: rotor.stations.positions.clone(), coordinates, basis, bearings: Vec::new() };
        out.bearings = out.reactions(design, rotor, side);
        Ok(out)
    }

    /// In the design's order.
    pub fn bearings(&self) -> &[Bearing] {
        &self.bearings
    }

    /// Displacements of all stations, six each in m and rad, and the drive's rotation if there is one, for those of the model's coordinates;
    /// zero where a rigid bearing holds.
    pub fn stations(&self, model: &DVector<f64>) -> (Vec<[f64; 6]>, Option<f64>) {
        let whole = self.basis.as_ref().map_or_else(|| model.clone(), |basis| basis * model);
        let mut stations = vec![[0.0; 6]; self.positions.len()];
        let mut drive = None;
        for (coordinate, value) in self.coordinates.iter().zip(whole.iter()) {
            match *coordinate {
                Coordinate::Station(station, motion) => stations[station][motion as usize] = *value,
                Coordinate::Drive => drive = Some(*value),
                Coordinate::FixedInterfaceMode(_) => {}
            }
        }
        (stations, drive)
    }

    fn reactions(&self, design: &Design, rotor: &Rotor, side: Side) -> Vec<Bearing> {
        let (stations, supports) = (&rotor.stations, &rotor.supports);
        let shaft = ShaftMatrices::new(design.rotor(side), stations, supports);
        let n = shaft.free.len();
        let reaction = |bearing: usize| {
            let mut stiffness = -supports.share(bearing, &stations.bearings, n);
            let mut mass = DMatrix::zeros(6, n);
            for translation in (0..3).filter(|&t| supports.holds(bearing, t)) {
                let held = 6 * stations.bearings[bearing] + translation;
                // two rigid bearings at one place: nothing says which of them carries more
                let holds = |other: &usize| {
                    stations.bearings[*other] * 6 + translation == held && supports.holds(*other, translation)
                };
                let share = 1.0 / (0..stations.bearings.len()).filter(holds).count() as f64;
                for column in 0..n {
                    stiffness[(translation, column)] += share * shaft.stiffness[(held, column)];
                    mass[(translation, column)] += share * shaft.mass[(held, column)];
                }
            }
            if self.kind == RecoveryKind::StaticShapes {
                mass.fill(0.0);
            }
            let name = supports.bearings[bearing].name.clone();
            Bearing { name, stiffness: self.over_model(&stiffness), mass: self.over_model(&mass) }
        };
        (0..stations.bearings.len()).map(reaction).collect()
    }

    /// Columns over all stations to columns over the model's coordinates.
    fn over_model(&self, rows: &DMatrix<f64>) -> DMatrix<f64> {
        let mut over_full = DMatrix::zeros(6, self.coordinates.len());
        for (column, coordinate) in self.coordinates.iter().enumerate() {
            if let Coordinate::Station(station, motion) = *coordinate {
                over_full.set_column(column, &rows.column(6 * station + motion as usize));
            }
        }
        self.basis.as_ref().map_or_else(|| over_full.clone(), |basis| &over_full * basis)
    }
}
