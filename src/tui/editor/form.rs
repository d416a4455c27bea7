//! Name and note of a variant while they are typed.

use crate::design::library::{NameError, VariantName};
use crate::tui::text_field::TextField;

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Form {
    pub name: TextField,
    pub note: TextField,
    /// Whether the note has the cursor.
    pub on_note: bool,
    /// Why the variant was not saved.
    pub error: Option<String>,
}

impl Form {
    /// A name to begin with.
    pub fn new(name: String) -> Self {
        Self { name: TextField::proposed(name), note: TextField::default(), on_note: false, error: None }
    }

    /// The line that is typed into.
    pub fn line(&mut self) -> &mut TextField {
        self.error = None;
        if self.on_note { &mut self.note } else { &mut self.name }
    }

    /// Goes to the other line, whose text is selected.
    pub fn switch(&mut self) {
        self.line().deselect();
        self.on_note = !self.on_note;
        self.line().select();
    }

    /// The name, or what is wrong with it.
    ///
    /// # Errors
    ///
    /// [`NameError`]
    pub fn checked_name(&self) -> Result<VariantName, NameError> {
        VariantName::new(self.name.text().trim())
    }
}
