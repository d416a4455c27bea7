//! Forces on both shafts, the picture, the estimate and the import, of designs with any gear data.
//!
//! The published pair is sample 1 of ISO 23509:2016, annex F, with the loads of ISO/TR 10300-30:2024.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use bevelscope::design::library::SHIPPED;
use bevelscope::design::{
    Design, Editor, Hand, MeshGeometry, Operating, PairKind, Side, Turns, grid::Sheet, grid::Shown, read,
};
use bevelscope::gear::{COLUMNS, Force};
use bevelscope::pair::{Estimate, Flank, PairFigures, Scene, Shape, edit_of, read_flanks, scenes, spiral_angle};
use nalgebra::{Matrix3, Rotation3, Vector3};
use proptest::prelude::*;

fn shipped(stem: &str) -> &'static str {
    SHIPPED.iter().find(|design| design.file_name == format!("{stem}.toml")).unwrap().text
}

fn design(stem: &str) -> Design {
    read(shipped(stem)).design.unwrap()
}

/// A design with these gear data and that torque (N m).
fn with(geometry: MeshGeometry, torque: Option<f64>) -> Design {
    let mut design = design("tapered-axle");
    design.mesh.geometry = Some(geometry);
    let [pinion, gear] = design.vectors_of_geometry().unwrap();
    (design.mesh.pinion, design.mesh.gear) = (pinion, gear);
    design.operating = Some(Operating { pinion_torque: torque, pinion_speed: None });
    design
}

fn geometries() -> impl Strategy<Value = MeshGeometry> {
    let kind = prop_oneof![
        Just(PairKind::SpiralBevel),
        Just(PairKind::StraightBevel),
        Just(PairKind::Hypoid),
        Just(PairKind::Spur),
        Just(PairKind::Helical),
    ];
    let hand = prop_oneof![Just(Hand::Right), Just(Hand::Left)];
    let turns = prop_oneof![Just(Turns::Positive), Just(Turns::Negative)];
    let angles = (0.2..0.5_f64, 0.2..0.7_f64, 0.6..1.3_f64, 0.05..0.8_f64, 0.05..0.7_f64);
    let sizes = (0.05..0.2_f64, 0.05..0.2_f64, 0.02..0.1_f64, 0.05..0.3_f64);
    (kind, hand, turns, angles, sizes, [-3.0..3.0_f64, -3.0..3.0]).prop_map(
        |(kind, hand, turns, angles, (cone_p, cone_g, dia_p, dia_g), azimuths)| {
            let (pressure_angle, pitch_p, pitch_g, spiral_p, spiral_g) = angles;
            let bevel = |value: f64| Some(value).filter(|_| !kind.is_parallel());
            let leans = |value: f64| Some(value).filter(|_| kind.has_hand() && !kind.is_parallel());
            let parallel = |value: f64| Some(value).filter(|_| kind.is_parallel());
            let is_hypoid = kind == PairKind::Hypoid;
            MeshGeometry {
                kind,
                pressure_angle,
                hand: Some(hand).filter(|_| kind.has_hand()),
                pinion_turns: turns,
                pinion_azimuth: azimuths[0],
                gear_azimuth: azimuths[1],
                pinion_pitch_angle: bevel(pitch_p),
                gear_pitch_angle: bevel(pitch_g),
                pinion_mean_cone_distance: bevel(cone_p),
                gear_mean_cone_distance: bevel(if is_hypoid { cone_g } else { cone_p }),
                pinion_spiral_angle: leans(spiral_p),
                gear_spiral_angle: leans(if is_hypoid { spiral_g } else { spiral_p }),
                pinion_apex: bevel(-0.05),
                gear_apex: bevel(0.01),
                pinion_pitch_diameter: parallel(dia_p),
                gear_pitch_diameter: parallel(dia_g),
                helix_angle: parallel(spiral_p).filter(|_| kind.has_hand()),
            }
        },
    )
}

/// The force in space, in the frame that both members share.
fn in_space(figures: &PairFigures, side: Side, force: Force) -> Vector3<f64> {
    let pair = figures.pair.unwrap();
    let member = if side == Side::Pinion { pair.pinion } else { pair.gear };
    let radial = member.across.cross(&member.axis);
    member.axis * force.axial - radial * force.radial + member.across * force.tangential
}

fn size(force: Force) -> f64 {
    Vector3::new(force.axial, force.radial, force.tangential).norm()
}

