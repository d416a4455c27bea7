//! Gear pair with torsion alone, two inertias on one mesh spring: closed form.
//!
//! With the equivalent mass m = 1/(rp^2/Jp + rg^2/Jg) and s = km (1 + j zeta) the dynamic mesh force is |s e m w^2/(s - m w^2)|
//! (Ozguven and Houser 1988, the torsional model of section 2.1). rp = 0.03 m, Jp = 1.8e-3 kg m^2, rg = 0.0965 m, Jg = 4.5e-2 kg m^2,
//! km = 2e8 N/m, zeta = 0.06, e = 1 um.

use std::f64::consts::TAU;

use bevelscope::design::DampingModel;
use bevelscope::model::{Coordinate, Model, ModelKind, RotorModel};
use bevelscope::response::{Modes, Spectrum, direct_spectrum};
use bevelscope::rotor::Motion;
use nalgebra::{DMatrix, DVector};

use crate::support::assert_close;

const M: f64 = 1.414_549_4;

/// A shaft that only turns, with a drive of next to no inertia on a spring of next to no stiffness: its share is 1e-12.
fn turning(inertia: f64, radius: f64) -> RotorModel {
    let k = 1e-6;
    RotorModel {
        stiffness: DMatrix::from_row_slice(2, 2, &[k, -k, -k, k]),
        mass: DMatrix::from_diagonal(&DVector::from_row_slice(&[inertia, 1e-12 * inertia])),
        mesh_vector: DVector::from_row_slice(&[radius, 0.0]),
        coordinates: vec![Coordinate::Station(0, Motion::ThY), Coordinate::Drive],
        mesh_station: 0,
        reduction: None,
    }
}

fn pair() -> Model {
    Model {
        kind: ModelKind::Fe,
        pinion: turning(1.8e-3, 0.03),
        gear: turning(4.5e-2, -0.0965),
        mesh_stiffness: 2e8,
        mesh_damping: 0.06,
        structural_damping: 0.0,
        damping_model: DampingModel::Hysteretic,
        transmission_error: 1e-6,
    }
}

#[test]
fn mesh_force() {
    assert_close("equivalent mass", 1.0 / (0.03_f64.powi(2) / 1.8e-3 + 0.0965_f64.powi(2) / 4.5e-2), M, 2e-8);
    let lines = [500.0, 1000.0, 1500.0, 2500.0, 4000.0];
    let expected = [15.004_541, 77.349_314, 334.273_60, 467.737_83, 258.102_65];
    let model = pair();
    for spectrum in [Spectrum::new(&model, &lines).unwrap(), direct_spectrum(&model, &lines).unwrap()] {
        for (force, expected) in spectrum.mesh_force.iter().zip(expected) {
            assert_close("|F_m|", force.norm(), expected, 5e-8);
        }
    }
}

#[test]
fn resonance() {
    let modes = Modes::new(&pair(), 4).unwrap().0;
    assert!(modes[0].frequency_hz == 0.0);
    let elastic = modes.iter().map(|mode| mode.frequency_hz).find(|f| (1800.0..2000.0).contains(f)).unwrap();
    assert_close("resonance", elastic, 1892.4572, 2e-8);
    assert_close("resonance", elastic, (2e8_f64 / M).sqrt() / TAU, 2e-8);
}
