//! Ball and roller bearings of a design, in SI units and rad. Declared like the rest of the [model](super::model).

use super::model::Design;
use super::rotor::BearingModel;
use super::schema::{Kind, Limit, Presence, Written};
use crate::bearing;
use crate::units::Quantity;

/// More than any catalogue has, and few enough to compute with.
const ELEMENTS: Kind = Kind::Whole(3, 1000);
const CONTACT_ANGLE: Kind = Kind::Number(Quantity::Angle, Limit::Between(-90.0, 90.0));
const PRELOAD: Kind = Kind::Number(Quantity::Deflection, Limit::NotNegative);
/// Groove radius over ball diameter: a groove is wider than the ball, and no plane.
const GROOVE: Kind = Kind::Number(Quantity::Ratio, Limit::Between(0.5, 1.0));
const LENGTH: Kind = Kind::Number(Quantity::Length, Limit::Positive);
const ZERO: Presence = Presence::Default(Written::Number(0.0));

tables! {
    /// Balls between two grooves, by contact data or by geometry, at a mean state that is given in one of three ways.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct BallBearing as "ball bearing" {
        /// Number of balls.
        pub elements: usize = "elements", ELEMENTS, Presence::Required;
        /// Unloaded contact angle: positive where thrust is taken when the shaft moves towards +y.
        pub contact_angle: f64 = "contact_angle_deg", CONTACT_ANGLE, Presence::Required;
        /// Radial clearance: half the diametral one; 0 where the contact angle comes from the clearance.
        pub clearance: f64 = "clearance_mm", Kind::Number(Quantity::Length, Limit::NotNegative), ZERO;
        /// Contact data: load-deflection constant of both raceways.
        pub contact_stiffness: Option<f64> = "contact_stiffness_n_per_m_1_5",
            Kind::Number(Quantity::BallContact, Limit::Positive), Presence::Optional;
        /// Contact data: distance A0 of the groove centres without load.
        pub groove_distance: Option<f64> = "groove_distance_mm", LENGTH, Presence::Optional;
        /// Contact data: radius of the inner groove centres.
        pub pitch_radius: Option<f64> = "pitch_radius_mm", LENGTH, Presence::Optional;
        /// Geometry: ball diameter.
        pub ball_diameter: Option<f64> = "ball_diameter_mm", LENGTH, Presence::Optional;
        /// Geometry: diameter of the circle of ball centres.
        pub pitch_diameter: Option<f64> = "pitch_diameter_mm", LENGTH, Presence::Optional;
        /// Geometry: radius of the inner groove over the ball diameter.
        pub inner_groove_factor: Option<f64> = "inner_groove_factor", GROOVE, Presence::Optional;
        /// Geometry: radius of the outer groove over the ball diameter.
        pub outer_groove_factor: Option<f64> = "outer_groove_factor", GROOVE, Presence::Optional;
        /// Mean state: displacement of the inner ring.
        pub displacement: Option<RingDisplacement> = "displacement",
            Kind::Table(RingDisplacement::TABLE), Presence::Optional;
        /// Mean state: loads on the inner ring, which does not tilt.
        pub preload: Option<Preload> = "preload", Kind::Table(Preload::TABLE), Presence::Optional;
        /// Mean state: found from the torque, with the whole shaft.
        pub mean_load: Option<MeanLoad> = "mean_load", Kind::Word(MeanLoad::WORDS), Presence::Optional;
        /// With a mean load from torque: axial approach of the rings at assembly, in the bearing's own loaded direction.
        pub mounting_preload: f64 = "mounting_preload_um", PRELOAD, ZERO;
    }

    /// Rollers between two raceways, at a mean state that is given in one of three ways.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct RollerBearing as "roller bearing" {
        /// Number of rollers.
        pub elements: usize = "elements", ELEMENTS, Presence::Required;
        /// Contact angle: positive where thrust is taken when the shaft moves towards +y; 0 for a cylindrical one.
        pub contact_angle: f64 = "contact_angle_deg", CONTACT_ANGLE, Presence::Required;
        /// Radial clearance: half the diametral one.
        pub clearance: f64 = "clearance_mm", Kind::Number(Quantity::Length, Limit::NotNegative), ZERO;
        /// Mean radius of the rollers from the axis.
        pub pitch_radius: f64 = "pitch_radius_mm", LENGTH, Presence::Required;
        /// Load-deflection constant of both raceways; that of steel rollers where only their length is given.
        pub contact_stiffness: Option<f64> = "contact_stiffness_n_per_m_10_9",
            Kind::Number(Quantity::RollerContact, Limit::Positive), Presence::Optional;
        /// Effective length: the load spreads unevenly along it when the rings tilt.
        pub roller_length: Option<f64> = "roller_length_mm", LENGTH, Presence::Optional;
        /// Mean state: displacement of the inner ring.
        pub displacement: Option<RingDisplacement> = "displacement",
            Kind::Table(RingDisplacement::TABLE), Presence::Optional;
        /// Mean state: loads on the inner ring, which does not tilt.
        pub preload: Option<Preload> = "preload", Kind::Table(Preload::TABLE), Presence::Optional;
        /// Mean state: found from the torque, with the whole shaft.
        pub mean_load: Option<MeanLoad> = "mean_load", Kind::Word(MeanLoad::WORDS), Presence::Optional;
        /// With a mean load from torque: axial approach of the rings at assembly, in the bearing's own loaded direction.
        pub mounting_preload: f64 = "mounting_preload_um", PRELOAD, ZERO;
    }

    /// How far the inner ring stands from where it would without load; x, y (axial) and z as everywhere.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    pub struct RingDisplacement as "displacement" {
        /// Along x.
        pub x: f64 = "x_um", Kind::Number(Quantity::Deflection, Limit::Any), ZERO;
        /// Along y, the shaft's axis.
        pub y: f64 = "y_um", Kind::Number(Quantity::Deflection, Limit::Any), ZERO;
        /// Along z.
        pub z: f64 = "z_um", Kind::Number(Quantity::Deflection, Limit::Any), ZERO;
        /// Tilt about x.
        pub rx: f64 = "rx_mrad", Kind::Number(Quantity::Tilt, Limit::Any), ZERO;
        /// Tilt about z.
        pub rz: f64 = "rz_mrad", Kind::Number(Quantity::Tilt, Limit::Any), ZERO;
    }

    /// Mean loads on the inner ring, its tilts held.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    pub struct Preload as "preload" {
        /// Along x.
        pub x: f64 = "x_n", Kind::Number(Quantity::Force, Limit::Any), ZERO;
        /// Along y, the shaft's axis.
        pub y: f64 = "y_n", Kind::Number(Quantity::Force, Limit::Any), ZERO;
        /// Along z.
        pub z: f64 = "z_n", Kind::Number(Quantity::Force, Limit::Any), ZERO;
    }
}

