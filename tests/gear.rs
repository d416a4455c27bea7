//! Mesh points, lines of action and forces from gear data.
//!
//! The published pairs are samples 1 and 2 of ISO 23509:2016, annex F, with the loads of ISO/TR 10300-30:2024.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use bevelscope::design::MeshVectors;
use bevelscope::gear::{Cone, LightLoad, Pair, Pitch, Teeth, mean_mesh_stiffness};
use bevelscope::model::mesh_vector;
use nalgebra::{Matrix3, Rotation3, Vector3, Vector6};
use proptest::prelude::*;

fn cone(pitch_angle: f64, cone_distance: f64, spiral_angle: f64) -> Cone {
    let [pitch_angle, spiral_angle] = [pitch_angle, spiral_angle].map(f64::to_radians);
    Cone { pitch_angle, cone_distance: cone_distance / 1e3, spiral_angle }
}

fn sample_1(hand: f64, turns: f64) -> Pair {
    let cones = [cone(19.747, 81.273, 35.0), cone(70.253, 81.273, 35.0)];
    Pair::new(&Teeth { pressure_angle: 20_f64.to_radians(), hand, turns }, &Pitch::Bevel { cones })
}

fn sample_2(hand: f64, turns: f64) -> Pair {
    let cones = [cone(21.291, 73.519, 49.998), cone(68.321, 76.337, 38.609)];
    Pair::new(&Teeth { pressure_angle: 17.747_f64.to_radians(), hand, turns }, &Pitch::Bevel { cones })
}

#[track_caller]
fn assert_near(found: Vector3<f64>, expected: [f64; 3], tolerance: f64) {
    assert!((found - Vector3::from(expected)).amax() <= tolerance, "{found} for {expected:?}");
}

#[test]
fn vectors_of_the_published_pairs() {
    // mm, unit vectors, m, to the digits that are printed
    for (pair, p_p, n_p, p_g, n_g, arms) in [
        (
            sample_1(1.0, 1.0),
            [0.0, 76.4936, 27.4595],
            [0.76975, -0.62285, 0.13980],
            [0.0, 27.4595, 76.4936],
            [-0.76975, 0.13980, -0.62285],
            [0.021_137, -0.058_881],
        ),
        (
            sample_1(1.0, -1.0),
            [0.0, 76.4936, 27.4595],
            [-0.76975, 0.39173, 0.50401],
            [0.0, 27.4595, 76.4936],
            [0.76975, 0.50401, 0.39173],
            [-0.021_137, 0.058_881],
        ),
        (
            sample_2(1.0, 1.0),
            [0.0, 68.5012, 26.6951],
            [0.61222, -0.79045, 0.01910],
            [0.0, 28.1994, 70.9375],
            [-0.74424, 0.06371, -0.66487],
            [0.016_343, -0.052_794],
        ),
    ] {
        assert_near(pair.pinion.point * 1e3, p_p, 6e-5);
        assert_near(pair.pinion.line_of_action, n_p, 6e-6);
        assert_near(pair.gear.point * 1e3, p_g, 6e-5);
        assert_near(pair.gear.line_of_action, n_g, 6e-6);
        assert!((pair.pinion.torque_arm() - arms[0]).abs() < 6e-7 && (pair.gear.torque_arm() - arms[1]).abs() < 6e-7);
    }
    // the other hand turning the other way: the mirror image
    let (right, left) = (sample_1(1.0, 1.0), sample_1(-1.0, -1.0));
    let mirrored = right.pinion.line_of_action.component_mul(&Vector3::new(-1.0, 1.0, 1.0));
    assert_near(left.pinion.line_of_action, mirrored.into(), 1e-15);
}

#[test]
fn normal_forces_shaft_angles_and_offsets_are_the_published_ones() {
    assert!((sample_1(1.0, 1.0).normal_force(300.0) / 14193.3 - 1.0).abs() < 1e-4);
    // the standard's own mean diameter, 53.383 mm: cone distance and pitch angle are rounded
    let sine = 21.291_f64.to_radians().sin();
    let cones = [cone(21.291, 53.383 / 2.0 / sine, 49.998), cone(68.321, 76.337, 38.609)];
    let teeth = Teeth { pressure_angle: 17.747_f64.to_radians(), hand: 1.0, turns: 1.0 };
    let force = Pair::new(&teeth, &Pitch::Bevel { cones }).normal_force(-250.0);
    assert!((force / 15298.7 - 1.0).abs() < 1e-4, "{force}");
    for (pair, offset) in [(sample_1(1.0, 1.0), 0.0), (sample_2(1.0, 1.0), 15.0), (sample_2(-1.0, 1.0), 15.0)] {
        assert!((pair.shaft_angle.to_degrees() - 90.0).abs() < 2e-2, "{}", pair.shaft_angle.to_degrees());
        assert!((pair.offset * 1e3 - offset).abs() < 1e-2, "{}", pair.offset * 1e3);
    }
    for (pair, ratio) in [(sample_1(1.0, 1.0), 14.0 / 39.0), (sample_2(1.0, 1.0), 13.0 / 42.0)] {
        let arms = (pair.pinion.torque_arm() / pair.gear.torque_arm()).abs();
        assert!((arms / ratio - 1.0).abs() < 2e-4, "{arms} {ratio}");
    }
}

