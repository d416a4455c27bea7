//! The tables of a design, with their keys.
//!
//! ```text
//!  F1 segments [F2 bearings] F3 bodies F4 mesh F5 drives F6 analysis F7 materials F8 design
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use super::table::severity_mark;
use crate::tui::editor::{Editing, Tab};
use crate::tui::keys::KeyNames;
use crate::tui::theme::Theme;

/// Draws a line with all tables; where there is little room, names are shortened, then the keys go.
pub fn render(editing: &Editing, keys: &KeyNames<'_>, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let (width, now) = (usize::from(area.width), editing.tab);
    let line = |(longest, with_key): (usize, bool)| -> Vec<(String, bool)> {
        let tabs = Tab::ALL.into_iter().map(|tab| {
            let title = tab.title();
            // also of the one in sight: nothing moves when another is chosen
            let title = &title[..title.len().min(longest)];
            let key = keys.key(tab.action()).filter(|_| with_key).map_or(String::new(), |key| format!("{key} "));
            let mark = editing.worst_in(tab).map_or("", |worst| severity_mark(worst, theme).0);
            (format!("{key}{title}{mark}"), tab == now)
        });
        tabs.collect()
    };
    // each has a place in front of it, and the last one behind
    let needed = |tabs: &[(String, bool)]| tabs.iter().map(|(text, _)| text.width() + 1).sum::<usize>() + 1;
    let widths = [(usize::MAX, true), (6, true), (5, true), (4, true), (usize::MAX, false), (6, false), (4, false)];
    let lines = widths.map(line);
    let Some(tabs) = lines.iter().find(|tabs| needed(tabs) <= width).or(lines.last()) else { return };
    let mut x = area.x;
    let mut after = " ";
    for (text, is_now) in tabs {
        let before = if *is_now { "[" } else { after };
        after = if *is_now { "]" } else { " " };
        let room = usize::from(area.right().saturating_sub(x));
        let style = if *is_now { theme.title } else { theme.faint };
        x = buffer.set_stringn(x, area.y, before, room, theme.title).0;
        let room = usize::from(area.right().saturating_sub(x));
        x = buffer.set_stringn(x, area.y, text, room, style).0;
    }
    buffer.set_stringn(x, area.y, after, usize::from(area.right().saturating_sub(x)), theme.title);
}
