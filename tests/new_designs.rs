//! New designs: every one that is proposed can be read, has the geometry that was asked for, and solves under its torque.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use bevelscope::comparison::compare;
use bevelscope::design::new::{Answer, BearingKind, Field, Proposal, TypicalBearing, Value, Wishes, shown};
use bevelscope::design::{Design, PairKind, read};
use bevelscope::gear::HypoidBlank;
use bevelscope::model::Rotors;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

fn wishes(answers: &[(Field, &str)]) -> Wishes {
    let mut wishes = Wishes::default();
    for (field, text) in answers {
        wishes.answer(*field, text).unwrap();
    }
    wishes
}

/// The design of a proposal, which must be without any finding.
fn design(proposal: &Proposal) -> Design {
    let text = proposal.text(&proposal.title());
    let reading = read(&text);
    assert_eq!(reading.findings, [], "{text}");
    reading.design.unwrap()
}

/// Reads and solves it on a few lines.
fn assert_solves(proposal: &Proposal) {
    let mut design = design(proposal);
    design.analysis.frequency_lines = 60;
    let pair = design.mesh.geometry.unwrap().pair();
    let (angle, offset) = if proposal.pair.kind.is_parallel() {
        (0.0, proposal.pair.mean_diameters.iter().sum::<f64>() / 2.0)
    } else {
        (90.0, proposal.pair.hypoid.map_or(0.0, |(offset, _)| offset))
    };
    assert!((pair.shaft_angle.to_degrees() - angle).abs() < 1e-6, "{}", pair.shaft_angle.to_degrees());
    assert!((pair.offset - offset).abs() < 1e-9, "{} and {offset} m", pair.offset);
    let arms = (pair.gear.torque_arm() / pair.pinion.torque_arm()).abs();
    assert!((arms / proposal.pair.ratio() - 1.0).abs() < 1e-8, "{arms}");
    let solved = compare(&design).unwrap_or_else(|error| panic!("{error}\n{}", proposal.text("x")));
    for spectrum in [&solved.fe, &solved.enhanced, &solved.basic] {
        assert!(spectrum.mesh_force.iter().all(|force| force.is_finite() && force.norm() > 0.0));
    }
}

#[test]
fn every_kind_and_mounting_solves_with_nothing_else_said() {
    for kind in PairKind::WORDS {
        for pinion in ["overhung", "straddle"] {
            for gear in ["overhung", "straddle"] {
                let asked = [(Field::Kind, *kind), (Field::PinionMounting, pinion), (Field::GearMounting, gear)];
                assert_solves(&Proposal::new(&wishes(&asked)).unwrap());
            }
        }
    }
}

#[test]
fn every_bearing_of_the_list_carries_a_shaft() {
    for bearing in TypicalBearing::all() {
        let name = bearing.name();
        let torque = format!("{}", 5.5e6 * bearing.bore.powi(3));
        let asked = [
            (Field::PinionTorque, torque.as_str()),
            (Field::PinionB1, &name),
            (Field::PinionB2, &name),
            (Field::GearB1, &name),
            (Field::GearTeeth, "17"),
            (Field::PinionTeeth, "16"),
        ];
        assert_solves(&Proposal::new(&wishes(&asked)).unwrap());
    }
}

/// A wish near to what would be proposed, or far from it.
fn answer(field: Field, proposal: &Proposal, pick: f64) -> Option<String> {
    Some(match field.answer() {
        Answer::Word(words) => words[(pick * words.len() as f64) as usize].into(),
        Answer::Bearing => {
            let names: Vec<String> = TypicalBearing::all().map(|bearing| bearing.name()).collect();
            names[(pick * names.len() as f64) as usize].clone()
        }
        Answer::Whole(low, high) => {
            let Some(Value::Number(teeth)) = proposal.answers().remove(&field) else { return None };
            format!("{:.0}", (teeth * 3.0_f64.powf(2.0 * pick - 1.0)).clamp(f64::from(low), f64::from(high)))
        }
        Answer::Number(quantity, low, high) => {
            let Some(Value::Number(value)) = proposal.answers().remove(&field) else { return None };
            let spread: f64 = if field == Field::PinionTorque { 100.0 } else { 2.0 };
            let value = value * spread.powf(2.0 * pick - 1.0) / quantity.to_si(1.0);
            format!("{}", value.clamp(low, high))
        }
    })
}

