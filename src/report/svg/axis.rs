//! Where a value lies in a picture, and where the round values are.

use super::text_width;
use crate::number::ticks::{Scale, Tick, ticks};

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
    pub fn ticks(&self) -> Vec<Tick> {
        let apart = |pair: &[Tick]| {
            let wide = f64::midpoint(text_width(&pair[0].1), text_width(&pair[1].1));
            (self.at(pair[1].0) - self.at(pair[0].0)).abs() >= wide + 10.0
        };
        let scale = Scale { low: self.low, high: self.high, log: self.log };
        ticks(scale, (self.to - self.from).abs() / 30.0, |ticks| ticks.windows(2).all(apart))
    }
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
