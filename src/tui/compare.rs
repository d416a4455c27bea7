//! Two designs beside one another: what differs, and how both behave.

use std::ops::ControlFlow;
use std::path::PathBuf;

use super::action::Action;
use super::app::{App, Scroll};
use super::axis::FrequencyAxis;
use super::backend::Backend;
use super::keymap::Mode;
use super::library::Row;
use super::message::Effect;
use super::solving::{Ticket, guarded};
use super::traces::{Envelope, envelope, levels, range};
use super::widgets::findings::sentence;
use crate::agreement::Agreement;
use crate::comparison::Comparison;
use crate::design::{self, Design, Difference, FrequencySpacing};

/// Two files to be compared: the marked one, and the selected one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CompareJob {
    pub ticket: Ticket,
    pub paths: [PathBuf; 2],
    /// What is to be compared in place of a file with edits that are not saved.
    pub unsaved: [Option<String>; 2],
}

/// The result.
#[derive(Debug, Clone, PartialEq)]
pub struct Compared {
    /// Why there is none, where a file cannot be read.
    pub differences: Result<Vec<Difference>, String>,
    pub sides: [Result<ComparedSide, String>; 2],
    /// RMS of the difference of the two finite element spectra, dB, where their lines are the same
    pub fe_rms_db: Option<f64>,
}

/// One of the two.
#[derive(Debug, Clone, PartialEq)]
pub struct ComparedSide {
    /// Of the design; nothing where there is no file
    pub hash: Option<String>,
    /// Hz
    pub frequency: Vec<f64>,
    /// |F_m| of the finite element model, dB re 1 N
    pub fe: Vec<f64>,
    pub log: bool,
    pub enhanced: Agreement,
    pub basic: Agreement,
}

/// The view.
#[derive(Debug)]
pub struct CompareView {
    pub ticket: Ticket,
    /// Names of the files, safe to show, and whether their edits count that are not saved.
    pub names: [String; 2],
    paths: [PathBuf; 2],
    pub result: Option<Compared>,
    pub scroll: Scroll,
    columns: Option<Overlaid>,
}

/// Both spectra at one width, over both their frequencies.
#[derive(Debug)]
pub struct Overlaid {
    pub axis: FrequencyAxis,
    pub range: (f64, f64),
    /// Nothing where a design has no solution.
    pub curves: [Envelope; 2],
    size: (usize, usize),
}

/// Reads, solves and compares two designs; nothing where that is no longer wanted. A panic in the backend becomes the
/// message of its side.
pub fn perform(job: &CompareJob, backend: &dyn Backend, wanted: &dyn Fn() -> bool) -> Option<Compared> {
    let mut observer = |_| if wanted() { ControlFlow::Continue(()) } else { ControlFlow::Break(()) };
    let unexpected = |panic: String| format!("failed unexpectedly: {panic}");
    let mut solved = |side: usize| {
        let solve = || -> Result<(Comparison, bool, Option<String>), String> {
            let (design, hash) = job.design(side, backend)?;
            let log = design.analysis.frequency_spacing == FrequencySpacing::Log;
            Ok((backend.compare(&design, &mut observer).map_err(|error| error.to_string())?, log, hash))
        };
        wanted().then(|| guarded(solve).unwrap_or_else(|panic| Err(unexpected(panic))))
    };
    let solved = [solved(0)?, solved(1)?];
    if !wanted() {
        return None;
    }
    let differences = guarded(|| job.differences(backend)).unwrap_or_else(|panic| Err(unexpected(panic)));
    let fe_rms_db = match &solved {
        [Ok((a, ..)), Ok((b, ..))] => a.fe_rms_db(b),
        _ => None,
    };
    let side = |(comparison, log, hash): (Comparison, bool, Option<String>)| ComparedSide {
        hash,
        fe: levels(&comparison.fe.mesh_force),
        frequency: comparison.frequency_hz,
        log,
        enhanced: comparison.enhanced_agreement,
        basic: comparison.basic_agreement,
    };
    Some(Compared { differences, sides: solved.map(|solved| solved.map(side)), fe_rms_db })
}

impl CompareJob {
    fn design(&self, side: usize, backend: &dyn Backend) -> Result<(Design, Option<String>), String> {
        let Some(text) = &self.unsaved[side] else {
            let loaded = backend.load(&self.paths[side]).map_err(|broken| broken.one_line)?;
            return Ok((loaded.design, loaded.hash));
        };
        let reading = design::read(text);
        let error = reading.errors().next().map(sentence).unwrap_or_default();
        Ok((reading.design.ok_or(error)?, Some(design::hash(text.as_bytes()))))
    }

