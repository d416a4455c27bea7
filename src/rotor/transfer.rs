//! Transfer matrix of a uniform beam piece that vibrates at a given frequency.
//!
//! The Initial Parameter Method (Hua et al. 2012, eqs. 36-40) carries the state (z, phi, Mb, Q) along the shaft. With shear
//! flexibility and rotary inertia the state obeys
//!
//! z' = phi - Q/(kappa G A), phi' = Mb/EI, Mb' = Q - rho I w^2 phi, Q' = rho A w^2 z,
//!
//! and the transfer matrix is f0 + f1 A + f2 A^2 + f3 A^3 with A the matrix of that system. Without the two, f0..f3 are the
//! Krylov-Duncan functions S, T/k, U/k^2, V/k^3 of (40).

use nalgebra::Matrix4;

/// A uniform piece of a beam that bends in one plane; any consistent units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    pub length: f64,
    /// EI
    pub bending_stiffness: f64,
    /// 1/(kappa G A); 0 for Euler-Bernoulli
    pub shear_flexibility: f64,
    /// rho A
    pub mass: f64,
    /// rho I; 0 for Euler-Bernoulli
    pub rotary_inertia: f64,
}

impl Piece {
    /// State at the piece's end from the state at its start, at `omega_squared` over the given length.
    pub fn transfer(&self, omega_squared: f64, length: f64) -> Matrix4<f64> {
        let e = 1.0 / self.bending_stiffness;
        let g = self.shear_flexibility;
        let m = self.mass * omega_squared;
        let i = self.rotary_inertia * omega_squared;
        let (shear, rotary) = (g * m, i * e);
        // A has the eigenvalues +-sqrt(p), +-sqrt(q): mu^2 + (shear + rotary) mu + shear rotary - m e = 0
        let root = (shear - rotary).hypot(2.0 * (m * e).sqrt());
        let q = -(shear + rotary + root) / 2.0;
        let p = if q == 0.0 { 0.0 } else { (shear * rotary - m * e) / q };
        let [f0, f1, f2, f3] = krylov(p, q, length);
        let (a, b) = (shear + rotary, e + g * shear);
        #[rustfmt::skip]
        let transfer = Matrix4::new(
            f0 - f2 * shear,          f1 - f3 * a,               f2 * e,                     f3 * b - f1 * g,
            f3 * e * m,               f0 - f2 * rotary,          f1 * e - f3 * e * rotary,   f2 * e,
            f2 * m,                   f3 * (m + i * rotary) - f1 * i, f0 - f2 * rotary,      f1 - f3 * a,
            f1 * m - f3 * m * shear,  f2 * m,                    f3 * m * e,                 f0 - f2 * shear,
        );
        transfer
    }

    /// Into how many equal parts the piece must be cut so that none, clamped at both ends, has a natural frequency at or below w.
    ///
    /// Dunkerley: 1/w1^2 <= 1/w_b^2 + 1/w_s^2 + 1/w_r^2, with bending, shear and rotary inertia each alone. Three at most up to
    /// [`Self::clamped_bound`].
    pub fn parts_without_own_modes(&self, omega_squared: f64) -> usize {
        const MARGIN: f64 = 1.1;
        // past that the numbers have overflowed
        const MOST: f64 = 1000.0;
        let [bending, shear, rotary] = self.clamped_alone();
        let mut parts: f64 = 1.0;
        while parts < MOST {
            let length_squared = parts.powi(-2);
            let sum = bending * length_squared * length_squared + (shear + rotary) * length_squared;
            if MARGIN * omega_squared * sum < 1.0 {
                break;
            }
            parts += 1.0;
        }
        parts as usize
    }

    /// Square of a frequency that the first one of the piece, clamped at both ends, does not exceed.
    ///
    /// Rigid in bending or in shear, without mass or without rotary inertia it could only be higher. With all nodes clamped a shaft would have
    /// the lowest frequency of its pieces, so that this bounds the shaft's first mode too.
    pub fn clamped_bound(&self) -> f64 {
        let [bending, shear, rotary] = self.clamped_alone();
        // the first root with rotary inertia alone is 4 pi^2, not pi^2
        1.0 / bending.max(shear).max(rotary / 4.0)
    }

