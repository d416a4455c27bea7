//! Shafts that nothing holds are refused with the motion named; shafts that little holds are not. Numbers beyond all measure give an error
//! that names what overflows, never a panic and never a figure that is no number.

use bevelscope::comparison::compare;
use bevelscope::design::{Bearing, Design, RotorDesign, Side};
use bevelscope::rotor::{Motion, Rotor, RotorError};

use crate::support::nonsense::assert_no_nonsense;
use crate::support::{ordinary, rigid, rotor, spring, steel_shaft};

fn with_bearings(bearings: Vec<Bearing>) -> Design {
    let mut design = ordinary();
    design.analysis.frequency_lines = 20;
    design.pinion.bearings = bearings;
    design
}

#[track_caller]
fn assert_unsupported(bearings: Vec<Bearing>, expected: &[Motion], words: &[&str]) {
    let design = with_bearings(bearings);
    let error = Rotor::new(&design, Side::Pinion).unwrap_err();
    assert_eq!(error, RotorError::Unsupported(expected.to_vec()));
    let message = compare(&design).unwrap_err().to_string();
    assert!(message.starts_with("pinion shaft: nothing holds it "), "{message}");
    for word in words {
        assert!(message.contains(word), "\"{word}\" in \"{message}\"");
    }
}

#[test]
fn nothing_axial() {
    let bearings = vec![spring(0.055, [6e8, 0.0, 6e8, 1e5, 1e5]), spring(0.13, [5e8, 0.0, 5e8, 0.0, 0.0])];
    assert_unsupported(bearings, &[Motion::Y], &["in the axial direction"]);
    let rigid = vec![rigid(0.055, [true, false, true]), rigid(0.13, [true, false, true])];
    assert_unsupported(rigid, &[Motion::Y], &["in the axial direction"]);
}

#[test]
fn nothing_sideways() {
    let bearings = vec![spring(0.055, [0.0, 2e8, 6e8, 1e5, 1e5]), spring(0.13, [0.0, 0.0, 5e8, 0.0, 0.0])];
    assert_unsupported(bearings, &[Motion::X], &["sideways in x"]);
    let bearings = vec![spring(0.055, [6e8, 2e8, 0.0, 1e5, 1e5]), spring(0.13, [5e8, 0.0, 0.0, 0.0, 0.0])];
    assert_unsupported(bearings, &[Motion::Z], &["sideways in z"]);
}

/// One bearing that holds no tilt: the shaft turns about its centre, wherever that is.
#[test]
fn tilt() {
    for position in [0.0, 0.055, 0.085, 0.17] {
        for bearing in [spring(position, [6e8, 2e8, 6e8, 0.0, 0.0]), rigid(position, [true; 3])] {
            let design = with_bearings(vec![bearing]);
            let error = Rotor::new(&design, Side::Pinion).unwrap_err();
            let RotorError::Unsupported(motions) = error else { panic!("{error:?}") };
            assert!(motions.contains(&Motion::ThX) && motions.contains(&Motion::ThZ), "at {position}: {motions:?}");
            assert!(!motions.contains(&Motion::Y), "at {position}: {motions:?}");
        }
    }
    // two at one place are one
    let twice = [0.085, 0.085].map(|at| spring(at, [6e8, 2e8, 6e8, 0.0, 0.0])).to_vec();
    assert_unsupported(twice, &[Motion::ThX, Motion::ThZ], &["tilting about x", "tilting about z"]);
    // a spring against one tilt leaves the other
    let one = vec![spring(0.085, [6e8, 2e8, 6e8, 1e5, 0.0])];
    assert_unsupported(one, &[Motion::ThZ], &["tilting about z"]);
}

#[test]
fn nothing_at_all() {
    let all = [Motion::X, Motion::Y, Motion::Z, Motion::ThX, Motion::ThZ];
    assert_unsupported(vec![spring(0.085, [0.0; 5])], &all, &["axial", "in x", "in z", "about x", "about z"]);
    assert_unsupported(vec![], &all, &["axial", "in x", "in z", "about x", "about z"]);
    assert_unsupported(vec![rigid(0.085, [false; 3])], &all, &["axial"]);
}

/// 1 N/m beside 1e9 N/m is soft, and a support.
#[test]
fn the_softest_sensible_support_is_accepted() {
    for k in [[1.0, 1e9, 1e9], [1e9, 1.0, 1e9], [1e9, 1e9, 1.0]] {
        let at = |position, k: [f64; 3]| spring(position, [k[0], k[1], k[2], 0.0, 0.0]);
        let design = with_bearings(vec![at(0.055, k), at(0.13, k)]);
        let rotor = Rotor::new(&design, Side::Pinion).unwrap_or_else(|error| panic!("{k:?}: {error}"));
        // in the soft direction the shaft bounces as a rigid body
        let [x, _, z] = k.map(|k| (2.0 * k / rotor.totals.mass).sqrt() / std::f64::consts::TAU);
        for (stiffness, bounce, bending) in [(k[0], x, rotor.bending_x), (k[2], z, rotor.bending_z)] {
            assert!(stiffness > 1.0 || bending.frequency <= bounce * (1.0 + 1e-6), "{} {bounce}", bending.frequency);
        }
        compare(&design).unwrap_or_else(|error| panic!("{k:?}: {error}"));
    }
}

