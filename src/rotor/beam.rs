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
