//! Shafts on ball and roller bearings whose stiffness follows from the torque.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

mod support;

use std::sync::Arc;

use bevelscope::bearing::{EquilibriumError, frames};
use bevelscope::design::{
    BallBearing, BeamTheory, Bearing, BearingModel, Design, MeanLoad, Operating, Preload, RollerBearing, RotorDesign,
    Side,
};
use bevelscope::model::{Coordinate, Model, ModelKind, Rotors};
use bevelscope::rotor::{BearingError, Motion, Rotor, RotorError};
use nalgebra::{DVector, Vector3, Vector6};
use proptest::prelude::*;
use support::{FRISWELL_STEEL, design, disc, ordinary, rotor, steel_shaft, unit};

fn taper(position: f64, contact_angle_deg: f64, length: f64, mounting_preload: f64) -> Bearing {
    let model = BearingModel::Roller(RollerBearing {
        elements: 17,
        contact_angle: contact_angle_deg.to_radians(),
        clearance: 0.0,
        pitch_radius: 0.0275,
        contact_stiffness: Some(9.6e8),
        roller_length: (length > 0.0).then_some(length),
        displacement: None,
        preload: None,
        mean_load: Some(MeanLoad::FromTorque),
        mounting_preload,
    });
    support::bearing(position, model)
}

fn ball(position: f64, contact_angle_deg: f64, mounting_preload: f64) -> Bearing {
    let model = BearingModel::Ball(BallBearing {
        elements: 12,
        contact_angle: contact_angle_deg.to_radians(),
        clearance: 0.0,
        contact_stiffness: Some(8.5e9),
        groove_distance: Some(4.5e-4),
        pitch_radius: Some(0.027),
        ball_diameter: None,
        pitch_diameter: None,
        inner_groove_factor: None,
        outer_groove_factor: None,
        displacement: None,
        preload: None,
        mean_load: Some(MeanLoad::FromTorque),
        mounting_preload,
    });
    support::bearing(position, model)
}

fn axle(torque: f64, bearings: [Vec<Bearing>; 2]) -> Design {
    let [pinion, gear] = bearings;
    let base = ordinary();
    let mut out = Design {
        pinion: RotorDesign { bearings: pinion, ..base.pinion },
        gear: RotorDesign { bearings: gear, ..base.gear },
        ..base
    };
    out.operating = Some(Operating { pinion_torque: Some(torque), pinion_speed: None });
    out
}

fn tapers(torque: f64, preload: f64) -> Design {
    let pair = |a, b| vec![taper(a, 20.0, 0.017, preload), taper(b, -20.0, 0.017, preload)];
    axle(torque, [pair(0.055, 0.13), pair(0.11, 0.22)])
}

/// Forces and moments of mesh and bearings about the shaft's start, without torsion; and the largest of them.
fn imbalance(rotor: &Rotor) -> (f64, f64) {
    let position = |station: usize| Vector3::new(0.0, rotor.stations.positions[station], 0.0);
    let (mut force, mut moment, mut most) = (Vector3::zeros(), Vector3::zeros(), 0.0_f64);
    let mut add = |at: Vector3<f64>, load: Vector6<f64>| {
        let own: Vector3<f64> = load.fixed_rows::<3>(0).into();
        force += own;
        moment += at.cross(&own) + load.fixed_rows::<3>(3);
        most = most.max(own.amax());
    };
    add(position(rotor.stations.mesh), *rotor.mean_states.mesh_load().unwrap());
    for (rolling, &station) in rotor.mean_states.bearings.iter().zip(&rotor.stations.bearings) {
        add(position(station), -frames::to_station(&rolling.as_ref().unwrap().state.load));
    }
    let length = rotor.stations.positions[rotor.stations.count() - 1];
    let moments = moment.x.abs().max(moment.z.abs()) / length;
    (force.amax().max(moments), most)
}

#[derive(Debug, Clone)]
struct Case {
    design: Design,
}

/// Numbers of one shaft: sizes, bearings, preloads.
type Drawn = ((f64, f64, f64, f64, f64), (bool, f64, f64, bool, bool), (f64, f64));

