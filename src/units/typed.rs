//! Numbers as people type them, with or without a unit.

use super::Quantity;
use super::accepted::is_unit;
use crate::text::excerpt;

/// A number that was typed, in the unit of design files.
#[derive(Debug, Clone, PartialEq)]
pub struct Typed {
    /// As it goes into a file: exactly as typed where no conversion was needed, else the shortest decimal that is right
    /// to 15 digits.
    pub text: String,
    /// The same as a number, in the file's unit.
    pub value: f64,
}

/// Why what was typed is no number of the quantity. The texts are harmless to show.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum UnitError {
    #[error("a number is wanted{}, e.g. {example}", in_unit(.unit))]
    NoNumber { unit: &'static str, example: &'static str },
    #[error("write {suggestion}: the decimal separator is a point")]
    Comma { suggestion: String },
    #[error("{number} is too large for a number")]
    TooLarge { number: String },
    /// `accepted` are the units of the quantity, the file's own first; empty where the quantity has none.
    #[error("unknown unit `{unit}`{}", accepted_units(.accepted))]
    UnknownUnit { unit: String, accepted: Vec<&'static str> },
}

fn in_unit(unit: &str) -> String {
    if unit.is_empty() { String::new() } else { format!(" in {unit}") }
}

fn accepted_units(units: &[&str]) -> String {
    if units.is_empty() { "; this is a plain number".into() } else { format!("; accepted: {}", units.join(", ")) }
}

/// Reads a number as people type it, and gives it in the file's unit.
///
/// ```
/// use bevelscope::units::{Quantity, parse};
///
/// assert_eq!(parse("6e8", Quantity::Stiffness)?.text, "6e8");
/// assert_eq!(parse("600 N/um", Quantity::Stiffness)?.text, "6e8");
/// assert_eq!(parse("1.4 in", Quantity::Length)?.text, "35.56");
/// assert_eq!(parse("1,5", Quantity::Length).unwrap_err().to_string(), "write 1.5: the decimal separator is a point");
/// # Ok::<(), bevelscope::units::UnitError>(())
/// ```
///
/// # Errors
///
/// [`UnitError`] says what is wanted.
pub fn parse(text: &str, quantity: Quantity) -> Result<Typed, UnitError> {
    // the sign as word processors write it
    let text = text.trim().replace('\u{2212}', "-");
    let wanted = || UnitError::NoNumber { unit: quantity.unit(), example: quantity.example() };
    let text = if quantity == Quantity::Length { inches(&text) } else { text };
    let (number, rest) = split(&text).ok_or_else(wanted)?;
    if let Some(decimals) = rest.strip_prefix(',').filter(|rest| rest.starts_with(|c: char| c.is_ascii_digit())) {
        return Err(UnitError::Comma { suggestion: excerpt(&with_point(number, decimals), 40) });
    }
    if !separates_digits(number) {
        return Err(wanted());
    }
    let (spelled, value) = spell(number).ok_or_else(|| UnitError::TooLarge { number: excerpt(number, 40) })?;
    let unit = rest.trim();
    if unit.is_empty() || is_unit(unit, quantity.unit()) {
        return Ok(Typed { text: spelled, value });
    }
    let Some(unit) = quantity.accepted().iter().find(|accepted| is_unit(unit, accepted.name)) else {
        let accepted = quantity.units().collect();
        return Err(UnitError::UnknownUnit { unit: excerpt(unit, 40), accepted });
    };
    let text = shortest(value * unit.times / unit.over);
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(Typed { text, value }),
        _ => Err(UnitError::TooLarge { number: excerpt(number, 40) }),
    }
}

/// `1.4"` as `1.4 in`, `3/8 in` and `1 3/8 in` with a decimal number.
fn inches(text: &str) -> String {
    let text = text.strip_suffix('"').map_or_else(|| text.to_owned(), |number| format!("{number} in"));
    decimal(&text).unwrap_or(text)
}

