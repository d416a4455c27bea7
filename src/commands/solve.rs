//! `bevelscope solve`: the spectra.

use std::io::{self, Write};

use clap::ValueEnum;

use super::{CommandError, FileArg, ModelArg, Status, input};
use crate::comparison::{self, SolveError, Spectrum};
use crate::design::Design;
use crate::model::{ModelKind, Rotors};
use crate::number::significant;
use crate::report::json::{self, ComplexList, Object};
use crate::report::{Table, csv};
use crate::response::frequency_lines;
use crate::text::printable;

#[derive(Debug, clap::Args)]
pub struct Args {
    #[command(flatten)]
    file: FileArg,
    #[command(flatten)]
    models: ModelArg,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// Aligned, for reading
    Table,
    /// RFC 4180, full precision
    Csv,
    /// One JSON value, full precision
    Json,
}

pub fn run(args: &Args, out: &mut impl Write, err: &mut impl Write) -> Result<Status, CommandError> {
    let loaded = input::load(&args.file.file, err)?;
    let design = &loaded.design;
    let frequency_hz = frequency_lines(&design.analysis);
    let models = solve(design, &args.models.kinds(), &frequency_hz)
        .map_err(|error| CommandError::Solve { name: loaded.name.clone(), error })?;
    match args.format {
        Format::Csv => csv::spectra(out, &frequency_hz, &models)?,
        Format::Json => json::write(out, &Output::new(design, &frequency_hz, &models))?,
        Format::Table => write_table(out, design, &frequency_hz, &models)?,
    }
    Ok(Status::Success)
}

fn solve(design: &Design, kinds: &[ModelKind], frequency_hz: &[f64]) -> Result<Vec<(ModelKind, Spectrum)>, SolveError> {
    let rotors = Rotors::new(design)?;
    kinds.iter().map(|&kind| Ok((kind, comparison::solve(kind, design, &rotors, frequency_hz)?))).collect()
}

#[derive(serde::Serialize)]
struct Output<'a> {
    design: &'a str,
    frequency_hz: &'a [f64],
    models: Object<ModelOutput>,
}

#[derive(serde::Serialize)]
struct ModelOutput {
    mesh_force_n: ComplexList,
    transmission_error_m: ComplexList,
    coordinates: usize,
}

impl<'a> Output<'a> {
    fn new(design: &'a Design, frequency_hz: &'a [f64], models: &[(ModelKind, Spectrum)]) -> Self {
        let model = |(kind, spectrum): &(ModelKind, Spectrum)| {
            let output = ModelOutput {
                mesh_force_n: spectrum.mesh_force.as_slice().into(),
                transmission_error_m: spectrum.transmission_error.as_slice().into(),
                coordinates: spectrum.coordinates,
            };
            (kind.name(), output)
        };
        Self { design: &design.name, frequency_hz, models: Object(models.iter().map(model).collect()) }
    }
}

/// Amplitude and phase of the mesh force and amplitude of the transmission error, three columns a model; three models fit 80 columns.
fn write_table(
    out: &mut impl Write,
    design: &Design,
    frequency_hz: &[f64],
    models: &[(ModelKind, Spectrum)],
) -> io::Result<()> {
    writeln!(out, "{}", printable(&design.name))?;
    let coordinates = models.iter().map(|(kind, spectrum)| format!("{} {}", kind.name(), spectrum.coordinates));
    writeln!(out, "coordinates: {}", coordinates.collect::<Vec<_>>().join(", "))?;
    writeln!(out, "F: dynamic mesh force; dte: dynamic transmission error\n")?;
    let mut heads = vec!["Hz".to_owned()];
    for (kind, _) in models {
        heads.extend([format!("{}\nF, N", kind.name()), "deg".into(), "dte,um".into()]);
    }
    let mut table = Table::with_heads(heads).tight();
    for (i, frequency) in frequency_hz.iter().enumerate() {
        let mut cells = vec![significant(*frequency, 6)];
        for (_, spectrum) in models {
            let (force, error) = (spectrum.mesh_force[i], spectrum.transmission_error[i]);
            cells.extend([
                significant(force.norm(), 4),
                // + 0.0: no minus before a zero
                format!("{:.0}", force.arg().to_degrees().round() + 0.0),
                significant(error.norm() * 1e6, 4),
            ]);
        }
        table.row(cells);
    }
    write!(out, "{table}")
}