    /// 1/w^2 of the piece clamped at both ends: with bending, with shear and (w from below) with rotary inertia alone.
    fn clamped_alone(&self) -> [f64; 3] {
        const CLAMPED: f64 = 500.563_901_740; // 4.730040745^4
        const PI_SQUARED: f64 = std::f64::consts::PI * std::f64::consts::PI;
        let length_squared = self.length * self.length;
        [
            self.mass * length_squared * length_squared / (CLAMPED * self.bending_stiffness),
            self.mass * self.shear_flexibility * length_squared / PI_SQUARED,
            self.rotary_inertia * length_squared / (PI_SQUARED * self.bending_stiffness),
        ]
    }
}

/// The functions f0..f3 of x^n with exp(x l) = f0 + f1 x + f2 x^2 + f3 x^3 at x = +-sqrt(p), +-sqrt(q); q <= 0.
fn krylov(p: f64, q: f64, l: f64) -> [f64; 4] {
    let (cp, sp) = even_and_odd(p, l);
    if p.abs().max(q.abs()) * l * l < 0.25 {
        // U and V as differences would lose digits: sum their series, h the complete symmetric polynomials of p and q
        let (mut h, mut power) = (1.0, 1.0);
        let (mut f2, mut f3) = (0.0, 0.0);
        let mut term = l * l / 2.0;
        for n in 0..9 {
            let even = f64::from(2 * n + 2);
            f2 += h * term;
            f3 += h * term * l / (even + 1.0);
            term *= l * l / ((even + 1.0) * (even + 2.0));
            power *= q;
            h = p * h + power;
        }
        return [cp - p * f2, sp - p * f3, f2, f3];
    }
    let (cq, sq) = even_and_odd(q, l);
    let d = p - q;
    [(p * cq - q * cp) / d, (p * sq - q * sp) / d, (cp - cq) / d, (sp - sq) / d]
}

