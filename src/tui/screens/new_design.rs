//! The form of a new design.
//!
//! ```text
//!  header
//! ┌ New design ───────────────────────┬ Side view ──────────────────┐
//! │ file            spiral-bevel-14-39│                             │
//! │ kind of pair    spiral-bevel      │ both shafts                 │
//! │▌pinion teeth   [15▏             ] ├ What follows ───────────────┤
//! │ gear teeth      42                │ ratio              2.8      │
//! └───────────────────────────────────┴─────────────────────────────┘
//!  what the question is about, or what is wrong with the answer
//!  footer
//! ```

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::{Modifier, Style};
use unicode_width::UnicodeWidthStr;

use crate::text::{cut, printable, wrap};
use crate::tui::app::App;
use crate::tui::keymap::Mode;
use crate::tui::new_design::{NewDesign, Row};
use crate::tui::theme::Theme;
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::text_line::bracketed;
use crate::tui::widgets::{figures, footer, header, side_view};

/// Columns of the questions where there is a picture beside them.
const FORM: u16 = 44;
const LABELS: u16 = 17;
const VALUES: u16 = 25;

/// Draws the screen over the whole frame and returns where the cursor stands.
pub fn render(app: &mut App, frame: &mut Frame) -> Option<Position> {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    let row = |y: u16, height: u16| Rect { y: area.y + y, height, ..area };
    let theme = app.theme;
    header::render_named(&format!("new design in {}", printable(&app.shown_as)), &theme, row(0, 1), buffer);
    let body = super::body(area);
    let has_picture = body.width >= FORM + 32;
    let form_width = if has_picture { FORM } else { body.width };
    let left = Rect { width: form_width, ..body };
    // the title says what is in sight
    let rows = app.new_design.rows();
    app.new_design.scroll.fit(rows.len(), usize::from(left.height.saturating_sub(2)));
    app.new_design.scroll.show(app.new_design.cursor);
    let title = title(&app.new_design, form_width);
    let inner = panel::frame(left, buffer, &title, app.mode == Mode::New, &theme);
    if has_picture {
        let right = Rect { x: body.x + form_width, width: body.width - form_width, ..body };
        render_right(&app.new_design, &theme, right, buffer);
    }
    let wide = Rect { width: body.right().saturating_sub(inner.x + 1), ..inner };
    let cursor = render_rows(&app.new_design, &rows, &theme, wide, buffer);
    render_help(&app.new_design, &theme, row(area.height - 1 - figures::HEIGHT, figures::HEIGHT), buffer);
    footer::render(app, row(area.height - 1, 1), buffer);
    cursor
}

fn title(form: &NewDesign, width: u16) -> Title<'static> {
    let place = form.scroll.position().map_or(String::new(), |position| format!(", {position}"));
    let named = format!("New design{place}");
    let what =
        if form.is_stale() { "stale: what is faint is from before" } else { "what is faint follows from the rest" };
    let hint = format!("{named}: {what}");
    Title {
        left: if usize::from(width) > hint.width() + 4 { vec![hint, named] } else { vec![named] },
        right: Vec::new(),
    }
}

fn render_rows(form: &NewDesign, rows: &[Row], theme: &Theme, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let mut cursor = None;
    for ((at, row), y) in rows.iter().enumerate().skip(form.scroll.top).zip(area.top()..area.bottom()) {
        let is_here = at == form.cursor;
        let label = match row {
            Row::Name => "file",
            Row::Field(field) => field.label(),
        };
        let marker = if is_here { theme.glyphs.selected } else { " " };
        let style = if is_here { theme.title } else { Style::new() };
        buffer.set_stringn(area.x, y, format!("{marker}{label}"), usize::from(LABELS), style);
        let place = Rect { x: area.x + LABELS, y, width: VALUES, height: 1 };
        if is_here {
            cursor = Some(render_typed(form, *row, theme, place, buffer));
        } else {
            let style = if form.is_asked(*row) { Style::new().add_modifier(Modifier::BOLD) } else { theme.faint };
            let value = cut(&printable(&form.value(*row)), usize::from(VALUES) - 1, theme.glyphs.ellipsis);
            buffer.set_stringn(place.x + 1, y, value, usize::from(VALUES) - 1, style);
        }
        if let Some(error) = form.error(*row) {
            let room = usize::from(area.right().saturating_sub(place.right() + 1));
            let text = format!("{} {}", theme.glyphs.broken, printable(error));
            let text = format!("{} ", cut(&text, room.saturating_sub(1), theme.glyphs.ellipsis));
            buffer.set_stringn(place.right() + 1, y, text, room, theme.error);
        }
    }
    cursor
}

