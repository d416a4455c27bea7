//! The line about the cell under the cursor.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::design::grid::{Cell, CellKind, Shown};
use crate::number::grouped;
use crate::text::{cut, printable};
use crate::tui::action::Action;
use crate::tui::editor::{Editing, FROM_GEOMETRY, Place};
use crate::tui::keys::KeyNames;
use crate::tui::theme::Theme;
use crate::tui::widgets::table;

/// One line about the cell under the cursor: what happened, what is wrong, what can be typed.
pub fn render(editing: &Editing, keys: &KeyNames<'_>, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let Message { text, mut more, is_listed, style } = message(editing, keys, theme);
    let width = usize::from(area.width).saturating_sub(2);
    if is_listed && more.is_empty() && printable(&text).width() > width {
        more = format!(" ({}: in full)", keys.of(Action::Findings));
    }
    let text = cut(&printable(&text), width.saturating_sub(more.width()), theme.glyphs.ellipsis) + &more;
    buffer.set_stringn(area.x + 1, area.y, text, width, style);
}

struct Message {
    text: String,
    /// Stays where the text has to be cut.
    more: String,
    /// The list of findings has it in full.
    is_listed: bool,
    style: Style,
}

impl Message {
    fn new(text: String, style: Style) -> Self {
        Self { text, more: String::new(), is_listed: false, style }
    }
}

fn message(editing: &Editing, keys: &KeyNames<'_>, theme: &Theme) -> Message {
    let broken = theme.glyphs.broken;
    if let Some(input) = &editing.input {
        return match (&input.error, editing.target()) {
            (Some(error), _) => Message::new(format!("{broken} {error}"), theme.error),
            (None, _) if editing.notice.as_ref().is_some_and(|notice| !notice.is_error) => {
                let text = editing.notice.as_ref().map_or(String::new(), |notice| notice.text.clone());
                Message::new(text, theme.title)
            }
            (None, Some(cell)) if input.is_selected => {
                let text = format!("Typing replaces it, moving the cursor keeps it. {}", about_cell(cell, keys));
                Message::new(text, theme.faint)
            }
            (None, Some(cell)) => Message::new(about_cell(cell, keys), theme.faint),
            (None, None) => Message::new("a name".into(), theme.faint),
        };
    }
    if let Some(notice) = &editing.notice {
        let mark = if notice.is_error { format!("{broken} ") } else { String::new() };
        let style = if notice.is_error { theme.error } else { theme.title };
        return Message::new(format!("{mark}{}", notice.text), style);
    }
    let places = findings_here(editing);
    if let Some(finding) = places.first().and_then(|&at| editing.findings().get(at)) {
        let (mark, style) = table::severity_mark(finding.severity, theme);
        let hint = finding.hint.as_ref().map_or(String::new(), |hint| format!(" ({hint})"));
        let more = if places.len() > 1 {
            format!(" ({}: {} more)", keys.of(Action::Findings), places.len() - 1)
        } else {
            String::new()
        };
        return Message { text: format!("{mark} {}{hint}", finding.message), more, is_listed: true, style };
    }
    if let Some(reason) = editing.design.as_ref().and_then(|design| editing.solving.failure(design)) {
        let text = format!("{broken} cannot be solved: {reason}");
        return Message { is_listed: true, ..Message::new(text, theme.error) };
    }
    let cursor = editing.cursor();
    let text = match (editing.target(), editing.view.place(cursor.row, cursor.column)) {
        (Some(cell), _) if cell.column.key == "material" => {
            let names = editing.material_names().join(", ");
            format!("{names}: {} takes the next, {} types", keys.of(Action::CycleCell), keys.of(Action::EditCell))
        }
        (Some(cell), _) => about_cell(cell, keys),
        (None, Some(Place::Matrix)) => format!("6x6 stiffness: {} opens it", keys.of(Action::EditCell)),
        (None, Some(Place::Name)) => {
            format!("the material's name: {} renames it, also where segments name it", keys.of(Action::EditCell))
        }
        (None, _) => String::new(),
    };
    Message::new(text, theme.faint)
}

/// The findings about the cell under the cursor, or else about its row but none of its cells, or about the whole list.
fn findings_here(editing: &Editing) -> Vec<usize> {
    let cursor = editing.cursor();
    let places = match editing.entry() {
        Some(entry) => entry.findings.clone(),
        None => editing.view.findings(cursor.row, cursor.column),
    };
    if !places.is_empty() {
        return places;
    }
    let row = editing.view.row(cursor.row);
    if editing.view.is_turned() {
        return row.map_or(Vec::new(), |row| editing.findings_of_table(&row.path));
    }
    let is_of_cell = |at: &usize| row.is_some_and(|row| row.cells.iter().any(|cell| cell.findings.contains(at)));
    let of_row = row.into_iter().flat_map(|row| &row.findings).copied().filter(|at| !is_of_cell(at));
    of_row.chain(editing.view.list_findings().iter().copied()).collect()
}

/// What a cell holds and what can be typed into it.
fn about_cell(cell: &Cell, keys: &KeyNames<'_>) -> String {
    if let (CellKind::MatrixEntry(..), Some(quantity)) = (cell.kind, cell.kind.quantity()) {
        return format!("stiffness {} [{}], e.g. {}", cell.column.label, cell.column.unit, quantity.example());
    }
    let wanted = match cell.kind {
        CellKind::Number(quantity, limit) => {
            let limit = limit.describe(quantity);
            if limit.is_empty() { cell.column.unit.to_owned() } else { limit }
        }
        CellKind::VectorEntry(_) | CellKind::MatrixEntry(..) => cell.column.unit.to_owned(),
        CellKind::Whole(low, high) if high < 1_000_000_000 => {
            format!("whole, {} to {}", grouped(low as f64), grouped(high as f64))
        }
        CellKind::Whole(low, _) => format!("whole, at least {low}"),
        CellKind::Text | CellKind::Name => "text".into(),
        CellKind::Texts => "words with commas between".into(),
        CellKind::Choice(_) | CellKind::Flags(_) | CellKind::Model(_) => cell.kind.words().join(", "),
    };
    let clears = format!(" ({} clears)", keys.of(Action::ClearCell));
    if cell.shown.is_derived() {
        return FROM_GEOMETRY.into();
    }
    let presence = match (&cell.shown, cell.required) {
        (_, true) => "",
        (Shown::Default(_), false) => " Not written: the default holds.",
        (Shown::Nothing | Shown::Derived(_), false) => " Not written.",
        (Shown::Written(_), false) => &clears,
    };
    let wanted = if wanted.is_empty() { wanted } else { format!("[{wanted}] ") };
    format!("{wanted}{}{presence}", cell.column.doc)
}
