//! Designs for tests: a few by hand, and random ones with shrinking.
//!
//! ```ignore
//! mod support;
//! proptest! {
//!     #[test]
//!     fn holds(design in support::random::designs()) { ... }
//! }
//! ```
//!
//! - [`steel_shaft`], [`disc`], [`spring`], [`rigid`], [`rotor`], [`design`]: building blocks with plain arguments, for tests of
//!   published examples.
//! - [`random`]: valid designs within two decades of an automotive final drive, everything the solver distinguishes included.
//! - [`nonsense`]: everything solved, and nothing in it infinite or not a number.
//! - [`dense`]: the whole model in one matrix, solved without any of the program's shortcuts.
//! - [`spectra`]: few lines, and how far two spectra are apart.
#![allow(dead_code, reason = "each test binary uses its own part")]
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

pub mod dense;
pub mod nonsense;
pub mod random;
pub mod spectra;

use std::collections::BTreeMap;

use bevelscope::design::{
    Analysis, BeamTheory, Bearing, BearingModel, Body, DampingModel, Design, DiagonalBearing, Drive, FrequencySpacing,
    Hold, Material, Mesh, MeshVectors, RotorDesign, Segment,
};

/// Steel of Friswell et al. (2010), example 5.9.1: E = 211 GPa, G = 81.2 GPa, 7810 kg/m^3.
pub const FRISWELL_STEEL: Material =
    Material { youngs_modulus: 211e9, poissons_ratio: 211.0 / (2.0 * 81.2) - 1.0, density: 7810.0 };

/// A solid uniform piece of "steel".
pub fn steel_shaft(length: f64, diameter: f64, elements: usize) -> Segment {
    Segment { length, outer_diameter: diameter, inner_diameter: 0.0, material: "steel".to_owned(), elements }
}

pub fn disc(position: f64, mass: f64, diametral_inertia: f64, polar_inertia: f64) -> Body {
    Body { name: format!("disc at {position}"), position, mass, diametral_inertia, polar_inertia }
}

/// Five springs in the order kx, ky, kz, krx, krz.
pub fn spring(position: f64, [kx, ky, kz, krx, krz]: [f64; 5]) -> Bearing {
    bearing(position, BearingModel::Diagonal(DiagonalBearing { kx, ky, kz, krx, krz }))
}

/// Holds x, y, z as asked.
pub fn rigid(position: f64, [x, y, z]: [bool; 3]) -> Bearing {
    bearing(position, BearingModel::Rigid(Hold { x, y, z }))
}

pub fn bearing(position: f64, model: BearingModel) -> Bearing {
    Bearing { name: format!("bearing at {position}"), position, axial_series_stiffness: None, model }
}

/// A rotor with a soft drive at its end and the mesh at its start.
pub fn rotor(segments: Vec<Segment>, bodies: Vec<Body>, bearings: Vec<Bearing>) -> RotorDesign {
    let length = segments.iter().map(|segment| segment.length).sum();
    RotorDesign {
        teeth: None,
        mesh_position: 0.0,
        housing_axial_stiffness: None,
        segments,
        bodies,
        bearings,
        drive: Some(Drive { position: length, torsional_stiffness: 1e4, inertia: 0.02 }),
    }
}

/// Two rotors whose mesh points stand on z, with a line of action that moves everything.
pub fn design(theory: BeamTheory, steel: Material, pinion: RotorDesign, gear: RotorDesign) -> Design {
    let (n1, n2) = ([0.76975, -0.62285, 0.13980], [-0.76975, 0.13980, -0.62285]);
    Design {
        name: "test".to_owned(),
        description: None,
        tags: Vec::new(),
        parent: None,
        note: None,
        operating: None,
        analysis: Analysis {
            frequency_min: 10.0,
            frequency_max: 4000.0,
            frequency_lines: 400,
            frequency_spacing: FrequencySpacing::Linear,
            structural_damping: 0.03,
            damping_model: DampingModel::Hysteretic,
            beam_theory: theory,
        },
        materials: BTreeMap::from([("steel".to_owned(), steel)]),
        mesh: Mesh {
            stiffness: 6.4e8,
            damping: 0.06,
            transmission_error: 5e-6,
            pinion: MeshVectors { point: [0.0, 0.0, 0.027_459_5], line_of_action: unit(n1) },
            gear: MeshVectors { point: [0.0, 0.0, 0.076_493_6], line_of_action: unit(n2) },
            geometry: None,
        },
        pinion,
        gear,
    }
}

pub fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

/// An ordinary design with elastic bearings: the base that single faults are put into.
pub fn ordinary() -> Design {
    let pinion = RotorDesign {
        mesh_position: 0.018,
        ..rotor(
            vec![steel_shaft(0.055, 0.044, 2), steel_shaft(0.115, 0.036, 3)],
            vec![disc(0.018, 0.6, 3e-4, 2.6e-4)],
            vec![spring(0.055, [6e8, 2.5e8, 6e8, 1.5e5, 1.5e5]), spring(0.13, [5e8, 1.8e8, 5e8, 8e4, 8e4])],
        )
    };
    let gear = RotorDesign {
        mesh_position: 0.025,
        ..rotor(
            vec![steel_shaft(0.11, 0.06, 2), steel_shaft(0.15, 0.05, 3)],
            vec![disc(0.025, 3.67, 6e-3, 1.1e-2), disc(0.06, 5.0, 9e-3, 1.1e-2)],
            vec![spring(0.11, [7e8, 2.2e8, 7e8, 2e5, 2e5]), spring(0.22, [6e8, 2.2e8, 6e8, 1.6e5, 1.6e5])],
        )
    };
    design(BeamTheory::Timoshenko, FRISWELL_STEEL, pinion, gear)
}

/// `|a - b| <= tolerance |b|`, with the figures where it fails.
#[track_caller]
pub fn assert_close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs() / expected.abs();
    assert!(error <= tolerance, "{what}: {found} instead of {expected}, off by {error:.3e}, allowed {tolerance:.1e}");
}
