//! The frequency axis: where a value lies, and where the round ones are.

use crate::number::ticks::{Scale, Tick, ticks};

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
        let column = |value: f64| ((self.fraction(value) * columns as f64) as usize).min(columns - 1);
        let apart = |pair: &[Tick]| column(pair[0].0) + pair[0].1.len() + 2 <= column(pair[1].0);
        let scale = Scale { low: self.min, high: self.max, log: self.log };
        let found = ticks(scale, columns as f64 / 4.0, |ticks| ticks.windows(2).all(apart));
        found.into_iter().map(|(value, label)| (column(value), label)).collect()
    }
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
        // within a decade, and between two frequencies of many digits
        assert_eq!(
            labels(FrequencyAxis { min: 1990.0, max: 2030.0, log: true }, 40),
            ["1,990", "2,000", "2,010", "2,020", "2,030"]
        );
        assert_eq!(
            labels(FrequencyAxis { min: 2005.0, max: 2005.02, log: false }, 40),
            ["2005.00", "2005.01", "2005.02"]
        );
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
}
