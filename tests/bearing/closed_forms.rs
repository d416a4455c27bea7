//! Bearings under pure axial and pure radial displacement, where everything can be written down.

use std::f64::consts::PI;

use bevelscope::bearing::{Matrix, Vector, roller_contact_stiffness};

use crate::{ball, bearing, difference, roller};
use bevelscope::bearing::{BallGeometry, Kind, equilibrium};

fn axial(kxx: f64, kzz: f64, kbb: f64, kxby: f64) -> Matrix {
    let mut k = Matrix::zeros();
    k.set_diagonal(&Vector::new(kxx, kxx, kzz, kbb, kbb));
    (k[(0, 4)], k[(4, 0)]) = (kxby, kxby);
    (k[(1, 3)], k[(3, 1)]) = (-kxby, -kxby);
    k
}

#[test]
fn a_roller_bearing_under_pure_thrust() {
    let (z, kn, r, n) = (17.0, 9.6e8, 0.0275, 10.0 / 9.0);
    for degrees in [20.0, -16.0, 45.0] {
        let bearing = roller(17, degrees, kn, r, 0.0);
        let (sin, cos) = degrees.to_radians().sin_cos();
        let dz = 1e-5 * sin.signum();
        let state = bearing.state(&Vector::new(0.0, 0.0, dz, 0.0, 0.0));
        let delta: f64 = dz * sin;
        let fz = z * kn * delta.powf(n) * sin;
        let k = n * kn * delta.powf(n - 1.0);
        assert!((state.load[2] / fz - 1.0).abs() < 1e-13);
        let expected =
            axial(z / 2.0 * k * cos * cos, n * fz / dz, z / 2.0 * r * r * k * sin * sin, -z / 2.0 * r * k * sin * cos);
        assert!(difference(&state.stiffness, &expected, r) < 1e-13, "{degrees}: {:e}", state.stiffness);
    }
}

#[test]
fn a_ball_bearing_under_pure_thrust() {
    let (z, kn, r, a0) = (12.0, 8.5e9, 0.027, 4.5e-4);
    let start = 40_f64.to_radians();
    let bearing = ball(12, 40.0, kn, r, a0);
    for angle in [40.5_f64, 42.0, 47.0].map(f64::to_radians) {
        let dz = a0 * (start.cos() * angle.tan() - start.sin());
        let delta = a0 * (start.cos() / angle.cos() - 1.0);
        let fz = z * kn * delta.powf(1.5) * angle.sin();
        let state = bearing.state(&Vector::new(0.0, 0.0, dz, 0.0, 0.0));
        assert!((state.load[2] / fz - 1.0).abs() < 1e-12, "{} {fz}", state.load[2]);
        let (sin, cos) = angle.sin_cos();
        let (kq, kt) = (1.5 * kn * delta.sqrt(), kn * delta.powf(1.5) / (a0 + delta));
        let (a, d) = (kq * cos * cos + kt * sin * sin, kq * sin * sin + kt * cos * cos);
        let e = (kq - kt) * sin * cos;
        let expected = axial(z / 2.0 * a, z * d, z / 2.0 * r * r * d, -z / 2.0 * r * e);
        assert!(difference(&state.stiffness, &expected, r) < 1e-12, "{:e}", state.stiffness);
    }
}

// Jr = Gamma((n+2)/2) / (2 sqrt(pi) Gamma((n+3)/2)): 0.228828 for n = 3/2, 0.244799 for n = 10/9.
#[test]
fn many_elements_under_pure_radial_load() {
    const MANY: usize = 4000;
    // a ball's own terms across the contact are delta/A0, and drop out for a small one
    for (bearing, n, jr, dx, tolerance) in [
        (ball(MANY, 0.0, 1e7, 0.03, 4.5e-4), 1.5, 0.228_828, 1e-9_f64, 1e-5),
        (roller(MANY, 0.0, 1e6, 0.03, 0.0), 10.0 / 9.0, 0.244_799, 1e-5, 1e-5),
    ] {
        let state = bearing.state(&Vector::new(dx, 0.0, 0.0, 0.0, 0.0));
        let kn = state.contacts[0].load / state.contacts[0].deflection.powf(n);
        let fr = MANY as f64 * kn * dx.powf(n) * jr;
        assert!((state.load[0] / fr - 1.0).abs() < tolerance, "{} {fr}", state.load[0]);
        // delta^(1/9) ends steeply: the sum over elements is that far from the integral
        let tolerance = tolerance.max(1e-3);
        assert!((state.stiffness[(0, 0)] / (n * fr / dx) - 1.0).abs() < tolerance);
        assert!((state.stiffness[(1, 1)] / (fr / dx) - 1.0).abs() < tolerance);
    }
}

