//! `bevelscope modes`: natural frequencies, where their energy is, and which of them pair up.

use std::io::{self, Write};

use super::{CommandError, FileArg, Format, ModelArg, Status, input};
use crate::agreement::{COMPARED_FE_MODES, ModePair, mac_matrix, pair_modes};
use crate::comparison::SolveError;
use crate::design::Design;
use crate::model::{Model, ModelKind, RecoveryKind, Rotors};
use crate::number::significant;
use crate::report::Table;
use crate::report::json::{self, Object};
use crate::response::{EnergyShare, Mode, Modes, StationShape, mode_shape};
use crate::text::{cut, printable};

/// Finite element modes that are listed: those that lumped ones are paired with.
const MOST_FE_MODES: usize = COMPARED_FE_MODES;

#[derive(Debug, clap::Args)]
pub struct Args {
    #[command(flatten)]
    file: FileArg,
    #[command(flatten)]
    models: ModelArg,
    /// With --format json: the whole MAC matrix of every model with FE, and mode shapes at the stations of both shafts
    #[arg(long)]
    shapes: bool,
    /// Form of the output; the table counts modes from 1, JSON from 0 as places in its lists
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(args: &Args, out: &mut impl Write, err: &mut impl Write) -> Result<Status, CommandError> {
    let loaded = input::load(&args.file.file, err)?;
    let rotors = input::rotors(&loaded, err)?;
    let solved = solve(&loaded.design, &rotors, &args.models.kinds(), args.shapes)
        .map_err(|error| input::failed(&loaded, error))?;
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
    shapes: Option<Shapes>,
}

/// What is only written on request.
struct Shapes {
    /// A row a mode, a column a finite element mode
    mac: Vec<Vec<f64>>,
    displacements: RecoveryKind,
    modes: Vec<[StationShape<f64>; 2]>,
}

/// The finite element mode whose shape a lumped mode has.
#[derive(Clone, Copy, serde::Serialize)]
struct Partner {
    /// Index among the finite element modes, from 0
    fe_mode: usize,
    fe_hz: f64,
    mac: f64,
    #[serde(skip)]
    is_rigid: bool,
}

fn solve(design: &Design, rotors: &Rotors, kinds: &[ModelKind], shapes: bool) -> Result<Vec<Solved>, SolveError> {
    let modes = |kind| -> Result<(Model, Modes), SolveError> {
        let model = Model::new(kind, design, rotors)?;
        let modes = Modes::new(&model, MOST_FE_MODES).map_err(|error| SolveError::Response { kind, error })?;
        Ok((model, modes))
    };
    let fe = modes(ModelKind::Fe)?;
    let enhanced = Model::new(ModelKind::Enhanced, design, rotors)?;
    let shapes_of = |model: &Model, modes: &Modes| -> Result<Option<Shapes>, SolveError> {
        if !shapes {
            return Ok(None);
        }
        let recovery = model.recovery(design, rotors)?;
        let mac = mac_matrix((model, modes), (&fe.0, &fe.1), &enhanced);
        Ok(Some(Shapes {
            mac: mac.row_iter().map(|row| row.iter().copied().collect()).collect(),
            displacements: recovery[0].kind,
            modes: modes.0.iter().map(|mode| mode_shape(model, &recovery, &mode.shape)).collect(),
        }))
    };
    let solved = |&kind: &ModelKind| {
        if kind == ModelKind::Fe {
            let modes = fe.1.0.iter().map(|mode| (mode.clone(), None)).collect();
            return Ok(Solved { kind, modes, shapes: shapes_of(&fe.0, &fe.1)? });
        }
        let (model, modes) = modes(kind)?;
        let shapes = shapes_of(&model, &modes)?;
        let pairs = pair_modes((&model, &modes), (&fe.0, &fe.1), &enhanced);
        let partner = |pair: &ModePair| {
            let of_fe = &fe.1.0[pair.fe];
            Partner { fe_mode: pair.fe, fe_hz: of_fe.frequency_hz, mac: pair.mac, is_rigid: of_fe.is_rigid() }
        };
        let find = |i: usize| pairs.iter().find(|pair| pair.lumped == i).map(partner);
        let modes = modes.0.into_iter().enumerate().map(|(i, mode)| (mode, find(i))).collect();
        Ok(Solved { kind, modes, shapes })
    };
    kinds.iter().map(solved).collect()
}

#[derive(serde::Serialize)]
struct Output<'a> {
    design: &'a str,
    models: Object<Vec<ModeOutput>>,
    /// Rows are modes of the model, columns those of FE
    #[serde(skip_serializing_if = "Option::is_none")]
    mac: Option<Object<Vec<Vec<f64>>>>,
    /// Scaled to phi^T M phi = 1 kg m^2
    #[serde(skip_serializing_if = "Option::is_none")]
    shapes: Option<Object<ShapesOutput>>,
}

#[derive(serde::Serialize)]
struct ShapesOutput {
    /// How they follow from the model's coordinates
    displacements: &'static str,
    modes: Vec<ModeShapes>,
}

#[derive(serde::Serialize)]
struct ModeShapes {
    pinion: ShapeOutput,
    gear: ShapeOutput,
}

/// One value a station.
#[derive(serde::Serialize)]
struct ShapeOutput {
    stations_mm: Vec<f64>,
    x_m: Vec<f64>,
    y_m: Vec<f64>,
    z_m: Vec<f64>,
    thx_rad: Vec<f64>,
    thy_rad: Vec<f64>,
    thz_rad: Vec<f64>,
    /// Null where there is no drive
    drive_rad: Option<f64>,
}

