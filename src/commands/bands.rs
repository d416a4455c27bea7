//! `bevelscope bands`: where a model disagrees with finite elements, and why.

use std::io::{self, Write};
use std::ops::ControlFlow;

use clap::ValueEnum;

use super::{CommandError, FileArg, Status, input};
use crate::agreement::{
    Causes, ModalComparison, PlaneFigures, TOLERANCE_DB, Unpaired, band_level_db, disagreement_bands,
    sixth_octave_bands,
};
use crate::comparison::{self, SolveError};
use crate::design::Design;
use crate::model::{ModelKind, Rotors};
use crate::number::grouped;
use crate::report::csv::field;
use crate::report::{Table, json};
use crate::response::{Dominant, frequency_lines};
use crate::text::{cut, printable, wrap};

#[derive(Debug, clap::Args)]
pub struct Args {
    #[command(flatten)]
    file: FileArg,
    /// Difference in dB beyond which lines disagree
    #[arg(long, value_name = "DB", default_value_t = TOLERANCE_DB, value_parser = super::check::parse_limit, allow_negative_numbers = true)]
    tolerance: f64,
    /// The model held against finite elements: enhanced, basic or reduced:K
    #[arg(long, default_value = "enhanced", value_parser = parse_model)]
    model: ModelKind,
    /// Form of the output; JSON counts modes from 0, as places in the lists of `bevelscope modes`
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

fn parse_model(text: &str) -> Result<ModelKind, String> {
    match text.parse() {
        Ok(ModelKind::Fe) => Err("finite elements agree with themselves: wanted enhanced, basic or reduced:K".into()),
        Ok(kind) => Ok(kind),
        Err(error) => Err(crate::model::UnknownModel::to_string(&error)),
    }
}

pub fn run(args: &Args, out: &mut impl Write, err: &mut impl Write) -> Result<Status, CommandError> {
    let loaded = input::load(&args.file.file, err)?;
    let rotors = input::rotors(&loaded, err)?;
    let output = Output::new(&loaded.design, &rotors, args).map_err(|error| input::failed(&loaded, error))?;
    match args.format {
        Format::Json => json::write(out, &output)?,
        Format::Csv => write_csv(out, &output.bands)?,
        Format::Table => write_table(out, &output)?,
    }
    Ok(Status::Success)
}

#[derive(serde::Serialize)]
struct Output<'a> {
    design: &'a str,
    model: String,
    tolerance_db: f64,
    bands: Vec<BandOutput>,
    levels: Vec<LevelOutput>,
}

/// One range of lines beyond the tolerance.
#[derive(serde::Serialize)]
struct BandOutput {
    from_hz: f64,
    to_hz: f64,
    worst_db: f64,
    worst_at_hz: f64,
    /// The mode with the greatest part in the difference there
    mode: Option<ModeOutput>,
    /// Its pair's distance, where it has one
    shift: Option<ShiftOutput>,
    unpaired: Vec<UnpairedOutput>,
    planes: Vec<PlaneOutput>,
    why: Vec<String>,
}

#[derive(serde::Serialize)]
struct ModeOutput {
    name: String,
    frequency_hz: f64,
    fe_mode: Option<usize>,
    lumped_mode: Option<usize>,
    /// Of the sizes of all contributions to the difference
    share: f64,
    motion: MotionOutput,
}

/// The motion with most of a mode's kinetic energy.
#[derive(serde::Serialize)]
struct MotionOutput {
    rotor: &'static str,
    motion: &'static str,
    share: f64,
}

#[derive(serde::Serialize)]
struct ShiftOutput {
    fe_hz: f64,
    lumped_hz: f64,
    shift_percent: f64,
    mac: f64,
    /// (phi . h)^2, lumped over FE
    participation_ratio: f64,
}

#[derive(serde::Serialize)]
struct UnpairedOutput {
    fe_mode: usize,
    frequency_hz: f64,
    name: String,
    motion: MotionOutput,
    /// (phi . h)^2 over the largest of all modes
    participation: f64,
}

#[derive(serde::Serialize)]
struct PlaneOutput {
    rotor: &'static str,
    plane: &'static str,
    mode_share: f64,
    energy_residual: f64,
    fallback: Vec<&'static str>,
    mass_kg: f64,
    static_mass_kg: f64,
    total_mass_kg: f64,
    inertia_kg_m2: f64,
    static_inertia_kg_m2: f64,
    total_inertia_kg_m2: f64,
}

/// Levels of one sixth-octave band, dB re 1 N.
#[derive(serde::Serialize)]
struct LevelOutput {
    from_hz: f64,
    to_hz: f64,
    fe_db: f64,
    model_db: f64,
}

impl From<Dominant> for MotionOutput {
    fn from(Dominant { side, group, share }: Dominant) -> Self {
        Self { rotor: side.name(), motion: group.name(), share }
    }
}

impl From<&Unpaired> for UnpairedOutput {
    fn from(mode: &Unpaired) -> Self {
        Self {
            fe_mode: mode.fe,
            frequency_hz: mode.frequency_hz,
            name: mode.name.clone(),
            motion: mode.dominant.into(),
            participation: mode.participation,
        }
    }
}

impl From<&PlaneFigures> for PlaneOutput {
    fn from(plane: &PlaneFigures) -> Self {
        let fallback = [("mass", plane.mass_fallback), ("inertia", plane.inertia_fallback)];
        Self {
            rotor: plane.rotor.side.name(),
            plane: plane.rotor.plane,
            mode_share: plane.mode_share,
            energy_residual: plane.energy_residual,
            fallback: fallback.into_iter().filter(|(_, taken)| *taken).map(|(name, _)| name).collect(),
            mass_kg: plane.mass,
            static_mass_kg: plane.static_mass,
            total_mass_kg: plane.total_mass,
            inertia_kg_m2: plane.inertia,
            static_inertia_kg_m2: plane.static_inertia,
            total_inertia_kg_m2: plane.total_inertia,
        }
    }
}

