//! What a design says, as typed values in SI units: m, N/m, N m/rad, kg, kg m^2, Pa, kg/m^3, Hz.
//!
//! Each field is declared here once, with its key in files, its quantity (which gives the file's unit), its limits and
//! what happens where it is not written.

use std::collections::BTreeMap;

use super::geometry::MeshGeometry;
use super::rotor::RotorDesign;
use super::schema::{Field, Kind, Limit, Presence, Written};
use crate::units::Quantity;

/// The newest format of design files that is understood.
pub const FORMAT: u64 = 1;

tables! {
    /// A pair of geared rotors with everything needed to solve it.
    /// A `Design` that came out of [`read`](super::read()) has passed every check that needs no mechanics.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Design as "design" {
        /// Name of the design.
        pub name: String = "name", Kind::Name, Presence::Required;
        /// What the design is about.
        pub description: Option<String> = "description", Kind::Text, Presence::Optional;
        /// Words to find it by.
        pub tags: Vec<String> = "tags", Kind::Texts, Presence::Default(Written::Empty);
        /// File stem of the design that this variant came from.
        pub parent: Option<String> = "parent", Kind::Text, Presence::Optional;
        /// Whatever is worth remembering.
        pub note: Option<String> = "note", Kind::Text, Presence::Optional;
        /// Frequency lines, damping and beam theory.
        pub analysis: Analysis = "analysis", Kind::Table(Analysis::TABLE), Presence::Default(Written::Empty);
        /// Materials by name; `steel` is always there.
        pub materials: BTreeMap<String, Material> = "material",
            Kind::NamedTables(Material::TABLE), Presence::Default(Written::Empty);
        /// Torque and speed of the pinion.
        pub operating: Option<Operating> = "operating", Kind::Table(Operating::TABLE), Presence::Optional;
        /// The tooth mesh.
        pub mesh: Mesh = "mesh", Kind::Table(Mesh::TABLE), Presence::Required;
        /// The driving rotor.
        pub pinion: RotorDesign = "pinion", Kind::Table(RotorDesign::TABLE), Presence::Required;
        /// The driven rotor.
        pub gear: RotorDesign = "gear", Kind::Table(RotorDesign::TABLE), Presence::Required;
    }
    also Field {
        name: "",
        key: "format",
        doc: "Number of the file format.",
        kind: Kind::Whole(1, FORMAT),
        presence: Presence::Required,
    };

    /// The mean state that the gearbox runs in.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Operating as "operating" {
        /// Mean torque of the pinion; its size loads the bearings, the line of action says which way.
        pub pinion_torque: Option<f64> = "pinion_torque_n_m", Kind::Number(Quantity::Torque, Limit::Any), Presence::Optional;
        /// Speed of the pinion: marks the mesh frequency and its harmonics.
        pub pinion_speed: Option<f64> = "pinion_speed_rpm",
            Kind::Number(Quantity::Speed, Limit::NotNegative), Presence::Optional;
    }

    /// The frequency lines, the damping and the beam theory.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Analysis as "analysis" {
        /// Lowest line.
        pub frequency_min: f64 = "frequency_min_hz",
            Kind::Number(Quantity::Frequency, Limit::Positive), Presence::Default(Written::Number(10.0));
        /// Highest line.
        pub frequency_max: f64 = "frequency_max_hz",
            Kind::Number(Quantity::Frequency, Limit::Positive), Presence::Default(Written::Number(5000.0));
        /// Number of lines, both ends included.
        pub frequency_lines: usize = "frequency_lines",
            Kind::Whole(2, 1_000_000), Presence::Default(Written::Whole(1000));
        /// How the lines are spread.
        pub frequency_spacing: FrequencySpacing = "frequency_spacing",
            Kind::Word(FrequencySpacing::WORDS), Presence::Default(Written::Text("linear"));
        /// Damping of shafts and bearings: a loss factor, or seconds where the damping is viscous.
        pub structural_damping: f64 = "structural_damping",
            Kind::Number(Quantity::Damping, Limit::NotNegative), Presence::Default(Written::Number(0.03));
        /// How the damping ratios act.
        pub damping_model: DampingModel = "damping_model",
            Kind::Word(DampingModel::WORDS), Presence::Default(Written::Text("hysteretic"));
        /// Theory of the beam elements.
        pub beam_theory: BeamTheory = "beam_theory",
            Kind::Word(BeamTheory::WORDS), Presence::Default(Written::Text("timoshenko"));
    }

    /// An isotropic elastic material.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct Material as "material" {
        /// Young's modulus.
        pub youngs_modulus: f64 = "youngs_modulus_gpa",
            Kind::Number(Quantity::ElasticModulus, Limit::Positive), Presence::DefaultIn(STEEL, Written::Number(206.0));
        /// Poisson's ratio.
        pub poissons_ratio: f64 = "poissons_ratio",
            Kind::Number(Quantity::Ratio, Limit::Between(-1.0, 0.5)), Presence::DefaultIn(STEEL, Written::Number(0.3));
        /// Density.
        pub density: f64 = "density_kg_per_m3",
            Kind::Number(Quantity::Density, Limit::Positive), Presence::DefaultIn(STEEL, Written::Number(7850.0));
    }

    /// The tooth mesh: one averaged spring along the line of action.
    #[derive(Debug, Clone, PartialEq)]
    pub struct Mesh as "mesh" {
        /// Mesh stiffness along the line of action.
        pub stiffness: f64 = "stiffness_n_per_m",
            Kind::Number(Quantity::Stiffness, Limit::Positive), Presence::Required;
        /// Mesh damping: a loss factor, or seconds where the damping is viscous.
        pub damping: f64 = "damping", Kind::Number(Quantity::Damping, Limit::NotNegative), Presence::Required;
        /// Amplitude e of the static transmission error.
        pub transmission_error: f64 = "transmission_error_um",
            Kind::Number(Quantity::Deflection, Limit::Positive), Presence::Required;
        /// The mesh in the pinion's frame.
        pub pinion: MeshVectors = "pinion", Kind::Table(MeshVectors::TABLE), Presence::Unless("geometry");
        /// The mesh in the gear's frame.
        pub gear: MeshVectors = "gear", Kind::Table(MeshVectors::TABLE), Presence::Unless("geometry");
        /// Gear data in place of the mesh vectors, which follow from them.
        pub geometry: Option<MeshGeometry> = "geometry", Kind::Table(MeshGeometry::TABLE), Presence::Optional;
    }

    /// Mesh point and line of action in one shaft's own frame (x, y along the shaft, z).
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct MeshVectors as "mesh side" {
        /// Mesh point relative to the mesh station.
        pub point: [f64; 3] = "point_mm", Kind::Vector(Quantity::Length), Presence::Required;
        /// Unit vector of the mesh force on the gear, in this side's frame.
        pub line_of_action: [f64; 3] = "line_of_action", Kind::Vector(Quantity::Ratio), Presence::Required;
    }
}

/// The material that exists without being written.
pub const STEEL: &str = "steel";

words! {
    /// How the frequency lines are spread between lowest and highest.
    pub enum FrequencySpacing {
        Linear = "linear",
        Log = "log",
    }

    /// How the damping ratios act (Hua et al. 2012, eqs. 11-14): K (1 + j zeta) with zeta a loss factor, or K (1 + j w zeta)
    /// with zeta in seconds.
    pub enum DampingModel {
        Hysteretic = "hysteretic",
        Viscous = "viscous",
    }

    /// Theory of the beam elements.
    pub enum BeamTheory {
        EulerBernoulli = "euler-bernoulli",
        Timoshenko = "timoshenko",
    }
}

impl Material {
    /// Shear modulus G = E / (2 (1 + nu)), Pa.
    pub fn shear_modulus(&self) -> f64 {
        self.youngs_modulus / (2.0 * (1.0 + self.poissons_ratio))
    }
}
