//! The first line over the tables.
//!
//! ```text
//!  bevelscope  overhung-elastic *   changed on disk   2 findings (f)   live   u: kx of pinion bearing B1
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::text::{cut, printable};
use crate::tui::action::Action;
use crate::tui::editor::Editing;
use crate::tui::keys::KeyNames;
use crate::tui::recovery::FileState;
use crate::tui::theme::Theme;

/// The design, its findings, whether edits are solved, and what would be undone.
pub fn render(editing: &Editing, live: bool, keys: &KeyNames<'_>, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    const PROGRAM: &str = " bevelscope  ";
    let (width, ellipsis) = (usize::from(area.width), theme.glyphs.ellipsis);
    let stem = editing.path.file_stem().unwrap_or_default().to_string_lossy();
    let star = if editing.is_modified() { " *" } else { "" };
    let count = editing.problems().len();
    let list = keys.of(Action::Findings);
    let found = match count {
        0 => String::new(),
        1 => format!("1 finding ({list})"),
        _ => format!("{count} findings ({list})"),
    };
    let undo =
        editing.editor.undo_name().map(|name| format!("{}: {}", keys.of(Action::Undo), printable(name.as_str())));
    let undo = undo.unwrap_or_default();
    let left = width.saturating_sub(PROGRAM.width());
    let name = cut(&printable(&stem), (left / 2).min(30), ellipsis) + star;
    let mut x = buffer.set_stringn(area.x, area.y, PROGRAM, width, theme.key).0;
    let mut put = |text: &str, style: Style| {
        if !text.is_empty() {
            let room = usize::from(area.right().saturating_sub(x));
            let text = cut(text, room.saturating_sub(1), ellipsis);
            x = (buffer.set_stringn(x, area.y, text, room, style).0 + 3).min(area.right());
        }
    };
    put(&name, theme.title);
    for warning in warnings(editing) {
        put(&printable(&warning), theme.error);
    }
    put(&found, theme.warning);
    put(if live { "live" } else { "live off" }, if live { theme.faint } else { theme.warning });
    put(&undo, theme.faint);
}

/// What is not right with the file, as long as it is not.
fn warnings(editing: &Editing) -> impl Iterator<Item = String> {
    let state = match editing.look.state {
        FileState::Same => None,
        FileState::Changed => Some("changed on disk".to_owned()),
        FileState::Gone => Some("file gone".to_owned()),
    };
    let also = editing.look.holder.as_ref().map(|holder| format!("also open: {holder}"));
    state.into_iter().chain(also)
}
