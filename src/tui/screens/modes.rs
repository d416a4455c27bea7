//! The natural modes of a design.
//!
//! ```text
//!  header
//! ┌ Modes 3 of 40 ──────────────────────────────────────────┐
//! │ FE modes beside their partners                           │
//! ├ FE 3, 236.4 Hz: gear tilt, x-y plane ──── ━ FE  ╍ enh. ──┤
//! │ numbers │ both shafts in two planes                      │
//! └ phase 1 of 8 ────────────────────────────────────────────┘
//!  pinion: bars of the energy in each motion
//!    gear: ...
//!  footer
//! ```

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;
use ratatui::text::Span;

use crate::model::{ModelKind, RecoveryKind};
use crate::number::significant;
use crate::text::{printable, wrap};
use crate::tui::app::App;
use crate::tui::modes::{LUMPED, ModesView, PHASES, ShapeOf, Study};
use crate::tui::theme::Theme;
use crate::tui::widgets::mode_table::hertz;
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::{energy_bars, figures, footer, header, mac_picture, mode_shape, mode_table};

/// Draws the screen over the whole frame.
pub fn render(app: &mut App, frame: &mut Frame) -> Option<Position> {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    let row = |y: u16, height: u16| Rect { y: area.y + y, height, ..area };
    let theme = app.theme;
    if let Some(view) = &mut app.modes {
        header::render_named(&format!("{}: natural modes", view.name), &theme, row(0, 1), buffer);
        render_body(view, &theme, super::body(area), buffer);
        render_figures(view, &theme, row(area.height - 1 - figures::HEIGHT, figures::HEIGHT), buffer);
    }
    footer::render(app, row(area.height - 1, 1), buffer)
}

fn render_body(view: &mut ModesView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let study = match &view.study {
        Some(Ok(study)) => study.clone(),
        other => {
            let text = match other {
                Some(Err(error)) => printable(error).into_owned(),
                _ => format!("Computing the modes of the three models{}", theme.glyphs.ellipsis),
            };
            let inner = panel::frame(area, buffer, &Title::left("Modes"), true, theme);
            for (line, y) in
                wrap(&text, usize::from(inner.width.saturating_sub(2))).iter().zip(inner.top()..inner.bottom())
            {
                buffer.set_stringn(inner.x + 1, y, line, usize::from(inner.width), Style::new());
            }
            return;
        }
    };
    if view.mac.is_some() {
        return render_mac(view, &study, theme, area, buffer);
    }
    let left = format!("Modes {} of {}, partners by MAC", view.cursor + 1, view.rows.len());
    let inner = panel::frame(area, buffer, &Title { left: vec![left, "Modes".into()], right: Vec::new() }, true, theme);
    let room = inner.height.saturating_sub(1);
    let shape = if room >= 20 { room / 2 } else { 10 };
    // the heading and three rows are seen before any shape
    let shape = shape.min(room.saturating_sub(4)) & !1;
    let table = room - shape;
    mode_table::render(view, theme, Rect { height: table, ..inner }, buffer);
    panel::divider(area, buffer, inner.y + table, &shape_title(view, &study, theme), theme);
    let below = Rect { y: inner.y + table + 1, height: shape, ..inner };
    render_shape(view, &study, theme, below, buffer);
    panel::bottom(area, buffer, &bottom(view), true, theme);
}

fn render_shape(view: &ModesView, study: &Study, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    match (&view.deflection_hz, &view.deflection, view.moment()) {
        (Some(_), Some(Err(error)), _) => {
            let text = format!(" {}", printable(error));
            buffer.set_stringn(area.x, area.y, text, usize::from(area.width), theme.error);
        }
        (.., Some(moment)) => mode_shape::render(&moment, &study.design, theme, area, buffer),
        _ => {
            let text = format!(" computing{}", theme.glyphs.ellipsis);
            buffer.set_stringn(area.x, area.y, text, usize::from(area.width), theme.faint);
        }
    }
}