// Representative sizes: Kn, deflection and stiffness under axial preload alone, from an independent computation, five digits.
#[test]
fn bearings_of_an_automotive_axle_under_preload() {
    let held = [None, None, None, Some(0.0), Some(0.0)];
    for (z, angle, length, r, fz, kn, dz, k_xx, k_zz, k_bb, k_bb_line, k_xby) in [
        (17, 20.0, 0.017, 0.0275, 5000.0, 9.6104e8, 10.53e-6, 1.9910e9, 5.2750e8, 1.9946e5, 2.5376e5, -1.9928e7),
        (16, -16.0, 0.0135, 0.0235, -5000.0, 7.8298e8, -20.15e-6, 1.6763e9, 2.7566e8, 7.6118e4, 1.0367e5, 1.1296e7),
        (21, 17.0, 0.015, 0.036, 4000.0, 8.5985e8, 10.61e-6, 2.2414e9, 4.1900e8, 2.7151e5, 3.1747e5, -2.4669e7),
    ] {
        assert!((roller_contact_stiffness(length) / kn - 1.0).abs() < 5e-5);
        let load = Vector::new(0.0, 0.0, fz, 0.0, 0.0);
        for (spread, k_bb) in [(0.0, k_bb), (length, k_bb_line)] {
            let bearing = bearing(z, angle, roller_contact_stiffness(length), r, 0.0, Kind::Roller { length: spread });
            let state = equilibrium(&bearing, &load, &held).unwrap();
            let k = &state.stiffness;
            for (found, expected) in
                [(k[(0, 0)], k_xx), (k[(2, 2)], k_zz), (k[(3, 3)], k_bb), (k[(0, 4)], k_xby), (k[(1, 3)], -k_xby)]
            {
                assert!((found / expected - 1.0).abs() < 5e-5, "{found:e} {expected:e}");
            }
            assert!((state.displacement[2] - dz).abs() <= 0.51e-8, "{}", state.displacement[2]);
        }
    }
    let geometry = BallGeometry {
        ball_diameter: 0.011_112_5,
        pitch_diameter: 0.0535,
        inner_groove_factor: 0.52,
        outer_groove_factor: 0.52,
        contact_angle: 40_f64.to_radians(),
    };
    // these figures are for E = 207 GPa
    let kn = geometry.contact_stiffness_of(207e9, 0.3);
    assert!((kn / 1.0966e10 - 1.0).abs() < 5e-5, "{kn:e}");
    assert!(
        (geometry.radius() / 0.026_920_3 - 1.0).abs() < 1e-5
            && (geometry.groove_distance() / 4.445e-4 - 1.0).abs() < 1e-12
    );
    let bearing = ball(12, 40.0, kn, geometry.radius(), geometry.groove_distance());
    let state = equilibrium(&bearing, &Vector::new(0.0, 0.0, 1000.0, 0.0, 0.0), &held).unwrap();
    let k = &state.stiffness;
    // to half of the last digit that is given
    for (found, expected, last) in [
        (k[(0, 0)], 1.2899e8, 1e4),
        (k[(2, 2)], 1.9272e8, 1e4),
        (k[(4, 4)], 6.9834e4, 1.0),
        (k[(0, 4)], -2.9549e6, 1e2),
        (state.displacement[2], 7.925e-6, 1e-9),
        (state.contacts[3].load, 127.6, 0.1),
        (state.contacts[3].angle * 180.0 / PI, 40.77, 0.01),
    ] {
        let off: f64 = found - expected;
        assert!(off.abs() <= 0.51 * last, "{found:e} {expected:e}");
    }
}
