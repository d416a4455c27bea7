//! The wide screen: the spectra of a design over the whole window, with a cursor, bands of disagreement and their reasons.
//!
//! The state is what is shown and what came from the background so far ([`Known`]). Whatever is wanted and not known is asked for with a
//! [`SpectraJob`] that carries what is known, so that nothing is computed twice.

mod columns;
mod curve;
mod job;
mod keys;
mod quantity;
mod readout;
mod solve;
mod update;
mod why;

use std::path::PathBuf;
use std::sync::Arc;

pub use columns::{Drawn, Request};
pub use curve::Curve;
pub use job::{Known, Part, SpectraJob, perform};
pub use quantity::Quantity;
pub use readout::{Item, legend_name, level_text, value};
pub use solve::{ModelCurves, Subject};
pub use why::{Band, Findings, Labelled};

use super::app::Scroll;
use super::axis::FrequencyAxis;
use super::solving::Ticket;
use crate::design::FrequencySpacing;
use crate::model::{ModelKind, mesh_frequency_hz, pinion_speed_rpm};

/// Modes a rotor of the reduced model, at first and at most.
const FIRST_REDUCED: usize = 3;
const MOST_REDUCED: usize = 99;
/// Tolerances, dB
const TOLERANCES: (f64, f64) = (1.0, 10.0);

/// What the lower panel shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lower {
    Difference,
    Phase,
    /// The other quantity of the mesh
    Beside,
    SixthOctaves,
}

impl Lower {
    const ALL: [Self; 4] = [Self::Difference, Self::Phase, Self::Beside, Self::SixthOctaves];
}

/// What is listed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Listed {
    Bands,
    Peaks,
    Nothing,
}

/// Where the list is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ListPlace {
    WithPlots,
    /// There is no room for both
    Hidden,
    /// In place of the plots
    Alone,
}

/// The view.
#[derive(Debug)]
pub struct SpectraView {
    pub ticket: Ticket,
    /// Safe to show
    pub name: String,
    pub path: PathBuf,
    text: Option<String>,
    /// What is shown is not what the file holds.
    is_edited: bool,
    pub known: Known,
    /// How far the model is that is being solved, from 0 to 1; nothing where all is there.
    pub pending: Option<f64>,
    /// Why there is nothing, or why a model is missing.
    pub failure: Option<String>,
    pub missing: Vec<ModelKind>,
    pub quantity: Quantity,
    /// FE, enhanced, basic, reduced
    pub shown: [bool; 4],
    /// Fixed-interface modes a rotor
    pub reduced: usize,
    /// Place of the model that is held against FE: 1 to 3
    against: usize,
    /// dB
    pub tolerance: f64,
    pub log: bool,
    pub linear_level: bool,
    pub lower: Lower,
    pub listed: Listed,
    /// What is in sight, Hz; all of it before anything is known
    window: Option<(f64, f64)>,
    /// A line of the analysis
    pub cursor: usize,
    pub scroll: Scroll,
    list_place: ListPlace,
    /// Columns of the plot that was drawn last
    width: usize,
    drawn: Option<Drawn>,
}

impl SpectraView {
    fn new(ticket: Ticket, name: String, path: PathBuf, text: Option<String>, is_edited: bool) -> Self {
        Self {
            ticket,
            name,
            path,
            text,
            is_edited,
            known: Known::default(),
            pending: Some(0.0),
            failure: None,
            missing: Vec::new(),
            quantity: Quantity::MeshForce,
            shown: [true, true, true, false],
            reduced: FIRST_REDUCED,
            against: 1,
            tolerance: crate::agreement::TOLERANCE_DB,
            log: false,
            linear_level: false,
            lower: Lower::Difference,
            listed: Listed::Bands,
            window: None,
            cursor: 0,
            scroll: Scroll::default(),
            list_place: ListPlace::WithPlots,
            width: 0,
            drawn: None,
        }
    }

    pub fn is_edited(&self) -> bool {
        self.is_edited
    }

    /// All four models.
    pub fn kinds(&self) -> [ModelKind; 4] {
        [ModelKind::Fe, ModelKind::Enhanced, ModelKind::Basic, ModelKind::Reduced(self.reduced)]
    }

    /// Those whose curves are wanted.
    pub fn shown_kinds(&self) -> impl Iterator<Item = ModelKind> + use<> {
        self.kinds().into_iter().zip(self.shown).filter(|(_, shown)| *shown).map(|(kind, _)| kind)
    }

    /// The model that is held against finite elements.
    pub fn against(&self) -> ModelKind {
        self.kinds()[self.against]
    }