/// cosh(sqrt(mu) l) and sinh(sqrt(mu) l)/sqrt(mu), for either sign of mu.
fn even_and_odd(mu: f64, l: f64) -> (f64, f64) {
    let x = mu.abs().sqrt() * l;
    if x < 1e-4 {
        let x2 = mu * l * l;
        (1.0 + x2 / 2.0, l * (1.0 + x2 / 6.0))
    } else if mu > 0.0 {
        (x.cosh(), l * x.sinh() / x)
    } else {
        (x.cos(), l * x.sin() / x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EULER: Piece =
        Piece { length: 1.0, bending_stiffness: 1.0, shear_flexibility: 0.0, mass: 1.0, rotary_inertia: 0.0 };
    const TIMOSHENKO: Piece = Piece { shear_flexibility: 0.012, rotary_inertia: 0.004, ..EULER };

    /// exp(A L) of the system in the module's head by its Taylor series with scaling and squaring.
    fn exponential(piece: &Piece, omega_squared: f64, length: f64) -> Matrix4<f64> {
        let (g, e) = (piece.shear_flexibility, 1.0 / piece.bending_stiffness);
        let (m, i) = (piece.mass * omega_squared, piece.rotary_inertia * omega_squared);
        #[rustfmt::skip]
        let system = Matrix4::new(
            0.0, 1.0, 0.0, -g,
            0.0, 0.0, e,   0.0,
            0.0, -i,  0.0, 1.0,
            m,   0.0, 0.0, 0.0,
        ) * (length / 64.0);
        let (mut sum, mut term) = (Matrix4::identity(), Matrix4::identity());
        for n in 1..40 {
            term = term * system / f64::from(n);
            sum += term;
        }
        (0..6).fold(sum, |power, _| power * power)
    }

    /// Every branch of the closed form: both theories, short and long pieces, below and above the frequency where the second pair of roots
    /// becomes a travelling wave (rho I w^2 = kappa G A).
    #[test]
    fn is_the_exponential_of_the_state_equations() {
        let cut_off = 1.0 / (TIMOSHENKO.shear_flexibility * TIMOSHENKO.rotary_inertia);
        for piece in
            [EULER, TIMOSHENKO, Piece { rotary_inertia: 0.0, ..TIMOSHENKO }, Piece { mass: 1e-9, ..TIMOSHENKO }]
        {
            for omega_squared in [0.0, 1e-6, 0.2, 3.0, 400.0, 0.999 * cut_off, cut_off, 1.001 * cut_off, 3.0 * cut_off]
            {
                for length in [1e-3, 0.1, 0.45, 0.5, 0.55, 1.0] {
                    let (found, expected) =
                        (piece.transfer(omega_squared, length), exponential(&piece, omega_squared, length));
                    for row in 0..4 {
                        for column in 0..4 {
                            // an entry is judged by the largest one of its row and column: the units are all 1 here
                            let size = expected.row(row).amax().min(expected.column(column).amax());
                            let error = (found[(row, column)] - expected[(row, column)]).abs() / size;
                            assert!(error < 1e-11, "{piece:?} {omega_squared} {length} ({row}, {column}): {error:e}");
                        }
                    }
                }
            }
        }
    }

    /// Cantilever with a body at its tip, clamped at the start (z = phi = 0): det of the tip's conditions on (Mb, Q).
    ///
    /// Roots x = k L with mu = M/(rho A L), j = J/(rho A L^3): Blevins, *Formulas for Natural Frequency and Mode Shape* (1979), table 8-8,
    /// to more digits by two independent programs.
    #[test]
    fn cantilevers_with_a_tip_body() {
        for (mu, j, root) in
            [(0.0, 0.0, 1.875_104), (0.5, 0.0, 1.419_964), (1.0, 0.0, 1.247_917), (1.0, 0.1, 1.195_670)]
        {
            let determinant = |x: f64| {
                let omega_squared = x.powi(4);
                let mut tip = EULER.transfer(omega_squared, 1.0);
                let (z, phi) = (tip.row(0).into_owned(), tip.row(1).into_owned());
                tip.set_row(2, &(tip.row(2) - phi * (omega_squared * j)));
                tip.set_row(3, &(tip.row(3) + z * (omega_squared * mu)));
                tip[(2, 2)] * tip[(3, 3)] - tip[(2, 3)] * tip[(3, 2)]
            };
            // half a unit of the last digit given, either side
            assert!(determinant(root - 5.1e-7) * determinant(root + 5.1e-7) < 0.0, "mu {mu}, j {j}");
        }
    }

    /// The bound is safe where it is used, at the clamped beam's own first frequency, and not wasteful.
    #[test]
    fn clamped_pieces_without_own_modes() {
        const CLAMPED: f64 = 4.730_040_744_862_704; // Blevins 1979, table 8-1
        assert_eq!(EULER.parts_without_own_modes((0.9 * CLAMPED).powi(4)), 1);
        assert_eq!(EULER.parts_without_own_modes(CLAMPED.powi(4)), 2);
        // clamped at both ends: the upper right block of the transfer matrix is singular first at the natural frequency
        let stubby = Piece { shear_flexibility: 0.3, rotary_inertia: 0.1, ..EULER };
        let rotary = Piece { rotary_inertia: 0.4, ..EULER };
        for piece in [EULER, TIMOSHENKO, stubby, rotary] {
            let own = |omega_squared: f64| {
                let t = piece.transfer(omega_squared, 1.0);
                t[(0, 2)] * t[(1, 3)] - t[(0, 3)] * t[(1, 2)]
            };
            let sign = own(1.0).signum();
            let mut omega_squared = 1.0;
            while piece.parts_without_own_modes(omega_squared) == 1 {
                assert!(own(omega_squared).signum() == sign, "{piece:?} has a mode below {omega_squared}");
                omega_squared *= 1.01;
            }
            // and below the bound from above it has one
            while own(omega_squared).signum() == sign {
                assert!(omega_squared < 1.01 * piece.clamped_bound(), "{piece:?} has no mode below {omega_squared}");
                omega_squared *= 1.001;
            }
            assert!(piece.parts_without_own_modes(piece.clamped_bound()) <= 3);
        }
    }
}
