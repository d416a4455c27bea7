//! Results as text: tables to read, CSV and JSON to compute with.

pub mod csv;
pub mod json;
mod number;
mod text;

pub use number::{grouped, significant};
pub use text::Table;
