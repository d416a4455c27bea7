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
    /// Dunkerley: 1/w1^2 <= 1/w_b^2 + 1/w_s^2 + 1/w_r^2, with bending, shear and rotary inertia each alone; of a part of length l that is
    /// b l^4 + s l^2. `None` where the numbers overflow or the parts would be too many to be of use.
    pub fn parts_without_own_modes(&self, omega_squared: f64) -> Option<usize> {
        const CLAMPED: f64 = 500.563_901_740; // 4.730040745^4
        const MARGIN: f64 = 1.1;
        const PI_SQUARED: f64 = std::f64::consts::PI * std::f64::consts::PI;
        const MOST_PARTS: f64 = 10_000.0;
        let bending = MARGIN * omega_squared * self.mass / (CLAMPED * self.bending_stiffness);
        let shear = self.mass * self.shear_flexibility + self.rotary_inertia / self.bending_stiffness;
        let shear = MARGIN * omega_squared * shear / PI_SQUARED;
        // b l^4 + s l^2 < 1 for l^2 below the positive root 2 / (s + sqrt(s^2 + 4 b))
        let longest_squared = 2.0 / (shear + shear.hypot(2.0 * bending.sqrt()));
        let parts = (self.length / longest_squared.sqrt()).floor() + 1.0;
        (parts <= MOST_PARTS).then_some(parts as usize)
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
