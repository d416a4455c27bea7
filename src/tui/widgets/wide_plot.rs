//! Both panels of the wide screen.
//!
//! Curves are told apart by dash and letter as well as by colour; the band is a character in the empty cells; the cursor is a line with a
//! mark on top.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};

use super::canvas::{Canvas, Pen};
use super::panel::put;
use super::plot::{AXIS_ROWS, Dash, GUTTER, Range, curve_width, draw_curve};
use super::spectrum::draw_frequencies;
use crate::model::ModelKind;
use crate::number::ticks::{multiples, round_step};
use crate::number::{grouped, significant};
use crate::tui::marker::Marker;
use crate::tui::spectra::{Lower, SpectraView};
use crate::tui::theme::Theme;
use crate::tui::traces::Envelope;

/// The scales of the differences, dB.
const LIMITS: [f64; 3] = [10.0, 20.0, 40.0];

pub fn style(kind: ModelKind, theme: &Theme) -> Style {
    match kind {
        ModelKind::Fe => theme.fe,
        ModelKind::Enhanced => theme.enhanced,
        ModelKind::Basic => theme.basic,
        ModelKind::Reduced(_) => theme.warning.remove_modifier(Modifier::BOLD),
    }
}

/// How the legend shows a curve.
pub fn sample(kind: ModelKind, theme: &Theme) -> &'static str {
    let [fe, enhanced, basic] = theme.marker.samples();
    match kind {
        ModelKind::Fe => fe,
        ModelKind::Enhanced => enhanced,
        ModelKind::Basic => basic,
        ModelKind::Reduced(_) => match theme.marker {
            Marker::Letters => "r",
            Marker::Points => ", ,",
            Marker::Dots => "• •",
            Marker::Braille | Marker::Blocks => "┅",
        },
    }
}

pub fn legend_name(kind: ModelKind) -> String {
    match kind {
        ModelKind::Fe => "FE".into(),
        ModelKind::Reduced(modes) => format!("reduced:{modes}"),
        other => other.name().into_owned(),
    }
}

/// What a model's curve is drawn with.
pub fn pen(kind: ModelKind, theme: &Theme) -> (Dash, Pen) {
    let [solid, dashed, dotted] = theme.marker.dashes();
    let [fe, enhanced, basic] = theme.glyphs.letters;
    let (dash, letter) = match kind {
        ModelKind::Fe => (solid, fe),
        ModelKind::Enhanced => (dashed, enhanced),
        ModelKind::Basic => (dotted, basic),
        ModelKind::Reduced(_) if theme.marker.dots().0 == 2 => (Dash { on: 3, off: 2 }, 'r'),
        ModelKind::Reduced(_) => (Dash { on: 1, off: 1 }, 'r'),
    };
    (dash, Pen { style: style(kind, theme), letter })
}

fn plot_of(area: Rect, axis_rows: u16) -> Rect {
    let height = area.height.saturating_sub(axis_rows);
    Rect { x: area.x + GUTTER.min(area.width), width: curve_width(area), height, ..area }
}

/// Draws axes, bands, curves, peaks and the cursor.
pub fn render_upper(view: &mut SpectraView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let plot = plot_of(area, AXIS_ROWS);
    let (dots, _) = theme.marker.dots();
    if plot.is_empty() || view.prepare(usize::from(plot.width), dots).is_none() {
        return;
    }
    let Some(drawn) = view.drawn() else { return };
    let range = Range { low: drawn.range.0, high: drawn.range.1 };
    draw_scale(range, !view.linear_level, theme, plot, buffer);
    draw_frequencies(&drawn.axis, theme, plot, buffer);
    draw_harmonics(view, theme, plot, buffer);
    draw_bands(view, theme, plot, buffer);
    draw_cursor(view, theme, plot, buffer);
    draw_curves(&drawn.curves, range, theme, plot, buffer);
    draw_peaks(view, range, theme, plot, buffer);
}

