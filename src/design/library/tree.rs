//! Variants under the design that they came from.

/// A file in tree order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Branch {
    /// The place in the list that was given
    pub index: usize,
    /// 0 for those without a parent in the list
    pub depth: usize,
}

/// Brings files, given as (file stem, parent), in tree order: each followed by its children, otherwise in the order given.
/// One whose parent is not there stands at the top, and so does the first one of a circle. Each comes exactly once.
pub fn tree(files: &[(&str, Option<&str>)]) -> Vec<Branch> {
    files.iter().enumerate().map(|(index, _)| Branch { index, depth: 0 }).collect()
}
