//! `bevelscope inspect`: what was built of a design.

mod mean_state;
mod mesh;

use std::io::{self, Write};

use mean_state::MeanStateOutput;
use nalgebra::Matrix6;

use super::{CommandError, FileArg, Format, Status, input};
use crate::comparison::SolveError;
use crate::design::{Design, RotorDesign, Side};
use crate::model::{Model, ModelKind, Rotors};
use crate::number::significant;
use crate::report::{Table, json};
use crate::rotor::{Bending, Rolling, Rotor};
use crate::text::printable;

#[derive(Debug, clap::Args)]
pub struct Args {
    #[command(flatten)]
    file: FileArg,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(args: &Args, out: &mut impl Write, err: &mut impl Write) -> Result<Status, CommandError> {
    let loaded = input::load(&args.file.file, err)?;
    let failed = |error| CommandError::Solve { name: loaded.name.clone(), error };
    let rotors = Rotors::new(&loaded.design).map_err(|error| failed(error.into()))?;
    let output = Output::new(&loaded.design, &rotors).map_err(failed)?;
    match args.format {
        Format::Json => json::write(out, &output)?,
        Format::Table => write_tables(out, &output)?,
    }
    Ok(Status::Success)
}

#[derive(serde::Serialize)]
struct Output<'a> {
    design: &'a str,
    coordinates: Coordinates,
    mesh: mesh::MeshOutput,
    pinion: RotorOutput<'a>,
    gear: RotorOutput<'a>,
}

#[derive(serde::Serialize)]
struct Coordinates {
    fe: usize,
    lumped: usize,
}

#[derive(serde::Serialize)]
struct RotorOutput<'a> {
    stations_mm: Vec<f64>,
    mass_kg: f64,
    polar_inertia_kg_m2: f64,
    diametral_inertia_kg_m2: f64,
    centroid_mm: f64,
    shaft_bearing_stiffness: [[f64; 6]; 6],
    bending: Planes,
    bearings: Vec<BearingOutput<'a>>,
}

#[derive(serde::Serialize)]
struct Planes {
    x: BendingOutput,
    z: BendingOutput,
}

#[derive(serde::Serialize)]
struct BendingOutput {
    frequency_hz: f64,
    mass_kg: f64,
    inertia_kg_m2: f64,
    energy_residual: f64,
    fallback: Vec<&'static str>,
}

#[derive(serde::Serialize)]
struct BearingOutput<'a> {
    name: &'a str,
    /// Translations that are held; the stiffness says nothing of them
    hold: Vec<&'static str>,
    stiffness: [[f64; 6]; 6],
    /// Which series springs are in it
    #[serde(skip)]
    springs: &'static str,
    /// Of ball and roller bearings only
    #[serde(skip_serializing_if = "Option::is_none")]
    mean_state: Option<MeanStateOutput>,
}

impl<'a> Output<'a> {
    fn new(design: &'a Design, rotors: &'a Rotors) -> Result<Self, SolveError> {
        let coordinates = |kind| Model::new(kind, design, rotors).map(|model| model.coordinates());
        Ok(Self {
            design: &design.name,
            coordinates: Coordinates { fe: coordinates(ModelKind::Fe)?, lumped: coordinates(ModelKind::Basic)? },
            mesh: mesh::MeshOutput::new(design),
            pinion: RotorOutput::new(&design.pinion, rotors.get(Side::Pinion)),
            gear: RotorOutput::new(&design.gear, rotors.get(Side::Gear)),
        })
    }
}

impl<'a> RotorOutput<'a> {
    fn new(design: &RotorDesign, rotor: &'a Rotor) -> Self {
        let bearing =
            |(place, (support, rolling)): (usize, (&'a crate::rotor::Support, &Option<Rolling>))| BearingOutput {
                springs: design.springs_of(place),
                mean_state: rolling.as_ref().map(MeanStateOutput::new),
                name: &support.name,
                hold: ["x", "y", "z"]
                    .into_iter()
                    .zip(support.held)
                    .filter(|(_, held)| *held)
                    .map(|(motion, _)| motion)
                    .collect(),
                stiffness: rows(&support.stiffness),
            };
        Self {
            stations_mm: rotor.stations.positions.iter().map(|position| position * 1e3).collect(),
            mass_kg: rotor.totals.mass,
            polar_inertia_kg_m2: rotor.totals.polar_inertia,
            diametral_inertia_kg_m2: rotor.totals.diametral_inertia,
            centroid_mm: rotor.totals.centroid * 1e3,
            shaft_bearing_stiffness: rows(&rotor.statics.shaft_bearing_stiffness),
            bending: Planes { x: (&rotor.bending_x).into(), z: (&rotor.bending_z).into() },
            bearings: rotor
                .supports
                .bearings
                .iter()
                .zip(rotor.mean_states.bearings.iter())
                .enumerate()
                .map(bearing)
                .collect(),
        }
    }
}

impl From<&Bending> for BendingOutput {
    fn from(bending: &Bending) -> Self {
        let fallback = [("mass", bending.mass_fallback), ("inertia", bending.inertia_fallback)];
        Self {
            frequency_hz: bending.frequency,
            mass_kg: bending.mass,
            inertia_kg_m2: bending.inertia,
            energy_residual: bending.energy_residual,
            fallback: fallback.into_iter().filter(|(_, used)| *used).map(|(name, _)| name).collect(),
        }
    }
}

fn rows(matrix: &Matrix6<f64>) -> [[f64; 6]; 6] {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[(i, j)]))
}

