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

use crate::pair::scenes;
use crate::text::{cut, printable, wrap};
use crate::tui::app::App;
use crate::tui::editor::{Editing, Tab};
use crate::tui::pair::{PairView, Shown};
use crate::tui::theme::Theme;
use crate::tui::widgets::panel::{self, Title};
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
        [scene] => {
            let short = scene.title.split(':').next().unwrap_or_default().to_owned();
            vec![scene.title.clone(), short]
        }
        _ => vec!["each shaft from its +y end, z up, x left".into(), "from +y, z up, x left".into(), "z up, x left".into()],
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

/// Which way the thrust acts, and what there is to be said.
fn render_said(editing: &Editing, shown: Option<&Shown>, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width);
    let mut say = |y: u16, text: &str, style: Style| {
        let text = cut(&printable(text), width.saturating_sub(1), theme.glyphs.ellipsis);
        buffer.set_stringn(area.x, area.y + y, text, width, style);
    };
    if let Some(shown) = shown {
        let figures = &shown.figures;
        if figures.pulls_into_mesh() {
            say(0, &format!(" ! {}", figures.thrust()), theme.warning);
        } else {
            say(0, &format!(" {}", figures.thrust()), theme.title);
        }
    }
    if let Some(notice) = &editing.notice {
        let style = if notice.is_error { theme.error } else { theme.title };
        return say(1, &format!(" {}", notice.text), style);
    }
    // the thrust is said already
    let problems = editing.problems();
    let of_mesh = |path: &crate::design::KeyPath| Tab::of(path).0 == Tab::Mesh;
    let other = problems
        .iter()
        .find(|finding| of_mesh(&finding.key_path) && !finding.message.starts_with(crate::gear::THRUST_INTO_MESH));
    if let Some(finding) = other {
        let sentence = editing.sentences(std::slice::from_ref(finding)).concat();
        say(1, &format!(" ! {sentence}"), theme.warning);
    }
}
