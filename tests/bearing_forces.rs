//! Forces of the bearings on their shafts, and displacements of the whole shaft, held against Newton's second law.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod support;

use std::f64::consts::TAU;

use bevelscope::design::{BearingModel, Design, Side, library, read};
use bevelscope::model::{Model, ModelKind, Rotors, mesh_vector};
use bevelscope::response::{
    BearingForces, BearingSpectrum, Spectrum, StationShape, both_rotor_modes, frequency_lines, operating_deflection,
};
use bevelscope::rotor::ShaftMatrices;
use nalgebra::{DVector, Vector6};
use num_complex::Complex64;
use proptest::prelude::*;
use support::dense;
use support::random::{Mounting, config, designs, designs_on};

struct Solved {
    model: Model,
    lines: Vec<f64>,
    mesh_force: Vec<Complex64>,
    forces: Vec<BearingSpectrum>,
    /// A line each
    shapes: Vec<[StationShape<Complex64>; 2]>,
}

fn solve(kind: ModelKind, design: &Design, rotors: &Rotors, count: usize) -> Solved {
    let mut analysis = design.analysis.clone();
    analysis.frequency_lines = count;
    let lines = frequency_lines(&analysis);
    let model = Model::new(kind, design, rotors).unwrap();
    let (modes, recovery) = (both_rotor_modes(&model).unwrap(), model.recovery(design, rotors).unwrap());
    let mesh_force = Spectrum::new(&model, &lines).unwrap().mesh_force;
    let forces = BearingForces::new(&model, &modes, &recovery).spectra(&model, &lines, &mesh_force);
    let shape = |(f, force): (&f64, &Complex64)| operating_deflection(&model, &modes, &recovery, TAU * f, *force);
    let shapes = lines.iter().zip(&mesh_force).map(shape).collect();
    Solved { model, lines, mesh_force, forces, shapes }
}

/// Force and moment about the shaft's start of a force at `position` along the shaft.
fn about_start(position: f64, f: &[Complex64; 6]) -> [Complex64; 6] {
    // arm (0, y, 0) x (fx, fy, fz) = (y fz, 0, -y fx)
    [f[0], f[1], f[2], f[3] + position * f[2], f[4], f[5] - position * f[0]]
}

/// Displacements of every station for a rigid motion of the shaft about its start: the same arms.
fn rigid(positions: &[f64], motion: usize) -> DVector<f64> {
    let mut out = DVector::zeros(6 * positions.len());
    for (i, y) in positions.iter().enumerate() {
        out[6 * i + motion] = 1.0;
        match motion {
            3 => out[6 * i + 2] = *y,
            5 => out[6 * i] = -y,
            _ => {}
        }
    }
    out
}

/// The worst of |forces - inertia| over the largest force, of all six motions (moments about the shaft's start, over its length).
fn imbalance(design: &Design, rotors: &Rotors, solved: &Solved, line: usize) -> f64 {
    let mut worst: f64 = 0.0;
    for (i, side) in Side::BOTH.into_iter().enumerate() {
        let (rotor, input, shape) = (rotors.get(side), design.rotor(side), &solved.shapes[line][i]);
        let stations = &rotor.stations;
        let length = input.length();
        let omega = TAU * solved.lines[line];
        let mut forces: Vec<[Complex64; 6]> = Vec::new();
        for (bearing, &station) in solved.forces.iter().filter(|b| b.side == side).zip(&stations.bearings) {
            forces.push(about_start(stations.positions[station], &bearing.force[line]));
        }
        let sign = if side == Side::Pinion { -1.0 } else { 1.0 };
        let h: Vector6<f64> = mesh_vector(design.mesh.vectors(side));
        let at_mesh = std::array::from_fn(|i| sign * h[i] * solved.mesh_force[line]);
        forces.push(about_start(stations.positions[stations.mesh], &at_mesh));
        assert_eq!(shape.drive.is_some(), input.drive.is_some());
        if let (Some(drive), Some(turned), Some(station)) = (input.drive, shape.drive, stations.drive) {
            let twist = turned - shape.displacements[station][4];
            let spring = solved.model.structural_factor(omega) * drive.torsional_stiffness;
            let mut on_shaft = [Complex64::ZERO; 6];
            on_shaft[4] = spring * twist;
            forces.push(on_shaft);
        }
        let shaft = ShaftMatrices::new(input, stations, &rotor.supports);
        let x = |part: fn(&Complex64) -> f64| {
            DVector::from_iterator(6 * stations.count(), shape.displacements.iter().flatten().map(part))
        };
        let (re, im) = (&shaft.mass * x(|c| c.re), &shaft.mass * x(|c| c.im));
        for motion in 0..6 {
            let unit = rigid(&stations.positions, motion);
            let inertia = -omega * omega * Complex64::new(unit.dot(&re), unit.dot(&im));
            let sum: Complex64 = forces.iter().map(|f| f[motion]).sum();
            let arm = if motion < 3 { 1.0 } else { length };
            let force = |f: &[Complex64; 6]| f[..3].iter().map(|c| c.norm()).fold(f[motion].norm() / arm, f64::max);
            let largest = forces.iter().map(force).fold(0.0, f64::max);
            worst = worst.max((sum - inertia).norm() / arm / largest);
        }
    }
    worst
}

