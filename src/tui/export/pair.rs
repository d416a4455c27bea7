//! The gear pair, as a document.

use super::source;
use crate::document::{Document, Picture};
use crate::pair;
use crate::tui::app::App;
use crate::tui::pair::Shown;

impl App {
    /// The pair of the design whose tables lie below; nothing as long as the text never was a design.
    pub(super) fn pair_document(&self) -> Option<Document> {
        let editing = self.editors.open()?;
        let shown = Shown::new(editing)?;
        let mut notes = pair::notes(&shown.figures);
        if shown.is_outdated {
            notes.push("The design has errors: this is from before them.".into());
        }
        Some(Document {
            title: "Gear pair".into(),
            sources: vec![source(editing)],
            notes,
            picture: pair::sketch(&shown.design, &shown.figures).map(Picture::Sketch),
            tables: vec![pair::table_of(&shown.design, &shown.figures)],
            data: pair::data(&shown.design, &shown.figures),
        })
    }
}
