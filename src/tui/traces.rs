//! Spectra made ready for drawing: levels in dB, and for each column of the picture the lowest and highest level in it.
//!
//! With minimum and maximum kept, a resonance one line wide among a million lines still shows at its height.

use num_complex::Complex64;

use super::axis::FrequencyAxis;
use crate::comparison::Comparison;
use crate::design::{Analysis, FrequencySpacing};

/// Below this, a force counts as none, dB re 1 N.
const FLOOR_DB: f64 = -400.0;

/// The levels of one comparison, one value a frequency line.
#[derive(Debug, Clone, PartialEq)]
pub struct Traces {
    pub axis: FrequencyAxis,
    frequency: Vec<f64>,
    /// |`F_m`|, dB re 1 N
    fe: Vec<f64>,
    enhanced: Vec<f64>,
    basic: Vec<f64>,
    /// enhanced - FE, dB
    difference: Vec<f64>,
    /// Lowest and highest level that the picture shows, dB.
    pub range: (f64, f64),
    /// The largest |enhanced - FE|, dB
    pub largest_difference: f64,
}

/// Lowest and highest value in each column; `None` where there is no value.
pub type Envelope = Vec<Option<(f64, f64)>>;

/// The picture's columns at one width.
#[derive(Debug, Clone, PartialEq)]
pub struct Columns {
    /// Columns of characters
    pub width: usize,
    /// Columns of dots in one column of characters
    pub dots: usize,
    pub fe: Envelope,
    pub enhanced: Envelope,
    pub basic: Envelope,
    /// enhanced - FE of largest magnitude in each column of characters, dB
    pub difference: Vec<Option<f64>>,
}

impl Traces {
    /// Levels and differences of a comparison.
    pub fn new(comparison: &Comparison, analysis: &Analysis) -> Self {
        let fe = levels(&comparison.fe.mesh_force);
        let enhanced = levels(&comparison.enhanced.mesh_force);
        let basic = levels(&comparison.basic.mesh_force);
        let difference: Vec<f64> = enhanced.iter().zip(&fe).map(|(enhanced, fe)| enhanced - fe).collect();
        let finite = difference.iter().filter(|value| value.is_finite());
        let largest_difference = finite.fold(0.0, |largest: f64, value| largest.max(value.abs()));
        let frequency = comparison.frequency_hz.clone();
        let axis = FrequencyAxis {
            min: frequency.first().copied().unwrap_or(0.0),
            max: frequency.last().copied().unwrap_or(1.0),
            log: analysis.frequency_spacing == FrequencySpacing::Log,
        };
        let range = range(&[&fe, &enhanced, &basic]);
        Self { axis, frequency, fe, enhanced, basic, difference, range, largest_difference }
    }

    /// The finite element model's levels on another axis.
    pub fn fe_columns(&self, axis: &FrequencyAxis, count: usize) -> Envelope {
        let start = self.frequency.partition_point(|&frequency| frequency < axis.min);
        let end = self.frequency.partition_point(|&frequency| frequency <= axis.max);
        envelope(&self.frequency[start..end], &self.fe[start..end], axis, count)
    }

    /// The columns of a picture `width` characters wide with `dots` dots in each.
    pub fn columns(&self, width: usize, dots: usize) -> Columns {
        let envelope = |values: &[f64], count: usize| envelope(&self.frequency, values, &self.axis, count);
        let difference = envelope(&self.difference, width)
            .into_iter()
            .map(|column| column.map(|(low, high)| if high.abs() >= low.abs() { high } else { low }))
            .collect();
        Columns {
            width,
            dots,
            fe: envelope(&self.fe, width * dots),
            enhanced: envelope(&self.enhanced, width * dots),
            basic: envelope(&self.basic, width * dots),
            difference,
        }
    }
}

/// Levels of forces, dB re 1 N.
pub fn levels(force: &[Complex64]) -> Vec<f64> {
    force.iter().map(|value| (20.0 * value.norm().log10()).max(FLOOR_DB)).collect()
}

