//! `bevelscope report`: studies as one page to read, print and keep, and its pictures as files.

use std::fs;
use std::io::Write;
use std::path::{Component, Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use super::{CommandError, Status, input};
use crate::agreement::TOLERANCE_DB;
use crate::design::{Loaded, SaveError, hash, save, save_new};
use crate::document::{Document, Source};
use crate::moment;
use crate::pair::PairFigures;
use crate::report::Study;
use crate::report::html::{Entry, page};
use crate::report::svg::{levels, pair, side_view, spectra};
use crate::text::printable;

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Design files, or - for standard input
    #[arg(required = true)]
    files: Vec<PathBuf>,
    /// The page to write, or - for standard output; by default the design's name in the current folder, or report.html
    #[arg(short, long, value_name = "OUT.html")]
    output: Option<PathBuf>,
    /// Folder to write the pictures to as well, each as an SVG file; it is made where it is missing
    #[arg(long, value_name = "FOLDER")]
    svg: Option<PathBuf>,
    /// Difference in dB beyond which lines disagree
    #[arg(long, value_name = "DB", default_value_t = TOLERANCE_DB, value_parser = super::check::parse_limit, allow_negative_numbers = true)]
    tolerance: f64,
    /// Overwrite files that are there
    #[arg(long)]
    force: bool,
}

pub fn run(args: &Args, out: &mut impl Write, err: &mut impl Write) -> Result<Status, CommandError> {
    let date = moment::day(now()?);
    let mut solved = Vec::new();
    for file in &args.files {
        let loaded = input::load(file, err)?;
        let rotors = input::rotors(&loaded, err)?;
        let study =
            Study::of_rotors(&loaded.design, rotors, args.tolerance).map_err(|error| input::failed(&loaded, error))?;
        solved.push((loaded, study));
    }
    let entries: Vec<Entry<'_>> = solved.iter().map(|(loaded, study)| Entry { loaded, study }).collect();
    let text = page(&entries, &date);
    let output = args.output.clone().unwrap_or_else(|| default_output(&args.files));
    let page_file = output.clone();
    let to_stdout = output == Path::new("-");
    let mut targets: Vec<(PathBuf, String)> = Vec::new();
    if let Some(folder) = &args.svg {
        for (stem, (loaded, study)) in stems(&args.files).iter().zip(&solved) {
            targets.extend(pictures(folder, stem, loaded, study));
        }
    }
    if !to_stdout {
        targets.push((output, text.clone()));
    }
    check(&targets, args)?;
    wanted_html(&page_file)?;
    if let Some(folder) = &args.svg {
        fs::create_dir_all(folder).map_err(|error| usage(&format!("{}: cannot be made: {error}", folder.display())))?;
    }
    for (path, text) in &targets {
        let saved = if args.force { save(path, text) } else { save_new(path, text) };
        saved.map_err(|error| usage(&error.to_string()))?;
    }
    if to_stdout {
        out.write_all(text.as_bytes())?;
    } else {
        for (path, _) in &targets {
            writeln!(out, "{}", printable(&path.display().to_string()))?;
        }
    }
    Ok(Status::Success)
}

fn usage(text: &str) -> CommandError {
    CommandError::Usage(printable(text).into_owned())
}

/// A page under the name of another kind of file would be opened by the wrong program.
fn wanted_html(output: &Path) -> Result<(), CommandError> {
    let html = |ending: &std::ffi::OsStr| ["html", "htm"].iter().any(|html| ending.eq_ignore_ascii_case(html));
    if output == Path::new("-") || output.is_dir() || output.extension().is_some_and(html) {
        return Ok(());
    }
    Err(usage(&format!(
        "{}: the report is a page: a name that ends in .html or .htm is wanted, or -",
        output.display()
    )))
}

