//! One shaft of a design and what sits on it, in SI units. Declared like the rest of the [model](super::model).

use super::rolling::{BallBearing, RollerBearing};
use super::schema::{Kind, Limit, Presence, Variant, Written};
use crate::units::Quantity;

const ZERO: Presence = Presence::Default(Written::Number(0.0));

tables! {
    /// One shaft with what sits on it.
    #[derive(Debug, Clone, PartialEq)]
    pub struct RotorDesign as "rotor" {
        /// Number of teeth.
        pub teeth: Option<u32> = "teeth", Kind::Whole(1, u32::MAX as u64), Presence::Optional;
        /// Where the mesh acts, from the shaft's start: the lumped point.
        pub mesh_position: f64 = "mesh_position_mm", Kind::Number(Quantity::Length, Limit::Any), Presence::Required;
        /// Axial stiffness Khb of the housing bolt, in series with all bearings.
        pub housing_axial_stiffness: Option<f64> = "housing_axial_stiffness_n_per_m",
            Kind::Number(Quantity::Stiffness, Limit::Positive), Presence::Optional;
        /// Pieces of the shaft from its start on, in order.
        pub segments: Vec<Segment> = "segment", Kind::Tables(Segment::TABLE, 1), Presence::Required;
        /// Rigid bodies on the shaft.
        pub bodies: Vec<Body> = "body", Kind::Tables(Body::TABLE, 0), Presence::Default(Written::Empty);
        /// Bearings of the shaft.
        pub bearings: Vec<Bearing> = "bearing", Kind::Tables(Bearing::TABLE, 1), Presence::Required;
        /// Engine (pinion) or load (gear); without it the shaft's end turns freely.
        pub drive: Option<Drive> = "drive", Kind::Table(Drive::TABLE), Presence::Optional;
    }

    /// A cylindrical piece of a shaft.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Segment as "segment" {
        /// Length.
        pub length: f64 = "length_mm", Kind::Number(Quantity::Length, Limit::Positive), Presence::Required;
        /// Outer diameter.
        pub outer_diameter: f64 = "outer_diameter_mm",
            Kind::Number(Quantity::Length, Limit::Positive), Presence::Required;
        /// Inner diameter; 0 where the piece is solid.
        pub inner_diameter: f64 = "inner_diameter_mm", Kind::Number(Quantity::Length, Limit::NotNegative), ZERO;
        /// Name of the material.
        pub material: String = "material", Kind::Name, Presence::Default(Written::Text(super::model::STEEL));
        /// Beam elements of equal length it is split in; a shaft has 400 stations at most.
        pub elements: usize = "elements", Kind::Whole(1, u64::MAX), Presence::Default(Written::Whole(1));
    }

    /// A rigid body on the shaft: pinion head, ring gear, differential.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Body as "body" {
        /// Name, unique within the rotor.
        pub name: String = "name", Kind::Name, Presence::Default(Written::ByPlace("body "));
        /// Where it sits, from the shaft's start.
        pub position: f64 = "position_mm", Kind::Number(Quantity::Length, Limit::Any), Presence::Required;
        /// Mass.
        pub mass: f64 = "mass_kg", Kind::Number(Quantity::Mass, Limit::NotNegative), Presence::Required;
        /// Mass moment of inertia about any diameter.
        pub diametral_inertia: f64 = "diametral_inertia_kg_m2",
            Kind::Number(Quantity::Inertia, Limit::NotNegative), Presence::Required;
        /// Mass moment of inertia about the shaft's axis.
        pub polar_inertia: f64 = "polar_inertia_kg_m2",
            Kind::Number(Quantity::Inertia, Limit::NotNegative), Presence::Required;
    }

    /// A bearing between shaft and ground.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Bearing as "bearing" {
        /// Name, unique within the rotor.
        pub name: String = "name", Kind::Name, Presence::Default(Written::ByPlace("B"));
        /// Where it sits, from the shaft's start.
        pub position: f64 = "position_mm", Kind::Number(Quantity::Length, Limit::Any), Presence::Required;
        /// Kc: a spring in series with the bearing's axial stiffness.
        pub axial_series_stiffness: Option<f64> = "axial_series_stiffness_n_per_m",
            Kind::Number(Quantity::Stiffness, Limit::Positive), Presence::Optional;
        /// Kind of the bearing; it decides the other keys.
        pub model: BearingModel = "model",
            Kind::Variant(BearingModel::VARIANTS), Presence::Default(Written::Text("diagonal"));
    }

    /// Five independent springs.
    #[derive(Debug, Clone, Copy, PartialEq, Default)]
    pub struct DiagonalBearing as "diagonal bearing" {
        /// Stiffness along x.
        pub kx: f64 = "kx_n_per_m", Kind::Number(Quantity::Stiffness, Limit::NotNegative), ZERO;
        /// Stiffness along y, the shaft's axis.
        pub ky: f64 = "ky_n_per_m", Kind::Number(Quantity::Stiffness, Limit::NotNegative), ZERO;
        /// Stiffness along z.
        pub kz: f64 = "kz_n_per_m", Kind::Number(Quantity::Stiffness, Limit::NotNegative), ZERO;
        /// Stiffness against tilting about x.
        pub krx: f64 = "krx_n_m_per_rad", Kind::Number(Quantity::AngularStiffness, Limit::NotNegative), ZERO;
        /// Stiffness against tilting about z.
        pub krz: f64 = "krz_n_m_per_rad", Kind::Number(Quantity::AngularStiffness, Limit::NotNegative), ZERO;
    }

    /// A full stiffness matrix.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct MatrixBearing as "matrix bearing" {
        /// Six rows in the order x, y, z, thx, thy, thz (N/m, N, N/rad, N m/rad): symmetric, positive semidefinite, thy zero.
        pub stiffness: [[f64; 6]; 6] = "stiffness", Kind::Matrix, Presence::Required;
    }

    /// Translations that are held: simply supported.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct RigidBearing as "rigid bearing" {
        /// Which of the three translations are held.
        pub hold: Hold = "hold", Kind::Words(Hold::WORDS), Presence::Required;
    }

    /// Engine or load: an inertia behind a torsional spring.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Drive as "drive" {
        /// Where it is coupled, from the shaft's start.
        pub position: f64 = "position_mm", Kind::Number(Quantity::Length, Limit::Any), Presence::Required;
        /// Torsional stiffness of the coupling.
        pub torsional_stiffness: f64 = "torsional_stiffness_n_m_per_rad",
            Kind::Number(Quantity::AngularStiffness, Limit::Positive), Presence::Required;
        /// Mass moment of inertia about the shaft's axis.
        pub inertia: f64 = "inertia_kg_m2", Kind::Number(Quantity::Inertia, Limit::Positive), Presence::Required;
    }
}