/// A range of levels that begins and ends on tens and does not follow an antiresonance into the ground.
pub fn range(curves: &[&[f64]]) -> (f64, f64) {
    let values = || curves.iter().flat_map(|curve| curve.iter().copied()).filter(|value| value.is_finite());
    let high = values().fold(f64::NEG_INFINITY, f64::max);
    let low = values().fold(f64::INFINITY, f64::min);
    if high < low {
        return (0.0, 10.0);
    }
    let high = (high / 10.0).ceil() * 10.0;
    let low = ((low / 10.0).floor() * 10.0).clamp(high - 120.0, high - 10.0);
    (low, high)
}

/// The lowest and highest value of the line through the points in each of `count` columns.
///
/// Where the line leaves a column, its value at the border counts for both columns: so neighbours always touch, and
/// columns without a point of their own are filled.
pub fn envelope(frequency: &[f64], values: &[f64], axis: &FrequencyAxis, count: usize) -> Envelope {
    let mut columns: Envelope = vec![None; count];
    let mut keep = |column: usize, value: f64| {
        if let Some(kept) = columns.get_mut(column) {
            *kept = Some(kept.map_or((value, value), |(low, high)| (low.min(value), high.max(value))));
        }
    };
    let border = |column: usize| axis.frequency(column as f64 / count as f64);
    let mut column = 0;
    let mut right_border = border(1);
    let mut before: Option<(f64, f64)> = None;
    for (&at, &value) in frequency.iter().zip(values) {
        while column + 1 < count && at >= right_border {
            if let Some((before_at, before_value)) = before.filter(|_| value.is_finite()) {
                let crossing = before_value + (value - before_value) * (right_border - before_at) / (at - before_at);
                keep(column, crossing);
                keep(column + 1, crossing);
            }
            column += 1;
            right_border = border(column + 1);
        }
        before = value.is_finite().then_some((at, value));
        if value.is_finite() {
            keep(column, value);
        }
    }
    columns
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(count: usize) -> Vec<f64> {
        (0..count).map(|at| 10.0 + 4990.0 * at as f64 / (count - 1) as f64).collect()
    }

    #[test]
    fn a_resonance_one_line_wide_among_a_million_keeps_its_height() {
        let frequency = lines(1_000_000);
        let mut values = vec![1.0; frequency.len()];
        values[654_321] = 80.0;
        for log in [false, true] {
            let axis = FrequencyAxis { min: 10.0, max: 5000.0, log };
            let columns = envelope(&frequency, &values, &axis, 90);
            let at = (axis.fraction(frequency[654_321]) * 90.0) as usize;
            assert_eq!(columns[at], Some((1.0, 80.0)));
            assert!(columns.iter().enumerate().all(|(column, found)| column == at || *found == Some((1.0, 1.0))));
        }
    }

    #[test]
    fn columns_without_a_line_of_their_own_are_filled_and_neighbours_touch() {
        let axis = FrequencyAxis { min: 10.0, max: 5000.0, log: true };
        let columns = envelope(&lines(7), &[0.0, 40.0, -10.0, 5.0, 5.0, 60.0, 0.0], &axis, 200);
        for pair in columns.windows(2) {
            let (Some(left), Some(right)) = (pair[0], pair[1]) else { panic!("an empty column") };
            assert!(left.0 <= right.1 + 1e-9 && right.0 <= left.1 + 1e-9, "{left:?} {right:?}");
        }
    }

    #[test]
    fn what_is_no_number_leaves_a_gap() {
        let axis = FrequencyAxis { min: 0.0, max: 4.0, log: false };
        let columns = envelope(&[0.0, 1.0, 2.0, 3.0, 4.0], &[1.0, 1.0, f64::NAN, 1.0, 1.0], &axis, 8);
        assert_eq!(columns[4], None);
        assert_eq!(columns[0], Some((1.0, 1.0)));
        assert_eq!(columns[7], Some((1.0, 1.0)));
    }

    #[test]
    fn the_range_is_round_and_bounded() {
        assert_eq!(range(&[&[3.0, 41.0], &[-12.0]]), (-20.0, 50.0));
        assert_eq!(range(&[&[41.0, -400.0]]), (-70.0, 50.0));
        assert_eq!(range(&[&[f64::NAN]]), (0.0, 10.0));
        assert_eq!(range(&[&[40.0, 40.0]]), (30.0, 40.0));
    }
}