fn shape_title(view: &ModesView, study: &Study, theme: &Theme) -> Title<'static> {
    let mut left = Vec::new();
    if let Some(hz) = view.deflection_hz {
        let what = format!("deflection at {} Hz", significant(hz, 5));
        let force = view.deflection.as_ref().and_then(|found| found.as_ref().ok());
        let force = force.filter(|found| found.at_hz.to_bits() == hz.to_bits()).map(|found| found.fe_force);
        left.extend(force.map(|force| format!("{what}, FE mesh force {} N", significant(force, 4))));
        left.push(what);
    } else if let Some((row, mode)) = view.row().and_then(|row| Some((row, row.mode(study)?))) {
        let number = row.fe.map_or(String::new(), |fe| format!(" {}", fe + 1));
        let what = format!("{}{number}, {} Hz: {}", row.model(), hertz(mode.frequency_hz), mode.name());
        let strain = format!("{:.0} %", 100.0 * mode.mesh_strain_share);
        left.push(format!("{what}; {strain} of the strain in the mesh"));
        left.push(format!("{what}; mesh strain {strain}"));
        left.push(what);
    }
    let [fe, enhanced, basic] = theme.marker.samples();
    let lumped = [(enhanced, theme.enhanced), (basic, theme.basic)];
    let shown = view.moment().map_or(Vec::new(), |moment| moment.shapes.iter().map(|(of, _)| *of).collect());
    let right = shown.into_iter().map(|of| match of {
        ShapeOf::Fe => Span::styled(format!("{fe} FE "), theme.fe),
        ShapeOf::Lumped(model) => Span::styled(format!("{} {} ", lumped[model].0, LUMPED[model]), lumped[model].1),
    });
    Title { left, right: right.collect() }
}

/// The phase, the scale, and how the lumped shape is known.
fn bottom(view: &ModesView) -> Title<'static> {
    let phase = format!("phase {} of {PHASES}", view.phase + 1);
    let Some(moment) = view.moment() else { return Title::left(phase) };
    let has_lumped = moment.shapes.iter().any(|(of, _)| *of != ShapeOf::Fe);
    let mut short = phase;
    if view.deflection_hz.is_some() {
        short = format!("{short}, largest {} m", significant(moment.largest[0], 3));
    }
    let how = RecoveryKind::of(ModelKind::Enhanced).name();
    let long = if has_lumped { format!("{short}, lumped {how}") } else { short.clone() };
    Title { left: vec![long, short], right: Vec::new() }
}

fn render_mac(view: &ModesView, study: &Study, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let Some((row, column)) = view.mac else { return };
    let model = LUMPED[view.lumped];
    let title = Title::left(format!("MAC of the {model} model with finite elements"));
    let inner = panel::frame(area, buffer, &title, true, theme);
    mac_picture::render(view, theme, Rect { height: inner.height.saturating_sub(1), ..inner }, buffer);
    let hz = |modes: &crate::response::Modes, at: usize| {
        modes.0.get(at).map_or(String::new(), |mode| hertz(mode.frequency_hz))
    };
    let value = study.mac[view.lumped].get((row, column)).copied().unwrap_or(0.0);
    let readout = format!(
        " {model} {} ({} Hz) with FE {} ({} Hz): MAC {value:.3}",
        row + 1,
        hz(&study.lumped[view.lumped].modes, row),
        column + 1,
        hz(&study.fe.modes, column)
    );
    buffer.set_stringn(inner.x, inner.bottom().saturating_sub(1), readout, usize::from(inner.width), theme.title);
    panel::bottom(area, buffer, &Title::left(mac_picture::legend(theme.glyphs.ascii)), true, theme);
}

fn render_figures(view: &ModesView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let Some(study) = view.study() else { return };
    let mode = match view.mac {
        // both modes under the cursor, in words
        Some((row, column)) => {
            let models =
                [(LUMPED[view.lumped], &study.lumped[view.lumped].modes, row), ("FE", &study.fe.modes, column)];
            for ((name, modes, at), y) in models.into_iter().zip(area.top()..area.bottom()) {
                let named = modes.0.get(at).map_or(String::new(), crate::response::Mode::name);
                buffer.set_stringn(
                    area.x,
                    y,
                    format!(" {name:>8} {}: {named}", at + 1),
                    usize::from(area.width),
                    Style::new(),
                );
            }
            return;
        }
        None => view.row().and_then(|row| row.mode(study)),
    };
    if let Some(mode) = mode {
        energy_bars::render(mode, theme, area, buffer);
    }
}
