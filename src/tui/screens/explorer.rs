//! The explorer: the designs on the left, the selected one on the right, the answer below.
//!
//! ```text
//!  header
//! ┌ Designs ──────────────┐┌ Mesh force ─────────────────────────────┐
//! │ list                  ││ three spectra                           │
//! ├ Side view ────────────┤├ enhanced − FE, dB ──────────────────────┤
//! │ both shafts           ││ strip                                   │
//! └───────────────────────┘└─────────────────────────────────────────┘
//!  figures
//!  footer
//! ```

use ratatui::Frame;
use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use unicode_width::UnicodeWidthStr;

use crate::text::{cut, printable, wrap};
use crate::tui::action::Action;
use crate::tui::app::{App, Outcome};
use crate::tui::keymap::Mode;
use crate::tui::library::{Row, RowState};
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::{difference_strip, figures, footer, header, library, plot, side_view, spectrum, text_pane};

/// Draws the explorer over the whole frame and returns where the cursor stands, if something is typed.
pub fn render(app: &mut App, frame: &mut Frame) -> Option<Position> {
    let area = frame.area();
    let buffer = frame.buffer_mut();
    let row = |y: u16, height: u16| Rect { y: area.y + y, height, ..area };
    let body = super::body(area);
    let most = area.width * 5 / 12;
    // more than that only for names that would be cut
    let wanted = u16::try_from(library::wanted_width(app) + 2).unwrap_or(u16::MAX);
    let left_width = most.clamp(24, 38).max(wanted.min(most));
    let left = Rect { width: left_width, ..body };
    let right = Rect { x: body.x + left_width, width: body.width - left_width, ..body };

    header::render(app, row(0, 1), buffer);
    render_left(app, left, buffer);
    render_right(app, right, buffer);
    figures::render(app, row(area.height - 1 - figures::HEIGHT, figures::HEIGHT), buffer);
    footer::render(app, row(area.height - 1, 1), buffer)
}

/// List above, side view below; a low window has room for the list only.
fn render_left(app: &mut App, area: Rect, buffer: &mut Buffer) {
    let focused = matches!(app.mode, Mode::Library | Mode::Filter);
    let inner = panel::frame(area, buffer, &library::title(app), focused, &app.theme);
    let has_side_view = inner.height >= 15 && !app.library.is_empty();
    let side_height = if has_side_view { (inner.height * 3 / 5).min(16) } else { 0 };
    let list = Rect { height: inner.height - side_height, ..inner };
    app.view_moved |= app.library.scroll_into_view(library::rows(list));
    library::render(app, list, buffer);
    if side_height > 0 {
        panel::divider(area, buffer, list.bottom(), &Title::left("Side view"), &app.theme);
        let side = Rect { y: list.bottom() + 1, height: side_height - 1, ..inner };
        if let Some(loaded) = app.library.selected().and_then(|row| row.loaded.as_ref()) {
            side_view::render(&loaded.design, &app.theme, side, buffer);
            panel::bottom(area, buffer, &side_view::legend(&app.theme), focused, &app.theme);
        } else if let Some(row) = app.library.selected() {
            let text = if matches!(row.state, RowState::Broken(_)) { " nothing to draw" } else { " not read yet" };
            buffer.set_stringn(side.x, side.y, text, usize::from(side.width), app.theme.faint);
        }
    }
}

fn render_right(app: &mut App, area: Rect, buffer: &mut Buffer) {
    let theme = app.theme;
    let focused = app.mode == Mode::Text;
    let next_pane = app.keys.names(Mode::Library, theme.glyphs.ascii).of(Action::NextPane);
    let how = (!focused).then_some(next_pane.as_str());
    match &mut app.detail.outcome {
        Some(Outcome::Failed { title, text }) => {
            let (title, text) = (*title, std::mem::take(text));
            text_pane::render((title, &text, theme.fe), &mut app.detail.text_scroll, how, &theme, area, buffer);
            if let Some(Outcome::Failed { text: place, .. }) = &mut app.detail.outcome {
                *place = text;
            }
        }
        Some(Outcome::Solved { .. }) => render_spectra(app, area, buffer),
        None => {
            let (title, text) = without_result(app);
            text_pane::render((title, &text, theme.fe), &mut app.detail.text_scroll, how, &theme, area, buffer);
        }
    }
}