/// How a bearing carries the shaft.
#[derive(Debug, Clone, PartialEq)]
pub enum BearingModel {
    /// Five independent springs.
    Diagonal(DiagonalBearing),
    /// 6x6 in the order x, y, z, thx, thy, thz (N/m, N, N/rad, N m/rad); symmetric, positive semidefinite, thy zero.
    Matrix([[f64; 6]; 6]),
    /// Translations that are held.
    Rigid(Hold),
    /// Balls between two grooves, at a mean state.
    Ball(BallBearing),
    /// Rollers between two raceways, at a mean state.
    Roller(RollerBearing),
}

impl BearingModel {
    /// The words of `model` and the keys that come with each.
    pub const VARIANTS: &'static [Variant] = &[
        Variant { word: "diagonal", table: DiagonalBearing::TABLE },
        Variant { word: "matrix", table: MatrixBearing::TABLE },
        Variant { word: "rigid", table: RigidBearing::TABLE },
        Variant { word: "ball", table: BallBearing::TABLE },
        Variant { word: "roller", table: RollerBearing::TABLE },
    ];

    /// The word of design files.
    pub fn word(&self) -> &'static str {
        match self {
            Self::Diagonal(_) => "diagonal",
            Self::Matrix(_) => "matrix",
            Self::Rigid(_) => "rigid",
            Self::Ball(_) => "ball",
            Self::Roller(_) => "roller",
        }
    }
}

/// Which translations a rigid bearing holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Hold {
    pub x: bool,
    pub y: bool,
    pub z: bool,
}

impl Hold {
    /// The words of `hold`.
    pub const WORDS: &'static [&'static str] = &["x", "y", "z"];
}

impl RotorDesign {
    /// Which series springs the stiffness of a bearing is with, as words behind its name; empty where the design has none.
    pub fn springs_of(&self, bearing: usize) -> &'static str {
        let has_kc = self.bearings.get(bearing).is_some_and(|bearing| bearing.axial_series_stiffness.is_some());
        match (has_kc, self.housing_axial_stiffness.is_some()) {
            (true, true) => " with Kc, before Khb",
            (true, false) => " with Kc",
            (false, true) => " before Khb",
            (false, false) => "",
        }
    }

    /// Length of the shaft, m.
    pub fn length(&self) -> f64 {
        self.segments.iter().map(|segment| segment.length).sum()
    }
}