/// One number of the design at a time, over the whole range of a double.
#[test]
fn extreme_values() {
    type Change = fn(&mut Design, f64);
    let bearing = |rotor: &mut RotorDesign, k: [f64; 5]| rotor.bearings[0] = spring(0.055, k);
    let changes: [(&str, Change); 18] = [
        ("mesh stiffness", |d, v| d.mesh.stiffness = v),
        ("mesh damping", |d, v| d.mesh.damping = v),
        ("transmission error", |d, v| d.mesh.transmission_error = v),
        ("structural damping", |d, v| d.analysis.structural_damping = v),
        ("mesh point", |d, v| d.mesh.pinion.point = [v, v, v]),
        ("Young's modulus", |d, v| d.materials.get_mut("steel").unwrap().youngs_modulus = v),
        ("density", |d, v| d.materials.get_mut("steel").unwrap().density = v),
        ("segment length", |d, v| d.pinion.segments[1].length = v),
        ("outer diameter", |d, v| d.pinion.segments[0].outer_diameter = v),
        ("body mass", |d, v| d.pinion.bodies[0].mass = v),
        ("diametral inertia", |d, v| d.pinion.bodies[0].diametral_inertia = v),
        ("polar inertia", |d, v| d.pinion.bodies[0].polar_inertia = v),
        ("drive stiffness", |d, v| d.pinion.drive.as_mut().unwrap().torsional_stiffness = v),
        ("drive inertia", |d, v| d.pinion.drive.as_mut().unwrap().inertia = v),
        ("Kc", |d, v| d.pinion.bearings[0].axial_series_stiffness = Some(v)),
        ("Khb", |d, v| d.gear.housing_axial_stiffness = Some(v)),
        ("highest line", |d, v| d.analysis.frequency_max = v.max(11.0)),
        ("lowest line", |d, v| d.analysis.frequency_min = v.min(3999.0)),
    ];
    let mut solved = 0;
    let mut refused = 0;
    let mut run = |what: &str, design: &Design| match assert_no_nonsense(what, design) {
        Ok(()) => solved += 1,
        Err(message) => {
            refused += 1;
            println!("{what}: {message}");
        }
    };
    for exponent in [-308, -300, -200, -150, -100, -50, -30, -15, 15, 30, 50, 100, 150, 200, 300, 308] {
        let value = 10_f64.powi(exponent);
        for (name, change) in changes {
            let mut design = ordinary();
            design.analysis.frequency_lines = 7;
            change(&mut design, value);
            run(&format!("{name} 1e{exponent}"), &design);
        }
        for i in 0..5 {
            let mut design = ordinary();
            design.analysis.frequency_lines = 7;
            let mut k = [6e8, 2.5e8, 6e8, 1.5e5, 1.5e5];
            k[i] = value;
            bearing(&mut design.pinion, k);
            run(&format!("bearing stiffness {i} 1e{exponent}"), &design);
        }
    }
    assert!(solved > 100 && refused > 20, "{solved} solved, {refused} refused");
}

/// Zeros where the design's rules allow them.
#[test]
fn zeros() {
    type Change = fn(&mut Design);
    let changes: [(&str, Change); 6] = [
        ("no damping", |d| {
            d.mesh.damping = 0.0;
            d.analysis.structural_damping = 0.0;
        }),
        ("massless body", |d| {
            let body = &mut d.pinion.bodies[0];
            (body.mass, body.diametral_inertia, body.polar_inertia) = (0.0, 0.0, 0.0);
        }),
        ("mesh on the axis", |d| {
            d.mesh.pinion.point = [0.0; 3];
            d.mesh.gear.point = [0.0; 3];
        }),
        ("line of action along the shaft", |d| d.mesh.pinion.line_of_action = [0.0, 1.0, 0.0]),
        ("no bodies", |d| d.pinion.bodies.clear()),
        ("bearing without stiffness beside others", |d| d.pinion.bearings.push(spring(0.1, [0.0; 5]))),
    ];
    for (name, change) in changes {
        let mut design = ordinary();
        change(&mut design);
        assert_no_nonsense(name, &design).unwrap_or_else(|message| panic!("{name}: {message}"));
    }
}

/// A shaft shorter than what makes two stations: a length may be any positive number.
#[test]
fn shaft_without_length() {
    for length in [1e-10, 1e-300] {
        let mut shaft = rotor(vec![steel_shaft(length, 0.03, 2)], vec![], vec![rigid(0.0, [true; 3])]);
        shaft.drive.as_mut().unwrap().position = 0.0;
        let design = Design { pinion: shaft, ..ordinary() };
        let message = assert_no_nonsense("short", &design).unwrap_err();
        assert!(message.starts_with("pinion shaft: the shaft is too short"), "{message}");
    }
}
