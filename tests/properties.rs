//! Properties that hold for every valid design, on random ones.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod support;

use std::f64::consts::TAU;

use bevelscope::comparison::compare;
use bevelscope::design::{BeamTheory, BearingModel, Design, RotorDesign, Side};
use bevelscope::model::{Model, ModelKind, RotorModel, Rotors};
use bevelscope::response::{Compliance, EnergyShare, Modes, Spectrum, direct_spectrum};
use bevelscope::rotor::{MeanStates, Motion, Rotor, ShaftMatrices, Stations, Supports};
use nalgebra::{Cholesky, DMatrix, DVector, Matrix6};
use num_complex::Complex64;
use proptest::prelude::*;
use support::dense;
use support::random::{Mounting, config, designs, designs_on};
use support::spectra::{error_of_peak, lines};

fn models(design: &Design) -> [Model; 3] {
    let rotors = Rotors::new(design).unwrap();
    ModelKind::ALL.map(|kind| Model::new(kind, design, &rotors).unwrap())
}

fn scaled(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let size = matrix.diagonal().map(|d| 1.0 / d.sqrt());
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| size[i] * matrix[(i, j)] * size[j])
}

proptest! {
    #![proptest_config(config(60))]

    #[test]
    fn stiffness_and_mass_are_symmetric_and_mass_is_positive(design in designs()) {
        for model in models(&design) {
            for rotor in model.rotors() {
                let (k, m) = (&rotor.stiffness, &rotor.mass);
                for matrix in [k, m] {
                    let size = matrix.diagonal().map(f64::sqrt);
                    for i in 0..matrix.nrows() {
                        for j in 0..i {
                            let error = (matrix[(i, j)] - matrix[(j, i)]).abs();
                            prop_assert!(error <= 1e-12 * size[i] * size[j], "{:?} ({i}, {j}) {error:e}", model.kind);
                        }
                    }
                }
                prop_assert!(Cholesky::new(scaled(m)).is_some(), "{:?} mass", model.kind);
                // K is positive semidefinite: its one zero is the rotation
                let turned = k * rotor.rotation();
                prop_assert!(turned.amax() <= 1e-9 * rotor.rotation().component_mul(&k.diagonal()).amax());
                let lowest = scaled(&(k + m * 1e-6)).symmetric_eigenvalues().min();
                prop_assert!(lowest > -1e-12, "{:?} {lowest:e}", model.kind);
            }
        }
    }

    #[test]
    fn one_free_rotation_with_the_mesh_and_two_without(design in designs()) {
        for model in models(&design) {
            let with = Modes::new(&model, 2).unwrap().0;
            // the line of action may pass the axes so closely that the mesh hardly holds the two rotations together
            let arm = |rotor: &RotorModel| rotor.mesh_vector[rotor.at_mesh(Motion::ThY).unwrap()].abs();
            if arm(&model.pinion).max(arm(&model.gear)) > 1e-3 {
                prop_assert!(with[1].frequency_hz > 0.5, "{:?} {}", model.kind, with[1].frequency_hz);
            }
            prop_assert!(with[0].frequency_hz < 0.01, "{:?} {}", model.kind, with[0].frequency_hz);
            let free = Model { mesh_stiffness: 1e-30, ..model };
            let without = Modes::new(&free, 3).unwrap().0;
            prop_assert!(without[1].frequency_hz < 0.01, "{:?} {}", free.kind, without[1].frequency_hz);
            prop_assert!(without[2].frequency_hz > 1.0, "{:?} {}", free.kind, without[2].frequency_hz);
        }
    }

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

    #[test]
    fn modes_are_those_of_the_whole_matrix(design in designs()) {
        const SHIFT: f64 = 1e7;
        for model in models(&design) {
            let (k, m, h) = dense::matrices(&model);
            let k = k + model.mesh_stiffness * &h * h.transpose();
            let (lambda, shapes) = dense::generalized(&k, &m, SHIFT);
            let found = Modes::new(&model, 24).unwrap().0;
            let count = found.len().min(lambda.len());
            let expected = |i: usize| lambda[i].max(0.0).sqrt() / TAU;
            let highest = expected(count - 1);
            for (i, mode) in found.iter().enumerate() {
                // in the unit of the reference, 1/(lambda + shift): rounding of K times its condition
                let squared = (TAU * mode.frequency_hz).powi(2);
                let error = (squared - lambda[i]).abs() * SHIFT / (lambda[i] + SHIFT).powi(2);
                prop_assert!(error < 1e-10, "{:?} mode {i}: {} {}", model.kind, mode.frequency_hz, expected(i));
                let total = sum(&mode.pinion) + sum(&mode.gear);
                prop_assert!((total - 1.0).abs() < 1e-12, "shares {total}");
                let lambda = (TAU * mode.frequency_hz).powi(2);
                let residual = (&k * &mode.shape - &m * &mode.shape * lambda).component_div(&k.diagonal().map(f64::sqrt));
                let size = (k.diagonal().component_mul(&mode.shape.component_mul(&mode.shape))).sum().sqrt();
                prop_assert!(residual.norm() < 1e-10 * size, "{:?} mode {i}: {:e}", model.kind, residual.norm() / size);
                let mass = mode.shape.dot(&(&m * &mode.shape));
                prop_assert!((mass - 1.0).abs() < 1e-12, "{mass}");
            }
            // of modes that share a frequency any mixture is legal: sum their shares
            let mut start = 0;
            while start < count {
                let end = (start + 1..count).find(|&i| expected(i) - expected(i - 1) > 1e-5 * highest).unwrap_or(count);
                if end == count && lambda.len() > count {
                    break;
                }
                let mut want = [0.0; 8];
                let mut have = [0.0; 8];
                for (mode, shape) in found[start..end].iter().zip(shapes.columns(start, end - start).column_iter()) {
                    for (want, share) in want.iter_mut().zip(shares_of(&model, &m, &shape.into_owned())) {
                        *want += share;
                    }
                    let (p, g) = (&mode.pinion, &mode.gear);
                    let own = [p.lateral, p.axial, p.tilt, p.torsion, g.lateral, g.axial, g.tilt, g.torsion];
                    for (have, share) in have.iter_mut().zip(own) {
                        *have += share;
                    }
                }
                for (have, want) in have.iter().zip(want) {
                    prop_assert!((have - want).abs() < 1e-6, "{:?} modes {start}..{end}: {have} {want}", model.kind);
                }
                start = end;
            }
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

    /// Both rotors in a frame turned about their axes: the same machine.
    #[test]
    fn turning_a_rotor_about_its_axis_changes_nothing(design in designs(), angles in [0.0..TAU, 0.0..TAU]) {
        let turned = turned(&design, angles);
        let lines = lines(&design, 12);
        for (kind, (a, b)) in ModelKind::ALL.into_iter().zip(models(&design).iter().zip(&models(&turned))) {
            if kind != ModelKind::Enhanced {
                let (a, b) = (Spectrum::new(a, &lines).unwrap(), Spectrum::new(b, &lines).unwrap());
                let error = error_of_peak(&b.mesh_force, &a.mesh_force);
                prop_assert!(error < 1e-8, "{kind:?} {error:e}");
            }
        }
    }

    /// The enhanced model has a first bending mode in each of two planes: it is the same machine from all sides only where the
    /// bearings are.
    #[test]
    fn turning_an_isotropic_rotor_changes_no_model(design in designs_on(Mounting::Isotropic), angles in [0.0..TAU, 0.0..TAU]) {
        let mut turned = turned(&design, angles);
        // their matrices are what they were: say it without rounding
        turned.pinion.bearings.clone_from(&design.pinion.bearings);
        turned.gear.bearings.clone_from(&design.gear.bearings);
        let lines = lines(&design, 12);
        for (a, b) in models(&design).iter().zip(&models(&turned)) {
            let kind = a.kind;
            let (a, b) = (Spectrum::new(a, &lines).unwrap(), Spectrum::new(b, &lines).unwrap());
            let error = error_of_peak(&b.mesh_force, &a.mesh_force);
            prop_assert!(error < 1e-8, "{kind:?} {error:e}");
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

proptest! {
    #![proptest_config(config(150))]

    /// Several numbers at once anywhere in the range of a double.
    #[test]
    fn extreme_numbers_give_figures_or_errors(
        design in designs(),
        changes in proptest::collection::vec((any::<prop::sample::Index>(), -308_i32..308), 1..4),
    ) {
        let mut design = design;
        design.analysis.frequency_lines = 3;
        for (which, exponent) in changes {
            let mut numbers = numbers(&mut design);
            let which = which.index(numbers.len());
            *numbers[which] = 10_f64.powi(exponent);
        }
        // an error with a name is as good
        let _ = support::nonsense::assert_no_nonsense("extreme", &design);
    }
}

/// Every number of a design that may be any positive value.
fn numbers(design: &mut Design) -> Vec<&mut f64> {
    let Design { analysis, materials, mesh, pinion, gear, .. } = design;
    let mut out = vec![
        &mut analysis.structural_damping,
        &mut mesh.stiffness,
        &mut mesh.damping,
        &mut mesh.transmission_error,
        &mut mesh.pinion.point[0],
        &mut mesh.gear.point[2],
    ];
    for material in materials.values_mut() {
        out.extend([&mut material.youngs_modulus, &mut material.density]);
    }
    for rotor in [pinion, gear] {
        out.extend(
            rotor.drive.as_mut().into_iter().flat_map(|drive| [&mut drive.torsional_stiffness, &mut drive.inertia]),
        );
        out.extend(&mut rotor.housing_axial_stiffness);
        for body in &mut rotor.bodies {
            out.extend([&mut body.mass, &mut body.diametral_inertia, &mut body.polar_inertia]);
        }
        for segment in &mut rotor.segments {
            // a scale of the section: the bore stays inside
            if segment.inner_diameter == 0.0 {
                out.push(&mut segment.outer_diameter);
            }
        }
        for bearing in &mut rotor.bearings {
            out.extend(&mut bearing.axial_series_stiffness);
            match &mut bearing.model {
                BearingModel::Diagonal(k) => out.extend([&mut k.kx, &mut k.ky, &mut k.kz, &mut k.krx, &mut k.krz]),
                // one entry alone would not leave a matrix positive definite
                BearingModel::Matrix(_) | BearingModel::Rigid(_) | BearingModel::Ball(_) | BearingModel::Roller(_) => {}
            }
        }
    }
    out
}

fn sum(share: &EnergyShare) -> f64 {
    share.lateral + share.axial + share.tilt + share.torsion
}

/// Kinetic energy of a mass-normalised shape: lateral, axial, tilt, torsion of the pinion, then of the gear.
fn shares_of(model: &Model, m: &DMatrix<f64>, shape: &DVector<f64>) -> [f64; 8] {
    let energy = shape.component_mul(&(m * shape));
    let mut out = [0.0; 8];
    let coordinates = model.rotors().into_iter().enumerate();
    let coordinates =
        coordinates.flat_map(|(r, rotor)| rotor.coordinates.iter().map(move |c| (r, c.motion().unwrap())));
    for ((rotor, motion), energy) in coordinates.zip(energy.iter()) {
        let group = match motion {
            Motion::X | Motion::Z => 0,
            Motion::Y => 1,
            Motion::ThX | Motion::ThZ => 2,
            Motion::ThY => 3,
        };
        out[4 * rotor + group] += energy;
    }
    out
}

/// Everything that has a direction turned about the y axis, by one angle a rotor. Rigid bearings hold the same in all directions here only
/// where they hold x and z, which random ones do.
fn turned(design: &Design, angles: [f64; 2]) -> Design {
    let mut out = design.clone();
    let turn = |angle: f64, [x, y, z]: [f64; 3]| {
        let (sin, cos) = angle.sin_cos();
        [x * cos + z * sin, y, z * cos - x * sin]
    };
    for (side, angle) in Side::BOTH.into_iter().zip(angles) {
        let (rotor, vectors) = match side {
            Side::Pinion => (&mut out.pinion, &mut out.mesh.pinion),
            Side::Gear => (&mut out.gear, &mut out.mesh.gear),
        };
        vectors.point = turn(angle, vectors.point);
        vectors.line_of_action = turn(angle, vectors.line_of_action);
        let (sin, cos) = angle.sin_cos();
        let mut rotation = Matrix6::zeros();
        for block in [0, 3] {
            for (i, j, value) in [(0, 0, cos), (0, 2, sin), (1, 1, 1.0), (2, 0, -sin), (2, 2, cos)] {
                rotation[(block + i, block + j)] = value;
            }
        }
        for bearing in &mut rotor.bearings {
            let k = match &bearing.model {
                BearingModel::Diagonal(k) => Matrix6::from_diagonal(&[k.kx, k.ky, k.kz, k.krx, 0.0, k.krz].into()),
                BearingModel::Matrix(k) => Matrix6::from_fn(|i, j| k[i][j]),
                BearingModel::Rigid(_) | BearingModel::Ball(_) | BearingModel::Roller(_) => continue,
            };
            let k = rotation * k * rotation.transpose();
            let k = (k + k.transpose()) * 0.5;
            bearing.model = BearingModel::Matrix(std::array::from_fn(|i| std::array::from_fn(|j| k[(i, j)])));
        }
    }
    out
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

#[test]
fn random_designs_hold_what_the_generator_promises() {
    use proptest::strategy::ValueTree;
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
