//! The spectra over the whole window.
//!
//! ```text
//!  header
//! ┌ Dynamic mesh force, dB re 1 N ─── ━ FE  ╍ enhanced  ┈ basic  ░ >3 dB ┐
//! │ curves, bands, numbered peaks, the cursor                            │
//! ├ enhanced − FE, dB ───────────────────────────────────────────────────┤
//! │ lower panel                                                          │
//! ├ Bands ───────────────────────────────────────────────────────────────┤
//! │ list; where the window is wide, it stands at the side                │
//! └──────────────────────────────────────────────────────────────────────┘
//!  readout, two rows
//!  footer
//! ```

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::text::{Line, Span};

use crate::model::ModelKind;
use crate::number::grouped;
use crate::text::{cut, printable, wrap};
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::keymap::Mode;
use crate::tui::spectra::{Listed, Lower, Quantity, SpectraView};
use crate::tui::theme::Theme;
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::plot::{GUTTER, curve_width};
use crate::tui::widgets::{figures, findings_list, footer, header, wide_plot};

/// From here on the list stands at the side, and no name in it is cut.
const WIDE: u16 = 190;
const SIDE: u16 = 96;
/// Rows inside the frame from which on there is room for a list below.
const HIGH: u16 = 16;
const LIST_ROWS: u16 = 5;
/// Rows from which on the list has more.
const VERY_HIGH: u16 = 30;
const MORE_LIST_ROWS: u16 = 9;

/// Draws the screen over the whole frame.
pub fn render(app: &mut App, frame: &mut Frame) -> Option<Position> {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    let row = |y: u16, height: u16| Rect { y: area.y + y, height, ..area };
    let theme = app.theme;
    let keys = app.keys.names(Mode::Spectra, theme.glyphs.ascii);
    let shows = [Action::ShowFe, Action::ShowEnhanced, Action::ShowBasic].map(|action| keys.of(action)).join(" ");
    if let Some(view) = &mut app.spectra {
        header::render_named(&printable(&view.name), &theme, row(0, 1), buffer);
        let body = super::body(area);
        view.give_list(area.width >= WIDE || body.height >= HIGH + 2);
        let is_listed = view.listed != Listed::Nothing;
        if view.is_list_alone() {
            let inner = panel::frame(body, buffer, &findings_list::title(view, &theme), true, &theme);
            findings_list::render(view, &theme, inner, buffer);
        } else if is_listed && area.width >= WIDE {
            let plots = Rect { width: body.width - SIDE, ..body };
            let list = Rect { x: plots.right(), width: SIDE, ..body };
            render_plots(view, false, &shows, &theme, plots, buffer);
            let inner = panel::frame(list, buffer, &findings_list::title(view, &theme), false, &theme);
            findings_list::render(view, &theme, inner, buffer);
        } else {
            render_plots(view, is_listed, &shows, &theme, body, buffer);
        }
        render_readout(view, &theme, row(area.height - 1 - figures::HEIGHT, figures::HEIGHT), buffer);
    }
    footer::render(app, row(area.height - 1, 1), buffer)
}

fn render_plots(view: &mut SpectraView, is_listed: bool, shows: &str, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let inner = panel::frame(area, buffer, &title(view, theme), true, theme);
    if view.known.models.is_empty() || view.lines().is_empty() {
        let text = match &view.failure {
            Some(error) => printable(error).into_owned(),
            None => format!("Solving{}", theme.glyphs.ellipsis),
        };
        let style = if view.failure.is_some() { theme.error } else { theme.faint };
        let lines = wrap(&text, usize::from(inner.width.saturating_sub(2)));
        for (line, y) in lines.iter().zip(inner.top()..inner.bottom()) {
            buffer.set_stringn(inner.x + 1, y, line, usize::from(inner.width.saturating_sub(1)), style);
        }
        return;
    }
    let list = match inner.height {
        _ if !is_listed => 0,
        VERY_HIGH.. => MORE_LIST_ROWS + 1,
        HIGH.. => LIST_ROWS + 1,
        _ => 0,
    };
    let plots = inner.height.saturating_sub(list);
    let lower = (plots * 3 / 10).clamp(3, 10) + 1;
    let upper = plots.saturating_sub(lower);
    let rows = |from: u16, height: u16| Rect { y: inner.y + from, height, ..inner };
    let (dots, _) = theme.marker.dots();
    if view.prepare(usize::from(curve_width(inner)), dots).is_none() {
        return;
    }
    wide_plot::render_upper(view, theme, rows(0, upper), buffer);
    if view.shown_kinds().next().is_none() {
        let text = format!("all models are hidden: {shows} show them");
        let width = usize::from(inner.width.saturating_sub(GUTTER + 2));
        buffer.set_stringn(
            inner.x + GUTTER + 1,
            inner.y + 1,
            cut(&text, width, theme.glyphs.ellipsis),
            width,
            theme.warning,
        );
    }
    panel::divider(area, buffer, inner.y + upper, &lower_title(view, theme), theme);
    wide_plot::render_lower(view, theme, rows(upper + 1, lower - 1), buffer);
    if list > 0 {
        panel::divider(area, buffer, inner.y + plots, &findings_list::title(view, theme), theme);
        findings_list::render(view, theme, rows(plots + 1, list - 1), buffer);
    }
}

