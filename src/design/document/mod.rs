//! Edits of a design file that leave every other byte as it was.
//!
//! The text itself is spliced, at the places that `scan` and `statement` find. Printing a `toml_edit::DocumentMut` instead
//! would turn `\r\n` into `\n`, drop a byte order mark, add a last line break and regroup dotted keys. What is found is not
//! trusted: every edit also says what the file should mean afterwards (a [`Tree`]), and a text that reads otherwise is
//! not taken over.
//!
//! | file | what it does |
//! | --- | --- |
//! | `scan`, `statement`, `items` | where things stand: in lines, in statements, between brackets |
//! | `tree` | what the text says |
//! | `view`, `order` | how something is written; where the schema wants it |
//! | `put`, `take`, `rows`, `rename`, `comment` | the edits |

mod comment;
mod items;
mod order;
mod put;
mod rename;
mod rows;
mod scan;
mod splice;
mod statement;
mod take;
mod tree;
mod view;

use toml::de::DeTable;
use toml_edit::Value;

pub(super) use rows::NewRow;
pub(super) use splice::Change;
pub(super) use tree::Tree;

use super::key_path::{KeyPath, Step};
use splice::{Splice, spliced};
use view::{Spot, View};

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
    #[error("{0} cannot be changed in the file as it is written")]
    NoPlace(KeyPath),
    /// Why, in one sentence
    #[error("{0}")]
    Refused(String),
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
        let view = self.view();
        match view.find(&view.tree.by_place(path)) {
            Spot::Inline(span) => self.text.get(span),
            _ => None,
        }
    }

    /// The value with its spelling; nothing where there is none, or a table with a header of its own.
    pub fn get(&self, path: &KeyPath) -> Option<Value> {
        self.raw(path)?.parse().ok()
    }

    /// Replaces a value, or adds a key to a table; a table that is not there is added. Comments, order, line ends and the
    /// spelling of everything else stay.
    ///
    /// # Errors
    ///
    /// See [`EditError`]. Entries of lists and lists of tables are not added.
    pub fn set(&mut self, path: &KeyPath, value: impl Into<Value>) -> Result<(), EditError> {
        let value = value.into().decorated("", "").to_string();
        self.put(path, &value).map(|_| ())
    }

    /// Takes a key or a table out.
    ///
    /// # Errors
    ///
    /// See [`EditError`].
    pub fn unset(&mut self, path: &KeyPath) -> Result<(), EditError> {
        self.remove(path).map(|_| ())
    }

    /// As [`set`](Self::set), with the value in TOML; gives what changed.
    pub(super) fn put(&mut self, path: &KeyPath, value: &str) -> Result<Option<Change>, EditError> {
        self.put_all(std::slice::from_ref(path), value)
    }

    /// The same value at several paths that have nothing to do with one another. The text is read once before and once
    /// after, however many they are.
    pub(super) fn put_all(&mut self, paths: &[KeyPath], value: &str) -> Result<Option<Change>, EditError> {
        let Some(first) = paths.first() else { return Ok(None) };
        let view = self.view();
        let mut meant = view.tree.clone();
        let mut splices = Vec::new();
        for path in paths {
            let path = view.tree.by_place(path);
            splices.extend(put::put(&view, &path, value)?);
            *meant.at_mut(&path).ok_or_else(|| EditError::NoPlace(path.clone()))? = Tree::read_value(value);
        }
        self.take_over(&splices, meant, first)
    }

    /// As [`unset`](Self::unset); gives what changed.
    pub(super) fn remove(&mut self, path: &KeyPath) -> Result<Option<Change>, EditError> {
        let view = self.view();
        let path = view.tree.by_place(path);
        let splices = take::take(&view, &path)?;
        let mut meant = view.tree.clone();
        meant.remove(&path);
        self.take_over(&splices, meant, &path)
    }

    /// Says something beside a value or a header that has a line of its own, in place of what was said there.
    pub(super) fn comment(&mut self, path: &KeyPath, text: &str) -> Result<Option<Change>, EditError> {
        let view = self.view();
        let path = view.tree.by_place(path);
        let (splices, meant) = (comment::comment(&view, &path, text), view.tree.clone());
        self.take_over(&splices, meant, &path)
    }

    /// Puts a row, or an entry, at a place of a list that may not be there yet.
    pub(super) fn insert_row(
        &mut self,
        list: &KeyPath,
        place: usize,
        row: &NewRow,
    ) -> Result<Option<Change>, EditError> {
        let view = self.view();
        let mut meant = view.tree.clone();
        let no_place = || EditError::NoPlace(list.place(place));
        let rows = meant.list_mut(list).ok_or_else(no_place)?;
        let new = match row {
            NewRow::Keys(keys) => Tree::Table(keys.iter().map(|(k, v)| (k.clone(), Tree::read_value(v))).collect()),
            NewRow::Entry(value) => Tree::read_value(value),
            NewRow::CopyOf(other) => rows.get(*other).ok_or_else(|| EditError::NotThere(list.place(*other)))?.clone(),
        };
        if place > rows.len() {
            return Err(EditError::NotThere(list.place(place)));
        }
        rows.insert(place, new);
        let splices = rows::insert(&view, list, place, row)?;
        self.take_over(&splices, meant, &list.place(place))
    }

    /// Takes a row, or an entry, out of its list.
    pub(super) fn delete_row(&mut self, list: &KeyPath, place: usize) -> Result<Option<Change>, EditError> {
        let view = self.view();
        let row = list.place(place);
        let splices = rows::delete(&view, &row)?;
        let mut meant = view.tree.clone();
        meant.list_mut(list).filter(|rows| place < rows.len()).map(|rows| rows.remove(place));
        self.take_over(&splices, meant, &row)
    }

    /// Swaps a row with the one after it.
    pub(super) fn swap_rows(&mut self, list: &KeyPath, place: usize) -> Result<Option<Change>, EditError> {
        let view = self.view();
        let splices = rows::swap(&view, list, place)?;
        let mut meant = view.tree.clone();
        if let Some(rows) = meant.list_mut(list).filter(|rows| place + 1 < rows.len()) {
            rows.swap(place, place + 1);
        }
        self.take_over(&splices, meant, &list.place(place))
    }

    /// Gives the last key of the path another name.
    pub(super) fn rename(&mut self, path: &KeyPath, name: &str) -> Result<Option<Change>, EditError> {
        let view = self.view();
        let Some((around, Step::Key(_))) = path.split_last() else { return Err(EditError::NoPlace(path.clone())) };
        if view.tree.at(&around.key(name)).is_some() {
            return Err(EditError::Refused(format!("there is a {} already", around.key(name))));
        }
        let splices = rename::rename(&view, path, name)?;
        let mut meant = view.tree.clone();
        let named = meant.remove(path).ok_or_else(|| EditError::NotThere(path.clone()))?;
        *meant.at_mut(&around.key(name)).ok_or_else(|| EditError::NoPlace(path.clone()))? = named;
        self.take_over(&splices, meant, path)
    }

    /// Takes over another text as a whole.
    pub(super) fn replace(&mut self, text: &str) -> Result<Option<Change>, EditError> {
        let new = Self::parse(text)?;
        let change = Change::between(&self.text, &new.text);
        *self = new;
        Ok(change)
    }

    /// What the text says.
    pub(super) fn tree(&self) -> Tree {
        Tree::read(&self.text)
    }

    /// How lines of the text end.
    pub(super) fn line_break(&self) -> &'static str {
        line_break(&self.text)
    }

    /// For undoing and redoing.
    pub(super) fn text_mut(&mut self) -> &mut String {
        &mut self.text
    }

    fn view(&self) -> View<'_> {
        View::new(&self.text, self.tree())
    }

    /// The text is only taken over if it says what was meant.
    fn take_over(&mut self, splices: &[Splice], meant: Tree, path: &KeyPath) -> Result<Option<Change>, EditError> {
        let text = spliced(&self.text, splices);
        let edited = Self::parse(text).map_err(|_| EditError::NoPlace(path.clone()))?;
        if edited.tree().pruned() != meant.pruned() {
            return Err(EditError::NoPlace(path.clone()));
        }
        let change = Change::between(&self.text, &edited.text);
        *self = edited;
        Ok(change)
    }
}

/// A key as it is written: bare, or in quotes.
pub(super) fn toml_key(name: &str) -> String {
    toml_edit::Key::new(name).to_string()
}

fn line_break(text: &str) -> &'static str {
    if text.contains("\r\n") { "\r\n" } else { "\n" }
}
