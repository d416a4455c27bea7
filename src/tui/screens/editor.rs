//! The editor: the tables above, what they do to shafts and spectra below.
//!
//! ```text
//!  header
//!  1 segments [2 bearings] 3 bodies ...
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

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::design::grid::{Cell, CellKind, Shown};
use crate::design::{Side, Totals};
use crate::number::grouped;
use crate::text::{cut, printable, wrap};
use crate::tui::app::App;
use crate::tui::editor::{Editing, Layer, Place, Tab, Target};
use crate::tui::theme::Theme;
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::side_view::{self, Element};
use crate::tui::widgets::{
    cell_input, choice, difference_strip, editor_header, figures, findings, footer, matrix, plot, spectrum, table,
    tabs, text_pane, variant_form,
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
    if let Some(editing) = app.editors.open_mut() {
        editor_header::render(editing, live, &theme, row(0, 1), buffer);
        tabs::render(editing.tab, &theme, row(1, 1), buffer);
        cursor = render_body(editing, live, &theme, body, buffer);
        render_figures(editing, &theme, row(last - 1 - figures::HEIGHT, figures::HEIGHT), buffer);
        render_message(editing, &theme, row(last - 1, 1), buffer);
    }
    footer::render(app, row(last, 1), buffer);
    cursor
}