fn unit(view: &SpectraView, quantity: Quantity, theme: &Theme) -> String {
    let unit = quantity.unit(theme.glyphs.ascii);
    if view.linear_level { unit.to_owned() } else { format!("dB re 1 {unit}") }
}

fn title(view: &SpectraView, theme: &Theme) -> Title<'static> {
    let mut right = Vec::new();
    for kind in view.shown_kinds() {
        let sample = wide_plot::sample(kind, theme);
        let missing = if view.missing.contains(&kind) { theme.glyphs.broken } else { "" };
        let name = crate::tui::spectra::legend_name(kind);
        right.push(Span::styled(format!("{sample} {name}{missing} "), wide_plot::style(kind, theme)));
    }
    right.push(Span::styled(theme.glyphs.band.to_string(), theme.band));
    right.push(Span::raw(format!(" >{} dB", view.tolerance)));
    if view.pending.is_some() {
        right.push(Span::raw(format!(" solving{}", theme.glyphs.ellipsis)));
    }
    let Some(subject) = &view.known.subject else { return Title { left: vec!["Spectra".into()], right } };
    let unit = unit(view, view.quantity, theme);
    let (long, short) = (view.quantity.title(&subject.design), view.quantity.short(&subject.design));
    Title { left: vec![format!("{long}, {unit}"), format!("{short}, {unit}"), short, unit], right }
}

fn lower_title(view: &SpectraView, theme: &Theme) -> Title<'static> {
    let against = crate::tui::spectra::legend_name(view.against());
    let minus = theme.glyphs.minus;
    let mut left = match view.lower {
        Lower::Difference => {
            vec![
                format!("{against} {minus} FE, dB, line by line (tolerance {})", view.tolerance),
                format!("{against} {minus} FE, dB (tolerance {})", view.tolerance),
                format!("{against} {minus} FE, dB"),
            ]
        }
        Lower::Phase if view.quantity.has_phase() => vec!["Phase, degrees".into()],
        Lower::Phase => vec!["Phase: a resultant has none".into()],
        Lower::Beside => {
            let beside = view.quantity.beside();
            let name = if beside == Quantity::MeshForce { "Dynamic mesh force" } else { "Dynamic transmission error" };
            vec![format!("{name}, {}", unit(view, beside, theme))]
        }
        Lower::SixthOctaves => {
            let limit = view.limit().map_or(Vec::new(), |limit| {
                let [long, short] = limit;
                vec![format!("Sixth octaves, dB; {long}"), format!("Sixth octaves, dB; {short}")]
            });
            limit.into_iter().chain(["Sixth-octave levels, dB".into()]).collect()
        }
    };
    let recovered = |kind: &ModelKind| matches!(kind, ModelKind::Enhanced | ModelKind::Basic);
    if matches!(view.quantity, Quantity::Bearing { .. }) && view.shown_kinds().any(|kind| recovered(&kind)) {
        left =
            left.iter().map(|text| format!("{text}; lumped: recovered by static shapes")).chain(left.clone()).collect();
    }
    // the legend of what stands on the axis above
    let mesh = view.mesh_frequency().map(|(hz, _)| Span::styled(format!("1x: mesh {} Hz", grouped(hz)), theme.faint));
    Title { left, right: mesh.into_iter().collect() }
}

/// Flows over the two rows; what happened to a model comes last.
fn render_readout(view: &SpectraView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let mut spans: Vec<Span<'static>> = Vec::new();
    for item in view.readout(theme.glyphs.ascii) {
        let style = item.kind.map_or(theme.title, |kind| wide_plot::style(kind, theme));
        spans.push(Span::styled(item.text, style));
    }
    if let Some((at, findings)) = view.band_under().zip(view.findings()) {
        let band = findings.bands[at].band;
        let text = format!("band {}/{}, worst {:+.1} dB", at + 1, findings.bands.len(), band.worst_db);
        spans.push(Span::styled(text, theme.beyond));
    }
    if let Some(mode) = view.peak_under().and_then(|peak| peak.mode.as_ref()) {
        spans.push(Span::styled(format!("peak: {mode}"), theme.title));
    }
    if let Some((hz, rpm)) = view.mesh_frequency() {
        spans.push(Span::styled(format!("mesh {} Hz at {} rpm", grouped(hz), grouped(rpm)), theme.faint));
    }
    if let Some(error) = view.failure.as_ref().filter(|_| !view.known.models.is_empty()) {
        spans.push(Span::styled(printable(error).into_owned(), theme.error));
    }
    let mut lines = vec![Line::default()];
    for span in spans {
        let used = lines.last().map_or(0, Line::width);
        if used > 0 && used + span.width() + 2 > usize::from(area.width) {
            lines.push(Line::default());
        }
        if let Some(line) = lines.last_mut() {
            line.push_span(Span::raw(if line.spans.is_empty() { " " } else { "  " }));
            line.push_span(span);
        }
    }
    for (line, y) in lines.iter().zip(area.top()..area.bottom()) {
        buffer.set_line(area.x, y, line, area.width);
    }
}
