//! The table of the editor.
//!
//! ```text
//!              outer    inner
//!     length diameter diameter  material   elements
//!       mm      mm       mm
//! ▌1  [ 36.0]    44.0      0.0  (steel)          1
//!  2    19.0 !   40.0    (0.0)  titanium         2
//! ```
//!
//! The first column stays in sight. In brackets is what is not written but holds; `!` and `×` mark findings. A single table is
//! turned around: a line a value, with its unit and what it is.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::design::grid::{CellKind, Shown};
use crate::design::{Finding, Severity};
use crate::text::{cut, printable};
use crate::tui::action::Action;
use crate::tui::editor::{Cursor, Editing, View, shown_text};
use crate::tui::keys::KeyNames;
use crate::tui::theme::Theme;

/// Widest column, without its brackets.
const WIDEST: usize = 18;
/// Columns around a value: brackets and a mark.
const AROUND: usize = 3;

/// Where the table is in sight: the cell under the cursor, and what to say about the rest.
#[derive(Debug, Default)]
pub struct Drawn {
    pub cell: Option<Rect>,
    /// `rows 1-5 of 12`; nothing where all is in sight
    pub position: Option<String>,
}

/// Rows that the table wants: its header and its lines.
pub fn wanted_height(editing: &Editing) -> u16 {
    let view = &editing.view;
    let headings = (0..view.rows.len()).filter(|&row| view.heading(row).is_some()).count();
    let header = if view.is_turned() { 0 } else { Layout::new(view, usize::MAX).header_rows() };
    (header + headings + view.rows.len().max(1)).min(1000) as u16
}

/// Draws the table and scrolls so that the cell under the cursor is in sight.
pub fn render(editing: &mut Editing, keys: &KeyNames<'_>, theme: &Theme, area: Rect, buffer: &mut Buffer) -> Drawn {
    if area.is_empty() {
        return Drawn::default();
    }
    if editing.view.is_turned() {
        return render_turned(editing, theme, area, buffer);
    }
    let layout = Layout::new(&editing.view, usize::from(area.width) / 3);
    let header = layout.header_rows().min(usize::from(area.height).saturating_sub(1)) as u16;
    let rows = Rect { y: area.y + header, height: area.height - header, ..area };
    let count = editing.view.rows.len();
    let position = scroll(editing.cursor_mut(), count, usize::from(rows.height));
    let left = layout.scroll(editing.cursor(), usize::from(area.width));
    editing.cursor_mut().left = left;
    let places = layout.places(left, usize::from(area.width));
    draw_header(&layout, &places, theme, Rect { height: header, ..area }, buffer);
    if count == 0 {
        let text = format!(" no rows: {} adds one", keys.of(Action::AddRow));
        buffer.set_stringn(rows.x, rows.y, text, usize::from(rows.width), theme.faint);
    }
    let cursor = editing.cursor();
    let mut drawn = Drawn { cell: None, position };
    for (row, y) in (cursor.top..count).zip(rows.top()..rows.bottom()) {
        let on_row = row == cursor.row;
        draw_row_marker(editing, row, theme, (rows.x, y), buffer);
        if !layout.has_name {
            let label = layout.cut_label(&editing.view, row, theme);
            buffer.set_stringn(rows.x + 2, y, label, layout.label, theme.faint);
        }
        for &(column, x, width) in &places {
            let cell = Rect { x: rows.x + x as u16, y, width: (width + AROUND) as u16, height: 1 };
            let selected = on_row && column == cursor.column;
            draw_cell(editing, (row, column), layout.columns[column].right, selected, theme, cell, buffer);
            if selected {
                drawn.cell = Some(cell);
            }
        }
    }
    drawn
}

/// Brings the cursor's row in sight; says where one is.
fn scroll(cursor: &mut Cursor, count: usize, height: usize) -> Option<String> {
    cursor.height = height;
    let lowest = (cursor.row + 1).saturating_sub(height);
    cursor.top = cursor.top.clamp(lowest, cursor.row.max(lowest)).min(count.saturating_sub(height).max(lowest));
    (count > height).then(|| format!("rows {}-{} of {count}", cursor.top + 1, (cursor.top + height).min(count)))
}

struct Layout {
    columns: Vec<Column>,
    /// Width of the rows' labels, where no column is their name
    label: usize,
    has_name: bool,
}

struct Column {
    header: Vec<String>,
    unit: &'static str,
    width: usize,
    /// Numbers end on the same place.
    right: bool,
}

impl Layout {
    fn new(view: &View, longest_name: usize) -> Self {
        let has_name = view.has_name_column();
        let columns = (0..view.columns.len()).map(|column| {
            let header = broken(&view.columns[column].label);
            let unit = view.columns[column].unit;
            let values = view.columns[column].longest;
            let words = header.iter().map(|word| word.width()).max().unwrap_or(0);
            let longest = if column == 0 && has_name { longest_name.min(24) } else { WIDEST };
            let right = (0..view.rows.len()).find_map(|row| view.cell(row, column)).is_some_and(|cell| {
                matches!(cell.kind, CellKind::Number(..) | CellKind::Whole(..) | CellKind::VectorEntry(_))
            });
            Column { width: values.max(words).max(unit.width()).min(longest.max(4)), header, unit, right }
        });
        let columns = columns.collect();
        Self { columns, label: if has_name { 0 } else { view.longest_label.min(longest_name.min(24)) }, has_name }
    }

