//! `bevelscope check`: how well the lumped models agree with the finite element model, a row a design.

use std::io::{self, Write};
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError, mpsc};

use super::{CommandError, Format, Status, input};
use crate::agreement::{highest_peak, reduced_modes_for};
use crate::comparison;
use crate::crash;
use crate::design::{self, LoadError, library};
use crate::model::Rotors;
use crate::number::grouped;
use crate::report::{Figures, Table, json};
use crate::text::printable;

/// How close a reduced model should come to finite elements in every sixth-octave band, dB; part of the key's name in JSON.
const REDUCED_DB: f64 = 1.0;

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Design files, folders of them, or - for standard input
    #[arg(required = true)]
    paths: Vec<PathBuf>,
    /// Band in Hz for all figures but the agreement limit, as LO:HI
    #[arg(long, value_name = "LO:HI", value_parser = parse_band)]
    band: Option<Band>,
    /// Largest RMS difference of the enhanced model, dB: beyond it the exit status is 1
    #[arg(long, value_name = "DB", value_parser = parse_limit, allow_negative_numbers = true)]
    max_rms_db: Option<f64>,
    /// Lowest agreement limit of the enhanced model, Hz: below it the exit status is 1
    #[arg(long, value_name = "HZ", value_parser = parse_limit, allow_negative_numbers = true)]
    min_limit_hz: Option<f64>,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

/// A frequency band, Hz.
#[derive(Debug, Clone, Copy)]
struct Band([f64; 2]);

fn parse_band(text: &str) -> Result<Band, String> {
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|hz| hz.is_finite() && *hz >= 0.0);
    let ends = text.split_once(':').and_then(|(low, high)| Some([number(low)?, number(high)?]));
    match ends {
        Some([low, high]) if low < high => Ok(Band([low, high])),
        _ => Err("wanted two frequencies in Hz, the lower first, such as 100:2500".into()),
    }
}

pub(super) fn parse_limit(text: &str) -> Result<f64, String> {
    let value = text.trim().parse::<f64>().ok().filter(|value| value.is_finite() && *value >= 0.0);
    value.ok_or_else(|| "wanted a number, not negative, such as 3".into())
}

pub fn run(args: &Args, out: &mut impl Write) -> Result<Status, CommandError> {
    let rows = checked_in_parallel(designs(&args.paths), args);
    match args.format {
        Format::Json => json::write(out, &rows)?,
        Format::Table => write_table(out, &rows, args)?,
    }
    let outside = |row: &Row| matches!(row, Row::Checked { within_limits: Some(false), .. });
    Ok(if rows.iter().any(|row| matches!(row, Row::Failed { .. })) {
        Status::BadInput
    } else if rows.iter().any(outside) {
        Status::OutsideLimits
    } else {
        Status::Success
    })
}

/// What the arguments name: the designs of folders by file name, files as they are, and why there is none.
fn designs(paths: &[PathBuf]) -> Vec<Result<PathBuf, Row>> {
    let mut designs = Vec::new();
    for path in paths {
        let found = if path.is_dir() { library::files(std::slice::from_ref(path)) } else { vec![path.clone()] };
        if found.is_empty() {
            designs.push(Err(Row::failed(path, "the folder holds no design (no .toml file)".into())));
        }
        designs.extend(found.into_iter().map(Ok));
    }
    designs
}

#[derive(serde::Serialize)]
struct Force {
    frequency_hz: f64,
    force_n: f64,
}

