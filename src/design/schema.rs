//! What a design file may hold: tables of fields, each declared once beside the struct field that it fills.
//!
//! The declarations are in `model.rs` and `rotor.rs` of this folder; [`ROOT`] is the top. Reading, limits,
//! hints, table columns and the reference page all come from here.

use crate::units::Quantity;

use super::key_path::{KeyPath, Step};
use super::model::Design;

/// The whole file.
pub const ROOT: &Table = Design::TABLE;

/// The table of a design file that a struct is read from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Table {
    /// What it is called in headings: `segment`; the root is `design`.
    pub name: &'static str,
    pub doc: &'static str,
    pub fields: &'static [Field],
}

/// One key of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Field {
    /// The struct field that it fills; empty where it fills none.
    pub name: &'static str,
    /// As in the file, with its unit: `length_mm`
    pub key: &'static str,
    pub doc: &'static str,
    pub kind: Kind,
    pub presence: Presence,
}

/// What may be written for a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A number in the quantity's unit
    Number(Quantity, Limit),
    /// A whole number within these bounds, both included
    Whole(u64, u64),
    /// Any text
    Text,
    /// A text that is not empty
    Name,
    /// A list of texts
    Texts,
    /// One of these words
    Word(&'static [&'static str]),
    /// A list of at least one of these words, none twice
    Words(&'static [&'static str]),
    /// Three numbers in the quantity's unit
    Vector(Quantity),
    /// Six rows of six numbers, in the order x, y, z, thx, thy, thz (N/m, N, N/rad, N m/rad)
    Matrix,
    /// A table
    Table(&'static Table),
    /// A list of tables with at least that many entries
    Tables(&'static Table, usize),
    /// Tables by name: `[material.titanium]`
    NamedTables(&'static Table),
    /// A word that decides which further keys the same table has
    Variant(&'static [Variant]),
}

/// One choice of a [`Kind::Variant`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Variant {
    pub word: &'static str,
    /// Its own keys, beside the common ones
    pub table: &'static Table,
}

/// Which numbers are allowed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Limit {
    Any,
    /// > 0
    Positive,
    /// >= 0
    NotNegative,
    /// Strictly between the two, in the file's unit
    Between(f64, f64),
}

/// What happens where a key is not written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Presence {
    Required,
    /// Required unless the table has the other key; both at once are an error.
    Unless(&'static str),
    /// May be missing, and then there is no value.
    Optional,
    /// Has this value.
    Default(Written),
    /// Has this value in the table of that name, is required in others.
    DefaultIn(&'static str, Written),
}

/// A value as it could be written in a file, in the file's unit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Written {
    Number(f64),
    Whole(u64),
    Text(&'static str),
    /// This text and the place in the list, from 1: `B1`
    ByPlace(&'static str),
    /// A list or table without entries
    Empty,
}

impl Table {
    /// The field with that file key.
    pub fn field(&self, key: &str) -> Option<&'static Field> {
        self.fields.iter().find(|field| field.key == key)
    }

    /// The fields in order: its own, then those that a choice of [`Kind::Variant`] brings.
    pub fn all_fields(&'static self) -> impl Iterator<Item = &'static Field> {
        let chosen = |field: &'static Field| match field.kind {
            Kind::Variant(variants) => variants,
            _ => &[],
        };
        let chosen = self.fields.iter().flat_map(chosen).map(|variant| variant.table);
        self.fields.iter().chain(chosen.flat_map(|table| table.fields))
    }

    /// This table and every table below it, each once, parents first. The keys of variants come as tables of their own.
    pub fn walk(&'static self) -> Vec<&'static Table> {
        let mut tables = vec![self];
        let mut next = 0;
        while let Some(table) = tables.get(next).copied() {
            for below in table.fields.iter().flat_map(Field::tables) {
                if !tables.contains(&below) {
                    tables.push(below);
                }
            }
            next += 1;
        }
        tables
    }
}

/// Where a key path leads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Target {
    /// The table that has the field, or the last table where the path leads to one
    pub table: &'static Table,
    /// Nothing where the path leads to a table
    pub field: Option<&'static Field>,
    /// How many steps of the path lead to that table
    pub steps: usize,
}

/// Follows a key path through the schema; nothing where it leads nowhere. Steps after a field that is no table are entries
/// of its value.
pub fn target(path: &KeyPath) -> Option<Target> {
    let mut target = Target { table: ROOT, field: None, steps: 0 };
    let mut named = false;
    for (i, step) in path.steps().iter().enumerate() {
        match step {
            _ if target.field.is_some() => return Some(target),
            Step::Key(_) if named => named = false,
            Step::Key(key) => {
                let field = target.table.all_fields().find(|field| field.key == *key)?;
                named = matches!(field.kind, Kind::NamedTables(_));
                match field.kind {
                    Kind::Table(table) | Kind::Tables(table, _) | Kind::NamedTables(table) => target.table = table,
                    _ => {
                        target.field = Some(field);
                        continue;
                    }
                }
            }
            Step::Place(_) | Step::Name(_) => {}
        }
        target.steps = i + 1;
    }
    Some(target)
}

impl Field {
    /// What it is called in a few words: `outer diameter`.
    pub fn label(&self) -> String {
        if self.name.is_empty() { self.key.replace('_', " ") } else { self.name.replace('_', " ") }
    }

    /// The tables right below this field.
    pub fn tables(&self) -> Vec<&'static Table> {
        match self.kind {
            Kind::Table(table) | Kind::Tables(table, _) | Kind::NamedTables(table) => vec![table],
            Kind::Variant(variants) => variants.iter().map(|variant| variant.table).collect(),
            _ => Vec::new(),
        }
    }

    /// The quantity of its number or numbers.
    pub fn quantity(&self) -> Option<Quantity> {
        match self.kind {
            Kind::Number(quantity, _) | Kind::Vector(quantity) => Some(quantity),
            _ => None,
        }
    }
}

impl Limit {
    /// Is the value, in the file's unit, allowed? Not a number never is.
    pub fn allows(self, value: f64) -> bool {
        match self {
            Self::Any => !value.is_nan(),
            Self::Positive => value > 0.0,
            Self::NotNegative => value >= 0.0,
            Self::Between(low, high) => low < value && value < high,
        }
    }

    /// What is allowed, in words: `greater than 0 mm`. Empty where everything is.
    pub fn describe(self, quantity: Quantity) -> String {
        let unit = quantity.unit();
        let words = match self {
            Self::Any => String::new(),
            Self::Positive => format!("greater than 0 {unit}"),
            Self::NotNegative => format!("at least 0 {unit}"),
            Self::Between(low, high) => format!("between {low} and {high} {unit}, both excluded"),
        };
        words.trim_end().replace(" ,", ",")
    }
}
