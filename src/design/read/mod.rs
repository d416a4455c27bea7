//! From the text of a design file to a [`Design`], or to everything that is wrong with it.

mod bearing;
mod locate;
mod nearest;
mod scalar;
mod slips;
mod table;
mod written;

pub(super) use locate::locate;
pub(crate) use nearest::did_you_mean;
pub(super) use nearest::listed;
pub(super) use table::{FromFile, FromTable, TableReader};

use toml::de::{DeTable, DeValue};

use super::check;
use super::finding::{Collector, Finding, Severity, is_error};
use super::key_path::KeyPath;
use super::model::{Design, FORMAT};
use super::schema::ROOT;

/// A value of the file with its place in the text.
pub(super) type Value<'r> = toml::Spanned<DeValue<'r>>;

/// What reading a text gave.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// There, and checked, exactly if no finding is an error.
    pub design: Option<Design>,
    /// All errors and warnings, in the order of the text.
    pub findings: Vec<Finding>,
}

impl Reading {
    pub fn errors(&self) -> impl Iterator<Item = &Finding> {
        self.findings.iter().filter(|finding| is_error(finding))
    }

    pub fn warnings(&self) -> impl Iterator<Item = &Finding> {
        self.findings.iter().filter(|finding| !is_error(finding))
    }
}

/// Reads the text of a design file and checks all that needs no mechanics. Everything wrong is found in one pass: a value
/// that could not be read stands in as not-a-number, which no later check objects to.
pub fn read(text: &str) -> Reading {
    let findings = Collector::default();
    let design = read_into(text, &findings);
    let findings = findings.finish();
    let design = design.filter(|_| !findings.iter().any(is_error));
    Reading { design, findings }
}

fn read_into(text: &str, findings: &Collector) -> Option<Design> {
    let (document, errors) = DeTable::parse_recoverable(text);
    if !errors.is_empty() {
        report_syntax(text, &errors, findings);
        return None;
    }
    let root = document.get_ref();
    if is_newer(root, findings) {
        return None;
    }
    let mut reader = TableReader::root(root, text, findings);
    // fills no field of the design, but must be there
    ROOT.field("format").and_then(|field| reader.whole(field));
    let mut design = Design::from_table(&mut reader);
    reader.finish();
    check::check(&mut design, root, findings);
    Some(design)
}

/// One finding a line: after the first error of a line the parser is guessing.
fn report_syntax(text: &str, errors: &[toml::de::Error], findings: &Collector) {
    let mut last_end_of_line = None;
    for error in errors {
        let span = error.span().unwrap_or(0..0);
        let start = span.start.min(text.len());
        let end_of_line = text.as_bytes()[start..].iter().position(|byte| *byte == b'\n').map(|line| start + line);
        if last_end_of_line != Some(end_of_line) {
            last_end_of_line = Some(end_of_line);
            let before = text.get(..start).unwrap_or_default();
            let line_start = before.rfind('\n').map_or(0, |at| at + 1);
            let line = text.get(line_start..end_of_line.unwrap_or(text.len())).unwrap_or_default();
            findings.error(
                &KeyPath::root(),
                span,
                format!("not TOML: {}", error.message()),
                slips::hint(line).map(Into::into),
            );
        }
        if findings.is_full() {
            return;
        }
    }
}

/// A newer file may hold anything, so that is all there is to say about it.
fn is_newer(root: &DeTable<'_>, findings: &Collector) -> bool {
    let Some(value) = root.get("format") else { return false };
    let newer = scalar::as_number(value.get_ref()).is_ok_and(|number| number > FORMAT as f64);
    if newer {
        let message = format!("written by a newer version: this one reads format {FORMAT}");
        findings.push(Finding {
            severity: Severity::Error,
            key_path: KeyPath::root().key("format"),
            span: Some(value.span()),
            message,
            hint: Some("update bevelscope to read this file".into()),
        });
    }
    newer
}
