//! Reading one table of the file: each field once, then whatever is left over is unknown.

use std::collections::BTreeMap;
use std::ops::Range;

use toml::de::{DeTable, DeValue};

use super::{Value, did_you_mean, listed};
use crate::design::finding::Collector;
use crate::design::key_path::KeyPath;
use crate::design::schema::{Field, Kind, Presence, Table, Written};
use crate::text::printable;

/// What a struct field can be read from.
pub(crate) trait FromFile: Sized {
    /// Reads the field from the table. A value that cannot be read is reported, and something stands in for it that no
    /// check objects to (not-a-number, an empty text).
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self;
}

/// A struct that is read from a table of its own; [`tables!`] writes this.
pub(crate) trait FromTable: Sized {
    const TABLE: &'static Table;
    fn from_table(reader: &mut TableReader<'_>) -> Self;
}

/// What a table has for a field.
pub(crate) enum Found<'r> {
    Written(&'r Value<'r>),
    Default(Written),
    /// Optional and left out, or required and reported
    Nothing,
}

/// One table while it is read.
pub(crate) struct TableReader<'r> {
    pub table: &'r DeTable<'r>,
    /// The header, or the whole of an inline table
    span: Range<usize>,
    pub path: KeyPath,
    /// The place in a list of tables, from 0
    pub place: usize,
    /// The name of a named table
    name: &'r str,
    pub text: &'r str,
    pub findings: &'r Collector,
    /// The schemas that the keys come from
    pub schemas: Vec<&'static Table>,
    /// The word that chose the second schema; `None` in it: any further key may be right
    pub variant: Option<(&'static Field, Option<&'static str>)>,
    /// The table stands in for one that is missing and reported
    silent: bool,
}

impl<'r> TableReader<'r> {
    pub fn root(table: &'r DeTable<'r>, text: &'r str, findings: &'r Collector) -> Self {
        let schemas = vec![crate::design::schema::ROOT];
        let (span, path) = (0..0, KeyPath::root());
        Self { table, span, path, place: 0, name: "", text, findings, schemas, variant: None, silent: false }
    }

    /// A reader for a table at `path` below this one.
    fn below(&self, table: &'r DeTable<'r>, span: Range<usize>, path: KeyPath, schema: &'static Table) -> Self {
        let (text, findings, silent) = (self.text, self.findings, self.silent);
        let schemas = vec![schema];
        Self { table, span, path, place: 0, name: "", text, findings, schemas, variant: None, silent }
    }

    pub fn path_of(&self, field: &Field) -> KeyPath {
        self.path.key(field.key)
    }

    /// Does the table have the key?
    pub fn is_written(&self, field: &Field) -> bool {
        self.table.contains_key(field.key)
    }

    pub fn look_up(&self, field: &'static Field) -> Found<'r> {
        if let Some(value) = self.table.get(field.key) {
            if let Presence::Unless(other) = field.presence
                && self.table.contains_key(other)
            {
                let message = format!("goes with `{other}` never: write the one or the other");
                self.wrong(&self.path_of(field), value, message, None);
            }
            return Found::Written(value);
        }
        match field.presence {
            Presence::Unless(other) if self.table.contains_key(other) => Found::Nothing,
            Presence::Default(written) => Found::Default(written),
            Presence::DefaultIn(name, written) if name == self.name => Found::Default(written),
            Presence::Optional => Found::Nothing,
            Presence::Required | Presence::Unless(_) | Presence::DefaultIn(..) => {
                self.report_missing(field);
                Found::Nothing
            }
        }
    }

    fn report_missing(&self, field: &Field) {
        if self.silent || self.findings.is_full() {
            return;
        }
        let path = self.path_of(field);
        let (message, hint) = match field.kind {
            Kind::Table(_) => (format!("the table [{path}] is missing"), None),
            Kind::Tables(_, _) => (format!("at least one [[{path}]] is wanted"), None),
            _ => (format!("`{}` is missing", field.key), Some(super::written::describe(field))),
        };
        let hint = hint.or_else(|| match field.presence {
            Presence::Unless(other) => Some(format!("{} Or write [{}].", field.doc, self.path.key(other))),
            _ => Some(field.doc.into()),
        });
        self.findings.error(&path, self.span.clone(), message, hint);
    }

    /// Reports what is wrong with a written value.
    pub fn wrong(&self, path: &KeyPath, value: &Value<'_>, message: impl Into<String>, hint: Option<String>) {
        self.findings.error(path, value.span(), message, hint);
    }

    /// Reports every key that no field was read from. The last thing to do with a reader.
    pub fn finish(self) {
        for (key, _) in self.table {
            let name = key.get_ref().as_ref();
            if self.findings.is_full() {
                return;
            }
            let path = self.path.key(name);
            match self.schemas.iter().find_map(|schema| schema.field(name)) {
                Some(_) => {}
                None => self.unknown(&path, name, key.span()),
            }
        }
    }

    fn unknown(&self, path: &KeyPath, name: &str, span: Range<usize>) {
        if let Some((field, chosen)) = self.variant {
            let Kind::Variant(variants) = field.kind else { return };
            let owner = variants.iter().find(|variant| variant.table.field(name).is_some());
            match (chosen, owner) {
                // which keys are right is not known before the model is
                (None, _) => return,
                (Some(chosen), Some(owner)) => {
                    let message = format!(
                        "`{name}` belongs to {} \"{}\"; this {} is \"{chosen}\"",
                        field.key, owner.word, self.schemas[0].name
                    );
                    return self.findings.error(path, span, message, Some(self.allowed()));
                }
                (Some(_), None) => {}
            }
        }
        let hint = format!("{}{}", did_you_mean(name, self.keys()), self.allowed());
        self.findings.error(path, span, "unknown key", Some(hint));
    }

    fn allowed(&self) -> String {
        format!("allowed here: {}", listed(self.keys()))
    }

    /// The keys that may be written here.
    fn keys(&self) -> impl Iterator<Item = &'static str> {
        let fields = self.schemas.iter().flat_map(|schema| schema.fields);
        fields.map(|field| field.key)
    }

