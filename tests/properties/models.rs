//! Matrices, modes, and what turning or refining a rotor changes.

use crate::models;
use crate::support::dense;
use crate::support::random::{Mounting, config, designs, designs_on};
use crate::support::spectra::{error_of_peak, lines};
use bevelscope::design::{BearingModel, Design, Side};
use bevelscope::model::{Model, ModelKind, RotorModel};
use bevelscope::response::{EnergyShare, Modes, Spectrum};
use bevelscope::rotor::Motion;
use nalgebra::{Cholesky, DMatrix, DVector, Matrix6};
use proptest::prelude::*;
use std::f64::consts::TAU;

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
}

fn scaled(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let size = matrix.diagonal().map(|d| 1.0 / d.sqrt());
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| size[i] * matrix[(i, j)] * size[j])
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
