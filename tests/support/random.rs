//! Random valid designs.
//!
//! Sizes, stiffnesses and inertias lie within two decades of an automotive final drive. Everything the solver tells apart occurs: two to
//! five segments, solid or hollow, of two materials; two or three bearings, diagonal, full 6x6 or rigid; Kc, Khb where it is legal;
//! bodies; both beam theories, both damping models, both line spacings; the mesh and the drive anywhere, on stations of other things
//! too; a rotor without a drive. No element is shorter than a fifth of its diameter.

use bevelscope::design::{
    Analysis, BallBearing, BeamTheory, Bearing, BearingModel, Body, DampingModel, Design, DiagonalBearing, Drive,
    FrequencySpacing, Hold, Material, Mesh, MeshVectors, Preload, RollerBearing, RotorDesign, Segment,
};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, RngSeed};

use super::{FRISWELL_STEEL, design, unit};

/// The same designs every time.
pub fn config(cases: u32) -> ProptestConfig {
    ProptestConfig {
        cases,
        rng_seed: RngSeed::Fixed(1),
        rng_algorithm: RngAlgorithm::ChaCha,
        failure_persistence: None,
        max_shrink_iters: 200,
        ..ProptestConfig::default()
    }
}

/// How the bearings of a rotor are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mounting {
    /// Any mixture
    Any,
    /// Diagonal bearings with kx = kz and krx = krz, or rigid ones that hold x and z: every direction across the shaft is alike
    Isotropic,
    /// Elastic bearings only
    Elastic,
    /// Angular contact ball and tapered roller bearings under preload
    Rolling,
}

/// Designs with any bearings.
pub fn designs() -> impl Strategy<Value = Design> {
    designs_on(Mounting::Any)
}

/// Designs with bearings of one kind.
pub fn designs_on(mounting: Mounting) -> impl Strategy<Value = Design> {
    let scale = |low: f64, high: f64| log_range(low, high);
    let materials = (100e9..220e9, 0.2..0.35, 2700.0..8000.0);
    let vectors = || (direction(), [-0.1..0.1, -0.03..0.03, -0.1..0.1]);
    (
        (rotors(mounting), rotors(mounting)),
        analyses(),
        materials,
        (scale(2e7, 2e9), 0.0..0.1, scale(1e-7, 1e-5)),
        (vectors(), vectors()),
    )
        .prop_map(|((pinion, gear), analysis, (e, nu, rho), (stiffness, damping, error), (p, g))| {
            let vectors = |(line_of_action, point): ([f64; 3], [f64; 3])| MeshVectors { point, line_of_action };
            let mesh_damping = match analysis.damping_model {
                DampingModel::Hysteretic => damping,
                DampingModel::Viscous => damping * 1e-4,
            };
            let mut out = design(analysis.beam_theory, FRISWELL_STEEL, pinion, gear);
            let second = Material { youngs_modulus: e, poissons_ratio: nu, density: rho };
            out.materials.insert("other".to_owned(), second);
            out.analysis = analysis;
            out.mesh = Mesh {
                stiffness,
                damping: mesh_damping,
                transmission_error: error,
                pinion: vectors(p),
                gear: vectors(g),
                geometry: None,
            };
            out
        })
}

/// A value whose logarithm is uniform.
pub fn log_range(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low.ln()..high.ln()).prop_map(f64::exp)
}

/// A unit vector in any direction.
fn direction() -> impl Strategy<Value = [f64; 3]> {
    [-1.0..1.0, -1.0..1.0, -1.0..1.0]
        .prop_filter("too short to have a direction", |v: &[f64; 3]| v.iter().map(|x| x * x).sum::<f64>() > 0.01)
        .prop_map(unit)
}

fn analyses() -> impl Strategy<Value = Analysis> {
    let theory = prop_oneof![Just(BeamTheory::EulerBernoulli), Just(BeamTheory::Timoshenko)];
    let spacing = prop_oneof![Just(FrequencySpacing::Linear), Just(FrequencySpacing::Log)];
    let damping = prop_oneof![
        (0.005..0.06).prop_map(|z| (DampingModel::Hysteretic, z)),
        (1e-7..1e-5).prop_map(|z| (DampingModel::Viscous, z)),
    ];
    (theory, spacing, damping, 2.0..50.0, 2000.0..6000.0, 2_usize..60).prop_map(
        |(beam_theory, frequency_spacing, (damping_model, structural_damping), low, high, lines)| Analysis {
            frequency_min: low,
            frequency_max: high,
            frequency_lines: lines,
            frequency_spacing,
            structural_damping,
            damping_model,
            beam_theory,
        },
    )
}