/// Shafts of any kind on two bearings set against each other, or on three, under any torque that leaves them in contact.
fn cases() -> impl Strategy<Value = Case> {
    let shaft = (0.15..0.4_f64, 0.035..0.06_f64, 0.05..0.95_f64, 0.1..0.35_f64, 0.6..0.9_f64);
    let bearings = (any::<bool>(), 12.0..28.0_f64, 12.0..40.0_f64, any::<bool>(), any::<bool>());
    let preload = (8e-6..3e-5_f64, 8e-6..3e-5_f64);
    let line = [-1.0..1.0_f64, -0.7..0.7, 0.3..1.0];
    let one = (shaft, bearings, preload);
    (one.clone(), one, 20.0..400.0_f64, line, 0.02..0.05_f64).prop_map(|(pinion, gear, torque, line, radius)| {
        let one =
            |((length, diameter, mesh, a, b), (balls, taper_angle, ball_angle, crossed, third), (p, q)): Drawn| {
                let turn = if crossed { -1.0 } else { 1.0 };
                let mut bearings = if balls {
                    vec![ball(a * length, turn * ball_angle, p), ball(b * length, -turn * ball_angle, q)]
                } else {
                    vec![
                        taper(a * length, turn * taper_angle, 0.017, p),
                        taper(b * length, -turn * taper_angle, 0.012, q),
                    ]
                };
                if third {
                    bearings.push(support::spring(length, [3e7, 0.0, 2e7, 0.0, 0.0]));
                }
                let segments =
                    vec![steel_shaft(length / 2.0, diameter, 2), steel_shaft(length / 2.0, 0.9 * diameter, 1)];
                let shaft = rotor(segments, vec![disc(mesh * length, 1.0, 1e-3, 1e-3)], bearings);
                RotorDesign { mesh_position: mesh * length, drive: if third { None } else { shaft.drive }, ..shaft }
            };
        let mut out = design(BeamTheory::Timoshenko, FRISWELL_STEEL, one(pinion), one(gear));
        // x carries the torque
        let line = unit([line[0] + 1.5 * line[0].signum(), line[1], line[2]]);
        out.mesh.pinion.line_of_action = line;
        out.mesh.gear.line_of_action = [-line[0], line[1], line[2]];
        out.mesh.pinion.point = [0.0, 0.0, radius];
        out.mesh.gear.point = [0.0, 0.0, 2.0 * radius];
        out.operating = Some(Operating { pinion_torque: Some(torque), pinion_speed: None });
        Case { design: out }
    })
}

fn is_empty_bearing(error: &RotorError) -> bool {
    matches!(error, RotorError::Bearing { error: BearingError::Equilibrium(EquilibriumError::NoContact), .. })
}

/// All bearings of the shaft are computed ones, so that their loads balance the mesh alone.
fn without_springs(mut design: Design) -> Design {
    for rotor in [&mut design.pinion, &mut design.gear] {
        rotor.bearings.retain(|bearing| !matches!(bearing.model, BearingModel::Diagonal(_)));
    }
    design
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Every whole shaft with an equilibrium has one found, and it is one: to 1e-9 of the load.
    #[test]
    fn the_loads_of_a_shaft_are_in_balance(case in cases()) {
        let design = without_springs(case.design);
        for side in Side::BOTH {
            match Rotor::new(&design, side) {
                Ok(rotor) => {
                    let (off, most) = imbalance(&rotor);
                    prop_assert!(off <= 1e-9 * most, "{side:?}: {off:e} of {most:e}");
                }
                // a bearing that the thrust lifts off is named, never passed on without stiffness
                Err(error) => prop_assert!(is_empty_bearing(&error), "{side:?}: {error}"),
            }
        }
    }

    /// A little more torque moves the rings as the linear model on the bearings' stiffness says: the stiffness is the derivative of the
    /// equilibrium, and the beams bend as those of the finite element model.
    #[test]
    fn the_stiffness_is_that_of_the_equilibrium(case in cases()) {
        const MORE: f64 = 1e-4;
        let at = |factor: f64| {
            let mut design = case.design.clone();
            let operating = design.operating.as_mut().unwrap();
            operating.pinion_torque = operating.pinion_torque.map(|torque| torque * factor);
            (Rotors::new(&design), design)
        };
        let ((Ok(here), design), (Ok(below), _), (Ok(above), _)) = (at(1.0), at(1.0 - MORE), at(1.0 + MORE)) else {
            return Err(TestCaseError::reject("a bearing runs empty"));
        };
        let model = Model::new(ModelKind::Fe, &design, &here).unwrap();
        for (side, fe) in Side::BOTH.into_iter().zip(model.rotors()) {
            let rotor = here.get(side);
            let load = rotor.mean_states.mesh_load().unwrap() * (2.0 * MORE);
            let kept: Vec<usize> = (0..fe.coordinates.len()).filter(|&i| fe.coordinates[i].motion() != Some(Motion::ThY)).collect();
            let stiffness = fe.stiffness.select_rows(&kept).select_columns(&kept);
            let place = |station: usize, motion: usize| kept.iter().position(|&i| {
                fe.coordinates[i] == Coordinate::Station(station, Motion::ALL[motion])
            });
            let mut loads = DVector::zeros(kept.len());
            for motion in [0, 1, 2, 3, 5] {
                loads[place(rotor.stations.mesh, motion).unwrap()] = load[motion];
            }
            let moved = stiffness.cholesky().unwrap().solve(&loads);
            for (i, &station) in rotor.stations.bearings.iter().enumerate() {
                let Some(rolling) = &rotor.mean_states.bearings[i] else { continue };
                let state = |rotors: &Rotors| rotors.get(side).mean_states.bearings[i].as_ref().unwrap().state.displacement;
                let found = frames::to_station(&(state(&above) - state(&below)));
                let radius = rolling.bearing.radius();
                let size = moved.amax();
                for motion in [0, 1, 2, 3, 5] {
                    let (arm, expected) = (if motion < 3 { 1.0 } else { radius }, moved[place(station, motion).unwrap()]);
                    // contacts that open and close within the step bend the line a little
                    prop_assert!((found[motion] - expected).abs() * arm <= 2e-3 * size, "{side:?} {i} {motion}: {} {expected}", found[motion]);
                }
            }
        }
    }

    /// The size of the torque counts, the line of action says which way: so the sign of the torque changes nothing, and what loads the
    /// other flank is in balance as well.
    #[test]
    fn reversing_the_torque(case in cases()) {
        let design = without_springs(case.design);
        let mut negative = design.clone();
        negative.operating = Some(Operating { pinion_torque: design.operating.unwrap().pinion_torque.map(|t| -t), pinion_speed: None });
        let mut coast = design.clone();
        for vectors in [&mut coast.mesh.pinion, &mut coast.mesh.gear] {
            vectors.line_of_action = vectors.line_of_action.map(|component| -component);
        }
        for side in Side::BOTH {
            let [one, other] = [&design, &negative].map(|design| Rotor::new(design, side).map(|rotor| rotor.mean_states.bearings));
            prop_assert_eq!(one, other);
            if let Ok(rotor) = Rotor::new(&coast, side) {
                let (off, most) = imbalance(&rotor);
                prop_assert!(off <= 1e-9 * most, "{off:e} of {most:e}");
            }
        }
    }
}

