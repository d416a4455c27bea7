//! The shortcut against the direct solve, power, reciprocity, low frequencies.

use crate::models;
use crate::support::dense;
use crate::support::random::{config, designs};
use crate::support::spectra::{error_of_peak, lines};
use bevelscope::comparison::compare;
use bevelscope::model::Model;
use bevelscope::response::{Compliance, Spectrum, direct_spectrum};
use nalgebra::DVector;
use num_complex::Complex64;
use proptest::prelude::*;
use std::f64::consts::TAU;

proptest! {
    #![proptest_config(config(60))]

    /// The shortcut is exact (Sherman and Morrison 1950): only rounding may lie between the two.
    #[test]
    fn shortcut_is_the_direct_solve(design in designs()) {
        let lines = lines(&design, 12);
        for model in models(&design) {
            let (fast, direct) = (Spectrum::new(&model, &lines).unwrap(), direct_spectrum(&model, &lines).unwrap());
            let force = error_of_peak(&fast.mesh_force, &direct.mesh_force);
            let error = error_of_peak(&fast.transmission_error, &direct.transmission_error);
            prop_assert!(force < 1e-8 && error < 1e-8, "{:?}: {force:e} {error:e}", model.kind);
        }
    }

    /// Passive: the transmission error puts work in at every frequency, and all of it is lost in the structure and the mesh:
    /// -Im(F_m) e = s zeta_s x^H K x + s zeta_m k_m |delta - e|^2.
    #[test]
    fn power_is_lost_and_balances(design in designs()) {
        let lines = lines(&design, 6);
        for model in models(&design) {
            let spectrum = Spectrum::new(&model, &lines).unwrap();
            let (k, _, h) = dense::matrices(&model);
            let (k, h) = (k.map(Complex64::from), h.map(Complex64::from));
            for (i, &frequency) in lines.iter().enumerate() {
                let omega = TAU * frequency;
                let e = model.transmission_error;
                let put_in = -spectrum.mesh_force[i].im * e;
                prop_assert!(put_in >= 0.0, "{:?} at {frequency} Hz: {put_in:e}", model.kind);
                let mesh = model.complex_mesh_stiffness(omega);
                let x = dense::dynamic_stiffness(&model, omega).lu().solve(&(&h * (mesh * e))).unwrap();
                let strain = x.dotc(&(&k * &x)).re;
                let gap = (spectrum.transmission_error[i] - e).norm_sqr();
                let lost = model.structural_factor(omega).im * strain + mesh.im * gap;
                let scale = spectrum.mesh_force[i].norm() * e;
                prop_assert!((put_in - lost).abs() < 1e-7 * scale, "{:?} {frequency}: {put_in:e} {lost:e}", model.kind);
            }
        }
    }

    /// Response at i to a force at j equals the response at j to the same force at i.
    #[test]
    fn reciprocity(design in designs(), at in any::<[prop::sample::Index; 2]>(), frequency in 20.0..4000.0) {
        for model in models(&design) {
            let n = model.coordinates();
            let (i, j) = (at[0].index(n), at[1].index(n));
            let lu = dense::dynamic_stiffness(&model, TAU * frequency).lu();
            let unit = |i: usize| DVector::from_fn(n, |row, _| Complex64::from(f64::from(u8::from(row == i))));
            let (to_j, to_i) = (lu.solve(&unit(j)).unwrap(), lu.solve(&unit(i)).unwrap());
            let size = (to_j[j].norm() * to_i[i].norm()).sqrt();
            prop_assert!((to_j[i] - to_i[j]).norm() < 1e-7 * size.max(to_j[i].norm()), "{:?} {i} {j}", model.kind);
        }
    }

    /// alpha is a property of the two rotors, whichever is called the pinion.
    #[test]
    fn compliance_does_not_depend_on_the_order(design in designs(), frequency in 20.0..4000.0) {
        for model in models(&design) {
            let omega = TAU * frequency;
            let factor = model.structural_factor(omega);
            let alpha = Compliance::new(&model).unwrap().at(omega, factor);
            let swapped = Model { pinion: model.gear.clone(), gear: model.pinion.clone(), ..model.clone() };
            let other = Compliance::new(&swapped).unwrap().at(omega, factor);
            prop_assert!((alpha - other).norm() < 1e-12 * alpha.norm());
        }
    }

    #[test]
    fn force_is_proportional_to_the_transmission_error(design in designs()) {
        let lines = lines(&design, 12);
        for model in models(&design) {
            let twice = Model { transmission_error: 2.0 * model.transmission_error, ..model.clone() };
            let (one, two) = (Spectrum::new(&model, &lines).unwrap(), Spectrum::new(&twice, &lines).unwrap());
            for (one, two) in one.mesh_force.iter().zip(&two.mesh_force) {
                prop_assert!((one * 2.0 - two).norm() <= 1e-15 * two.norm());
            }
        }
    }

    /// Both lumped models are statically right.
    #[test]
    fn lumped_models_tend_to_the_finite_elements_at_low_frequency(design in designs()) {
        let [fe, enhanced, basic] = models(&design).map(|model| Compliance::new(&model).unwrap());
        let model = &models(&design)[0];
        let at = |compliance: &Compliance, f: f64| compliance.at(TAU * f, model.structural_factor(TAU * f));
        for (name, lumped) in [("enhanced", &enhanced), ("basic", &basic)] {
            let error = |f: f64| (at(lumped, f) - at(&fe, f)).norm() / at(&fe, f).norm();
            // the inertia forces, which the models share out differently, fall with f^2
            let (tenth, hundredth) = (error(0.1), error(0.01));
            let falls = hundredth < tenth / 90.0 + 1e-10;
            prop_assert!(tenth < 1e-6 && falls, "{name}: {tenth:e} at 0.1 Hz, {hundredth:e} at 0.01 Hz");
        }
    }

    /// Nothing in a comparison of a valid design is NaN or infinite.
    #[test]
    fn comparisons_are_finite(design in designs()) {
        let comparison = compare(&design).unwrap();
        prop_assert_eq!(comparison.fe.mesh_force.len(), design.analysis.frequency_lines);
        for spectrum in [&comparison.fe, &comparison.enhanced, &comparison.basic] {
            prop_assert!(spectrum.mesh_force.iter().chain(&spectrum.transmission_error).all(|v| v.is_finite()));
        }
        for agreement in [&comparison.enhanced_agreement, &comparison.basic_agreement] {
            prop_assert!(agreement.rms_db.is_finite() && agreement.max_db >= agreement.rms_db);
            prop_assert!((0.0..=1.0 + 1e-12).contains(&agreement.frac));
            prop_assert!((0.0..=design.analysis.frequency_max).contains(&agreement.agreement_limit_hz));
        }
    }
}
