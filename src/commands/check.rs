//! `bevelscope check`: how well the lumped models agree with the finite element model, a row a design.

use std::io::{self, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use super::{CommandError, Format, Status, input};
use crate::agreement::{Agreement, PeakPair};
use crate::comparison;
use crate::design::library;
use crate::report::{Table, grouped, json};
use crate::text::printable;

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Design files, folders of them, or - for standard input
    #[arg(required = true)]
    paths: Vec<PathBuf>,
    /// Band in Hz for all figures but the agreement limit, as LO:HI
    #[arg(long, value_name = "LO:HI", value_parser = parse_band)]
    band: Option<Band>,
    /// Largest RMS difference of the enhanced model, dB: beyond it the exit status is 1
    #[arg(long, value_name = "DB", value_parser = parse_limit)]
    max_rms_db: Option<f64>,
    /// Lowest agreement limit of the enhanced model, Hz: below it the exit status is 1
    #[arg(long, value_name = "HZ", value_parser = parse_limit)]
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

fn parse_limit(text: &str) -> Result<f64, String> {
    let value = text.trim().parse::<f64>().ok().filter(|value| value.is_finite() && *value >= 0.0);
    value.ok_or_else(|| "wanted a number, not negative".into())
}

pub fn run(args: &Args, out: &mut impl Write) -> Result<Status, CommandError> {
    let files = files(&args.paths)?;
    let rows = checked_in_parallel(&files, args);
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

/// The design files meant: those of folders by file name, the others as they are.
fn files(paths: &[PathBuf]) -> Result<Vec<PathBuf>, CommandError> {
    let mut files = Vec::new();
    for path in paths {
        if !path.is_dir() {
            files.push(path.clone());
            continue;
        }
        let shown = path.display().to_string();
        let found = library::files(std::slice::from_ref(path));
        if found.is_empty() {
            let message = format!("{}: the folder holds no design (no .toml file)", printable(&shown));
            return Err(CommandError::Usage(message));
        }
        files.extend(found);
    }
    Ok(files)
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
        enhanced: Figures,
        basic: Figures,
    },
    Failed {
        file: String,
        error: String,
    },
}

#[derive(serde::Serialize)]
struct Figures {
    rms_db: f64,
    max_db: f64,
    max_at_hz: f64,
    frac: f64,
    agreement_limit_hz: f64,
    peaks: Vec<Peak>,
}

#[derive(serde::Serialize)]
struct Peak {
    fe_hz: Option<f64>,
    lumped_hz: Option<f64>,
    shift_percent: Option<f64>,
    height_db: Option<f64>,
}

impl From<Agreement> for Figures {
    fn from(agreement: Agreement) -> Self {
        let Agreement { rms_db, max_db, max_at_hz, frac, agreement_limit_hz, peaks } = agreement;
        let peak = |PeakPair { fe_hz, lumped_hz, shift_percent, height_db }| Peak {
            fe_hz,
            lumped_hz,
            shift_percent,
            height_db,
        };
        Self { rms_db, max_db, max_at_hz, frac, agreement_limit_hz, peaks: peaks.into_iter().map(peak).collect() }
    }
}

/// All rows in the order given; as many designs at a time as there are cores.
fn checked_in_parallel(files: &[PathBuf], args: &Args) -> Vec<Row> {
    let workers = std::thread::available_parallelism().map_or(1, usize::from).min(files.len());
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        loop {
            let i = next.fetch_add(1, Ordering::Relaxed);
            let Some(file) = files.get(i) else { return done };
            done.push((i, checked(file, args)));
        }
    };
    let mut rows: Vec<(usize, Row)> = std::thread::scope(|scope| {
        let threads: Vec<_> = (1..workers).map(|_| scope.spawn(work)).collect();
        let own = work();
        own.into_iter().chain(threads.into_iter().flat_map(|thread| thread.join().unwrap_or_default())).collect()
    });
    rows.sort_by_key(|(i, _)| *i);
    rows.into_iter().map(|(_, row)| row).collect()
}

fn checked(file: &Path, args: &Args) -> Row {
    let failed = |error: String| Row::Failed { file: file.display().to_string(), error };
    // warnings are about the design, not about the agreement: `solve` and `inspect` show them
    let loaded = match input::load(file, &mut io::sink()) {
        Ok(loaded) => loaded,
        Err(error) => return failed(error.to_string()),
    };
    let design = &loaded.design;
    let compared = comparison::compare_over(design, args.band.map(|band| band.0), &mut |_| ControlFlow::Continue(()));
    let compared = match compared {
        Ok(compared) => compared,
        Err(error) => return failed(error.to_string()),
    };
    let agreement = &compared.enhanced_agreement;
    let limited = args.max_rms_db.is_some() || args.min_limit_hz.is_some();
    let within = args.max_rms_db.is_none_or(|limit| agreement.rms_db <= limit)
        && args.min_limit_hz.is_none_or(|limit| agreement.agreement_limit_hz >= limit);
    let all_lines = [design.analysis.frequency_min, design.analysis.frequency_max];
    Row::Checked {
        file: file.display().to_string(),
        design: design.name.clone(),
        band_hz: args.band.map_or(all_lines, |band| band.0),
        within_limits: limited.then_some(within),
        enhanced: compared.enhanced_agreement.into(),
        basic: compared.basic_agreement.into(),
    }
}

fn write_table(out: &mut impl Write, rows: &[Row], args: &Args) -> io::Result<()> {
    let stem = |file: &str| Path::new(file).file_stem().map_or_else(|| file.into(), |stem| stem.display().to_string());
    let mut heads = vec!["design", "enhanced\nlimit Hz", "RMS\ndB", "max\ndB", "at\nHz", "FRAC"];
    heads.extend(["basic\nlimit Hz", "RMS\ndB"]);
    let limited = args.max_rms_db.is_some() || args.min_limit_hz.is_some();
    if limited {
        heads.push("within\nlimits");
    }
    let mut table = Table::with_heads(heads.into_iter().map(str::to_owned).collect()).widest_name(20);
    for row in rows {
        match row {
            Row::Checked { file, enhanced, basic, within_limits, .. } => {
                let mut cells = vec![
                    stem(file),
                    grouped(enhanced.agreement_limit_hz),
                    format!("{:.2}", enhanced.rms_db),
                    format!("{:.2}", enhanced.max_db),
                    grouped(enhanced.max_at_hz),
                    format!("{:.3}", enhanced.frac),
                    grouped(basic.agreement_limit_hz),
                    format!("{:.2}", basic.rms_db),
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
    for row in rows {
        if let Row::Failed { file, error } = row {
            write!(out, "\n{}:", printable(file))?;
            for line in error.trim_end().lines() {
                write!(out, "\n  {}", printable(line))?;
            }
            writeln!(out)?;
        }
    }
    Ok(())
}
