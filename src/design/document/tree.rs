//! What a TOML text says, without how it is laid out: every edit is judged by it.

use std::collections::BTreeMap;

use toml::de::{DeTable, DeValue};

use crate::design::key_path::{KeyPath, Step};
use crate::design::schema::{Kind, Presence, ROOT, Table, Written};

/// A value with its spelling, or a list or table of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Tree {
    Value(String),
    List(Vec<Tree>),
    Table(BTreeMap<String, Tree>),
}

impl Tree {
    pub fn table() -> Self {
        Self::Table(BTreeMap::new())
    }

    /// What can be read of the text.
    pub fn read(text: &str) -> Self {
        Self::of_table(text, DeTable::parse_recoverable(text).0.get_ref())
    }

    /// What one value says.
    pub fn read_value(value: &str) -> Self {
        Self::of(value, &DeValue::parse_recoverable(value).0)
    }

    pub fn of_table(text: &str, table: &DeTable<'_>) -> Self {
        Self::Table(table.iter().map(|(key, value)| (key.get_ref().to_string(), Self::of(text, value))).collect())
    }

    fn of(text: &str, value: &toml::Spanned<DeValue<'_>>) -> Self {
        match value.get_ref() {
            DeValue::Table(table) => Self::of_table(text, table),
            DeValue::Array(entries) => Self::List(entries.iter().map(|entry| Self::of(text, entry)).collect()),
            _ => Self::Value(text.get(value.span()).unwrap_or_default().to_owned()),
        }
    }

    /// The path with every name turned into a place; as far as it leads.
    pub fn by_place(&self, path: &KeyPath) -> KeyPath {
        let mut at = Some(self);
        let mut schema = Some(ROOT);
        let mut found = KeyPath::root();
        for step in path.steps() {
            let step = match (step, at) {
                (Step::Name(name), Some(Self::List(entries))) => {
                    let is_named = |place: &usize| entries[*place].name(*place, schema).as_deref() == Some(name);
                    (0..entries.len()).find(is_named).map_or_else(|| step.clone(), Step::Place)
                }
                _ => step.clone(),
            };
            schema = match &step {
                Step::Key(key) => schema.and_then(|schema| match schema.field(key)?.kind {
                    Kind::Table(table) | Kind::Tables(table, _) => Some(table),
                    _ => None,
                }),
                _ => schema,
            };
            at = at.and_then(|tree| tree.below(&step));
            found = match step {
                Step::Key(key) => found.key(&key),
                Step::Place(place) => found.place(place),
                Step::Name(name) => found.name(&name),
            };
        }
        found
    }

    /// The name of a row: the one written, or the one that follows from the place.
    pub fn name(&self, place: usize, schema: Option<&Table>) -> Option<String> {
        if let Some(written) = self.get("name") {
            return written.text();
        }
        match schema?.field("name")?.presence {
            Presence::Default(Written::ByPlace(prefix)) => Some(format!("{prefix}{}", place + 1)),
            _ => None,
        }
    }

    fn below(&self, step: &Step) -> Option<&Self> {
        match (self, step) {
            (Self::Table(table), Step::Key(key)) => table.get(key),
            (Self::List(entries), Step::Place(place)) => entries.get(*place),
            _ => None,
        }
    }

    /// The value at a path by place.
    pub fn at(&self, path: &KeyPath) -> Option<&Self> {
        path.steps().iter().try_fold(self, |tree, step| tree.below(step))
    }

    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&Self> {
        match self {
            Self::Table(table) => table.get(key),
            _ => None,
        }
    }

    /// The entries of a list; none of anything else.
    pub fn entries(&self) -> &[Self] {
        match self {
            Self::List(entries) => entries,
            _ => &[],
        }
    }

    /// The keys of a table with their values.
    pub fn pairs(&self) -> impl Iterator<Item = (&str, &Self)> {
        let table = if let Self::Table(table) = self { Some(table) } else { None };
        table.into_iter().flatten().map(|(key, value)| (key.as_str(), value))
    }

    pub fn raw(&self) -> Option<&str> {
        if let Self::Value(raw) = self { Some(raw) } else { None }
    }

    /// The text of a value in quotes.
    pub fn text(&self) -> Option<String> {
        self.raw()?.parse::<toml_edit::Value>().ok()?.as_str().map(String::from)
    }

    /// The number, in the file's unit.
    pub fn number(&self) -> Option<f64> {
        let (value, _) = DeValue::parse_recoverable(self.raw()?);
        match value.get_ref() {
            DeValue::Float(float) => float.as_str().parse().ok(),
            DeValue::Integer(number) => {
                i64::from_str_radix(number.as_str(), number.radix()).ok().map(|number| number as f64)
            }
            _ => None,
        }
    }

    /// The same without keys that only hold empty lists and tables: whether those are written makes no difference.
    pub fn pruned(self) -> Self {
        match self {
            Self::Table(table) => {
                let pruned = table.into_iter().map(|(key, value)| (key, value.pruned()));
                Self::Table(pruned.filter(|(_, value)| !value.is_empty()).collect())
            }
            Self::List(entries) => Self::List(entries.into_iter().map(Self::pruned).collect()),
            Self::Value(value) => Self::Value(value),
        }
    }

    fn is_empty(&self) -> bool {
        match self {
            Self::Table(table) => table.is_empty(),
            Self::List(entries) => entries.is_empty(),
            Self::Value(_) => false,
        }
    }

    fn below_mut(&mut self, step: &Step) -> Option<&mut Self> {
        match (self, step) {
            (Self::Table(table), Step::Key(key)) => Some(table.entry(key.clone()).or_insert_with(Self::table)),
            (Self::List(entries), Step::Place(place)) => entries.get_mut(*place),
            _ => None,
        }
    }

    /// The value at a path by place; tables on the way are made.
    pub fn at_mut(&mut self, path: &KeyPath) -> Option<&mut Self> {
        path.steps().iter().try_fold(self, |tree, step| tree.below_mut(step))
    }

    /// The list at a path; made where nothing is there.
    pub fn list_mut(&mut self, path: &KeyPath) -> Option<&mut Vec<Self>> {
        let tree = self.at_mut(path)?;
        if tree.is_empty() {
            *tree = Self::List(Vec::new());
        }
        if let Self::List(entries) = tree { Some(entries) } else { None }
    }

    /// Takes a key out of its table.
    pub fn remove(&mut self, path: &KeyPath) -> Option<Self> {
        let (table, last) = path.split_last()?;
        match (self.at_mut(&table)?, last) {
            (Self::Table(table), Step::Key(key)) => table.remove(key),
            _ => None,
        }
    }
}