/// The table, with what lies over it, and the two panes below. Returns where the cursor stands.
fn render_body(editing: &mut Editing, live: bool, theme: &Theme, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let wanted = table::wanted_height(editing) + 2;
    let upper = if area.height >= 8 + LOWER {
        wanted.clamp(8, (area.height - LOWER).min(area.height * 3 / 5))
    } else {
        area.height
    };
    let frame = Rect { height: upper, ..area };
    let focused = editing.layer.is_none();
    let inner = panel::frame(frame, buffer, &table_title(editing), focused, theme);
    let drawn = table::render(editing, theme, inner, buffer);
    let said = [totals(editing, theme), drawn.position];
    let said: Vec<String> = said.into_iter().flatten().collect();
    if !said.is_empty() {
        let left = vec![said.join(", "), said.last().cloned().unwrap_or_default()];
        panel::bottom(frame, buffer, &Title { left, right: Vec::new() }, focused, theme);
    }
    let lower = Rect { y: frame.bottom(), height: area.height - upper, ..area };
    if lower.height >= LOWER {
        let side_width = if area.width >= SIDE_VIEW { (area.width * 5 / 12).clamp(24, 38) } else { 0 };
        render_side_view(editing, theme, Rect { width: side_width, ..lower }, buffer);
        let right = Rect { x: lower.x + side_width, width: lower.width - side_width, ..lower };
        render_spectra(editing, live, theme, right, buffer);
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
    let count = editing.findings().len();
    let mut layer = editing.layer.take();
    let mut cursor = None;
    match &mut layer {
        Some(Layer::Choice(choice)) => choice::render(choice, cell, theme, area, buffer),
        Some(Layer::Findings(list)) => {
            list.cursor = list.cursor.min(count.saturating_sub(1));
            findings::render(editing.findings(), list, theme, area, buffer);
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

fn table_title(editing: &Editing) -> Title<'static> {
    let title = editing.title();
    if !editing.tab.has_sides() {
        return Title::left(title);
    }
    let other = if editing.side == Side::Pinion { Side::Gear } else { Side::Pinion };
    Title { left: vec![format!("{title} (p: {})", other.name()), title], right: Vec::new() }
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

/// Whether the spectra are those of the design as it is now, and if not, why.
fn state(editing: &Editing, live: bool) -> String {
    let stale = if editing.is_stale() { "stale, " } else { "" };
    if let Some(pending) = &editing.solving.pending {
        return format!("{stale}solving {:.0} %", pending.done * 100.0);
    }
    let errors = editing.editor.reading().errors().count();
    match &editing.design {
        None if errors == 1 => format!("{stale}not solved: 1 error"),
        None => format!("{stale}not solved: {errors} errors"),
        Some(design) if editing.solving.failure(design).is_some() => format!("{stale}cannot be solved"),
        Some(_) if editing.solving.current.is_none() => "not solved".into(),
        Some(_) if editing.is_stale() && live => "stale: = solves".into(),
        Some(_) if editing.is_stale() => "stale, live off: = solves".into(),
        Some(_) => String::new(),
    }
}

fn render_spectra(editing: &mut Editing, live: bool, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let state = state(editing, live);
    let why = why_not(editing);
    let modified = editing.is_modified();
    let Some(solution) = &mut editing.solving.current else {
        let title = if state.is_empty() { "Spectra" } else { &state };
        let solving = format!("Solving the three models{}", theme.glyphs.ellipsis);
        let waits = "= solves the three models, L solves them after each edit.";
        let text = why.unwrap_or_else(|| if editing.solving.pending.is_some() { solving } else { waits.into() });
        let style = Style::new();
        text_pane::render((title, &text, style), &mut crate::tui::app::Scroll::default(), true, theme, area, buffer);
        return;
    };
    let name = ["Dynamic mesh force, dB re 1 N", "Mesh force, dB re 1 N", "dB re 1 N"];
    let left = name.iter().map(|name| if state.is_empty() { (*name).to_owned() } else { format!("{state} - {name}") });
    let left: Vec<String> = left.chain((!state.is_empty()).then(|| state.clone())).collect();
    let inner = panel::frame(area, buffer, &Title { left, right: Vec::new() }, false, theme);
    let strip_height = if inner.height >= 18 { (inner.height * 3 / 10).clamp(3, 7) | 1 } else { 0 };
    let upper =
        Rect { height: inner.height.saturating_sub(if strip_height > 0 { strip_height + 1 } else { 0 }), ..inner };
    let (dots, _) = theme.marker.dots();
    let width = usize::from(plot::curve_width(inner));
    solution.picture.prepare(width, dots);
    let axis = solution.picture.traces.axis;
    let ghost = editing.solving.ghost.as_mut().filter(|_| modified);
    let ghost = ghost.map(|ghost| ghost.columns(axis, width));
    let trust = solution.summary.enhanced.agreement_limit_hz;
    spectrum::render_over(&solution.picture, ghost, trust, theme, upper, buffer);
    let right = spectrum::legend(theme, ghost.is_some());
    if strip_height > 0 {
        let strip = Rect { y: upper.bottom() + 1, height: strip_height, ..inner };
        panel::divider(area, buffer, upper.bottom(), &difference_strip::title(theme), theme);
        difference_strip::render(&solution.picture, theme, strip, buffer);
    }
    panel::bottom(area, buffer, &Title { left: Vec::new(), right }, false, theme);
    if let Some(why) = why {
        let room = usize::from(upper.width.saturating_sub(plot::GUTTER + 3));
        let lines = wrap(&format!("{} {why}", theme.glyphs.broken), room);
        for (line, y) in lines.iter().take(3).zip(upper.top()..upper.bottom()) {
            let x = upper.x + plot::GUTTER;
            buffer.set_stringn(x, y, format!(" {line} "), room + 2, theme.error);
        }
    }
}

/// Why the design as it is now has no solution.
fn why_not(editing: &Editing) -> Option<String> {
    match &editing.design {
        None => editing.editor.reading().errors().next().map(findings::sentence),
        Some(design) => editing.solving.failure(design).map(str::to_owned),
    }
}

fn render_figures(editing: &Editing, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let Some(solution) = &editing.solving.current else {
        let text = " agreement: not known yet";
        buffer.set_stringn(area.x, area.y, text, usize::from(area.width), theme.faint);
        return;
    };
    let stale = if editing.is_stale() { " stale" } else { "" };
    let ghost = editing.solving.ghost.as_ref().filter(|_| editing.is_modified()).map(|ghost| &ghost.summary);
    let x = area.x + stale.len() as u16;
    buffer.set_stringn(area.x, area.y, stale, usize::from(area.width), theme.warning);
    let right = Rect { x, width: area.width - stale.len() as u16, ..area };
    figures::render_models(&solution.summary, ghost, theme, right, buffer);
}

/// One line about the cell under the cursor: what happened, what is wrong, what can be typed.
fn render_message(editing: &Editing, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let Message { text, more, style } = message(editing, theme);
    let width = usize::from(area.width).saturating_sub(2);
    let text = cut(&printable(&text), width.saturating_sub(more.width()), theme.glyphs.ellipsis) + &more;
    buffer.set_stringn(area.x + 1, area.y, text, width, style);
}

struct Message {
    text: String,
    /// Stays where the text has to be cut.
    more: String,
    style: Style,
}

impl Message {
    fn new(text: String, style: Style) -> Self {
        Self { text, more: String::new(), style }
    }
}

fn message(editing: &Editing, theme: &Theme) -> Message {
    let broken = theme.glyphs.broken;
    if let Some(input) = &editing.input {
        return match (&input.error, editing.target()) {
            (Some(error), _) => Message::new(format!("{broken} {error}"), theme.error),
            (None, Some(cell)) => Message::new(about_cell(cell), theme.faint),
            (None, None) => Message::new("a name".into(), theme.faint),
        };
    }
    if let Some(notice) = &editing.notice {
        let mark = if notice.is_error { format!("{broken} ") } else { String::new() };
        let style = if notice.is_error { theme.error } else { theme.title };
        return Message::new(format!("{mark}{}", notice.text), style);
    }
    let places = findings_here(editing);
    if let Some(finding) = places.first().and_then(|&at| editing.findings().get(at)) {
        let (mark, style) = table::severity_mark(finding.severity, theme);
        let hint = finding.hint.as_ref().map_or(String::new(), |hint| format!(" ({hint})"));
        let more = if places.len() > 1 { format!(" (f: {} more)", places.len() - 1) } else { String::new() };
        return Message { text: format!("{mark} {}{hint}", finding.message), more, style };
    }
    if let Some(reason) = editing.design.as_ref().and_then(|design| editing.solving.failure(design)) {
        return Message::new(format!("{broken} cannot be solved: {reason}"), theme.error);
    }
    let cursor = editing.cursor();
    let text = match (editing.target(), editing.view.place(cursor.row, cursor.column)) {
        (Some(cell), _) => about_cell(cell),
        (None, Some(Place::Matrix)) => "6x6 stiffness: Enter opens it".into(),
        (None, Some(Place::Name)) => "the material's name: Enter renames it, also where segments name it".into(),
        (None, _) => String::new(),
    };
    Message::new(text, theme.faint)
}

/// The findings about the cell under the cursor, or else about its row but none of its cells, or about the whole list.
fn findings_here(editing: &Editing) -> Vec<usize> {
    let cursor = editing.cursor();
    let places = match editing.entry() {
        Some(entry) => entry.findings.clone(),
        None => editing.view.findings(cursor.row, cursor.column),
    };
    if !places.is_empty() || editing.view.is_turned() {
        return places;
    }
    let row = editing.view.row(cursor.row);
    let is_of_cell = |at: &usize| row.is_some_and(|row| row.cells.iter().any(|cell| cell.findings.contains(at)));
    let of_row = row.into_iter().flat_map(|row| &row.findings).copied().filter(|at| !is_of_cell(at));
    of_row.chain(editing.view.list_findings().iter().copied()).collect()
}

/// What a cell holds and what can be typed into it.
fn about_cell(cell: &Cell) -> String {
    if matches!(cell.kind, CellKind::MatrixEntry(..)) {
        return format!("stiffness {} [{}]; 600 N/um or 1.5e5 are typed alike", cell.column.label, cell.column.unit);
    }
    let wanted = match cell.kind {
        CellKind::Number(quantity, limit) => {
            let limit = limit.describe(quantity);
            if limit.is_empty() { cell.column.unit.to_owned() } else { limit }
        }
        CellKind::VectorEntry(_) | CellKind::MatrixEntry(..) => cell.column.unit.to_owned(),
        CellKind::Whole(low, high) if high < 1_000_000_000 => {
            format!("whole, {} to {}", grouped(low as f64), grouped(high as f64))
        }
        CellKind::Whole(low, _) => format!("whole, at least {low}"),
        CellKind::Text | CellKind::Name => "text".into(),
        CellKind::Texts => "words with commas between".into(),
        CellKind::Choice(_) | CellKind::Flags(_) | CellKind::Model(_) => cell.kind.words().join(", "),
    };
    let presence = match (&cell.shown, cell.required) {
        (_, true) => "",
        (Shown::Default(_), false) => " Not written: the default holds.",
        (Shown::Nothing, false) => " Not written.",
        (Shown::Written(_), false) => " (x clears)",
    };
    let wanted = if wanted.is_empty() { wanted } else { format!("[{wanted}] ") };
    format!("{wanted}{}{presence}", cell.column.doc)
}
