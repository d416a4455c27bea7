//! What a screen shows, as data: neither how it is drawn in a terminal nor how it is written to a file.
//!
//! A screen makes a [`Document`], [`report`](crate::report) makes a text of it, and neither knows the other.

mod format;
mod picture;
mod sketch;

pub use format::{Format, WrongExtension};
pub use picture::{Curve, Line, Mark, Matrix, Panel, Panels, Picture, Plane, Rows, Shaft, Shafts, Span};
pub use sketch::{Ink, Place, Sketch, SketchFrame, Stroke};

/// All that is written of a screen.
#[derive(Debug, Clone, Default)]
pub struct Document {
    /// `Dynamic mesh force`
    pub title: String,
    pub sources: Vec<Source>,
    /// Sentences below the title
    pub notes: Vec<String>,
    pub picture: Option<Picture>,
    /// What a page lists
    pub tables: Vec<Table>,
    /// What a table for a spreadsheet holds
    pub data: Table,
}

/// A design that a document is about.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Source {
    /// `design`, or what tells it from others: `design A`
    pub role: String,
    pub name: String,
    /// As of [`crate::design::hash`]; nothing where there is no file
    pub hash: Option<String>,
}

/// Columns of one length.
#[derive(Debug, Clone, Default)]
pub struct Table {
    pub caption: String,
    pub columns: Vec<Column>,
}

#[derive(Debug, Clone)]
pub struct Column {
    /// For programs, with the unit: `fe_mesh_force_n_re`
    pub key: String,
    /// For people, with the unit: `FE, Hz`
    pub name: String,
    pub values: Values,
}

#[derive(Debug, Clone)]
pub enum Values {
    /// In full precision; not a number where there is none
    Numbers(Vec<f64>),
    /// Numbers as people read them; empty where there is none
    Figures(Vec<String>),
    Texts(Vec<String>),
}

impl Column {
    pub fn new(key: impl Into<String>, name: impl Into<String>, values: Values) -> Self {
        Self { key: key.into(), name: name.into(), values }
    }
}

impl Values {
    pub fn len(&self) -> usize {
        match self {
            Self::Numbers(values) => values.len(),
            Self::Figures(texts) | Self::Texts(texts) => texts.len(),
        }
    }

    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

impl Table {
    pub fn rows(&self) -> usize {
        self.columns.iter().map(|column| column.values.len()).min().unwrap_or(0)
    }
}

impl Document {
    /// One line: the program, its version, each design and its hash.
    pub fn provenance(&self) -> String {
        let source = |source: &Source| {
            let hash = source.hash.as_deref().unwrap_or("unknown");
            format!(", {} {}, hash {hash}", source.role, source.name.replace(['\r', '\n'], " "))
        };
        let sources: String = self.sources.iter().map(source).collect();
        format!("bevelscope {}{sources}", env!("CARGO_PKG_VERSION"))
    }
}