fn write_tables(out: &mut impl Write, output: &Output<'_>) -> io::Result<()> {
    writeln!(out, "{}", printable(output.design))?;
    writeln!(out, "coordinates: FE {}, lumped {}", output.coordinates.fe, output.coordinates.lumped)?;
    output.mesh.write(out)?;
    for (name, rotor) in [("PINION", &output.pinion), ("GEAR", &output.gear)] {
        writeln!(out, "\n{name}")?;
        write_rotor(out, rotor)?;
    }
    Ok(())
}

fn write_rotor(out: &mut impl Write, rotor: &RotorOutput<'_>) -> io::Result<()> {
    let stations: Vec<String> = rotor.stations_mm.iter().map(|position| significant(*position, 5)).collect();
    writeln!(out, "{} stations at mm:", stations.len())?;
    for line in wrapped(&stations, 76) {
        writeln!(out, "  {line}")?;
    }
    let mut totals = Table::new(["totals", "", ""]);
    for (name, value, unit) in [
        ("mass", rotor.mass_kg, "kg"),
        ("centroid from y = 0", rotor.centroid_mm, "mm"),
        ("polar inertia", rotor.polar_inertia_kg_m2, "kg m2"),
        ("diametral inertia about the centroid", rotor.diametral_inertia_kg_m2, "kg m2"),
    ] {
        totals.row([format!("  {name}"), significant(value, 6), unit.into()]);
    }
    write!(out, "{totals}")?;
    writeln!(out, "first bending mode, and what it makes of the rotor at the mesh (enhanced model)")?;
    let mut bending = Table::new([
        "  plane",
        "mode\nHz",
        "effective\nmass, kg",
        "effective\ninertia, kg m2",
        "kinetic energy\nmissed, %",
        "taken from\nstatics",
    ]);
    for (plane, mode) in [("  x-y", &rotor.bending.x), ("  y-z", &rotor.bending.z)] {
        let fallback = if mode.fallback.is_empty() { "-".into() } else { mode.fallback.join(", ") };
        bending.row([
            plane.into(),
            significant(mode.frequency_hz, 6),
            significant(mode.mass_kg, 5),
            significant(mode.inertia_kg_m2, 5),
            significant(mode.energy_residual * 100.0, 3),
            fallback,
        ]);
    }
    write!(out, "{bending}")?;
    writeln!(out, "stiffness at the mesh station K_ll (N/m, N/rad; N m/rad)")?;
    write!(out, "{}", matrix(&rotor.shaft_bearing_stiffness))?;
    for bearing in &rotor.bearings {
        let name = printable(bearing.name);
        if bearing.hold.is_empty() {
            if let Some(state) = &bearing.mean_state {
                state.write(out, &name)?;
            }
            writeln!(out, "bearing \"{name}\"{} (N/m, N/rad; N m/rad)", bearing.springs)?;
            write!(out, "{}", matrix(&bearing.stiffness))?;
        } else {
            writeln!(out, "bearing \"{name}\": rigid, holds {}", bearing.hold.join(", "))?;
        }
    }
    Ok(())
}

fn matrix(rows: &[[f64; 6]; 6]) -> Table {
    const MOTIONS: [&str; 6] = ["x", "y", "z", "thx", "thy", "thz"];
    let mut table = Table::new(["     ", "x", "y", "z", "thx", "thy", "thz"]);
    // what is rounding beside the diagonal is shown as the zero it stands for
    let negligible = |i: usize, j: usize| rows[i][j].abs() <= 1e-13 * (rows[i][i] * rows[j][j]).abs().sqrt();
    for (i, row) in rows.iter().enumerate() {
        let cell = |j: usize| if negligible(i, j) { "0".to_owned() } else { format!("{:.4e}", row[j]) };
        table.row(std::iter::once(format!("  {}", MOTIONS[i])).chain((0..6).map(cell)));
    }
    table
}

/// Words in lines of at most `columns`.
fn wrapped(words: &[String], columns: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in words {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= columns => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.clone()),
        }
    }
    lines
}
