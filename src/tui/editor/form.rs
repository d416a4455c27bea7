//! Name and note of a variant while they are typed.

use super::line::Line;
use crate::design::library::VariantName;

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Form {
    pub name: Line,
    pub note: Line,
    /// Whether the note has the cursor.
    pub on_note: bool,
    /// Why the variant was not saved.
    pub error: Option<String>,
}

impl Form {
    /// A name to begin with.
    pub fn new(name: String) -> Self {
        Self { name: Line::new(name), note: Line::default(), on_note: false, error: None }
    }

    /// The line that is typed into.
    pub fn line(&mut self) -> &mut Line {
        self.error = None;
        if self.on_note { &mut self.note } else { &mut self.name }
    }

    /// The name, or what is wrong with it.
    ///
    /// # Errors
    ///
    /// A sentence.
    pub fn checked_name(&self) -> Result<VariantName, String> {
        VariantName::new(self.name.text().trim()).map_err(|error| error.to_string())
    }
}
