//! That the random designs are as various as they claim.

use crate::support::random::{config, designs};
use bevelscope::design::{BeamTheory, BearingModel, Side};
use bevelscope::model::Rotors;

#[test]
fn random_designs_hold_what_the_generator_promises() {
    use proptest::strategy::{Strategy, ValueTree};
    use proptest::test_runner::TestRunner;
    let mut runner = TestRunner::new(config(1));
    let (mut fallbacks, mut housings, mut rigid, mut full, mut euler) = (0, 0, 0, 0, 0);
    for _ in 0..200 {
        let design = designs().new_tree(&mut runner).unwrap().current();
        let rotors = Rotors::new(&design).unwrap();
        euler += usize::from(design.analysis.beam_theory == BeamTheory::EulerBernoulli);
        for side in Side::BOTH {
            let (rotor, solved) = (design.rotor(side), rotors.get(side));
            assert!((2..=5).contains(&rotor.segments.len()) && (2..=3).contains(&rotor.bearings.len()));
            for (i, pair) in solved.stations.positions.windows(2).enumerate() {
                let middle = f64::midpoint(pair[0], pair[1]);
                let mut end = 0.0;
                let segment = rotor.segments.iter().find(|segment| {
                    end += segment.length;
                    end > middle
                });
                let diameter = segment.unwrap().outer_diameter;
                assert!(pair[1] - pair[0] > 0.199 * diameter, "element {i}: {pair:?}, diameter {diameter}");
            }
            for bearing in &rotor.bearings {
                rigid += usize::from(matches!(bearing.model, BearingModel::Rigid(_)));
                full += usize::from(matches!(bearing.model, BearingModel::Matrix(_)));
            }
            housings += usize::from(rotor.housing_axial_stiffness.is_some());
            let modes = [solved.bending_x, solved.bending_z];
            fallbacks += modes.iter().filter(|mode| mode.mass_fallback || mode.inertia_fallback).count();
        }
    }
    // out of 400 rotors
    println!("fallbacks {fallbacks}, housings {housings}, rigid {rigid}, full {full}, euler {euler}");
    assert!(fallbacks > 10 && housings > 40 && rigid > 100 && full > 200 && (60..140).contains(&euler));
}
