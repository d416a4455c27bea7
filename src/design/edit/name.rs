//! What an edit is called.

use std::fmt;

/// What an edit is called, by meaning: `outer diameter of pinion segment 3`. May hold characters of the file: make it
/// [printable](crate::text::printable) before it is shown.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct EditName(String);

impl EditName {
    pub fn new(name: impl Into<String>) -> Self {
        Self(name.into())
    }

    pub fn as_str(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for EditName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}
