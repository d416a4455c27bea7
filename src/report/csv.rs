//! Spectra as CSV (RFC 4180): a header line, one row a frequency line, full double precision.

use std::io::{self, Write};

use crate::comparison::Spectrum;
use crate::model::ModelKind;

/// Writes `frequency_hz` and, for each model, mesh force (N) and transmission error (m) as real and imaginary parts.
///
/// # Errors
///
/// Those of the writer.
pub fn spectra(out: &mut impl Write, frequency_hz: &[f64], models: &[(ModelKind, Spectrum)]) -> io::Result<()> {
    write!(out, "frequency_hz")?;
    for (kind, _) in models {
        for quantity in ["mesh_force_n", "transmission_error_m"] {
            write!(out, ",{0}_{quantity}_re,{0}_{quantity}_im", kind.name())?;
        }
    }
    write!(out, "\r\n")?;
    for (i, frequency) in frequency_hz.iter().enumerate() {
        // the shortest form that reads back as the same double
        write!(out, "{frequency:?}")?;
        for (_, spectrum) in models {
            for value in [spectrum.mesh_force[i], spectrum.transmission_error[i]] {
                write!(out, ",{:?},{:?}", value.re, value.im)?;
            }
        }
        write!(out, "\r\n")?;
    }
    Ok(())
}
