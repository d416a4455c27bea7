//! Results as text: tables to read, CSV and JSON to compute with.

pub mod csv;
pub mod json;
mod text;

pub use text::Table;