/// The text with its fraction worked out; nothing where it has none.
fn decimal(text: &str) -> Option<String> {
    let end = |text: &str| text.bytes().take_while(u8::is_ascii_digit).count();
    let (sign, unsigned) = text.strip_prefix('-').map_or(("", text), |rest| ("-", rest));
    let (first, rest) = unsigned.split_at(end(unsigned));
    // a whole number before it
    let (whole, above, rest) = match rest.trim_start() {
        after if after.len() < rest.len() && end(after) > 0 => (first, &after[..end(after)], &after[end(after)..]),
        _ => ("0", first, rest),
    };
    let below = rest.strip_prefix('/')?;
    let (below, unit) = below.split_at(end(below));
    let [whole, above, below]: [f64; 3] = [whole.parse().ok()?, above.parse().ok()?, below.parse().ok()?];
    let value = whole + above / below;
    value.is_finite().then(|| format!("{sign}{}{unit}", shortest(value)))
}

/// What was meant by a number with a comma in it: of comma and point, the last one is the decimal separator.
fn with_point(whole: &str, decimals: &str) -> String {
    if decimals.contains('.') { format!("{whole}{decimals}") } else { format!("{}.{decimals}", whole.replace('.', "")) }
}

/// Whether each `_` stands between two digits, as in a design file.
fn separates_digits(number: &str) -> bool {
    let parts: Vec<&str> = number.split('_').collect();
    let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_alphanumeric());
    parts.windows(2).all(|pair| digit(pair[0].chars().next_back()) && digit(pair[1].chars().next()))
}

impl Quantity {
    /// What may be typed, in words: `6e8 or 600 N/um`.
    pub const fn example(self) -> &'static str {
        match self {
            Self::Length => "35, 0.035 m or 1.4 in",
            Self::Deflection => "5 or 0.005 mm",
            Self::Frequency => "1200 or 1.2 kHz",
            Self::Mass => "1.5 or 1500 g",
            Self::Inertia => "7e-4 or 700 kg mm^2",
            Self::Stiffness => "6e8 or 600 N/um",
            Self::AngularStiffness => "1.5e5 or 150 kN m/rad",
            Self::Force => "-5000 or -5 kN",
            Self::ForcePerRadian => "-7e6 or -7000 kN/rad",
            Self::ElasticModulus => "206 or 206000 MPa",
            Self::Density => "7850 or 7.85 g/cm^3",
            Self::Angle => "40 or 0.7 rad",
            Self::Tilt => "0.5 or 0.0005 rad",
            Self::Torque => "300 or 0.3 kN m",
            Self::Speed => "1200 or 20 Hz",
            Self::BallContact => "1.1e10 or 3.5e5 N/mm^1.5",
            Self::RollerContact => "9.6e8 or 4.5e5 N/mm^(10/9)",
            Self::Ratio | Self::Damping => "0.03 or 3 %",
        }
    }
}

/// The number at the start, and what follows it.
fn split(text: &str) -> Option<(&str, &str)> {
    let bytes = text.as_bytes();
    let run =
        |from: usize, wanted: fn(&u8) -> bool| from + bytes[from..].iter().take_while(|byte| wanted(byte)).count();
    let digits = |byte: &u8| byte.is_ascii_digit() || *byte == b'_';
    let is = |at: usize, wanted: &[u8]| bytes.get(at).is_some_and(|byte| wanted.contains(byte));
    let whole = usize::from(is(0, b"+-"));
    let in_radix: Option<fn(&u8) -> bool> = match bytes {
        [b'0', b'x', ..] => Some(|byte| byte.is_ascii_hexdigit() || *byte == b'_'),
        [b'0', b'o', ..] => Some(|byte| matches!(byte, b'0'..=b'7' | b'_')),
        [b'0', b'b', ..] => Some(|byte| matches!(byte, b'0' | b'1' | b'_')),
        _ => None,
    };
    if let Some(digits) = in_radix {
        let end = run(2, digits);
        return (end > 2).then(|| text.split_at(end));
    }
    let mut end = run(whole, digits);
    if is(end, b".") {
        end = run(end + 1, digits);
    }
    if !bytes[whole..end].iter().any(u8::is_ascii_digit) {
        return None;
    }
    let exponent = end + 1 + usize::from(is(end + 1, b"+-"));
    if is(end, b"eE") && bytes.get(exponent).is_some_and(u8::is_ascii_digit) {
        end = run(exponent, digits);
    }
    Some(text.split_at(end))
}

