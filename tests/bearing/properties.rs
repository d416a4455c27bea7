//! What holds for any bearing at any displacement, over random ones.

use bevelscope::bearing::{Bearing, Data, Kind, Matrix, Vector, equilibrium, frames};
use nalgebra::{Rotation3, Vector3, Vector6};
use num_complex::Complex64;
use proptest::prelude::*;

use crate::difference;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Sort {
    Ball,
    Roller,
    Spread,
}

fn log_range(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low.ln()..high.ln()).prop_map(f64::exp)
}

/// A bearing, and a displacement at which something is in contact: as far as the largest contacts of catalogue loads.
fn cases() -> impl Strategy<Value = (Bearing, Vector)> {
    let sorts = prop_oneof![Just(Sort::Ball), Just(Sort::Roller), Just(Sort::Spread)];
    let numbers = (5_usize..30, -50.0..50.0_f64, log_range(0.01, 0.15), log_range(0.2, 5.0), 0.0..8e-6_f64);
    (sorts, numbers, proptest::array::uniform5(-1.0..1.0_f64), log_range(2e-6, 4e-5))
        .prop_map(|(sort, (elements, degrees, radius, stiffness, clearance), direction, size)| {
            let kind = match sort {
                Sort::Ball => Kind::Ball { groove_distance: 0.012 * radius },
                Sort::Roller => Kind::Roller { length: 0.0 },
                Sort::Spread => Kind::Roller { length: 0.4 * radius },
            };
            let contact_stiffness = stiffness * if sort == Sort::Ball { 1e10 } else { 1e9 };
            let contact_angle = degrees.to_radians();
            let bearing = Bearing::new(Data { elements, contact_angle, clearance, radius, contact_stiffness, kind });
            let tilt = size / radius;
            let mut q = Vector::from(direction).component_mul(&Vector::new(size, size, size, tilt, tilt));
            // the loaded way, mostly
            q[2] = q[2].abs() * contact_angle.signum() + q[2] * 0.3;
            (bearing.unwrap(), q)
        })
        .prop_filter("nothing is in contact", |(bearing, q)| bearing.state(q).loaded() > 0)
}

