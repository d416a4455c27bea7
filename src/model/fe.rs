//! Dynamic finite element model of one rotor: every station's six coordinates and the drive.

use nalgebra::{DMatrix, DVector};

use super::{Coordinate, RotorModel};
use crate::design::{Design, Side};
use crate::rotor::{Motion, Rotor, ShaftMatrices, mesh_vector, signed};

/// Free coordinates of all stations in order, then the drive's rotation where there is a drive.
pub fn rotor(design: &Design, rotor: &Rotor, side: Side) -> RotorModel {
    let input = design.rotor(side);
    let shaft = ShaftMatrices::new(input, &rotor.stations, &rotor.supports);
    let kept: Vec<usize> = (0..shaft.free.len()).filter(|&i| shaft.free[i]).collect();
    let n = kept.len();
    let size = n + usize::from(input.drive.is_some());
    let mut stiffness = DMatrix::zeros(size, size);
    let mut mass = DMatrix::zeros(size, size);
    // column by column, as they lie in memory
    for (column, &j) in kept.iter().enumerate() {
        for (row, &i) in kept.iter().enumerate() {
            stiffness[(row, column)] = shaft.stiffness[(i, j)];
            mass[(row, column)] = shaft.mass[(i, j)];
        }
    }
    let mesh_station = rotor.stations.mesh;
    let h = signed(side) * mesh_vector(design.mesh.vectors(side));
    let mut mesh = DVector::zeros(size);
    let mut coordinates = Vec::with_capacity(size);
    for (row, &i) in kept.iter().enumerate() {
        let (station, motion) = (i / 6, i % 6);
        if station == mesh_station {
            mesh[row] = h[motion];
        }
        if let Some(drive) = input.drive
            && rotor.stations.drive == Some(station)
            && Motion::ALL[motion] == Motion::ThY
        {
            join_drive(&mut stiffness, row, n, drive.torsional_stiffness);
        }
        coordinates.push(Coordinate::Station(station, Motion::ALL[motion]));
    }
    if let Some(drive) = input.drive {
        mass[(n, n)] = drive.inertia;
        coordinates.push(Coordinate::Drive);
    }
    RotorModel { stiffness, mass, mesh_vector: mesh, coordinates, mesh_station, reduction: None }
}

/// Adds a torsional spring (N m/rad) between two coordinates.
pub(super) fn join_drive(stiffness: &mut DMatrix<f64>, shaft: usize, drive: usize, spring: f64) {
    stiffness[(shaft, shaft)] += spring;
    stiffness[(drive, drive)] += spring;
    stiffness[(shaft, drive)] -= spring;
    stiffness[(drive, shaft)] -= spring;
}
