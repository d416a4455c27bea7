//! The list of designs.
//!
//! ```text
//! ┌ Designs 2 of 5 ──────────────┐
//! │ design            FE trust Hz│
//! │ overhung-elastic  92   2,997 │
//! │▌overhung-rigid    92   2,997 │
//! │ straddle           …       … │
//! │ typo × line 14: unknown key  │
//! └──────────────────────────────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use super::panel::Title;
use crate::number::grouped;
use crate::text::{cut, printable};
use crate::tui::app::App;
use crate::tui::keymap::Mode;
use crate::tui::library::{Row, RowState, Visible};
use crate::tui::theme::Theme;

const COORDINATES: usize = 5;
const LIMIT: usize = 9;

/// What the frame around the list says.
pub fn title(app: &App) -> Title<'static> {
    let library = &app.library;
    if library.is_empty() {
        return Title::left("Designs");
    }
    let place = if library.matches() == 0 { 0 } else { library.cursor() + 1 };
    if library.filter().is_empty() && app.mode != Mode::Filter {
        return Title::left(format!("Designs {place} of {}", library.len()));
    }
    let filter = printable(library.filter());
    let found = if place == 0 { "no match".into() } else { format!("{place} of {} matches", library.matches()) };
    Title { left: vec![format!("Designs /{filter}  {found}"), format!("/{filter}  {found}"), found], right: Vec::new() }
}

/// Draws the list into the inside of its frame. The list is scrolled already.
pub fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    if area.height == 0 {
        return;
    }
    let theme = &app.theme;
    let columns = Widths::new(usize::from(area.width));
    let heading = columns.line("design", "FE", "trust Hz", theme);
    buffer.set_stringn(area.x, area.y, heading, usize::from(area.width), theme.faint);
    for (Visible { row, selected, marked, depth, folder }, y) in app.library.visible().zip(area.y + 1..area.bottom()) {
        let name = stem(row, folder.as_deref(), marked, depth, theme);
        let name = match row.matching_title(app.library.filter()) {
            Some(title) => columns.with_title(&name, &title, theme),
            None => name,
        };
        let text = columns.row(row, &name, theme);
        let style = match (&row.state, selected) {
            (_, true) => theme.selected,
            (RowState::Broken(_) | RowState::Unsolvable(_), false) => theme.error,
            (RowState::Pending | RowState::Loaded, false) => theme.faint,
            _ => Style::new(),
        };
        let marker = if selected { theme.glyphs.selected } else { " " };
        let line = format!("{marker}{}", text.get(1..).unwrap_or_default());
        buffer.set_style(Rect::new(area.x, y, area.width, 1), style);
        buffer.set_stringn(area.x, y, line, usize::from(area.width), style);
    }
}

/// The file's name, with its folder where that tells it from another one, below its parent's, with a mark where others are compared with it.
fn stem(row: &Row, folder: Option<&str>, marked: bool, depth: usize, theme: &Theme) -> String {
    // a long line of descent leaves room for the name
    let depth = depth.min(4);
    let branch = if depth > 0 { theme.glyphs.branch } else { "" };
    let mark = if marked { format!("{} ", theme.glyphs.marked) } else { String::new() };
    let folder = folder.map_or(String::new(), |folder| format!("{folder}/"));
    format!("{}{branch}{mark}{folder}{}", "  ".repeat(depth.saturating_sub(1)), row.stem)
}

/// The width of a list in which no name is cut.
pub fn wanted_width(app: &App) -> usize {
    1 + app.library.longest_name() + " *".len() + COORDINATES + LIMIT
}

/// The rows under the heading.
pub fn rows(area: Rect) -> usize {
    usize::from(area.height).saturating_sub(1)
}

struct Widths {
    name: usize,
    /// None where names need the room.
    coordinates: usize,
    all: usize,
}

impl Widths {
    fn new(all: usize) -> Self {
        let coordinates = if all >= 28 { COORDINATES } else { 0 };
        Self { name: all.saturating_sub(1 + coordinates + LIMIT), coordinates, all }
    }

    /// The name, with what of the design's title matches the filter.
    fn with_title(&self, name: &str, title: &str, theme: &Theme) -> String {
        let ellipsis = theme.glyphs.ellipsis;
        let room = self.name.saturating_sub(2);
        let name = cut(name, room.saturating_sub(title.width() + 3).max(room / 2), ellipsis);
        let left = room.saturating_sub(name.width() + 3);
        format!("{name} \"{}\"", cut(title, left, ellipsis))
    }

    fn line(&self, name: &str, coordinates: &str, limit: &str, theme: &Theme) -> String {
        let name = cut(name, self.name, theme.glyphs.ellipsis);
        let gap = " ".repeat(self.name.saturating_sub(name.width()));
        let coordinates = if self.coordinates > 0 { coordinates } else { "" };
        format!(" {name}{gap}{coordinates:>0$}{limit:>LIMIT$}", self.coordinates)
    }

    fn row(&self, row: &Row, stem: &str, theme: &Theme) -> String {
        let ellipsis = theme.glyphs.ellipsis;
        let name = if row.unsaved {
            // the mark is never cut off
            format!("{} *", cut(stem, self.name.saturating_sub(3), ellipsis))
        } else {
            stem.to_owned()
        };
        match &row.state {
            RowState::Pending | RowState::Loaded => self.line(&name, ellipsis, ellipsis, theme),
            RowState::Solved(summary) => {
                let limit = match summary.enhanced.agreement_limit_hz {
                    limit if limit > 0.0 => grouped(limit),
                    _ => "nowhere".into(),
                };
                let warned = row.warnings().next().is_some();
                let limit = if warned { format!("! {limit}") } else { limit };
                // figures and spectra of the list are those of the file
                let coordinates = if row.unsaved { "saved".into() } else { summary.fe_coordinates.to_string() };
                self.line(&name, &coordinates, &limit, theme)
            }
            RowState::Broken(broken) => self.broken(&name, &broken.one_line, theme),
            RowState::Unsolvable(message) => self.broken(&name, message.lines().next().unwrap_or_default(), theme),
        }
    }

    /// The reason in place of the figures; the name gives way to it, down to half of the line.
    fn broken(&self, stem: &str, reason: &str, theme: &Theme) -> String {
        let ellipsis = theme.glyphs.ellipsis;
        let reason = format!("{} {}", theme.glyphs.broken, printable(reason));
        let room = self.all.saturating_sub(2);
        let name_room = room.saturating_sub(reason.width()).max(room / 2);
        let name = match stem.strip_suffix(" *") {
            Some(stem) => format!("{} *", cut(stem, name_room.saturating_sub(2), ellipsis)),
            None => cut(stem, name_room, ellipsis),
        };
        let reason = cut(&reason, room.saturating_sub(name.width()), ellipsis);
        let gap = " ".repeat((room + 1).saturating_sub(name.width() + reason.width()));
        format!(" {name}{gap}{reason}")
    }
}
