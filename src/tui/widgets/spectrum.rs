//! The mesh force of the three models.
//!
//! ```text
//! ┌ Mesh force, dB re 1 N ── ━ FE  ╍ enhanced  ┈ basic  ░ > 3 dB ┐
//! │  80┤             ⢀⡀                      ░░░⣀⣀░░░░           │
//! │  40┤     ⡀      ⢰⠉⡆           ⣀⠤⠒⠉⠑⢄    ⢀⠔⠊⠉░░░⠉⠢           │
//! │   0┤⠘⠒⠉⠉⠑⠒⠤⠤⠤⠔⠒⠊  ⠈⠒⠤⠤⠤⠔⠒⠒⠊⠉       ⠑⠢⠤⠤⠔⠒                    │
//! │    └────┬─────────┬─────────┬▲────────┬─────────┬──────────  │
//! │  Hz   1,000     2,000     3,000     4,000     5,000          │
//! ```
//!
//! Where one cell has dots of two curves, it has the colour of the enhanced one. The band marks the columns where the
//! enhanced model is off by more than the tolerance: a character in the empty cells, a background in all. The mark on
//! the axis is the enhanced model's trust limit.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::Span;

use super::canvas::{Canvas, Pen};
use super::panel::{Title, put};
use super::plot::{AXIS_ROWS, GUTTER, Range, curve_width, draw_curve};
use crate::agreement::TOLERANCE_DB;
use crate::number::grouped;
use crate::number::ticks::multiples;
use crate::tui::app::Picture;
use crate::tui::axis::FrequencyAxis;
use crate::tui::theme::Theme;
use crate::tui::traces::{Columns, Envelope};

/// What the marks mean, with the saved state's curve if it is drawn.
pub fn legend(theme: &Theme, ghost: bool) -> Vec<Span<'static>> {
    let [fe, enhanced, basic] = theme.marker.samples();
    let mut spans = vec![
        Span::styled(format!("{fe} FE"), theme.fe),
        Span::styled(format!(" {enhanced} enhanced"), theme.enhanced),
        Span::styled(format!(" {basic} basic "), theme.basic),
        Span::styled(theme.glyphs.band.to_string(), theme.band),
        Span::raw(format!(" >{TOLERANCE_DB} dB")),
    ];
    if ghost {
        spans.push(Span::styled(format!(" {} FE saved", theme.glyphs.ghost), theme.faint));
    }
    spans
}

/// Title and legend of a frame `width` columns wide.
pub fn title(theme: &Theme, width: u16) -> Title<'static> {
    let [fe, enhanced, basic] = theme.marker.samples();
    let gap = if width >= 60 { "  " } else { " " };
    let right = vec![
        Span::styled(format!("{fe} FE"), theme.fe),
        Span::styled(format!("{gap}{enhanced} enhanced"), theme.enhanced),
        Span::styled(format!("{gap}{basic} basic"), theme.basic),
        Span::raw(gap),
        Span::styled(theme.glyphs.band.to_string(), theme.band),
        Span::raw(format!(" >{TOLERANCE_DB} dB")),
    ];
    Title {
        left: ["Dynamic mesh force, dB re 1 N", "Mesh force, dB re 1 N", "dB re 1 N"].map(Into::into).into(),
        right,
    }
}

/// Draws axes, band and curves into the inside of the frame.
pub fn render(picture: &Picture, trust_limit: f64, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    render_over(picture, None, trust_limit, theme, area, buffer);
}

/// As [`render`], over a curve of the saved state, which has as many columns as the picture has cells.
pub fn render_over(
    picture: &Picture,
    ghost: Option<&Envelope>,
    trust_limit: f64,
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) {
    let plot = Rect {
        x: area.x + GUTTER.min(area.width),
        width: curve_width(area),
        height: area.height.saturating_sub(AXIS_ROWS),
        ..area
    };
    if plot.is_empty() {
        return;
    }
    let (dots, _) = theme.marker.dots();
    let Some(columns) = picture.columns(usize::from(plot.width), dots) else { return };
    let (low, high) = picture.traces.range;
    let range = Range { low, high };
    draw_levels(range, theme, plot, buffer);
    draw_frequencies(&picture.traces.axis, theme, plot, buffer);
    draw_trust_limit(&picture.traces.axis, trust_limit, theme, plot, buffer);
    draw_band(columns, theme, plot, buffer);
    if let Some(ghost) = ghost {
        draw_ghost(ghost, range, theme, plot, buffer);
    }

    let mut canvas = Canvas::new(plot.width, plot.height, theme.marker);
    let [fe, enhanced, basic] = theme.glyphs.letters;
    let [solid, dashed, dotted] = theme.marker.dashes();
    draw_curve(&mut canvas, &columns.basic, range, dotted, Pen { style: theme.basic, letter: basic });
    draw_curve(&mut canvas, &columns.fe, range, solid, Pen { style: theme.fe, letter: fe });
    draw_curve(&mut canvas, &columns.enhanced, range, dashed, Pen { style: theme.enhanced, letter: enhanced });
    canvas.render(plot, buffer);
}

