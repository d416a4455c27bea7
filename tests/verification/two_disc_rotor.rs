//! Two-disc rotor at rest: Friswell, Penny, Garvey and Lees, *Dynamics of Rotating Machinery* (2010), example 5.9.1.
//!
//! Six Timoshenko elements of 0.25 m, diameter 0.05 m, discs of thickness 0.07 m at 0.5 m (diameter 0.28 m) and 1 m (0.35 m),
//! 1 MN/m in both transverse directions at both ends. Printed: 86.66, 274.31, 716.78 rad/s, each twice. Further digits and the torsional
//! frequency are from two independent programs that agree with the printed ones.

use std::f64::consts::PI;

use bevelscope::design::{BeamTheory, Body, Side};
use bevelscope::rotor::{Rotor, ShaftMatrices};

use crate::support::{FRISWELL_STEEL, assert_close, dense, design, disc, ordinary, rotor, spring, steel_shaft};

/// A disc of the shaft's steel with a bore of 0.05 m.
fn bored_disc(position: f64, diameter: f64) -> Body {
    const THICKNESS: f64 = 0.07;
    const BORE: f64 = 0.05;
    let mass = FRISWELL_STEEL.density * PI / 4.0 * (diameter.powi(2) - BORE.powi(2)) * THICKNESS;
    let squares = diameter.powi(2) + BORE.powi(2);
    disc(position, mass, mass * (squares / 16.0 + THICKNESS.powi(2) / 12.0), mass * squares / 8.0)
}

#[test]
fn natural_frequencies_at_rest() {
    let discs = vec![bored_disc(0.5, 0.28), bored_disc(1.0, 0.35)];
    assert_close("mass", discs[0].mass, 32.589_728, 1e-7);
    assert_close("diametral inertia", discs[1].diametral_inertia, 0.423_580_58, 1e-7);
    // the axial springs are ours: the example leaves the axial motion out, and it is uncoupled
    let bearings = vec![spring(0.0, [1e6, 1e6, 1e6, 0.0, 0.0]), spring(1.5, [1e6, 0.0, 1e6, 0.0, 0.0])];
    let shaft = rotor(vec![steel_shaft(1.5, 0.05, 6)], discs, bearings);
    let design = design(BeamTheory::Timoshenko, FRISWELL_STEEL, shaft, ordinary().gear);
    let solved = Rotor::new(&design, Side::Pinion).unwrap();
    assert_eq!(solved.stations.count(), 7);
    let shaft = ShaftMatrices::new(&design.pinion, &solved.stations, &solved.supports);
    let frequencies = |motions: &[usize]| {
        let kept: Vec<usize> = (0..shaft.free.len()).filter(|i| motions.contains(&(i % 6))).collect();
        let pick = |a: &nalgebra::DMatrix<f64>| a.select_rows(&kept).select_columns(&kept);
        let (lambda, _) = dense::generalized(&pick(&shaft.stiffness), &pick(&shaft.mass), 1e5);
        lambda.into_iter().map(f64::sqrt).collect::<Vec<_>>()
    };
    let bending = frequencies(&[0, 2, 3, 5]);
    let expected = [86.658_11, 274.3129, 716.7863, 1066.156, 1683.315];
    for (i, expected) in expected.into_iter().enumerate() {
        for found in &bending[2 * i..2 * i + 2] {
            assert_close("bending", *found, expected, 5e-7);
        }
    }
    for (found, printed) in bending.iter().step_by(2).zip([86.66, 274.31, 716.78]) {
        assert!((found - printed).abs() < 0.01, "{found} is printed as {printed}");
    }
    // the first is the free rotation
    assert_close("torsion", frequencies(&[4])[1], 650.4079, 1e-7);
}

/// The same rotor by transfer matrices: six elements are an upper bound, good to their discretisation error.
#[test]
fn first_bending_frequency_by_transfer_matrices() {
    let discs = vec![bored_disc(0.5, 0.28), bored_disc(1.0, 0.35)];
    let bearings = vec![spring(0.0, [1e6, 1e6, 1e6, 0.0, 0.0]), spring(1.5, [1e6, 0.0, 1e6, 0.0, 0.0])];
    let shaft = rotor(vec![steel_shaft(1.5, 0.05, 6)], discs, bearings);
    let design = design(BeamTheory::Timoshenko, FRISWELL_STEEL, shaft, ordinary().gear);
    let solved = Rotor::new(&design, Side::Pinion).unwrap();
    for bending in [solved.bending_x, solved.bending_z] {
        let omega = 2.0 * PI * bending.frequency;
        assert!(omega < 86.658_12, "a finite element frequency is an upper bound: {omega}");
        assert_close("first bending", omega, 86.658_11, 1e-5);
    }
}
