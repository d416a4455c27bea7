//! A question over what has changed: the changes, which scroll, and below them what can be done.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use crate::design::{Changes, LineChange};
use crate::text::{cut, printable, wrap};
use crate::tui::action::Action;
use crate::tui::app::{App, Scroll};
use crate::tui::recovery::Theirs;
use crate::tui::theme::Theme;
use crate::tui::widgets::panel::{self, Title};

const WIDTH: u16 = 96;

/// A line with its style; it is broken where there is no room for it.
pub type Said = (String, Style);

/// The changes below what they are of.
pub fn section(title: &str, changes: &Changes, theme: &Theme) -> Vec<Said> {
    if changes.is_empty() {
        return vec![(format!("{title}: nothing differs"), theme.title)];
    }
    let mut lines = vec![(format!("{title}, {}:", changes.count()), theme.title)];
    match changes {
        Changes::Values(values) => {
            let arrow = if theme.glyphs.ascii { "->" } else { "→" };
            let shown = |value: &Option<String>| value.clone().unwrap_or_else(|| "nothing".into());
            lines.extend(values.iter().map(|value| {
                let label = &value.label;
                let text = match value.shown() {
                    [_, change] if value.is_row => format!("  {label}: {change}"),
                    _ => format!("  {label}: {} {arrow} {} {}", shown(&value.a), shown(&value.b), value.unit),
                };
                (text.trim_end().to_owned(), theme.fe)
            }));
        }
        Changes::Lines(changes) => lines.extend(changes.iter().map(|change| match change {
            LineChange::Removed { line, text } => (format!("  {line:>4} - {text}"), theme.faint),
            LineChange::Added { line, text } => (format!("  {line:>4} + {text}"), theme.fe),
        })),
    }
    lines
}

/// What became of a file.
pub fn of_theirs(theirs: &Theirs, theme: &Theme) -> Vec<Said> {
    match theirs {
        Theirs::Changed(changes) => section("The file since", changes, theme),
        Theirs::Gone => vec![("The file is gone.".into(), theme.warning)],
        Theirs::Unreadable(reason) => vec![(format!("The file cannot be used now: {reason}"), theme.warning)],
    }
}

/// Draws the window over `area`.
pub fn render(
    app: &App,
    title: String,
    said: &[Said],
    choices: &[(Action, &str)],
    scroll: &mut Scroll,
    area: Rect,
    buffer: &mut Buffer,
) {
    let theme = app.theme;
    let width = area.width.saturating_sub(2).min(WIDTH);
    let room = usize::from(width.saturating_sub(4));
    let lines: Vec<Said> = said
        .iter()
        .flat_map(|(text, style)| {
            let text = printable(text);
            let broken = if text.is_empty() { vec![String::new()] } else { wrap(&text, room) };
            broken.into_iter().map(|line| (line, *style)).collect::<Vec<_>>()
        })
        .collect();
    let keys = |action| app.keys.of(app.mode, action, theme.glyphs.ascii).into_iter().next();
    let choices: Vec<String> = choices
        .iter()
        .map(|(action, text)| {
            let key = keys(*action).unwrap_or_else(|| format!(":{}", action.name()));
            format!("{key:>4}  {text}")
        })
        .collect();
    let window = super::window(area, width, (lines.len() + choices.len() + 3) as u16, buffer);
    let inner = panel::frame(window, buffer, &Title::left(title), true, &theme);
    let below = (choices.len() as u16 + 1).min(inner.height);
    let upper = Rect { height: inner.height - below, ..inner };
    scroll.fit(lines.len(), usize::from(upper.height));
    for ((line, style), y) in lines.iter().skip(scroll.top).zip(upper.top()..upper.bottom()) {
        buffer.set_stringn(inner.x + 1, y, line, room, *style);
    }
    for (choice, y) in choices.iter().zip(upper.bottom() + 1..inner.bottom()) {
        buffer.set_stringn(inner.x + 1, y, cut(choice, room, theme.glyphs.ellipsis), room, theme.key);
    }
    if let Some(position) = scroll.position() {
        let left = vec![format!("lines {position}"), position];
        panel::bottom(window, buffer, &Title { left, right: Vec::new() }, true, &theme);
    }
}