    /// A quantity's curve of a model, if it is there.
    pub fn curve(&self, kind: ModelKind, quantity: Quantity) -> Option<&Curve> {
        self.known.model(kind)?.curve(quantity).map(|curve| &**curve)
    }

    /// Bands and peaks of what is shown.
    pub fn findings(&self) -> Option<&Findings> {
        self.shared_findings().map(|findings| &**findings)
    }

    /// Those of another model, quantity or tolerance are not those of what is shown.
    pub(super) fn shared_findings(&self) -> Option<&Arc<Findings>> {
        let is_same = |findings: &&Arc<Findings>| {
            findings.against == self.against()
                && findings.quantity == self.quantity
                && findings.tolerance.to_bits() == self.tolerance.to_bits()
        };
        self.known.findings.as_ref().filter(is_same)
    }

    /// Lines of the analysis, Hz.
    pub fn lines(&self) -> &[f64] {
        self.known.subject.as_ref().map_or(&[], |subject| &subject.frequency_hz)
    }

    /// First and last line, Hz.
    fn ends(&self) -> Option<(f64, f64)> {
        let lines = self.lines();
        Some((*lines.first()?, *lines.last()?))
    }

    /// What is in sight.
    pub fn axis(&self) -> Option<FrequencyAxis> {
        let (min, max) = self.window.or_else(|| self.ends())?;
        Some(FrequencyAxis { min, max, log: self.log && min > 0.0 })
    }

    /// Where the cursor is, Hz.
    pub fn at_hz(&self) -> Option<f64> {
        self.lines().get(self.cursor).copied()
    }

    /// The band that the cursor is in, or the one next to it.
    pub fn band_near(&self) -> Option<usize> {
        let hz = self.at_hz()?;
        let bands = &self.findings()?.bands;
        let distance = |band: &Band| (band.band.from_hz - hz).max(hz - band.band.to_hz).max(0.0);
        (0..bands.len()).min_by(|&a, &b| distance(&bands[a]).total_cmp(&distance(&bands[b])))
    }

    /// The band that the cursor is in.
    pub fn band_under(&self) -> Option<usize> {
        let (hz, at) = (self.at_hz()?, self.band_near()?);
        let band = self.findings()?.bands[at].band;
        (band.from_hz..=band.to_hz).contains(&hz).then_some(at)
    }

    /// Whether the list is shown in place of the plots.
    pub fn is_list_alone(&self) -> bool {
        self.list_place == ListPlace::Alone
    }

    /// Whether there is room for plots and list together, which is known when they are drawn.
    pub fn give_list(&mut self, has_room: bool) {
        self.list_place = match (has_room, self.list_place) {
            (true, _) => ListPlace::WithPlots,
            (false, ListPlace::WithPlots) => ListPlace::Hidden,
            (false, place) => place,
        };
    }

    /// The peak that the cursor is on.
    pub fn peak_under(&self) -> Option<&Labelled> {
        let peak = &self.findings()?.peaks[self.peak_at()?];
        (peak.place().to_bits() == self.at_hz()?.to_bits()).then_some(peak)
    }

    /// The mesh frequency, Hz, at the speed (1/min) that the design gives.
    pub fn mesh_frequency(&self) -> Option<(f64, f64)> {
        let design = &self.known.subject.as_ref()?.design;
        let hz = mesh_frequency_hz(design)?;
        Some((hz, pinion_speed_rpm(design, hz)?))
    }

    /// The peak next to the cursor.
    pub fn peak_at(&self) -> Option<usize> {
        let hz = self.at_hz()?;
        let peaks = &self.findings()?.peaks;
        let distance = |at: usize| (peaks[at].place() - hz).abs();
        (0..peaks.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b)))
    }

    /// Takes over what came; what the design is decides how it is shown at first.
    fn take(&mut self, part: &Part) {
        self.known.take(part);
        match part {
            Part::Subject(subject) => {
                self.log = subject.design.analysis.frequency_spacing == FrequencySpacing::Log;
                self.cursor = subject.frequency_hz.len() / 2;
            }
            Part::Model(model) => self.missing.retain(|kind| *kind != model.kind),
            // nothing else is drawn: of a million lines the columns are not found again for each step
            Part::Progress(done) => {
                self.pending = Some(*done);
                return;
            }
            Part::Failed(kind, text) => {
                self.missing.extend(*kind);
                self.failure = Some(text.clone());
                if kind.is_none() {
                    self.pending = None;
                }
            }
            Part::Done => {
                self.pending = None;
                return;
            }
            Part::Modes(_) | Part::Findings(_) => return,
        }
        self.drawn = None;
    }
}
