//! Torsional train with a branch: Friswell, Penny, Garvey and Lees, *Dynamics of Rotating Machinery* (2010), the geared torsional system.
//!
//! 400e-6 kg m^2 on 1e4 N m/rad to gear A; 700e-6 kg m^2 on 5e3 N m/rad to each of the gears; gears A and B of 25e-6 kg m^2 mesh 1:1.
//! Printed with a rigid mesh: 425.4, 634.1, 3247.2 Hz. A mesh spring that grows stiff must tend to that, from below, with the inverse of
//! its stiffness.

use bevelscope::design::DampingModel;
use bevelscope::model::{Coordinate, Model, ModelKind, RotorModel};
use bevelscope::response::Modes;
use bevelscope::rotor::Motion;
use nalgebra::{DMatrix, DVector};

use crate::support::assert_close;

/// Gear first, then each (inertia, spring to the gear); the last is the drive.
fn star(branches: &[(f64, f64)], radius: f64) -> RotorModel {
    let n = branches.len() + 1;
    let (mut k, mut m) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
    m[(0, 0)] = 25e-6;
    for (i, &(inertia, spring)) in branches.iter().enumerate() {
        m[(i + 1, i + 1)] = inertia;
        k[(0, 0)] += spring;
        k[(i + 1, i + 1)] = spring;
        k[(0, i + 1)] = -spring;
        k[(i + 1, 0)] = -spring;
    }
    let mut mesh_vector = DVector::zeros(n);
    mesh_vector[0] = radius;
    let coordinates =
        (0..n).map(|i| if i == n - 1 { Coordinate::Drive } else { Coordinate::Station(i, Motion::ThY) }).collect();
    RotorModel { stiffness: k, mass: m, mesh_vector, coordinates, mesh_station: 0, reduction: None }
}

fn frequencies(mesh_stiffness: f64) -> Vec<f64> {
    let model = Model {
        kind: ModelKind::Fe,
        pinion: star(&[(700e-6, 5e3), (400e-6, 1e4)], 0.05),
        gear: star(&[(700e-6, 5e3)], -0.05),
        mesh_stiffness,
        mesh_damping: 0.0,
        structural_damping: 0.0,
        damping_model: DampingModel::Hysteretic,
        transmission_error: 1e-6,
    };
    Modes::new(&model, 10).unwrap().0.iter().map(|mode| mode.frequency_hz).collect()
}

/// Both gears as one: the rigid mesh, to more digits than are printed.
fn rigid_mesh() -> Vec<f64> {
    let model = star(&[(700e-6, 5e3), (400e-6, 1e4), (700e-6, 5e3)], 0.05);
    let mut mass = model.mass;
    mass[(0, 0)] = 50e-6;
    let (lambda, _) = crate::support::dense::generalized(&model.stiffness, &mass, 1e6);
    lambda.iter().map(|l| l.max(0.0).sqrt() / std::f64::consts::TAU).collect()
}

#[test]
fn stiff_mesh_tends_to_the_rigid_one() {
    let limit = rigid_mesh();
    for (found, printed) in limit[1..].iter().zip([425.4, 634.1, 3247.2]) {
        assert!((found - printed).abs() <= 0.05, "{found} is printed as {printed}");
    }
    let errors = |stiffness: f64| {
        let found = frequencies(stiffness);
        assert!(found[0] == 0.0, "one free rotation: {}", found[0]);
        [1, 2, 3].map(|i| 1.0 - found[i] / limit[i])
    };
    let (soft, stiff, stiffest) = (errors(1e10), errors(1e12), errors(1e15));
    for i in 0..3 {
        assert!(soft[i] > -1e-12 && stiff[i] > -1e-12, "from below: {soft:?} {stiff:?}");
        assert!(stiffest[i].abs() < 1e-8, "{stiffest:?}");
    }
    // in the highest mode the mesh carries most of the load
    assert!((soft[2] / stiff[2] / 100.0 - 1.0).abs() < 0.05, "{soft:?} {stiff:?}");
    assert_close("printed", frequencies(1e15)[3], 3247.2, 2e-5);
}
