//! The bearings of a design under load, and what the torque does to them and to the spectra.
//!
//! ```text
//!  header
//! ┌ Bearings at 300 N m ──────────────────────────────────────────┐
//! │ a row a bearing                                               │
//! └───────────────────────────────────────────────────────────────┘
//! ┌ Element loads from +y ┐┌ pinion head bearing: roller ──────────┐
//! │ the ring with a bar   ││ load, displacement, 6x6               │
//! │ on each element       │├ Mesh force ───────────────────────────┤
//! └ element 3: 1,234 N ───┘└ spectra now, over the saved one ──────┘
//!  figures (was ...)
//!  what is to be said
//!  footer
//! ```
//!
//! Where there is no room for all of the lower half, some of its panes share one place.

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

use super::editor::spectra;
use crate::number::grouped;
use crate::text::{cut, printable, wrap};
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::bearings::{
    BearingRow, BearingsView, Pane, failure, follows_torque, is_stale, rows, shown_torque, since_saved, torque,
};
use crate::tui::editor::Editing;
use crate::tui::keymap::Mode;
use crate::tui::keys::KeyNames;
use crate::tui::theme::Theme;
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::{bearing_state, bearing_table, editor_header, element_loads, figures, footer};

/// The narrowest screen that shows the picture beside another pane.
const TWO_PANES: u16 = 76;
/// The least rows of numbers above spectra.
const NUMBERS: u16 = bearing_state::HEIGHT + 4;
const SPECTRA: u16 = 9;

/// Of a negative torque.
const NO_SIGN: &str = "the sign of the torque does not count: pinion_turns chooses the flank";

/// Draws the screen over the whole frame; returns where the cursor stands, if the torque is typed.
pub fn render(app: &mut App, frame: &mut Frame) -> Option<Position> {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    let row = |y: u16, height: u16| Rect { y: area.y + y, height, ..area };
    let last = area.height - 1;
    let body = row(1, area.height - 3 - figures::HEIGHT);
    let (theme, live) = (app.theme, app.editors.live);
    let keys = app.keys.names(Mode::Bearings, theme.glyphs.ascii);
    if let (Some(editing), Some(view)) = (app.editors.open_mut(), &mut app.bearings) {
        editor_header::render(editing, live, &keys, &theme, row(0, 1), buffer);
        render_body(editing, view, live, &keys, &theme, body, buffer);
        spectra::render_figures(editing, &theme, row(last - 1 - figures::HEIGHT, figures::HEIGHT), buffer);
        render_message(editing, view, &keys, &theme, row(last - 1, 1), buffer);
    }
    footer::render(app, row(last, 1), buffer)
}

fn render_body(
    editing: &mut Editing,
    view: &mut BearingsView,
    live: bool,
    keys: &KeyNames<'_>,
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) {
    let count = rows(editing).len() as u16;
    let most = area.height.saturating_sub(12).min(area.height / 2).max(4);
    // a spectrum can be low, numbers cannot
    let least = if view.pane == Pane::Spectra { area.height.saturating_sub(6).min(7) } else { 0 };
    let most = most.max(least);
    let upper = Rect { height: (count.saturating_add(3)).clamp(4, most), ..area };
    let inner = panel::frame(upper, buffer, &title(editing), true, theme);
    bearing_table::render(view, &rows(editing), failure(editing), theme, inner, buffer);
    if let Some(position) = view.scroll.position() {
        panel::bottom(upper, buffer, &Title::left(position), true, theme);
    }
    let lower = Rect { y: upper.bottom(), height: area.height - upper.height, ..area };
    let (left, right) = if area.width >= TWO_PANES {
        let left = (2 * lower.height + 2).clamp(26, lower.width * 2 / 5);
        (left, Rect { x: lower.x + left, width: lower.width - left, ..lower })
    } else {
        (0, lower)
    };
    view.shared = match (left > 0, right.height >= NUMBERS + SPECTRA) {
        (true, true) => Vec::new(),
        (true, false) => vec![Pane::Spectra, Pane::State],
        (false, true) => vec![Pane::State, Pane::Elements],
        (false, false) => vec![Pane::Spectra, Pane::State, Pane::Elements],
    };
    if left > 0 {
        render_elements(editing, view, theme, Rect { width: left, ..lower }, buffer);
    }
    let first = view.shared.first().copied();
    let shown = if view.shared.contains(&view.pane) { Some(view.pane) } else { first };
    let upper = Rect { height: NUMBERS, ..right };
    let below = Rect { y: upper.bottom(), height: right.height.saturating_sub(NUMBERS), ..right };
    match (shown, right.height >= NUMBERS + SPECTRA) {
        (Some(Pane::Elements), true) => render_elements(editing, view, theme, upper, buffer),
        (_, true) => render_state(editing, view, theme, upper, buffer),
        (Some(Pane::Elements), false) => render_elements(editing, view, theme, right, buffer),
        (Some(Pane::State), false) => render_state(editing, view, theme, right, buffer),
        (_, false) => spectra::render(editing, live, keys, theme, right, buffer),
    }
    if right.height >= NUMBERS + SPECTRA {
        spectra::render(editing, live, keys, theme, below, buffer);
    }
}