#[test]
fn random_wishes_solve_or_are_refused_with_the_limit() {
    let mut runner = TestRunner::new(Config { cases: 600, failure_persistence: None, ..Config::default() });
    let accepted = std::cell::Cell::new(0);
    let picks = proptest::collection::vec((0.0..1.0_f64, proptest::bool::weighted(0.35)), Field::ALL.len());
    let cases = (0..PairKind::WORDS.len(), picks);
    let outcome = runner.run(&cases, |(kind, picks)| {
        let mut wishes = wishes(&[(Field::Kind, PairKind::WORDS[kind])]);
        for (field, (pick, is_wanted)) in Field::ALL.into_iter().zip(picks).skip(1) {
            let Ok(so_far) = Proposal::new(&wishes) else { break };
            if is_wanted && field.belongs_to(wishes.kind()) {
                let text = answer(field, &so_far, pick);
                let before = wishes.clone();
                wishes.answer(field, &text.unwrap_or_default()).unwrap_or_else(|error| panic!("{field:?}: {error}"));
                // one wish that cannot be is said, and the rest is tried without it
                if let Err(refusal) = Proposal::new(&wishes) {
                    prop_assert!(refusal.field.belongs_to(wishes.kind()), "{refusal:?}");
                    prop_assert!(!refusal.message.contains("NaN") && refusal.message.len() > 20, "{refusal:?}");
                    wishes = before;
                }
            }
        }
        let proposal = Proposal::new(&wishes).unwrap();
        accepted.set(accepted.get() + usize::from(Field::ALL.iter().filter(|f| wishes.is_given(**f)).count() > 4));
        assert_solves(&proposal);
        Ok(())
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
    assert!(accepted.get() > 200, "{} designs with several wishes", accepted.get());
}

/// Sample 2 of ISO 23509:2016 (annex F.3): the blank with its cutter gives the cones that the standard prints.
#[test]
fn the_hypoid_pair_of_the_standard_comes_out() {
    let blank = HypoidBlank {
        ratio: 42.0 / 13.0,
        offset: 0.015,
        gear_outer_diameter: 0.170,
        // the standard's mean diameter is 141.877 mm
        face_width: (0.170 - 0.141_877) / f64::to_radians(68.321).sin(),
        pinion_spiral_angle: f64::to_radians(49.998),
    };
    let found = blank.pitch(Some(0.0635)).unwrap();
    let [pinion, gear] = found.cones;
    let near =
        |value: f64, expected: f64, within: f64| assert!((value - expected).abs() < within, "{value}, {expected}");
    near(pinion.pitch_angle.to_degrees(), 21.291, 0.01);
    near(gear.pitch_angle.to_degrees(), 68.321, 0.01);
    near(pinion.cone_distance * 1e3, 73.519, 0.02);
    near(gear.cone_distance * 1e3, 76.337, 0.02);
    near(gear.spiral_angle.to_degrees(), 38.609, 0.005);
    near(found.offset_angle.to_degrees(), 11.390, 0.005);
    near(2e3 * pinion.cone_distance * pinion.pitch_angle.sin(), 53.383, 0.005);
}

/// Sample 1 of the standard (annex F.2) from the numbers on its first lines.
#[test]
fn the_spiral_bevel_pair_of_the_standard_comes_out() {
    let asked = [
        (Field::PinionTeeth, "14"),
        (Field::GearTeeth, "39"),
        (Field::GearOuterDiameter, "176.893"),
        (Field::FaceWidth, "25.4 mm"),
    ];
    let proposal = Proposal::new(&wishes(&asked)).unwrap();
    let geometry = design(&proposal).mesh.geometry.unwrap();
    let near = |value: Option<f64>, expected: f64, within: f64| {
        assert!((value.unwrap() - expected).abs() < within, "{value:?}, {expected}");
    };
    near(geometry.pinion_pitch_angle.map(f64::to_degrees), 19.747, 1e-3);
    near(geometry.gear_mean_cone_distance.map(|length| length * 1e3), 81.273, 1e-3);
    near(Some(proposal.pair.mesh_stiffness), 6.4e8, 0.05e8);
}

#[test]
fn what_cannot_be_says_which_limit() {
    for (asked, field, expected) in [
        (
            vec![(Field::PinionTeeth, "20"), (Field::GearTeeth, "19")],
            Field::GearTeeth,
            "at least the pinion's 20 teeth",
        ),
        (vec![(Field::PinionTeeth, "6"), (Field::GearTeeth, "61")], Field::GearTeeth, "at most 60"),
        (
            vec![(Field::Kind, "hypoid"), (Field::GearTeeth, "20"), (Field::PinionTeeth, "13")],
            Field::GearTeeth,
            "at least 26",
        ),
        (vec![(Field::PinionTorque, "15000")], Field::PinionTorque, "the list of bearings ends at 100 mm"),
        (
            vec![(Field::Kind, "hypoid"), (Field::Offset, "100")],
            Field::Offset,
            "1 to 25 % of the gear's outer diameter",
        ),
        (vec![(Field::FaceWidth, "80")], Field::FaceWidth, "0.05 to 0.4 of the outer cone distance"),
        (vec![(Field::SpiralAngle, "55")], Field::SpiralAngle, "must be from 5 to 50 deg"),
        (vec![(Field::PinionB2, "tapered-20")], Field::PinionB2, "carries 300 N m at over 80 MPa"),
        (vec![(Field::GearOuterDiameter, "60")], Field::GearOuterDiameter, "too small for its shaft of 40 mm"),
    ] {
        let refusal = Proposal::new(&wishes(&asked)).unwrap_err();
        assert_eq!(refusal.field, field, "{refusal}");
        assert!(refusal.message.contains(expected), "{refusal}");
    }
    for (field, text, expected) in [
        (Field::PinionTeeth, "3", "a whole number from 5 to 100 is wanted"),
        (Field::PinionTeeth, "14.5", "a whole number from 5 to 100 is wanted"),
        (Field::FaceWidth, "1,5", "write 1.5"),
        (Field::FaceWidth, "0", "must be from 2 to 500 mm"),
        (Field::Hand, "middle", "`middle` is none of right, left"),
        (Field::GearB1, "6208", "is no bearing of the list"),
        (Field::PinionTorque, "5 \u{1b}[2J", "\\u{1b}"),
    ] {
        let refusal = Wishes::default().answer(field, text).unwrap_err();
        assert!(refusal.message.contains(expected), "{refusal}");
        assert!(!refusal.message.contains('\u{1b}'));
    }
}

/// Facts of ISO 15 and ISO 355 for dimension series 02, and what single-row bearings of that size usually have inside.
#[test]
fn the_list_has_sizes_of_the_standards() {
    let named = |name| TypicalBearing::named(name).unwrap();
    let ball = named("deep-groove-40");
    assert_eq!([ball.outside_diameter, ball.width].map(|length| (length * 1e3).round()), [80.0, 18.0]);
    // a 6208 has nine balls of 11.9 to 12.3 mm, whoever makes it
    assert_eq!((ball.elements(), (ball.element_diameter() * 1e4).round()), (9, 120.0));
    let tapered = named("tapered-35");
    assert_eq!((tapered.outside_diameter * 1e3, (tapered.width * 1e5).round()), (72.0, 1825.0));
    assert_eq!((tapered.elements(), tapered.roller_length().map(|length| (length * 1e3).round())), (17, Some(12.0)));
    // ISO 15 and ISO 355 as the catalogues print them, mm: 62.. and 72.. are d x D x B, 302.. d x D x T with the first digit of the
    // ISO 355 series (2: 10 deg to 13 deg 52', 3: to 15 deg 59')
    let standard = [
        ("6204", "30204", 20.0, 47.0, 14.0, 15.25, '2'),
        ("6205", "30205", 25.0, 52.0, 15.0, 16.25, '3'),
        ("6206", "30206", 30.0, 62.0, 16.0, 17.25, '3'),
        ("6207", "30207", 35.0, 72.0, 17.0, 18.25, '3'),
        ("6208", "30208", 40.0, 80.0, 18.0, 19.75, '3'),
        ("6210", "30210", 50.0, 90.0, 20.0, 21.75, '3'),
        ("6212", "30212", 60.0, 110.0, 22.0, 23.75, '3'),
        ("6214", "30214", 70.0, 125.0, 24.0, 26.25, '3'),
        ("6216", "30216", 80.0, 140.0, 26.0, 28.25, '3'),
        ("6220", "30220", 100.0, 180.0, 34.0, 37.0, '3'),
    ];
    for kind in BearingKind::ALL {
        assert_eq!(TypicalBearing::of_kind(kind).count(), standard.len());
        for (bearing, (ball, tapered, d, outside, width, high, series)) in TypicalBearing::of_kind(kind).zip(standard) {
            let is_tapered = kind == BearingKind::Tapered;
            let name = if is_tapered { tapered } else { ball };
            let listed = [bearing.bore, bearing.outside_diameter, bearing.width].map(|length| length * 1e3);
            let expected = [d, outside, if is_tapered { high } else { width }];
            assert!(listed.iter().zip(expected).all(|(one, other)| (one - other).abs() < 1e-9), "{name}: {listed:?}");
            let range = if series == '2' { 10.0..13.87 } else { 13.87..15.99 };
            assert!(!is_tapered || range.contains(&bearing.contact_angle.to_degrees()), "{name}");
        }
    }
    for bearing in TypicalBearing::all() {
        assert_eq!(TypicalBearing::named(&bearing.name()), Some(bearing));
        // the elements fit between the rings and beside one another
        assert!(bearing.element_diameter() < (bearing.outside_diameter - bearing.bore) / 2.0);
        assert!(f64::from(bearing.elements()) * bearing.element_diameter() < 3.1 * bearing.pitch_diameter());
    }
    assert_eq!(TypicalBearing::of_kind(BearingKind::Tapered).count(), 10);
}

#[test]
fn answers_are_shown_with_their_unit() {
    let proposal = Proposal::new(&wishes(&[(Field::FaceWidth, "1 in")])).unwrap();
    let answers = proposal.answers();
    assert_eq!(shown(Field::FaceWidth, &answers[&Field::FaceWidth]), "25.4 mm");
    assert_eq!(shown(Field::PinionSpeed, &answers[&Field::PinionSpeed]), "1200 rpm");
    assert_eq!(shown(Field::PinionTeeth, &answers[&Field::PinionTeeth]), "14");
    assert_eq!(shown(Field::SpiralAngle, &answers[&Field::SpiralAngle]), "35 deg");
    for kind in PairKind::WORDS {
        let proposal = Proposal::new(&wishes(&[(Field::Kind, kind)])).unwrap();
        let answers = proposal.answers();
        for field in Field::ALL {
            assert_eq!(answers.contains_key(&field), field.belongs_to(proposal.pair.kind), "{kind} {field:?}");
        }
    }
}

/// With this cutter the pinion came out at 56.5 deg and its gear at 32.7.
#[test]
fn a_hypoid_gear_is_flatter_than_its_pinion() {
    let asked = [(Field::Kind, "hypoid"), (Field::GearOuterDiameter, "400"), (Field::CutterRadius, "40")];
    let refusal = Proposal::new(&wishes(&asked)).unwrap_err();
    assert_eq!(refusal.field, Field::CutterRadius);
    assert!(refusal.message.contains("a gear of at least 45 deg") && refusal.message.contains("would do"), "{refusal}");
    let mut found = 0;
    for cutter in 1..60 {
        let cutter = format!("{}", 10 * cutter);
        let asked =
            [(Field::Kind, "hypoid"), (Field::GearOuterDiameter, "400"), (Field::CutterRadius, cutter.as_str())];
        let Ok(proposal) = Proposal::new(&wishes(&asked)) else { continue };
        let [pinion, gear] = [0, 1].map(|at| proposal.pair.cone(at).unwrap().0.to_degrees());
        assert!(gear >= 45.0 && pinion < gear, "{cutter} mm: {pinion} and {gear} deg");
        found += 1;
    }
    assert!(found > 5, "{found}");
}

/// A deep groove ball bearing has two shoulders, an angular contact ball bearing one.
#[test]
fn only_bearings_with_one_shoulder_are_warned_of() {
    let warnings = |bearing: &str| {
        let asked = [(Field::PinionB1, bearing), (Field::PinionB2, bearing)];
        let rotors = Rotors::new(&design(&Proposal::new(&wishes(&asked)).unwrap())).unwrap();
        rotors.pinion.mean_states.warnings().map(|(_, warning)| warning.to_string()).collect::<Vec<_>>().join("; ")
    };
    assert!(!warnings("deep-groove-50").contains("shoulder"), "{}", warnings("deep-groove-50"));
}