#[test]
fn most_random_shafts_stay_in_contact() {
    use proptest::strategy::ValueTree;
    use proptest::test_runner::TestRunner;
    let mut runner = TestRunner::deterministic();
    let found = (0..200).filter(|_| {
        let case = cases().new_tree(&mut runner).unwrap().current();
        Rotors::new(&case.design).is_ok()
    });
    let found = found.count();
    assert!(found > 120, "{found} of 200: the other tests of this file would say little");
}

#[test]
fn without_torque_and_preload_nothing_is_in_contact() {
    let error = Rotors::new(&tapers(0.0, 0.0)).unwrap_err();
    let name = "bearing at 0.055".to_owned();
    let no_contact = BearingError::Equilibrium(EquilibriumError::NoContact);
    assert_eq!(error.0[0], (Side::Pinion, RotorError::Bearing { name, error: no_contact }));
    assert!(error.to_string().starts_with("pinion shaft: bearing \"bearing at 0.055\": NO_CONTACT: "), "{error}");
    // with preload alone there is a state, and both bearings push alike
    let rotors = Rotors::new(&tapers(0.0, 1e-5)).unwrap();
    let loads: Vec<f64> =
        rotors.pinion.mean_states.bearings.iter().map(|b| b.as_ref().unwrap().state.load[2]).collect();
    assert!(loads[0] > 500.0 && (loads[0] + loads[1]).abs() < 1e-9 * loads[0], "{loads:?}");
}

#[test]
fn what_nothing_holds_is_named() {
    // cylindrical rollers only
    let cylindrical = || vec![taper(0.055, 0.0, 0.017, 0.0), taper(0.13, 0.0, 0.017, 0.0)];
    let good = || vec![taper(0.11, 20.0, 0.017, 1e-5), taper(0.22, -20.0, 0.017, 1e-5)];
    let error = Rotors::new(&axle(300.0, [cylindrical(), good()])).unwrap_err();
    assert_eq!(error.0, [(Side::Pinion, RotorError::Singular(vec![Motion::Y]))]);
    assert!(
        error.to_string().starts_with("pinion shaft: SINGULAR: ")
            && error.to_string().contains("in the axial direction"),
        "{error}"
    );
    // both tapers open under the thrust, which points towards +y on the pinion
    let backwards = vec![taper(0.055, -20.0, 0.017, 0.0), taper(0.13, -20.0, 0.017, 0.0)];
    let error = Rotors::new(&axle(300.0, [backwards, good()])).unwrap_err();
    assert!(matches!(&error.0[0].1, RotorError::GivesWay { .. }), "{error}");
    assert!(error.to_string().starts_with("pinion shaft: UNSUPPORTED_LOAD: bearing \"bearing at 0."), "{error}");
}

