//! The spectra of a design while it is edited, and what the lumped models are worth.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::text::{cut, wrap};
use crate::tui::action::Action;
use crate::tui::app::Scroll;
use crate::tui::editor::Editing;
use crate::tui::keys::KeyNames;
use crate::tui::theme::Theme;
use crate::tui::widgets::panel::{self, Title};
use crate::tui::widgets::{difference_strip, figures, plot, spectrum, text_pane};

/// Whether the spectra are those of the design as it is now, and if not, why.
fn state(editing: &Editing, live: bool, keys: &KeyNames<'_>) -> String {
    let stale = if editing.is_stale() { "stale, " } else { "" };
    if let Some(pending) = &editing.solving.pending {
        return format!("{stale}solving {:.0} %", pending.done * 100.0);
    }
    let errors = editing.editor.reading().errors().count();
    match &editing.design {
        None if errors == 1 => format!("{stale}not solved: 1 error"),
        None => format!("{stale}not solved: {errors} errors"),
        Some(design) if editing.solving.failure(design).is_some() => format!("{stale}cannot be solved"),
        Some(_) if editing.solving.current.is_none() => "not solved".into(),
        Some(_) if editing.is_stale() && live => format!("stale: {} solves", keys.of(Action::Solve)),
        Some(_) if editing.is_stale() => format!("stale, live off: {} solves", keys.of(Action::Solve)),
        Some(_) => String::new(),
    }
}

/// Draws the spectra, over those of the saved state, or why there are none.
pub fn render(editing: &mut Editing, live: bool, keys: &KeyNames<'_>, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let state = state(editing, live, keys);
    let why = why_not(editing);
    let modified = editing.is_modified();
    let Some(solution) = &mut editing.solving.current else {
        let title = if state.is_empty() { "Spectra" } else { &state };
        let solving = format!("Solving the three models{}", theme.glyphs.ellipsis);
        let (solve, toggle) = (keys.of(Action::Solve), keys.of(Action::ToggleLive));
        let waits = format!("{solve} solves the three models, {toggle} solves them after each edit.");
        let text = why.unwrap_or(if editing.solving.pending.is_some() { solving } else { waits });
        let style = Style::new();
        text_pane::render((title, &text, style), &mut Scroll::default(), None, theme, area, buffer);
        return;
    };
    let name = ["Dynamic mesh force, dB re 1 N", "Mesh force, dB re 1 N", "dB re 1 N"];
    let left = name.iter().map(|name| if state.is_empty() { (*name).to_owned() } else { format!("{state} - {name}") });
    let left: Vec<String> = left.chain((!state.is_empty()).then(|| state.clone())).collect();
    let inner = panel::frame(area, buffer, &Title { left, right: Vec::new() }, false, theme);
    let strip_height = if inner.height >= 18 { (inner.height * 3 / 10).clamp(3, 7) | 1 } else { 0 };
    let upper =
        Rect { height: inner.height.saturating_sub(if strip_height > 0 { strip_height + 1 } else { 0 }), ..inner };
    let (dots, _) = theme.marker.dots();
    let width = usize::from(plot::curve_width(inner));
    solution.picture.prepare(width, dots);
    let axis = solution.picture.traces.axis;
    let ghost = editing.solving.ghost.as_mut().filter(|_| modified);
    let ghost = ghost.map(|ghost| ghost.columns(axis, width));
    let trust = solution.summary.enhanced.agreement_limit_hz;
    spectrum::render_over(&solution.picture, ghost, trust, theme, upper, buffer);
    let right = spectrum::legend(theme, ghost.is_some());
    if strip_height > 0 {
        let strip = Rect { y: upper.bottom() + 1, height: strip_height, ..inner };
        panel::divider(area, buffer, upper.bottom(), &difference_strip::title(theme), theme);
        difference_strip::render(&solution.picture, theme, strip, buffer);
    }
    panel::bottom(area, buffer, &Title { left: Vec::new(), right }, false, theme);
    if let Some(why) = why {
        let room = usize::from(upper.width.saturating_sub(plot::GUTTER + 3));
        let mut lines = wrap(&format!("{} {why}", theme.glyphs.broken), room);
        // the frequencies stay in sight
        let most = usize::from(upper.height.saturating_sub(plot::AXIS_ROWS)).max(1);
        if lines.len() > most {
            lines.truncate(most);
            if let Some(last) = lines.last_mut() {
                *last = cut(&format!("{last}{}", " ".repeat(room)), room, theme.glyphs.ellipsis);
            }
        }
        for (line, y) in lines.iter().zip(upper.top()..upper.bottom()) {
            let x = upper.x + plot::GUTTER;
            let gap = " ".repeat(room.saturating_sub(line.width()));
            buffer.set_stringn(x, y, format!(" {line}{gap} "), room + 2, theme.error);
        }
    }
}

/// Why the design as it is now has no solution.
fn why_not(editing: &Editing) -> Option<String> {
    match &editing.design {
        None => {
            let first = editing.editor.reading().errors().next()?;
            editing.sentences(std::slice::from_ref(first)).pop()
        }
        Some(design) => editing.solving.failure(design).map(str::to_owned),
    }
}

/// Draws how far the lumped models can be trusted, and what that was before the edits.
pub fn render_figures(editing: &Editing, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let Some(solution) = &editing.solving.current else {
        let text = " agreement: not known yet";
        buffer.set_stringn(area.x, area.y, text, usize::from(area.width), theme.faint);
        return;
    };
    let stale = if editing.is_stale() { " stale" } else { "" };
    let ghost = editing.solving.ghost.as_ref().filter(|_| editing.is_modified()).map(|ghost| &ghost.summary);
    let x = area.x + stale.len() as u16;
    buffer.set_stringn(area.x, area.y, stale, usize::from(area.width), theme.warning);
    let right = Rect { x, width: area.width - stale.len() as u16, ..area };
    figures::render_models(&solution.summary, ghost, theme, right, buffer);
}