    fn differences(&self, backend: &dyn Backend) -> Result<Vec<Difference>, String> {
        let [a, b] = &self.paths;
        if self.unsaved.iter().all(Option::is_none) {
            return backend.differences(a, b);
        }
        let text = |side: usize| match &self.unsaved[side] {
            Some(text) => Ok(text.clone()),
            None => backend.read(&self.paths[side]),
        };
        Ok(design::diff(&text(0)?, &text(1)?))
    }
}

impl CompareView {
    pub fn paths(&self) -> &[PathBuf; 2] {
        &self.paths
    }

    /// Computes the columns if the width has changed.
    pub fn prepare(&mut self, width: usize, dots: usize) -> Option<&Overlaid> {
        let result = self.result.as_ref()?;
        if self.columns.as_ref().is_none_or(|columns| columns.size != (width, dots)) {
            self.columns = Overlaid::new(result, width, dots);
        }
        self.columns.as_ref()
    }
}

impl Overlaid {
    fn new(result: &Compared, width: usize, dots: usize) -> Option<Self> {
        let sides: Vec<&ComparedSide> = result.sides.iter().flatten().filter(|side| !side.fe.is_empty()).collect();
        let ends = |pick: fn(f64, f64) -> f64, of: fn(&[f64]) -> Option<&f64>| {
            sides.iter().filter_map(|side| of(&side.frequency).copied()).reduce(pick)
        };
        let (min, max) = (ends(f64::min, <[f64]>::first)?, ends(f64::max, <[f64]>::last)?);
        let axis = FrequencyAxis { min, max, log: sides.iter().all(|side| side.log) };
        let range = range(&sides.iter().map(|side| side.fe.as_slice()).collect::<Vec<_>>());
        let curve = |side: &Result<ComparedSide, String>| match side {
            Ok(side) => envelope(&side.frequency, &side.fe, &axis, width * dots),
            Err(_) => Vec::new(),
        };
        Some(Self { axis, range, curves: result.sides.each_ref().map(curve), size: (width, dots) })
    }
}

impl App {
    /// The design that another one would be compared with: the marked one, else its parent.
    pub fn compared_with(&self, row: &Row) -> Option<&Row> {
        self.library.marked().filter(|marked| marked.path != row.path).or_else(|| self.library.parent(row))
    }

    pub(super) fn toggle_mark(&mut self) {
        let Some(row) = self.library.selected() else { return };
        let (path, stem) = (row.path.clone(), row.stem.clone());
        if self.library.marked().is_some_and(|marked| marked.path == path) {
            self.library.mark(None);
            return self.say(format!("{stem} is no longer marked"));
        }
        self.library.mark(Some(path));
        let compare = self.keys.names(Mode::Library, true).of(Action::Compare);
        self.say(format!("{stem} is marked; select another and press {compare}"));
    }

    pub(super) fn open_compare(&mut self) -> Vec<Effect> {
        let Some(selected) = self.library.selected() else { return Vec::new() };
        let Some(other) = self.compared_with(selected) else {
            let mark = self.keys.names(Mode::Library, true).of(Action::Mark);
            self.complain(format!("mark another design with {mark} first, then come back to this one"));
            return Vec::new();
        };
        let names = [other, selected].map(|row| match self.editors.unsaved_text(&row.path) {
            Some(_) => format!("{} (unsaved edits)", row.stem),
            None => row.stem.clone(),
        });
        let paths = [other.path.clone(), selected.path.clone()];
        let effects = self.compare_now(names, paths);
        self.open(Mode::Compare);
        effects
    }

    fn compare_now(&mut self, names: [String; 2], paths: [PathBuf; 2]) -> Vec<Effect> {
        let ticket = self.ticket();
        let unsaved = paths.each_ref().map(|path| self.editors.unsaved_text(path));
        let scroll = Scroll::default();
        self.compare = Some(CompareView { ticket, names, paths: paths.clone(), result: None, scroll, columns: None });
        vec![Effect::Compare(CompareJob { ticket, paths, unsaved })]
    }

    /// A becomes B, and B becomes A.
    pub(super) fn swap_compared(&mut self) -> Vec<Effect> {
        let Some(view) = &mut self.compare else { return Vec::new() };
        view.names.swap(0, 1);
        view.paths.swap(0, 1);
        let Some(result) = &mut view.result else {
            let (names, paths) = (view.names.clone(), view.paths.clone());
            return self.compare_now(names, paths);
        };
        result.sides.swap(0, 1);
        for difference in result.differences.iter_mut().flatten() {
            difference.swap();
        }
        view.columns = None;
        Vec::new()
    }

    pub(super) fn compared(&mut self, ticket: Ticket, result: Compared) {
        if let Some(view) = self.compare.as_mut().filter(|view| view.ticket == ticket) {
            view.result = Some(result);
        }
    }
}