/// The answer under the cursor: a text in brackets, or a word between arrows.
fn render_typed(form: &NewDesign, row: Row, theme: &Theme, place: Rect, buffer: &mut Buffer) -> Position {
    if NewDesign::words(row).is_some() {
        let [left, right] = if theme.glyphs.ascii { ["<", ">"] } else { ["◂", "▸"] };
        let value = cut(&printable(&form.value(row)), usize::from(VALUES) - 4, theme.glyphs.ellipsis);
        let gap = " ".repeat((usize::from(VALUES) - 4).saturating_sub(value.width()));
        buffer.set_stringn(
            place.x,
            place.y,
            format!("{left} {value}{gap} {right}"),
            usize::from(VALUES),
            theme.selected,
        );
        return Position::new(place.x + 2, place.y);
    }
    let empty = crate::tui::text_field::TextField::default();
    let cursor = bracketed(form.typed(row).unwrap_or(&empty), theme, place, buffer);
    if !form.is_asked(row) {
        let room = usize::from(VALUES) - 2;
        let value = cut(&printable(&form.value(row)), room, theme.glyphs.ellipsis);
        buffer.set_stringn(place.x + 1, place.y, value, room, theme.faint);
    }
    cursor
}

fn render_right(form: &NewDesign, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let stale = if form.is_stale() { "stale: " } else { "" };
    let inner = panel::frame(area, buffer, &Title::left(format!("{stale}Side view")), false, theme);
    let facts = form.facts();
    let below = (facts.len() as u16 + 1).min(inner.height * 3 / 5);
    let picture = Rect { height: inner.height - below, ..inner };
    if let Some((_, design)) = &form.proposal {
        side_view::render(design, theme, picture, buffer);
    }
    panel::divider(area, buffer, picture.bottom(), &Title::left(format!("{stale}What follows")), theme);
    for ((label, value), y) in facts.iter().zip(picture.bottom() + 1..inner.bottom()) {
        buffer.set_stringn(inner.x + 1, y, format!("{label:<15}"), 15, theme.faint);
        let room = usize::from(inner.width.saturating_sub(17));
        buffer.set_stringn(inner.x + 16, y, cut(value, room, theme.glyphs.ellipsis), room, Style::new());
    }
}

/// What is wrong with the answer under the cursor, else what the question is about.
fn render_help(form: &NewDesign, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let row = form.row();
    let (text, style) = match (form.error(row), row) {
        _ if form.pending => (format!("writing{}", theme.glyphs.ellipsis), theme.faint),
        (Some(error), _) => (format!("{} {}", theme.glyphs.broken, printable(error)), theme.error),
        (None, Row::Name) => ("Name of the file; .toml is added.".into(), Style::new()),
        (None, Row::Field(field)) => {
            let how = if NewDesign::words(row).is_some() { "Arrows choose. " } else { "" };
            (format!("{how}{}", field.help()), Style::new())
        }
    };
    for (line, y) in wrap(&text, usize::from(area.width).saturating_sub(2)).iter().zip(area.top()..area.bottom()) {
        buffer.set_stringn(area.x + 1, y, line, usize::from(area.width.saturating_sub(1)), style);
    }
}