// F_a/F_t = 0.80915 and F_r/F_t = 0.18162 for sample 1 with the thrust away from the apex, -0.50891 and 0.65477 into mesh.
#[test]
fn force_components_are_those_of_textbooks() {
    for (turns, axial, radial) in [(1.0, 0.80915, 0.18162), (-1.0, -0.50891, 0.65477)] {
        let pair = sample_1(1.0, turns);
        let [pinion, gear] = pair.forces(pair.normal_force(300.0));
        let tangential = 300.0 / 0.027_459_5;
        assert!((pinion.tangential + turns * tangential).abs() < 1e-5 * tangential, "{pinion:?}");
        assert!((pinion.axial / tangential - axial).abs() < 1e-5 && (pinion.radial / tangential - radial).abs() < 1e-5);
        // at a right angle each member's thrust is the other's separating force
        assert!((gear.axial - pinion.radial).abs() < 1e-6 * tangential, "{gear:?}");
        assert!((gear.radial - pinion.axial).abs() < 1e-6 * tangential, "{gear:?}");
        // the gear turns the other way; its torque is larger by the ratio of teeth
        assert!((gear.tangential * 0.076_493_6 * turns + 300.0 * 39.0 / 14.0).abs() < 0.1, "{gear:?}");
    }
}

#[test]
fn spur_and_helical_pairs_push_along_their_lines_of_action() {
    for helix in [0.0, 20.0_f64.to_radians()] {
        let teeth = Teeth { pressure_angle: 0.35, hand: 1.0, turns: 1.0 };
        let pair = Pair::new(&teeth, &Pitch::Parallel { radii: [0.03, 0.09], helix_angle: helix });
        assert!((pair.pinion.torque_arm() - 0.03 * 0.35_f64.cos() * helix.cos()).abs() < 1e-16);
        assert!((pair.gear.torque_arm() + 0.09 * 0.35_f64.cos() * helix.cos()).abs() < 1e-16);
        assert!(pair.shaft_angle == 0.0 && (pair.offset - 0.12).abs() < 1e-16);
        let [pinion, gear] = pair.forces(1000.0);
        assert!(pinion.radial > 0.0 && (pinion.radial - gear.radial).abs() < 1e-9, "they separate");
        assert!((pinion.axial + gear.axial).abs() < 1e-9 && (pinion.axial > 0.0) == (helix > 0.0), "{pinion:?}");
    }
}