/// At which torque, and which was saved.
fn title(editing: &Editing) -> Title<'static> {
    let stale = if is_stale(editing) { "stale: " } else { "" };
    let shown = |design: &crate::design::Design| match torque(design) {
        Some(torque) => format!("{} N m", shown_torque(torque)),
        None => "no torque".into(),
    };
    let Some(design) = &editing.last_design else { return Title::left("Bearings") };
    if !design.follows_torque() {
        let is_any = |word| rows(editing).iter().any(|row| row.bearing.model.loaded_by() == Some(word));
        let what = match (is_any("preload"), is_any("given")) {
            (true, _) => ": loads by preload, not by the torque",
            (false, true) => ": rings displaced as given, no load by the torque",
            (false, false) => ": no load counts",
        };
        return Title { left: vec![format!("{stale}Bearings{what}"), format!("{stale}Bearings")], right: Vec::new() };
    }
    let now = shown(design);
    let saved = editing.solving.ghost.as_ref().map(|ghost| shown(&ghost.design)).filter(|saved| *saved != now);
    let saved = saved.map_or(String::new(), |saved| format!(" (saved: {saved})"));
    let short = format!("{stale}Bearings at {now}{saved}");
    let long = format!("{short}: mean loads on the inner rings, elements that carry load");
    Title { left: vec![long, short], right: Vec::new() }
}

/// The pane of the selected bearing, and the bearing.
fn selected<'a>(rows: &'a [BearingRow<'a>], view: &BearingsView) -> Option<&'a BearingRow<'a>> {
    rows.get(view.cursor)
}

fn name(row: &BearingRow<'_>) -> String {
    format!("{} {}", row.side.name(), printable(&row.bearing.name))
}

fn render_state(editing: &Editing, view: &BearingsView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let rows = rows(editing);
    let Some(row) = selected(&rows, view) else { return };
    let stale = if is_stale(editing) { "stale: " } else { "" };
    let by = match row.bearing.model.loaded_by() {
        Some("given") => ", displacement given".into(),
        by => by.map_or(String::new(), |by| format!(", load by {by}")),
    };
    let name = format!("{stale}{}: {}{by}", name(row), row.bearing.model.word());
    let inner = panel::frame(area, buffer, &Title::left(name), false, theme);
    bearing_state::render(row, theme, inner, buffer);
    let design = editing.last_design.as_ref();
    let springs = design.map_or("", |design| design.rotor(row.side).springs_of(row.place));
    let left = bearing_state::stiffness_units(springs);
    panel::bottom(area, buffer, &Title { left, right: Vec::new() }, false, theme);
}

fn render_elements(editing: &Editing, view: &BearingsView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let rows = rows(editing);
    let Some(row) = selected(&rows, view) else { return };
    let stale = if is_stale(editing) { "stale: " } else { "" };
    let most = row.rolling.map(|rolling| grouped(rolling.state.greatest_load()));
    let most = most.map_or(String::new(), |most| format!(", longest {most} N"));
    let title = [
        format!("{stale}Element loads of {}, from +y{most}", name(row)),
        format!("{stale}Element loads of {}, from +y", name(row)),
        format!("{stale}Element loads, from +y"),
        format!("{stale}Loads, from +y"),
    ];
    let inner = panel::frame(area, buffer, &Title { left: title.into(), right: Vec::new() }, false, theme);
    let Some(state) = row.rolling.map(|rolling| &rolling.state) else {
        let what = row.bearing.model.word();
        let text = if row.support.is_some() {
            format!("no rolling elements: a {what} bearing is linear")
        } else {
            "not known yet".to_owned()
        };
        for (line, y) in wrap(&text, usize::from(inner.width.saturating_sub(2))).iter().zip(inner.top()..inner.bottom())
        {
            buffer.set_stringn(inner.x + 1, y, line, usize::from(inner.width), theme.faint);
        }
        return;
    };
    element_loads::render(state, view.element, theme, inner, buffer);
    if let Some(contact) = state.contacts.get(view.element) {
        let left = element_loads::readout(view.element, contact).into();

        panel::bottom(area, buffer, &Title { left, right: Vec::new() }, false, theme);
    }
}

/// What happened, what is wrong, or what the torque does here.
fn render_message(
    editing: &Editing,
    view: &BearingsView,
    keys: &KeyNames<'_>,
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) {
    let broken = theme.glyphs.broken;
    let rows = rows(editing);
    let warning = selected(&rows, view).and_then(|row| row.rolling?.state.warnings.first());
    let changed = selected(&rows, view).and_then(|row| since_saved(editing, row));
    let (text, style) = match (&editing.notice, failure(editing)) {
        (Some(notice), _) if notice.is_error => (format!("{broken} {}", notice.text), theme.error),
        (Some(notice), _) => match changed {
            Some(changed) => (format!("{}: {changed}", notice.text), theme.title),
            None => (notice.text.clone(), theme.title),
        },
        (None, Some(reason)) => (format!("{broken} cannot be solved: {reason}"), theme.error),
        (None, None) if warning.is_some() => {
            (format!("! {}", warning.map_or(String::new(), ToString::to_string)), theme.warning)
        }
        (None, None) => match changed {
            Some(changed) => (format!("since saved: {changed}"), theme.fe),
            None => (about_torque(editing, keys), theme.faint),
        },
    };
    let width = usize::from(area.width).saturating_sub(2);
    let text = cut(&printable(&text), width, theme.glyphs.ellipsis);
    buffer.set_stringn(area.x + 1, area.y, text, width, style);
}

fn about_torque(editing: &Editing, keys: &KeyNames<'_>) -> String {
    if !follows_torque(editing) {
        return "no bearing here follows the torque: the spectra do not depend on it".into();
    }
    if editing.last_design.as_ref().and_then(|design| torque(design)).is_some_and(|torque| torque < 0.0) {
        return NO_SIGN.into();
    }
    let [more, less, type_it] =
        [Action::MoreTorque, Action::LessTorque, Action::TypeTorque].map(|action| keys.of(action));
    format!("{more} and {less} change the torque, {type_it} types it; loads and spectra follow")
}
