//! What is drawn, column by column, at one width and one window.

use crate::model::ModelKind;
use crate::tui::axis::FrequencyAxis;
use crate::tui::traces::{Envelope, envelope, range};

use super::{Lower, ModelCurves, Quantity, SpectraView};

/// What the columns are for: they are computed again where it differs.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    axis: FrequencyAxis,
    width: usize,
    dots: usize,
    quantity: Quantity,
    linear: bool,
    lower: Lower,
    kinds: Vec<ModelKind>,
    against: ModelKind,
}

/// The columns of both panels.
#[derive(Debug)]
pub struct Drawn {
    request: Request,
    pub axis: FrequencyAxis,
    /// Lowest and highest value of the upper panel: dB, or the quantity's unit
    pub range: (f64, f64),
    pub curves: Vec<(ModelKind, Envelope)>,
    /// The same of the lower panel: dB, or degrees
    pub lower_range: (f64, f64),
    pub lower: Vec<(ModelKind, Envelope)>,
    /// Of the model that is held against FE, in columns of characters: largest difference, dB
    pub difference: Vec<Option<f64>>,
}

impl SpectraView {
    /// The columns at a width; nothing before a line is known.
    pub fn prepare(&mut self, width: usize, dots: usize) -> Option<&Drawn> {
        self.width = width;
        let request = Request {
            axis: self.axis()?,
            width,
            dots,
            quantity: self.quantity,
            linear: self.linear_level,
            lower: self.lower,
            kinds: self.shown_kinds().collect(),
            against: self.against(),
        };
        if self.drawn.as_ref().is_none_or(|drawn| drawn.request != request) {
            self.drawn = Some(Drawn::new(self, request));
        }
        self.drawn.as_ref()
    }
}

/// The values between two frequencies with one more on either side, so that curves go to the border.
fn in_sight<'a>(hz: &'a [f64], values: &'a [f64], axis: &FrequencyAxis) -> (&'a [f64], &'a [f64]) {
    let from = hz.partition_point(|f| *f < axis.min).saturating_sub(1);
    let to = (hz.partition_point(|f| *f <= axis.max) + 1).min(hz.len()).min(values.len());
    if from >= to { (&[], &[]) } else { (&hz[from..to], &values[from..to]) }
}

/// As [`envelope`], also for points beyond the axis: those are moved to the border along the line.
fn columns(hz: &[f64], values: &[f64], axis: &FrequencyAxis, count: usize) -> Envelope {
    let (hz, values) = in_sight(hz, values, axis);
    let (mut hz, mut values) = (hz.to_vec(), values.to_vec());
    let last = hz.len().saturating_sub(1);
    if last > 0 {
        for (outside, inside, border) in [(0, 1, axis.min), (last, last - 1, axis.max)] {
            let is_beyond = if outside == 0 { hz[outside] < border } else { hz[outside] > border };
            if is_beyond {
                let part = (border - hz[outside]) / (hz[inside] - hz[outside]);
                values[outside] += (values[inside] - values[outside]) * part;
                hz[outside] = border;
            }
        }
    }
    envelope(&hz, &values, axis, count)
}

/// The value of the line next to the middle of each column: between two lines a phase that goes round has no line to follow.
fn samples(hz: &[f64], value: impl Fn(usize) -> f64, axis: &FrequencyAxis, count: usize) -> Envelope {
    let sample = |column: usize| {
        let middle = axis.frequency((column as f64 + 0.5) / count as f64);
        let after = hz.partition_point(|f| *f < middle).min(hz.len().saturating_sub(1));
        let before = after.saturating_sub(1);
        let nearer = if middle - hz.get(before)? < hz.get(after)? - middle { before } else { after };
        let value = value(nearer);
        value.is_finite().then_some((value, value))
    };
    (0..count).map(sample).collect()
}

