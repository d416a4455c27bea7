//! From the frame of the bearing formulas (Z along the shaft) to that of the shafts (y along the shaft) and back.
//!
//! X = z, Y = x, Z = y: a cyclic change of the axes, so that no sign changes anywhere.

use nalgebra::{Matrix6, Vector6};

use super::{Matrix, Vector};

/// Places of (dx, dy, dz, bx, by) among x, y, z, thx, thy, thz.
pub const PLACES: [usize; 5] = [2, 0, 1, 5, 3];

/// Displacements or loads of a station (order x, y, z, thx, thy, thz) as the bearing has them; thy is free.
pub fn to_bearing(station: &Vector6<f64>) -> Vector {
    Vector::from_fn(|i, _| station[PLACES[i]])
}

/// Displacements or loads of a bearing in the order x, y, z, thx, thy, thz; thy is zero.
pub fn to_station(bearing: &Vector) -> Vector6<f64> {
    let mut station = Vector6::zeros();
    for (i, &place) in PLACES.iter().enumerate() {
        station[place] = bearing[i];
    }
    station
}

/// Stiffness in the order x, y, z, thx, thy, thz; row and column thy are zero.
pub fn stiffness_to_station(stiffness: &Matrix) -> Matrix6<f64> {
    let mut station = Matrix6::zeros();
    for (i, &row) in PLACES.iter().enumerate() {
        for (j, &column) in PLACES.iter().enumerate() {
            station[(row, column)] = stiffness[(i, j)];
        }
    }
    station
}
