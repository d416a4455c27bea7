//! Edits of a design file that leave every other byte as it was.
//!
//! A value is replaced, or a line added, in the text itself, at the place that the parser names. Printing a
//! `toml_edit::DocumentMut` instead would turn `\r\n` into `\n`, drop a byte order mark, add a last line break and
//! regroup dotted keys. `toml_edit` gives the values and how they are spelled.

use std::ops::Range;

use toml::de::{DeTable, DeValue};
use toml_edit::Value;

use super::key_path::{KeyPath, Step};
use super::read::{Value as Parsed, walk};

/// The text of a design file, as TOML.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Document {
    text: String,
}

/// Why an edit could not be made. The document is as before.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum EditError {
    #[error("not TOML: {0}")]
    Syntax(String),
    #[error("there is no {0} in the file")]
    NotThere(KeyPath),
    #[error("{0} is a table or a list of tables, not a value")]
    NoValue(KeyPath),
    #[error("{0} cannot be added to the file as it is written")]
    NoPlace(KeyPath),
}

impl Document {
    /// # Errors
    ///
    /// [`EditError::Syntax`]; what the values mean is not looked at.
    pub fn parse(text: impl Into<String>) -> Result<Self, EditError> {
        let text = text.into();
        DeTable::parse(&text).map_err(|error| EditError::Syntax(error.message().into()))?;
        Ok(Self { text })
    }

    /// The whole text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The value as it is spelled in the file.
    pub fn raw(&self, path: &KeyPath) -> Option<&str> {
        let (root, _) = DeTable::parse_recoverable(&self.text);
        let walk = walk(root.get_ref(), path);
        let value = walk.value.filter(|value| walk.steps == path.steps().len() && !self.is_spread(value))?;
        self.text.get(value.span())
    }

    /// The value with its spelling; nothing where there is none, or a table with a header of its own.
    pub fn get(&self, path: &KeyPath) -> Option<Value> {
        self.raw(path)?.parse().ok()
    }

    /// Replaces a value, or adds a key to a table; a table that is not there is added at the end. Comments, order, line
    /// ends and the spelling of everything else stay.
    ///
    /// # Errors
    ///
    /// See [`EditError`]. Entries of lists and lists of tables are not added.
    pub fn set(&mut self, path: &KeyPath, value: impl Into<Value>) -> Result<(), EditError> {
        let value = value.into().decorated("", "").to_string();
        let (place, insertion) = self.edit(path, &value)?;
        let mut text = self.text.clone();
        text.replace_range(place, &insertion);
        // the text is only taken over if it says what was asked
        let edited = Self::parse(text).map_err(|_| EditError::NoPlace(path.clone()))?;
        if edited.raw(path) != Some(&value) {
            return Err(EditError::NoPlace(path.clone()));
        }
        *self = edited;
        Ok(())
    }

    /// Which bytes to replace with what.
    fn edit(&self, path: &KeyPath, value: &str) -> Result<(Range<usize>, String), EditError> {
        let (root, _) = DeTable::parse_recoverable(&self.text);
        let walk = walk(root.get_ref(), path);
        let missing = &path.steps()[walk.steps..];
        let key_of = |key: &str| KeyPath::root().key(key).to_string();
        match (missing, walk.value) {
            ([], Some(found)) if !self.is_spread(found) => Ok((found.span(), value.into())),
            ([], _) => Err(EditError::NoValue(path.clone())),
            ([Step::Key(key)], None) => {
                let end = self.end_of_values(root.get_ref()).map_or(self.start(), |end| self.next_line(end));
                Ok(self.line_at(end, end, &key_of(key), value))
            }
            ([Step::Key(key)], Some(found)) => {
                let DeValue::Table(table) = found.get_ref() else { return Err(EditError::NoPlace(path.clone())) };
                let end = self.end_of_values(table);
                match (self.first_byte(found), end) {
                    (Some(b'['), _) => {
                        let last = end.unwrap_or(found.span().end);
                        Ok(self.line_at(self.next_line(last), end.unwrap_or(0), &key_of(key), value))
                    }
                    (Some(b'{'), Some(end)) => Ok((end..end, format!(", {} = {value}", key_of(key)))),
                    (Some(b'{'), None) => Ok((found.span(), format!("{{ {} = {value} }}", key_of(key)))),
                    // dotted keys stay together with others; a table that only has tables below it gets its header
                    _ if end.is_some() => Err(EditError::NoPlace(path.clone())),
                    _ => self.table_at_end(path, key, value),
                }
            }
            ([Step::Key(_), Step::Key(key)], _) => self.table_at_end(path, key, value),
            _ => Err(EditError::NotThere(path.clone())),
        }
    }

    /// A new `[table]` with one key.
    fn table_at_end(&self, path: &KeyPath, key: &str, value: &str) -> Result<(Range<usize>, String), EditError> {
        let table = path.split_last().map(|(table, _)| table).unwrap_or_default();
        if table.steps().iter().any(|step| !matches!(step, Step::Key(_))) {
            return Err(EditError::NoPlace(path.clone()));
        }
        let (line_break, end) = (self.line_break(), self.text.len());
        let before = if self.text.is_empty() || self.text.ends_with('\n') { "" } else { line_break };
        let key = KeyPath::root().key(key);
        Ok((end..end, format!("{before}{line_break}[{table}]{line_break}{key} = {value}{line_break}")))
    }

    /// A line at that byte, indented like the line that `sibling` is on.
    fn line_at(&self, at: usize, sibling: usize, key: &str, value: &str) -> (Range<usize>, String) {
        let line_break = self.line_break();
        let start = self.text[..sibling].rfind('\n').map_or(0, |at| at + 1);
        let indent: String = self.text[start..sibling].chars().take_while(|c| *c == ' ' || *c == '\t').collect();
        let open = at > self.start() && !self.text[..at].ends_with('\n');
        let before = if open { line_break } else { "" };
        (at..at, format!("{before}{indent}{key} = {value}{line_break}"))
    }

    /// Where the last value ends that is written in the table itself, not under a header of its own.
    fn end_of_values(&self, table: &DeTable<'_>) -> Option<usize> {
        let end = |value: &Parsed<'_>| match value.get_ref() {
            _ if self.is_under_header(value) => None,
            // of dotted keys, those below count
            DeValue::Table(below) if self.first_byte(value) != Some(b'{') => self.end_of_values(below),
            _ => Some(value.span().end),
        };
        table.values().filter_map(end).max()
    }

    /// A table with a header, a list of such tables, or a table of dotted keys: not one value in one place.
    fn is_spread(&self, value: &Parsed<'_>) -> bool {
        self.is_under_header(value) || (value.get_ref().is_table() && self.first_byte(value) != Some(b'{'))
    }

    fn is_under_header(&self, value: &Parsed<'_>) -> bool {
        match value.get_ref() {
            DeValue::Table(_) => self.first_byte(value) == Some(b'['),
            DeValue::Array(entries) => {
                entries.first().is_some_and(|entry| entry.get_ref().is_table() && self.is_under_header(entry))
            }
            _ => false,
        }
    }

    fn first_byte(&self, value: &Parsed<'_>) -> Option<u8> {
        self.text.as_bytes().get(value.span().start).copied()
    }

    /// The start of the text, after a byte order mark.
    fn start(&self) -> usize {
        if self.text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 }
    }

    fn next_line(&self, from: usize) -> usize {
        self.text[from..].find('\n').map_or(self.text.len(), |at| from + at + 1)
    }

    fn line_break(&self) -> &'static str {
        if self.text.contains("\r\n") { "\r\n" } else { "\n" }
    }
}
