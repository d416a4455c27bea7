//! Results as text: tables to read, CSV and JSON to compute with.

pub mod csv;
mod figures;
pub mod json;
mod text;

pub use figures::{Figures, Peak};
pub use text::Table;
