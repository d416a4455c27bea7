//! The gear pair of a design that is being edited: what the screen shows, and what its keys do.
//!
//! ```text
//! design ─> PairFigures ─> lines of numbers, picture
//! key    ─> face width ─> Estimate ────────┐
//!        └> file ─> flanks ─> differences ─┴─> one edit
//! ```

mod estimate;
mod import;
mod keys;
mod lines;

use std::sync::Arc;

pub use estimate::EstimateForm;
pub use import::{ImportForm, Preview};
pub use lines::{Line, lines, text};

use super::app::{App, Scroll};
use super::editor::Editing;
use crate::design::Design;
use crate::pair::PairFigures;

/// The view. The design is the one whose tables lie below.
#[derive(Debug, Default)]
pub struct PairView {
    /// Opened from the list of designs: back goes there.
    from_list: bool,
    pub scroll: Scroll,
    /// The face width is being typed.
    pub estimate: Option<EstimateForm>,
    /// A table of mesh numbers is being chosen or looked through.
    pub import: Option<ImportForm>,
}

impl PairView {
    fn scrolled(&mut self) -> &mut Scroll {
        match &mut self.import {
            Some(form) => &mut form.scroll,
            None => &mut self.scroll,
        }
    }

    /// Lines of a page.
    pub fn page(&self) -> isize {
        self.import.as_ref().map_or(&self.scroll, |form| &form.scroll).page()
    }

    pub(super) fn move_by(&mut self, by: isize) {
        self.scrolled().by(by);
    }
}

/// What is shown of a design.
#[derive(Debug)]
pub struct Shown {
    pub design: Arc<Design>,
    pub figures: PairFigures,
    /// The text has errors, and this is from before them.
    pub is_outdated: bool,
}

impl Shown {
    /// Nothing as long as the text never was a design.
    pub fn new(editing: &Editing) -> Option<Self> {
        let design = editing.last_design.clone()?;
        let figures = PairFigures::new(&design);
        Some(Self { design, figures, is_outdated: editing.design.is_none() })
    }
}

impl App {
    /// The numbers as lines with tabs, for a spreadsheet.
    pub(super) fn pair_text(&self) -> Option<String> {
        Some(text(&Shown::new(self.editors.open()?)?))
    }
}
