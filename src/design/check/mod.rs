//! Checks over several values of a design. None of them objects to the not-a-number that stands in for a value that could
//! not be read, so they run on whatever was read.

mod geometry;
mod matrix;
mod mesh;
mod operating;
mod rolling;
mod rotor;
mod stations;
mod supports;

use toml::de::DeTable;

use super::finding::{Collector, Finding, Severity};
use super::key_path::KeyPath;
use super::model::{Analysis, Design};
use super::read::locate;

/// Where checks report to.
struct Checker<'a> {
    root: &'a DeTable<'a>,
    findings: &'a Collector,
}

impl Checker<'_> {
    fn error(&self, path: &KeyPath, message: impl Into<String>, hint: Option<&str>) {
        self.report(Severity::Error, path, message.into(), hint);
    }

    fn warn(&self, path: &KeyPath, message: impl Into<String>, hint: Option<&str>) {
        self.report(Severity::Warning, path, message.into(), hint);
    }

    fn report(&self, severity: Severity, path: &KeyPath, message: String, hint: Option<&str>) {
        let (span, hint) = (Some(locate(self.root, path)), hint.map(String::from));
        self.findings.push(Finding { severity, key_path: path.clone(), span, message, hint });
    }
}

/// Checks the design, and brings unit vectors and symmetric matrices to full precision.
pub(super) fn check(design: &mut Design, root: &DeTable<'_>, findings: &Collector) {
    let checker = Checker { root, findings };
    let top = KeyPath::root();
    analysis(&design.analysis, &top.key("analysis"), &checker);
    rotor::check(&mut design.pinion, &design.materials, &top.key("pinion"), &checker);
    rotor::check(&mut design.gear, &design.materials, &top.key("gear"), &checker);
    geometry::check(design, &top.key("mesh").key("geometry"), &checker);
    mesh::check(design, &top.key("mesh"), &checker);
    operating::check(design, &top, &checker);
}

fn analysis(analysis: &Analysis, path: &KeyPath, checker: &Checker<'_>) {
    let (min, max) = (analysis.frequency_min, analysis.frequency_max);
    if max <= min {
        let message = format!("must be greater than frequency_min_hz, {min:?} Hz; it is {max:?} Hz");
        checker.error(&path.key("frequency_max_hz"), message, None);
    }
}
