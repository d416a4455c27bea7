//! Spectra as CSV (RFC 4180): a header line, one row a frequency line, full double precision.

use std::borrow::Cow;
use std::io::{self, Write};

use crate::comparison::{BearingSpectrum, Spectrum};
use crate::model::ModelKind;
use crate::text::printable;

/// Components of a bearing's force in the order of [`BearingSpectrum::force`], with their units.
pub const FORCE_COMPONENTS: [&str; 6] = ["fx_n", "fy_n", "fz_n", "mx_n_m", "my_n_m", "mz_n_m"];

/// One model's columns.
#[derive(Debug)]
pub struct Columns<'a> {
    pub kind: ModelKind,
    pub spectrum: &'a Spectrum,
    /// Empty where they are not asked for
    pub bearings: &'a [BearingSpectrum],
}

/// Writes `frequency_hz` and, for each model, mesh force (N) and transmission error (m) as real and imaginary parts; then the forces of
/// its bearings as `MODEL_bearing_ROTOR_NAME_fx_n_re` and so on. Control characters in names are written out as in `\u{1b}`.
///
/// # Errors
///
/// Those of the writer.
pub fn spectra(out: &mut impl Write, frequency_hz: &[f64], models: &[Columns<'_>]) -> io::Result<()> {
    write!(out, "frequency_hz")?;
    for Columns { kind, .. } in models {
        for quantity in ["mesh_force_n", "transmission_error_m"] {
            write!(out, ",{0}_{quantity}_re,{0}_{quantity}_im", kind.name())?;
        }
    }
    for Columns { kind, bearings, .. } in models {
        for bearing in *bearings {
            let name = printable(&bearing.name);
            for component in FORCE_COMPONENTS {
                for part in ["re", "im"] {
                    let column = format!("{}_bearing_{}_{name}_{component}_{part}", kind.name(), bearing.side.name());
                    write!(out, ",{}", field(&column))?;
                }
            }
        }
    }
    write!(out, "\r\n")?;
    for (i, frequency) in frequency_hz.iter().enumerate() {
        // the shortest form that reads back as the same double
        write!(out, "{frequency:?}")?;
        for Columns { spectrum, .. } in models {
            for value in [spectrum.mesh_force[i], spectrum.transmission_error[i]] {
                write!(out, ",{:?},{:?}", value.re, value.im)?;
            }
        }
        for value in models.iter().flat_map(|model| model.bearings).flat_map(|bearing| bearing.force[i]) {
            write!(out, ",{:?},{:?}", value.re, value.im)?;
        }
        write!(out, "\r\n")?;
    }
    Ok(())
}

/// Text as a field of RFC 4180: in quotes where a comma, a quote or a line end would break it.
pub fn field(text: &str) -> Cow<'_, str> {
    if text.contains([',', '"', '\r', '\n']) {
        Cow::Owned(format!("\"{}\"", text.replace('"', "\"\"")))
    } else {
        Cow::Borrowed(text)
    }
}

#[cfg(test)]
mod tests {
    use super::field;

    /// RFC 4180, sections 2.5 to 2.7.
    #[test]
    fn fields_are_quoted_where_they_must_be() {
        for (text, written) in [
            ("B1", "B1"),
            ("left, \"A\"", "\"left, \"\"A\"\"\""),
            ("a\r\nb", "\"a\r\nb\""),
            ("with space", "with space"),
        ] {
            assert_eq!(field(text), written);
        }
    }
}
