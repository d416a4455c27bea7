//! Effective mass and inertia of a rotor at its mesh station (Hua et al. 2012, eqs. 56-57).

use super::initial_parameter::{PlaneMode, first_mode};
use super::plane::{BendingPlane, Plane};
use super::{RotorError, Statics, Stations, Supports};
use crate::design::RotorDesign;

/// First bending mode in one plane and what it makes of the rotor's mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bending {
    /// Hz
    pub frequency: f64,
    /// Effective mass at the mesh station, kg
    pub mass: f64,
    /// Effective diametral inertia at the mesh station, kg m^2
    pub inertia: f64,
    /// Share of the mode's kinetic energy that mass and inertia miss
    pub energy_residual: f64,
    /// The mass is the static (Guyan) one, since the mode does not determine it
    pub mass_fallback: bool,
    /// The inertia is the static (Guyan) one
    pub inertia_fallback: bool,
}

impl Bending {
    /// The pair (56), (57) has no real solution; it touches where the mode is also the eigenvector of the two-coordinate model:
    ///
    /// M = (K11 + K12 phi/z) / w^2, I = (K22 + K12 z/phi) / w^2.
    ///
    /// That keeps the frequency and the ratio z : phi exactly. What the mode does not determine, or what is not positive, is
    /// taken from the static mass.
    fn new(mode: &PlaneMode, direction: BendingPlane, statics: &Statics) -> Self {
        /// Below this the mode does not tilt at the mesh (or does not move, the other way round).
        const UNDETERMINED: f64 = 1e-6;
        let [k11, k12, k22] = direction.block(&statics.shaft_bearing_stiffness);
        let [deflection, rotation] = direction.coordinates();
        let (static_mass, static_inertia) = (statics.static_mass[deflection], statics.static_mass[rotation]);
        let omega_squared = mode.omega * mode.omega;
        let (z, phi) = (mode.deflection, mode.slope);
        let tilt = phi.abs() * k22.sqrt() / (z.abs() * k11.sqrt());
        let mass = if tilt < UNDETERMINED {
            Some(k11 / omega_squared)
        } else if tilt > 1.0 / UNDETERMINED {
            None
        } else {
            Some((k11 + k12 * phi / z) / omega_squared)
        };
        let inertia = if tilt < UNDETERMINED {
            None
        } else if tilt > 1.0 / UNDETERMINED {
            Some(k22 / omega_squared)
        } else {
            Some((k22 + k12 * z / phi) / omega_squared)
        };
        let usable = |value: Option<f64>| value.filter(|v| v.is_finite() && *v > 0.0);
        let (mass, inertia) = (usable(mass), usable(inertia));
        let strain = z * z * k11 + 2.0 * z * phi * k12 + phi * phi * k22;
        Self {
            frequency: mode.omega / std::f64::consts::TAU,
            mass: mass.unwrap_or(static_mass),
            inertia: inertia.unwrap_or(static_inertia),
            energy_residual: 1.0 - strain / (omega_squared * mode.inertia_integral),
            mass_fallback: mass.is_none(),
            inertia_fallback: inertia.is_none(),
        }
    }

    fn is_finite(&self) -> bool {
        [self.frequency, self.mass, self.inertia, self.energy_residual].iter().all(|figure| figure.is_finite())
    }
}

/// Bending in the x-y and in the y-z plane; transfer matrices want the coarsest stations.
pub fn in_both_planes(
    rotor: &RotorDesign,
    stations: &Stations,
    supports: &Supports,
    statics: &Statics,
) -> Result<[Bending; 2], RotorError> {
    let plane = |direction| Plane::new(rotor, stations, supports, direction);
    let mode = |plane: &Plane, direction| {
        first_mode(plane, estimate(statics, direction)).ok_or(RotorError::NotFinite("first bending mode"))
    };
    let (plane_x, plane_z) = (plane(BendingPlane::X), plane(BendingPlane::Z));
    let mode_z = mode(&plane_z, BendingPlane::Z)?;
    // most shafts are held alike in both planes
    let mode_x = if plane_x == plane_z { mode_z } else { mode(&plane_x, BendingPlane::X)? };
    let both = [Bending::new(&mode_x, BendingPlane::X, statics), Bending::new(&mode_z, BendingPlane::Z, statics)];
    if both.iter().all(Bending::is_finite) { Ok(both) } else { Err(RotorError::NotFinite("first bending mode")) }
}

/// Lower natural frequency (rad/s) of the two-coordinate model with the static masses: near the first mode, a place to start.
fn estimate(statics: &Statics, direction: BendingPlane) -> f64 {
    let [k11, k12, k22] = direction.block(&statics.shaft_bearing_stiffness);
    let [mass, inertia] = direction.coordinates().map(|i| statics.static_mass[i]);
    let (a, b) = (k11 / mass, k22 / inertia);
    let spread = (a - b).hypot(2.0 * k12 / (mass * inertia).sqrt());
    // the product of the roots over the larger one has no cancellation
    let lower = (k11 * k22 - k12 * k12) / (mass * inertia) / (0.5 * (a + b + spread));
    if lower > 0.0 { lower.sqrt() } else { a.min(b).sqrt() }
}