/// A load that no bearing of that size carries, in the direction that they are made for.
#[test]
fn a_load_that_is_far_too_large_is_said_to_be() {
    let error = Rotors::new(&tapers(1e9, 1e-5)).unwrap_err();
    assert!(matches!(&error.0[0].1, RotorError::MovesTooFar { .. }), "{error}");
    let text = error.to_string();
    assert!(text.contains("UNSUPPORTED_LOAD: ") && text.contains("by more than a quarter of its radius"), "{text}");
}

#[test]
fn bearings_by_preload_are_those_of_the_bearing_alone() {
    let mut design = ordinary();
    let BearingModel::Roller(mut roller) = taper(0.055, 20.0, 0.017, 0.0).model else { panic!() };
    roller.mean_load = None;
    roller.preload = Some(Preload { x: 300.0, y: 5000.0, z: -200.0 });
    design.pinion.bearings[0].model = BearingModel::Roller(roller);
    let rotors = Rotors::new(&design).unwrap();
    let rolling = rotors.pinion.mean_states.bearings[0].as_ref().unwrap();
    assert!(
        (rolling.state.load - nalgebra::SVector::from([-200.0, 300.0, 5000.0, 0.0, 0.0])).fixed_rows::<3>(0).amax()
            < 1e-8
    );
    assert_eq!((rolling.state.displacement[3], rolling.state.displacement[4]), (0.0, 0.0));
    let expected = frames::stiffness_to_station(&rolling.state.stiffness);
    assert_eq!(rotors.pinion.supports.bearings[0].stiffness, expected);
    // thrust the wrong way
    roller.preload = Some(Preload { x: 300.0, y: -5000.0, z: -200.0 });
    design.pinion.bearings[0].model = BearingModel::Roller(roller);
    let error = Rotors::new(&design).unwrap_err().to_string();
    assert!(error.starts_with("pinion shaft: bearing \"bearing at 0.055\": UNSUPPORTED_LOAD: "), "{error}");
    assert!(error.contains(" 3.0000e2, -5.0000e3 and -2.0000e2 N in x, y and z "), "{error}");
}

#[test]
fn a_state_is_taken_over_exactly_where_nothing_it_depends_on_differs() {
    let design = tapers(300.0, 1e-5);
    let first = Rotors::new(&design).unwrap();
    let is_kept = |rotors: &Rotors, side: Side| {
        Arc::ptr_eq(&rotors.get(side).mean_states.bearings, &first.get(side).mean_states.bearings)
    };
    let neither: [fn(&mut Design); 9] = [
        |d| d.mesh.stiffness *= 2.0,
        |d| d.mesh.damping *= 2.0,
        |d| d.analysis.frequency_lines += 7,
        |d| d.pinion.drive.as_mut().unwrap().position *= 0.9,
        |d| d.pinion.bodies[0].mass *= 2.0,
        |d| d.pinion.bearings[0].name = "another".into(),
        |d| d.pinion.bearings[0].axial_series_stiffness = Some(1e9),
        |d| d.materials.get_mut("steel").unwrap().density *= 1.01,
        |d| d.operating.as_mut().unwrap().pinion_speed = Some(100.0),
    ];
    for (at, change) in neither.iter().enumerate() {
        let mut design = design.clone();
        change(&mut design);
        let again = Rotors::reusing(&design, Some(&first)).unwrap();
        assert!(Side::BOTH.into_iter().all(|side| is_kept(&again, side)), "{at}");
    }
    let mut gear = design.clone();
    gear.gear.bearings[1].position *= 1.01;
    let again = Rotors::reusing(&gear, Some(&first)).unwrap();
    assert!(is_kept(&again, Side::Pinion) && !is_kept(&again, Side::Gear));
    for change in [
        |d: &mut Design| d.operating = Some(Operating { pinion_torque: Some(310.0), pinion_speed: None }),
        |d: &mut Design| d.mesh.pinion.point[2] *= 1.01,
        |d: &mut Design| d.pinion.segments[1].outer_diameter *= 1.01,
        |d: &mut Design| d.pinion.bearings[1].position *= 1.01,
        |d: &mut Design| d.materials.get_mut("steel").unwrap().youngs_modulus *= 1.01,
    ] {
        let mut design = design.clone();
        change(&mut design);
        let again = Rotors::reusing(&design, Some(&first)).unwrap();
        assert_ne!(again.pinion.mean_states.bearings, first.pinion.mean_states.bearings);
        assert_eq!(again.pinion.mean_states, Rotors::new(&design).unwrap().pinion.mean_states);
    }
}
