//! What the explorer shows of a design that was edited and saved.

use std::path::Path;
use std::sync::Arc;

use super::{Editing, Solution, same_mechanics};
use crate::design::Design;
use crate::tui::LoadedDesign;
use crate::tui::app::{App, Outcome, Picture, UNSOLVABLE};
use crate::tui::library::RowState;
use crate::tui::message::Effect;

impl Editing {
    /// The solution of what is in the file, if it is known, or why there is none.
    fn saved_outcome(&self) -> Option<Outcome> {
        let saved = self.saved_design()?;
        if let Some(text) = self.solving.failure(saved) {
            return Some(Outcome::Failed { title: UNSOLVABLE, text: text.to_owned() });
        }
        let loaded = Arc::new(LoadedDesign::from(Design::clone(saved)));
        let solved = |summary, traces, bearings| {
            let picture = Box::new(Picture::new(traces));
            Outcome::Solved { loaded, summary, picture, bearings }
        };
        if let Some(Solution { summary, picture, bearings, .. }) =
            self.solving.current.as_ref().filter(|solution| same_mechanics(&solution.design, saved))
        {
            return Some(solved(Box::new(summary.clone()), Arc::clone(&picture.traces), bearings.clone()));
        }
        let ghost = self.solving.ghost.as_ref().filter(|ghost| same_mechanics(&ghost.design, saved))?;
        Some(solved(Box::new(ghost.summary.clone()), ghost.traces(), ghost.bearings.clone()))
    }
}

impl App {
    /// What the tables have to say is kept with all other messages.
    pub(in crate::tui) fn keep_notice_of_editor(&mut self) {
        let notice = self.editors.open().and_then(|editing| editing.notice.clone());
        if notice != self.editors.kept_notice {
            if let Some(notice) = &notice {
                self.messages.keep(notice.text.clone());
            }
            self.editors.kept_notice = notice;
        }
    }

    /// A design was saved: what the explorer knows of it is of an earlier file. What the editor knows stands in for it
    /// until the file is read and solved again.
    pub(super) fn show_saved(&mut self, path: &Path) -> Vec<Effect> {
        let Some(editing) = self.editors.get(path) else { return Vec::new() };
        let is_valid = editing.saved_design().is_some();
        let outcome = editing.saved_outcome();
        if let Some(row) = self.library.row_mut(path) {
            row.stale = true;
            row.state = match &outcome {
                Some(Outcome::Solved { summary, .. }) => RowState::Solved((**summary).clone()),
                Some(Outcome::Failed { text, .. }) => RowState::Unsolvable(text.clone()),
                None if is_valid => RowState::Loaded,
                None => RowState::Pending,
            };
        }
        if self.detail.path.as_deref() != Some(path) {
            return Vec::new();
        }
        self.detail.outcome = outcome;
        // the editor's solutions come first while it is in sight; closing it asks for what is still to come
        self.detail.pending = true;
        self.detail.ticket = self.ticket();
        if self.editors.open().is_some() { Vec::new() } else { self.solve_selected() }
    }
}