#[derive(serde::Serialize)]
#[serde(untagged)]
enum Row {
    Checked {
        file: String,
        design: String,
        band_hz: [f64; 2],
        /// Whether the enhanced model keeps the limits asked for; left out where none is
        #[serde(skip_serializing_if = "Option::is_none")]
        within_limits: Option<bool>,
        /// Highest resonance of the finite element spectrum in the band; left out where there is none
        #[serde(skip_serializing_if = "Option::is_none")]
        fe_highest_peak: Option<Box<Force>>,
        /// Greatest force of the finite element spectrum in the band, which may be at its end, below no peak
        fe_greatest: Option<Box<Force>>,
        /// Whether that is the last line of the band: a resonance may lie beyond it
        #[serde(skip)]
        rises_to_end: bool,
        enhanced: Box<Figures>,
        basic: Figures,
        /// Fixed-interface modes a rotor with which a reduced model keeps all sixth-octave levels within 1 dB
        reduced_modes_for_1_db: Option<usize>,
        /// What looks unintended in the file, as text
        #[serde(skip_serializing_if = "String::is_empty")]
        warnings: String,
    },
    Failed {
        file: String,
        error: String,
    },
}

impl Row {
    fn failed(file: &Path, error: String) -> Self {
        Self::Failed { file: file.display().to_string(), error }
    }
}

