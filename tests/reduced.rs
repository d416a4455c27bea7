//! Reduced models (Craig and Bampton 1968) between the static and the finite element model.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod support;

use std::f64::consts::TAU;

use bevelscope::agreement::{difference_db, reduced_modes_for, sixth_octave_bands};
use bevelscope::design::{Design, Side, library, read};
use bevelscope::model::{CraigBampton, Model, ModelKind, Rotors, natural_modes};
use bevelscope::response::{Modes, Spectrum, direct_spectrum, frequency_lines};
use bevelscope::rotor::Motion;
use num_complex::Complex64;
use proptest::prelude::*;
use support::random::{config, designs};
use support::spectra::{error_of_peak, lines};

const ALL: ModelKind = ModelKind::Reduced(usize::MAX);

fn model(kind: ModelKind, design: &Design) -> Model {
    Model::new(kind, design, &Rotors::new(design).unwrap()).unwrap()
}

fn rms_db(a: &[Complex64], b: &[Complex64]) -> f64 {
    let difference = difference_db(a, b);
    (difference.iter().map(|d| d * d).sum::<f64>() / difference.len() as f64).sqrt()
}

proptest! {
    #![proptest_config(config(60))]

    #[test]
    fn all_modes_are_the_finite_element_model(design in designs()) {
        let lines = lines(&design, 40);
        let (fe, all) = (model(ModelKind::Fe, &design), model(ALL, &design));
        prop_assert_eq!(fe.coordinates(), all.coordinates());
        let (fe, all) = (Spectrum::new(&fe, &lines).unwrap(), Spectrum::new(&all, &lines).unwrap());
        let force = error_of_peak(&all.mesh_force, &fe.mesh_force);
        let error = error_of_peak(&all.transmission_error, &fe.transmission_error);
        prop_assert!(force < 1e-8 && error < 1e-8, "{force:e} {error:e}");
    }

    /// Rayleigh and Ritz: every further shape lowers natural frequencies, and none falls below that of the finite elements.
    #[test]
    fn natural_frequencies_fall_towards_the_finite_elements(design in designs()) {
        let fe = Modes::new(&model(ModelKind::Fe, &design), 14).unwrap().0;
        let mut above = [f64::INFINITY; 14];
        for kind in [0, 1, 2, 3, 5, 8, 13, usize::MAX].map(ModelKind::Reduced) {
            let modes = Modes::new(&model(kind, &design), 14).unwrap().0;
            for (i, mode) in modes.iter().enumerate() {
                // in lambda with a floor of (2 pi 300)^2, the unit in which eigenvalues are good to rounding
                let slack = |hz: f64| 1e-9 * (hz * hz + 9e4);
                let (found, lower) = (mode.frequency_hz.powi(2), fe[i].frequency_hz.powi(2));
                prop_assert!(found <= above[i] + slack(mode.frequency_hz), "{kind:?} mode {i} rises to {}", mode.frequency_hz);
                prop_assert!(found >= lower - slack(mode.frequency_hz), "{kind:?} mode {i}: {found} below {lower}");
                above[i] = found;
            }
        }
        for (i, mode) in fe.iter().enumerate() {
            prop_assert!((above[i].sqrt() - mode.frequency_hz).abs() < 1e-6 * (mode.frequency_hz + 10.0), "mode {i}");
        }
    }

    /// Guyan (1965): the stiffness is that of the lumped models, the mass what the static shapes carry.
    #[test]
    fn no_mode_is_the_static_model(design in designs()) {
        let rotors = Rotors::new(&design).unwrap();
        let reduced = Model::new(ModelKind::Reduced(0), &design, &rotors).unwrap();
        let enhanced = Model::new(ModelKind::Enhanced, &design, &rotors).unwrap();
        prop_assert_eq!(reduced.coordinates(), enhanced.coordinates());
        let drives = Side::BOTH.into_iter().filter(|side| design.rotor(*side).drive.is_some()).count();
        prop_assert_eq!(reduced.coordinates(), 12 + drives);
        for (side, (a, b)) in Side::BOTH.into_iter().zip(reduced.rotors().into_iter().zip(enhanced.rotors())) {
            prop_assert_eq!(&a.stiffness, &b.stiffness);
            let statics = &rotors.get(side).statics;
            for motion in [0, 1, 2, 3, 5] {
                let (found, wanted) = (a.mass[(motion, motion)], statics.static_mass[motion]);
                prop_assert!((found - wanted).abs() < 1e-9 * wanted, "{side:?} {motion}: {found} {wanted}");
            }
            // turning as one: all of the polar inertia
            let turned = a.rotation();
            let polar = rotors.get(side).totals.polar_inertia
                + design.rotor(side).drive.map_or(0.0, |drive| drive.inertia);
            prop_assert!((turned.dot(&(&a.mass * &turned)) - polar).abs() < 1e-9 * polar);
            // the basis carries the full stiffness to the reduced one
            let reduction = a.reduction.as_ref().unwrap();
            let carried = reduction.basis.tr_mul(&(&reduction.full.stiffness * &reduction.basis));
            // nothing resists turning where there is no drive: to rounding of what the shaft alone would resist
            let size = |i: usize| match a.stiffness[(i, i)] {
                0.0 if i == 4 && a.drive().is_none() => {
                    let turning = reduction.full.at_mesh(Motion::ThY).unwrap();
                    reduction.full.stiffness[(turning, turning)]
                }
                own => own,
            };
            for i in 0..a.coordinates.len() {
                for j in 0..a.coordinates.len() {
                    let size = (size(i) * size(j)).sqrt();
                    prop_assert!((carried[(i, j)] - a.stiffness[(i, j)]).abs() < 1e-7 * size, "{side:?} {i} {j}");
                }
            }
        }
    }

    /// What holds for the other models holds here: the shortcut is the direct solve, and the shares of every mode's energy are whole.
    #[test]
    fn shortcut_and_energy_shares(design in designs(), kept in 0_usize..12) {
        let model = model(ModelKind::Reduced(kept), &design);
        let lines = lines(&design, 8);
        let (fast, direct) = (Spectrum::new(&model, &lines).unwrap(), direct_spectrum(&model, &lines).unwrap());
        let force = error_of_peak(&fast.mesh_force, &direct.mesh_force);
        prop_assert!(force < 1e-8, "{force:e}");
        for mode in Modes::new(&model, usize::MAX).unwrap().0 {
            let total = [mode.pinion, mode.gear].map(|s| s.lateral + s.axial + s.tilt + s.torsion).iter().sum::<f64>();
            prop_assert!((total - 1.0).abs() < 1e-12);
        }
    }
}

