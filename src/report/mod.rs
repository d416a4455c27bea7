//! Results as text: tables to read, CSV and JSON to compute with, pictures and pages to keep.

pub mod csv;
pub mod document;
mod figures;
pub mod html;
pub mod json;
pub mod markup;
mod study;
pub mod svg;
mod text;

pub use figures::{Figures, Peak};
pub use study::{Curves, Levels, Study};
pub use text::Table;
