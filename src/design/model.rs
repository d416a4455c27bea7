//! What a design says, as typed values in SI units.

use std::collections::BTreeMap;

/// A pair of geared rotors with everything needed to solve it.
///
/// A `Design` that came out of [`read`](super::read) has passed every check that needs no mechanics.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    pub name: String,
    pub description: Option<String>,
    pub tags: Vec<String>,
    /// File stem of the design this variant came from.
    pub parent: Option<String>,
    pub note: Option<String>,
    pub analysis: Analysis,
    /// By name; `steel` is always there.
    pub materials: BTreeMap<String, Material>,
    pub mesh: Mesh,
    pub pinion: RotorDesign,
    pub gear: RotorDesign,
}

/// The frequency lines, the damping and the beam theory.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    /// Lowest line, Hz.
    pub frequency_min: f64,
    /// Highest line, Hz.
    pub frequency_max: f64,
    /// Number of lines, both ends included; at least 2.
    pub frequency_lines: usize,
    pub frequency_spacing: FrequencySpacing,
    /// zeta_s: a loss factor, or seconds where the damping is viscous.
    pub structural_damping: f64,
    pub damping_model: DampingModel,
    pub beam_theory: BeamTheory,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrequencySpacing {
    Linear,
    Log,
}

/// How the damping ratios act (Hua et al. 2012, eqs. 11-14).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DampingModel {
    /// K (1 + j zeta): zeta is a loss factor.
    Hysteretic,
    /// K (1 + j w zeta): zeta is in seconds.
    Viscous,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BeamTheory {
    EulerBernoulli,
    Timoshenko,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Pa
    pub youngs_modulus: f64,
    pub poissons_ratio: f64,
    /// kg/m^3
    pub density: f64,
}

impl Material {
    /// Shear modulus G = E / (2 (1 + nu)), Pa.
    pub fn shear_modulus(&self) -> f64 {
        self.youngs_modulus / (2.0 * (1.0 + self.poissons_ratio))
    }
}

/// The tooth mesh: one averaged spring along the line of action.
#[derive(Debug, Clone, PartialEq)]
pub struct Mesh {
    /// k_m, N/m
    pub stiffness: f64,
    /// zeta_m, as [`Analysis::structural_damping`]
    pub damping: f64,
    /// Amplitude e of the static transmission error, m
    pub transmission_error: f64,
    pub pinion: MeshVectors,
    pub gear: MeshVectors,
}

/// Mesh point and line of action in one shaft's own frame (x, y along the shaft, z).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshVectors {
    /// Relative to the mesh station, m
    pub point: [f64; 3],
    /// Unit vector
    pub line_of_action: [f64; 3],
}

/// One shaft with what sits on it.
#[derive(Debug, Clone, PartialEq)]
pub struct RotorDesign {
    pub teeth: Option<u32>,
    /// Where the mesh acts: the lumped point, m from the shaft's start
    pub mesh_position: f64,
    /// Khb of the housing bolt, N/m
    pub housing_axial_stiffness: Option<f64>,
    pub segments: Vec<Segment>,
    pub bodies: Vec<Body>,
    pub bearings: Vec<Bearing>,
    pub drive: Drive,
}

impl RotorDesign {
    /// Length of the shaft, m.
    pub fn length(&self) -> f64 {
        self.segments.iter().map(|segment| segment.length).sum()
    }
}

/// A cylindrical piece of a shaft.
#[derive(Debug, Clone, PartialEq)]
pub struct Segment {
    /// m
    pub length: f64,
    /// m
    pub outer_diameter: f64,
    /// m; 0 where the piece is solid
    pub inner_diameter: f64,
    /// A key of [`Design::materials`]
    pub material: String,
    /// How many beam elements of equal length it is split in; at least 1
    pub elements: usize,
}

/// A rigid body on the shaft: pinion head, ring gear, differential.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Unique within the rotor
    pub name: String,
    /// m
    pub position: f64,
    /// kg
    pub mass: f64,
    /// kg m^2
    pub diametral_inertia: f64,
    /// kg m^2
    pub polar_inertia: f64,
}

#[derive(Debug, Clone, PartialEq)]
pub struct Bearing {
    /// Unique within the rotor
    pub name: String,
    /// m
    pub position: f64,
    /// Kc: a spring in series with the bearing's axial stiffness, N/m
    pub axial_series_stiffness: Option<f64>,
    pub model: BearingModel,
}

#[derive(Debug, Clone, PartialEq)]
#[expect(clippy::large_enum_variant, reason = "a rotor has a handful of bearings")]
pub enum BearingModel {
    /// Five independent springs.
    Diagonal(DiagonalBearing),
    /// 6x6 in the order x, y, z, thx, thy, thz (N/m, N, N m/rad); symmetric, positive semidefinite, thy zero.
    Matrix([[f64; 6]; 6]),
    /// Translations that are held.
    Rigid(Hold),
}

#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct DiagonalBearing {
    /// N/m
    pub kx: f64,
    /// N/m, along the shaft
    pub ky: f64,
    /// N/m
    pub kz: f64,
    /// N m/rad
    pub krx: f64,
    /// N m/rad
    pub krz: f64,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Hold {
    pub x: bool,
    pub y: bool,
    pub z: bool,
}

/// Engine or load: an inertia behind a torsional spring.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drive {
    /// m
    pub position: f64,
    /// N m/rad
    pub torsional_stiffness: f64,
    /// kg m^2
    pub inertia: f64,
}
