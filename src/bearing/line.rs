//! Integrals along the contact line of a roller.

use nalgebra::ComplexField;

/// Gauss-Legendre points and weights of order 16 on (0, 1); mirrored for the other half.
const GAUSS: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_6),
    (0.458_016_777_657_227_4, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_7, 0.149_595_988_816_576_73),
    (0.755_404_408_355_003, 0.124_628_971_255_533_87),
    (0.865_631_202_387_831_7, 0.095_158_511_682_492_78),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_89),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_095),
];

/// (1/L) int xi^k (delta + xi tilt)_+^m dxi over -L/2 < xi < L/2, for k = 0, 1, 2. Without a length, the value at the middle.
///
/// Quadrature where the line is loaded rather evenly: there the closed form would subtract nearly equal powers, and the integrand is smooth.
pub(super) fn moments<T: ComplexField<RealField = f64> + Copy>(delta: T, tilt: T, length: f64, m: f64) -> [T; 3] {
    let of = T::from_real;
    let half = length / 2.0;
    // delta and tilt * half: value at the middle, and what it gains towards the end
    let slope = tilt * of(half);
    let (middle, gain) = (delta.real(), slope.real().abs());
    if middle + gain <= 0.0 {
        return [T::zero(); 3];
    }
    if gain < 0.5 * middle {
        if half == 0.0 {
            return [delta.powf(m), T::zero(), T::zero()];
        }
        let mut sums = [T::zero(); 3];
        for (t, weight) in GAUSS.into_iter().flat_map(|(t, weight)| [(t, weight), (-t, weight)]) {
            let value = (delta + slope * of(t)).powf(m) * of(weight / 2.0);
            for (sum, power) in sums.iter_mut().zip([1.0, t * half, (t * half).powi(2)]) {
                *sum += value * of(power);
            }
        }
        return sums;
    }
    // over delta itself, from one end of the line to the other
    let end = |value: T, power: f64| if value.real() > 0.0 { value.powf(power) } else { T::zero() };
    let integral = |j: f64| {
        let power = m + 1.0 + j;
        (end(delta + slope, power) - end(delta - slope, power)) * of(0.5 / power)
    };
    let (p0, p1, p2) = (integral(0.0), integral(1.0), integral(2.0));
    [
        p0 / slope,
        (p1 - delta * p0) * of(half) / (slope * slope),
        (p2 - delta * p1 * of(2.0) + delta * delta * p0) * of(half * half) / (slope * slope * slope),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Midpoint rule over 20,000 slices.
    fn slices(delta: f64, tilt: f64, length: f64, m: f64) -> [f64; 3] {
        const N: usize = 20_000;
        let mut sums = [0.0; 3];
        for i in 0..N {
            let xi = length * ((i as f64 + 0.5) / N as f64 - 0.5);
            let value = (delta + xi * tilt).max(0.0).powf(m) / N as f64;
            for (k, sum) in sums.iter_mut().enumerate() {
                *sum += value * [1.0, xi, xi * xi][k];
            }
        }
        sums
    }

    #[test]
    fn the_integrals_are_those_of_20_000_slices() {
        let length = 0.017;
        for m in [1.0 / 9.0, 10.0 / 9.0, 19.0 / 9.0] {
            for delta in [-4e-6, -1e-7, 1e-9, 3e-6, 8e-6] {
                for tilt in [-2e-3, -9e-4, -1e-4, -1e-9, 0.0, 1e-6, 4.6e-4, 4.8e-4, 3e-3] {
                    let (found, expected) = (moments(delta, tilt, length, m), slices(delta, tilt, length, m));
                    let size = (delta.abs() + tilt.abs() * length).powf(m);
                    for k in 0..3 {
                        let error = (found[k] - expected[k]).abs() / (size * [1.0, length, length * length][k]);
                        // the one slice that is partly loaded is off by its own size, the others by that of the midpoint rule
                        let tolerance = 2.0 * (1.0 / 20_000_f64).powf(1.0 + m) + 1e-8;
                        assert!(error < tolerance, "m {m}, delta {delta}, tilt {tilt}, k {k}: {error:.1e}");
                    }
                }
            }
        }
    }

    // Both ways are right to rounding where they meet, at gain = delta / 2.
    #[test]
    fn quadrature_and_closed_form_meet() {
        let (delta, length) = (8e-6, 0.017);
        let tilt = delta / length;
        for m in [1.0 / 9.0, 10.0 / 9.0, 19.0 / 9.0] {
            let (below, above) =
                (moments(delta, tilt * (1.0 - 1e-15), length, m), moments(delta, tilt * (1.0 + 1e-15), length, m));
            for k in 0..3 {
                assert!((below[k] / above[k] - 1.0).abs() < 1e-13, "m {m}, k {k}: {} {}", below[k], above[k]);
            }
        }
    }

    #[test]
    fn a_line_without_length_is_a_point() {
        let short = moments(8e-6, 1e-3, 1e-9, 10.0 / 9.0);
        let point = moments(8e-6, 1e-3, 0.0, 10.0 / 9.0);
        assert!((short[0] / point[0] - 1.0).abs() < 1e-12 && short[1].abs() < 1e-9 * short[0] && point[1] == 0.0);
    }
}