fn pairs() -> impl Strategy<Value = Pair> {
    let signs = || prop_oneof![Just(1.0), Just(-1.0)];
    let teeth = (0.2..0.5_f64, signs(), signs()).prop_map(|(pressure_angle, hand, turns)| Teeth {
        pressure_angle,
        hand,
        turns,
    });
    let cones = ((0.2..0.7_f64, 0.05..0.2_f64, 0.0..0.9_f64), (0.6..1.3_f64, 0.05..0.2_f64, 0.0..0.7_f64));
    let bevel = cones.prop_map(|(p, g)| {
        let cone = |(pitch_angle, cone_distance, spiral_angle)| Cone { pitch_angle, cone_distance, spiral_angle };
        Pitch::Bevel { cones: [cone(p), cone(g)] }
    });
    let parallel = ([0.02..0.1_f64, 0.05..0.3_f64], 0.0..0.6_f64)
        .prop_map(|(radii, helix_angle)| Pitch::Parallel { radii, helix_angle });
    (teeth, prop_oneof![bevel, parallel]).prop_map(|(teeth, pitch)| Pair::new(&teeth, &pitch))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    /// A mesh spring does not notice when the whole assembly moves as one rigid body: h_p q_p - h_g q_g = 0. It fails for a left-handed
    /// frame, and for lines of action that are not one physical vector.
    #[test]
    fn the_mesh_does_not_notice_rigid_motion(
        pair in pairs(),
        azimuths in [-3.0..3.0_f64, -3.0..3.0_f64],
        stations in [-0.1..0.1_f64, -0.1..0.1_f64],
        (translation, rotation) in ([-1.0..1.0_f64, -1.0..1.0, -1.0..1.0], [-1.0..1.0_f64, -1.0..1.0, -1.0..1.0]),
    ) {
        let (translation, rotation) = (Vector3::from(translation), Vector3::from(rotation));
        let mut stretch = Vec::new();
        for (member, (azimuth, station)) in [pair.pinion, pair.gear].iter().zip(azimuths.into_iter().zip(stations)) {
            let (point, line) = member.turned(azimuth);
            // the shaft's own frame in space: its z is where the mesh point was before it was turned back by the azimuth
            let own = Matrix3::from_columns(&[member.across, member.axis, member.across.cross(&member.axis)]);
            prop_assert!((own.determinant() - 1.0).abs() < 1e-12, "a right-handed frame");
            let frame = own * Rotation3::from_axis_angle(&Vector3::y_axis(), -azimuth).matrix();
            let node = member.origin + member.axis * station;
            let moved = frame.transpose() * (translation + rotation.cross(&node));
            let turned = frame.transpose() * rotation;
            let q = Vector6::new(moved.x, moved.y, moved.z, turned.x, turned.y, turned.z);
            let relative = point - Vector3::new(0.0, station, 0.0);
            stretch.push(mesh_vector(&MeshVectors { point: relative.into(), line_of_action: line.into() }).dot(&q));
        }
        prop_assert!((stretch[0] - stretch[1]).abs() < 1e-13, "{stretch:?}");
    }

    /// The arm is that of the line of action, whatever the azimuth, and both members see the same force in space.
    #[test]
    fn both_members_see_one_line_of_action(pair in pairs(), azimuth in -3.0..3.0_f64) {
        let (point, line) = pair.pinion.turned(azimuth);
        prop_assert!((point.cross(&line).y - pair.pinion.torque_arm()).abs() < 1e-15);
        prop_assert!((point - Vector3::new(pair.pinion.point.z * azimuth.sin(), point.y, pair.pinion.point.z * azimuth.cos())).amax() < 1e-15);
        prop_assert!((line.norm() - 1.0).abs() < 1e-14);
        // what one member pushes the other takes: the same force in space
        let world = |member: &bevelscope::gear::Member| {
            Matrix3::from_columns(&[member.across, member.axis, member.across.cross(&member.axis)]) * member.line_of_action
        };
        prop_assert!((world(&pair.pinion) - world(&pair.gear)).amax() < 1e-13);
    }

    /// The arms are to each other as r cos(spiral angle) of both members, which is the ratio of teeth.
    #[test]
    fn the_torque_arm_ratio_is_exact(pitch in [0.2..0.7_f64, 0.6..1.3], distance in 0.05..0.2_f64, spiral in [0.0..0.9_f64, 0.0..0.7]) {
        let cones = [0, 1].map(|i| Cone { pitch_angle: pitch[i], cone_distance: distance, spiral_angle: spiral[i] });
        let pair = Pair::new(&Teeth { pressure_angle: 0.35, hand: 1.0, turns: 1.0 }, &Pitch::Bevel { cones });
        let arm = |i: usize| distance * pitch[i].sin() * spiral[i].cos();
        let ratio = pair.pinion.torque_arm() / pair.gear.torque_arm();
        prop_assert!((ratio.abs() / (arm(0) / arm(1)) - 1.0).abs() < 1e-13, "{ratio}");
    }
}

// Sample 1: 20 N/(mm um) over 21.59 mm, along the normal at 35 deg: 6.4e8 N/m.
#[test]
fn the_mean_mesh_stiffness_is_that_of_the_standard() {
    let stiffness = mean_mesh_stiffness(0.02159, 35_f64.to_radians()).unwrap();
    assert!((stiffness / 6.435e8 - 1.0).abs() < 1e-3, "{stiffness:e}");
    assert!(mean_mesh_stiffness(0.0, 0.5).is_err() && mean_mesh_stiffness(f64::NAN, 0.5).is_err());
    // however wide and steep, an estimate that is not refused can be computed with
    for (width, degrees) in [(1e302, 0.0), (1e305, 0.0), (f64::INFINITY, 0.0), (0.02, 89.999_999_9), (0.02, 80.1)] {
        assert!(mean_mesh_stiffness(width, f64::to_radians(degrees)).is_err(), "{width} m, {degrees} deg");
    }
    assert!(mean_mesh_stiffness(10.0, f64::to_radians(80.0)).unwrap() < 1e13);
    assert!(mean_mesh_stiffness(0.02, 1.6).is_err() && mean_mesh_stiffness(0.02, -0.1).is_err());
}

/// ISO 10300-1, equations 11 to 13, and the fourth root of ISO 6336-1: at 6.25 N/mm a sixteenth, and a half.
#[test]
fn light_load_softens_the_mesh() {
    for (load, bevel, cylindrical) in [(6.25e3, 0.0625, 0.5), (100e3, 1.0, 1.0), (300e3, 1.0, 1.0)] {
        assert!((LightLoad::Bevel.factor(load) - bevel).abs() < 1e-15);
        assert!((LightLoad::Cylindrical.factor(load) - cylindrical).abs() < 1e-15);
    }
}
