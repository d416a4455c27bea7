//! Two designs beside one another: what differs, both finite element spectra, the agreement of both.
//!
//! ```text
//!  header                                    A name   B name
//! ┌ Differences ────────────────────────────────────────────┐
//! │ value                                 A        B  unit  │
//! │ kx of pinion bearing B1             6e8    7.5e8  N/m   │
//! ├ FE mesh force, dB re 1 N ──────────────── ━ A  ╍ B ─────┤
//! │ two spectra                                             │
//! └─────────────────────────────────────────────────────────┘
//!  A: enhanced trust up to 2,997 Hz, 3.72 dB RMS   basic ...
//!  B: ...
//!  footer
//! ```

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;
use ratatui::text::{Line, Span};
use unicode_width::UnicodeWidthStr;

use crate::agreement::Agreement;
use crate::design::Difference;
use crate::number::grouped;
use crate::text::{cut, cut_apart, printable, wrap};
use crate::tui::app::App;
use crate::tui::compare::{CompareView, Compared};
use crate::tui::theme::Theme;
use crate::tui::widgets::canvas::{Canvas, Pen};
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::plot::{AXIS_ROWS, GUTTER, Range, curve_width, draw_curve};
use crate::tui::widgets::{figures, footer, header, spectrum};

/// The fewest rows that a spectrum is drawn in, with its axis.
const LEAST_PLOT: u16 = 6;

/// Draws the view over the whole frame.
pub fn render(app: &mut App, frame: &mut Frame) -> Option<Position> {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    let row = |y: u16, height: u16| Rect { y: area.y + y, height, ..area };
    let theme = app.theme;
    if let Some(view) = &mut app.compare {
        let [a, b] = &view.names;
        header::render_named(&format!("A {a}   B {b}"), &theme, row(0, 1), buffer);
        render_body(view, &theme, super::body(area), buffer);
        render_figures(view, &theme, row(area.height - 1 - figures::HEIGHT, figures::HEIGHT), buffer);
    }
    footer::render(app, row(area.height - 1, 1), buffer)
}

fn render_body(view: &mut CompareView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let lines = match &view.result {
        None => vec![Cells::text(&format!("Reading and solving both designs{}", theme.glyphs.ellipsis))],
        Some(result) => lines(result, usize::from(area.width)),
    };
    let wanted = u16::try_from(lines.len()).unwrap_or(u16::MAX).saturating_add(1);
    let room = area.height.saturating_sub(2);
    // the differences need few rows most of the time: the spectra have the rest, and never less than half
    let table = wanted.clamp(2.min(room), (room / 2).max(2.min(room)));
    let has_plot = room.saturating_sub(table + 1) >= LEAST_PLOT;
    let table = if has_plot { table } else { room };
    view.scroll.fit(lines.len(), usize::from(table).saturating_sub(1));
    let inner = panel::frame(area, buffer, &title(view), true, theme);
    render_table(&lines, view.scroll.top, theme, Rect { height: table.min(inner.height), ..inner }, buffer);
    let Some(position) = has_plot.then_some(inner.y + table) else { return };
    panel::divider(area, buffer, position, &plot_title(view, theme), theme);
    let below = Rect { y: position + 1, height: inner.bottom().saturating_sub(position + 1), ..inner };
    render_plot(view, theme, below, buffer);
}

fn title(view: &CompareView) -> Title<'static> {
    let count = match view.result.as_ref().map(|result| &result.differences) {
        Some(Ok(differences)) => match differences.len() {
            0 => "No differences".into(),
            1 => "1 difference".into(),
            more => format!("{more} differences"),
        },
        _ => "Differences".into(),
    };
    let position =
        view.scroll.position().map_or_else(|| count.clone(), |position| format!("{count}, lines {position}"));
    Title { left: vec![position, count], right: Vec::new() }
}

fn plot_title(view: &CompareView, theme: &Theme) -> Title<'static> {
    let [a, b] = theme.marker.samples_of_two();
    let (a, b) = (format!("{a} A"), format!("{b} B"));
    let long = "FE dynamic mesh force, dB re 1 N";
    let rms = view.result.as_ref().and_then(|result| result.fe_rms_db);
    let mut left: Vec<String> = rms.map(|rms| format!("{long}, {rms:.2} dB RMS apart")).into_iter().collect();
    left.extend([long, "FE mesh force, dB", "FE, dB"].map(Into::into));
    Title { left, right: vec![Span::styled(a, theme.fe), Span::styled(format!("  {b}"), theme.enhanced)] }
}

/// One line of the table.
enum Cells {
    Text(String),
    Values([String; 4]),
}

