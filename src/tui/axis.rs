//! Axes: where a value lies, and where the round numbers are.

use crate::number::grouped;

/// The frequency axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FrequencyAxis {
    pub min: f64,
    pub max: f64,
    pub log: bool,
}

impl FrequencyAxis {
    /// Where a frequency lies, from 0 at the left end to 1 at the right end.
    pub fn fraction(&self, frequency: f64) -> f64 {
        if self.log {
            (frequency / self.min).ln() / (self.max / self.min).ln()
        } else {
            (frequency - self.min) / (self.max - self.min)
        }
    }

    /// The frequency at a fraction of the axis.
    pub fn frequency(&self, fraction: f64) -> f64 {
        if self.log {
            self.min * (self.max / self.min).powf(fraction)
        } else {
            self.min + (self.max - self.min) * fraction
        }
    }

    /// Round frequencies for an axis of `columns` columns whose labels must not touch: column, label.
    pub fn ticks(&self, columns: usize) -> Vec<(usize, String)> {
        if columns == 0 || !self.fraction(self.max).is_finite() {
            return Vec::new();
        }
        let candidates: Vec<Vec<f64>> = if self.log {
            [&[1.0, 2.0, 5.0][..], &[1.0, 3.0], &[1.0]].into_iter().map(|steps| self.log_ticks(steps)).collect()
        } else {
            let densest = round_step((self.max - self.min) / (columns as f64 / 4.0));
            [1.0, 2.0, 5.0, 10.0, 20.0]
                .into_iter()
                .map(|factor| multiples(self.min, self.max, round_step(densest * factor)))
                .collect()
        };
        let place = |values: &[f64]| -> Vec<(usize, String)> {
            values
                .iter()
                .map(|&value| (((self.fraction(value) * columns as f64) as usize).min(columns - 1), label(value)))
                .collect()
        };
        let apart =
            |ticks: &[(usize, String)]| ticks.windows(2).all(|pair| pair[0].0 + pair[0].1.len() + 2 <= pair[1].0);
        candidates.iter().map(|values| place(values)).find(|ticks| apart(ticks)).unwrap_or_default()
    }

    fn log_ticks(&self, steps: &[f64]) -> Vec<f64> {
        let decades = self.min.log10().floor() as i32..=self.max.log10().floor() as i32;
        decades
            .flat_map(|decade| steps.iter().map(move |step| step * 10_f64.powi(decade)))
            .filter(|value| (self.min..=self.max).contains(value))
            .collect()
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

/// The multiples of `step` from `low` to `high`.
pub fn multiples(low: f64, high: f64, step: f64) -> Vec<f64> {
    let first = (low / step - 1e-9).ceil();
    let count = ((high - first * step) / step + 1e-9).floor();
    if !(0.0..1000.0).contains(&count) {
        return Vec::new();
    }
    (0..=count as usize).map(|at| (first + at as f64) * step).collect()
}

fn label(value: f64) -> String {
    if value >= 10.0 || (value - value.round()).abs() < 1e-9 { grouped(value) } else { format!("{value}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: FrequencyAxis, columns: usize) -> Vec<String> {
        axis.ticks(columns).into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round_and_apart() {
        let linear = FrequencyAxis { min: 10.0, max: 5000.0, log: false };
        assert_eq!(
            labels(linear, 80),
            ["500", "1,000", "1,500", "2,000", "2,500", "3,000", "3,500", "4,000", "4,500", "5,000"]
        );
        assert_eq!(labels(linear, 40), ["1,000", "2,000", "3,000", "4,000", "5,000"]);
        let log = FrequencyAxis { log: true, ..linear };
        assert_eq!(labels(log, 80), ["10", "20", "50", "100", "200", "500", "1,000", "2,000", "5,000"]);
        assert_eq!(labels(log, 20), ["10", "100", "1,000"]);
        assert_eq!(labels(linear, 0), [""; 0]);
    }

    #[test]
    fn fraction_and_frequency_are_inverse() {
        for log in [false, true] {
            let axis = FrequencyAxis { min: 10.0, max: 5000.0, log };
            for fraction in [0.0, 0.3, 1.0] {
                assert!((axis.fraction(axis.frequency(fraction)) - fraction).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn steps_are_round() {
        let steps: Vec<_> = [0.7, 1.0, 3.0, 6.0, 45.0].into_iter().map(round_step).collect();
        assert_eq!(steps, [1.0, 1.0, 5.0, 10.0, 50.0]);
        assert_eq!(multiples(-12.0, 25.0, 10.0), [-10.0, 0.0, 10.0, 20.0]);
    }
}
