//! Beam pinned at both ends: E = 211 GPa, G = 81.2 GPa, 7810 kg/m^3, 1 m long, diameter 0.04 m.
//!
//! Euler-Bernoulli: (n pi)^2 sqrt(EI/(rho A L^4)) (Timoshenko, Young and Weaver, *Vibration Problems in Engineering*, 1974, section 5.10).
//! Timoshenko: with w = sin(n pi y/L) the frequency equation is quadratic in w^2 (Cowper 1966). The figures of eight elements are from
//! two independent finite element programs.

use std::f64::consts::PI;

use bevelscope::design::{BeamTheory, Design, Side};
use bevelscope::rotor::{Rotor, ShaftMatrices};
use nalgebra::DMatrix;

use crate::support::{FRISWELL_STEEL, assert_close, dense, design, ordinary, rigid, rotor, steel_shaft};

fn pinned(theory: BeamTheory, elements: usize) -> Design {
    let bearings = vec![rigid(0.0, [true; 3]), rigid(1.0, [true, false, true])];
    let mut shaft = rotor(vec![steel_shaft(1.0, 0.04, elements)], vec![], bearings);
    shaft.mesh_position = 0.25;
    design(theory, FRISWELL_STEEL, shaft, ordinary().gear)
}

/// Bending frequencies (rad/s) of the finite element model in both planes, ascending.
fn bending(design: &Design) -> Vec<f64> {
    let solved = Rotor::new(design, Side::Pinion).unwrap();
    let shaft = ShaftMatrices::new(&design.pinion, &solved.stations, &solved.supports);
    let kept: Vec<usize> = (0..shaft.free.len()).filter(|&i| shaft.free[i] && ![1, 4].contains(&(i % 6))).collect();
    let pick = |a: &DMatrix<f64>| a.select_rows(&kept).select_columns(&kept);
    let (lambda, _) = dense::generalized(&pick(&shaft.stiffness), &pick(&shaft.mass), 1e5);
    lambda.into_iter().map(f64::sqrt).collect()
}

/// n-th exact frequency under Timoshenko's theory, kappa after Cowper for a solid round section.
fn exact_timoshenko(n: f64) -> f64 {
    let nu = FRISWELL_STEEL.poissons_ratio;
    let kappa = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu);
    let (area, second_moment) = (PI / 4.0 * 0.04_f64.powi(2), PI / 64.0 * 0.04_f64.powi(4));
    let (e, g, rho) = (211e9, 81.2e9, 7810.0);
    let q = (n * PI).powi(2);
    // (kGA q - rho A w^2)(EI q + kGA - rho I w^2) = (kGA)^2 q
    let shear = kappa * g * area;
    let (a, b) = (
        rho * area * rho * second_moment,
        shear * q * rho * second_moment + rho * area * (e * second_moment * q + shear),
    );
    let c = shear * q * e * second_moment * q;
    (2.0 * c / (b + (b * b - 4.0 * a * c).sqrt())).sqrt()
}

#[test]
fn eight_elements() {
    for (theory, expected) in [
        (BeamTheory::EulerBernoulli, [513.0062, 2052.524, 4622.920]),
        (BeamTheory::Timoshenko, [512.0238, 2037.400, 4550.912]),
    ] {
        let found = bending(&pinned(theory, 8));
        for (i, expected) in expected.into_iter().enumerate() {
            for plane in 0..2 {
                // to half a unit of the last digit given
                let (found, digit) = (found[2 * i + plane], if expected < 1e3 { 1e-4 } else { 1e-3 });
                assert!((found - expected).abs() < 0.51 * digit, "{theory:?} {i}: {found} instead of {expected}");
            }
        }
    }
}

/// Consistent elements converge from above, cubic ones with the fourth power of their length. With shear the strain of an element is constant
/// where the true one varies: its share of the error falls with the second power, from a smaller value.
#[test]
fn refinement_tends_to_the_closed_form() {
    let euler = |n: f64| {
        (n * PI).powi(2) * (211e9 * PI / 64.0 * 0.04_f64.powi(4) / (7810.0 * PI / 4.0 * 0.04_f64.powi(2))).sqrt()
    };
    assert_close("closed form", euler(1.0), 512.9977, 1e-7);
    for (theory, exact) in [
        (BeamTheory::EulerBernoulli, [euler(1.0), euler(2.0), euler(3.0)]),
        (BeamTheory::Timoshenko, [1.0, 2.0, 3.0].map(exact_timoshenko)),
    ] {
        let orders = if theory == BeamTheory::EulerBernoulli { 3.95..4.05 } else { 1.9..3.0 };
        let [coarse, fine] = [8, 32].map(|elements| bending(&pinned(theory, elements)));
        for (i, exact) in exact.into_iter().enumerate() {
            let (before, after) = (coarse[2 * i] / exact - 1.0, fine[2 * i] / exact - 1.0);
            assert!(after > 0.0, "from above: {after:e}");
            let order = (before / after).log(4.0);
            assert!(orders.contains(&order), "{theory:?} {i}: {before:e} {after:e}, order {order}");
        }
    }
}

/// Transfer matrices have no discretisation error.
#[test]
fn transfer_matrices_give_the_closed_form() {
    let exact = [(BeamTheory::EulerBernoulli, 512.997_7), (BeamTheory::Timoshenko, exact_timoshenko(1.0))];
    for (theory, omega) in exact {
        let design = pinned(theory, 8);
        let solved = Rotor::new(&design, Side::Pinion).unwrap();
        let tolerance = if theory == BeamTheory::EulerBernoulli { 1e-7 } else { 1e-12 };
        for bending in [solved.bending_x, solved.bending_z] {
            assert_close("first bending", 2.0 * PI * bending.frequency, omega, tolerance);
        }
    }
}