/// Draws the strip of differences, or curves.
pub fn render_lower(view: &SpectraView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let plot = plot_of(area, 0);
    let Some(drawn) = view.drawn().filter(|_| !plot.is_empty()) else { return };
    let levels = view.lower == Lower::SixthOctaves || (view.lower == Lower::Beside && !view.linear_level);
    let range = if view.lower == Lower::Difference {
        let largest = drawn.difference.iter().flatten().filter(|d| d.is_finite()).fold(0.0_f64, |a, d| a.max(d.abs()));
        let limit = LIMITS.into_iter().find(|limit| *limit >= largest).unwrap_or(LIMITS[2]);
        Range { low: -limit, high: limit }
    } else {
        Range { low: drawn.lower_range.0, high: drawn.lower_range.1 }
    };
    draw_scale(range, levels, theme, plot, buffer);
    draw_ends(range, theme, plot, buffer);
    draw_cursor(view, theme, plot, buffer);
    if view.lower == Lower::Difference {
        draw_differences(&drawn.difference, range, view.tolerance, theme, plot, buffer);
    } else {
        draw_curves(&drawn.lower, range, theme, plot, buffer);
    }
}

fn draw_curves(curves: &[(ModelKind, Envelope)], range: Range, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    let mut canvas = Canvas::new(plot.width, plot.height, theme.marker);
    // of two curves in one cell the lumped one shows, as in the small picture; basic lies lowest
    let order = |kind: &ModelKind| match kind {
        ModelKind::Basic => 0,
        ModelKind::Fe => 1,
        ModelKind::Reduced(_) => 2,
        ModelKind::Enhanced => 3,
    };
    let mut sorted: Vec<_> = curves.iter().collect();
    sorted.sort_by_key(|(kind, _)| order(kind));
    for (kind, curve) in sorted {
        let (dash, pen) = pen(*kind, theme);
        draw_curve(&mut canvas, curve, range, dash, pen);
    }
    canvas.render(plot, buffer);
}

/// Bars from zero; beyond the tolerance they are of another letter, and two dots wide where there are two.
fn draw_differences(
    differences: &[Option<f64>],
    range: Range,
    tolerance: f64,
    theme: &Theme,
    plot: Rect,
    buffer: &mut Buffer,
) {
    let mut canvas = Canvas::new(plot.width, plot.height, theme.marker);
    let (across, _) = theme.marker.dots();
    let rows = canvas.dots_high();
    for (x, difference) in differences.iter().enumerate() {
        let Some(difference) = difference.filter(|difference| difference.is_finite()) else { continue };
        let beyond = difference.abs() > tolerance;
        let (style, letter) = if beyond { (theme.beyond, '#') } else { (theme.enhanced, '-') };
        let (zero, end) = (range.row(0.0, rows), range.row(difference, rows).clamp(0, rows.cast_signed() as i64 - 1));
        let (top, bottom) = (zero.min(end).max(0), zero.max(end));
        for dot in (0..across).filter(|dot| *dot == 0 || beyond) {
            canvas.set_column(x * across + dot, top as usize, bottom as usize, Pen { style, letter });
        }
    }
    canvas.render(plot, buffer);
}

/// The axis of the values: levels on tens, others on round numbers.
pub fn draw_scale(range: Range, levels: bool, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    let axis = plot.x - 1;
    for y in plot.top()..plot.bottom() {
        put(buffer, axis, y, theme.glyphs.vertical, theme.border);
    }
    let per_row = (range.high - range.low) / f64::from(plot.height);
    let least = 2.0 * per_row;
    let step = if levels {
        [10.0, 20.0, 40.0].into_iter().find(|step| *step >= least).unwrap_or(60.0)
    } else {
        round_step(least)
    };
    let step = if (range.high - 180.0).abs() < 1e-9 { 90.0_f64.max((least / 90.0).ceil() * 90.0) } else { step };
    let (_, dots) = theme.marker.dots();
    for value in multiples(range.low, range.high, step) {
        let row = range.row(value, usize::from(plot.height) * dots).max(0) as u16 / dots as u16;
        let label = label(value);
        let x = axis.saturating_sub(label.len() as u16);
        if row < plot.height {
            buffer.set_stringn(x, plot.y + row, label, usize::from(GUTTER - 1), theme.faint);
            put(buffer, axis, plot.y + row, theme.glyphs.tick_left, theme.border);
        }
    }
}