fn size(matrix: &Matrix, radius: f64) -> f64 {
    let scale = Vector::new(1.0, 1.0, 1.0, 1.0 / radius, 1.0 / radius);
    Matrix::from_fn(|i, j| matrix[(i, j)] * scale[i] * scale[j]).amax()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// df/dq by a step along the imaginary axis, which loses no digits.
    #[test]
    fn stiffness_is_the_complex_step_derivative((bearing, q) in cases()) {
        const STEP: f64 = 1e-30;
        let mut derivative = Matrix::zeros();
        for column in 0..5 {
            let mut at: [Complex64; 5] = std::array::from_fn(|i| Complex64::new(q[i], 0.0));
            at[column].im = STEP;
            for (row, load) in bearing.load(&at).into_iter().enumerate() {
                derivative[(row, column)] = load.im / STEP;
            }
        }
        let error = difference(&bearing.stiffness(&q), &derivative, bearing.radius());
        prop_assert!(error < 1e-12, "{error:e}");
    }

    /// Loads are the gradient of the energy, by differences of fourth order.
    #[test]
    fn loads_are_the_gradient_of_the_energy((bearing, q) in cases()) {
        let load = Vector::from(bearing.load(&q.into()));
        let size = load[0].abs().max(load[1].abs()).max(load[2].abs());
        for i in 0..5 {
            let arm = if i < 3 { 1.0 } else { bearing.radius() };
            let step = 1e-9 / arm;
            let at = |steps: f64| { let mut q = q; q[i] += steps * step; bearing.energy(&q) };
            let slope = (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step);
            prop_assert!((slope - load[i]).abs() <= 2e-3 * size * arm, "{i}: {slope} {}", load[i]);
        }
    }

    #[test]
    fn stiffness_is_symmetric_and_semidefinite((bearing, q) in cases()) {
        let k = bearing.stiffness(&q);
        prop_assert_eq!(k, k.transpose());
        let r = bearing.radius();
        let scale = Vector::new(1.0, 1.0, 1.0, 1.0 / r, 1.0 / r);
        let scaled = Matrix::from_fn(|i, j| k[(i, j)] * scale[i] * scale[j]);
        let least = scaled.symmetric_eigenvalues().min();
        prop_assert!(least >= -1e-13 * scaled.amax(), "{least:e}");
    }

    /// A roller bearing without load spread meets its loads at the apex.
    #[test]
    fn rank_of_a_point_roller_is_at_most_three((bearing, q) in cases()) {
        let k = bearing.stiffness(&q);
        if bearing.exponent() < 1.2 && bearing.full_contact(1e-6).rank(1e-6) <= 3 {
            let arm = bearing.radius() * bearing.contact_angle().tan();
            for j in 0..5 {
                prop_assert!((k[(3, j)] - arm * k[(1, j)]).abs() <= 1e-12 * k.amax());
                prop_assert!((k[(4, j)] + arm * k[(0, j)]).abs() <= 1e-12 * k.amax());
            }
        }
    }

    /// Turned by a whole number of pitches about its axis, everything turns along.
    #[test]
    fn rotation_about_the_axis((bearing, q) in cases(), pitches in 1_usize..7) {
        let angle = std::f64::consts::TAU * pitches as f64 / bearing.elements() as f64;
        let (s, c) = angle.sin_cos();
        let mut turn = Matrix::identity();
        for at in [0, 3] {
            turn[(at, at)] = c;
            turn[(at, at + 1)] = -s;
            turn[(at + 1, at)] = s;
            turn[(at + 1, at + 1)] = c;
        }
        let (here, there) = (bearing.state(&q), bearing.state(&(turn * q)));
        prop_assert!((turn * here.load - there.load).amax() <= 1e-10 * here.load.amax());
        let turned = turn * here.stiffness * turn.transpose();
        prop_assert!(difference(&turned, &there.stiffness, bearing.radius()) < 1e-9);
    }

    /// f(q; c Kn) = c f, and without clearance f(c q) = c^n f for rollers.
    #[test]
    fn loads_scale((bearing, q) in cases(), factor in 0.1..10.0_f64) {
        let of = |factor: f64, clearance: f64, q: &Vector| {
            Vector::from(rebuilt(&bearing, factor, clearance).load(&(*q).into()))
        };
        let plain = of(1.0, bearing.clearance(), &q);
        let stiffer = of(factor, bearing.clearance(), &q);
        prop_assert!((stiffer - plain * factor).amax() <= 1e-12 * stiffer.amax());
        if bearing.exponent() < 1.2 {
            let (one, more) = (of(1.0, 0.0, &q), of(1.0, 0.0, &(q * factor)));
            prop_assert!((more - one * factor.powf(bearing.exponent())).amax() <= 1e-10 * more.amax());
        }
    }

    /// Loads that come from a displacement have an equilibrium, and it is found.
    #[test]
    fn loads_of_a_displacement_are_balanced((bearing, q) in cases()) {
        let mut held = [None; 5];
        if bearing.exponent() < 1.2 && bearing.full_contact(1e-6).rank(1e-6) <= 3 {
            (held[3], held[4]) = (Some(q[3]), Some(q[4]));
        }
        let load = Vector::from(bearing.load(&q.into()));
        let state = equilibrium(&bearing, &load, &held);
        prop_assert!(state.is_ok(), "{state:?}");
        let arm = Vector::new(1.0, 1.0, 1.0, bearing.radius(), bearing.radius());
        let found = state.unwrap().load;
        let (off, most) = ((found - load).component_div(&arm), load.component_div(&arm).amax());
        for i in (0..5).filter(|&i| held[i].is_none()) {
            prop_assert!(off[i].abs() <= 1e-9 * most, "{i}: {:e}", off[i].abs() / most);
        }
    }

    /// The stiffness in the shafts' frame, from forces and lever arms in space.
    #[test]
    fn the_shafts_frame_is_that_of_cross_products((bearing, q) in cases()) {
        let station = frames::to_station(&q);
        prop_assert_eq!(frames::to_bearing(&station), q);
        let state = bearing.state(&q);
        let load = frames::to_station(&state.load);
        let mut expected = Vector6::zeros();
        let r = bearing.radius();
        for contact in &state.contacts {
            // from +z (up) towards +x, seen along +y
            let outwards = Rotation3::from_axis_angle(&Vector3::y_axis(), contact.position) * Vector3::z();
            let (sin, cos) = contact.angle.sin_cos();
            let force = contact.load * (cos * outwards + sin * Vector3::y());
            let moment = (r * outwards).cross(&(contact.load * sin * Vector3::y()));
            for i in 0..3 {
                expected[i] += force[i];
                expected[i + 3] += moment[i];
            }
        }
        prop_assert!((load - expected).fixed_rows::<3>(0).amax() <= 1e-11 * load.amax(), "{load} {expected}");
        if bearing.full_contact(1e-6).rank(1e-6) <= 3 || bearing.exponent() > 1.2 {
            prop_assert!((load - expected).fixed_rows::<3>(3).amax() <= 1e-11 * load.amax(), "{load} {expected}");
        }
        let k = frames::stiffness_to_station(&state.stiffness);
        prop_assert!(k.row(4).amax() == 0.0 && k.column(4).amax() == 0.0);
        let load = |q: &Vector6<f64>| frames::to_station(&Vector::from(bearing.load(&frames::to_bearing(q).into())));
        let step = frames::to_station(&(q * 1e-7));
        let off = load(&(station + step)) - load(&(station - step)) - 2.0 * k * step;
        prop_assert!(off.amax() <= 1e-6 * state.load.amax() + 1e-9 * size(&state.stiffness, r) * q.amax());
    }
}

/// The same bearing with other contacts.
fn rebuilt(bearing: &Bearing, factor: f64, clearance: f64) -> Bearing {
    let data = bearing.data();
    Bearing::new(Data { contact_stiffness: factor * data.contact_stiffness, clearance, ..data }).unwrap()
}
