//! What the explorer shows, written to files.

use std::path::{Path, PathBuf};

use super::report::{now, provenance};
use crate::agreement::TOLERANCE_DB;
use crate::comparison;
use crate::design::{self, Loaded};
use crate::document::{Document, Format};
use crate::model::ModelKind;
use crate::moment;
use crate::report::csv::{self, Columns};
use crate::report::html::{Entry, page};
use crate::report::{Study, document, svg};

/// Writes a screen, and says where.
pub fn shown(path: &Path, document: &Document) -> Result<PathBuf, String> {
    let format = Format::of(path).map_err(|error| error.to_string())?;
    let text = document::text(document, format, &today()?).map_err(|error| error.to_string())?;
    write(path, &text)
}

/// Writes the spectra of a design, their picture, or its whole report; `text` counts in place of the file.
pub fn design(path: &Path, file: &Path, text: Option<&str>) -> Result<PathBuf, String> {
    let format = Format::of(path).map_err(|error| error.to_string())?;
    let loaded = match text {
        None => design::load(file).map_err(|error| error.reason())?,
        Some(text) => {
            let reading = design::read(text);
            let error = reading.errors().next().map(|finding| finding.message.clone()).unwrap_or_default();
            let design = reading.design.ok_or(error)?;
            let name = format!("{} (unsaved edits)", file.display());
            Loaded { design, text: text.to_owned(), warnings: reading.findings, name }
        }
    };
    let text = match format {
        Format::Csv => spectra(&loaded)?,
        Format::Svg | Format::Html => {
            let study = Study::new(&loaded.design, TOLERANCE_DB).map_err(|error| error.to_string())?;
            match format {
                Format::Svg => svg::spectra(&loaded.design, &study).file(&provenance(&loaded)),
                _ => page(&[Entry { loaded: &loaded, study: &study }], &today()?),
            }
        }
    };
    write(path, &text)
}

fn spectra(loaded: &Loaded) -> Result<String, String> {
    let comparison = comparison::compare(&loaded.design).map_err(|error| error.to_string())?;
    let models = [
        (ModelKind::Fe, &comparison.fe),
        (ModelKind::Enhanced, &comparison.enhanced),
        (ModelKind::Basic, &comparison.basic),
    ];
    let columns: Vec<Columns<'_>> =
        models.into_iter().map(|(kind, spectrum)| Columns { kind, spectrum, bearings: &[] }).collect();
    let mut out = format!("# {}\r\n", crate::text::printable(&provenance(loaded))).into_bytes();
    csv::spectra(&mut out, &comparison.frequency_hz, &columns).map_err(|error| error.to_string())?;
    String::from_utf8(out).map_err(|error| error.to_string())
}

fn today() -> Result<String, String> {
    Ok(moment::day(now().map_err(|error| error.to_string())?))
}

/// A name without a folder is one in the current folder.
fn write(path: &Path, text: &str) -> Result<PathBuf, String> {
    let path = std::path::absolute(path).map_err(|error| error.to_string())?;
    design::save_new(&path, text).map_err(|error| error.to_string())?;
    Ok(path)
}
