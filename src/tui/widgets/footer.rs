//! The last line: the filter while it is typed, and what the keys do.
//!
//! ```text
//!  /over▏  Enter keep filter  Esc back
//!  ↑↓ move  / filter  ? help  q quit  R reread
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use unicode_width::UnicodeWidthStr;

use super::text_line::prompted;
use crate::text::{cut, printable};
use crate::tui::action::{ACTIONS, About, Action, Hint};
use crate::tui::app::App;
use crate::tui::keymap::Mode;
use crate::tui::notice::NoticeKind;
use crate::tui::text_field::TextField;

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
        let place = Rect { width: area.width.div_ceil(2), ..area };
        let field = (app.library.filter_field(), theme.title);
        if let Some((position, end)) = prompted((" /", theme.title), field, theme, place, buffer) {
            cursor = Some(position);
            x = (end + 2).min(area.right());
        }
        if let Some(notice) = app.notice.as_ref().filter(|notice| notice.kind == NoticeKind::Done) {
            let room = usize::from(area.right().saturating_sub(x));
            let text = cut(&printable(&notice.text), room, ellipsis);
            x = (buffer.set_stringn(x, area.y, text, room, theme.title).0 + 1).min(area.right());
        }
    } else if let (Some((prompt, field)), None) = (line(app), app.shown_notice()) {
        let place = Rect { width: area.width.div_ceil(2), ..area };
        if let Some((position, end)) = prompted((prompt, theme.title), (field, theme.title), theme, place, buffer) {
            cursor = Some(position);
            x = (end + 2).min(area.right());
        }
    } else if let Some(notice) = app.shown_notice() {
        let text = printable(&notice.text);
        // what happened comes before what could be done
        let room = usize::from(area.width).saturating_sub(4);
        let (text, style) = match notice.kind {
            NoticeKind::Done => (format!(" {}", cut(&text, room, ellipsis)), theme.title),
            NoticeKind::Failed | NoticeKind::NotListed | NoticeKind::Standing => {
                (format!(" {} {}", theme.glyphs.broken, cut(&text, room, ellipsis)), theme.error)
            }
        };
        x = (buffer.set_stringn(x, area.y, text, usize::from(area.width), style).0 + 1).min(area.right());
    }
    for (keys, text) in hints(app, usize::from(area.right().saturating_sub(x))) {
        x = buffer.set_stringn(x, area.y, format!(" {keys}"), usize::from(area.right() - x), theme.key).0;
        x = buffer.set_stringn(x, area.y, format!(" {text} "), usize::from(area.right() - x), theme.faint).0;
    }
    cursor
}

/// What is typed in this line, and what it is.
fn line(app: &App) -> Option<(&'static str, &TextField)> {
    match app.mode {
        Mode::Frequency => app.modes.as_ref().map(|view| (" deflection at, Hz: ", &view.field)),
        Mode::Torque => app.bearings.as_ref().map(|view| (" torque, N m: ", &view.field)),
        _ => None,
    }
}

/// The hint of an action where it is; screens come first in the list that leads to them.
fn hint_in(mode: Mode, about: &About) -> Option<Hint> {
    let hint = |priority, text| Some(Hint { text, priority });
    match (mode, about.action) {
        (Mode::Library, Action::OpenSpectra) => hint(2, "wide"),
        (Mode::Library, Action::BearingLoads) => hint(2, "bearings"),
        (Mode::Library, Action::GearPair) => hint(2, "pair"),
        (Mode::Library, Action::NewDesign) => hint(2, "new"),
        (Mode::Library, Action::Help) => hint(3, "help"),
        (Mode::Library, Action::Quit) => hint(4, "quit"),
        (Mode::Spectra, Action::MoveLeft | Action::MoveRight) => hint(0, "cursor"),
        // they go where the keys of bands and peaks go
        (Mode::Spectra, Action::MoveUp | Action::MoveDown) => None,
        _ => about.hint,
    }
}

/// The hints that fit: chosen by priority, shown in that order.
fn hints(app: &App, width: usize) -> Vec<(String, &'static str)> {
    let ascii = app.theme.glyphs.ascii;
    let mut wanted: Vec<(u8, String, &'static str)> = Vec::new();
    for about in ACTIONS {
        let Some(hint) = hint_in(app.mode, about).filter(|_| app.applies(about.action)) else { continue };
        let Some(key) = app.keys.of(app.mode, about.action, ascii).into_iter().next() else { continue };
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