fn is_sound(scene: &Scene) -> bool {
    let [low, high] = scene.bounds();
    low.iter().chain(high.iter()).all(|value| value.is_finite()) && (high - low).max() > 0.0
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// What the pinion pushes pushes back: both forces are one physical vector and its opposite, of the size of the normal force,
    /// and turn their shafts by arm times normal force.
    #[test]
    fn action_is_reaction(geometry in geometries(), torque in prop_oneof![Just(None), (-900.0..900.0_f64).prop_map(Some)]) {
        let figures = PairFigures::new(&with(geometry, torque));
        let normal = figures.normal_force.unwrap();
        let [pinion, gear] = [figures.pinion.force.unwrap(), figures.gear.force.unwrap()];
        prop_assert!((normal * figures.pinion.torque_arm.abs() - torque.unwrap_or(1.0).abs()).abs() < 1e-9 * (1.0 + normal));
        for force in [pinion, gear] {
            prop_assert!((size(force) - normal).abs() <= 1e-9 * normal);
        }
        let together = in_space(&figures, Side::Pinion, pinion) + in_space(&figures, Side::Gear, gear);
        prop_assert!(together.norm() <= 1e-9 * normal, "{together}");
        for (side, force, sign) in [(Side::Pinion, pinion, -1.0), (Side::Gear, gear, 1.0)] {
            let shaft = figures.shaft(side);
            let [x, _, z] = shaft.vectors.point;
            let turning = force.tangential * x.hypot(z);
            prop_assert!((turning - sign * shaft.torque_arm * normal).abs() <= 1e-9 * normal, "{side:?}");
        }
    }

    /// At a right angle without offset each member's thrust is the other's separating force.
    #[test]
    fn at_a_right_angle_thrust_and_separating_force_change_places(mut geometry in geometries(), pitch in 0.2..1.3_f64) {
        prop_assume!(matches!(geometry.kind, PairKind::SpiralBevel | PairKind::StraightBevel));
        geometry.pinion_pitch_angle = Some(pitch);
        geometry.gear_pitch_angle = Some(std::f64::consts::FRAC_PI_2 - pitch);
        let figures = PairFigures::new(&with(geometry, Some(100.0)));
        let [pinion, gear] = [figures.pinion.force.unwrap(), figures.gear.force.unwrap()];
        let normal = figures.normal_force.unwrap();
        prop_assert!((gear.axial - pinion.radial).abs() <= 1e-9 * normal);
        prop_assert!((gear.radial - pinion.axial).abs() <= 1e-9 * normal);
        prop_assert_eq!(figures.pulls_into_mesh(), pinion.axial < -1e-9 * normal);
        prop_assert_eq!(figures.pulls_into_mesh(), figures.thrust().starts_with("thrust pulls the pinion into mesh"));
    }

    /// Of any pair there is one picture of finite size, and of its vectors alone one a shaft; arrows are to each other as the components.
    #[test]
    fn every_pair_can_be_drawn(geometry in geometries()) {
        let mut design = with(geometry, Some(100.0));
        let figures = PairFigures::new(&design);
        let drawn = scenes(&design, &figures);
        prop_assert!(drawn.len() == 1 && drawn.iter().all(is_sound));
        for side in Side::BOTH {
            let force = figures.shaft(side).force.unwrap();
            let length = |wanted: char| drawn[0].shapes.iter().find_map(|shape| match shape {
                Shape::Force { from, to, side: of, letter } if *of == side && *letter == wanted => Some((to - from).norm()),
                _ => None,
            });
            let (first, other) = if geometry.kind.is_parallel() { ('t', force.tangential) } else { ('a', force.axial) };
            // seen along an offset the radial force is foreshortened
            if geometry.kind != PairKind::Hypoid {
                let ratio = length('r').unwrap() * other.abs() - length(first).unwrap() * force.radial.abs();
                prop_assert!(ratio.abs() <= 1e-9 * size(force) * length('r').unwrap().max(length(first).unwrap()));
            }
        }
        design.mesh.geometry = None;
        let figures = PairFigures::new(&design);
        let drawn = scenes(&design, &figures);
        prop_assert!(drawn.len() == 2 && drawn.iter().all(is_sound));
    }

    /// The mesh point may lie anywhere round the shafts: the forces are the same.
    #[test]
    fn azimuths_turn_the_picture_and_not_the_forces(geometry in geometries()) {
        let plain = MeshGeometry { pinion_azimuth: 0.0, gear_azimuth: 0.0, ..geometry };
        let [turned, plain] = [geometry, plain].map(|geometry| PairFigures::new(&with(geometry, Some(50.0))));
        for side in Side::BOTH {
            let [a, b] = [turned.shaft(side).force.unwrap(), plain.shaft(side).force.unwrap()];
            let difference = Vector3::new(a.axial - b.axial, a.radial - b.radial, a.tangential - b.tangential);
            prop_assert!(difference.norm() <= 1e-9 * size(a), "{a:?} {b:?}");
            let turn = Rotation3::from_axis_angle(
                &Vector3::y_axis(),
                if side == Side::Pinion { geometry.pinion_azimuth } else { geometry.gear_azimuth },
            );
            let point = Vector3::from(plain.shaft(side).vectors.point);
            prop_assert!((turn * point - Vector3::from(turned.shaft(side).vectors.point)).norm() < 1e-12);
            prop_assert!((Matrix3::from(turn).determinant() - 1.0).abs() < 1e-12);
        }
    }
}