impl Cells {
    fn text(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

fn lines(result: &Compared, width: usize) -> Vec<Cells> {
    let mut lines = Vec::new();
    let text = |lines: &mut Vec<Cells>, text: String| {
        lines.extend(wrap(&text, width.saturating_sub(4)).into_iter().map(Cells::Text));
    };
    for (name, side) in ["A", "B"].into_iter().zip(&result.sides) {
        if let Err(error) = side {
            text(&mut lines, format!("{name}: {error}"));
        }
    }
    match &result.differences {
        Err(error) => text(&mut lines, error.clone()),
        Ok(differences) if differences.is_empty() => text(&mut lines, "Both files say the same.".into()),
        Ok(differences) => lines.extend(differences.iter().map(cells)),
    }
    lines
}

fn cells(difference: &Difference) -> Cells {
    let [label, a, b] = [&difference.label, difference.shown()[0], difference.shown()[1]].map(|text| printable(text));
    Cells::Values([label.into_owned(), a.into_owned(), b.into_owned(), difference.unit.to_owned()])
}

fn render_table(lines: &[Cells], top: usize, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if area.is_empty() {
        return;
    }
    let all = usize::from(area.width).saturating_sub(2);
    // as wide as what is in them, within bounds; what is left is for the label
    let widest = |place: usize| {
        let cells = lines.iter().map(|cells| match cells {
            Cells::Values(values) => values[place].width(),
            Cells::Text(_) => 0,
        });
        cells.max().unwrap_or(0)
    };
    let unit = widest(3).clamp(4, 12);
    // a long text gives way to the labels, a number does not
    let left = all.saturating_sub(widest(0) + unit + 5) / 2;
    let value = widest(1).max(widest(2)).clamp(6, left.max(11));
    let label = all.saturating_sub(2 * (value + 2) + unit + 1);
    let ellipsis = theme.glyphs.ellipsis;
    let line = |[name, a, b, of]: [&str; 4]| {
        let right = |text: &str| format!("  {}{text}", " ".repeat(value.saturating_sub(text.width())));
        let [a, b] = cut_apart([a, b], value, ellipsis);
        let name = cut(name, label, ellipsis);
        let gap = " ".repeat(label.saturating_sub(name.width()));
        format!(" {name}{gap}{}{} {}", right(&a), right(&b), cut(of, unit, ellipsis))
    };
    let width = usize::from(area.width);
    buffer.set_stringn(area.x, area.y, line(["value", "A", "B", "unit"]), width, theme.faint);
    for (cells, y) in lines.iter().skip(top).zip(area.y + 1..area.bottom()) {
        let text = match cells {
            Cells::Text(text) => format!(" {text}"),
            Cells::Values([name, a, b, of]) => line([name, a, b, of]),
        };
        buffer.set_stringn(area.x, y, text, width, Style::new());
    }
}

fn render_plot(view: &mut CompareView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
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
    let Some(overlaid) = view.prepare(usize::from(plot.width), dots) else {
        let text = if view.result.is_some() { " neither design has a solution" } else { "" };
        buffer.set_stringn(area.x, area.y, text, usize::from(area.width), theme.faint);
        return;
    };
    let range = Range { low: overlaid.range.0, high: overlaid.range.1 };
    spectrum::draw_levels(range, theme, plot, buffer);
    spectrum::draw_frequencies(&overlaid.axis, theme, plot, buffer);
    let [solid, dashed, _] = theme.marker.dashes();
    let pens = [(solid, Pen { style: theme.fe, letter: 'a' }), (dashed, Pen { style: theme.enhanced, letter: 'b' })];
    let mut canvas = Canvas::new(plot.width, plot.height, theme.marker);
    for (curve, (dash, pen)) in overlaid.curves.iter().zip(pens) {
        draw_curve(&mut canvas, curve, range, dash, pen);
    }
    canvas.render(plot, buffer);
}

/// A line a design, so that like stands below like.
fn render_figures(view: &CompareView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let Some(result) = &view.result else { return };
    for ((name, side), y) in ["A", "B"].into_iter().zip(&result.sides).zip(area.top()..area.bottom()) {
        let mut spans = vec![Span::styled(format!(" {name}: "), theme.title)];
        match side {
            Ok(side) => {
                spans.push(Span::styled("enhanced ", theme.enhanced));
                spans.push(Span::raw(agreement(&side.enhanced, area.width)));
                spans.push(Span::styled("  basic ", theme.basic));
                spans.push(Span::raw(agreement(&side.basic, area.width)));
            }
            Err(_) => spans.push(Span::styled("no agreement without a solution", theme.faint)),
        }
        buffer.set_line(area.x, y, &Line::from(spans), area.width);
    }
}

/// How far a model can be trusted, in as many words as there is room for.
fn agreement(agreement: &Agreement, width: u16) -> String {
    let limit = if agreement.agreement_limit_hz > 0.0 { grouped(agreement.agreement_limit_hz) } else { "0".into() };
    let rms = agreement.rms_db;
    match width {
        100.. => format!("trust to {limit:>6} Hz, {rms:>5.2} dB RMS, FRAC {:.2}", agreement.frac),
        80.. => format!("to {limit:>6} Hz, {rms:>5.2} dB RMS"),
        _ => format!("{limit:>6} Hz {rms:>5.2} dB"),
    }
}