impl From<&Causes> for BandOutput {
    fn from(causes: &Causes) -> Self {
        let mode = causes.responsible.zip(causes.mode.clone());
        let mode = mode.map(|(responsible, (name, frequency_hz, dominant))| ModeOutput {
            name,
            frequency_hz,
            fe_mode: responsible.fe,
            lumped_mode: responsible.lumped,
            share: responsible.share,
            motion: dominant.into(),
        });
        let shift = causes.shift.map(|shift| ShiftOutput {
            fe_hz: shift.fe_hz,
            lumped_hz: shift.lumped_hz,
            shift_percent: shift.percent,
            mac: shift.mac,
            participation_ratio: shift.participation_ratio,
        });
        Self {
            from_hz: causes.band.from_hz,
            to_hz: causes.band.to_hz,
            worst_db: causes.band.worst_db,
            worst_at_hz: causes.band.worst_at_hz,
            mode,
            shift,
            unpaired: causes.unpaired.iter().map(UnpairedOutput::from).collect(),
            planes: causes.planes.iter().map(PlaneOutput::from).collect(),
            why: causes.sentences(),
        }
    }
}

impl<'a> Output<'a> {
    fn new(design: &'a Design, rotors: &Rotors, args: &Args) -> Result<Self, SolveError> {
        let frequency_hz = frequency_lines(&design.analysis);
        let solve = |kind| -> Result<_, SolveError> {
            let solved = comparison::solved(kind, design, rotors)?;
            let failed = |error| SolveError::Response { kind, error };
            let spectrum = solved.spectrum(&frequency_hz).map_err(failed)?;
            Ok((solved, spectrum.mesh_force))
        };
        let ((fe_solved, fe), (lumped_solved, lumped)) = (solve(ModelKind::Fe)?, solve(args.model)?);
        let found = disagreement_bands(&frequency_hz, &lumped, &fe, args.tolerance);
        let go_on = &mut || ControlFlow::Continue(());
        let modes = ModalComparison::of(&fe_solved, &lumped_solved, design, rotors, go_on)?;
        let output = |band| BandOutput::from(&Causes::new(&modes, rotors, band));
        let levels = sixth_octave_bands(&frequency_hz).into_iter().map(|band| LevelOutput {
            from_hz: band.low_hz,
            to_hz: band.high_hz,
            fe_db: band_level_db(&fe[band.lines.clone()]),
            model_db: band_level_db(&lumped[band.lines]),
        });
        Ok(Self {
            design: &design.name,
            model: args.model.name().into_owned(),
            tolerance_db: args.tolerance,
            bands: found.into_iter().map(output).collect(),
            levels: levels.collect(),
        })
    }
}

fn write_csv(out: &mut impl Write, bands: &[BandOutput]) -> io::Result<()> {
    let heads = "from_hz,to_hz,worst_db,worst_at_hz,mode,mode_hz,motion,motion_share,lumped_hz,shift_percent,why";
    write!(out, "{heads}\r\n")?;
    for band in bands {
        write!(out, "{:?},{:?},{:?},{:?},", band.from_hz, band.to_hz, band.worst_db, band.worst_at_hz)?;
        match &band.mode {
            Some(mode) => {
                let motion = format!("{} {}", mode.motion.rotor, mode.motion.motion);
                write!(out, "{},{:?},{motion},{:?},", field(&mode.name), mode.frequency_hz, mode.motion.share)?;
            }
            None => write!(out, ",,,,")?,
        }
        match &band.shift {
            Some(shift) => write!(out, "{:?},{:?},", shift.lumped_hz, shift.shift_percent)?,
            None => write!(out, ",,")?,
        }
        write!(out, "{}\r\n", field(&band.why.join(" ")))?;
    }
    Ok(())
}

fn write_table(out: &mut impl Write, output: &Output<'_>) -> io::Result<()> {
    const WIDTH: usize = 80;
    const WIDEST_NAME: usize = 34;
    writeln!(out, "{}", printable(output.design))?;
    if output.bands.is_empty() {
        return writeln!(out, "{}: no line differs from FE by more than {} dB", output.model, output.tolerance_db);
    }
    writeln!(out, "{} against FE: lines that differ by more than {} dB\n", output.model, output.tolerance_db)?;
    let mut table =
        Table::new(["from Hz", "to Hz", "worst\ndB", "at Hz", "mode\nHz", "shift\n%", "mode held responsible", ""]);
    for band in &output.bands {
        let mode = band.mode.as_ref();
        table.row([
            grouped(band.from_hz),
            grouped(band.to_hz),
            format!("{:+.1}", band.worst_db),
            grouped(band.worst_at_hz),
            mode.map_or("-".into(), |mode| grouped(mode.frequency_hz)),
            band.shift.as_ref().map_or("-".into(), |shift| format!("{:+.1}", shift.shift_percent)),
            mode.map_or("-".into(), |mode| cut(&mode.name, WIDEST_NAME, "..")),
        ]);
    }
    write!(out, "{table}")?;
    for band in &output.bands {
        writeln!(out)?;
        for line in wrap(&band.why.join(" "), WIDTH) {
            writeln!(out, "{line}")?;
        }
    }
    Ok(())
}