// F_a/F_t = 0.80915 and F_r/F_t = 0.18162 at F_t = 10925.3 N; T_g/T_p is the ratio of teeth.
#[test]
fn figures_of_the_published_pair() {
    let figures = PairFigures::new(&design("tapered-axle"));
    let force = figures.pinion.force.unwrap();
    assert!((force.axial / 10925.3 - 0.80915).abs() < 1e-4 && (force.radial / 10925.3 - 0.18162).abs() < 1e-4);
    assert!((figures.normal_force.unwrap() / 14193.3 - 1.0).abs() < 1e-4);
    let arms = figures.arms.unwrap();
    assert!(
        (arms.teeth, arms.deviation().as_str()) == ([14, 39], "0.00 %")
            && (arms.ratio * 14.0 / 39.0 - 1.0).abs() < 2e-4
    );
    assert_eq!(figures.thrust(), "thrust pushes the pinion out of mesh on this flank; gear: away from its apex");
    assert!((figures.mesh_frequency.unwrap() - 280.0).abs() < 1e-9);
}

#[test]
fn a_pair_without_torque_is_shown_under_one_newton_metre() {
    let figures = PairFigures::new(&design("overhung-elastic"));
    let normal = figures.normal_force.unwrap();
    assert!(figures.torque.is_none() && (normal * figures.pinion.torque_arm.abs() - 1.0).abs() < 1e-12);
    // a line of action through the axis turns nothing
    let mut design = design("overhung-elastic");
    design.mesh.pinion.line_of_action = [0.0, 1.0, 0.0];
    let figures = PairFigures::new(&design);
    assert!(figures.normal_force.is_none() && figures.pinion.force.is_none() && figures.arms.is_none());
    assert_eq!(figures.thrust(), "no thrust: the line of action meets the pinion's axis");
    assert!(!figures.pulls_into_mesh());
    assert!(scenes(&design, &figures).iter().all(is_sound));
}

/// The sign of a torque looks like a choice of the flank, which it is not.
#[test]
fn a_negative_torque_is_told_that_only_its_size_counts() {
    let text = shipped("tapered-axle");
    let line = text.lines().find(|line| line.starts_with("pinion_torque_n_m")).unwrap();
    let reading = read(&text.replace(line, "pinion_torque_n_m = -300.0"));
    let [finding] = &reading.findings[..] else { panic!("{:?}", reading.findings) };
    assert_eq!(finding.key_path.to_string(), "operating.pinion_torque_n_m");
    assert!(finding.message.contains("only its size counts") && reading.design.is_some(), "{}", finding.message);
    assert!(finding.hint.as_deref().unwrap().contains("pinion_turns"));
    assert_eq!(read(text).findings, []);
}

// ISO 10300-1, method B: sample 1 has 21.59 mm at 35 deg, 6.4e8 N/m.
#[test]
fn the_estimate_says_its_sum_and_is_one_edit() {
    let estimate = Estimate::new(0.02159, 35_f64.to_radians()).unwrap();
    assert_eq!(
        (estimate.written().as_str(), estimate.formula.as_str()),
        ("6.435e8", "20 N/(mm um) x 21.590 mm / cos^2(35.000 deg)")
    );
    assert_eq!(Estimate::new(0.02, 0.0).unwrap().formula, "20 N/(mm um) x 20.000 mm");
    let mut editor = Editor::new(shipped("tapered-axle")).unwrap();
    let applied = editor.apply(&estimate.edit().unwrap()).unwrap();
    assert_eq!(applied.name.as_str(), "stiffness of the mesh (estimate, ISO 10300-1)");
    assert_eq!(editor.reading().design.as_ref().unwrap().mesh.stiffness, 6.435e8);
    editor.undo();
    assert_eq!(editor.text(), shipped("tapered-axle"));
    let geometry = |stem: &str| design(stem).mesh.geometry.unwrap();
    let degrees = |stem: &str| spiral_angle(&geometry(stem)).unwrap().to_degrees();
    assert!((degrees("tapered-axle") - 35.0).abs() < 1e-9 && (degrees("straddle-helical") - 20.0).abs() < 1e-9);
    // of a hypoid pair the mean of 49.998 and 38.609
    assert!((degrees("tapered-hypoid") - 44.3035).abs() < 1e-9);
}

