//! `bevelscope modes`: natural frequencies, where their energy is, and which of them pair up.

use std::io::{self, Write};

use super::{CommandError, FileArg, Format, ModelArg, Status, input};
use crate::agreement::{ModePair, pair_modes};
use crate::comparison::SolveError;
use crate::design::Design;
use crate::model::{Model, ModelKind, Rotors};
use crate::number::significant;
use crate::report::Table;
use crate::report::json::{self, Object};
use crate::response::{EnergyShare, Mode, Modes};
use crate::text::printable;

/// Finite element modes that are listed.
const MOST_FE_MODES: usize = 40;

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

pub fn run(args: &Args, out: &mut impl Write, err: &mut impl Write) -> Result<Status, CommandError> {
    let loaded = input::load(&args.file.file, err)?;
    let solved = solve(&loaded.design, &args.models.kinds())
        .map_err(|error| CommandError::Solve { name: loaded.name.clone(), error })?;
    match args.format {
        Format::Json => json::write(out, &Output::new(&loaded.design, &solved))?,
        Format::Table => write_tables(out, &loaded.design, &solved)?,
    }
    Ok(Status::Success)
}

/// One model's modes, each lumped one with the finite element mode it pairs with.
struct Solved {
    kind: ModelKind,
    modes: Vec<(Mode, Option<Partner>)>,
}

/// The finite element mode whose shape a lumped mode has.
#[derive(Clone, Copy, serde::Serialize)]
struct Partner {
    /// Index among the finite element modes
    fe_mode: usize,
    fe_hz: f64,
    mac: f64,
}

fn solve(design: &Design, kinds: &[ModelKind]) -> Result<Vec<Solved>, SolveError> {
    let rotors = Rotors::new(design)?;
    let modes = |kind| -> Result<(Model, Modes), SolveError> {
        let model = Model::new(kind, design, &rotors)?;
        let modes = Modes::new(&model, MOST_FE_MODES).map_err(|error| SolveError::Response { kind, error })?;
        Ok((model, modes))
    };
    let fe = modes(ModelKind::Fe)?;
    let enhanced = Model::new(ModelKind::Enhanced, design, &rotors)?;
    let with_partners = |(model, modes): (Model, Modes)| {
        let pairs = pair_modes((&model, &modes), (&fe.0, &fe.1), &enhanced);
        let partner =
            |pair: &ModePair| Partner { fe_mode: pair.fe, fe_hz: fe.1.0[pair.fe].frequency_hz, mac: pair.mac };
        let find = |i: usize| pairs.iter().find(|pair| pair.lumped == i).map(partner);
        let modes = modes.0.into_iter().enumerate().map(|(i, mode)| (mode, find(i))).collect();
        Solved { kind: model.kind, modes }
    };
    let of_fe = || Solved { kind: ModelKind::Fe, modes: fe.1.0.iter().map(|mode| (mode.clone(), None)).collect() };
    let solved = |kind| if kind == ModelKind::Fe { Ok(of_fe()) } else { modes(kind).map(with_partners) };
    kinds.iter().copied().map(solved).collect()
}

#[derive(serde::Serialize)]
struct Output<'a> {
    design: &'a str,
    models: Object<Vec<ModeOutput>>,
}

#[derive(serde::Serialize)]
struct ModeOutput {
    frequency_hz: f64,
    energy_share: Shares,
    /// Null for finite element modes and for a lumped mode without partner
    paired_with: Option<Partner>,
}

#[derive(serde::Serialize)]
struct Shares {
    pinion: ShareOutput,
    gear: ShareOutput,
}

#[derive(serde::Serialize)]
struct ShareOutput {
    lateral: f64,
    axial: f64,
    tilt: f64,
    torsion: f64,
}

impl From<EnergyShare> for ShareOutput {
    fn from(EnergyShare { lateral, axial, tilt, torsion }: EnergyShare) -> Self {
        Self { lateral, axial, tilt, torsion }
    }
}

impl<'a> Output<'a> {
    fn new(design: &'a Design, models: &[Solved]) -> Self {
        let models = models.iter().map(|model| {
            let mode = |(mode, partner): &(Mode, Option<Partner>)| ModeOutput {
                frequency_hz: mode.frequency_hz,
                energy_share: Shares { pinion: mode.pinion.into(), gear: mode.gear.into() },
                paired_with: *partner,
            };
            (model.kind.name(), model.modes.iter().map(mode).collect())
        });
        Self { design: &design.name, models: Object(models.collect()) }
    }
}

fn write_tables(out: &mut impl Write, design: &Design, models: &[Solved]) -> io::Result<()> {
    writeln!(out, "{}", printable(&design.name))?;
    writeln!(out, "kinetic energy in %: lateral x, z; axial y; tilt thx, thz; torsion thy, drive")?;
    for model in models {
        writeln!(out, "\n{}", model.kind.title())?;
        let mut heads = vec!["mode", "Hz"];
        heads.extend(["pinion\nlat", "ax", "tilt", "tors", "gear\nlat", "ax", "tilt", "tors"]);
        if model.kind != ModelKind::Fe {
            heads.extend(["FE\nmode", "FE\nHz", "shift\n%", "MAC"]);
        }
        let mut table = Table::with_heads(heads.into_iter().map(str::to_owned).collect()).tight();
        for (i, (mode, partner)) in model.modes.iter().enumerate() {
            let mut cells = vec![format!("{i}"), significant(mode.frequency_hz, 6)];
            for share in [mode.pinion, mode.gear] {
                cells.extend([share.lateral, share.axial, share.tilt, share.torsion].map(percent));
            }
            if model.kind != ModelKind::Fe {
                cells.extend(partner_cells(mode, *partner));
            }
            table.row(cells);
        }
        write!(out, "{table}")?;
    }
    Ok(())
}

fn partner_cells(mode: &Mode, partner: Option<Partner>) -> [String; 4] {
    let Some(partner) = partner else { return ["-"; 4].map(str::to_owned) };
    let shift = 100.0 * (mode.frequency_hz / partner.fe_hz - 1.0);
    let shift = match shift.abs() {
        // the rigid rotation has no frequency to be off from
        size if !size.is_finite() => "-".into(),
        0.0..0.005 => "0.00".into(),
        0.005..100.0 => format!("{shift:+.2}"),
        _ => format!("{shift:+.0}"),
    };
    [format!("{}", partner.fe_mode), significant(partner.fe_hz, 6), shift, format!("{:.2}", partner.mac)]
}

/// Whole percent, a point where there is next to nothing.
fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent.abs() < 0.5 { ".".into() } else { format!("{percent:.0}") }
}
