//! The first line.
//!
//! ```text
//!  bevelscope  Overhung pinion and gear    FE 92 · lumped 14 coordinates · 0.6 ms   ~/designs
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use unicode_width::UnicodeWidthStr;

use crate::text::{cut, cut_start, printable};
use crate::tui::app::{App, Outcome};
use crate::tui::text::duration;
use crate::tui::theme::Theme;

const PROGRAM: &str = " bevelscope  ";

/// Draws the line: the program, the design, the sizes of its models, the library. Where there is little room, the
/// library's name goes first, for the design's name.
pub fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    if area.height == 0 {
        return;
    }
    let theme = &app.theme;
    let ellipsis = theme.glyphs.ellipsis;
    let width = usize::from(area.width);
    let name = app.library.selected().map_or(String::new(), super::super::library::Row::name);
    let sizes = sizes(app, width);
    let left = width.saturating_sub(PROGRAM.width() + 1);
    let folder = printable(&app.shown_as);
    // a name this long is still told from others
    let name_wanted = name.width().min(24);
    let folder_room = left.saturating_sub(name_wanted + sizes.width() + 5);
    let folder = if folder_room >= folder.width().min(12) {
        cut_start(&folder, folder_room.min(30), ellipsis)
    } else {
        String::new()
    };
    let right = match (sizes.is_empty(), folder.is_empty()) {
        (_, true) => sizes,
        (true, false) => folder,
        (false, false) => format!("{sizes}   {folder}"),
    };
    let name = cut(&name, left.saturating_sub(right.width() + 2), ellipsis);
    let (x, _) = buffer.set_stringn(area.x, area.y, PROGRAM, width, theme.key);
    buffer.set_stringn(x, area.y, name, left, theme.title);
    let right_x = width.saturating_sub(right.width() + 1).max(usize::from(x - area.x));
    buffer.set_stringn(area.x + right_x as u16, area.y, right, width - right_x, theme.faint);
}

/// Draws the line with a name only.
pub fn render_named(name: &str, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width);
    let (x, y) = buffer.set_stringn(area.x, area.y, PROGRAM, width, theme.key);
    let left = width.saturating_sub(PROGRAM.width());
    buffer.set_stringn(x, y, cut(name, left, theme.glyphs.ellipsis), left, theme.title);
}

fn sizes(app: &App, width: usize) -> String {
    let dot = app.theme.glyphs.separator;
    match &app.detail.outcome {
        Some(Outcome::Solved { summary, .. }) => {
            let time = if app.detail.pending { "rereading".into() } else { duration(summary.elapsed) };
            let (fe, lumped) = (summary.fe_coordinates, summary.lumped_coordinates);
            let unit = if width >= 80 { " coordinates" } else { "" };
            format!("FE {fe} {dot} lumped {lumped}{unit} {dot} {time}")
        }
        _ => String::new(),
    }
}
