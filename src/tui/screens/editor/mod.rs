//! The editor: the tables above, what they do to shafts and spectra below.
//!
//! ```text
//!  header
//!  F1 segments [F2 bearings] F3 bodies ...
//! ┌ pinion bearings ────────────────────────────────────────────────┐
//! │ table                                                           │
//! └ length 170 mm, mass 1.9 kg ─────────────────────────────────────┘
//! ┌ Side view: B1 ────────┐┌ stale: Mesh force ─────────────────────┐
//! │ both shafts           ││ spectra now, over the saved one        │
//! └───────────────────────┘└────────────────────────────────────────┘
//!  figures (was ...)
//!  what is to be said about the cell
//!  footer
//! ```

mod message;
pub(super) mod spectra;

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

use crate::design::{Side, Totals};
use crate::text::printable;
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::bearings;
use crate::tui::editor::{Editing, Layer, Tab, Target};
use crate::tui::keymap::Mode;
use crate::tui::keys::KeyNames;
use crate::tui::theme::Theme;
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::side_view::{self, Element};
use crate::tui::widgets::{
    cell_input, choice, editor_header, figures, findings, footer, matrix, table, tabs, variant_form,
};

/// The lowest pane that shows a spectrum.
const LOWER: u16 = 9;
/// The narrowest screen that shows the side view beside it.
const SIDE_VIEW: u16 = 76;

/// Draws the editor over the whole frame and returns where the cursor stands, if something is typed.
pub fn render(app: &mut App, frame: &mut Frame) -> Option<Position> {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    let row = |y: u16, height: u16| Rect { y: area.y + y, height, ..area };
    let last = area.height - 1;
    let body = row(2, area.height - 4 - figures::HEIGHT);
    let mut cursor = None;
    let (theme, live) = (app.theme, app.editors.live);
    let keys = app.keys.names(Mode::Table, theme.glyphs.ascii);
    if let Some(editing) = app.editors.open_mut() {
        editor_header::render(editing, live, &keys, &theme, row(0, 1), buffer);
        tabs::render(editing, &keys, &theme, row(1, 1), buffer);
        cursor = render_body(editing, live, &keys, &theme, body, buffer);
        spectra::render_figures(editing, &theme, row(last - 1 - figures::HEIGHT, figures::HEIGHT), buffer);
        message::render(editing, &keys, &theme, row(last - 1, 1), buffer);
    }
    footer::render(app, row(last, 1), buffer);
    cursor
}

/// The table, with what lies over it, and the two panes below. Returns where the cursor stands.
fn render_body(
    editing: &mut Editing,
    live: bool,
    keys: &KeyNames<'_>,
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) -> Option<Position> {
    let wanted = table::wanted_height(editing) + 2;
    let upper = if area.height >= 8 + LOWER {
        wanted.clamp(8, (area.height - LOWER).min(area.height * 3 / 5))
    } else {
        area.height
    };
    let frame = Rect { height: upper, ..area };
    let focused = editing.layer.is_none();
    let inner = panel::frame(frame, buffer, &table_title(editing, keys), focused, theme);
    let drawn = table::render(editing, keys, theme, inner, buffer);
    let said = [totals(editing, theme), drawn.position];
    let said: Vec<String> = said.into_iter().flatten().collect();
    let under_load = bearings::in_words(editing).map(|words| format!("{words} ({})", keys.of(Action::BearingLoads)));
    if !said.is_empty() {
        let with_load = under_load.map(|words| format!("{}, {words}", said.join(", ")));
        let short = [said.join(", "), said.last().cloned().unwrap_or_default()];
        let left = with_load.into_iter().chain(short).collect();
        panel::bottom(frame, buffer, &Title { left, right: Vec::new() }, focused, theme);
    }
    let lower = Rect { y: frame.bottom(), height: area.height - upper, ..area };
    if lower.height >= LOWER {
        let side_width = if area.width >= SIDE_VIEW { (area.width * 5 / 12).clamp(24, 38) } else { 0 };
        render_side_view(editing, theme, Rect { width: side_width, ..lower }, buffer);
        let right = Rect { x: lower.x + side_width, width: lower.width - side_width, ..lower };
        spectra::render(editing, live, keys, theme, right, buffer);
    }
    let cell = drawn.cell.unwrap_or(Rect { height: 1, ..inner });
    render_layers(editing, cell, theme, inner, area, buffer)
}

