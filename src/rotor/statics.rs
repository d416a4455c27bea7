//! The shaft as the mesh feels it: static stiffness at the mesh station.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn, Matrix5, Matrix6};

use super::assembly::ShaftMatrices;
use super::{RotorError, Stations, Supports};
use crate::design::RotorDesign;

/// The five coordinates of a station that the bearings hold: all but thy.
const HELD_BY_BEARINGS: [usize; 5] = [0, 1, 2, 3, 5];

/// Static stiffness of a rotor at its mesh station, and the mass that its static shapes carry.
#[derive(Debug, Clone, PartialEq)]
pub struct Statics {
    /// `K_ll` (Hua et al. 2012, eqs. 28-35); order x, y, z, thx, thy, thz, row and column thy zero
    pub shaft_bearing_stiffness: Matrix6<f64>,
    /// Diagonal of `T^T` M T, T the static shapes for unit motion of each coordinate of the mesh station (Guyan 1965); kg and
    /// kg m^2, thy zero
    pub static_mass: [f64; 6],
}

impl Statics {
    /// Solves the shaft under unit loads at the mesh station (eq. 35: the inverse of its compliance).
    ///
    /// Static shapes are exact over uniform pieces: the coarsest stations have the least rounding.
    ///
    /// # Errors
    ///
    /// A rigid bearing at the mesh station, or values that overflow or lie too far apart.
    pub fn new(rotor: &RotorDesign, stations: &Stations, supports: &Supports) -> Result<Self, RotorError> {
        let shaft = ShaftMatrices::new(rotor, stations, supports);
        let kept: Vec<usize> = (0..shaft.free.len()).filter(|&i| shaft.free[i] && i % 6 != 4).collect();
        let mesh: Vec<usize> = HELD_BY_BEARINGS
            .iter()
            .map(|motion| kept.binary_search(&(6 * stations.mesh + motion)))
            .collect::<Result<_, _>>()
            .map_err(|_| RotorError::RigidAtMesh)?;
        let stiffness = shaft.stiffness.select_rows(&kept).select_columns(&kept);
        let shapes = unit_load_shapes(&stiffness, &mesh)?;
        let compliance = Matrix5::from_fn(|i, j| shapes[(mesh[i], j)]);
        let inverse = invert_symmetric(&compliance)?;
        let mut shaft_bearing_stiffness = Matrix6::zeros();
        for (i, &row) in HELD_BY_BEARINGS.iter().enumerate() {
            for (j, &column) in HELD_BY_BEARINGS.iter().enumerate() {
                shaft_bearing_stiffness[(row, column)] = inverse[(i, j)];
            }
        }
        let mass = shaft.mass.select_rows(&kept).select_columns(&kept);
        let unit_shapes = &shapes * inverse;
        let mut static_mass = [0.0; 6];
        for (i, &motion) in HELD_BY_BEARINGS.iter().enumerate() {
            let shape = unit_shapes.column(i);
            static_mass[motion] = shape.dot(&(&mass * shape));
        }
        Ok(Self { shaft_bearing_stiffness, static_mass })
    }
}

/// Displacements under a unit load on each of the given coordinates: one column a load.
fn unit_load_shapes(stiffness: &DMatrix<f64>, loaded: &[usize]) -> Result<DMatrix<f64>, RotorError> {
    let n = stiffness.nrows();
    let scale = DVector::from_fn(n, |i, _| 1.0 / stiffness[(i, i)].sqrt());
    let scaled = DMatrix::from_fn(n, n, |i, j| scale[i] * stiffness[(i, j)] * scale[j]);
    if !scaled.iter().all(|entry| entry.is_finite()) {
        return Err(RotorError::NotFinite("static stiffness"));
    }
    let factor: Cholesky<f64, Dyn> = Cholesky::new(scaled).ok_or(RotorError::IllConditioned("static stiffness"))?;
    let mut shapes = DMatrix::zeros(n, loaded.len());
    for (column, &coordinate) in loaded.iter().enumerate() {
        shapes[(coordinate, column)] = scale[coordinate];
    }
    factor.solve_mut(&mut shapes);
    for mut column in shapes.column_iter_mut() {
        column.component_mul_assign(&scale);
    }
    Ok(shapes)
}

/// Inverse of a compliance in mixed units, scaled so that metres and radians weigh alike, and made symmetric.
fn invert_symmetric(compliance: &Matrix5<f64>) -> Result<Matrix5<f64>, RotorError> {
    let scale = compliance.diagonal().map(|entry| 1.0 / entry.sqrt());
    let scaled = Matrix5::from_fn(|i, j| scale[i] * f64::midpoint(compliance[(i, j)], compliance[(j, i)]) * scale[j]);
    let inverse = scaled.try_inverse().ok_or(RotorError::IllConditioned("compliance at the mesh"))?;
    let inverse = Matrix5::from_fn(|i, j| scale[i] * f64::midpoint(inverse[(i, j)], inverse[(j, i)]) * scale[j]);
    if inverse.iter().all(|entry| entry.is_finite()) {
        Ok(inverse)
    } else {
        Err(RotorError::NotFinite("stiffness at the mesh"))
    }
}
