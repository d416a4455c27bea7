//! What the cursor is on, as a text for the clipboard.

use super::action::Action;
use super::app::{App, Outcome};
use super::clipboard;
use super::compare::CompareView;
use super::editor::{Editing, Layer, Place};
use super::help::HelpLine;
use super::keymap::Mode;
use super::message::Effect;
use super::widgets::{figures, findings};
use crate::design::grid::Cell;
use crate::text::{excerpt, printable};

/// Letters of the copied text in the message.
const SHOWN: usize = 40;

impl App {
    /// Hands what the cursor is on, or the design's path, to the terminal.
    pub(super) fn copy(&mut self, action: Action) -> Vec<Effect> {
        let text = if action == Action::CopyPath { self.path_in_sight() } else { self.under_the_cursor() };
        let Some(text) = text.map(|text| harmless(&text)).filter(|text| !text.is_empty()) else {
            self.say_in_sight("there is nothing to copy here".into());
            return Vec::new();
        };
        match clipboard::sequence(&text, self.clipboard) {
            Ok(bytes) => {
                let lines = text.lines().count();
                let lines = if lines > 1 { format!("{lines} lines, ") } else { String::new() };
                self.say_in_sight(format!("sent to terminal: {lines}{}", excerpt(&text.replace('\t', " "), SHOWN)));
                vec![Effect::Copy(bytes)]
            }
            Err(error) => {
                self.complain(error.to_string());
                Vec::new()
            }
        }
    }

    fn path_in_sight(&self) -> Option<String> {
        let path = match self.editors.open() {
            Some(editing) => &editing.path,
            None => &self.library.selected()?.path,
        };
        Some(path.display().to_string())
    }

    fn under_the_cursor(&self) -> Option<String> {
        match self.mode {
            Mode::Help => Some(self.help_text()),
            Mode::Messages => Some(self.messages.text()),
            Mode::Compare => self.compare.as_ref().and_then(differences),
            Mode::Spectra => self.spectra.as_ref()?.readout_text(),
            Mode::Why => self.spectra.as_ref().map(|view| view.why().join("\n")),
            Mode::Modes => self.modes.as_ref().and_then(|view| view.as_text()),
            Mode::Overview => Some(self.overview_text()),
            Mode::Bearings => self.bearings_text(),
            Mode::Pair => self.pair_text(),
            Mode::Table | Mode::Matrix | Mode::Choice | Mode::Findings => self.editors.open().and_then(in_tables),
            _ => match &self.detail.outcome {
                Some(Outcome::Solved { summary, .. }) => {
                    Some(format!("{}: {}", self.path_in_sight()?, figures::sentence(summary)))
                }
                Some(Outcome::Failed { text, .. }) => Some(text.clone()),
                None => None,
            },
        }
    }

    fn help_text(&self) -> String {
        let line = |line: &HelpLine| match line {
            HelpLine::Title(title) => (*title).to_owned(),
            HelpLine::Entry { keys, text, .. } => format!("{keys}\t{text}"),
        };
        self.help_lines().iter().map(line).collect::<Vec<_>>().join("\n")
    }
}

/// The differences as lines with tabs, for a spreadsheet.
fn differences(view: &CompareView) -> Option<String> {
    let differences = view.result.as_ref()?.differences.as_ref().ok()?;
    let [a, b] = &view.names;
    let head = ["value", a, b, "unit"].map(field).join("\t");
    let lines = differences.iter().map(|difference| {
        let [a, b] = difference.shown();
        [&difference.label, a, b, difference.unit].map(field).join("\t")
    });
    Some(std::iter::once(head).chain(lines).collect::<Vec<_>>().join("\n"))
}

fn in_tables(editing: &Editing) -> Option<String> {
    match &editing.layer {
        Some(Layer::Choice(choice)) => choice.words.get(choice.cursor).map(ToString::to_string),
        Some(Layer::Findings(list)) => editing.findings().get(list.cursor).map(findings::sentence),
        _ => {
            let cursor = editing.cursor();
            match (editing.target(), editing.view.place(cursor.row, cursor.column)?) {
                (Some(cell), _) => Some(with_unit(cell)),
                (None, Place::Matrix) => Some(matrix(editing)),
                (None, _) => editing.view.shown(cursor.row, cursor.column).map(|shown| shown.text().to_owned()),
            }
        }
    }
}

/// As in the file, and the unit that stands in the file's key.
fn with_unit(cell: &Cell) -> String {
    let (text, unit) = (cell.shown.text(), cell.column.unit);
    if text.is_empty() || unit.is_empty() { text.to_owned() } else { format!("{text} {unit}") }
}

/// All entries, a row a line; they have several units, which the file's key does not name either.
fn matrix(editing: &Editing) -> String {
    let entry = |row, column| {
        let cell = editing.view.matrix_entry(editing.cursor().row, (row, column));
        cell.map_or(String::new(), |cell| field(cell.shown.text()))
    };
    let line = |row| (0..6).map(|column| entry(row, column)).collect::<Vec<_>>().join("\t");
    (0..6).map(line).collect::<Vec<_>>().join("\n")
}

/// A value between tabs.
fn field(text: &str) -> String {
    printable(text).into_owned()
}

/// Whoever pastes it into a shell must not be surprised: lines and tabs are kept, other control characters written out.
fn harmless(text: &str) -> String {
    let line = |line: &str| line.split('\t').map(printable).collect::<Vec<_>>().join("\t");
    text.trim_end().lines().map(line).collect::<Vec<_>>().join("\n")
}
