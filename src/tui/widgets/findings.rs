//! Everything that is wrong or unusual in the design that is being edited.
//!
//! ```text
//! ┌ 2 findings ────────────────────────────────────────┐
//! │▌× error kx of pinion bearing B1: must be ...       │
//! │ ! warning damping of mesh: 3 is a lot              │
//! └────────────────────────────────────────────────────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::panel::{self, Title};
use super::table::severity_mark;
use crate::design::Finding;
use crate::text::wrap;
use crate::tui::editor::{Editing, List};
use crate::tui::theme::Theme;

/// A finding as it is read.
pub fn sentence(finding: &Finding) -> String {
    let path = finding.shown_path();
    let path = if path.is_empty() { path } else { path + ": " };
    let hint = finding.hint.as_ref().map_or(String::new(), |hint| format!(" ({hint})"));
    format!("{} {path}{}{hint}", finding.severity.word(), finding.message)
}

/// Draws the list over `area`; `is_open` is whether it is not known yet if the design can be solved.
pub fn render(editing: &Editing, is_open: bool, list: &mut List, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    panel::clear(area, buffer);
    let findings = editing.problems();
    let count = findings.len();
    let title = match count {
        0 => "No findings".to_owned(),
        1 => "1 finding".to_owned(),
        _ => format!("{count} findings"),
    };
    let inner = panel::frame(area, buffer, &Title::left(title), true, theme);
    if inner.width < 5 || inner.height == 0 {
        return;
    }
    list.cursor = list.cursor.min(count.saturating_sub(1));
    let room = usize::from(inner.width) - 4;
    // which finding each line belongs to
    let mut lines: Vec<(usize, bool, String)> = Vec::new();
    for (at, sentence) in editing.sentences(&findings).iter().enumerate() {
        let wrapped = wrap(sentence, room);
        lines.extend(wrapped.into_iter().enumerate().map(|(line, text)| (at, line == 0, text)));
    }
    if count == 0 {
        let text = "Nothing is wrong or unusual in this design.";
        let open = " Whether it can be solved is not known yet.";
        let text = if is_open { format!("{text}{open}") } else { text.into() };
        lines.extend(wrap(&text, room).into_iter().map(|line| (0, false, line)));
    }
    list.scroll.fit(lines.len(), usize::from(inner.height));
    let first = lines.iter().position(|(at, ..)| *at == list.cursor).unwrap_or(0);
    let last = lines.iter().rposition(|(at, ..)| *at == list.cursor).unwrap_or(0);
    let lowest = (last + 1).saturating_sub(usize::from(inner.height));
    list.scroll.top = list.scroll.top.clamp(lowest.min(first), first);
    for ((at, is_first, text), y) in lines.iter().skip(list.scroll.top).zip(inner.top()..inner.bottom()) {
        let selected = *at == list.cursor && count > 0;
        if selected {
            buffer.set_stringn(inner.x, y, theme.glyphs.selected, 1, theme.key);
        }
        let mut style = if selected { theme.selected } else { Style::new() };
        if let Some(finding) = findings.get(*at).filter(|_| *is_first) {
            let (mark, mark_style) = severity_mark(finding.severity, theme);
            buffer.set_stringn(inner.x + 1, y, mark, 1, mark_style);
            if !selected {
                style = mark_style;
            }
        }
        buffer.set_stringn(inner.x + 3, y, text, room, style);
    }
    if let Some(position) = list.scroll.position() {
        panel::bottom(area, buffer, &Title::left(format!("lines {position}")), true, theme);
    }
}
