//! A ball between two grooves: the direction of the contact turns with the load.

use nalgebra::{ComplexField, Matrix3};

use super::Bearing;

pub(super) const EXPONENT: f64 = 1.5;

/// Groove centres of one ball under the radial and axial displacement of the inner ring.
struct Grooves<T> {
    /// Radial and axial distance, and their resultant
    radial: T,
    axial: T,
    distance: T,
    /// How much further apart than without load; a contact where it is positive
    deflection: T,
}

impl<T: ComplexField<RealField = f64> + Copy> Grooves<T> {
    fn new(bearing: &Bearing, a0: f64, radial: T, axial: T) -> Self {
        let (sin, cos) = bearing.0.contact_angle.sin_cos();
        let of = T::from_real;
        // A^2 - A0^2 is computed without the difference of two large numbers
        let gain = (radial * of(cos) + axial * of(sin)) * of(2.0 * a0) + radial * radial + axial * axial;
        let distance = (of(a0 * a0) + gain).sqrt();
        Self {
            radial: of(a0 * cos) + radial,
            axial: of(a0 * sin) + axial,
            distance,
            deflection: gain / (distance + of(a0)),
        }
    }
}

/// Radial and axial force of one ball on the inner ring.
pub(super) fn force<T: ComplexField<RealField = f64> + Copy>(
    bearing: &Bearing,
    a0: f64,
    [radial, axial]: [T; 2],
) -> [T; 2] {
    let grooves = Grooves::new(bearing, a0, radial, axial);
    if grooves.deflection.real() <= 0.0 {
        return [T::zero(); 2];
    }
    let load = grooves.deflection.powf(EXPONENT) * T::from_real(bearing.0.contact_stiffness);
    [load * grooves.radial / grooves.distance, load * grooves.axial / grooves.distance]
}

/// Deflection (m, not clipped), load (N) and contact angle (rad).
pub(super) fn contact(bearing: &Bearing, a0: f64, [radial, axial]: [f64; 2]) -> (f64, f64, f64) {
    let grooves = Grooves::new(bearing, a0, radial, axial);
    let load = bearing.0.contact_stiffness * grooves.deflection.max(0.0).powf(EXPONENT);
    (grooves.deflection, load, grooves.axial.atan2(grooves.radial))
}

pub(super) fn energy(bearing: &Bearing, a0: f64, [radial, axial]: [f64; 2]) -> f64 {
    let deflection = Grooves::new(bearing, a0, radial, axial).deflection.max(0.0);
    bearing.0.contact_stiffness * deflection.powf(EXPONENT + 1.0) / (EXPONENT + 1.0)
}

/// Derivative of the force over radial and axial displacement; a ball takes no moment, so the third row is zero.
pub(super) fn stiffness(bearing: &Bearing, a0: f64, [radial, axial]: [f64; 2]) -> Matrix3<f64> {
    let Grooves { radial, axial, distance, deflection } = Grooves::new(bearing, a0, radial, axial);
    if deflection <= 0.0 {
        return Matrix3::zeros();
    }
    let along = EXPONENT * bearing.0.contact_stiffness * deflection.sqrt();
    let across = bearing.0.contact_stiffness * deflection * deflection.sqrt() / distance;
    along_and_across(along, across, radial / distance, axial / distance)
}

/// At the unloaded contact angle and a given deflection.
pub(super) fn local(bearing: &Bearing, deflection: f64) -> Matrix3<f64> {
    let (sin, cos) = bearing.0.contact_angle.sin_cos();
    along_and_across(EXPONENT * bearing.0.contact_stiffness * deflection.sqrt(), 0.0, cos, sin)
}

fn along_and_across(along: f64, across: f64, cos: f64, sin: f64) -> Matrix3<f64> {
    let coupling = (along - across) * sin * cos;
    Matrix3::new(
        along * cos * cos + across * sin * sin,
        coupling,
        0.0,
        coupling,
        along * sin * sin + across * cos * cos,
        0.0,
        0.0,
        0.0,
        0.0,
    )
}