fn segments() -> impl Strategy<Value = Segment> {
    (0.02..0.14, 0.022..0.07, prop_oneof![Just(0.0), 0.2..0.75], any::<bool>(), 1_usize..4).prop_map(
        |(length, outer_diameter, bore, steel, elements): (f64, f64, f64, bool, usize)| Segment {
            length,
            outer_diameter,
            inner_diameter: bore * outer_diameter,
            material: if steel { "steel" } else { "other" }.to_owned(),
            elements: elements.min((length / (0.2 * outer_diameter)) as usize).max(1),
        },
    )
}

/// A place along a shaft, to be looked up in [`stands`]: things often share a station, and none cuts off a sliver.
fn places() -> impl Strategy<Value = usize> {
    0_usize..60
}

/// Where things may stand, m: the ends of elements, and the middles of those that can be halved.
fn stands(segments: &[Segment]) -> Vec<f64> {
    let mut out = vec![0.0];
    let mut start = 0.0;
    for segment in segments {
        let element = segment.length / segment.elements as f64;
        for i in 0..segment.elements {
            if element >= 0.4 * segment.outer_diameter {
                out.push(start + (i as f64 + 0.5) * element);
            }
            out.push(start + (i as f64 + 1.0) * element);
        }
        start += segment.length;
    }
    out
}

/// A rotor that its bearings hold, with bearings at two different places at least.
pub fn rotors(mounting: Mounting) -> impl Strategy<Value = RotorDesign> {
    let body = (places(), log_range(0.2, 10.0), log_range(0.01, 0.06), 1.0..1.9);
    let bearings = vec((places(), bearing_models(mounting), prop::option::weighted(0.25, log_range(2e8, 3e9))), 2..=3);
    (
        vec(segments(), 2..=5),
        vec(body, 0..=3),
        bearings,
        (places(), prop::option::weighted(0.85, places())),
        (log_range(2e3, 1e5), log_range(0.005, 0.5)),
        prop::option::weighted(0.3, log_range(1e8, 2e9)),
    )
        .prop_map(|(segments, bodies, bearings, (mesh, drive), (spring, inertia), housing)| {
            let stands = stands(&segments);
            let place = |at: usize| stands[at % stands.len()];
            let bodies = bodies.into_iter().enumerate().map(|(i, (at, mass, radius, ratio))| Body {
                name: format!("body {i}"),
                position: place(at),
                mass,
                diametral_inertia: mass * radius * radius,
                polar_inertia: ratio * mass * radius * radius,
            });
            let bearings = bearings.into_iter().enumerate().map(|(i, (at, model, series))| Bearing {
                name: format!("B{i}"),
                position: place(at),
                axial_series_stiffness: series,
                model,
            });
            let rotor = RotorDesign {
                teeth: None,
                mesh_position: place(mesh),
                housing_axial_stiffness: housing,
                segments,
                bodies: bodies.collect(),
                bearings: bearings.collect(),
                drive: drive.map(|at| Drive { position: place(at), torsional_stiffness: spring, inertia }),
            };
            legal(rotor)
        })
        .prop_filter("bearings too close together", |rotor| {
            let places = rotor.bearings.iter().map(|bearing| bearing.position);
            let (low, high) = places.fold((f64::INFINITY, 0.0_f64), |(l, h), p| (l.min(p), h.max(p)));
            high - low >= 0.2 * rotor.length()
        })
        .prop_filter("a rigid bearing at the mesh station", |rotor| {
            let mesh = rotor.mesh_position;
            !rotor.bearings.iter().any(|b| is_rigid(b) && (b.position - mesh).abs() < 1e-6)
        })
}

/// Makes a drawn rotor legal: one axial support at least, no Kc on a rigid bearing, Khb only where it is clear what rests on it.
fn legal(mut rotor: RotorDesign) -> RotorDesign {
    let mut axial_hold = false;
    for bearing in &mut rotor.bearings {
        if let BearingModel::Rigid(hold) = &mut bearing.model {
            bearing.axial_series_stiffness = None;
            hold.y &= !axial_hold;
            axial_hold |= hold.y;
        }
    }
    let elastic: f64 = rotor.bearings.iter().map(axial_stiffness).sum();
    if elastic == 0.0 && !axial_hold {
        match &mut rotor.bearings[0].model {
            BearingModel::Rigid(hold) => hold.y = true,
            BearingModel::Diagonal(k) => k.ky = 2e8,
            BearingModel::Matrix(_) | BearingModel::Ball(_) | BearingModel::Roller(_) => {}
        }
    } else if elastic > 0.0 && axial_hold {
        rotor.housing_axial_stiffness = None;
    }
    rotor
}