#[test]
fn an_import_is_one_edit_that_can_be_taken_back() {
    let flank = "coast,5.1e8,4,0,0,27.46,-0.76975,0.39173,0.50401,0,0,76.49,0.76975,0.50401,0.39173";
    let flanks = read_flanks(&format!("{}\n{flank}\n", COLUMNS.join(","))).unwrap();
    assert_eq!(Flank::Drive.of(&flanks).unwrap_err(), "there is no line for the flank drive");
    for stem in ["tapered-axle", "overhung-elastic"] {
        let mut editor = Editor::new(shipped(stem)).unwrap();
        let edit = edit_of(Flank::Coast.of(&flanks).unwrap(), &editor, "m1.csv");
        let applied = editor.apply(&edit).unwrap();
        assert_eq!(applied.name.as_str(), "averaged mesh numbers of the coast flank");
        let mesh = &editor.reading().design.as_ref().unwrap().mesh;
        assert_eq!((mesh.stiffness, mesh.transmission_error, mesh.geometry), (5.1e8, 4e-6, None));
        assert!((mesh.gear.point[2] - 0.07649).abs() < 1e-15);
        assert!(editor.undo().is_some() && editor.undo().is_none());
        assert_eq!(editor.text(), shipped(stem));
    }
}

#[test]
fn mesh_vectors_that_follow_from_gear_data_are_shown_and_not_wanted() {
    let mut editor = Editor::new(shipped("tapered-axle")).unwrap();
    let cells = |editor: &Editor| editor.grid(&Sheet::mesh_side(Side::Pinion)).rows[0].cells.clone();
    let shown: Vec<String> = cells(&editor).iter().map(|cell| cell.shown.text().to_owned()).collect();
    // the mesh point of sample 1 lies 27.4595 mm from the axis, the line of action is that of its right-hand pinion
    assert!(
        shown[2].starts_with("27.459") && shown[3].starts_with("0.76975") && shown[4].starts_with("-0.6228"),
        "{shown:?}"
    );
    assert!(cells(&editor).iter().all(|cell| cell.shown.is_derived() && !cell.required));
    // an edit of something else does not make them edits
    let stiffness = Estimate::new(0.02, 0.5).unwrap().edit().unwrap();
    editor.apply(&stiffness).unwrap();
    let grid = editor.grid(&Sheet::mesh_side(Side::Pinion));
    assert!(bevelscope::design::changed_cells(editor.saved_text(), &grid).is_empty());
    // while the gear data are wrong nobody knows
    let path = "mesh.geometry.hand".parse().unwrap();
    editor.apply(&bevelscope::design::Edit::Remove { path }).unwrap();
    assert!(cells(&editor).iter().all(|cell| cell.shown == Shown::Derived("?".into())));
    let geometry = editor.grid(&Sheet::mesh_geometry());
    let hand = geometry.rows[0].cells.iter().find(|cell| cell.column.key == "hand").unwrap();
    assert!(!hand.findings.is_empty(), "what is missing is said beside its cell");
}

proptest! {
    /// What a mesh point or a line of action has of an axis is zero, or worth saying.
    #[test]
    fn rounding_is_no_component(geometry in geometries(), quarter in 0..4_u8) {
        let azimuth = f64::from(quarter) * std::f64::consts::FRAC_PI_2;
        let geometry = MeshGeometry { pinion_azimuth: azimuth, gear_azimuth: azimuth, ..geometry };
        let design = with(geometry, None);
        for vectors in [design.mesh.pinion, design.mesh.gear] {
            for vector in [vectors.point, vectors.line_of_action].map(Vector3::from) {
                let least = 1e-9 * vector.norm();
                prop_assert!(vector.iter().all(|component| *component == 0.0 || component.abs() >= least), "{vector}");
            }
            // at a quarter turn one of both is nothing
            prop_assert!(vectors.point[0] == 0.0 || vectors.point[2] == 0.0);
        }
    }
}