/// Designs on given stiffnesses, and on ball and roller bearings.
fn mounted() -> impl Strategy<Value = Design> {
    prop_oneof![3 => designs(), 1 => designs_on(Mounting::Rolling)]
}

proptest! {
    #![proptest_config(config(80))]

    /// Newton: on each rotor the forces of bearings, mesh and drive are what accelerates its mass; Kc, Khb, rigid, ball and roller bearings included.
    #[test]
    fn forces_of_finite_elements_are_the_inertia_forces(design in mounted()) {
        let rotors = Rotors::new(&design).unwrap();
        let solved = solve(ModelKind::Fe, &design, &rotors, 20);
        for line in 0..20 {
            let error = imbalance(&design, &rotors, &solved, line);
            prop_assert!(error < 1e-9, "{} Hz: {error:e}", solved.lines[line]);
        }
    }

    /// The displacements are those of the direct complex solve of the whole system.
    #[test]
    fn operating_deflection_is_the_direct_solve(design in designs()) {
        let rotors = Rotors::new(&design).unwrap();
        let solved = solve(ModelKind::Fe, &design, &rotors, 4);
        let (_, _, h) = dense::matrices(&solved.model);
        for (line, frequency) in solved.lines.iter().enumerate() {
            let omega = TAU * frequency;
            let push = solved.model.complex_mesh_stiffness(omega) * solved.model.transmission_error;
            let x = dense::dynamic_stiffness(&solved.model, omega).lu().solve(&h.map(|h| h * push)).unwrap();
            let mut at = 0;
            for (rotor, shape) in solved.model.rotors().into_iter().zip(&solved.shapes[line]) {
                for (motions, size) in [(0..3, 1.0), (3..6, 0.1)] {
                    let largest = x.iter().map(|x| x.norm()).fold(0.0, f64::max);
                    for (i, coordinate) in rotor.coordinates.iter().enumerate() {
                        if let bevelscope::model::Coordinate::Station(station, motion) = coordinate {
                            let motion = *motion as usize;
                            if motions.contains(&motion) {
                                let error = (shape.displacements[*station][motion] - x[at + i]).norm();
                                prop_assert!(error < 1e-7 * largest / size, "{frequency} Hz {station} {motion}");
                            }
                        }
                    }
                }
                at += rotor.coordinates.len();
            }
        }
    }

    /// With all fixed-interface modes the reduced model's own shapes give the forces of finite elements.
    #[test]
    fn reduced_with_all_modes_has_the_forces_of_finite_elements(design in mounted()) {
        let rotors = Rotors::new(&design).unwrap();
        let [fe, all] = [ModelKind::Fe, ModelKind::Reduced(usize::MAX)].map(|kind| solve(kind, &design, &rotors, 10));
        for (a, b) in fe.forces.iter().zip(&all.forces) {
            let largest = |f: &BearingSpectrum| f.total().fold(f.force.iter().map(|f| f[3].norm()).fold(0.0, f64::max), f64::max);
            let scale = fe.forces.iter().map(largest).fold(0.0, f64::max);
            for (a, b) in a.force.iter().flatten().zip(b.force.iter().flatten()) {
                prop_assert!((a - b).norm() < 1e-7 * scale, "{a} {b}");
            }
        }
    }

    /// Static shapes carry the whole load: the bearings' forces of a lumped model sum up to -K_ll q, and at low frequency they are those of
    /// finite elements.
    #[test]
    fn static_shapes_carry_the_load_of_lumped_models(design in mounted()) {
        let rotors = Rotors::new(&design).unwrap();
        let [fe, enhanced, basic] = ModelKind::ALL.map(|kind| solve(kind, &design, &rotors, 6));
        for lumped in [&enhanced, &basic] {
            for (line, frequency) in lumped.lines.iter().enumerate() {
                let factor = lumped.model.structural_factor(TAU * frequency);
                for (i, side) in Side::BOTH.into_iter().enumerate() {
                    let rotor = rotors.get(side);
                    let q = &lumped.shapes[line][i].displacements[rotor.stations.mesh];
                    let k = rotor.statics.shaft_bearing_stiffness;
                    for motion in 0..3 {
                        let wanted: Complex64 = (0..6).map(|j| -factor * k[(motion, j)] * q[j]).sum();
                        let own = lumped.forces.iter().filter(|b| b.side == side);
                        let found: Complex64 = own.clone().map(|b| b.force[line][motion]).sum();
                        let size = own.flat_map(|b| b.force[line]).map(Complex64::norm).fold(wanted.norm(), f64::max);
                        prop_assert!((found - wanted).norm() < 1e-7 * size, "{side:?} {motion}: {found} {wanted}");
                    }
                }
            }
        }
        let mut slow = design.clone();
        (slow.analysis.frequency_min, slow.analysis.frequency_max) = (0.01, 0.02);
        let [fe_slow, enhanced_slow] = [ModelKind::Fe, ModelKind::Enhanced].map(|kind| solve(kind, &slow, &rotors, 2));
        let scale = fe_slow.forces.iter().flat_map(|b| b.force[0]).map(Complex64::norm).fold(0.0, f64::max);
        for (a, b) in fe_slow.forces.iter().zip(&enhanced_slow.forces) {
            for (a, b) in a.force[0].iter().zip(&b.force[0]) {
                prop_assert!((a - b).norm() < 1e-5 * scale, "{a} {b}");
            }
        }
        prop_assert_eq!(fe.forces.len(), enhanced.forces.len());
    }
}