/// Nothing is written where anything would be lost: an existing file without `--force`, a design with it.
fn check(targets: &[(PathBuf, String)], args: &Args) -> Result<(), CommandError> {
    let designs: Vec<PathBuf> = args.files.iter().filter_map(|file| fs::canonicalize(file).ok()).collect();
    for (i, (path, _)) in targets.iter().enumerate() {
        if targets[..i].iter().any(|(other, _)| place_of(other) == place_of(path)) {
            return Err(usage(&format!("{}: the page and a picture cannot have one name", path.display())));
        }
        if fs::canonicalize(path).is_ok_and(|path| designs.contains(&path)) {
            return Err(usage(&format!("{}: this is one of the designs", path.display())));
        }
        if path.is_dir() {
            return Err(usage(&SaveError::Exists(path.clone()).to_string()));
        }
        if !args.force && fs::symlink_metadata(path).is_ok() {
            return Err(usage(&format!("{}; --force overwrites", SaveError::Exists(path.clone()))));
        }
    }
    Ok(())
}

/// A path without links in its folder, which need not be there.
fn place_of(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.into());
    let above = path.ancestors().skip(1).find_map(|above| Some((above, fs::canonicalize(above).ok()?)));
    let Some((above, mut place)) = above else { return path };
    // what is not there yet has no links
    for part in path.strip_prefix(above).into_iter().flat_map(Path::components) {
        match part {
            Component::ParentDir => drop(place.pop()),
            Component::CurDir => {}
            part => place.push(part),
        }
    }
    place
}

fn pictures(folder: &Path, stem: &str, loaded: &Loaded, study: &Study) -> Vec<(PathBuf, String)> {
    let design = &loaded.design;
    let provenance = provenance(loaded);
    let gears = pair(design, &PairFigures::new(design));
    let pictures = [spectra(design, study), levels(design, study), side_view(design)].into_iter().chain(gears);
    pictures.map(|picture| (folder.join(format!("{stem}-{}.svg", picture.name)), picture.file(&provenance))).collect()
}

/// The program, its version, the design and its hash.
pub(super) fn provenance(loaded: &Loaded) -> String {
    let source =
        Source { role: "design".into(), name: loaded.design.name.clone(), hash: Some(hash(loaded.text.as_bytes())) };
    Document { sources: vec![source], ..Document::default() }.provenance()
}

fn default_output(files: &[PathBuf]) -> PathBuf {
    match files {
        [file] if file != Path::new("-") => PathBuf::from(format!("{}.html", stem(file))),
        _ => "report.html".into(),
    }
}

fn stem(file: &Path) -> String {
    if file == Path::new("-") {
        return "standard-input".into();
    }
    file.file_stem().map_or_else(|| "design".into(), |stem| printable(&stem.to_string_lossy()).into_owned())
}

/// A name for the pictures of each file; of several with one name the later ones are numbered.
fn stems(files: &[PathBuf]) -> Vec<String> {
    let mut stems: Vec<String> = Vec::new();
    for file in files {
        let stem = stem(file);
        let numbered = (2..).map(|number| format!("{stem}-{number}"));
        let free = std::iter::once(stem.clone()).chain(numbered).find(|name| !stems.contains(name));
        stems.extend(free);
    }
    stems
}

/// The time of the report: now, or what `SOURCE_DATE_EPOCH` says (reproducible-builds.org), in seconds since 1970.
pub(super) fn now() -> Result<SystemTime, CommandError> {
    /// The end of the year 9999
    const LAST: u64 = 253_402_300_799;
    let Some(seconds) = std::env::var_os("SOURCE_DATE_EPOCH") else { return Ok(SystemTime::now()) };
    let seconds = seconds.to_str().and_then(|text| text.parse().ok()).filter(|seconds| *seconds <= LAST);
    let wanted = || usage("SOURCE_DATE_EPOCH: wanted a whole number of seconds since 1970");
    Ok(UNIX_EPOCH + Duration::from_secs(seconds.ok_or_else(wanted)?))
}
