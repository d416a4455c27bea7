//! The help: the keys in force, and what the marks mean.
//!
//! ```text
//! ┌ Help /design  2 of 9 ────────────────────────────┐
//! │ Moving                                           │
//! │   ↑ k           the design above, or a line up   │
//! │ ▌ ↓ j           the design below, or a line down │
//! └ lines 1-12 of 40 ────────────────────────────────┘
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::text::{cut, printable, wrap};
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::help::HelpLine;
use crate::tui::keymap::Mode;
use crate::tui::theme::Theme;
use crate::tui::widgets::panel::{self, Title};

const KEYS: usize = 20;

/// Draws the help over `area`, and returns where the cursor stands while a search is typed.
pub fn render(app: &mut App, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let theme = app.theme;
    let all = app.help_lines();
    let width = wanted_width(&all).min(area.width.saturating_sub(4));
    let lines = broken(&all, usize::from(width.saturating_sub(2)));
    let typing = app.mode == Mode::HelpSearch;
    let searched = typing || !app.help_search.is_empty();
    // while it is searched, its size stays
    let height = if searched { area.height } else { lines.len() as u16 + 2 };
    let window = super::window(area, width, height, buffer);
    let found: Vec<usize> =
        (0..lines.len()).filter(|&at| matches!(lines[at].1, Part::Entry { is_first: true, .. })).collect();
    let place = app.help_search.place(found.len());
    let inner = panel::frame(window, buffer, &title(app, searched, place, found.len()), true, &theme);
    let text = if typing { Rect { height: inner.height.saturating_sub(1), ..inner } } else { inner };
    app.help_scroll.fit(lines.len(), usize::from(text.height));
    let present = place.and_then(|place| found.get(place).copied());
    if let Some(line) = present.filter(|_| std::mem::take(&mut app.help_search.follow)) {
        app.help_scroll.show(line);
    }
    let top = app.help_scroll.top;
    let entry = present.and_then(|line| lines.get(line)).map(|(entry, _)| *entry);
    for ((of, line), y) in lines.iter().skip(top).zip(text.top()..text.bottom()) {
        render_line(line, entry == Some(*of), &theme, Rect { y, height: 1, ..text }, buffer);
    }
    if lines.is_empty() {
        buffer.set_stringn(text.x + 1, text.y, "nothing has these letters in it", usize::from(text.width), theme.faint);
    }
    if let Some(position) = app.help_scroll.position() {
        let keys = app.keys.names(Mode::Help, theme.glyphs.ascii);
        let how = format!("{} searches, {} closes", keys.of(Action::Filter), keys.of(Action::Back));
        let left = vec![format!("lines {position}, {how}"), format!("lines {position}"), position];
        panel::bottom(window, buffer, &Title { left, right: Vec::new() }, true, &theme);
    }
    let prompt = Rect { y: text.bottom(), height: inner.height - text.height, ..inner };
    if typing { super::typed(" /", &app.help_search.field, &theme, prompt, buffer) } else { None }
}

fn title(app: &App, searched: bool, place: Option<usize>, found: usize) -> Title<'static> {
    if !searched {
        return Title::left("Help");
    }
    let search = printable(app.help_search.field.text().trim()).into_owned();
    let count = match place {
        Some(place) => format!("{} of {found}", place + 1),
        None if found == 0 => "no match".into(),
        None => String::new(),
    };
    Title { left: vec![format!("Help /{search}  {count}").trim_end().to_owned(), count], right: Vec::new() }
}

/// One line on the screen.
enum Part<'a> {
    Title(&'static str),
    Entry { keys: &'a str, text: String, is_first: bool },
}

/// As wide as the longest line is; while it is searched that is not known beforehand.
fn wanted_width(lines: &[HelpLine]) -> u16 {
    let width = |line: &HelpLine| match line {
        HelpLine::Title(title) => title.width(),
        HelpLine::Entry { keys, text, .. } => (keys.width() + 1).max(KEYS) + text.width() + 2,
    };
    // the frame, and a blank at each side
    lines.iter().map(width).max().unwrap_or(0).clamp(74, 1000) as u16 + 4
}

/// The lines in parts that fit, each with the number of its line.
fn broken(lines: &[HelpLine], width: usize) -> Vec<(usize, Part<'_>)> {
    let mut parts = Vec::new();
    for (at, line) in lines.iter().enumerate() {
        match line {
            HelpLine::Title(title) => parts.push((at, Part::Title(title))),
            HelpLine::Entry { keys, text, .. } => {
                // a long list of keys has a line of its own
                let start = if keys.width() < KEYS {
                    0
                } else {
                    parts.push((at, Part::Entry { keys, text: String::new(), is_first: true }));
                    1
                };
                let texts = wrap(text, width.saturating_sub(KEYS + 3)).into_iter().enumerate();
                parts.extend(texts.map(|(line, text)| {
                    let is_first = line + start == 0;
                    (at, Part::Entry { keys: if is_first { keys } else { "" }, text, is_first })
                }));
            }
        }
    }
    parts
}

fn render_line(part: &Part, present: bool, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let room = usize::from(area.width.saturating_sub(1));
    match part {
        Part::Title(title) => drop(buffer.set_stringn(area.x + 1, area.y, title, room, theme.title)),
        Part::Entry { keys, text, is_first } => {
            let marker = if present && *is_first { theme.glyphs.selected } else { " " };
            let gap = " ".repeat(KEYS.saturating_sub(keys.width()).max(1));
            let start = format!("{marker} {keys}{gap}");
            let (x, _) =
                buffer.set_stringn(area.x + 1, area.y, cut(&start, room, theme.glyphs.ellipsis), room, theme.key);
            let left = usize::from(area.right().saturating_sub(x));
            buffer.set_stringn(x, area.y, text, left, Style::new());
            if present {
                buffer.set_style(area, theme.selected);
            }
        }
    }
}