/// Draws the axis of the levels, left of the plot.
pub fn draw_levels(range: Range, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    let axis = plot.x - 1;
    for y in plot.top()..plot.bottom() {
        put(buffer, axis, y, theme.glyphs.vertical, theme.border);
    }
    // labels on every second row at most
    let per_row = (range.high - range.low) / f64::from(plot.height);
    let step = [10.0, 20.0, 40.0].into_iter().find(|step| *step >= 2.0 * per_row).unwrap_or(60.0);
    let (_, dots) = theme.marker.dots();
    for level in multiples(range.low, range.high, step) {
        let row = range.row(level, usize::from(plot.height) * dots) as u16 / dots as u16;
        let label = grouped(level);
        let x = axis.saturating_sub(label.len() as u16);
        buffer.set_stringn(x, plot.y + row, label, usize::from(GUTTER - 1), theme.faint);
        put(buffer, axis, plot.y + row, theme.glyphs.tick_left, theme.border);
    }
}

/// Draws the axis of the frequencies, two rows below the plot.
pub fn draw_frequencies(frequencies: &FrequencyAxis, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    let glyphs = theme.glyphs;
    let (axis, labels) = (plot.bottom(), plot.bottom() + 1);
    put(buffer, plot.x - 1, axis, glyphs.bottom_left, theme.border);
    for x in plot.left()..plot.right() {
        put(buffer, x, axis, glyphs.horizontal, theme.border);
    }
    let unit = plot.x.saturating_sub(3);
    buffer.set_stringn(unit, labels, "Hz", usize::from(GUTTER), theme.faint);
    let mut taken = unit + 3;
    for (column, label) in frequencies.ticks(usize::from(plot.width)) {
        let x = plot.x + column as u16;
        put(buffer, x, axis, glyphs.tick_down, theme.border);
        let length = label.len() as u16;
        let start = x.saturating_sub(length / 2).min(plot.right().saturating_sub(length)).max(taken);
        if start + length <= plot.right() {
            buffer.set_stringn(start, labels, label, usize::from(plot.width), theme.faint);
            taken = start + length + 1;
        }
    }
}

fn draw_trust_limit(frequencies: &FrequencyAxis, limit: f64, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    let place = frequencies.fraction(limit);
    if limit > 0.0 && (0.0..=1.0).contains(&place) {
        let column = ((place * f64::from(plot.width)) as u16).min(plot.width - 1);
        put(buffer, plot.x + column, plot.bottom(), theme.glyphs.trust, theme.enhanced.patch(theme.title));
    }
}

/// A character of its own in each cell, so that it is told from the curves without colour.
fn draw_ghost(ghost: &Envelope, range: Range, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    let rows = i64::from(plot.height);
    for (x, column) in (plot.left()..plot.right()).zip(ghost) {
        let Some((low, high)) = column else { continue };
        let row = |level: f64| range.row(level, usize::from(plot.height));
        for y in row(*high).max(0)..=row(*low).min(rows - 1) {
            put(buffer, x, plot.y + y as u16, theme.glyphs.ghost, theme.faint);
        }
    }
}

fn draw_band(columns: &Columns, theme: &Theme, plot: Rect, buffer: &mut Buffer) {
    for (x, difference) in (plot.left()..plot.right()).zip(&columns.difference) {
        if difference.is_some_and(|difference| difference.abs() > TOLERANCE_DB) {
            for y in plot.top()..plot.bottom() {
                put(buffer, x, y, theme.glyphs.band, theme.band);
            }
        }
    }
}
