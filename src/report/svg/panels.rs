//! Plots over one another with the same frequencies.

use super::axis::Axis;
use super::curve::places;
use super::frame::{Frame, legend_of};
use super::{Anchor, Drawing, WIDTH, text_width};
use crate::document::{Line, Panel, Panels};
use crate::number::grouped;

const LEFT: f64 = 58.0;
const RIGHT: f64 = WIDTH - 14.0;
const TOP: f64 = 54.0;
/// Of the first plot and of the others, px
const HEIGHTS: [f64; 2] = [300.0, 120.0];
/// Between two plots
const GAP: f64 = 38.0;

/// Description, height in px, drawing.
pub fn draw(panels: &Panels) -> (String, f64, Drawing) {
    let x = Axis { low: panels.range.0, high: panels.range.1, log: panels.log, from: LEFT, to: RIGHT };
    let mut drawing = Drawing::default();
    let first = panels.panels.first();
    let lines: Vec<(&str, &str)> = first
        .into_iter()
        .flat_map(|panel| &panel.curves)
        .map(|curve| (class(curve.line), curve.name.as_str()))
        .collect();
    legend_of(&mut drawing, [LEFT, 14.0], &lines, &panels.band);
    let mut top = TOP;
    let count = panels.panels.len();
    for (at, panel) in panels.panels.iter().enumerate() {
        let bottom = top + HEIGHTS[usize::from(at > 0)];
        draw_panel(&mut drawing, panels, panel, x, [top, bottom], [at == 0, at + 1 == count]);
        top = bottom + GAP;
    }
    drawing.text("label", [f64::midpoint(LEFT, RIGHT), top - 4.0], Anchor::Middle, "frequency, Hz");
    let labels: Vec<String> = panels.panels.iter().map(|panel| panel.label.clone()).collect();
    let names: Vec<&str> = lines.iter().map(|(_, name)| *name).collect();
    let description = format!(
        "{} from {} to {} Hz: {}.",
        labels.join("; below it "),
        grouped(panels.range.0),
        grouped(panels.range.1),
        names.join(", ")
    );
    (description, top + 2.0, drawing)
}

/// Of the style sheet.
pub fn class(line: Line) -> &'static str {
    match line {
        Line::Fe => "fe",
        Line::Enhanced => "enhanced",
        Line::Basic => "basic",
        Line::Reduced => "reduced",
    }
}

fn draw_panel(
    drawing: &mut Drawing,
    panels: &Panels,
    panel: &Panel,
    x: Axis,
    [top, bottom]: [f64; 2],
    [is_first, is_last]: [bool; 2],
) {
    let (low, high) = panel.range;
    // nothing has no height of its own
    let high = if high > low { high } else { low + 1.0 };
    let y = Axis { low, high, log: false, from: bottom, to: top };
    bands(drawing, panels, x, [top, bottom], is_first);
    Frame { x, y }.draw(drawing, is_last);
    for level in panel.levels.iter().filter(|level| (low..=high).contains(*level)) {
        drawing.line(if *level == 0.0 { "zero" } else { "tolerance" }, [x.from, y.at(*level)], [x.to, y.at(*level)]);
    }
    // names of lines stand inside, those of places above
    let mut free = [f64::NEG_INFINITY; 2];
    for mark in panels.marks.iter().filter(|mark| (x.low..=x.high).contains(&mark.hz)) {
        let at = x.at(mark.hz);
        if mark.line {
            drawing.line("place", [at, top], [at, bottom]);
        }
        let half = text_width(&mark.text) / 2.0;
        let shift = if mark.line { half + 3.0 } else { 0.0 };
        let middle = (at + shift).clamp(half, x.to.max(half + 1.0) - half);
        let free = &mut free[usize::from(mark.line)];
        if is_first && middle - half > *free {
            let (class, y) = if mark.line { ("faint", top + 13.0) } else { ("strong", top - 5.0) };
            drawing.text(class, [middle, y], Anchor::Middle, &mark.text);
            *free = middle + half + 3.0;
        }
    }
    for curve in panel.curves.iter().rev() {
        for run in curve.points.split(|(_, value)| !value.is_finite()).filter(|run| !run.is_empty()) {
            drawing.path(&format!("curve {}", class(curve.line)), &places(&x, &y, run.iter().copied()), false);
        }
    }
    drawing.text("label", [4.0, top - if is_first { 18.0 } else { 8.0 }], Anchor::Start, &panel.label);
}

/// Shaded, with their numbers where there is room.
fn bands(drawing: &mut Drawing, panels: &Panels, x: Axis, [top, bottom]: [f64; 2], numbered: bool) {
    let mut free = f64::NEG_INFINITY;
    for (at, band) in panels.bands.iter().enumerate() {
        if band.to_hz < x.low || band.from_hz > x.high {
            continue;
        }
        let (from, to) = (x.at(band.from_hz), x.at(band.to_hz));
        let wider = (1.0 - (to - from)).max(0.0) / 2.0;
        let (from, to) = ((from - wider).max(x.from), (to + wider).min(x.to));
        drawing.rect("band", [from, top], [to, bottom], Some(&band.text));
        let number = (at + 1).to_string();
        let (middle, half) = (f64::midpoint(from, to), text_width(&number) / 2.0);
        if numbered && middle - half > free {
            drawing.text("strong", [middle, bottom - 6.0], Anchor::Middle, &number);
            free = middle + half + 3.0;
        }
    }
}
