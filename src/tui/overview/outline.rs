//! A spectrum in a line of text.

use num_complex::Complex64;

use crate::tui::traces::levels;

/// Columns that are kept of a spectrum: more than a table has room for.
const COLUMNS: usize = 120;

/// Levels that the shades span, dB: what lies lower is drawn as the lowest.
pub const SPAN_DB: f64 = 40.0;

/// The highest level in each of a few columns with as many lines each, dB re 1 N.
pub fn outline(force: &[Complex64]) -> Vec<f64> {
    highest_of(&levels(force), COLUMNS)
}

/// The highest value in each of `count` parts of the list; fewer where it is shorter.
fn highest_of(values: &[f64], count: usize) -> Vec<f64> {
    let count = count.min(values.len());
    let part = |at: usize| &values[at * values.len() / count..(at + 1) * values.len() / count];
    let highest =
        |values: &[f64]| values.iter().copied().filter(|value| value.is_finite()).fold(f64::NEG_INFINITY, f64::max);
    (0..count).map(|at| highest(part(at))).collect()
}

/// The outline in `width` characters; the highest is drawn at `top` (dB), the same for designs that are compared.
pub fn sparks(outline: &[f64], top: f64, width: usize, ascii: bool) -> String {
    const UNICODE: [char; 8] = ['▁', '▂', '▃', '▄', '▅', '▆', '▇', '█'];
    const ASCII: [char; 8] = ['_', '.', '-', '~', '=', '+', '*', '#'];
    let steps = if ascii { ASCII } else { UNICODE };
    let levels = highest_of(outline, width);
    let shown = levels.iter().map(|level| {
        let part = (level - (top - SPAN_DB)) / SPAN_DB;
        steps[((part * 8.0) as usize).min(7)]
    });
    shown.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_resonance_one_line_wide_is_in_the_outline_and_in_the_sparks() {
        let mut force = vec![Complex64::new(1.0, 0.0); 100_000];
        force[66_000] = Complex64::new(0.0, 1000.0);
        let outline = outline(&force);
        assert_eq!((outline.len(), outline[66 * COLUMNS / 100]), (COLUMNS, 60.0));
        assert_eq!(sparks(&outline, 60.0, 10, true), "______#___");
        assert_eq!(sparks(&outline, 60.0, 10, false), "▁▁▁▁▁▁█▁▁▁");
        assert_eq!(sparks(&outline, 90.0, 10, true), "______-___");
        assert_eq!(sparks(&[], 60.0, 10, true), "");
        assert_eq!(sparks(&[f64::NAN, f64::NEG_INFINITY, 60.0], 60.0, 9, true), "__#");
    }
}