fn is_rigid(bearing: &Bearing) -> bool {
    matches!(bearing.model, BearingModel::Rigid(_))
}

fn axial_stiffness(bearing: &Bearing) -> f64 {
    match &bearing.model {
        BearingModel::Diagonal(k) => k.ky,
        BearingModel::Matrix(k) => k[1][1],
        BearingModel::Rigid(_) | BearingModel::Ball(_) | BearingModel::Roller(_) => 0.0,
    }
}

fn bearing_models(mounting: Mounting) -> BoxedStrategy<BearingModel> {
    let stiff = || log_range(5e7, 3e9);
    let axial = || prop_oneof![1 => Just(0.0), 3 => log_range(5e7, 1e9)];
    let tilt = || prop_oneof![1 => Just(0.0), 3 => log_range(5e3, 1e6)];
    let diagonal = (stiff(), axial(), stiff(), tilt(), tilt())
        .prop_map(|(kx, ky, kz, krx, krz)| BearingModel::Diagonal(DiagonalBearing { kx, ky, kz, krx, krz }));
    let isotropic = (stiff(), axial(), tilt())
        .prop_map(|(k, ky, kr)| BearingModel::Diagonal(DiagonalBearing { kx: k, ky, kz: k, krx: kr, krz: kr }));
    let hold = any::<bool>().prop_map(|y| BearingModel::Rigid(Hold { x: true, y, z: true }));
    match mounting {
        Mounting::Any => prop_oneof![2 => diagonal, 2 => full_matrices(), 1 => hold].boxed(),
        Mounting::Isotropic => prop_oneof![3 => isotropic, 1 => hold].boxed(),
        Mounting::Elastic => prop_oneof![diagonal, full_matrices()].boxed(),
        Mounting::Rolling => rolling().boxed(),
    }
}

/// Bearings of 35 x 72 mm, give or take, whose thrust points one way or the other.
fn rolling() -> impl Strategy<Value = BearingModel> {
    let loads = (any::<bool>(), log_range(1000.0, 10_000.0), -0.2..0.2, -0.2..0.2);
    let preload = |(opposite, y, x, z): (bool, f64, f64, f64)| {
        (if opposite { -1.0 } else { 1.0 }, Preload { x: x * y, y: if opposite { -y } else { y }, z: z * y })
    };
    (any::<bool>(), 15.0..40.0_f64, loads, 8_usize..20).prop_map(move |(is_ball, angle, loads, elements)| {
        let (sign, preload) = preload(loads);
        let contact_angle = sign * angle.to_radians();
        if is_ball {
            BearingModel::Ball(BallBearing {
                elements,
                contact_angle,
                clearance: 0.0,
                contact_stiffness: Some(8.5e9),
                groove_distance: Some(4.5e-4),
                pitch_radius: Some(0.027),
                ball_diameter: None,
                pitch_diameter: None,
                inner_groove_factor: None,
                outer_groove_factor: None,
                displacement: None,
                preload: Some(preload),
                mean_load: None,
                mounting_preload: 0.0,
            })
        } else {
            BearingModel::Roller(RollerBearing {
                elements,
                contact_angle,
                clearance: 0.0,
                pitch_radius: 0.0275,
                contact_stiffness: Some(9.6e8),
                roller_length: Some(0.017),
                displacement: None,
                preload: Some(preload),
                mean_load: None,
                mounting_preload: 0.0,
            })
        }
    })
}

/// B B^T over five coordinates, in the units of a bearing: positive definite, all couplings present, thy free.
fn full_matrices() -> impl Strategy<Value = BearingModel> {
    let entries = vec(-0.6..0.6, 25);
    (entries, log_range(1e8, 2e9), 0.01..0.03).prop_map(|(b, stiffness, radius): (Vec<f64>, f64, f64)| {
        const PLACES: [usize; 5] = [0, 1, 2, 3, 5];
        let root = |i: usize, j: usize| b[5 * i + j] + f64::from(u8::from(i == j));
        let size = |i: usize| if i < 3 { stiffness.sqrt() } else { radius * stiffness.sqrt() };
        let mut k = [[0.0; 6]; 6];
        for i in 0..5 {
            for j in i..5 {
                let entry = size(i) * size(j) * (0..5).map(|m| root(i, m) * root(j, m)).sum::<f64>();
                k[PLACES[i]][PLACES[j]] = entry;
                k[PLACES[j]][PLACES[i]] = entry;
            }
        }
        BearingModel::Matrix(k)
    })
}
