//! Load-deflection constants from geometry: Hertz point contact of balls, line contact of rollers, both of steel.

use std::f64::consts::PI;

/// Young's modulus (Pa) and Poisson's ratio of bearing steel.
const STEEL: (f64, f64) = (206e9, 0.3);

/// A ball between its grooves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BallGeometry {
    /// D, m
    pub ball_diameter: f64,
    /// d_m, m
    pub pitch_diameter: f64,
    /// Groove radius over ball diameter, f_i
    pub inner_groove_factor: f64,
    /// f_o
    pub outer_groove_factor: f64,
    /// rad
    pub contact_angle: f64,
}

impl BallGeometry {
    /// A0 = (f_i + f_o - 1) D, m.
    pub fn groove_distance(&self) -> f64 {
        (self.inner_groove_factor + self.outer_groove_factor - 1.0) * self.ball_diameter
    }

    /// Radius of the inner groove centres, r = d_m/2 + (f_i - 1/2) D cos(alpha0), m.
    pub fn radius(&self) -> f64 {
        self.pitch_diameter / 2.0 + (self.inner_groove_factor - 0.5) * self.ball_diameter * self.contact_angle.cos()
    }

    /// Kn of both raceways of a steel bearing, N/m^(3/2).
    pub fn contact_stiffness(&self) -> f64 {
        self.contact_stiffness_of(STEEL.0, STEEL.1)
    }

    /// Kn for rings and balls of that Young's modulus (Pa) and Poisson's ratio.
    pub fn contact_stiffness_of(&self, youngs_modulus: f64, poissons_ratio: f64) -> f64 {
        // 2 / ((1 - nu1^2)/E1 + (1 - nu2^2)/E2) for two bodies of one material
        let modulus = youngs_modulus / (1.0 - poissons_ratio * poissons_ratio);
        let g = self.ball_diameter * self.contact_angle.cos() / self.pitch_diameter;
        let inner = self.raceway(self.inner_groove_factor, 2.0 * g / (1.0 - g), modulus);
        let outer = self.raceway(self.outer_groove_factor, -2.0 * g / (1.0 + g), modulus);
        (inner.powf(-2.0 / 3.0) + outer.powf(-2.0 / 3.0)).powf(-1.5)
    }

    /// Q / delta^(3/2) of one raceway; `rolling` is the curvature along the raceway, times the ball diameter.
    fn raceway(&self, groove_factor: f64, rolling: f64, modulus: f64) -> f64 {
        let sum = 4.0 - 1.0 / groove_factor + rolling;
        let difference = (1.0 / groove_factor + rolling) / sum;
        let kappa = ellipticity(difference);
        let (first, second) = elliptic_integrals(kappa);
        PI * kappa * modulus * (second / (4.5 * first.powi(3) * sum / self.ball_diameter)).sqrt()
    }
}

/// Kn of a steel roller on both raceways over its effective length (m), N/m^(10/9): the value of ISO/TS 16281,
/// 35948 l^(8/9) N/mm^(10/9) with l in mm.
pub fn roller_contact_stiffness(length: f64) -> f64 {
    3.5948e10 * length.powf(8.0 / 9.0)
}

/// Axis ratio kappa > 1 of the contact ellipse from the difference of curvatures F.
fn ellipticity(difference: f64) -> f64 {
    let curvature = |kappa: f64| {
        let (first, second) = elliptic_integrals(kappa);
        1.0 - 2.0 / (kappa * kappa - 1.0) * (first / second - 1.0)
    };
    // F rises from 0 (circle) to 1 (line)
    let (mut low, mut high) = (1e-4_f64, 30.0_f64);
    for _ in 0..100 {
        let middle = f64::midpoint(low, high);
        if curvature(middle.exp()) < difference { low = middle } else { high = middle }
    }
    f64::midpoint(low, high).exp()
}

/// Complete elliptic integrals of the first and second kind of parameter m = 1 - 1/kappa^2, by the arithmetic-geometric mean.
fn elliptic_integrals(kappa: f64) -> (f64, f64) {
    let (mut a, mut b) = (1.0, 1.0 / kappa);
    let mut sum = (1.0 - b * b) / 2.0;
    let mut weight = 1.0;
    while (a - b).abs() > 1e-16 * a {
        let c = (a - b) / 2.0;
        (a, b) = (f64::midpoint(a, b), (a * b).sqrt());
        sum += weight * c * c;
        weight *= 2.0;
        if weight > 1e12 {
            break;
        }
    }
    let first = PI / (2.0 * a);
    (first, first * (1.0 - sum))
}

#[cfg(test)]
mod tests {
    use super::*;

    // Abramowitz and Stegun (1964), table 17.1: m = 0.5 and m = 0.9.
    #[test]
    fn elliptic_integrals_are_those_of_the_tables() {
        for (m, first, second) in [
            (0.5_f64, 1.854_074_677_301_372, 1.350_643_881_047_676),
            (0.9, 2.578_092_113_348_173, 1.104_774_732_704_073),
        ] {
            let (k, e) = elliptic_integrals(1.0 / (1.0 - m).sqrt());
            assert!((k / first - 1.0).abs() < 1e-14 && (e / second - 1.0).abs() < 1e-14, "{m}: {k} {e}");
        }
    }

    // Brewe and Hamrock (1977): kappa = a^(2/pi) and simple fits of the integrals are within 3 % of the exact constant for groove
    // factors 0.515 to 0.53 and g = 0.1 to 0.3.
    #[test]
    fn the_constant_is_near_that_of_the_usual_fits() {
        for f in [0.515, 0.52, 0.53] {
            for g in [0.1, 0.2, 0.3] {
                let geometry = BallGeometry {
                    ball_diameter: 0.01,
                    pitch_diameter: 0.01 / g,
                    inner_groove_factor: f,
                    outer_groove_factor: f,
                    contact_angle: 0.0,
                };
                let rolling = 2.0 * g / (1.0 - g);
                let exact = geometry.raceway(f, rolling, 226e9);
                // curvature radii across and along the groove
                let (across, along) = (1.0 / (2.0 - 1.0 / f), 1.0 / (2.0 + rolling));
                let a: f64 = across / along;
                let (kappa, e, k) =
                    (a.powf(2.0 / PI), 1.0 + (PI / 2.0 - 1.0) / a, PI / 2.0 + (PI / 2.0 - 1.0) * a.ln());
                let sum = 4.0 - 1.0 / f + rolling;
                let fit = PI * kappa * 226e9 * (e / (4.5 * k.powi(3) * sum / 0.01)).sqrt();
                assert!((fit / exact - 1.0).abs() < 0.03, "f {f}, g {g}: {fit:e} {exact:e}");
            }
        }
    }
}
