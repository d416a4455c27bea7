//! What lies over what: the mode that listens to the keys, and those below it.

use super::action::Action;
use super::app::{App, Outcome};
use super::keymap::Mode;

impl App {
    /// All modes, the lowest first.
    pub fn layers(&self) -> impl Iterator<Item = Mode> {
        self.below.iter().copied().chain([self.mode])
    }

    /// Puts a mode over the present one.
    pub(super) fn open(&mut self, mode: Mode) {
        self.below.push(self.mode);
        self.mode = mode;
    }

    /// Back to the mode below.
    pub(super) fn close(&mut self) {
        self.mode = self.below.pop().unwrap_or(Mode::Library);
        // the text may have gone while something lay over it
        if self.mode == Mode::Text && !self.has_text() {
            self.mode = Mode::Library;
        }
    }

    /// Whether an action would do something now.
    pub fn applies(&self, action: Action) -> bool {
        let panes = matches!(self.mode, Mode::Library | Mode::Text | Mode::Filter);
        let selected = self.library.selected();
        match action {
            Action::NextPane => self.has_text() && self.detail.text_scroll.last() > 0,
            Action::NextMatch | Action::PreviousMatch if self.mode == Mode::Help => !self.help_search.is_empty(),
            Action::NextMatch | Action::PreviousMatch => {
                !self.library.filter().is_empty() && self.mode == Mode::Library
            }
            Action::Filter | Action::MoveUp | Action::MoveDown if panes => !self.library.is_empty(),
            Action::Back => self.mode != Mode::Library || !self.library.filter().is_empty(),
            Action::Mark | Action::Rename | Action::Duplicate | Action::Delete => selected.is_some(),
            Action::Compare => selected.is_some_and(|row| self.compared_with(row).is_some()),
            _ => true,
        }
    }

    /// Whether the present outcome is a solution.
    pub fn is_solved(&self) -> bool {
        matches!(self.detail.outcome, Some(Outcome::Solved { .. }))
    }
}
