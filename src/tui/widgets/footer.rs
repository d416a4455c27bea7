//! The last line: the filter while it is typed, and what the keys do.
//!
//! ```text
//!  /over▏  Enter keep filter  Esc back
//!  ↑↓ move  / filter  ? help  q quit  R reread
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use unicode_width::UnicodeWidthStr;

use crate::design::grid::{CellKind, Shape};
use crate::text::{cut, cut_start, printable};
use crate::tui::action::{ACTIONS, Action};
use crate::tui::app::App;
use crate::tui::editor::{Editing, Layer};
use crate::tui::keymap::{self, Mode};

/// Draws the line and returns where the cursor stands, if something is typed.
pub fn render(app: &App, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    if area.height == 0 || area.width == 0 {
        return None;
    }
    let theme = &app.theme;
    let ellipsis = theme.glyphs.ellipsis;
    let mut x = area.x;
    let mut cursor = None;
    if app.mode == Mode::Filter {
        let room = usize::from(area.width / 2).saturating_sub(3);
        let typed = cut_start(&printable(app.library.filter()), room, ellipsis);
        x = buffer.set_stringn(x, area.y, format!(" /{typed}"), usize::from(area.width), theme.title).0;
        cursor = Some(Position::new(x.min(area.right() - 1), area.y));
        x = (x + 2).min(area.right());
    } else if let Some(notice) = &app.notice {
        let text =
            format!(" {} {}", theme.glyphs.broken, cut(&printable(notice), usize::from(area.width / 2), ellipsis));
        x = buffer.set_stringn(x, area.y, text, usize::from(area.width), theme.error).0 + 1;
    }
    for (keys, text) in hints(app, usize::from(area.right().saturating_sub(x))) {
        x = buffer.set_stringn(x, area.y, format!(" {keys}"), usize::from(area.right() - x), theme.key).0;
        x = buffer.set_stringn(x, area.y, format!(" {text} "), usize::from(area.right() - x), theme.faint).0;
    }
    cursor
}

/// The hints that fit: chosen by priority, shown in that order.
fn hints(app: &App, width: usize) -> Vec<(String, &'static str)> {
    let ascii = app.theme.glyphs.ascii;
    let mut wanted: Vec<(u8, String, &'static str)> = Vec::new();
    for about in ACTIONS {
        let Some(hint) = about.hint.filter(|_| applies(app, about.action)) else { continue };
        let Some(key) = keymap::keys(app.mode, about.action, ascii).into_iter().next() else { continue };
        match wanted.iter_mut().find(|(_, _, text)| *text == hint.text) {
            Some((_, keys, _)) if key.chars().all(|arrow| "↑↓←→".contains(arrow)) => keys.push_str(&key),
            Some((_, keys, _)) => *keys = format!("{keys}/{key}"),
            None => wanted.push((hint.priority, key, hint.text)),
        }
    }
    wanted.sort_by_key(|(priority, ..)| *priority);
    let mut used = 0;
    wanted
        .into_iter()
        .filter_map(|(_, keys, text)| {
            let needed = keys.width() + text.width() + 3;
            let fits = used + needed <= width;
            used += if fits { needed } else { 0 };
            fits.then_some((keys, text))
        })
        .collect()
}

/// Whether an action would do something now.
fn applies(app: &App, action: Action) -> bool {
    match action {
        Action::NextPane => app.has_text() && app.detail.text_scroll.last() > 0,
        Action::NextMatch | Action::PreviousMatch => !app.library.filter().is_empty() && app.mode == Mode::Library,
        Action::Quit if app.mode == Mode::Leave || Mode::TYPING.contains(&app.mode) => false,
        // everyone knows, and there is much to say
        Action::MoveUp | Action::MoveDown if app.mode == Mode::Table => false,
        Action::Filter | Action::MoveUp | Action::MoveDown | Action::OpenEditor if app.mode != Mode::Help => {
            !app.library.is_empty()
        }
        Action::Back => app.mode != Mode::Library || !app.library.filter().is_empty(),
        _ => app.editors.open().is_none_or(|editing| applies_in_editor(editing, action)),
    }
}

fn applies_in_editor(editing: &Editing, action: Action) -> bool {
    let is_list = matches!(editing.view.shape, Shape::List { .. });
    let is_there = editing.view.row(editing.cursor().row).is_some();
    match action {
        Action::Undo => editing.editor.undo_name().is_some(),
        Action::Redo => editing.editor.redo_name().is_some(),
        Action::Save => editing.is_modified(),
        Action::OtherShaft => editing.tab.has_sides(),
        Action::AddRow => editing.view.shape != Shape::Single,
        Action::DuplicateRow => is_list && is_there,
        Action::DeleteRow => editing.view.shape != Shape::Single && is_there,
        Action::CancelSolve => editing.solving.pending.is_some(),
        Action::Solve => editing.solving.pending.is_none() && editing.wants_solution(),
        Action::Findings => !editing.findings().is_empty(),
        Action::CycleCell => {
            editing.cell().is_some_and(|cell| matches!(cell.kind, CellKind::Choice(_) | CellKind::Model(_)))
        }
        Action::ClearCell => {
            let target = editing.target();
            target.is_some_and(|cell| cell.shown.is_written() && !cell.required)
        }
        Action::Tick => matches!(&editing.layer, Some(Layer::Choice(choice)) if choice.ticked.is_some()),
        Action::NextCell => !editing.view.is_turned(),
        _ => true,
    }
}
