//! The spectra in sight, as a document.

use std::sync::Arc;

use num_complex::Complex64;

use crate::document::{Column, Curve, Document, Line, Mark, Panel, Panels, Picture, Source, Span, Table, Values};
use crate::model::{ModelKind, RecoveryKind, mesh_frequency_hz};
use crate::number::{grouped, significant};
use crate::text::printable;
use crate::tui::axis::FrequencyAxis;
use crate::tui::spectra::{Curve as Known, Findings, Lower, ModelCurves, Quantity, SpectraView, Subject, legend_name};
use crate::tui::traces::range;

/// What is needed to write the spectra as they are now: shared, so that no line is copied.
#[derive(Debug, Clone)]
pub struct ShownSpectra {
    subject: Arc<Subject>,
    models: Vec<Arc<ModelCurves>>,
    findings: Option<Arc<Findings>>,
    quantity: Quantity,
    against: ModelKind,
    lower: Lower,
    axis: FrequencyAxis,
    linear: bool,
    tolerance: f64,
    /// Hz
    cursor: Option<f64>,
    readout: Option<String>,
    is_edited: bool,
}

impl SpectraView {
    /// The curves in sight; nothing where there are none.
    pub fn shown_now(&self) -> Option<ShownSpectra> {
        let (subject, axis) = (self.known.subject.clone()?, self.axis()?);
        let has_curve = |model: &Arc<ModelCurves>| model.curve(self.quantity).is_some();
        let models: Vec<_> = self.shown_kinds().filter_map(|kind| self.known.model(kind).cloned()).collect();
        let models: Vec<_> = models.into_iter().filter(has_curve).collect();
        (!models.is_empty()).then(|| ShownSpectra {
            subject,
            models,
            findings: self.shared_findings().cloned(),
            quantity: self.quantity,
            against: self.against(),
            lower: self.lower,
            axis,
            linear: self.linear_level,
            tolerance: self.tolerance,
            cursor: self.at_hz(),
            readout: self.readout_text(),
            is_edited: self.is_edited(),
        })
    }
}

impl ShownSpectra {
    /// A word for file names.
    pub fn name(&self) -> String {
        let column = self.quantity.column(&self.subject.design);
        column.strip_suffix("_n").or(column.strip_suffix("_um")).unwrap_or(&column).to_owned()
    }

    pub fn document(&self) -> Document {
        let Subject { design, hash, .. } = &*self.subject;
        let name = printable(&design.name);
        let name = if self.is_edited { format!("{name} (unsaved edits)") } else { name.into_owned() };
        Document {
            title: self.quantity.title(design),
            sources: vec![Source { role: "design".into(), name, hash: hash.clone() }],
            notes: self.notes(),
            picture: Some(Picture::Panels(self.picture())),
            tables: self.findings.as_deref().map_or_else(Vec::new, |findings| vec![bands(findings), peaks(findings)]),
            data: self.data(),
        }
    }

    fn notes(&self) -> Vec<String> {
        let mut notes = vec![format!(
            "Lines of the analysis from {} to {} Hz. Further lines near resonances are drawn and not written.",
            grouped(self.axis.min),
            grouped(self.axis.max)
        )];
        let is_recovered = |model: &Arc<ModelCurves>| model.recovery == RecoveryKind::StaticShapes;
        if matches!(self.quantity, Quantity::Bearing { .. }) && self.models.iter().any(is_recovered) {
            notes.push("Bearing forces of the lumped models are recovered by static shapes.".into());
        }
        notes.extend(mesh_frequency_hz(&self.subject.design).map(|hz| {
            format!("Mesh frequency at the speed of the design: {} Hz; it and its harmonics are marked 1\u{d7}, 2\u{d7} and so on.", grouped(hz))
        }));
        notes.extend(self.readout.as_ref().map(|readout| format!("At the cursor: {readout}.")));
        for (at, band) in self.findings.iter().flat_map(|findings| findings.bands.iter().enumerate()) {
            if !band.sentences.is_empty() {
                notes.push(format!("Band {}: {}", at + 1, band.sentences.join(" ")));
            }
        }
        notes
    }

    /// The lines of the analysis that are in sight.
    fn lines(&self) -> std::ops::Range<usize> {
        let lines = &self.subject.frequency_hz;
        let from = lines.partition_point(|hz| *hz < self.axis.min);
        from..lines.partition_point(|hz| *hz <= self.axis.max).max(from)
    }

    fn data(&self) -> Table {
        let Subject { design, frequency_hz, .. } = &*self.subject;
        let lines = self.lines();
        let mut columns =
            vec![Column::new("frequency_hz", "frequency, Hz", Values::Numbers(frequency_hz[lines.clone()].to_vec()))];
        let below = (self.lower == Lower::Beside).then(|| self.quantity.beside());
        for quantity in std::iter::once(self.quantity).chain(below) {
            let key = quantity.column(design);
            for model in &self.models {
                let Some(curve) = model.curve(quantity) else { continue };
                let part = |end: &str, of: fn(&Complex64) -> f64| {
                    let key = format!("{}_{key}{end}", model.kind.name());
                    Column::new(key.clone(), key, Values::Numbers(curve.lines[lines.clone()].iter().map(of).collect()))
                };
                columns.push(part(if quantity.has_phase() { "_re" } else { "" }, |value| value.re));
                if quantity.has_phase() {
                    columns.push(part("_im", |value| value.im));
                }
            }
        }
        Table { caption: self.quantity.title(design), columns }
    }

