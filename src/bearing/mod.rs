//! Rolling-element bearings: loads and stiffness of balls and rollers in contact with both rings.
//!
//! The formulation is that of T. C. Lim and R. Singh, "Vibration transmission through rolling element bearings", Journal of Sound and
//! Vibration 139(2), 179-199 and 201-225 (1990), with the spread of the load along rollers of part V, 169(4), 547-553 (1994).
//!
//! Everything here is in the frame of those papers: Z along the shaft, X and Y radial, right handed. Displacements are those of the
//! inner ring relative to the outer one, q = (dx, dy, dz, bx, by); loads are those on the inner ring, f = (Fx, Fy, Fz, Mx, My), and the
//! bearing pushes back with -f. The reference point is on the axis in the plane of the element centres. [`frames`] leads to the
//! shafts' frame.

mod ball;
mod elements;
mod equilibrium;
pub mod frames;
mod hertz;
mod line;
mod newton;
mod roller;

pub use elements::{Contact, State, Warning};
pub use equilibrium::{EquilibriumError, Held, equilibrium};
pub use hertz::{BallGeometry, roller_contact_stiffness};
pub use newton::{Failure, Potential, minimise};

/// Five displacements or loads in the order of the module's documentation; m and rad, or N and N m.
pub type Vector = nalgebra::SVector<f64, 5>;

/// df/dq in that order; N/m, N/rad and N, N m/rad.
pub type Matrix = nalgebra::SMatrix<f64, 5, 5>;

/// A bearing whose numbers can be computed with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bearing(Data);

/// What rolls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// Q = Kn delta^(3/2); A0 is the distance of the groove centres without load, m
    Ball { groove_distance: f64 },
    /// Q = Kn delta^(10/9); the load spreads over this length (m) of each roller, or is taken at its middle where the length is 0
    Roller { length: f64 },
}

/// A number that no bearing has.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("BAD_INPUT: {field} must be {wanted}; it is {value:?}")]
pub struct BadInput {
    pub field: &'static str,
    pub wanted: &'static str,
    pub value: f64,
}

/// The numbers of a bearing, to be checked by [`Bearing::new`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Data {
    /// Number of rolling elements
    pub elements: usize,
    /// Unloaded contact angle, rad; positive where thrust is taken when the inner ring moves towards +Z
    pub contact_angle: f64,
    /// Radial clearance r_L, m: half the diametral one
    pub clearance: f64,
    /// Radius r of the inner groove centres, or mean radius of the rollers, m
    pub radius: f64,
    /// Kn of both raceways together, N/m^(3/2) or N/m^(10/9)
    pub contact_stiffness: f64,
    pub kind: Kind,
}

impl Bearing {
    /// # Errors
    ///
    /// [`BadInput`] names the field: fewer than three elements, a stiffness, radius or groove distance that is not greater than 0, a
    /// contact angle of 90 degrees or more, a negative clearance or length, or what is not finite.
    pub fn new(data: Data) -> Result<Self, BadInput> {
        let Data { elements, contact_angle, clearance, radius, contact_stiffness, kind } = data;
        let check = |field, wanted, value: f64, is_right: bool| {
            if value.is_finite() && is_right { Ok(()) } else { Err(BadInput { field, wanted, value }) }
        };
        check("elements", "at least 3", elements as f64, elements >= 3)?;
        let right_angle = std::f64::consts::FRAC_PI_2;
        check("contact angle", "within 90 degrees, in rad", contact_angle, contact_angle.abs() < right_angle)?;
        check("clearance", "at least 0 m", clearance, clearance >= 0.0)?;
        check("pitch radius", "greater than 0 m", radius, radius > 0.0)?;
        check("contact stiffness", "greater than 0", contact_stiffness, contact_stiffness > 0.0)?;
        match kind {
            Kind::Ball { groove_distance } => {
                check("groove distance", "greater than 0 m", groove_distance, groove_distance > 0.0)?;
            }
            Kind::Roller { length } => check("roller length", "at least 0 m", length, length >= 0.0)?,
        }
        Ok(Self(data))
    }

    /// What it was made of.
    pub fn data(&self) -> Data {
        self.0
    }

    /// Number of rolling elements.
    pub fn elements(&self) -> usize {
        self.0.elements
    }

    /// Unloaded contact angle, rad.
    pub fn contact_angle(&self) -> f64 {
        self.0.contact_angle
    }

    /// Radius r of kinematics and moments, m.
    pub fn radius(&self) -> f64 {
        self.0.radius
    }

    /// Exponent n of Q = Kn delta^n.
    pub fn exponent(&self) -> f64 {
        match self.0.kind {
            Kind::Ball { .. } => ball::EXPONENT,
            Kind::Roller { .. } => roller::EXPONENT,
        }
    }

    /// How far the rings approach under a load (N) that all elements share, m.
    pub fn typical_deflection(&self, load: f64) -> f64 {
        (load / (self.0.elements as f64 * self.0.contact_stiffness)).powf(1.0 / self.exponent())
    }

    /// Radial clearance, m.
    pub fn clearance(&self) -> f64 {
        self.0.clearance
    }

    /// K with every element pressed by `deflection` (m) at the unloaded contact angle: what the bearing can resist at all.
    pub fn full_contact(&self, deflection: f64) -> Matrix {
        (0..self.0.elements).fold(Matrix::zeros(), |sum, j| {
            let b = self.kinematics(j);
            let stiffness = match self.0.kind {
                Kind::Ball { .. } => ball::local(self, deflection),
                Kind::Roller { length } => roller::local(self, length, deflection),
            };
            sum + b.transpose() * stiffness * b
        })
    }
}
