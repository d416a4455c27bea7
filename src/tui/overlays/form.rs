//! Asking for a name, and asking whether.
//!
//! ```text
//! ┌ Rename overhung-rigid ─────────────────────────────┐
//! │ name: overhung-elastic▏                            │
//! │ × there is a design of that name already           │
//! └────────────────────────────────────────────────────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};

use crate::text::{cut, wrap};
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::editor::Editing;
use crate::tui::files::Purpose;
use crate::tui::keymap::Mode;
use crate::tui::library::Row;
use crate::tui::widgets::panel::{self, Title};

const WIDTH: u16 = 64;

/// Draws the form over `area` and returns where the cursor stands.
pub fn render(app: &App, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let theme = app.theme;
    let form = app.form.as_ref()?;
    let verb = match form.purpose {
        Purpose::Rename => "Rename",
        Purpose::Duplicate => "Copy",
    };
    let stem = Row::new(form.path.clone()).stem;
    let (style, text) = match form.checked(&app.library) {
        _ if form.pending => (theme.faint, format!("working{}", theme.glyphs.ellipsis)),
        Err(_) if !form.is_touched => (theme.faint, "another name".into()),
        Ok(_) => {
            let unsaved =
                form.purpose == Purpose::Duplicate && app.editors.get(&form.path).is_some_and(Editing::is_modified);
            let without = if unsaved { "; without unsaved edits" } else { "" };
            (theme.faint, format!("in the same folder; .toml is added{without}"))
        }
        Err(error) => (theme.error, format!("{} {error}", theme.glyphs.broken)),
    };
    let lines = wrap(&text, usize::from(area.width.min(WIDTH).saturating_sub(4)));
    let window = super::window(area, WIDTH, lines.len() as u16 + 3, buffer);
    let inner = panel::frame(window, buffer, &Title::left(format!("{verb} {stem}")), true, &theme);
    for (line, y) in lines.iter().zip(inner.top() + 1..inner.bottom()) {
        buffer.set_stringn(inner.x + 1, y, line, usize::from(inner.width.saturating_sub(1)), style);
    }
    super::typed(" name: ", &form.field, &theme, inner, buffer)
}

/// Draws the question whether to delete.
pub fn render_question(app: &App, area: Rect, buffer: &mut Buffer) {
    let theme = app.theme;
    let Some(path) = &app.to_delete else { return };
    let row = app.library.row(path);
    let stem = Row::new(path.clone()).stem;
    let ascii = theme.glyphs.ascii;
    let back = app.keys.names(Mode::Library, ascii).of(Action::RestoreDeleted);
    let variants = match row.map_or(0, |row| app.library.variants(row)) {
        0 => String::new(),
        1 => "\n1 variant names it as its parent.".into(),
        more => format!("\n{more} variants name it as their parent."),
    };
    let text = format!("Move {stem} to the trash of its folder? {back} brings it back.{variants}");
    let width = area.width.min(WIDTH);
    let mut lines = wrap(&text, usize::from(width.saturating_sub(4)));
    let keys = |action| app.keys.of(Mode::Confirm, action, ascii).join(" ");
    lines.push(String::new());
    lines.push(format!("yes: {}    no: {}", keys(Action::Accept), keys(Action::Back)));
    let window = super::window(area, width, lines.len() as u16 + 2, buffer);
    let inner = panel::frame(window, buffer, &Title::left("Delete"), true, &theme);
    for (line, y) in lines.iter().zip(inner.top()..inner.bottom()) {
        let room = usize::from(inner.width.saturating_sub(1));
        buffer.set_stringn(inner.x + 1, y, cut(line, room, theme.glyphs.ellipsis), room, theme.fe);
    }
}