    fn picture(&self) -> Panels {
        let spans = self.findings.iter().flat_map(|findings| &findings.bands).map(|found| {
            let band = &found.band;
            let (from, to) = (grouped(band.from_hz), grouped(band.to_hz));
            let text = format!("{from} to {to} Hz, {:+.1} dB at {} Hz", band.worst_db, grouped(band.worst_at_hz));
            Span { from_hz: band.from_hz, to_hz: band.to_hz, text }
        });
        let peaks = self.findings.iter().flat_map(|findings| findings.peaks.iter().enumerate());
        let peaks =
            peaks.filter_map(|(at, peak)| Some(Mark { hz: peak.pair.fe_hz?, text: (at + 1).to_string(), line: false }));
        let cursor = self.cursor.map(|hz| Mark { hz, text: "cursor".into(), line: true });
        let mesh = mesh_frequency_hz(&self.subject.design);
        let harmonics = mesh.into_iter().flat_map(|hz| (1..=9).map(move |order| (f64::from(order), hz)));
        let harmonics =
            harmonics.map(|(order, hz)| Mark { hz: order * hz, text: format!("{order}\u{d7}"), line: true });
        let mut marks: Vec<Mark> = peaks.chain(harmonics).chain(cursor).collect();
        marks.sort_by(|a, b| a.hz.total_cmp(&b.hz));
        Panels {
            range: (self.axis.min, self.axis.max),
            log: self.axis.log,
            panels: vec![self.upper(self.quantity), self.below()],
            bands: spans.collect(),
            band: format!("{} off by more than {} dB, line by line", legend_name(self.against), self.tolerance),
            marks,
        }
    }

    fn upper(&self, quantity: Quantity) -> Panel {
        let unit = quantity.unit(false);
        let value = |db: f64| if self.linear { 10_f64.powf(db / 20.0) } else { db };
        let curve = |model: &Arc<ModelCurves>, known: &Known| {
            let points = model.drawn_hz.iter().zip(&known.drawn_db);
            self.curve(model.kind, points.map(|(hz, db)| (*hz, value(*db))))
        };
        let curves = self.models.iter().filter_map(|model| Some(curve(model, model.curve(quantity)?))).collect();
        let label = quantity.title(&self.subject.design);
        let label = if self.linear { format!("{label}, {unit}") } else { format!("{label}, dB re 1 {unit}") };
        self.panel(label, curves, self.linear)
    }

    /// With the range of what is in it.
    fn panel(&self, label: String, curves: Vec<Curve>, linear: bool) -> Panel {
        let values: Vec<f64> = curves
            .iter()
            .flat_map(|curve: &Curve| &curve.points)
            .filter(|(hz, _)| (self.axis.min..=self.axis.max).contains(hz))
            .map(|(_, value)| *value)
            .collect();
        let highest = values.iter().copied().filter(|value| value.is_finite()).fold(0.0, f64::max);
        let range = if linear { (0.0, if highest > 0.0 { 1.05 * highest } else { 1.0 }) } else { range(&[&values]) };
        Panel { label, range, curves, levels: Vec::new() }
    }

    fn below(&self) -> Panel {
        let lines = &self.subject.frequency_hz;
        let known = || self.models.iter().filter_map(|model| Some((model, model.curve(self.quantity)?)));
        match self.lower {
            Lower::Beside => self.upper(self.quantity.beside()),
            Lower::SixthOctaves => {
                let steps = |(model, known): (&Arc<ModelCurves>, &Arc<Known>)| {
                    let ends = known.bands.iter().flat_map(|&(low, high, level)| [(low, level), (high, level)]);
                    self.curve(model.kind, ends)
                };
                self.panel("Sixth-octave levels, dB".into(), known().map(steps).collect(), false)
            }
            Lower::Phase => {
                let phase = |(model, known): (&Arc<ModelCurves>, &Arc<Known>)| {
                    let phases = known.lines.iter().map(|value| value.arg().to_degrees());
                    self.curve(model.kind, lines.iter().copied().zip(around(phases)))
                };
                let curves = if self.quantity.has_phase() { known().map(phase).collect() } else { Vec::new() };
                Panel { label: "Phase, degrees".into(), range: (-180.0, 180.0), curves, levels: vec![0.0] }
            }
            Lower::Difference => {
                let fe = known().find(|(model, _)| model.kind == ModelKind::Fe);
                let other = known().find(|(model, _)| model.kind == self.against);
                let curve = fe.zip(other).map(|((_, fe), (model, other))| {
                    let all =
                        other.lines.iter().zip(&fe.lines).map(|(other, fe)| 20.0 * (other.norm() / fe.norm()).log10());
                    self.curve(model.kind, lines.iter().copied().zip(all))
                });
                let points = curve.iter().flat_map(|curve| &curve.points).map(|(_, value)| value.abs());
                let largest = points.filter(|value| value.is_finite()).fold(self.tolerance, f64::max);
                let limit = [10.0, 20.0, 40.0].into_iter().find(|limit| *limit >= largest).unwrap_or(40.0);
                Panel {
                    label: format!(
                        "{} over FE, dB (tolerance {} dB, line by line)",
                        legend_name(self.against),
                        self.tolerance
                    ),
                    range: (-limit, limit),
                    curves: curve.into_iter().collect(),
                    levels: vec![0.0, self.tolerance, -self.tolerance],
                }
            }
        }
    }

