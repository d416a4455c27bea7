//! Where a value lies in a picture, and where the round values are.

use crate::number::grouped;

use super::text_width;

/// An axis from one place of the picture to another, linear or logarithmic.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    pub low: f64,
    pub high: f64,
    pub log: bool,
    /// Where the lowest value lies, px
    pub from: f64,
    /// Where the highest one lies, px
    pub to: f64,
}

impl Axis {
    /// Where a value lies, px; at the nearer end where it is beyond the axis.
    pub fn at(&self, value: f64) -> f64 {
        let fraction = if self.log {
            (value / self.low).ln() / (self.high / self.low).ln()
        } else {
            (value - self.low) / (self.high - self.low)
        };
        let fraction = if fraction.is_nan() { 0.0 } else { fraction.clamp(0.0, 1.0) };
        self.from + (self.to - self.from) * fraction
    }

    /// Round values with their labels, which do not touch along a line of text.
    pub fn ticks(&self) -> Vec<(f64, String)> {
        const STEPS: [&[f64]; 3] = [&[1.0, 2.0, 5.0], &[1.0, 3.0], &[1.0]];
        let apart = |ticks: &[(f64, String)]| {
            let wide = |pair: &[(f64, String)]| f64::midpoint(text_width(&pair[0].1), text_width(&pair[1].1));
            ticks.windows(2).all(|pair| (self.at(pair[1].0) - self.at(pair[0].0)).abs() >= wide(pair) + 10.0)
        };
        let powers = STEPS.into_iter().map(|steps| self.powers(steps)).find(|ticks| ticks.len() > 2 && apart(ticks));
        if let Some(ticks) = powers.filter(|_| self.log) {
            return ticks;
        }
        let densest = round_step((self.high - self.low) / ((self.to - self.from).abs() / 30.0));
        let steps = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0].map(|factor| round_step(densest * factor));
        steps.into_iter().map(|step| self.multiples(step)).find(|ticks| apart(ticks)).unwrap_or_default()
    }

    fn powers(&self, steps: &[f64]) -> Vec<(f64, String)> {
        let decade = |value: f64| value.max(f64::MIN_POSITIVE).log10().floor() as i32;
        let decades = decade(self.low)..=decade(self.high);
        let values = decades.flat_map(|decade| steps.iter().map(move |step| step * 10_f64.powi(decade)));
        let inside = values.filter(|value| (self.low..=self.high).contains(value));
        inside.map(|value| (value, label(value, value))).collect()
    }

    fn multiples(&self, step: f64) -> Vec<(f64, String)> {
        let first = (self.low / step - 1e-9).ceil();
        let count = ((self.high - first * step) / step + 1e-9).floor();
        if !(0.0..1000.0).contains(&count) {
            return Vec::new();
        }
        let value = |i: usize| (first + i as f64) * step;
        (0..=count as usize).map(value).map(|value| (value, label(value, step))).collect()
    }
}

/// The next round number (1, 2 or 5 times a power of ten) that is not below `step`.
pub fn round_step(step: f64) -> f64 {
    if !(step.is_finite() && step > 0.0) {
        return 1.0;
    }
    let power = 10_f64.powf(step.log10().floor());
    let mantissa = step / power * (1.0 - 1e-9);
    [1.0, 2.0, 5.0].into_iter().find(|&round| mantissa <= round).unwrap_or(10.0) * power
}

/// As many decimals as the step has.
fn label(value: f64, step: f64) -> String {
    const MOST_DECIMALS: f64 = 12.0;
    let decimals = (-step.log10().floor()).clamp(0.0, MOST_DECIMALS) as usize;
    if decimals == 0 { grouped(value) } else { format!("{:.decimals$}", value + 0.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: Axis) -> Vec<String> {
        axis.ticks().into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round_and_apart() {
        let linear = Axis { low: 10.0, high: 4000.0, log: false, from: 0.0, to: 400.0 };
        assert_eq!(labels(linear), ["500", "1,000", "1,500", "2,000", "2,500", "3,000", "3,500", "4,000"]);
        assert_eq!(labels(Axis { log: true, ..linear }), ["10", "20", "50", "100", "200", "500", "1,000", "2,000"]);
        // too narrow for powers of ten
        assert_eq!(
            labels(Axis { low: 99.9, high: 100.2, log: true, from: 0.0, to: 150.0 }),
            ["99.9", "100.0", "100.1", "100.2"]
        );
    }

    #[test]
    fn nothing_lies_beyond_the_axis() {
        let axis = Axis { low: 10.0, high: 1000.0, log: true, from: 300.0, to: 100.0 };
        assert_eq!(
            [0.0, 10.0, 100.0, 1000.0, 1e9, f64::NAN].map(|f| axis.at(f)),
            [300.0, 300.0, 200.0, 100.0, 100.0, 300.0]
        );
    }
}