    /// Lines of labels, and one of units.
    fn header_rows(&self) -> usize {
        1 + self.columns.iter().map(|column| column.header.len()).max().unwrap_or(1)
    }

    /// Columns of the screen that stay: the marker and the rows' names.
    fn fixed(&self) -> usize {
        match self.columns.first() {
            Some(name) if self.has_name => 1 + name.width + AROUND,
            _ => 2 + self.label + 1,
        }
    }

    fn first_scrolled(&self) -> usize {
        usize::from(self.has_name)
    }

    /// The first scrolled column, so that the cursor's is in sight.
    fn scroll(&self, cursor: Cursor, width: usize) -> usize {
        let room = width.saturating_sub(self.fixed());
        let first = self.first_scrolled();
        let used = |left: usize, last: usize| -> usize {
            self.columns.get(left..=last).unwrap_or_default().iter().map(|column| column.width + AROUND).sum()
        };
        let last = self.columns.len().saturating_sub(1);
        if cursor.column < first || self.columns.is_empty() {
            return first;
        }
        let mut left = cursor.left.clamp(first, cursor.column.max(first));
        while left < cursor.column && used(left, cursor.column) > room {
            left += 1;
        }
        // no room is left empty at the end
        while left > first && used(left - 1, last) <= room {
            left -= 1;
        }
        left
    }

    /// The columns in sight: number, place on the screen, width.
    fn places(&self, left: usize, width: usize) -> Vec<(usize, usize, usize)> {
        let mut places = Vec::new();
        let mut x = 1;
        if self.has_name {
            places.push((0, x, self.columns[0].width.min(width.saturating_sub(1 + AROUND))));
        }
        x = self.fixed();
        for (at, column) in self.columns.iter().enumerate().skip(left.max(self.first_scrolled())) {
            let room = width.saturating_sub(x + AROUND);
            // the first one may be cut, the others are whole or not there
            if column.width > room && (at > left || room == 0) {
                break;
            }
            places.push((at, x, column.width.min(room)));
            x += column.width + AROUND;
        }
        places
    }

    fn cut_label(&self, view: &View, row: usize, theme: &Theme) -> String {
        let label = view.row(row).map_or("", |row| &row.label);
        cut(&printable(label), self.label, theme.glyphs.ellipsis)
    }
}

/// A long label in two lines.
fn broken(label: &str) -> Vec<String> {
    if label.width() <= 10 {
        return vec![label.to_owned()];
    }
    let spaces = label.match_indices(' ').map(|(at, _)| at);
    match spaces.min_by_key(|at| (label.len() - at).abs_diff(*at)) {
        Some(at) => vec![label[..at].to_owned(), label[at + 1..].to_owned()],
        None => vec![label.to_owned()],
    }
}

fn draw_header(layout: &Layout, places: &[(usize, usize, usize)], theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let labels = layout.header_rows() - 1;
    for &(at, x, width) in places {
        let column = &layout.columns[at];
        // short labels stand over the unit
        let above = labels - column.header.len();
        let lines = std::iter::repeat_n("", above).chain(column.header.iter().map(String::as_str)).chain([column.unit]);
        for (line, y) in lines.zip(area.top()..area.bottom()) {
            let text = cut(line, width, theme.glyphs.ellipsis);
            let gap = if column.right { width - text.width() } else { 0 };
            buffer.set_stringn(area.x + (x + 1 + gap) as u16, y, text, width, theme.faint);
        }
    }
    let first = places.iter().map(|(at, ..)| *at).find(|at| *at >= layout.first_scrolled());
    let last = places.last().map(|(at, ..)| *at);
    if let (Some(first), Some(last)) = (first, last) {
        if first > layout.first_scrolled() {
            buffer.set_stringn(area.x + layout.fixed() as u16 - 1, area.y, "<", 1, theme.key);
        }
        if last + 1 < layout.columns.len() {
            buffer.set_stringn(area.right() - 1, area.y, ">", 1, theme.key);
        }
    }
}

fn draw_row_marker(editing: &Editing, row: usize, theme: &Theme, (x, y): (u16, u16), buffer: &mut Buffer) {
    if row == editing.cursor().row {
        buffer.set_stringn(x, y, theme.glyphs.selected, 1, theme.key);
    } else if let Some((mark, style)) =
        editing.view.row(row).and_then(|row| mark(editing.findings(), &row.findings, theme))
        && !editing.view.is_turned()
    {
        buffer.set_stringn(x, y, mark, 1, style);
    }
}

