//! Seven bearings computed by an independent program, to eight digits: displacement, loads and stiffness.

#![allow(clippy::unreadable_literal, reason = "figures as the other program printed them")]

use bevelscope::bearing::{Bearing, Kind, Matrix, Vector, equilibrium};

use crate::{ball, bearing, difference, roller};

/// K to 1e-7 of its largest entry, displacements and loads to the digits that are given.
#[track_caller]
fn check(bearing: &Bearing, q: [f64; 5], f: [f64; 5], k: [f64; 15]) {
    let state = bearing.state(&Vector::from(q));
    let mut expected = Matrix::zeros();
    let mut entries = k.into_iter();
    for (i, j) in (0..5).flat_map(|i| (i..5).map(move |j| (i, j))) {
        expected[(i, j)] = entries.next().unwrap();
        expected[(j, i)] = expected[(i, j)];
    }
    let error = difference(&state.stiffness, &expected, bearing.radius());
    assert!(error <= 1e-7, "K is off by {error:.2e}: {:e}", state.stiffness);
    for (i, expected) in f.into_iter().enumerate() {
        let size = f[0].abs().max(f[1].abs()).max(f[2].abs()) * if i < 3 { 1.0 } else { bearing.radius() };
        assert!((state.load[i] - expected).abs() <= 1e-7 * size, "load {i}: {} for {expected}", state.load[i]);
    }
}

/// As [`check`], found from the loads.
#[track_caller]
fn check_balance(bearing: &Bearing, held: [Option<f64>; 5], q: [f64; 5], f: [f64; 5], k: [f64; 15]) {
    let state = equilibrium(bearing, &Vector::from(f), &held).unwrap();
    let size = q[0].abs().max(q[1].abs()).max(q[2].abs());
    for (i, expected) in q.into_iter().enumerate() {
        let size = if i < 3 { size } else { size / bearing.radius() };
        let found = state.displacement[i];
        assert!((found - expected).abs() <= 1e-7 * size, "displacement {i}: {found} for {expected}");
    }
    check(bearing, state.displacement.into(), f, k);
}

#[test]
fn ball_at_a_displacement() {
    check(
        &ball(12, 40.0, 8.5e9, 0.027, 0.000_45),
        [4e-06, -2e-06, 1.2e-05, 0.0001, -0.0002],
        [1027.2489, 36.946012, 1671.7526, 1.183451, -24.389681],
        [
            111865240.0,
            -434232.03,
            47381209.0,
            -6146.908,
            -2577024.2,
            119196640.0,
            2138573.3,
            2753637.1,
            6146.908,
            178324100.0,
            89218.644,
            -1211654.2,
            66924.948,
            27.017545,
            63073.325,
        ],
    );
}

#[test]
fn ball_under_thrust() {
    check_balance(
        &ball(12, 40.0, 8.5e9, 0.027, 0.000_45),
        [None; 5],
        [0.0, 0.0, 9.3632864e-06, 0.0, 0.0],
        [0.0, 0.0, 1000.0, 0.0, 0.0],
        [
            108437570.0,
            0.0,
            0.0,
            0.0,
            -2497091.1,
            108437570.0,
            0.0,
            2497091.1,
            0.0,
            163580930.0,
            0.0,
            0.0,
            59625.248,
            0.0,
            59625.248,
        ],
    );
}

#[test]
fn ball_under_five_loads() {
    check_balance(
        &ball(12, 40.0, 8.5e9, 0.027, 0.000_45),
        [None; 5],
        [4.85834e-05, -5.3695653e-05, 1.1285267e-06, 0.0023991073, 0.0018575795],
        [800.0, -300.0, 1500.0, 5.0, -8.0],
        [
            109470150.0,
            -32885941.0,
            33073614.0,
            -570341.27,
            -2120512.5,
            114135540.0,
            22783296.0,
            2371505.0,
            570341.27,
            153587160.0,
            1459232.6,
            -48283.766,
            61688.276,
            15335.834,
            50276.761,
        ],
    );
}

#[test]
fn roller_at_a_displacement() {
    check(
        &roller(17, 20.0, 9.6e8, 0.0275, 0.0),
        [6e-06, 3e-06, 8e-06, 0.0001, -0.00015],
        [10636.809, 5705.4171, 6146.4279, 57.106555, -106.46575],
        [
            1184095900.0,
            -115707850.0,
            424908070.0,
            -1158140.9,
            -11851831.0,
            1293578600.0,
            253977310.0,
            12947663.0,
            1158140.9,
            328228270.0,
            2542105.0,
            -4252982.0,
            129595.51,
            11592.043,
            118627.12,
        ],
    );
}

#[test]
fn roller_under_two_loads_with_tilts_held() {
    check_balance(
        &roller(17, 20.0, 9.6e8, 0.0275, 0.0),
        [None, None, None, Some(0.0), Some(0.0)],
        [2.0203761e-06, 0.0, 1.0457616e-05, 0.0, 0.0],
        [4000.0, 0.0, 5000.0, 0.0, -40.036726],
        [
            1963865300.0,
            0.0,
            45583805.0,
            0.0,
            -19656684.0,
            1979829400.0,
            0.0,
            19816471.0,
            0.0,
            522438310.0,
            0.0,
            -456256.58,
            198346.66,
            0.0,
            196747.31,
        ],
    );
}

#[test]
fn roller_with_load_spread_along_the_line() {
    check(
        &roller(17, 20.0, 9.6e8, 0.0275, 0.017),
        [6e-06, 3e-06, 8e-06, 0.0004, -0.0009],
        [19405.554, 9009.7475, 10335.788, 102.83774, -223.02459],
        [
            1192468400.0,
            -43238178.0,
            482416720.0,
            -215226.65,
            -11959320.0,
            1252880700.0,
            219232160.0,
            12378660.0,
            215226.65,
            323945990.0,
            2122483.1,
            -4990500.4,
            157114.6,
            1562.4145,
            152662.03,
        ],
    );
}

#[test]
fn cylindrical_roller_with_clearance() {
    check_balance(
        &bearing(14, 0.0, 5e8, 0.03, 4e-6, Kind::Roller { length: 0.0 }),
        [None, None, Some(0.0), Some(0.0), Some(0.0)],
        [0.0, 1.5386721e-05, 0.0, 0.0, 0.0],
        [0.0, 5000.0, 0.0, 0.0, 0.0],
        [349540370.0, 0.0, 0.0, 0.0, 0.0, 531702610.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    );
}