impl From<&StationShape<f64>> for ShapeOutput {
    fn from(shape: &StationShape<f64>) -> Self {
        let of = |motion: usize| shape.displacements.iter().map(|station| station[motion]).collect();
        Self {
            stations_mm: shape.positions.iter().map(|position| position * 1e3).collect(),
            x_m: of(0),
            y_m: of(1),
            z_m: of(2),
            thx_rad: of(3),
            thy_rad: of(4),
            thz_rad: of(5),
            drive_rad: shape.drive,
        }
    }
}

impl From<&Shapes> for ShapesOutput {
    fn from(shapes: &Shapes) -> Self {
        let mode = |[pinion, gear]: &[StationShape<f64>; 2]| ModeShapes { pinion: pinion.into(), gear: gear.into() };
        Self { displacements: shapes.displacements.name(), modes: shapes.modes.iter().map(mode).collect() }
    }
}

#[derive(serde::Serialize)]
struct ModeOutput {
    frequency_hz: f64,
    /// By where its kinetic energy is
    name: String,
    /// Share of the strain energy in the mesh
    mesh_strain_share: f64,
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
        let shapes = |model: &'_ Solved| Some((model.kind.name(), model.shapes.as_ref()?.into()));
        let mac = |model: &'_ Solved| Some((model.kind.name(), model.shapes.as_ref()?.mac.clone()));
        let (mac, shapes) = (models.iter().map(mac).collect(), models.iter().map(shapes).collect());
        let (mac, shapes): (Option<Vec<_>>, Option<Vec<_>>) = (mac, shapes);
        let models = models.iter().map(|model| {
            let mode = |(mode, partner): &(Mode, Option<Partner>)| ModeOutput {
                frequency_hz: mode.frequency_hz,
                name: mode.name(),
                mesh_strain_share: mode.mesh_strain_share,
                energy_share: Shares { pinion: mode.pinion.into(), gear: mode.gear.into() },
                paired_with: *partner,
            };
            (model.kind.name(), model.modes.iter().map(mode).collect())
        });
        Self {
            design: &design.name,
            models: Object(models.collect()),
            mac: mac.map(Object),
            shapes: shapes.map(Object),
        }
    }
}

fn write_tables(out: &mut impl Write, design: &Design, models: &[Solved]) -> io::Result<()> {
    writeln!(out, "{}", printable(&design.name))?;
    writeln!(out, "kinetic energy in %: lateral x, z; axial y; tilt thx, thz; torsion thy, drive")?;
    writeln!(out, "mesh: share of the strain energy in the mesh, %")?;
    for model in models {
        writeln!(out, "\n{}", model.kind.title())?;
        let mut heads = vec!["mode", "Hz"];
        heads.extend(["pinion\nlat", "ax", "tilt", "tors", "gear\nlat", "ax", "tilt", "tors"]);
        if model.kind == ModelKind::Fe {
            heads.extend(["mesh", "name", ""]);
        } else {
            heads.extend(["FE\nmode", "FE\nHz", "shift\n%", "MAC"]);
        }
        let mut table = Table::with_heads(heads.into_iter().map(str::to_owned).collect()).tight();
        for (i, (mode, partner)) in model.modes.iter().enumerate() {
            let mut cells = vec![format!("{}", i + 1), significant(mode.frequency_hz, 6)];
            for share in [mode.pinion, mode.gear] {
                cells.extend([share.lateral, share.axial, share.tilt, share.torsion].map(percent));
            }
            if model.kind == ModelKind::Fe {
                cells.extend([percent(mode.mesh_strain_share), short_name(mode)]);
            } else {
                cells.extend(partner_cells(mode, *partner));
            }
            table.row(cells);
        }
        write!(out, "{table}")?;
    }
    let shares = models.iter().flat_map(|model| &model.modes).flat_map(|(mode, _)| [mode.pinion, mode.gear]);
    let mut all = shares.flat_map(|share| [share.lateral, share.axial, share.tilt, share.torsion]);
    if all.any(|share| share < -0.005) {
        writeln!(out, "\nshares below 0: motions that the mass matrix couples (lateral and tilt of a")?;
        writeln!(out, "shaft) share their energy; their sum is never below 0")?;
    }
    Ok(())
}

fn partner_cells(mode: &Mode, partner: Option<Partner>) -> [String; 4] {
    let Some(partner) = partner else { return ["-"; 4].map(str::to_owned) };
    let shift = 100.0 * (mode.frequency_hz / partner.fe_hz - 1.0);
    let shift = match shift.abs() {
        // the rigid rotation has no frequency to be off from
        _ if partner.is_rigid => "-".into(),
        0.0..0.005 => "0.00".into(),
        0.005..100.0 => format!("{shift:+.2}"),
        _ => format!("{shift:+.0}"),
    };
    [format!("{}", partner.fe_mode + 1), significant(partner.fe_hz, 6), shift, format!("{:.2}", partner.mac)]
}

/// A mode's name in what the other columns leave of eighty; JSON has all of it.
fn short_name(mode: &Mode) -> String {
    const ROOM: usize = 22;
    cut(&mode.name().replace(" plane", "").replace(", ", " "), ROOM, "..")
}

/// Whole percent, a point where there is next to nothing.
fn percent(share: f64) -> String {
    let percent = 100.0 * share;
    if percent.abs() < 0.5 { ".".into() } else { format!("{percent:.0}") }
}
