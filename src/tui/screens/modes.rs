//! The natural modes of a design.
//!
//! ```text
//!  header
//! ┌ Modes 3 of 40 ──────────────────────────────────────────┐
//! │ FE modes beside their partners                           │
//! ├ FE 3, 236.4 Hz: gear tilt, x-y plane ──── ━ FE  e enh. ──┤
//! │ numbers │ both shafts in two planes                      │
//! └ phase 0 deg, numbers are parts of the largest ───────────┘
//!  FE   pinion: bars of the energy in each motion
//!         gear: ...
//!  enh. ...
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
use crate::tui::modes::{ModesView, PHASES, Study};
use crate::tui::spectra::legend_name;
use crate::tui::theme::Theme;
use crate::tui::widgets::mode_table::hertz;
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::{deflection_figures, energy_bars, footer, header, mac_picture, mode_shape, mode_table};

/// Rows of the smallest terminal in which the partner's energy stands below that of finite elements.
const BOTH_ENERGIES: u16 = 24;

/// Draws the screen over the whole frame.
pub fn render(app: &mut App, frame: &mut Frame) -> Option<Position> {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    let row = |y: u16, height: u16| Rect { y: area.y + y, height, ..area };
    let theme = app.theme;
    if let Some(view) = &mut app.modes {
        header::render_named(&format!("{}: natural modes", view.name), &theme, row(0, 1), buffer);
        let below = if area.height >= BOTH_ENERGIES { 2 * energy_bars::ROWS } else { energy_bars::ROWS };
        // what needs less is not spread over more
        let below = if view.mac.is_some() || view.study().is_none() { energy_bars::ROWS } else { below };
        render_body(view, &theme, row(1, area.height.saturating_sub(2 + below)), buffer);
        render_figures(view, &theme, row(area.height - 1 - below, below), buffer);
    }
    footer::render(app, row(area.height - 1, 1), buffer)
}

fn render_body(view: &mut ModesView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let study = match &view.study {
        Some(Ok(study)) => study.clone(),
        other => {
            let text = match other {
                Some(Err(error)) => printable(error).into_owned(),
                _ => format!("Computing the modes of all models{}", theme.glyphs.ellipsis),
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
    let shape = if room >= 20 { room / 2 } else { 8 };
    // the heading and three rows are seen before any shape
    let shape = shape.min(room.saturating_sub(4)) & !1;
    let table = room - shape;
    mode_table::render(view, theme, Rect { height: table, ..inner }, buffer);
    panel::divider(area, buffer, inner.y + table, &shape_title(view, &study, theme), theme);
    let below = Rect { y: inner.y + table + 1, height: shape, ..inner };
    render_shape(view, &study, theme, below, buffer);
    panel::bottom(area, buffer, &bottom(view, &study, theme, area.width), true, theme);
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
        left.push(format!("operating deflection at {} Hz", significant(hz, 5)));
        left.push(format!("deflection at {} Hz", significant(hz, 5)));
    } else if let Some((row, mode)) = view.row().and_then(|row| Some((row, row.mode(study)?))) {
        let number = row.fe.map_or(String::new(), |fe| format!(" {}", fe + 1));
        let model = legend_name(row.kind(study));
        left.push(format!("{model}{number}, {} Hz: {}", hertz(mode.frequency_hz), mode.name()));
    }
    let shown = view.moment().map_or(Vec::new(), |moment| moment.shapes.iter().map(|(of, _)| *of).collect());
    let right = shown.into_iter().map(|of| {
        let (sample, style) = mode_shape::sample(of, theme);
        Span::styled(format!("{sample} {} ", legend_name(of)), style)
    });
    Title { left, right: right.collect() }
}

/// The phase, the scale, and how the partner's shape is known.
fn bottom(view: &ModesView, study: &Study, theme: &Theme, width: u16) -> Title<'static> {
    let phase = format!("phase {} deg", 360 / PHASES * view.phase);
    if view.is_reducing {
        return Title::left(format!("computing reduced:{}{}", view.reduced, theme.glyphs.ellipsis));
    }
    let Some(moment) = view.moment() else { return Title::left(phase) };
    let mode = view.row().and_then(|row| row.mode(study)).filter(|_| view.deflection_hz.is_none());
    if let Some(mode) = mode.filter(|_| width < energy_bars::WHOLE) {
        let strain = format!("{phase}, {:.0} % of the strain in the mesh", 100.0 * mode.mesh_strain_share);
        return Title { left: vec![strain, phase], right: Vec::new() };
    }
    let scale = format!("{phase}, numbers are parts of the largest");
    let partner = moment.shapes.iter().map(|(of, _)| *of).find(|of| *of != ModelKind::Fe);
    let how =
        partner.map_or(scale.clone(), |of| format!("{scale}; {} {}", legend_name(of), RecoveryKind::of(of).name()));
    Title { left: vec![how, scale, phase], right: Vec::new() }
}

fn render_mac(view: &ModesView, study: &Study, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let (Some((row, column)), Some(small)) = (view.mac, study.one(view.model)) else {
        panel::frame(area, buffer, &bottom(view, study, theme, area.width), true, theme);
        return;
    };
    let model = legend_name(small.own.kind());
    let title = Title::left(format!("MAC of the {model} model with finite elements"));
    let inner = panel::frame(area, buffer, &title, true, theme);
    mac_picture::render(view, theme, Rect { height: inner.height.saturating_sub(1), ..inner }, buffer);
    let hz = |modes: &crate::response::Modes, at: usize| {
        modes.0.get(at).map_or(String::new(), |mode| hertz(mode.frequency_hz))
    };
    let value = small.mac.get((row, column)).copied().unwrap_or(0.0);
    let readout = format!(
        " {model} {} ({} Hz) with FE {} ({} Hz): MAC {value:.3}",
        row + 1,
        hz(&small.own.modes, row),
        column + 1,
        hz(&study.fe.modes, column)
    );
    buffer.set_stringn(inner.x, inner.bottom().saturating_sub(1), readout, usize::from(inner.width), theme.title);
    panel::bottom(area, buffer, &Title::left(mac_picture::legend(theme.glyphs.ascii)), true, theme);
}

fn render_figures(view: &ModesView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let Some(study) = view.study() else { return };
    if let Some((row, column)) = view.mac {
        return render_names(study, view.model, [row, column], area, buffer);
    }
    match (&view.deflection_hz, &view.deflection) {
        (Some(_), Some(Ok(found))) => deflection_figures::render(study, found, theme, area, buffer),
        (Some(_), _) => {}
        (None, _) => energy_bars::render(&view.pair(), theme, area, buffer),
    }
}

/// Both modes under the cursor of the MAC, in words.
fn render_names(study: &Study, model: usize, places: [usize; 2], area: Rect, buffer: &mut Buffer) {
    let Some(small) = study.one(model) else { return };
    let models = [&small.own, &*study.fe];
    for ((one, at), y) in models.into_iter().zip(places).zip(area.top()..area.bottom()) {
        let named = one.modes.0.get(at).map_or(String::new(), crate::response::Mode::name);
        let text = format!(" {:>10} {}: {named}", legend_name(one.kind()), at + 1);
        buffer.set_stringn(area.x, y, text, usize::from(area.width), Style::new());
    }
}
