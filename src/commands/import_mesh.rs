//! `bevelscope import-mesh`: averaged results of a contact program into a design.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::{CommandError, Status, input};
use crate::design::{Editor, Source, TextError, read_text, save_new};
use crate::gear::AveragedMesh;
use crate::pair::{Flank, edit_of, import_notes, read_flanks};
use crate::text::printable;

/// Most bytes of a table.
const MAX_BYTES: u64 = 1 << 20;

/// What a table looks like.
const TABLE: &str = "\
The table: comma-separated values with decimal points. The first line names
all 15 columns, in any order; each further line is a flank, drive or coast.
Lines that are empty or begin with # say nothing.

  flank                          drive or coast
  stiffness_n_per_m              mean mesh stiffness along the line of action, N/m
  transmission_error_um          amplitude at mesh frequency, um
  pinion_point_x_mm, _y_, _z_    mesh point, mm, from the pinion's mesh station
  pinion_line_x, _y, _z          line of action, unit vector (to 1 %)
  gear_point_x_mm, _y_, _z_      the same point from the gear's mesh station
  gear_line_x, _y, _z            the same vector in the gear's frame

Frames: each side in its own shaft's frame, y along the shaft. Signs: both
lines are one vector, the direction of the force on the gear.

Example (two lines; each of them is one line in the file):
flank,stiffness_n_per_m,transmission_error_um,pinion_point_x_mm,pinion_point_y_mm,pinion_point_z_mm,pinion_line_x,pinion_line_y,pinion_line_z,gear_point_x_mm,gear_point_y_mm,gear_point_z_mm,gear_line_x,gear_line_y,gear_line_z
drive,6.4e8,5,0,0,27.46,0.76975,-0.62285,0.1398,0,0,76.49,-0.76975,0.1398,-0.62285";

/// Put averaged mesh numbers into a design: mesh point, line of action, stiffness and transmission error of one flank.
///
/// Mesh vectors take the place of `[mesh.geometry]`, which is taken out where the design has it: a design has one or the other. Comments on
/// replaced numbers give way to `# imported: FILE, FLANK flank`. Everything else in the design stays as it is written.
#[derive(Debug, clap::Args)]
#[command(after_long_help = TABLE)]
pub struct Args {
    /// Table with the mesh numbers
    csv: PathBuf,
    /// Design file, or - for standard input
    file: PathBuf,
    /// Which flank of the table
    #[arg(long, default_value = "drive")]
    flank: FlankArg,
    /// New design file, or - for standard output; a file that is there is never overwritten
    #[arg(short, long)]
    output: PathBuf,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum FlankArg {
    Drive,
    Coast,
}

impl From<FlankArg> for Flank {
    fn from(flank: FlankArg) -> Self {
        match flank {
            FlankArg::Drive => Self::Drive,
            FlankArg::Coast => Self::Coast,
        }
    }
}

pub fn run(args: &Args, out: &mut impl Write, err: &mut impl Write) -> Result<Status, CommandError> {
    let name = args.csv.display().to_string();
    let failed = |error: String| CommandError::Usage(format!("{}: {error}", printable(&name)));
    let flanks = flanks(&args.csv).map_err(failed)?;
    let mesh = Flank::from(args.flank).of(&flanks).map_err(failed)?;
    let loaded = input::load(&args.file, err)?;
    let usage = |error: &dyn std::fmt::Display| CommandError::Usage(printable(&error.to_string()).into_owned());
    let mut editor = Editor::new(loaded.text.as_str()).map_err(|error| usage(&error))?;
    let table = args.csv.file_name().map_or_else(|| name.clone().into(), |name| name.to_string_lossy());
    for note in import_notes(mesh, &editor) {
        let _ = writeln!(err, "{}: {}", printable(&name), printable(&note));
    }
    let edit = edit_of(mesh, &editor, &printable(&table));
    editor.apply(&edit).map_err(|error| usage(&error))?;
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

/// All flanks of a table file.
///
/// # Errors
///
/// What is wrong, in words that are harmless to show, without the file's name.
pub fn flanks(path: &Path) -> Result<Vec<AveragedMesh>, String> {
    let text = read_text(path, MAX_BYTES).map_err(|error| match error {
        TextError::TooLarge { .. } => "larger than 1 MiB: no table of averaged mesh numbers".to_owned(),
        error => error.to_string(),
    });
    text.and_then(|text| read_flanks(&text)).map_err(|error| printable(&error).into_owned())
}
