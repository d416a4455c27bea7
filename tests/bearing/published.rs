//! Displacements of a deep groove ball bearing by ISO/TS 16281, and the load zones of bearing catalogues.
//!
//! The displacements are those that the public repository minzhun/ISO16281 quotes in its `Test_BallBearing.py`, apparently from a commercial
//! gearbox program: 7 balls of 11.5 mm, pitch 43.5 mm, groove factors 0.52 and 0.53, E = 210 GPa, nu = 0.3; diametral clearance as
//! given, tilting counted at half the pitch diameter.

use bevelscope::bearing::{BallGeometry, Bearing, Data, Held, Kind, Vector, equilibrium};

use crate::roller;

fn deep_groove(diametral_clearance: f64) -> (Bearing, f64) {
    let geometry = BallGeometry {
        ball_diameter: 11.5e-3,
        pitch_diameter: 43.5e-3,
        inner_groove_factor: 0.52,
        outer_groove_factor: 0.53,
        contact_angle: 0.0,
    };
    let groove_distance = geometry.groove_distance();
    // the clearance becomes a contact angle
    let contact_angle = (1.0 - diametral_clearance / (2.0 * groove_distance)).acos();
    let contact_stiffness = BallGeometry { contact_angle, ..geometry }.contact_stiffness_of(210e9, 0.3);
    let bearing = Bearing::new(Data {
        elements: 7,
        contact_angle,
        clearance: 0.0,
        radius: 43.5e-3 / 2.0,
        contact_stiffness,
        kind: Kind::Ball { groove_distance },
    });
    (bearing.unwrap(), groove_distance * contact_angle.sin())
}

/// Radial displacement (um), axial displacement from the middle (um) and tilt (mrad).
fn displaced(clearance: f64, radial: f64, axial: f64, moment: f64) -> [f64; 3] {
    let (bearing, middle) = deep_groove(clearance);
    let load = Vector::new(radial, 0.0, axial, moment, 0.0);
    // under a radial load alone the inner ring stays in the middle
    let held: Held =
        if axial == 0.0 && moment == 0.0 { [None, None, Some(-middle), Some(0.0), Some(0.0)] } else { [None; 5] };
    let q = equilibrium(&bearing, &load, &held).unwrap().displacement;
    [q[0].hypot(q[1]) * 1e6, (q[2] + middle) * 1e6, q[3].hypot(q[4]) * 1e3]
}

#[test]
fn displacements_are_those_of_iso_ts_16281() {
    let none = f64::NAN;
    for ((radial, axial, moment, clearance), published) in [
        ((1000.0, 0.0, 0.0, 0.0), [15.1101, none, none]),
        ((0.0, 1000.0, 0.0, 0.0), [none, 133.5381, none]),
        ((1000.0, 0.0, 0.0, 10e-6), [21.223, none, none]),
        ((0.0, 1000.0, 0.0, 10e-6), [none, 149.1717, none]),
        ((1000.0, 1000.0, 0.0, 10e-6), [19.5923, 146.4603, 2.6872]),
        ((0.0, 0.0, 1.0, 0.0), [none, none, 3.6957]),
        ((1000.0, 1000.0, 1.0, 10e-6), [19.7144, 146.3084, 2.7239]),
    ] {
        let found = displaced(clearance, radial, axial, moment);
        for (found, published) in found.into_iter().zip(published).filter(|(_, published)| !published.is_nan()) {
            let error = (found / published - 1.0).abs();
            assert!(error < 1e-4, "{radial} N, {axial} N, {moment} N m: {found} for {published}, off by {error:.1e}");
        }
    }
}

// NSK catalogue E728g, section 5: with half of the elements loaded, Fa = 1.216 Fr tan(a) and Qmax = 4.37 Fr/(Z cos(a)) for points, 1.260
// and 4.08 for lines (n rounded to 1.1 there; with 10/9 it is 1.2580 and 4.0850).
#[test]
fn the_load_zone_is_that_of_catalogues() {
    const MANY: usize = 4000;
    let angle: f64 = 20.0;
    let bearing = roller(MANY, angle, 1e6, 0.03, 0.0);
    // radial and axial displacement such that the elements opposite the load just touch at the sides
    let q = Vector::new(1e-5, 0.0, 0.0, 0.0, 0.0);
    let state = bearing.state(&q);
    let (fr, fz) = (state.load[0], state.load[2]);
    let most = state.contacts.iter().map(|contact| contact.load).fold(0.0, f64::max);
    let (sin, cos) = angle.to_radians().sin_cos();
    assert!(state.loaded().abs_diff(MANY / 2) <= 1, "{}", state.loaded());
    assert!((fz / (fr * sin / cos) / 1.2580 - 1.0).abs() < 1e-4, "{}", fz / (fr * sin / cos));
    assert!((most * MANY as f64 * cos / fr / 4.0850 - 1.0).abs() < 1e-4, "{}", most * MANY as f64 * cos / fr);
}

#[test]
fn the_hertz_constant_is_that_of_the_reference() {
    let (bearing, _) = deep_groove(0.0);
    // Kn = Q / delta^1.5 of one ball on the load line
    let state = bearing.state(&Vector::new(1e-6, 0.0, 0.0, 0.0, 0.0));
    let constant = state.contacts[0].load / 1e-6_f64.powf(1.5);
    assert!((constant / 1.054_910_7e10 - 1.0).abs() < 1e-7, "{constant:e}");
}
