//! Numbers for reading.

pub mod ticks;

/// `digits` significant digits, in powers of ten only where the plain form would be long.
pub fn significant(value: f64, digits: usize) -> String {
    if value == 0.0 {
        return "0".into();
    }
    if !value.is_finite() {
        return "-".into();
    }
    let last = digits.saturating_sub(1);
    // rounded first: 9.9996 has its fourth digit before the point
    let scientific = format!("{value:.last$e}");
    let exponent: i32 = scientific.rsplit('e').next().and_then(|text| text.parse().ok()).unwrap_or(0);
    let magnitude = exponent.unsigned_abs() as usize;
    match exponent {
        -3..0 => format!("{value:.*}", last + magnitude),
        0.. if magnitude <= digits => format!("{value:.*}", last.saturating_sub(magnitude)),
        _ => scientific,
    }
}

/// Whole number with a comma between thousands: 2,997; two digits of what is below 10: 7.9.
pub fn grouped(value: f64) -> String {
    if value.abs() < 9.95 && value != value.round() {
        return significant(value, 2);
    }
    if !value.is_finite() || value.abs() >= 1e15 {
        return significant(value, 4);
    }
    let digits = format!("{:.0}", value.abs());
    let mut out = String::new();
    if value <= -0.5 {
        out.push('-');
    }
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

/// A value, or zero where beside the `largest` of its kind it is what rounding has left.
pub fn without_rounding(value: f64, largest: f64) -> f64 {
    const ROUNDING: f64 = 1e-9;
    if value.abs() < ROUNDING * largest { 0.0 } else { value }
}

#[cfg(test)]
mod tests {
    use super::{grouped, significant};

    #[test]
    fn significant_digits_survive_any_magnitude() {
        for (value, expected) in [
            (0.0, "0"),
            (12.694_228, "12.69"),
            (9.9996, "10.00"),
            (-0.001_234_56, "-0.001235"),
            (123_456.0, "1.235e5"),
            (1.5e-9, "1.500e-9"),
            (12_345.6, "12346"),
        ] {
            assert_eq!(significant(value, 4), expected);
        }
    }

    #[test]
    fn thousands_are_grouped() {
        for (value, expected) in [
            (0.0, "0"),
            (-0.2, "-0.20"),
            (7.943, "7.9"),
            (9.97, "10"),
            (999.4, "999"),
            (2996.6, "2,997"),
            (-1_234_567.0, "-1,234,567"),
            (1e20, "1.000e20"),
        ] {
            assert_eq!(grouped(value), expected);
        }
    }
}
