//! Designs that are being edited, and edits that were never saved.

/// A row a design.
pub fn rows() -> Vec<(String, String)> {
    vec![("locks and journals".into(), "none are kept by this version".into())]
}