/// Levels of bands as steps.
fn steps(bands: &[(f64, f64, f64)], axis: &FrequencyAxis, count: usize) -> Envelope {
    let ends = bands.iter().flat_map(|&(low, high, level)| [(low, level), (high * (1.0 - 1e-9), level)]);
    let (hz, levels): (Vec<f64>, Vec<f64>) = ends.unzip();
    columns(&hz, &levels, axis, count)
}

fn to_linear(envelope: Envelope) -> Envelope {
    let value = |db: f64| 10_f64.powf(db / 20.0);
    envelope.into_iter().map(|column| column.map(|(low, high)| (value(low), value(high)))).collect()
}

/// Round bounds of what is in sight.
fn bounds(curves: &[(ModelKind, Envelope)], linear: bool) -> (f64, f64) {
    let values: Vec<f64> =
        curves.iter().flat_map(|(_, curve)| curve.iter().flatten()).flat_map(|(l, h)| [*l, *h]).collect();
    if !linear {
        return range(&[&values]);
    }
    let highest = values.into_iter().filter(|value| value.is_finite()).fold(0.0, f64::max);
    (0.0, if highest > 0.0 { highest * 1.05 } else { 1.0 })
}

impl Drawn {
    fn new(view: &SpectraView, request: Request) -> Self {
        let Request { axis, width, dots, quantity, linear, lower, .. } = request;
        let models: Vec<&ModelCurves> =
            request.kinds.iter().filter_map(|kind| view.known.model(*kind)).map(|model| &**model).collect();
        let count = width * dots;
        let level = |model: &ModelCurves, quantity: Quantity| {
            let curve = model.curve(quantity)?;
            let found = columns(&model.drawn_hz, &curve.drawn_db, &axis, count);
            Some((model.kind, if linear { to_linear(found) } else { found }))
        };
        let curves: Vec<_> = models.iter().filter_map(|model| level(model, quantity)).collect();
        let lines = view.lines();
        let below = |model: &&ModelCurves| match lower {
            Lower::Difference => None,
            Lower::Phase => {
                let values = &model.curve(quantity).filter(|_| quantity.has_phase())?.lines;
                Some((model.kind, samples(lines, |at| values[at].arg().to_degrees(), &axis, count)))
            }
            Lower::Beside => level(model, quantity.beside()),
            Lower::SixthOctaves => Some((model.kind, steps(&model.curve(quantity)?.bands, &axis, count))),
        };
        let lower_curves: Vec<_> = models.iter().filter_map(below).collect();
        let lower_range = match lower {
            Lower::Phase => (-180.0, 180.0),
            Lower::Beside => bounds(&lower_curves, linear),
            _ => bounds(&lower_curves, false),
        };
        let difference = view.difference(&axis, width);
        let range = bounds(&curves, linear);
        Self { axis, range, curves, lower_range, lower: lower_curves, difference, request }
    }
}

impl SpectraView {
    /// What was [prepared](Self::prepare) last.
    pub fn drawn(&self) -> Option<&Drawn> {
        self.drawn.as_ref()
    }

    /// Of the lines in each column the largest difference, dB; in columns without a line that of the nearest.
    fn difference(&self, axis: &FrequencyAxis, width: usize) -> Vec<Option<f64>> {
        let curve = |kind| self.curve(kind, self.quantity);
        let (Some(fe), Some(other)) = (curve(ModelKind::Fe), curve(self.against())) else { return vec![None; width] };
        let lines = self.lines();
        let from = lines.partition_point(|f| *f < axis.min).saturating_sub(1);
        let to = (lines.partition_point(|f| *f <= axis.max) + 1).min(lines.len());
        let difference: Vec<f64> =
            (from..to).map(|at| 20.0 * (other.lines[at].norm() / fe.lines[at].norm()).log10()).collect();
        let found = columns(&lines[from..to], &difference, axis, width);
        found
            .into_iter()
            .map(|column| column.map(|(low, high)| if high.abs() >= low.abs() { high } else { low }))
            .collect()
    }
}