/// The mark of the worst of some findings.
pub fn mark(findings: &[Finding], places: &[usize], theme: &Theme) -> Option<(&'static str, Style)> {
    let worst = places.iter().filter_map(|&at| findings.get(at)).map(|finding| finding.severity).min()?;
    Some(severity_mark(worst, theme))
}

pub fn severity_mark(severity: Severity, theme: &Theme) -> (&'static str, Style) {
    match severity {
        Severity::Error => (theme.glyphs.broken, theme.error),
        Severity::Warning => ("!", theme.warning),
    }
}

fn draw_cell(
    editing: &Editing,
    (row, column): (usize, usize),
    right: bool,
    selected: bool,
    theme: &Theme,
    area: Rect,
    buffer: &mut Buffer,
) {
    let width = usize::from(area.width).saturating_sub(AROUND);
    let shown = editing.view.shown(row, column);
    let style = match &shown {
        _ if selected => theme.selected,
        Some(Shown::Written(_)) => Style::new(),
        _ => theme.faint,
    };
    let text = cut(&shown.as_ref().map_or(String::new(), shown_text), width, theme.glyphs.ellipsis);
    let gap = " ".repeat(width - text.width());
    let text = if right { format!("{gap}{text}") } else { format!("{text}{gap}") };
    let (open, close) = if selected { ("[", "]") } else { (" ", " ") };
    buffer.set_stringn(area.x, area.y, format!("{open}{text}{close}"), width + 2, style);
    let found = mark(editing.findings(), &editing.view.findings(row, column), theme);
    if let Some((mark, style)) = found {
        buffer.set_stringn(area.right() - 1, area.y, mark, 1, style);
    }
    if editing.view.is_changed(row, column) && !(selected && found.is_some()) {
        // a finding has the place after the bracket
        let x = if found.is_some() { area.right() - 2 } else { area.right() - 1 };
        buffer.set_stringn(x, area.y, "*", 1, theme.key);
    }
}

enum Line {
    Heading(String),
    Row(usize),
}

fn render_turned(editing: &mut Editing, theme: &Theme, area: Rect, buffer: &mut Buffer) -> Drawn {
    let view = &editing.view;
    let mut lines = Vec::new();
    for row in 0..view.rows.len() {
        lines.extend(view.heading(row).map(|heading| Line::Heading(printable(heading).into_owned())));
        lines.push(Line::Row(row));
    }
    let width = usize::from(area.width);
    let cell = |row: usize| view.cell(row, 0);
    let widest = |texts: &mut dyn Iterator<Item = usize>| texts.max().unwrap_or(0);
    let rows = 0..view.rows.len();
    let label = widest(&mut rows.clone().filter_map(cell).map(|cell| cell.column.label.width())).min(width / 2);
    let unit = widest(&mut rows.clone().filter_map(cell).map(|cell| cell.column.unit.width()));
    let values = widest(&mut rows.filter_map(cell).map(|cell| shown_text(&cell.shown).width()));
    let left = width.saturating_sub(label + AROUND + 2);
    let value = values.clamp(10, (left / 2).max(10)).min(left);

    let height = usize::from(area.height);
    let at = lines.iter().position(|line| matches!(line, Line::Row(row) if *row == editing.cursor().row)).unwrap_or(0);
    let cursor = editing.cursor_mut();
    cursor.height = height;
    // with the heading above it
    let wanted = if at == 1 { 0 } else { at };
    let lowest = (at + 1).saturating_sub(height);
    let top = cursor.top.clamp(lowest, wanted.max(lowest)).min(lines.len().saturating_sub(height).max(lowest));
    cursor.top = top;
    let position = (lines.len() > height)
        .then(|| format!("lines {}-{} of {}", top + 1, (top + height).min(lines.len()), lines.len()));

    let mut drawn = Drawn { cell: None, position };
    for (line, y) in lines.iter().skip(top).zip(area.top()..area.bottom()) {
        let row = match line {
            Line::Heading(heading) => {
                buffer.set_stringn(area.x + 1, y, cut(heading, width - 1, theme.glyphs.ellipsis), width, theme.title);
                continue;
            }
            Line::Row(row) => *row,
        };
        let Some(cell) = editing.view.cell(row, 0) else { continue };
        let selected = row == editing.cursor().row;
        draw_row_marker(editing, row, theme, (area.x, y), buffer);
        let name = cut(&cell.column.label, label, theme.glyphs.ellipsis);
        buffer.set_stringn(area.x + 2, y, name, label, Style::new());
        let place =
            Rect { x: area.x + 2 + label as u16, y, width: (value + AROUND) as u16, height: 1 }.intersection(area);
        draw_cell(editing, (row, 0), false, selected, theme, place, buffer);
        let rest = usize::from(area.right().saturating_sub(place.right()));
        let doc = if cell.shown.is_derived() { "from the gear data" } else { cell.column.doc };
        let doc = format!("{:<unit$}  {doc}", cell.column.unit);
        buffer.set_stringn(place.right(), y, cut(&doc, rest, theme.glyphs.ellipsis), rest, theme.faint);
        if selected {
            drawn.cell = Some(place);
        }
    }
    drawn
}
