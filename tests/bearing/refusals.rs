//! What no bearing is, and loads that none can carry: each has an error of its own.

use bevelscope::bearing::{Bearing, Data, EquilibriumError, Kind, Vector, Warning, equilibrium};

use crate::{ball, bearing, roller};

const TILTS_HELD: [Option<f64>; 5] = [None, None, None, Some(0.0), Some(0.0)];

#[test]
fn bad_numbers_name_their_field() {
    let good = Data {
        elements: 12,
        contact_angle: 0.7,
        clearance: 0.0,
        radius: 0.027,
        contact_stiffness: 8.5e9,
        kind: Kind::Ball { groove_distance: 4.5e-4 },
    };
    assert!(Bearing::new(good).is_ok());
    for (data, field) in [
        (Data { elements: 2, ..good }, "elements"),
        (Data { contact_angle: 1.6, ..good }, "contact angle"),
        (Data { contact_angle: f64::NAN, ..good }, "contact angle"),
        (Data { clearance: -1e-6, ..good }, "clearance"),
        (Data { radius: 0.0, ..good }, "pitch radius"),
        (Data { contact_stiffness: 0.0, ..good }, "contact stiffness"),
        (Data { contact_stiffness: f64::INFINITY, ..good }, "contact stiffness"),
        (Data { kind: Kind::Ball { groove_distance: 0.0 }, ..good }, "groove distance"),
        (Data { kind: Kind::Roller { length: -0.01 }, ..good }, "roller length"),
    ] {
        let error = Bearing::new(data).unwrap_err();
        assert_eq!(error.field, field);
        assert!(error.to_string().starts_with(&format!("BAD_INPUT: {field} must be ")), "{error}");
    }
}

#[test]
fn without_load_or_behind_a_clearance_nothing_is_in_contact() {
    let open = bearing(14, 0.0, 5e8, 0.03, 4e-6, Kind::Roller { length: 0.0 });
    for (bearing, load, held) in [
        (&ball(12, 40.0, 8.5e9, 0.027, 4.5e-4), Vector::zeros(), [None; 5]),
        (&roller(17, 20.0, 9.6e8, 0.0275, 0.017), Vector::zeros(), TILTS_HELD),
        (&open, Vector::new(5000.0, 0.0, 0.0, 0.0, 0.0), [Some(1e-6), Some(0.0), Some(0.0), Some(0.0), Some(0.0)]),
    ] {
        assert_eq!(equilibrium(bearing, &load, &held), Err(EquilibriumError::NoContact));
    }
}

#[test]
fn a_roller_bearing_carries_only_what_its_rollers_push_against() {
    let taper = roller(17, 20.0, 9.6e8, 0.0275, 0.0);
    let spread = roller(17, 20.0, 9.6e8, 0.0275, 0.017);
    let cylindrical = roller(14, 0.0, 5e8, 0.03, 0.0);
    for (what, bearing, load, held) in [
        ("thrust the wrong way", &taper, [0.0, 0.0, -5000.0, 0.0, 0.0], TILTS_HELD),
        (
            "thrust the wrong way, turned round",
            &roller(17, -20.0, 9.6e8, 0.0275, 0.0),
            [0.0, 0.0, 5000.0, 0.0, 0.0],
            TILTS_HELD,
        ),
        // Fr tan(20 deg) = 1456 N
        ("less thrust than one roller gives", &taper, [4000.0, 0.0, 1400.0, 0.0, 0.0], TILTS_HELD),
        ("thrust on a cylindrical one", &cylindrical, [5000.0, 0.0, 100.0, 0.0, 0.0], TILTS_HELD),
        ("a moment without a line to bear it", &taper, [0.0, 0.0, 5000.0, 30.0, 0.0], [None; 5]),
        ("a moment beyond the line", &spread, [0.0, 0.0, 1000.0, 300.0, 0.0], [None; 5]),
    ] {
        let error = equilibrium(bearing, &Vector::from(load), &held).unwrap_err();
        assert_eq!(error, EquilibriumError::UnsupportedLoad { load: Vector::from(load) }, "{what}");
    }
    // just beyond that limit there is an equilibrium, on very few rollers
    let state = equilibrium(&taper, &Vector::new(4000.0, 0.0, 1600.0, 0.0, 0.0), &TILTS_HELD).unwrap();
    assert!(state.loaded() < 9, "{}", state.loaded());
}

#[test]
fn a_matching_moment_is_carried_by_tilts_that_are_free() {
    // all forces of a taper meet at the apex: Mx = r tan(a) Fy, My = -r tan(a) Fx
    let taper = roller(17, 20.0, 9.6e8, 0.0275, 0.0);
    let arm = 0.0275 * 20_f64.to_radians().tan();
    let load = Vector::new(900.0, -400.0, 5000.0, arm * -400.0, -arm * 900.0);
    let state = equilibrium(&taper, &load, &[None; 5]).unwrap();
    assert!((state.load - load).amax() < 1e-8 * 5000.0, "{}", state.load);
}

#[test]
fn what_is_unusual_is_said() {
    let thrust = Vector::new(0.0, 0.0, 1000.0, 0.0, 0.0);
    let ball = ball(12, 40.0, 8.5e9, 0.027, 4.5e-4);
    let even = equilibrium(&ball, &thrust, &[None; 5]).unwrap();
    assert_eq!((even.warnings.as_slice(), even.note()), (&[][..], None));
    let radial = equilibrium(&ball, &Vector::new(1000.0, 0.0, 10.0, 0.0, 0.0), &TILTS_HELD).unwrap();
    let unloaded = 12 - radial.loaded();
    // ordinary under a radial load: worth a note, and no warning
    assert!((1..12).contains(&unloaded), "{unloaded}");
    assert_eq!(radial.note(), Some(format!("{unloaded} of 12 rolling elements carry no load")));
    assert!(
        !radial.warnings.iter().any(|warning| matches!(warning, Warning::FewLoaded { .. })),
        "{:?}",
        radial.warnings
    );
    // with this much clearance the load rests on the elements right below it
    let loose = Bearing::new(Data { clearance: 5e-5, ..ball.data() }).unwrap();
    let held = [None, Some(0.0), Some(0.0), Some(0.0), Some(0.0)];
    let few = equilibrium(&loose, &Vector::new(1.0, 0.0, 0.0, 0.0, 0.0), &held).unwrap();
    assert_eq!(few.warnings, [Warning::FewLoaded { loaded: few.loaded(), elements: 12 }]);
    assert!((1..3).contains(&few.loaded()), "{}", few.loaded());
    let backwards = equilibrium(&ball, &-thrust, &TILTS_HELD).unwrap();
    assert_eq!(backwards.warnings, [Warning::OppositeShoulder(12)]);
    assert!(Warning::OppositeShoulder(1).to_string().starts_with("1 ball bears on"));
    // a deep groove bearing has both shoulders, and its angle from clearance
    let deep_groove = Bearing::new(Data { contact_angle: f64::to_radians(10.0), ..ball.data() }).unwrap();
    assert_eq!(equilibrium(&deep_groove, &-thrust, &TILTS_HELD).unwrap().warnings, []);
    let deep = equilibrium(&ball, &(thrust * 1e3), &TILTS_HELD).unwrap();
    assert!(matches!(deep.warnings[..], [Warning::Deep { .. }]), "{:?}", deep.warnings);
    let range = radial.angle_range().unwrap();
    assert!(range[0] < range[1] && range[1] < 1.0, "{range:?}");
}
