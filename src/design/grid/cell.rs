//! One value of a table, as a person sees and edits it.

use crate::design::KeyPath;
use crate::design::schema::{Limit, Variant};
use crate::units::Quantity;

/// What a column, or a cell of a row's own, holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// As in the file: `outer_diameter_mm`
    pub key: &'static str,
    /// Short, without the unit: `outer diameter`, `point x`, `x thz`
    pub label: String,
    /// As people read it: `mm`; empty where there is none.
    pub unit: &'static str,
    /// One sentence.
    pub doc: &'static str,
}

/// One value.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    pub column: Column,
    /// By place: `pinion.bearing[0].kx_n_per_m`, `mesh.pinion.point_mm[2]`.
    pub path: KeyPath,
    pub shown: Shown,
    pub kind: CellKind,
    /// It must be written; otherwise it may be cleared.
    pub required: bool,
    /// Which findings are about it, as places in the list of findings.
    pub findings: Vec<usize>,
}

/// What a cell shows. Texts are as in the file: make them [printable](crate::text::printable).
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Shown {
    /// Written in the file: numbers as spelled there, texts without quotes, lists with commas.
    Written(String),
    /// Not written; this holds.
    Default(String),
    /// Not to be written: it follows from other values.
    Derived(String),
    /// Not written, and there is no value.
    Nothing,
}

/// What may be typed into a cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CellKind {
    /// With a unit of the quantity, or in the file's unit
    Number(Quantity, Limit),
    /// Within these bounds, both included
    Whole(u64, u64),
    Text,
    /// A text that is not empty
    Name,
    /// Words with commas between them
    Texts,
    /// One of these
    Choice(&'static [&'static str]),
    /// At least one of these
    Flags(&'static [&'static str]),
    /// One of three numbers
    VectorEntry(Quantity),
    /// One of 36 numbers, by row and column; the mirrored one changes with it
    MatrixEntry(usize, usize),
    /// The model of a bearing, one of these: the row has other cells afterwards
    Model(&'static [Variant]),
}

impl CellKind {
    /// What the number measures; nothing where it is none, or a whole one.
    pub fn quantity(self) -> Option<Quantity> {
        match self {
            Self::Number(quantity, _) | Self::VectorEntry(quantity) => Some(quantity),
            Self::MatrixEntry(row, column) => Some(matrix_quantity(row, column)),
            _ => None,
        }
    }

    /// The words to choose from, in order; none where anything else can be typed.
    pub fn words(self) -> Vec<&'static str> {
        match self {
            Self::Choice(words) | Self::Flags(words) => words.to_vec(),
            Self::Model(variants) => variants.iter().map(|v| v.word).collect(),
            _ => Vec::new(),
        }
    }
}

/// What an entry of a stiffness matrix measures: forces and moments over displacements and angles.
pub(super) fn matrix_quantity(row: usize, column: usize) -> Quantity {
    match (row < 3, column < 3) {
        (true, true) => Quantity::Stiffness,
        (true, false) => Quantity::ForcePerRadian,
        (false, true) => Quantity::Force,
        (false, false) => Quantity::AngularStiffness,
    }
}

impl Shown {
    /// The text without the mark.
    pub fn text(&self) -> &str {
        match self {
            Self::Written(text) | Self::Default(text) | Self::Derived(text) => text,
            Self::Nothing => "",
        }
    }

    pub fn is_derived(&self) -> bool {
        matches!(self, Self::Derived(_))
    }

    pub fn is_written(&self) -> bool {
        matches!(self, Self::Written(_))
    }
}
