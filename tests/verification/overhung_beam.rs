//! Roots of the Initial Parameter Method on uniform Euler-Bernoulli beams, x = k d with k^4 = rho A w^2/(EI).
//!
//! The overhung beam of Fig. 7 in Hua et al. (2012): body (mu = M/(rho A d), j = J/(rho A d^3)) at a, simple supports at b and c, free
//! ends at 0 and d. Roots from two independent programs (characteristic determinant at high precision).
//! Simply supported with a mass in the middle: Timoshenko, Young and Weaver (1974).

use std::f64::consts::{PI, TAU};

use bevelscope::design::{BeamTheory, Body, Design, Material, Side};
use bevelscope::rotor::{Rotor, RotorError};

use crate::support::{assert_close, design, disc, ordinary, rigid, rotor, spring, steel_shaft};

const LENGTH: f64 = 0.5;
const DIAMETER: f64 = 0.04;
const STEEL: Material = Material { youngs_modulus: 206e9, poissons_ratio: 0.3, density: 7850.0 };

fn mass_per_length() -> f64 {
    STEEL.density * PI / 4.0 * DIAMETER.powi(2)
}

/// x = k d of the first bending mode, in both planes.
fn roots(design: &Design) -> [f64; 2] {
    let solved = Rotor::new(design, Side::Pinion).unwrap();
    let bending = STEEL.youngs_modulus * PI / 64.0 * DIAMETER.powi(4);
    [solved.bending_x, solved.bending_z].map(|mode| {
        let omega = TAU * mode.frequency;
        (mass_per_length() * omega * omega / bending).powf(0.25) * LENGTH
    })
}

/// mu and j over the whole length d, as the table has them.
fn body(at: f64, mu: f64, j: f64) -> Body {
    disc(at * LENGTH, mu * mass_per_length() * LENGTH, j * mass_per_length() * LENGTH.powi(3), 1e-3)
}

fn beam(bodies: Vec<Body>, supports: &[f64]) -> Design {
    let bearings = supports.iter().enumerate().map(|(i, at)| rigid(at * LENGTH, [true, i == 0, true])).collect();
    let mut shaft = rotor(vec![steel_shaft(LENGTH, DIAMETER, 2)], bodies, bearings);
    shaft.mesh_position = 0.1 * LENGTH;
    design(BeamTheory::EulerBernoulli, STEEL, shaft, ordinary().gear)
}

#[test]
fn overhung_beam_of_fig_7() {
    let rows = [
        (vec![], [0.5, 1.0], 3.011_831),
        (vec![body(0.0, 0.5, 0.01)], [0.3, 1.0], 2.558_542),
        (vec![body(0.0, 2.0, 0.05)], [0.3, 0.9], 1.888_960),
        (vec![body(0.05, 0.5, 0.005)], [0.3, 0.9], 2.917_225),
    ];
    for (bodies, supports, expected) in rows {
        for found in roots(&beam(bodies, &supports)) {
            assert_close("x1", found, expected, 3e-7);
        }
    }
}

/// Both supports at the very ends: their reactions leave the end conditions by no other way.
#[test]
fn mass_in_the_middle() {
    for found in roots(&beam(vec![body(0.5, 1.0, 0.0)], &[0.0, 1.0])) {
        assert_close("x1", found, 2.383_191, 3e-7);
    }
}

/// A spring of any stiffness on the way from soft to rigid: the frequency rises steadily to that of the rigid support.
#[test]
fn elastic_supports_tend_to_rigid_ones() {
    let rigid = roots(&beam(vec![body(0.05, 0.5, 0.005)], &[0.3, 0.9]))[1];
    let elastic = |k: f64| {
        let mut design = beam(vec![body(0.05, 0.5, 0.005)], &[0.3, 0.9]);
        design.pinion.bearings = [0.3, 0.9].map(|at| spring(at * LENGTH, [k, 1e8, k, 0.0, 0.0])).to_vec();
        roots(&design)[1]
    };
    let found: Vec<f64> = (3..14).map(|exponent| elastic(10_f64.powi(exponent))).collect();
    for pair in found.windows(2) {
        assert!(pair[0] < pair[1] && pair[1] < rigid, "{found:?} below {rigid}");
    }
    // the error falls with 1/k
    let gaps: Vec<f64> = [1e11, 1e12, 1e13].map(|k| 1.0 - elastic(k) / rigid).to_vec();
    assert!((gaps[0] / gaps[1] - 10.0).abs() < 0.1 && (gaps[1] / gaps[2] - 10.0).abs() < 0.1, "{gaps:?}");
}

/// A bar on two soft springs at its ends with a body in the middle: the body's inertia moves the pitch mode and not the bounce mode. Where
/// they meet the root is double, and sign changes of the determinant alone would miss it.
#[test]
fn double_root() {
    let frequency = |inertia: f64| {
        let mut design = beam(vec![body(0.5, 1.0, inertia)], &[0.0, 1.0]);
        design.pinion.bearings = [0.0, LENGTH].map(|at| spring(at, [1e4, 1e8, 1e4, 0.0, 0.0])).to_vec();
        design.pinion.mesh_position = 0.5 * LENGTH;
        Rotor::new(&design, Side::Pinion).unwrap().bending_z.frequency
    };
    // as a rigid bar: bounce w^2 = 2k/M, pitch w^2 = 2k (d/2)^2/J, which meet at J = M d^2/4
    let rigid_meeting = 2.0 / 4.0 - 1.0 / 12.0;
    let bounce = frequency(0.5 * rigid_meeting);
    assert_close("bounce does not feel the inertia", frequency(0.9 * rigid_meeting), bounce, 1e-11);
    let (mut low, mut high) = (0.9 * rigid_meeting, 1.1 * rigid_meeting);
    while high - low > 4.0 * f64::EPSILON * low {
        let middle = f64::midpoint(low, high);
        if frequency(middle) < bounce * (1.0 - 1e-9) { high = middle } else { low = middle }
    }
    assert!((low / rigid_meeting - 1.0).abs() < 0.02, "{low} {rigid_meeting}");
    for step in -50..=50 {
        let inertia = low * (1.0 + 2e-10 * f64::from(step));
        assert_close("where the roots meet", frequency(inertia), bounce, 2e-8);
    }
    // past the meeting the pitch mode is the lowest: w^2 falls with 1/J
    let pitch = [1.05, 1.10].map(|factor| frequency(factor * low) / bounce);
    assert!(pitch[0] < 0.99 && pitch[1] < pitch[0], "{pitch:?}");
}

/// A rigid bearing at the mesh station leaves no compliance to invert.
#[test]
fn rigid_bearing_at_the_mesh_is_refused() {
    let mut design = beam(vec![], &[0.5, 1.0]);
    design.pinion.mesh_position = 0.5 * LENGTH;
    assert_eq!(Rotor::new(&design, Side::Pinion).unwrap_err(), RotorError::RigidAtMesh);
}