/// The balance above looks at every kind of support.
#[test]
fn shipped_designs_balance_and_name_their_bearings() {
    for shipped in library::SHIPPED {
        let design = read(shipped.text).design.unwrap();
        let rotors = Rotors::new(&design).unwrap();
        let solved = solve(ModelKind::Fe, &design, &rotors, 200);
        let worst = (0..200).map(|line| imbalance(&design, &rotors, &solved, line)).fold(0.0, f64::max);
        println!("{}: {worst:e}", shipped.file_name);
        assert!(worst < 1e-9);
        let names = |side: Side| design.rotor(side).bearings.iter().map(move |b| (side, b.name.clone()));
        let names: Vec<_> = names(Side::Pinion).chain(names(Side::Gear)).collect();
        assert_eq!(solved.forces.iter().map(|b| (b.side, b.name.clone())).collect::<Vec<_>>(), names);
        for (bearing, force) in design.pinion.bearings.iter().zip(&solved.forces) {
            if matches!(bearing.model, BearingModel::Rigid(_)) {
                // a support that only holds translations takes no moment
                assert!(force.force.iter().all(|f| f[3..].iter().all(|m| m.norm() == 0.0)));
            }
            let f = force.force[7];
            let radial = (f[0].norm_sqr() + f[2].norm_sqr()).sqrt();
            assert!((force.radial().nth(7).unwrap() - radial).abs() < 1e-12 * radial);
            let total = (f[1].norm_sqr() + radial * radial).sqrt();
            assert!((force.total().nth(7).unwrap() - total).abs() < 1e-12 * total);
        }
    }
}
