//! Pictures as what is in them.

use super::Sketch;

/// One of few kinds.
#[derive(Debug, Clone)]
pub enum Picture {
    Panels(Panels),
    Shafts(Shafts),
    Rows(Rows),
    Matrix(Matrix),
    Sketch(Sketch),
}

/// Whose line it is, for colours and dashes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Line {
    Fe,
    Enhanced,
    Basic,
    Reduced,
}

/// Plots over one another with the same frequencies.
#[derive(Debug, Clone)]
pub struct Panels {
    /// Hz
    pub range: (f64, f64),
    pub log: bool,
    /// The upper one first
    pub panels: Vec<Panel>,
    /// Shaded in all of them
    pub bands: Vec<Span>,
    /// What the shade means
    pub band: String,
    /// Ascending
    pub marks: Vec<Mark>,
}

#[derive(Debug, Clone)]
pub struct Panel {
    /// With the unit
    pub label: String,
    pub range: (f64, f64),
    pub curves: Vec<Curve>,
    /// Values that a line is drawn at
    pub levels: Vec<f64>,
}

#[derive(Debug, Clone)]
pub struct Curve {
    pub line: Line,
    pub name: String,
    /// Hz and value, ascending; a value that is no number parts the line
    pub points: Vec<(f64, f64)>,
}

/// A range of frequencies.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    pub from_hz: f64,
    pub to_hz: f64,
    /// What is in it
    pub text: String,
}

/// A frequency with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    pub hz: f64,
    pub text: String,
    /// A line through all panels with the text beside it, else the text alone, above
    pub line: bool,
}

/// Shapes of both shafts.
#[derive(Debug, Clone)]
pub struct Shafts {
    pub shafts: Vec<Shaft>,
}

#[derive(Debug, Clone)]
pub struct Shaft {
    pub name: String,
    /// m
    pub ends: (f64, f64),
    /// m, and whether it is rigid
    pub bearings: Vec<(f64, bool)>,
    /// m
    pub mesh: f64,
    pub planes: Vec<Plane>,
}

#[derive(Debug, Clone)]
pub struct Plane {
    pub name: String,
    /// m, and displacement over the largest of all
    pub curves: Vec<Curve>,
}

/// A small spectrum in each row.
#[derive(Debug, Clone)]
pub struct Rows {
    /// What they show, with the unit
    pub label: String,
    /// Lowest and highest level drawn
    pub range: (f64, f64),
    pub rows: Vec<(String, Vec<f64>)>,
}

/// Values from 0 to 1 in squares.
#[derive(Debug, Clone)]
pub struct Matrix {
    pub row_label: String,
    pub column_label: String,
    /// A list a row
    pub rows: Vec<Vec<f64>>,
}
