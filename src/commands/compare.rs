//! `bevelscope compare`: where two designs differ, and how the models of both agree.
//!
//! The table of differences has a line for each value by its key path, as both files spell it, with its unit. A value that only one design has is `-` for the other; a row that only one has is `added` or `removed`. Only a terminal's lines are cut. Then the agreement of both, and how far
//! apart the finite element spectra are, where both are computed on the same lines.

use std::io::{self, IsTerminal, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use unicode_width::UnicodeWidthStr;

use super::{CommandError, Format, Status, input};
use crate::comparison::{self, Comparison};
use crate::design::{Difference, Loaded, diff};
use crate::number::grouped;
use crate::report::{Figures, Table, json};
use crate::text::{cut, cut_apart, printable};

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Design file, or - for standard input
    a: PathBuf,
    /// The other design file
    b: PathBuf,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

pub fn run(args: &Args, out: &mut impl Write, err: &mut impl Write) -> Result<Status, CommandError> {
    if args.a.as_os_str() == "-" && args.b.as_os_str() == "-" {
        return Err(CommandError::Usage("standard input can be one of the two designs, not both".into()));
    }
    let (a, b) = (Side::new(&args.a, err)?, Side::new(&args.b, err)?);
    let differences = diff(&a.loaded.text, &b.loaded.text);
    let fe_rms_db = a.comparison.fe_rms_db(&b.comparison);
    match args.format {
        Format::Json => json::write(out, &Output::new(&a, &b, &differences, fe_rms_db))?,
        Format::Table => {
            let width = if io::stdout().is_terminal() { WIDTH } else { usize::MAX };
            write_tables(out, (&a, &b), &differences, fe_rms_db, width)?;
        }
    }
    Ok(Status::Success)
}

struct Side {
    file: String,
    loaded: Loaded,
    comparison: Comparison,
}

impl Side {
    fn new(path: &Path, err: &mut impl Write) -> Result<Self, CommandError> {
        let loaded = input::load(path, err)?;
        let rotors = input::rotors(&loaded, err)?;
        let comparison = comparison::compare_rotors(&loaded.design, &rotors, None, &mut |_| ControlFlow::Continue(()))
            .map_err(|error| input::failed(&loaded, error))?;
        Ok(Self { file: path.display().to_string(), loaded, comparison })
    }

    fn stem(&self) -> String {
        let stem = Path::new(&self.file).file_stem();
        stem.map_or_else(|| self.file.clone(), |stem| stem.to_string_lossy().into_owned())
    }
}

#[derive(serde::Serialize)]
struct Output<'a> {
    a: SideOutput<'a>,
    b: SideOutput<'a>,
    differences: Vec<DifferenceOutput<'a>>,
    /// RMS of the difference of the finite element spectra; null where their lines differ
    fe_rms_db: Option<f64>,
}

#[derive(serde::Serialize)]
struct SideOutput<'a> {
    file: &'a str,
    design: &'a str,
    enhanced: Figures,
    basic: Figures,
}

#[derive(serde::Serialize)]
struct DifferenceOutput<'a> {
    /// Key path in A; its last key names the unit
    key: String,
    /// The same in B: another one where the row has moved or has another name
    key_in_b: String,
    label: &'a str,
    a: Option<Value<'a>>,
    b: Option<Value<'a>>,
    unit: &'a str,
    /// As spelled in the file
    a_text: Option<&'a str>,
    b_text: Option<&'a str>,
}

/// A number in `unit`, or a text; null where the design has no such value or row.
#[derive(serde::Serialize)]
#[serde(untagged)]
enum Value<'a> {
    Number(f64),
    Text(&'a str),
}

impl<'a> Value<'a> {
    fn new(spelled: Option<&'a str>, number: Option<f64>) -> Option<Self> {
        number.map(Self::Number).or(spelled.map(Self::Text))
    }
}

