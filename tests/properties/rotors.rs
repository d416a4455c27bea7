//! One shaft: bending modes, statics, effective masses.

use crate::support::dense;
use crate::support::random::{config, designs};
use bevelscope::design::{Design, RotorDesign, Side};
use bevelscope::model::Rotors;
use bevelscope::rotor::{MeanStates, Rotor, ShaftMatrices, Stations, Supports};
use nalgebra::DMatrix;
use proptest::prelude::*;
use std::f64::consts::TAU;

proptest! {
    #![proptest_config(config(60))]

    /// The Initial Parameter Method has no discretisation error, and finite elements bound it from above.
    #[test]
    fn finite_elements_of_one_plane_tend_to_the_initial_parameter_method(design in designs()) {
        for side in Side::BOTH {
            let exact = Rotor::new(&design, side).unwrap();
            let mut errors = Vec::new();
            // places stand in the middle of elements too: both of these have a station there
            for factor in [2, 6] {
                let mut fine = design.rotor(side).clone();
                fine.housing_axial_stiffness = None;
                for segment in &mut fine.segments {
                    segment.elements *= factor;
                }
                let error = [(exact.bending_x.frequency, [0, 5]), (exact.bending_z.frequency, [2, 3])]
                    .map(|(frequency, motions)| plane_frequency(&design, (side, &fine), motions) / frequency - 1.0);
                errors.push(error);
            }
            for [coarse, fine] in [[errors[0][0], errors[1][0]], [errors[0][1], errors[1][1]]] {
                // rounding of finite elements grows with the fourth power of their number
                prop_assert!(coarse > -1e-8 && fine > -3e-7, "{side:?} from above: {coarse:e} {fine:e}");
                // order 4, and 2 for the share of shear: down by 81 or by 9 once the elements are short enough
                prop_assert!(fine < 3e-7 + coarse / 7.0, "{side:?}: {coarse:e} {fine:e}");
            }
        }
    }

    /// Statics and transfer matrices are exact whatever the elements: finer ones change nothing.
    #[test]
    fn refinement_leaves_statics_and_effective_masses(design in designs()) {
        let mut fine = design.clone();
        for rotor in [&mut fine.pinion, &mut fine.gear] {
            for segment in &mut rotor.segments {
                segment.elements *= 2;
            }
        }
        let halves = |rotor: &RotorDesign| {
            let segments = rotor.segments.iter().flat_map(|segment| {
                let half = bevelscope::design::Segment { length: segment.length / 2.0, ..segment.clone() };
                [half.clone(), half]
            });
            RotorDesign { segments: segments.collect(), ..rotor.clone() }
        };
        let cut = Design { pinion: halves(&design.pinion), gear: halves(&design.gear), ..design.clone() };
        let (base, others) = (Rotors::new(&design).unwrap(), [Rotors::new(&fine).unwrap(), Rotors::new(&cut).unwrap()]);
        for (other, side) in others.iter().flat_map(|other| Side::BOTH.map(|side| (other, side))) {
            let (a, b) = (base.get(side), other.get(side));
            let (ka, kb) = (a.statics.shaft_bearing_stiffness, b.statics.shaft_bearing_stiffness);
            let size = ka.diagonal().map(f64::sqrt);
            for i in 0..6 {
                for j in 0..6 {
                    prop_assert!((ka[(i, j)] - kb[(i, j)]).abs() <= 1e-9 * size[i] * size[j], "K_ll ({i}, {j})");
                }
            }
            let totals = |r: &Rotor| [r.totals.mass, r.totals.polar_inertia, r.totals.diametral_inertia];
            for (a, b) in totals(a).into_iter().zip(totals(b)) {
                prop_assert!((a - b).abs() <= 1e-9 * a);
            }
            for (a, b) in [(a.bending_x, b.bending_x), (a.bending_z, b.bending_z)] {
                let figures = |b: &bevelscope::rotor::Bending| [b.frequency, b.mass, b.inertia];
                prop_assert_eq!((a.mass_fallback, a.inertia_fallback), (b.mass_fallback, b.inertia_fallback));
                for (a, b) in figures(&a).into_iter().zip(figures(&b)) {
                    prop_assert!((a - b).abs() <= 1e-9 * a, "{a} {b}");
                }
                prop_assert!((a.energy_residual - b.energy_residual).abs() <= 1e-9);
                // theory: the static shape has the least strain energy, so the residual has one sign
                prop_assert!(a.energy_residual >= -1e-9 && a.energy_residual <= 1.0 + 1e-9, "{}", a.energy_residual);
            }
        }
    }

    /// What the enhanced model promises: its two-coordinate model has the first bending frequency of the plane, and its shape.
    #[test]
    fn effective_masses_keep_the_first_bending_frequency(design in designs()) {
        for side in Side::BOTH {
            let rotor = Rotor::new(&design, side).unwrap();
            let k = rotor.statics.shaft_bearing_stiffness;
            for (bending, [w, s]) in [(rotor.bending_x, [0, 5]), (rotor.bending_z, [2, 3])] {
                if bending.mass_fallback || bending.inertia_fallback {
                    continue;
                }
                let lambda = (TAU * bending.frequency).powi(2);
                let (a, b) = (k[(w, w)] - lambda * bending.mass, k[(s, s)] - lambda * bending.inertia);
                let error = (a * b - k[(w, s)].powi(2)).abs() / (k[(w, w)] * k[(s, s)]);
                prop_assert!(error < 1e-9, "{side:?} {w}: {error:e}");
            }
        }
    }
}

/// First frequency (Hz) of the finite element model of one plane alone, on the in-plane blocks of its bearings.
fn plane_frequency(design: &Design, (side, rotor): (Side, &RotorDesign), motions: [usize; 2]) -> f64 {
    let stations = Stations::new(design, rotor).unwrap();
    let supports = Supports::new(rotor, &MeanStates::new(design, side, &stations, None).unwrap()).unwrap();
    let shaft = ShaftMatrices::new(rotor, &stations, &supports);
    let kept: Vec<usize> = (0..shaft.free.len()).filter(|&i| shaft.free[i] && motions.contains(&(i % 6))).collect();
    let pick = |a: &DMatrix<f64>| a.select_rows(&kept).select_columns(&kept);
    let (lambda, _) = dense::generalized(&pick(&shaft.stiffness), &pick(&shaft.mass), 1e5);
    lambda[0].max(0.0).sqrt() / TAU
}