    /// The points in sight, and one more on either side.
    fn curve(&self, kind: ModelKind, points: impl Iterator<Item = (f64, f64)>) -> Curve {
        let all: Vec<(f64, f64)> = points.collect();
        let from = all.partition_point(|(hz, _)| *hz < self.axis.min);
        let to = all.partition_point(|(hz, _)| *hz <= self.axis.max).max(from);
        let line = match kind {
            ModelKind::Fe => Line::Fe,
            ModelKind::Enhanced => Line::Enhanced,
            ModelKind::Basic => Line::Basic,
            ModelKind::Reduced(_) => Line::Reduced,
        };
        Curve { line, name: legend_name(kind), points: all[from..to].to_vec() }
    }
}

/// Degrees; where the phase goes round from one line to the next the curve is parted.
fn around(phases: impl Iterator<Item = f64>) -> impl Iterator<Item = f64> {
    let mut before = f64::NAN;
    phases.map(move |phase| {
        let goes_round = (phase - before).abs() > 180.0;
        before = phase;
        if goes_round { f64::NAN } else { phase }
    })
}

fn bands(findings: &Findings) -> Table {
    let all = &findings.bands;
    let figures =
        |figure: &dyn Fn(&crate::tui::spectra::Band) -> String| Values::Figures(all.iter().map(figure).collect());
    let texts = |text: &dyn Fn(&crate::tui::spectra::Band) -> String| Values::Texts(all.iter().map(text).collect());
    let numbers = (1..=all.len()).map(|at| at.to_string()).collect();
    Table {
        caption: format!(
            "Bands in which {} is more than {} dB off, line by line",
            legend_name(findings.against),
            findings.tolerance
        ),
        columns: vec![
            Column::new("band", "band", Values::Texts(numbers)),
            Column::new("from_hz", "from, Hz", figures(&|one| grouped(one.band.from_hz))),
            Column::new("to_hz", "to, Hz", figures(&|one| grouped(one.band.to_hz))),
            Column::new("worst_db", "worst, dB", figures(&|one| format!("{:+.1}", one.band.worst_db))),
            Column::new("worst_at_hz", "at, Hz", figures(&|one| grouped(one.band.worst_at_hz))),
            Column::new(
                "mode_hz",
                "mode, Hz",
                figures(&|one| one.mode.as_ref().map_or(String::new(), |(hz, _)| grouped(*hz))),
            ),
            Column::new(
                "mode",
                "mode held responsible",
                texts(&|one| one.mode.as_ref().map_or(String::new(), |(_, name)| name.clone())),
            ),
        ],
    }
}

fn peaks(findings: &Findings) -> Table {
    let all = &findings.peaks;
    let numbers = |value: &dyn Fn(&crate::agreement::PeakPair) -> Option<String>| {
        Values::Figures(all.iter().map(|one| value(&one.pair).unwrap_or_default()).collect())
    };
    let hz = |hz: Option<f64>| hz.map(|hz| significant(hz, 5));
    let signed = |value: Option<f64>| value.map(|value| format!("{value:+.2}"));
    let against = legend_name(findings.against);
    let beside = findings.beside.map_or_else(|| "other, Hz".into(), |kind| format!("{}, Hz", legend_name(kind)));
    Table {
        caption: format!(
            "Peaks of FE and {against}, paired by frequency within {:.0} %; a dash: no partner",
            100.0 * crate::agreement::FARTHEST_PEAK
        ),
        columns: vec![
            Column::new("peak", "peak", Values::Texts((1..=all.len()).map(|at| at.to_string()).collect())),
            Column::new("fe_hz", "FE, Hz", numbers(&|pair| hz(pair.fe_hz))),
            Column::new("lumped_hz", format!("{against}, Hz"), numbers(&|pair| hz(pair.lumped_hz))),
            Column::new(
                "beside_hz",
                beside,
                Values::Figures(all.iter().map(|one| hz(one.beside_hz).unwrap_or_default()).collect()),
            ),
            Column::new("shift_percent", "shift, %", numbers(&|pair| signed(pair.shift_percent))),
            Column::new("height_db", "height, dB", numbers(&|pair| signed(pair.height_db))),
            Column::new(
                "mode",
                "mode",
                Values::Texts(all.iter().map(|one| one.mode.clone().unwrap_or_default()).collect()),
            ),
        ],
    }
}
