//! A roller between two raceways: the direction of the contact is fixed, the load may spread unevenly along the line.

use nalgebra::{ComplexField, Matrix3};

use super::Bearing;
use super::line::moments;

pub(super) const EXPONENT: f64 = 10.0 / 9.0;

/// Approach of the raceways at the middle of the roller, before clipping.
fn deflection<T: ComplexField<RealField = f64> + Copy>(bearing: &Bearing, radial: T, axial: T) -> T {
    let (sin, cos) = bearing.0.contact_angle.sin_cos();
    radial * T::from_real(cos) + axial * T::from_real(sin)
}

/// Radial and axial force and tilting moment of one roller on the inner ring; displacements radial and axial, tilt in the plane of
/// the roller.
pub(super) fn force<T: ComplexField<RealField = f64> + Copy>(
    bearing: &Bearing,
    length: f64,
    [radial, axial, tilt]: [T; 3],
) -> [T; 3] {
    let (sin, cos) = bearing.0.contact_angle.sin_cos();
    let [i0, i1, _] = moments(deflection(bearing, radial, axial), tilt, length, EXPONENT);
    let stiffness = T::from_real(bearing.0.contact_stiffness);
    let load = stiffness * i0;
    [load * T::from_real(cos), load * T::from_real(sin), stiffness * i1]
}

/// Deflection at the middle (m, not clipped) and load (N).
pub(super) fn contact(bearing: &Bearing, length: f64, [radial, axial, tilt]: [f64; 3]) -> (f64, f64) {
    let middle = deflection(bearing, radial, axial);
    (middle, bearing.0.contact_stiffness * moments(middle, tilt, length, EXPONENT)[0])
}

pub(super) fn energy(bearing: &Bearing, length: f64, [radial, axial, tilt]: [f64; 3]) -> f64 {
    let power = EXPONENT + 1.0;
    bearing.0.contact_stiffness * moments(deflection(bearing, radial, axial), tilt, length, power)[0] / power
}

/// Derivative of the force over radial and axial displacement and tilt.
pub(super) fn stiffness(bearing: &Bearing, length: f64, [radial, axial, tilt]: [f64; 3]) -> Matrix3<f64> {
    let moments = moments(deflection(bearing, radial, axial), tilt, length, EXPONENT - 1.0);
    local_of(bearing, moments)
}

/// All of the line pressed alike.
pub(super) fn local(bearing: &Bearing, length: f64, deflection: f64) -> Matrix3<f64> {
    local_of(bearing, moments(deflection, 0.0, length, EXPONENT - 1.0))
}

fn local_of(bearing: &Bearing, moments: [f64; 3]) -> Matrix3<f64> {
    let (sin, cos) = bearing.0.contact_angle.sin_cos();
    let [j0, j1, j2] = moments.map(|moment| EXPONENT * bearing.0.contact_stiffness * moment);
    Matrix3::new(
        j0 * cos * cos,
        j0 * sin * cos,
        j1 * cos,
        j0 * sin * cos,
        j0 * sin * sin,
        j1 * sin,
        j1 * cos,
        j1 * sin,
        j2,
    )
}