fn render_spectra(app: &mut App, area: Rect, buffer: &mut Buffer) {
    let theme = app.theme;
    let Some(Outcome::Solved { picture, summary, .. }) = &mut app.detail.outcome else { return };
    let mut title = spectrum::title(&theme, area.width);
    if app.library.selected().is_some_and(|row| row.unsaved) {
        title.left = title.left.into_iter().map(|text| format!("saved: {text}")).collect();
        title.left.push("saved".into());
    }
    let inner = panel::frame(area, buffer, &title, false, &theme);
    let warnings: Vec<&str> = app.library.selected().into_iter().flat_map(Row::warnings).collect();
    let warned = warning_lines(&warnings, usize::from(inner.width.saturating_sub(2)), theme.glyphs.ellipsis);
    let below = Rect { y: inner.bottom() - warned.len() as u16, height: warned.len() as u16, ..inner };
    let inner = Rect { height: inner.height - below.height, ..inner };
    for (line, y) in warned.iter().zip(below.top()..below.bottom()) {
        buffer.set_stringn(below.x + 1, y, line, usize::from(below.width), theme.warning);
    }
    let strip_height = (inner.height * 3 / 10).clamp(3, 7) | 1;
    let upper = Rect { height: inner.height.saturating_sub(strip_height + 1), ..inner };
    let strip = Rect { y: upper.bottom() + 1, height: strip_height, ..inner };
    let (dots, _) = theme.marker.dots();
    picture.prepare(usize::from(plot::curve_width(inner)), dots);
    spectrum::render(picture, summary.enhanced.agreement_limit_hz, &theme, upper, buffer);
    panel::divider(area, buffer, upper.bottom(), &difference_strip::title(&theme), &theme);
    difference_strip::render(picture, &theme, strip, buffer);
}

/// The first warning in at most two lines, and how many there are besides.
fn warning_lines(warnings: &[&str], width: usize, ellipsis: &str) -> Vec<String> {
    let Some(first) = warnings.first() else { return Vec::new() };
    let more = if warnings.len() > 1 { format!(" (and {} more)", warnings.len() - 1) } else { String::new() };
    let lines = wrap(&format!("! {}{more}", printable(first)), width);
    if lines.len() <= 2 {
        return lines;
    }
    let room = width.saturating_sub(more.width() + ellipsis.width());
    vec![lines[0].clone(), format!("{}{ellipsis}{more}", cut(&lines[1], room, ""))]
}

/// What the right side says where there is neither a result nor an error.
fn without_result(app: &App) -> (&'static str, String) {
    let folder = printable(&app.shown_as);
    let keys = app.keys.names(Mode::Library, app.theme.glyphs.ascii);
    if app.library.is_empty() {
        let text = format!(
            "There is no design in {folder}.\n\n\
             A design is a file NAME.toml: a pinion and a gear, each a shaft with its segments, bodies, bearings and its \
             drive, and the mesh between them. bevelscope solves it with finite elements and with two lumped models, and \
             shows up to which frequency the lumped ones can be trusted.\n\n\
             {} asks a few questions and makes one.\n\n\
             Put a design there and press {}, or quit with {} and name another folder:\n\n    bevelscope FOLDER",
            keys.of(Action::NewDesign),
            keys.of(Action::Reread),
            keys.of(Action::Quit)
        );
        return ("No designs", text);
    }
    if app.library.matches() == 0 {
        let filter = printable(app.library.filter());
        return (
            "No match",
            format!(
                "None of the {} designs matches \"{filter}\".\n\n{} drops the filter.",
                app.library.len(),
                keys.of(Action::Back)
            ),
        );
    }
    let read = app.library.selected().is_some_and(|row| row.loaded.is_some());
    let dots = app.theme.glyphs.ellipsis;
    if read {
        ("Spectra", format!("Solving the three models{dots}"))
    } else {
        ("Spectra", format!("Reading the design{dots}"))
    }
}