/// Computed once with an independent dense implementation (500 lines from 10 to 4000 Hz). Its single mode is that of one plane, where
/// here a pair of equal frequency is mixed so that the mesh drives the first alone: 0.7555 there, 0.7556 here.
#[test]
fn further_modes_close_in_on_the_finite_elements() {
    let text = include_str!("fixtures/cases/overhung-elastic.toml");
    let mut design = read(text).design.unwrap();
    (design.analysis.frequency_max, design.analysis.frequency_lines) = (4000.0, 500);
    let lines = frequency_lines(&design.analysis);
    let spectrum = |kind| Spectrum::new(&model(kind, &design), &lines).unwrap().mesh_force;
    let fe = spectrum(ModelKind::Fe);
    for (kind, expected, digit) in [
        (ModelKind::Basic, 10.12, 0.005),
        (ModelKind::Enhanced, 3.72, 0.005),
        (ModelKind::Reduced(0), 3.53, 0.005),
        (ModelKind::Reduced(1), 0.7555, 0.0005),
        (ModelKind::Reduced(3), 0.632, 0.0005),
        (ModelKind::Reduced(6), 0.042, 0.0005),
        (ModelKind::Reduced(10), 0.029, 0.0005),
        (ALL, 0.0, 1e-6),
    ] {
        let found = rms_db(&spectrum(kind), &fe);
        println!("{kind:?} {found}");
        assert!((found - expected).abs() <= digit, "{kind:?}: {found} dB instead of {expected}");
    }
}

