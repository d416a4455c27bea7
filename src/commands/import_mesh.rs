//! `bevelscope import-mesh`: averaged results of a contact program into a design.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::{CommandError, Status, input};
use crate::design::{Edit, Editor, KeyPath, Side, Source, Spelled, save_new};
use crate::gear::{AveragedMesh, read_csv};
use crate::text::printable;

/// Most bytes of a table.
const MAX_BYTES: u64 = 1 << 20;

/// Put averaged mesh numbers into a design: mesh point, line of action, stiffness and transmission error of one flank.
///
/// The table is a file of comma-separated values. Its first line names the columns, in any order: flank, stiffness_n_per_m,
/// transmission_error_um, pinion_point_x_mm (y, z), pinion_line_x (y, z), gear_point_x_mm (y, z), gear_line_x (y, z); each further
/// line is a flank, drive or coast. Everything else in the design stays as it is written.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// Table with the mesh numbers
    csv: PathBuf,
    /// Design file, or - for standard input
    file: PathBuf,
    /// Which flank of the table
    #[arg(long, default_value = "drive")]
    flank: Flank,
    /// New design file, or - for standard output; a file that is there is never overwritten
    #[arg(short, long)]
    output: PathBuf,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Flank {
    Drive,
    Coast,
}

impl Flank {
    fn word(self) -> &'static str {
        match self {
            Self::Drive => "drive",
            Self::Coast => "coast",
        }
    }
}

pub fn run(args: &Args, out: &mut impl Write, err: &mut impl Write) -> Result<Status, CommandError> {
    let mesh = flank(&args.csv, args.flank)?;
    let loaded = input::load(&args.file, err)?;
    let usage = |error: &dyn std::fmt::Display| CommandError::Usage(printable(&error.to_string()).into_owned());
    let mut editor = Editor::new(loaded.text.as_str()).map_err(|error| usage(&error))?;
    for edit in edits(&mesh, loaded.design.mesh.geometry.is_some()) {
        editor.apply(&edit).map_err(|error| usage(&error))?;
    }
    let reading = editor.reading();
    let name = args.output.display().to_string();
    let findings = Source::new(&name, editor.text()).render_all(&reading.findings);
    if reading.design.is_none() {
        return Err(CommandError::Usage(format!("the design would not be valid:\n{findings}").trim_end().into()));
    }
    let _ = write!(err, "{findings}");
    if args.output == Path::new("-") {
        out.write_all(editor.text().as_bytes())?;
    } else {
        save_new(&args.output, editor.text()).map_err(|error| usage(&error))?;
    }
    Ok(Status::Success)
}

fn flank(path: &Path, flank: Flank) -> Result<AveragedMesh, CommandError> {
    let name = path.display().to_string();
    let failed = |error: &dyn std::fmt::Display| {
        CommandError::Usage(format!("{}: {}", printable(&name), printable(&error.to_string())))
    };
    let too_large = std::fs::metadata(path).map_err(|error| failed(&error))?.len() > MAX_BYTES;
    if too_large {
        return Err(failed(&"larger than 1 MiB: no table of averaged mesh numbers"));
    }
    let text = std::fs::read_to_string(path).map_err(|error| failed(&error))?;
    let flanks = read_csv(&text).map_err(|error| failed(&error))?;
    let found = flanks.into_iter().find(|mesh| mesh.flank == flank.word());
    found.ok_or_else(|| failed(&format!("there is no line for the flank {}", flank.word())))
}

/// Vectors take the place of gear data, if there are any.
fn edits(mesh: &AveragedMesh, has_geometry: bool) -> Vec<Edit> {
    let top = KeyPath::root().key("mesh");
    let set = |path: KeyPath, text: String| Some(Edit::Set { path, value: Spelled::parse(&text)? });
    let mut edits: Vec<Option<Edit>> = Vec::new();
    if has_geometry {
        edits.push(Some(Edit::Remove { path: top.key("geometry") }));
    }
    edits.push(set(top.key("stiffness_n_per_m"), format!("{:?}", mesh.stiffness_n_per_m)));
    edits.push(set(top.key("transmission_error_um"), format!("{:?}", mesh.transmission_error_um)));
    for (side, (point, line)) in Side::BOTH.into_iter().zip(mesh.sides) {
        edits.push(set(top.key(side.name()).key("point_mm"), format!("{point:?}")));
        edits.push(set(top.key(side.name()).key("line_of_action"), format!("{line:?}")));
    }
    edits.into_iter().flatten().collect()
}
