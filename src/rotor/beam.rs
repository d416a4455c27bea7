//! The beam element: two nodes, twelve coordinates, consistent mass.
//!
//! Bending with shear after Przemieniecki (1968) and Friswell et al. (2010, section 5.4).

use nalgebra::{Matrix4, SMatrix};

use super::Section;

/// Element matrix over (x, y, z, thx, thy, thz) of the left node, then of the right one.
pub type ElementMatrix = SMatrix<f64, 12, 12>;

/// Positions of (w, dw/dy) at both ends in the y-z plane: dz/dy = +thx.
const PLANE_Z: [usize; 4] = [2, 3, 8, 9];
/// The same in the x-y plane, where dx/dy = -thz.
const PLANE_X: [usize; 4] = [0, 5, 6, 11];
const SIGN_X: [f64; 4] = [1.0, -1.0, 1.0, -1.0];
const AXIAL: [usize; 2] = [1, 7];
const TORSION: [usize; 2] = [4, 10];

/// Shear parameter p = 12 EI / (kappa G A L^2); 0 for Euler-Bernoulli.
fn shear_parameter(section: &Section, length: f64) -> f64 {
    12.0 * section.bending_stiffness * section.shear_flexibility / (length * length)
}

/// Stiffness of an element of the given length (m), in N/m, N and N m/rad.
pub fn stiffness(section: &Section, length: f64) -> ElementMatrix {
    let l = length;
    let p = shear_parameter(section, l);
    let (k4, k2) = ((4.0 + p) * l * l, (2.0 - p) * l * l);
    #[rustfmt::skip]
    let bending = Matrix4::new(
        12.0,     6.0 * l, -12.0,     6.0 * l,
        6.0 * l,  k4,      -6.0 * l,  k2,
        -12.0,   -6.0 * l,  12.0,    -6.0 * l,
        6.0 * l,  k2,      -6.0 * l,  k4,
    ) * (section.bending_stiffness / ((1.0 + p) * l.powi(3)));
    assemble(
        &bending,
        [section.axial_stiffness / l, -section.axial_stiffness / l],
        [section.torsional_stiffness / l, -section.torsional_stiffness / l],
    )
}

/// Consistent mass of an element of the given length (m), in kg, kg m and kg m^2.
pub fn mass(section: &Section, length: f64) -> ElementMatrix {
    let l = length;
    let p = shear_parameter(section, l);
    let a1 = 13.0 / 35.0 + 7.0 * p / 10.0 + p * p / 3.0;
    let a2 = (11.0 / 210.0 + 11.0 * p / 120.0 + p * p / 24.0) * l;
    let a3 = 9.0 / 70.0 + 3.0 * p / 10.0 + p * p / 6.0;
    let a4 = -(13.0 / 420.0 + 3.0 * p / 40.0 + p * p / 24.0) * l;
    let a5 = (1.0 / 105.0 + p / 60.0 + p * p / 120.0) * l * l;
    let a6 = -(1.0 / 140.0 + p / 60.0 + p * p / 120.0) * l * l;
    #[rustfmt::skip]
    let translation = Matrix4::new(
        a1,  a2,  a3,  a4,
        a2,  a5, -a4,  a6,
        a3, -a4,  a1, -a2,
        a4,  a6, -a2,  a5,
    ) * (section.mass * l / (1.0 + p).powi(2));
    let b1 = 6.0 / 5.0;
    let b2 = (0.1 - p / 2.0) * l;
    let b3 = (2.0 / 15.0 + p / 6.0 + p * p / 3.0) * l * l;
    let b4 = (-1.0 / 30.0 - p / 6.0 + p * p / 6.0) * l * l;
    #[rustfmt::skip]
    let rotation = Matrix4::new(
        b1,  b2, -b1,  b2,
        b2,  b3, -b2,  b4,
       -b1, -b2,  b1, -b2,
        b2,  b4, -b2,  b3,
    ) * (section.rotary_inertia / ((1.0 + p).powi(2) * l));
    assemble(
        &(translation + rotation),
        [section.mass * l / 3.0, section.mass * l / 6.0],
        [section.polar_inertia * l / 3.0, section.polar_inertia * l / 6.0],
    )
}