/// `reduced_modes_for` in its own words: the levels of all sixth-octave bands, for one K after the other.
#[test]
fn smallest_number_of_modes_within_a_tolerance() {
    let level =
        |force: &[Complex64]| 10.0 * (force.iter().map(Complex64::norm_sqr).sum::<f64>() / force.len() as f64).log10();
    for shipped in library::SHIPPED {
        let mut design = read(shipped.text).design.unwrap();
        for highest in [800.0, 2500.0, 5000.0] {
            design.analysis.frequency_max = highest;
            let lines = frequency_lines(&design.analysis);
            let spectrum = |kind| Spectrum::new(&model(kind, &design), &lines).unwrap().mesh_force;
            let fe = spectrum(ModelKind::Fe);
            let worst = |count: usize| {
                let force = spectrum(ModelKind::Reduced(count));
                let bands = sixth_octave_bands(&lines).into_iter();
                bands.map(|b| (level(&force[b.lines.clone()]) - level(&fe[b.lines])).abs()).fold(0.0, f64::max)
            };
            let rotors = Rotors::new(&design).unwrap();
            for tolerance in [0.01, 1.0, 20.0] {
                let found = reduced_modes_for(&design, &rotors, &lines, &fe, tolerance).unwrap();
                println!("{} up to {highest} Hz within {tolerance} dB: {found}", shipped.file_name);
                assert!(worst(found) <= tolerance, "{found}");
                assert!((0..found).all(|fewer| worst(fewer) > tolerance), "{found}");
            }
        }
    }
}

/// The full rotor is kept, so that what a reduced mode looks like is known; the lowest modes come first.
#[test]
fn fixed_interface_modes_hold_mesh_and_drive() {
    for shipped in library::SHIPPED {
        let design = read(shipped.text).design.unwrap();
        let rotors = Rotors::new(&design).unwrap();
        for side in Side::BOTH {
            let all = CraigBampton::new(&design, rotors.get(side), side).unwrap();
            let rotor = all.keep(usize::MAX);
            let reduction = rotor.reduction.as_ref().unwrap();
            let (full, basis) = (&reduction.full, &reduction.basis);
            let free = natural_modes(&full.stiffness, &full.mass, &full.rotation()).unwrap();
            let mut free: Vec<f64> = free.stiffness.iter().zip(&free.mass).map(|(k, m)| k / m).collect();
            free.sort_by(f64::total_cmp);
            let slowest = if shipped.file_name == "turbine-generator.toml" { 1.0 } else { 100.0 };
            let mut below = 0.0;
            let interface = 6 + usize::from(design.rotor(side).drive.is_some());
            for mode in interface..basis.ncols() {
                let held =
                    full.coordinates.iter().enumerate().filter(|(_, c)| rotor.coordinates[..interface].contains(c));
                assert!(held.clone().count() == interface && held.clone().all(|(i, _)| basis[(i, mode)] == 0.0));
                let lambda = rotor.stiffness[(mode, mode)] / rotor.mass[(mode, mode)];
                assert!(lambda.sqrt() / TAU > slowest && lambda >= below * (1.0 - 1e-9), "{mode}");
                below = lambda;
                // Rayleigh: what is held lies no lower than the free mode of the same number, and below that of as many more as are held
                let number = mode - interface;
                let slack = 1e-9 * lambda + 1.0;
                assert!(free[number] <= lambda + slack && lambda <= free[number + interface] + slack, "{mode}");
            }
        }
    }
}