/// What lies over the table and takes the keys.
fn render_layers(
    editing: &mut Editing,
    cell: Rect,
    theme: &Theme,
    inner: Rect,
    area: Rect,
    buffer: &mut Buffer,
) -> Option<Position> {
    if let Some(Layer::Matrix(entry)) = editing.layer {
        return matrix::render(editing, entry, theme, area, buffer);
    }
    if let Some(input) = &editing.input {
        if input.target != Target::NewMaterial {
            return Some(cell_input::render(input, cell, theme, inner, buffer));
        }
        // a row that is not there yet: in the last line, below the materials
        let y = inner.bottom().saturating_sub(1);
        let place = Rect { x: inner.x + 1, y, width: inner.width.min(30), height: 1 };
        return Some(cell_input::render(input, place, theme, inner, buffer));
    }
    let mut layer = editing.layer.take();
    let mut cursor = None;
    match &mut layer {
        Some(Layer::Choice(choice)) => choice::render(choice, cell, theme, area, buffer),
        Some(Layer::Findings(list)) => {
            let is_open = editing.wants_solution();
            findings::render(editing, is_open, list, theme, area, buffer);
        }
        Some(Layer::Form(form)) => {
            let stem = editing.path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            cursor = Some(variant_form::render(form, &stem, theme, area, buffer));
        }
        Some(Layer::Matrix(_)) | None => {}
    }
    editing.layer = layer;
    cursor
}

fn table_title(editing: &Editing, keys: &KeyNames<'_>) -> Title<'static> {
    let title = editing.title();
    if !editing.tab.has_sides() {
        return Title::left(title);
    }
    let other = if editing.side == Side::Pinion { Side::Gear } else { Side::Pinion };
    Title {
        left: vec![format!("{title} ({}: {})", keys.of(Action::OtherShaft), other.name()), title],
        right: Vec::new(),
    }
}

/// What a shaft measures as a whole.
fn totals(editing: &Editing, theme: &Theme) -> Option<String> {
    let design = editing.design.as_ref()?;
    let unit = |value: f64| if value.is_finite() { format!("{value:.2}") } else { "?".into() };
    let shaft = Totals::of(design, editing.side);
    let length = format!("shaft {} mm", unit(shaft.length * 1e3));
    let dot = theme.glyphs.separator;
    match editing.tab {
        Tab::Segments => Some(format!("{length} {dot} {} kg", unit(shaft.shaft_mass))),
        Tab::Bodies => {
            Some(format!("bodies {} kg {dot} with shaft {} kg", unit(shaft.bodies_mass), unit(shaft.mass())))
        }
        Tab::Bearings | Tab::Drives => Some(length),
        _ => None,
    }
}

fn render_side_view(editing: &Editing, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if area.width == 0 {
        return;
    }
    let pointed = pointed(editing);
    let label = pointed.and_then(|_| match editing.tab {
        Tab::Mesh | Tab::Drives => {
            Some(format!("{} {}", editing.side.name(), editing.tab.title().trim_end_matches('s')))
        }
        _ => editing.view.row(editing.cursor().row).map(|row| format!("{} {}", editing.side.name(), row.label)),
    });
    let title = match label {
        Some(label) => vec![format!("Side view: {}", printable(&label)), printable(&label).into_owned()],
        None => vec!["Side view".to_owned()],
    };
    let inner = panel::frame(area, buffer, &Title { left: title, right: Vec::new() }, false, theme);
    if let Some(design) = &editing.last_design {
        side_view::render_with(design, pointed, theme, inner, buffer);
        let legend = match &editing.design {
            Some(_) => side_view::legend(theme),
            None => Title::left("the last state without errors"),
        };
        panel::bottom(area, buffer, &legend, false, theme);
    } else {
        buffer.set_stringn(inner.x, inner.y, " nothing to draw: errors", usize::from(inner.width), theme.faint);
    }
}

/// What of a shaft the cursor is on.
fn pointed(editing: &Editing) -> Option<(Side, Element)> {
    let row = editing.cursor().row;
    editing.view.row(row)?;
    let element = match editing.tab {
        Tab::Segments => Element::Segment(row),
        Tab::Bearings => Element::Bearing(row),
        Tab::Bodies => Element::Body(row),
        Tab::Mesh => Element::Mesh,
        Tab::Drives => Element::Drive,
        _ => return None,
    };
    Some((editing.side, element))
}