/// Both ends of a scale that has no room for more, beside what stands there.
fn draw_ends(range: Range, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    const LOW: u16 = 4;
    if plot.height > LOW || plot.height < 2 {
        return;
    }
    for (y, value) in [(plot.top(), range.high), (plot.bottom() - 1, range.low)] {
        let label = label(value);
        let from = (plot.x - 1).saturating_sub(label.len() as u16);
        let is_free = |x: u16| buffer.cell((x, y)).is_some_and(|cell| cell.symbol() == " ");
        if (plot.x.saturating_sub(GUTTER)..plot.x - 1).all(is_free) {
            buffer.set_stringn(from, y, label, usize::from(GUTTER - 1), theme.faint);
        }
    }
}

/// In four columns.
fn label(value: f64) -> String {
    if value == 0.0 {
        return "0".into();
    }
    match value.abs() {
        1e6.. => format!("{}M", significant(value / 1e6, 2).trim_end_matches(".0")),
        10_000.0.. => format!("{}k", significant(value / 1e3, 2).trim_end_matches(".0")),
        10.0.. => grouped(value).replace(',', ""),
        0.01.. => {
            let text = format!("{value:.2}");
            text.trim_end_matches('0').trim_end_matches('.').to_owned()
        }
        _ => format!("{value:.0e}"),
    }
}

fn draw_bands(view: &SpectraView, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    let Some(drawn) = view.drawn() else { return };
    for (x, difference) in (plot.left()..plot.right()).zip(&drawn.difference) {
        if difference.is_some_and(|difference| difference.abs() > view.tolerance) {
            for y in plot.top()..plot.bottom() {
                put(buffer, x, y, theme.glyphs.band, theme.band);
            }
        }
    }
}

fn column(view: &SpectraView, hz: f64, plot: Rect) -> Option<u16> {
    let place = view.drawn()?.axis.fraction(hz);
    let inside = (0.0..=1.0).contains(&place);
    inside.then(|| plot.x + ((place * f64::from(plot.width)) as u16).min(plot.width - 1))
}

fn draw_cursor(view: &SpectraView, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    let Some(x) = view.at_hz().and_then(|hz| column(view, hz, plot)) else { return };
    for y in plot.top()..plot.bottom() {
        put(buffer, x, y, theme.glyphs.vertical, theme.title);
    }
    put(buffer, x, plot.top(), theme.glyphs.pointer, theme.title);
}

/// The mesh frequency and its harmonics as `1x`, `2x` on the axis, as far as they have one digit and are apart: bare numbers are peaks.
fn draw_harmonics(view: &SpectraView, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    let Some((mesh, _)) = view.mesh_frequency() else { return };
    let mut free = plot.left();
    for order in 1..=9_u8 {
        let Some(x) = column(view, f64::from(order) * mesh, plot).filter(|x| *x >= free) else { continue };
        if x + 1 >= plot.right() {
            continue;
        }
        put(buffer, x, plot.bottom(), char::from(b'0' + order), theme.title);
        put(buffer, x + 1, plot.bottom(), 'x', theme.title);
        free = x + 3;
    }
}

/// The number of each peak in the list, above its column.
fn draw_peaks(view: &SpectraView, range: Range, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    let (Some(findings), Some(drawn)) = (view.findings(), view.drawn()) else { return };
    let Some((_, curve)) = drawn.curves.iter().find(|(kind, _)| *kind == ModelKind::Fe) else { return };
    let (dots, _) = theme.marker.dots();
    let mut free = plot.left();
    for (at, peak) in findings.peaks.iter().enumerate() {
        let Some(x) = peak.pair.fe_hz.and_then(|hz| column(view, hz, plot)) else { continue };
        let label = (at + 1).to_string();
        if x < free || x + label.len() as u16 > plot.right() {
            continue;
        }
        let dot = usize::from(x - plot.x) * dots;
        let highest =
            curve.iter().skip(dot).take(dots).flatten().map(|(_, high)| *high).fold(f64::NEG_INFINITY, f64::max);
        let row = range.row(highest, usize::from(plot.height)) - 1;
        let y = plot.y + row.clamp(0, i64::from(plot.height) - 1) as u16;
        buffer.set_stringn(x, y, &label, label.len(), theme.title);
        free = x + label.len() as u16 + 1;
    }
}

#[cfg(test)]
mod tests {
    use super::label;

    #[test]
    fn labels_fit_their_columns() {
        for (value, text) in [(1e6, "1M"), (2.5e7, "25M"), (2e4, "20k"), (0.5, "0.5"), (0.0, "0")] {
            assert_eq!(label(value), text);
        }
    }
}