words! {
    /// Where the mean load of a bearing comes from.
    pub enum MeanLoad {
        FromTorque = "from-torque",
    }
}

impl BearingModel {
    /// Whether the mean state follows from the torque.
    pub fn follows_torque(&self) -> bool {
        let mean_load = match self {
            Self::Ball(ball) => ball.mean_load,
            Self::Roller(roller) => roller.mean_load,
            _ => None,
        };
        mean_load.is_some()
    }

    /// Where the mean state comes from, in a word: `torque`, `preload` or `given` as a displacement; nothing where no load counts.
    pub fn loaded_by(&self) -> Option<&'static str> {
        let state = match self {
            Self::Ball(ball) => ball.mean_state(),
            Self::Roller(roller) => roller.mean_state(),
            _ => None,
        };
        state.map(|state| match state {
            MeanState::FromTorque(_) => "torque",
            MeanState::Preload(_) => "preload",
            MeanState::Displacement(_) => "given",
        })
    }
}

impl Design {
    /// Whether a bearing's stiffness depends on the torque.
    pub fn follows_torque(&self) -> bool {
        [&self.pinion, &self.gear].into_iter().flat_map(|rotor| &rotor.bearings).any(|one| one.model.follows_torque())
    }
}

/// The mean state of a ball or roller bearing as the design gives it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MeanState {
    Displacement(RingDisplacement),
    Preload(Preload),
    /// From the torque, with this axial approach of the rings at assembly, m
    FromTorque(f64),
}

impl BallBearing {
    /// The bearing that can be computed with.
    ///
    /// # Errors
    ///
    /// [`bearing::BadInput`] names what no bearing has; a design that was read has no such thing.
    pub fn bearing(&self) -> Result<bearing::Bearing, bearing::BadInput> {
        let given = |value: Option<f64>| value.unwrap_or(f64::NAN);
        let geometry = bearing::BallGeometry {
            ball_diameter: given(self.ball_diameter),
            pitch_diameter: given(self.pitch_diameter),
            inner_groove_factor: given(self.inner_groove_factor),
            outer_groove_factor: given(self.outer_groove_factor),
            contact_angle: self.contact_angle,
        };
        bearing::Bearing::new(bearing::Data {
            elements: self.elements,
            contact_angle: self.contact_angle,
            clearance: self.clearance,
            radius: self.pitch_radius.unwrap_or_else(|| geometry.radius()),
            contact_stiffness: self.contact_stiffness.unwrap_or_else(|| geometry.contact_stiffness()),
            kind: bearing::Kind::Ball {
                groove_distance: self.groove_distance.unwrap_or_else(|| geometry.groove_distance()),
            },
        })
    }

    /// Nothing where the design gives none or several.
    pub fn mean_state(&self) -> Option<MeanState> {
        mean_state(self.displacement, self.preload, self.mean_load, self.mounting_preload)
    }
}

impl RollerBearing {
    /// The bearing that can be computed with.
    ///
    /// # Errors
    ///
    /// [`bearing::BadInput`] names what no bearing has; a design that was read has no such thing.
    pub fn bearing(&self) -> Result<bearing::Bearing, bearing::BadInput> {
        let steel = || self.roller_length.map_or(f64::NAN, bearing::roller_contact_stiffness);
        bearing::Bearing::new(bearing::Data {
            elements: self.elements,
            contact_angle: self.contact_angle,
            clearance: self.clearance,
            radius: self.pitch_radius,
            contact_stiffness: self.contact_stiffness.unwrap_or_else(steel),
            kind: bearing::Kind::Roller { length: self.roller_length.unwrap_or(0.0) },
        })
    }

    /// Nothing where the design gives none or several.
    pub fn mean_state(&self) -> Option<MeanState> {
        mean_state(self.displacement, self.preload, self.mean_load, self.mounting_preload)
    }
}

fn mean_state(
    displacement: Option<RingDisplacement>,
    preload: Option<Preload>,
    mean_load: Option<MeanLoad>,
    mounting_preload: f64,
) -> Option<MeanState> {
    match (displacement, preload, mean_load) {
        (Some(displacement), None, None) => Some(MeanState::Displacement(displacement)),
        (None, Some(preload), None) => Some(MeanState::Preload(preload)),
        (None, None, Some(MeanLoad::FromTorque)) => Some(MeanState::FromTorque(mounting_preload)),
        _ => None,
    }
}
