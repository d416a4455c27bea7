//! Round values for the scales of pictures, on the screen and on paper.

use super::grouped;

/// The values that a scale goes over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    pub low: f64,
    pub high: f64,
    pub log: bool,
}

/// A round value with its label.
pub type Tick = (f64, String);

/// The densest round values of which at most `most` lie on the scale and whose labels fit, ascending; none where nothing fits.
///
/// A logarithmic scale has those of powers of ten, and multiples of a step where it is too short for three of them.
pub fn ticks(scale: Scale, most: f64, fits: impl Fn(&[Tick]) -> bool) -> Vec<Tick> {
    const STEPS: [&[f64]; 3] = [&[1.0, 2.0, 5.0], &[1.0, 3.0], &[1.0]];
    let Scale { low, high, log } = scale;
    if log {
        let mut powers = STEPS.into_iter().map(|steps| powers(low, high, steps));
        if let Some(ticks) = powers.find(|ticks| ticks.len() > 2 && fits(ticks)) {
            return ticks;
        }
    }
    let densest = round_step((high - low) / most);
    let steps = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0].map(|factor| round_step(densest * factor));
    let ticks = |step: f64| -> Vec<Tick> {
        multiples(low, high, step).into_iter().map(|value| (value, label(value, step))).collect()
    };
    steps.into_iter().map(ticks).find(|ticks| fits(ticks)).unwrap_or_default()
}

fn powers(low: f64, high: f64, steps: &[f64]) -> Vec<Tick> {
    let decade = |value: f64| value.max(f64::MIN_POSITIVE).log10().floor() as i32;
    let decades = decade(low)..=decade(high);
    let values = decades.flat_map(|decade| steps.iter().map(move |step| step * 10_f64.powi(decade)));
    values.filter(|value| (low..=high).contains(value)).map(|value| (value, label(value, value))).collect()
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

/// The multiples of `step` from `low` to `high`; none where they would be too many.
pub fn multiples(low: f64, high: f64, step: f64) -> Vec<f64> {
    let first = (low / step - 1e-9).ceil();
    let count = ((high - first * step) / step + 1e-9).floor();
    if !(0.0..1000.0).contains(&count) {
        return Vec::new();
    }
    (0..=count as usize).map(|at| (first + at as f64) * step).collect()
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

    #[test]
    fn steps_are_round() {
        let steps: Vec<_> = [0.7, 1.0, 3.0, 6.0, 45.0].into_iter().map(round_step).collect();
        assert_eq!(steps, [1.0, 1.0, 5.0, 10.0, 50.0]);
        assert_eq!(multiples(-12.0, 25.0, 10.0), [-10.0, 0.0, 10.0, 20.0]);
    }

    #[test]
    fn labels_tell_their_values_apart() {
        for (low, high) in [(2005.0, 2005.02), (0.05, 0.95), (1e-5, 3e-4), (10.0, 5000.0), (1995.0, 2015.0)] {
            for log in [false, true] {
                let found = ticks(Scale { low, high, log }, 10.0, |ticks| ticks.len() < 12);
                assert!(found.len() >= 3, "{low} to {high}: {found:?}");
                for pair in found.windows(2) {
                    assert!(pair[0].1 != pair[1].1 && pair[0].0 < pair[1].0, "{pair:?}");
                }
                for (value, label) in found {
                    let read: f64 = label.replace(',', "").parse().unwrap();
                    assert!((read - value).abs() <= 1e-9 * value.abs(), "{value} is labelled {label}");
                }
            }
        }
    }
}
