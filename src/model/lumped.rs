//! Lumped models of one rotor: the six coordinates of its mesh station and the drive (Hua et al. 2012, eqs. 17-35, 56-59).

use nalgebra::{DMatrix, DVector};

use super::{Coordinate, RotorModel, fe};
use crate::design::{Design, Side};
use crate::rotor::{Motion, Rotor, mesh_vector, signed};

/// Where a lumped model takes its masses from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LumpedMass {
    /// Effective masses of the first bending modes (56), (57); axial mass and polar inertia of the whole rotor (58), (59)
    Enhanced,
    /// The whole rotor as a rigid body
    Basic,
}

impl LumpedMass {
    /// Diagonal of the mass matrix at the mesh station: kg, then kg m^2.
    pub fn diagonal(self, rotor: &Rotor) -> [f64; 6] {
        let totals = &rotor.totals;
        let (x, z) = (&rotor.bending_x, &rotor.bending_z);
        match self {
            Self::Enhanced => [x.mass, totals.mass, z.mass, z.inertia, totals.polar_inertia, x.inertia],
            Self::Basic => {
                let (m, d) = (totals.mass, totals.diametral_inertia);
                [m, m, m, d, totals.polar_inertia, d]
            }
        }
    }
}

/// Index of the shaft's rotation thy among the coordinates of a lumped rotor.
const SHAFT_ROTATION: usize = 4;
/// Index of the drive's rotation, where there is a drive.
const DRIVE: usize = 6;

/// `K_ll` (35) and the torsional spring to the drive: N/m, N, N m/rad; order x, y, z, thx, thy, thz, then the drive if any.
pub(super) fn stiffness(design: &Design, rotor: &Rotor, side: Side) -> DMatrix<f64> {
    let drive = design.rotor(side).drive;
    let size = DRIVE + usize::from(drive.is_some());
    let mut stiffness = DMatrix::zeros(size, size);
    stiffness.fixed_view_mut::<6, 6>(0, 0).copy_from(&rotor.statics.shaft_bearing_stiffness);
    if let Some(drive) = drive {
        // the shaft's own torsion lies in series: without it the low-frequency response would be wrong
        let spring = 1.0 / (1.0 / drive.torsional_stiffness + rotor.stations.torsional_compliance());
        fe::join_drive(&mut stiffness, SHAFT_ROTATION, DRIVE, spring);
    }
    stiffness
}

/// Coordinates x, y, z, thx, thy, thz of the mesh station, then the drive's rotation where there is a drive.
pub fn rotor(design: &Design, rotor: &Rotor, side: Side, masses: LumpedMass) -> RotorModel {
    let stiffness = stiffness(design, rotor, side);
    let size = stiffness.nrows();
    let mut mass = DMatrix::zeros(size, size);
    for (i, value) in masses.diagonal(rotor).into_iter().enumerate() {
        mass[(i, i)] = value;
    }
    let mut mesh = DVector::zeros(size);
    mesh.fixed_rows_mut::<6>(0).copy_from(&(signed(side) * mesh_vector(design.mesh.vectors(side))));
    let mut coordinates: Vec<Coordinate> =
        Motion::ALL.into_iter().map(|motion| Coordinate::Station(0, motion)).collect();
    if let Some(drive) = design.rotor(side).drive {
        mass[(DRIVE, DRIVE)] = drive.inertia;
        coordinates.push(Coordinate::Drive);
    }
    RotorModel { stiffness, mass, mesh_vector: mesh, coordinates, mesh_station: 0, reduction: None }
}