/// All rows in the order given; as many designs at a time as there are cores.
fn checked_in_parallel(designs: Vec<Result<PathBuf, Row>>, args: &Args) -> Vec<Row> {
    let workers = std::thread::available_parallelism().map_or(1, usize::from).min(designs.len());
    let (sender, rows) = mpsc::channel();
    let queue = Mutex::new(designs.into_iter().enumerate());
    let work = |sender: mpsc::Sender<(usize, Row)>| {
        let next = || queue.lock().unwrap_or_else(PoisonError::into_inner).next();
        while let Some((i, design)) = next() {
            let row = design.map_or_else(|row| row, |file| guarded(&file, args));
            if sender.send((i, row)).is_err() {
                return;
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..workers {
            let sender = sender.clone();
            scope.spawn(|| work(sender));
        }
        work(sender);
    });
    let mut rows: Vec<(usize, Row)> = rows.iter().collect();
    rows.sort_by_key(|(i, _)| *i);
    rows.into_iter().map(|(_, row)| row).collect()
}

/// A design that makes the program fail is a row like any other that cannot be solved.
fn guarded(file: &Path, args: &Args) -> Row {
    catch_unwind(AssertUnwindSafe(|| crash::caught(|| checked(file, args))))
        .unwrap_or_else(|_| Row::failed(file, "the program failed on this design".into()))
}

fn checked(file: &Path, args: &Args) -> Row {
    let loaded = match design::load(file) {
        Ok(loaded) => loaded,
        // findings say where in the file they are; all else is said of the row's file
        Err(error @ LoadError::Invalid { .. }) => return Row::failed(file, error.to_string()),
        Err(error) => return Row::failed(file, error.reason()),
    };
    let design = &loaded.design;
    let rotors = match Rotors::new(design) {
        Ok(rotors) => rotors,
        Err(error) => return Row::failed(file, error.to_string()),
    };
    let warnings = loaded.render_warnings() + &input::mean_state_warnings(&loaded, &rotors);
    let band = args.band.map(|band| band.0);
    let compared = match comparison::compare_rotors(design, &rotors, band, &mut |_| ControlFlow::Continue(())) {
        Ok(compared) => compared,
        Err(error) => return Row::failed(file, error.to_string()),
    };
    let reduced_modes = reduced_modes_for(design, &rotors, &compared.frequency_hz, &compared.fe.mesh_force, REDUCED_DB);
    let agreement = &compared.enhanced_agreement;
    let limited = args.max_rms_db.is_some() || args.min_limit_hz.is_some();
    let within = args.max_rms_db.is_none_or(|limit| agreement.rms_db <= limit)
        && args.min_limit_hz.is_none_or(|limit| agreement.agreement_limit_hz >= limit);
    let all_lines = [design.analysis.frequency_min, design.analysis.frequency_max];
    let [low, high] = args.band.map_or([0.0, f64::INFINITY], |band| band.0);
    let lines =
        compared.frequency_hz.partition_point(|hz| *hz < low)..compared.frequency_hz.partition_point(|hz| *hz <= high);
    let (hz, force) = (&compared.frequency_hz[lines.clone()], &compared.fe.mesh_force[lines]);
    let fe_greatest = hz
        .iter()
        .zip(force)
        .map(|(hz, force)| Box::new(Force { frequency_hz: *hz, force_n: force.norm() }))
        .max_by(|a, b| a.force_n.total_cmp(&b.force_n));
    let rises_to_end = fe_greatest.as_ref().is_some_and(|greatest| Some(&greatest.frequency_hz) == hz.last());
    let peak = highest_peak(hz, force);
    let fe_highest_peak = peak.map(|peak| Box::new(Force { frequency_hz: peak.frequency_hz, force_n: peak.force() }));
    Row::Checked {
        file: file.display().to_string(),
        design: design.name.clone(),
        band_hz: args.band.map_or(all_lines, |band| band.0),
        within_limits: limited.then_some(within),
        fe_highest_peak,
        fe_greatest,
        rises_to_end,
        enhanced: Box::new((&compared.enhanced_agreement).into()),
        basic: (&compared.basic_agreement).into(),
        reduced_modes_for_1_db: reduced_modes,
        warnings,
    }
}

fn write_table(out: &mut impl Write, rows: &[Row], args: &Args) -> io::Result<()> {
    let stem = |file: &str| Path::new(file).file_stem().map_or_else(|| file.into(), |stem| stem.display().to_string());
    let mut heads = vec!["design", "enhanced\nlimit Hz", "RMS\ndB", "max\ndB", "at\nHz", "FRAC"];
    heads.extend(["basic\nlimit Hz", "RMS\ndB", "modes\n1 dB"]);
    let limited = args.max_rms_db.is_some() || args.min_limit_hz.is_some();
    if limited {
        heads.push("within\nlimits");
    }
    let mut table = Table::with_heads(heads.into_iter().map(str::to_owned).collect()).widest_name(20);
    for row in rows {
        match row {
            Row::Checked { file, enhanced, basic, within_limits, warnings, reduced_modes_for_1_db: modes, .. } => {
                // a warning does not make a design wrong, but nobody should miss it
                let mark = if warnings.is_empty() { "" } else { " !" };
                let mut cells = vec![
                    stem(file) + mark,
                    grouped(enhanced.agreement_limit_hz),
                    format!("{:.2}", enhanced.rms_db),
                    format!("{:.2}", enhanced.max_db),
                    grouped(enhanced.max_at_hz),
                    format!("{:.3}", enhanced.frac),
                    grouped(basic.agreement_limit_hz),
                    format!("{:.2}", basic.rms_db),
                    modes.map_or("-".into(), |modes| modes.to_string()),
                ];
                if limited {
                    cells.push(if *within_limits == Some(false) { "NO" } else { "yes" }.into());
                }
                table.row(cells);
            }
            Row::Failed { file, .. } => table.row([stem(file), "error, see below".into()]),
        }
    }
    write!(out, "{table}")?;
    if rows.iter().any(|row| matches!(row, Row::Checked { .. })) {
        writeln!(out, "modes: a rotor, for reduced:K to keep all sixth-octave levels within {REDUCED_DB} dB of FE")?;
    }
    for row in rows {
        if let Row::Checked { file, fe_greatest: Some(greatest), rises_to_end: true, .. } = row {
            let (force, hz) = (grouped(greatest.force_n), grouped(greatest.frequency_hz));
            writeln!(
                out,
                "{}: the FE force rises to {force} N at the end of the range, {hz} Hz",
                printable(&stem(file))
            )?;
        }
    }
    for row in rows {
        let (file, text) = match row {
            Row::Checked { file, warnings, .. } => (file, warnings),
            Row::Failed { file, error } => (file, error),
        };
        if text.is_empty() {
            continue;
        }
        writeln!(out)?;
        if !text.starts_with(&format!("{}:", printable(file))) {
            write!(out, "{}: ", printable(file))?;
        }
        for line in text.trim_end().lines() {
            // tabs keep the marks of a finding below what they mark
            let parts: Vec<_> = line.split('\t').map(printable).collect();
            writeln!(out, "{}", parts.join("\t"))?;
        }
    }
    Ok(())
}