/// Puts a bending matrix over (w, s, w2, s2) into both planes, and the two-node bars (own, cross) beside it.
fn assemble(bending: &Matrix4<f64>, axial: [f64; 2], torsion: [f64; 2]) -> ElementMatrix {
    let mut out = ElementMatrix::zeros();
    for i in 0..4 {
        for j in 0..4 {
            out[(PLANE_Z[i], PLANE_Z[j])] = bending[(i, j)];
            out[(PLANE_X[i], PLANE_X[j])] = SIGN_X[i] * SIGN_X[j] * bending[(i, j)];
        }
    }
    for (nodes, [own, cross]) in [(AXIAL, axial), (TORSION, torsion)] {
        for i in 0..2 {
            for j in 0..2 {
                out[(nodes[i], nodes[j])] = if i == j { own } else { cross };
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::{BeamTheory, Material, Segment};

    /// E 211 GPa, G 81.2 GPa, 7810 kg/m^3, 0.25 m long, diameter 0.05 m: one element of example 5.9.1 in Friswell et al. (2010). The
    /// entries are from two independent programs.
    fn matrices(theory: BeamTheory) -> (ElementMatrix, ElementMatrix) {
        let steel = Material { youngs_modulus: 211e9, poissons_ratio: 211.0 / 162.4 - 1.0, density: 7810.0 };
        let segment = Segment {
            length: 0.25,
            outer_diameter: 0.05,
            inner_diameter: 0.0,
            material: "steel".to_owned(),
            elements: 1,
        };
        let section = Section::new(&segment, &steel, theory);
        (stiffness(&section, 0.25), mass(&section, 0.25))
    }

    #[track_caller]
    fn assert_entry(matrix: &ElementMatrix, (i, j): (usize, usize), expected: f64) {
        for found in [matrix[(i, j)], matrix[(j, i)]] {
            assert!((found - expected).abs() < 5.1e-7 * expected.abs(), "({i}, {j}): {found} instead of {expected}");
        }
    }

    #[test]
    fn entries_in_both_planes() {
        let euler = [
            [4.971_570e7, 6.214_463e6, 1.035_744e6, 5.178_719e5],
            [1.423_955, 5.020_354e-2, 2.281_979e-3, 0.492_907_5],
            [-2.966_573e-2, -1.711_484e-3, 0.0, 0.0],
        ];
        let timoshenko = [
            [4.569_644e7, 5.712_055e6, 9.729_429e5, 4.550_710e5],
            [1.420_508, 4.931_719e-2, 2.313_923e-3, 0.496_354_4],
            [-3.055_208e-2, -1.779_377e-3, 0.0, 0.0],
        ];
        for (theory, [[kww, kws, kss, kss2], [mww, mws, mss, mww2], [mws2, mss2, ..]]) in
            [(BeamTheory::EulerBernoulli, euler), (BeamTheory::Timoshenko, timoshenko)]
        {
            let (k, m) = matrices(theory);
            // (deflection, slope) of both nodes, and the sign of the slope: dz/dy = +thx, dx/dy = -thz
            for ([w, s, w2, s2], sign) in [([2, 3, 8, 9], 1.0), ([0, 5, 6, 11], -1.0)] {
                for (a, b, c, d, mirror) in [(w, s, w2, s2, 1.0), (w2, s2, w, s, -1.0)] {
                    let turn = sign * mirror;
                    assert_entry(&k, (a, a), kww);
                    assert_entry(&k, (a, c), -kww);
                    assert_entry(&k, (a, b), turn * kws);
                    assert_entry(&k, (a, d), turn * kws);
                    assert_entry(&k, (b, b), kss);
                    assert_entry(&k, (b, d), kss2);
                    assert_entry(&m, (a, a), mww);
                    assert_entry(&m, (a, b), turn * mws);
                    assert_entry(&m, (b, b), mss);
                    assert_entry(&m, (a, c), mww2);
                    assert_entry(&m, (a, d), turn * mws2);
                    assert_entry(&m, (b, d), mss2);
                }
            }
            for (i, j) in [(1, 1), (7, 7)] {
                assert_entry(&k, (i, j), 1.657_190e9);
                assert_entry(&m, (i, j), 1.277_908);
            }
            assert_entry(&k, (1, 7), -1.657_190e9);
            assert_entry(&m, (1, 7), 1.277_908 / 2.0);
            assert_entry(&k, (4, 4), 1.992_948e5);
            assert_entry(&k, (4, 10), -1.992_948e5);
            assert_entry(&m, (4, 4), 3.993_463e-4);
            assert_entry(&m, (10, 4), 3.993_463e-4 / 2.0);
        }
    }

    /// Rigid motions strain nothing and carry the element's mass: the signs of the slopes, seen from outside.
    #[test]
    fn rigid_motions() {
        for theory in [BeamTheory::EulerBernoulli, BeamTheory::Timoshenko] {
            let (k, m) = matrices(theory);
            let (mass, length) = (3.0 * 1.277_908, 0.25);
            // in z, in x, tilt about x with z = y thx, tilt about z with x = -y thz
            let motions =
                [(2, 3, 0.0), (0, 5, 0.0), (2, 3, 1.0), (0, 5, -1.0)].map(|(w, s, slope): (usize, usize, f64)| {
                    let mut shape = nalgebra::SVector::<f64, 12>::zeros();
                    if slope == 0.0 {
                        (shape[w], shape[w + 6]) = (1.0, 1.0);
                    } else {
                        (shape[s], shape[s + 6], shape[w + 6]) = (slope, slope, length);
                    }
                    shape
                });
            let rotary = if theory == BeamTheory::Timoshenko { mass * 0.05 * 0.05 / 16.0 } else { 0.0 };
            let carried = [mass, mass, mass * length * length / 3.0 + rotary, mass * length * length / 3.0 + rotary];
            for (shape, carried) in motions.iter().zip(carried) {
                assert!((k * shape).amax() < 1e-14 * k.amax(), "{shape}");
                let found = shape.dot(&(m * shape));
                assert!((found - carried).abs() < 1e-6 * carried, "{found} instead of {carried}");
            }
        }
    }
}
