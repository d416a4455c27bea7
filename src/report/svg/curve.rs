//! Curves of any number of lines in a picture of a given width.

use super::axis::Axis;

/// The places of a curve. Of all values in a column of a pixel only the lowest and the highest are kept, in their order and
/// each at its own place, and the ends; so no peak is lost and the picture stays small.
pub fn places(x: &Axis, y: &Axis, values: impl Iterator<Item = (f64, f64)>) -> Vec<[f64; 2]> {
    let mut out: Vec<[f64; 2]> = Vec::new();
    let mut column: Vec<[f64; 2]> = Vec::new();
    let mut last = None;
    for (at, value) in values {
        let place = [x.at(at), y.at(value)];
        if out.is_empty() && column.is_empty() {
            out.push(place);
        }
        if column.last().is_some_and(|before| before[0].floor() != place[0].floor()) {
            out.extend(extremes(&column));
            column.clear();
        }
        column.push(place);
        last = Some(place);
    }
    out.extend(extremes(&column));
    out.extend(last);
    out.dedup();
    out
}

/// The lowest and the highest place, in their order.
fn extremes(column: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let by_height = |a: &(usize, &[f64; 2]), b: &(usize, &[f64; 2])| a.1[1].total_cmp(&b.1[1]);
    let ends = [column.iter().enumerate().min_by(by_height), column.iter().enumerate().max_by(by_height)];
    let mut ends: Vec<(usize, [f64; 2])> = ends.into_iter().flatten().map(|(i, place)| (i, *place)).collect();
    ends.sort_by_key(|(i, _)| *i);
    ends.dedup_by_key(|(i, _)| *i);
    ends.into_iter().map(|(_, place)| place).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_million_lines_keep_their_extremes_and_little_else() {
        let x = Axis { low: 0.0, high: 1e6, log: false, from: 50.0, to: 750.0 };
        let y = Axis { low: -1.0, high: 3.0, log: false, from: 300.0, to: 0.0 };
        // one line alone stands out, above and below
        let value = |i: usize| match i {
            654_321 => 2.5,
            123_456 => -0.9,
            _ => (i as f64 * 0.01).sin() * 0.5,
        };
        let drawn = places(&x, &y, (0..=1_000_000).map(|i| (i as f64, value(i))));
        assert!(drawn.len() <= 2 * 701 + 2, "{}", drawn.len());
        for i in [0, 123_456, 654_321, 1_000_000] {
            assert!(drawn.contains(&[x.at(i as f64), y.at(value(i))]), "{i}");
        }
        assert!(drawn.windows(2).all(|pair| pair[0][0] <= pair[1][0]));
    }
}
