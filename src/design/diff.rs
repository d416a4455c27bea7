//! Where two designs differ.

use super::KeyPath;

/// One value, or one row, that is not the same in two designs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// By name where rows have names (`pinion.bearing[B1].kx_n_per_m`), else by place.
    pub path: KeyPath,
    /// In words: `kx of pinion bearing B1`
    pub label: String,
    /// As spelled in the first design, texts without quotes; nothing where it has no such value or row. Defaults count.
    pub a: Option<String>,
    /// So in the second.
    pub b: Option<String>,
    /// As people read it; empty where there is none.
    pub unit: &'static str,
}

/// Everything that differs, in the order of the schema. Numbers are compared as numbers, rows by name where they have
/// names, else by place. A row that only one has is one difference, with `row` in place of its values.
pub fn diff(a: &str, b: &str) -> Vec<Difference> {
    let _ = (a, b);
    Vec::new()
}
