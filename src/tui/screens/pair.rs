//! The gear pair of a design.
//!
//! ```text
//!  header
//! ┌ spiral-bevel: pitch cones ────┐┌ Numbers ──────────────────────┐
//! │ picture to scale              ││             pinion       gear  │
//! │                               ││ axial force  +8840      +1984 N│
//! └ a axial r radial ... ─────────┘└ lines 1-12 of 25 ─────────────┘
//!  which way the thrust acts
//!  what is to be said about the mesh
//!  footer
//! ```

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;

use crate::gear::THRUST_INTO_MESH;
use crate::pair::scenes;
use crate::text::{cut, printable, wrap};
use crate::tui::app::App;
use crate::tui::editor::{Editing, Tab};
use crate::tui::pair::{PairView, Shown};
use crate::tui::theme::Theme;
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::table::severity_mark;
use crate::tui::widgets::{figures, footer, header, pair_numbers, pair_picture};

/// Columns that the numbers take.
const NUMBERS: u16 = 40;

/// Draws the screen over the whole frame.
pub fn render(app: &mut App, frame: &mut Frame) -> Option<Position> {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    let row = |y: u16, height: u16| Rect { y: area.y + y, height, ..area };
    let theme = app.theme;
    if let (Some(view), Some(editing)) = (&mut app.pair, app.editors.open()) {
        let stem = editing.path.file_stem().unwrap_or_default().to_string_lossy();
        let unsaved = if editing.is_modified() { " (unsaved edits)" } else { "" };
        header::render_named(&format!("{}{unsaved}: gear pair", printable(&stem)), &theme, row(0, 1), buffer);
        let shown = Shown::new(editing);
        render_body(view, editing, shown.as_ref(), &theme, super::body(area), buffer);
        let below = row(area.height - 1 - figures::HEIGHT, figures::HEIGHT);
        render_said(editing, shown.as_ref(), &theme, below, buffer);
    }
    footer::render(app, row(area.height - 1, 1), buffer)
}

fn render_body(
    view: &mut PairView,
    editing: &Editing,
    shown: Option<&Shown>,
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) {
    let Some(shown) = shown else {
        let inner = panel::frame(area, buffer, &Title::left("No gear pair: the design has errors"), true, theme);
        let errors = editing.sentences(&editing.problems());
        let room = usize::from(inner.width.saturating_sub(2));
        let lines = errors.iter().flat_map(|line| wrap(&printable(line), room));
        for (line, y) in lines.zip(inner.top()..inner.bottom()) {
            buffer.set_stringn(inner.x + 1, y, line, room, theme.error);
        }
        return;
    };
    let left = Rect { width: area.width.saturating_sub(NUMBERS), ..area };
    let right = Rect { x: area.x + left.width, width: area.width - left.width, ..area };
    render_picture(shown, theme, left, buffer);
    let title = if shown.is_outdated { "Numbers from before the errors" } else { "Numbers" };
    let inner = panel::frame(right, buffer, &Title::left(title), true, theme);
    pair_numbers::render(shown, &mut view.scroll, theme, inner, buffer);
    if let Some(position) = view.scroll.position() {
        panel::bottom(right, buffer, &Title::left(format!("lines {position}")), true, theme);
    }
}

fn render_picture(shown: &Shown, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let scenes = scenes(&shown.design, &shown.figures);
    let left = match &scenes[..] {
        [scene] => scene.titles.clone(),
        _ => vec![
            "each shaft to its own scale, from its +y end, z up, x left".into(),
            "own scales, from +y: z up, x left".into(),
            "z up, x left".into(),
        ],
    };
    let inner = panel::frame(area, buffer, &Title { left, right: Vec::new() }, false, theme);
    panel::bottom(area, buffer, &Title { left: pair_picture::legend(theme), right: Vec::new() }, false, theme);
    if scenes.is_empty() {
        buffer.set_stringn(inner.x, inner.y, " nothing to draw", usize::from(inner.width), theme.faint);
    }
    let count = (scenes.len() as u16).max(1);
    // cells are twice as high as wide
    let is_beside = inner.width > 2 * inner.height;
    for (at, scene) in (0_u16..).zip(&scenes) {
        let place = if is_beside {
            let width = inner.width / count;
            Rect { x: inner.x + at * width, width, ..inner }
        } else {
            let height = inner.height / count;
            Rect { y: inner.y + at * height, height, ..inner }
        };
        pair_picture::render(scene, theme, place, buffer);
    }
}

/// Which way the thrust acts, and what there is to be said; where that is nothing, the thrust has both lines.
fn render_said(editing: &Editing, shown: Option<&Shown>, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width);
    let mut lines: Vec<(String, Style)> = Vec::new();
    if let Some(shown) = shown {
        let figures = &shown.figures;
        let (mark, style) = if figures.pulls_into_mesh() { ("! ", theme.warning) } else { ("", theme.title) };
        let text = format!("{mark}{}", figures.thrust());
        lines.extend(wrap(&text, width.saturating_sub(2)).into_iter().map(|line| (line, style)));
    }
    if let Some(said) = said(editing, theme) {
        let room = width.saturating_sub(2);
        // of a thrust in two lines the first is read
        let is_long = lines.len() > 1;
        if let Some((line, _)) = lines.first_mut().filter(|_| is_long) {
            *line = cut(&format!("{line}{}", theme.glyphs.ellipsis), room, theme.glyphs.ellipsis);
        }
        lines.truncate(1);
        lines.push((cut(&printable(&said.0), room, theme.glyphs.ellipsis), said.1));
    }
    for ((line, style), y) in lines.into_iter().zip(area.top()..area.bottom()) {
        buffer.set_stringn(area.x + 1, y, line, width.saturating_sub(1), style);
    }
}

/// What happened last, else what is wrong or unusual in the mesh besides the thrust.
fn said(editing: &Editing, theme: &Theme) -> Option<(String, Style)> {
    if let Some(notice) = &editing.notice {
        return Some((notice.text.clone(), if notice.is_error { theme.error } else { theme.title }));
    }
    let problems = editing.problems();
    let other = problems
        .iter()
        .find(|finding| Tab::of(&finding.key_path).0 == Tab::Mesh && !finding.message.starts_with(THRUST_INTO_MESH))?;
    let sentence = editing.sentences(std::slice::from_ref(other)).concat();
    let (mark, style) = severity_mark(other.severity, theme);
    Some((format!("{mark} {sentence}"), style))
}