impl<'a> Output<'a> {
    fn new(a: &'a Side, b: &'a Side, differences: &'a [Difference], fe_rms_db: Option<f64>) -> Self {
        let side = |side: &'a Side| SideOutput {
            file: &side.file,
            design: &side.loaded.design.name,
            enhanced: (&side.comparison.enhanced_agreement).into(),
            basic: (&side.comparison.basic_agreement).into(),
        };
        let difference = |difference: &'a Difference| {
            let (a_text, b_text) = (difference.a.as_deref(), difference.b.as_deref());
            let [a, b] = difference.numbers();
            DifferenceOutput {
                key: difference.path.to_string(),
                key_in_b: difference.path_in_b.to_string(),
                label: &difference.label,
                a: Value::new(a_text, a),
                b: Value::new(b_text, b),
                unit: difference.unit,
                a_text,
                b_text,
            }
        };
        Self { a: side(a), b: side(b), differences: differences.iter().map(difference).collect(), fe_rms_db }
    }
}

/// Columns of the terminal, and the most that each of the two values takes.
const WIDTH: usize = 80;
const VALUE: usize = 14;

fn write_tables(
    out: &mut impl Write,
    (a, b): (&Side, &Side),
    differences: &[Difference],
    fe_rms_db: Option<f64>,
    width: usize,
) -> io::Result<()> {
    for (name, side) in [("A", a), ("B", b)] {
        let design = printable(&side.loaded.design.name);
        writeln!(
            out,
            "{name}  {}",
            cut(&format!("{}: {design}", printable(&side.stem())), width.saturating_sub(3), "..")
        )?;
    }
    writeln!(out)?;
    if differences.is_empty() {
        writeln!(out, "no value differs")?;
    } else {
        write_differences(out, differences, width)?;
    }
    writeln!(out)?;
    let mut table = Table::new(["", "enhanced\nlimit Hz", "RMS\ndB", "FRAC", "basic\nlimit Hz", "RMS\ndB", "FRAC"]);
    for (name, side) in [("A", a), ("B", b)] {
        let mut cells = vec![name.to_owned()];
        for agreement in [&side.comparison.enhanced_agreement, &side.comparison.basic_agreement] {
            cells.push(grouped(agreement.agreement_limit_hz));
            cells.push(format!("{:.2}", agreement.rms_db));
            cells.push(format!("{:.3}", agreement.frac));
        }
        table.row(cells);
    }
    write!(out, "{table}")?;
    match fe_rms_db {
        Some(rms) => writeln!(out, "\nfinite element spectra: {rms:.2} dB RMS apart"),
        None => writeln!(out, "\nfinite element spectra: on different lines"),
    }
}

/// A line a value; where its key path leaves no room for the values, they stand below it. Nothing is cut where there is no
/// end to the lines, and a long text never widens the columns of the others.
fn write_differences(out: &mut impl Write, differences: &[Difference], width: usize) -> io::Result<()> {
    let most = if width == usize::MAX { usize::MAX } else { VALUE };
    let rows = differences.iter().map(|difference| {
        let key = printable(&difference.path.to_string()).into_owned();
        let values = difference.shown().map(printable);
        let [a, b] = cut_apart([&values[0], &values[1]], most, "..");
        [key, a, b, difference.unit.to_owned()]
    });
    let rows: Vec<[String; 4]> = [["key", "A", "B", "unit"].map(str::to_owned)].into_iter().chain(rows).collect();
    let widest = |place: usize| {
        let widths = rows.iter().map(|row| row[place].width());
        widths.filter(|width| *width <= VALUE).max().unwrap_or(0)
    };
    let (a, b, unit) = (widest(1), widest(2), widest(3));
    let longest_key = rows.iter().map(|row| row[0].width()).max().unwrap_or(0);
    let room = longest_key.min(WIDTH.saturating_sub(a + b + unit + 6));
    let pad = |text: &str, width: usize| " ".repeat(width.saturating_sub(text.width()));
    for [key, of_a, of_b, unit] in &rows {
        let key = cut(key, width, "..");
        if key.width() > room {
            write!(out, "{key}\n{}", " ".repeat(room))?;
        } else {
            write!(out, "{key}{}", pad(&key, room))?;
        }
        let line = format!("  {}{of_a}  {}{of_b}  {unit}", pad(of_a, a), pad(of_b, b));
        writeln!(out, "{}", line.trim_end())?;
    }
    Ok(())
}