/// The number as it may stand in a file, as it was typed if that is TOML; nothing where it is too large.
fn spell(number: &str) -> Option<(String, f64)> {
    let written = number.parse::<toml_edit::Value>().ok();
    let written = written.and_then(|value| value.as_float().or(value.as_integer().map(|number| number as f64)));
    if let Some(value) = written.filter(|value| value.is_finite()) {
        return Some((number.into(), value));
    }
    // people leave out a zero before or after the point, or write zeros in front
    let value: f64 = number.replace('_', "").parse().ok()?;
    value.is_finite().then(|| (shortest(value), value))
}

/// The shortest decimal that is the number to 15 digits.
fn shortest(value: f64) -> String {
    let digits = format!("{value:.14e}");
    let (mantissa, exponent) = digits.split_once('e').unwrap_or((&digits, "0"));
    let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if value == 0.0 {
        return "0.0".into();
    }
    if !(-4..6).contains(&exponent) {
        return format!("{mantissa}e{exponent}");
    }
    let rounded: f64 = format!("{mantissa}e{exponent}").parse().unwrap_or(value);
    format!("{rounded:?}")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn text(typed: &str, quantity: Quantity) -> String {
        parse(typed, quantity).unwrap_or_else(|error| panic!("{typed}: {error}")).text
    }

    // Conversions by definition of the units (NIST SP 811): 1 in = 25.4 mm, 1 lb = 0.45359237 kg, 1 lbf = 4.4482216152605 N;
    // those of stiffness and pressure are its table B.8, to 7 digits 1.751268e2 N/m and 6.894757e3 Pa.
    #[test]
    fn what_people_type_comes_out_in_the_files_unit() {
        for (typed, quantity, expected) in [
            ("35", Quantity::Length, "35"),
            ("1.5e3", Quantity::Length, "1.5e3"),
            ("6e8", Quantity::Stiffness, "6e8"),
            ("1_000", Quantity::Length, "1_000"),
            ("  35 mm ", Quantity::Length, "35"),
            ("35mm", Quantity::Length, "35"),
            ("0x10", Quantity::Length, "0x10"),
            ("0x10mm", Quantity::Length, "0x10"),
            ("\u{2212}5", Quantity::Length, "-5"),
            (".5", Quantity::Length, "0.5"),
            ("5.", Quantity::Length, "5.0"),
            ("007", Quantity::Length, "7.0"),
            ("1E3", Quantity::Length, "1E3"),
            ("+3", Quantity::Length, "+3"),
            ("-0.0", Quantity::Length, "-0.0"),
            ("99999999999999999999", Quantity::Length, "1e20"),
            ("1.4 in", Quantity::Length, "35.56"),
            ("0.035 m", Quantity::Length, "35.0"),
            ("35000 µm", Quantity::Length, "35.0"),
            ("3.5 cm", Quantity::Length, "35.0"),
            ("1 ft", Quantity::Length, "304.8"),
            ("1.4\"", Quantity::Length, "35.56"),
            ("1.4 \"", Quantity::Length, "35.56"),
            ("3/8 in", Quantity::Length, "9.525"),
            ("3/8\"", Quantity::Length, "9.525"),
            ("1 3/8 in", Quantity::Length, "34.925"),
            ("-1 1/2\"", Quantity::Length, "-38.1"),
            ("1/2 mm", Quantity::Length, "0.5"),
            ("600 N/um", Quantity::Stiffness, "6e8"),
            ("600 N/μm", Quantity::Stiffness, "6e8"),
            ("600 kN/mm", Quantity::Stiffness, "6e8"),
            ("600 MN/m", Quantity::Stiffness, "6e8"),
            ("12.5 N/mm", Quantity::Stiffness, "12500.0"),
            ("1 lbf/in", Quantity::Stiffness, "175.126835246476"),
            ("150 kN m/rad", Quantity::AngularStiffness, "150000.0"),
            ("150kNm/rad", Quantity::AngularStiffness, "150000.0"),
            ("150 N·m/rad", Quantity::AngularStiffness, "150"),
            ("150 N.m / rad", Quantity::AngularStiffness, "150"),
            ("-7000 kN", Quantity::Force, "-7e6"),
            ("1 lbf", Quantity::Force, "4.4482216152605"),
            ("2 kN/rad", Quantity::ForcePerRadian, "2000.0"),
            ("1500 N mm/rad", Quantity::AngularStiffness, "1.5"),
            ("250 g", Quantity::Mass, "0.25"),
            ("2 lb", Quantity::Mass, "0.90718474"),
            ("7e-4 kg m2", Quantity::Inertia, "7e-4"),
            ("7e-4 kg m^2", Quantity::Inertia, "7e-4"),
            ("7e-4 kg m²", Quantity::Inertia, "7e-4"),
            ("7000 g cm2", Quantity::Inertia, "0.0007"),
            ("700 kg mm2", Quantity::Inertia, "0.0007"),
            ("206000 MPa", Quantity::ElasticModulus, "206.0"),
            ("2.06e11 Pa", Quantity::ElasticModulus, "206.0"),
            ("1e6 psi", Quantity::ElasticModulus, "6.89475729316836"),
            ("1000 ksi", Quantity::ElasticModulus, "6.89475729316836"),
            ("7.85 g/cm3", Quantity::Density, "7850.0"),
            ("7850 kg/m³", Quantity::Density, "7850"),
            ("1.2 kHz", Quantity::Frequency, "1200.0"),
            ("1200 rpm", Quantity::Frequency, "20.0"),
            ("6.283185307179586 rad/s", Quantity::Frequency, "1.0"),
            ("3 %", Quantity::Damping, "0.03"),
            ("30%", Quantity::Ratio, "0.3"),
            ("0.2 thou", Quantity::Deflection, "5.08"),
            ("0.005 mm", Quantity::Deflection, "5.0"),
            ("1e-5 m", Quantity::Length, "0.01"),
            ("1e-9 m", Quantity::Length, "1e-6"),
            ("0 in", Quantity::Length, "0.0"),
        ] {
            assert_eq!(text(typed, quantity), expected, "{typed}");
        }
    }

    #[test]
    fn what_is_no_number_says_what_is_wanted() {
        for (typed, quantity, expected) in [
            ("", Quantity::Length, "a number is wanted in mm, e.g. 35, 0.035 m or 1.4 in"),
            ("abc", Quantity::Ratio, "a number is wanted, e.g. 0.03 or 3 %"),
            ("nan", Quantity::Length, "a number is wanted in mm, e.g. 35, 0.035 m or 1.4 in"),
            ("inf", Quantity::Length, "a number is wanted in mm, e.g. 35, 0.035 m or 1.4 in"),
            ("1,5", Quantity::Length, "write 1.5: the decimal separator is a point"),
            ("1,5 mm", Quantity::Length, "write 1.5 mm: the decimal separator is a point"),
            ("1.234,5", Quantity::Length, "write 1234.5: the decimal separator is a point"),
            ("1,234.5", Quantity::Length, "write 1234.5: the decimal separator is a point"),
            ("3/0 in", Quantity::Length, "unknown unit `/0 in`; accepted: mm, m, cm, um, in, ft"),
            ("/8 in", Quantity::Length, "a number is wanted in mm, e.g. 35, 0.035 m or 1.4 in"),
            ("1__0", Quantity::Length, "a number is wanted in mm, e.g. 35, 0.035 m or 1.4 in"),
            ("_1", Quantity::Length, "a number is wanted in mm, e.g. 35, 0.035 m or 1.4 in"),
            ("1_", Quantity::Length, "a number is wanted in mm, e.g. 35, 0.035 m or 1.4 in"),
            ("0x", Quantity::Length, "a number is wanted in mm, e.g. 35, 0.035 m or 1.4 in"),
            ("0b2", Quantity::Length, "a number is wanted in mm, e.g. 35, 0.035 m or 1.4 in"),
            ("0x1G", Quantity::Length, "unknown unit `G`; accepted: mm, m, cm, um, in, ft"),
            ("1.5.", Quantity::Length, "unknown unit `.`; accepted: mm, m, cm, um, in, ft"),
            ("5 ^", Quantity::Length, "unknown unit `^`; accepted: mm, m, cm, um, in, ft"),
            ("5 m m", Quantity::Length, "unknown unit `m m`; accepted: mm, m, cm, um, in, ft"),
            ("5 m.m", Quantity::Length, "unknown unit `m.m`; accepted: mm, m, cm, um, in, ft"),
            ("1e999", Quantity::Length, "1e999 is too large for a number"),
            ("1e308 m", Quantity::Length, "1e308 is too large for a number"),
            ("5 N/m", Quantity::Length, "unknown unit `N/m`; accepted: mm, m, cm, um, in, ft"),
            (
                "5 mn/m",
                Quantity::Stiffness,
                "unknown unit `mn/m`; accepted: N/m, N/mm, N/um, kN/m, kN/mm, MN/m, GN/m, lbf/in",
            ),
            ("5 mm", Quantity::Ratio, "unknown unit `mm`; accepted: %"),
            ("5 \u{1b}[2J", Quantity::Ratio, "unknown unit `\\u{1b}[2J`; accepted: %"),
        ] {
            assert_eq!(parse(typed, quantity).unwrap_err().to_string(), expected, "{typed}");
        }
    }

    #[test]
    fn the_files_own_unit_comes_first_and_changes_nothing() {
        for quantity in Quantity::ALL {
            let first = quantity.accepted()[0];
            assert!(
                quantity.unit().is_empty()
                    || (first.name == quantity.unit() && first.times == 1.0 && first.over == 1.0)
            );
        }
    }

    fn quantities() -> impl Strategy<Value = Quantity> {
        proptest::sample::select(Quantity::ALL.to_vec())
    }

    proptest! {
        #[test]
        fn a_number_as_rust_prints_it_comes_back(value in proptest::num::f64::NORMAL, quantity in quantities()) {
            for printed in [format!("{value:?}"), format!("{value:e}")] {
                let typed = parse(&printed, quantity).unwrap();
                prop_assert_eq!(&typed.text, &printed);
                prop_assert_eq!(typed.value.to_bits(), value.to_bits());
            }
        }

        #[test]
        fn any_unit_is_right_to_15_digits(value in -1e12..1e12_f64, quantity in quantities(), pick in any::<usize>()) {
            let units = quantity.accepted();
            let unit = units[pick % units.len()];
            let typed = parse(&format!("{value:?} {}", unit.name), quantity).unwrap();
            let expected = value * unit.times / unit.over;
            prop_assert!((typed.value - expected).abs() <= 5e-15 * expected.abs(), "{typed:?}");
            prop_assert_eq!(typed.text.parse::<f64>().unwrap().to_bits(), typed.value.to_bits());
            prop_assert!(typed.text.parse::<toml_edit::Value>().is_ok());
            // what a file has, typed again, stays
            prop_assert_eq!(parse(&typed.text, quantity).unwrap(), typed);
        }

        #[test]
        fn nothing_typed_breaks_it(typed in "[0-9+\\-_.,eEx a-zµ²/\u{1b}]{0,12}", quantity in quantities()) {
            if let Ok(typed) = parse(&typed, quantity) {
                prop_assert!(typed.text.parse::<toml_edit::Value>().is_ok(), "{typed:?}");
            }
        }
    }
}