    fn read_table<T: FromTable>(&self, path: KeyPath, value: &'r Value<'r>, place: usize, name: &'r str) -> Option<T> {
        let DeValue::Table(table) = value.get_ref() else {
            let written = super::written::what(self.text, value);
            self.wrong(&path, value, format!("expected a table, found {written}"), None);
            return None;
        };
        let mut reader = Self { place, name, ..self.below(table, value.span(), path, T::TABLE) };
        let read = T::from_table(&mut reader);
        reader.finish();
        Some(read)
    }

    /// What stands in for a table that is not there: all defaults, and not-a-number for what has none.
    fn read_nothing<T: FromTable>(&self, name: &'r str) -> T {
        let nothing = DeTable::new();
        let mut reader = TableReader {
            table: &nothing,
            name,
            silent: true,
            ..TableReader::below(self, &nothing, 0..0, self.path.clone(), T::TABLE)
        };
        T::from_table(&mut reader)
    }
}

impl<T: FromTable> FromFile for T {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        let read = match reader.look_up(field) {
            Found::Written(value) => reader.read_table(reader.path_of(field), value, 0, ""),
            Found::Default(_) | Found::Nothing => None,
        };
        read.unwrap_or_else(|| reader.read_nothing(""))
    }
}

impl<T: FromTable> FromFile for Option<T> {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        reader.is_written(field).then(|| T::from_file(reader, field))
    }
}

impl<T: FromTable> FromFile for Vec<T> {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        let Found::Written(value) = reader.look_up(field) else { return Self::new() };
        let path = reader.path_of(field);
        let DeValue::Array(entries) = value.get_ref() else {
            let written = super::written::what(reader.text, value);
            let message = format!("expected a list of tables, found {written}");
            let hint = format!("write [[{path}]], or {} = [{{ ... }}]", field.key);
            reader.wrong(&path, value, message, Some(hint));
            return Self::new();
        };
        if let Kind::Tables(table, at_least) = field.kind
            && entries.len() < at_least
        {
            reader.wrong(&path, value, format!("at least {at_least} {} is wanted", table.name), None);
        }
        let read = |(place, entry)| {
            reader.read_table(path.place(place), entry, place, "").unwrap_or_else(|| reader.read_nothing(""))
        };
        entries.iter().enumerate().map(read).collect()
    }
}

impl<T: FromTable> FromFile for BTreeMap<String, T> {
    /// Adds the tables that need no writing.
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        let mut read = Self::new();
        if let Found::Written(value) = reader.look_up(field) {
            let path = reader.path_of(field);
            if let DeValue::Table(named) = value.get_ref() {
                for (key, value) in named {
                    let name = key.get_ref().as_ref();
                    let entry = reader.read_table(path.key(name), value, 0, name);
                    read.insert(name.into(), entry.unwrap_or_else(|| reader.read_nothing(name)));
                }
            } else {
                let written = super::written::what(reader.text, value);
                let message = format!("expected tables by name, found {written}");
                let hint = format!("write [{}.NAME]", printable(&path.to_string()));
                reader.wrong(&path, value, message, Some(hint));
            }
        }
        for name in T::TABLE.fields.iter().filter_map(|field| match field.presence {
            Presence::DefaultIn(name, _) => Some(name),
            _ => None,
        }) {
            read.entry(name.into()).or_insert_with(|| reader.read_nothing(name));
        }
        read
    }
}
