//! `bevelscope solve`: the spectra.

use std::io::{self, Write};

use clap::ValueEnum;

use super::{CommandError, FileArg, ModelArg, Status, input};
use crate::comparison::{self, BearingSpectrum, RecoveryKind, SolveError, Spectrum, WithBearings};
use crate::design::Design;
use crate::model::{ModelKind, Rotors};
use crate::number::significant;
use crate::report::json::{self, ComplexList, Object};
use crate::report::{Table, csv};
use crate::response::frequency_lines;
use crate::text::{cut, printable};

#[derive(Debug, clap::Args)]
pub struct Args {
    #[command(flatten)]
    file: FileArg,
    #[command(flatten)]
    models: ModelArg,
    /// Forces of all bearings on their shafts, too
    #[arg(long)]
    bearing_forces: bool,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

/// One model solved.
struct Solved {
    kind: ModelKind,
    spectrum: Spectrum,
    /// Forces of the bearings and how they were found, where asked for
    bearings: Option<(Vec<BearingSpectrum>, RecoveryKind)>,
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
    let rotors = input::rotors(&loaded, err)?;
    let models = solve(design, &rotors, &args.models.kinds(), &frequency_hz, args.bearing_forces)
        .map_err(|error| input::failed(&loaded, error))?;
    match args.format {
        Format::Csv => csv::spectra(out, &frequency_hz, &models.iter().map(Solved::columns).collect::<Vec<_>>())?,
        Format::Json => json::write(out, &Output::new(design, &frequency_hz, &models))?,
        Format::Table => {
            write_table(out, design, &frequency_hz, &models)?;
            write_bearing_tables(out, &frequency_hz, &models)?;
        }
    }
    Ok(Status::Success)
}

fn solve(
    design: &Design,
    rotors: &Rotors,
    kinds: &[ModelKind],
    frequency_hz: &[f64],
    bearing_forces: bool,
) -> Result<Vec<Solved>, SolveError> {
    let solved = |&kind: &ModelKind| {
        if !bearing_forces {
            let spectrum = comparison::solve(kind, design, rotors, frequency_hz)?;
            return Ok(Solved { kind, spectrum, bearings: None });
        }
        let WithBearings { spectrum, bearings, recovery } =
            comparison::solve_with_bearings(kind, design, rotors, frequency_hz)?;
        Ok(Solved { kind, spectrum, bearings: Some((bearings, recovery)) })
    };
    kinds.iter().map(solved).collect()
}

impl Solved {
    fn columns(&self) -> csv::Columns<'_> {
        let bearings = self.bearings.as_ref().map_or(&[][..], |(bearings, _)| bearings);
        csv::Columns { kind: self.kind, spectrum: &self.spectrum, bearings }
    }
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
    #[serde(skip_serializing_if = "Option::is_none")]
    bearing_forces: Option<BearingForces>,
}

#[derive(serde::Serialize)]
struct BearingForces {
    /// How the displacements at the bearings follow from the model
    displacements: &'static str,
    bearings: Vec<BearingOutput>,
}

#[derive(serde::Serialize)]
struct BearingOutput {
    rotor: &'static str,
    bearing: String,
    /// Force on the shaft
    #[serde(flatten)]
    components: Object<ComplexList>,
    /// sqrt(|fx|^2 + |fz|^2)
    radial_n: Vec<f64>,
    /// sqrt(|fx|^2 + |fy|^2 + |fz|^2)
    total_n: Vec<f64>,
}

impl BearingForces {
    fn new((bearings, recovery): &(Vec<BearingSpectrum>, RecoveryKind)) -> Self {
        let output = |bearing: &BearingSpectrum| {
            let component = |(i, name): (usize, &'static str)| {
                let values: Vec<_> = bearing.force.iter().map(|force| force[i]).collect();
                (name.into(), ComplexList::from(values.as_slice()))
            };
            BearingOutput {
                rotor: bearing.side.name(),
                bearing: bearing.name.clone(),
                components: Object(csv::FORCE_COMPONENTS.into_iter().enumerate().map(component).collect()),
                radial_n: bearing.radial().collect(),
                total_n: bearing.total().collect(),
            }
        };
        Self { displacements: recovery.name(), bearings: bearings.iter().map(output).collect() }
    }
}

impl<'a> Output<'a> {
    fn new(design: &'a Design, frequency_hz: &'a [f64], models: &[Solved]) -> Self {
        let model = |Solved { kind, spectrum, bearings }: &Solved| {
            let output = ModelOutput {
                mesh_force_n: spectrum.mesh_force.as_slice().into(),
                transmission_error_m: spectrum.transmission_error.as_slice().into(),
                coordinates: spectrum.coordinates,
                bearing_forces: bearings.as_ref().map(BearingForces::new),
            };
            (kind.name(), output)
        };
        Self { design: &design.name, frequency_hz, models: Object(models.iter().map(model).collect()) }
    }
}

/// Amplitude and phase of the mesh force and amplitude of the transmission error, three columns a model; three models fit 80 columns.
fn write_table(out: &mut impl Write, design: &Design, frequency_hz: &[f64], models: &[Solved]) -> io::Result<()> {
    writeln!(out, "{}", printable(&design.name))?;
    let coordinates =
        models.iter().map(|Solved { kind, spectrum, .. }| format!("{} {}", kind.name(), spectrum.coordinates));
    writeln!(out, "coordinates: {}", coordinates.collect::<Vec<_>>().join(", "))?;
    writeln!(out, "F: dynamic mesh force; dte: dynamic transmission error\n")?;
    let mut heads = vec!["Hz".to_owned()];
    for Solved { kind, .. } in models {
        heads.extend([format!("{}\nF, N", kind.name()), "deg".into(), "dte,um".into()]);
    }
    let mut table = Table::with_heads(heads).tight();
    for (i, frequency) in frequency_hz.iter().enumerate() {
        let mut cells = vec![significant(*frequency, 6)];
        for Solved { spectrum, .. } in models {
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

/// Amplitude of every bearing's force across its shaft and along it, a table a model and as many bearings beside one another as fit.
fn write_bearing_tables(out: &mut impl Write, frequency_hz: &[f64], models: &[Solved]) -> io::Result<()> {
    const BESIDE: usize = 3;
    const WIDEST_NAME: usize = 8;
    for Solved { kind, bearings, .. } in models {
        let Some((bearings, recovery)) = bearings else { continue };
        for beside in bearings.chunks(BESIDE) {
            writeln!(out, "\n{}: forces of bearings, {}\n", kind.title(), recovery.name())?;
            let mut heads = vec!["Hz".to_owned()];
            for bearing in beside {
                let name = cut(&printable(&bearing.name), WIDEST_NAME, "..");
                heads.extend([format!("{}\n{name}\nradial N", bearing.side.name()), "axial N".into()]);
            }
            let mut table = Table::with_heads(heads);
            for (i, frequency) in frequency_hz.iter().enumerate() {
                let mut cells = vec![significant(*frequency, 6)];
                for bearing in beside {
                    let [fx, fy, fz, ..] = bearing.force[i];
                    cells.extend([fx.norm().hypot(fz.norm()), fy.norm()].map(|force| significant(force, 4)));
                }
                table.row(cells);
            }
            write!(out, "{table}")?;
        }
    }
    Ok(())
}
