//! Keys and results of the editor.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::keys::{act_on_choice, act_on_findings, act_on_form, act_on_input, act_on_matrix, act_on_table, line};
use super::{Editing, Input, Pending, Solution};
use crate::tui::action::Action;
use crate::tui::app::{App, Outcome, Picture};
use crate::tui::file_jobs::FileJob;
use crate::tui::keymap::Mode;
use crate::tui::message::Effect;
use crate::tui::solving::{EditedJob, Solved, Ticket};

impl App {
    /// Opens the tables of the selected design.
    pub(in crate::tui) fn open_editor(&mut self) -> Vec<Effect> {
        let Some(path) = self.library.selected().map(|row| row.path.clone()) else { return Vec::new() };
        let known = self.editors.get(&path);
        if known.is_some_and(|editing| editing.is_modified() || editing.is_saving) {
            return self.show_editor(path);
        }
        self.notice = None;
        self.editors.opening = Some(path.clone());
        self.editors.then_bearings = false;
        vec![Effect::File(FileJob::Open { path })]
    }

    /// The text of a design is there.
    pub(in crate::tui) fn opened(&mut self, path: PathBuf, result: Result<String, String>) -> Vec<Effect> {
        // another one was asked for meanwhile, or nothing any more
        if self.editors.opening.as_ref() != Some(&path) || !matches!(self.mode, Mode::Library | Mode::Text) {
            return Vec::new();
        }
        self.editors.opening = None;
        let unchanged = |editing: &Editing| result.as_ref().is_ok_and(|text| editing.saved_text() == text);
        if self.editors.get(&path).is_some_and(unchanged) {
            return self.show_editor(path);
        }
        let opened = result.and_then(|text| Editing::new(path.clone(), text).map_err(|error| error.to_string()));
        match opened {
            Ok(mut editing) => {
                editing.solving.current = self.solution_at_hand(&path);
                editing.keep_ghost();
                self.editors.put(editing);
                self.show_editor(path)
            }
            Err(error) => {
                self.editors.then_bearings = false;
                let reason = error.lines().next().unwrap_or_default().to_owned();
                self.complain(format!("no tables: {reason}"));
                Vec::new()
            }
        }
    }

    /// What the explorer shows of the design already.
    fn solution_at_hand(&self, path: &Path) -> Option<Solution> {
        if self.detail.path.as_deref() != Some(path) {
            return None;
        }
        let Some(Outcome::Solved { loaded, summary, picture, bearings }) = &self.detail.outcome else { return None };
        let design = Arc::new(loaded.design.clone());
        let picture = Picture::new(Arc::clone(&picture.traces));
        Some(Solution { design, summary: (**summary).clone(), picture, bearings: bearings.clone() })
    }

    pub(in crate::tui) fn show_editor(&mut self, path: PathBuf) -> Vec<Effect> {
        self.notice = None;
        self.editors.opening = None;
        self.editors.open = Some(path);
        self.follow_editor();
        if std::mem::take(&mut self.editors.then_bearings) {
            self.show_bearings(true);
        }
        self.solve_if_live()
    }

    /// Takes over what the open design says about mode and marks.
    pub(in crate::tui) fn follow_editor(&mut self) {
        let Some(editing) = self.editors.open() else { return };
        let (mode, unsaved, path) = (editing.mode(), editing.is_modified(), editing.path.clone());
        // the table is the lowest layer
        *self.below.first_mut().unwrap_or(&mut self.mode) = mode;
        if let Some(row) = self.library.row_mut(&path) {
            row.unsaved = unsaved;
        }
    }

    /// Back to the explorer; the edits stay.
    pub(in crate::tui) fn close_editor(&mut self) -> Vec<Effect> {
        if let Some(editing) = self.editors.open_mut() {
            editing.solving.pending = None;
            editing.notice = None;
        }
        self.editors.open = None;
        self.mode = Mode::Library;
        // the selection was not followed meanwhile
        let effects = self.follow_selection();
        if !effects.is_empty() {
            return effects;
        }
        if self.detail.pending || self.is_outdated() {
            return self.solve_selected();
        }
        vec![Effect::CancelSolve]
    }

    /// Whether what the explorer shows is not of the file as it was read last.
    fn is_outdated(&self) -> bool {
        let Some(row) = self.library.selected() else { return false };
        match (&self.detail.outcome, &row.loaded) {
            (Some(Outcome::Solved { loaded, .. }), Some(now)) => row.stale || loaded.design != now.design,
            _ => true,
        }
    }

    /// Asks for the solution of the design as it is now, if it is wanted and not under way.
    fn solve_if_live(&mut self) -> Vec<Effect> {
        if self.editors.live { self.solve_edited(false) } else { self.drop_outdated() }
    }

    /// A solution that is no longer of the design as it is now is not waited for.
    fn drop_outdated(&mut self) -> Vec<Effect> {
        let pending = self.editors.open_mut().and_then(|editing| editing.solving.pending.take());
        if pending.is_some() { vec![Effect::CancelSolve] } else { Vec::new() }
    }

    fn solve_edited(&mut self, asked: bool) -> Vec<Effect> {
        let ticket = self.ticket();
        let list = self.keys.names(Mode::Table, self.theme.glyphs.ascii).of(Action::Findings);
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        let Some(design) = editing.design.clone() else {
            if asked {
                let errors = editing.editor.reading().errors().count();
                let word = plural(errors, "error");
                editing.warn(format!("not solved: {errors} {word} in the design ({list} lists them)"));
            }
            return self.drop_outdated();
        };
        if !asked && !editing.wants_solution() {
            return self.drop_outdated();
        }
        editing.solving.failure = None;
        editing.solving.pending = Some(Pending { ticket, design: Arc::clone(&design), done: 0.0, is_fresh: true });
        vec![Effect::SolveEdited(EditedJob { ticket, path: editing.path.clone(), design })]
    }

    pub(in crate::tui) fn progress(&mut self, ticket: Ticket, done: f64) {
        let editing = self.editors.open_mut();
        if let Some(pending) = editing.and_then(|editing| editing.solving.pending.as_mut())
            && pending.ticket == ticket
        {
            pending.done = done;
        }
    }

    pub(in crate::tui) fn solved_edited(&mut self, ticket: Ticket, path: &Path, result: Result<Solved, String>) {
        let Some(editing) = self.editors.get_mut(path) else { return };
        let Some(Pending { design, .. }) = editing.solving.pending.take_if(|pending| pending.ticket == ticket) else {
            return;
        };
        match result {
            Ok(Solved { summary, traces: Some(traces), bearings }) => {
                let picture = Picture::new(Arc::new(*traces));
                editing.solving.current = Some(Solution { design, summary, picture, bearings });
                editing.keep_ghost();
            }
            Ok(_) => {}
            Err(text) => editing.solving.failure = Some((design, text)),
        }
    }

    /// What a key does while the tables are in sight; nothing if it is not the editor's.
    pub(in crate::tui) fn act_in_editor(&mut self, action: Action) -> Option<Vec<Effect>> {
        if !self.below.is_empty() {
            return None;
        }
        let mode = self.mode;
        let editing = self.editors.open_mut()?;
        editing.notice = None;
        if let Some(effects) = self.act_on_solution(action) {
            return Some(effects);
        }
        let editing = self.editors.open_mut()?;
        match action {
            Action::Back => return Some(self.back_in_editor()),
            Action::SaveForm => return Some(self.save_form()),
            Action::Help
            | Action::Modes
            | Action::Overview
            | Action::GearPair
            | Action::Palette
            | Action::Messages
            | Action::Quit
            | Action::Redraw
            | Action::Suspend
            | Action::SaveAll
            | Action::DiscardAll
            | Action::Recover
            | Action::Filter
            | Action::CycleMarker
            | Action::ToggleBackground
            | Action::Copy
            | Action::CopyPath
            | Action::Reread => return None,
            _ => match mode {
                Mode::Cell => act_on_input(editing, action),
                Mode::Form => act_on_form(editing, action),
                Mode::Choice => act_on_choice(editing, action),
                Mode::Findings => act_on_findings(editing, action),
                Mode::Matrix => act_on_matrix(editing, action),
                _ => act_on_table(editing, action),
            },
        }
        Some(self.after_edit())
    }

    /// What can be done with the open design from wherever its solution is in sight; nothing where the action is another.
    pub(in crate::tui) fn act_on_solution(&mut self, action: Action) -> Option<Vec<Effect>> {
        let solve = self.keys.names(self.mode, self.theme.glyphs.ascii).of(Action::Solve);
        let editing = self.editors.open_mut()?;
        Some(match action {
            Action::Save => self.save(None),
            Action::Solve => {
                let effects = self.solve_edited(true);
                self.follow_editor();
                effects
            }
            Action::ToggleLive => self.toggle_live(),
            Action::CancelSolve if editing.solving.pending.is_none() => {
                editing.say("nothing is being solved");
                Vec::new()
            }
            Action::CancelSolve => {
                editing.say(format!("stopped solving: {solve} starts again"));
                self.drop_outdated()
            }
            _ => return None,
        })
    }

    /// The text may have changed.
    pub(in crate::tui) fn after_edit(&mut self) -> Vec<Effect> {
        self.follow_editor();
        let Some(editing) = self.editors.open() else { return Vec::new() };
        let is_typed = editing.input.is_some();
        let settled = editing.solving.pending.is_none() && !editing.wants_solution();
        let same = editing.is_pending_for_now();
        if is_typed || settled || same { Vec::new() } else { self.solve_if_live() }
    }

    /// A letter that is no action's: the first letter of a number.
    pub(in crate::tui) fn type_in_editor(&mut self, letter: char) -> Vec<Effect> {
        let mode = self.mode;
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        if matches!(mode, Mode::Table | Mode::Matrix) && (letter.is_ascii_digit() || "-+.".contains(letter)) {
            editing.notice = None;
            editing.type_number(letter);
        }
        self.follow_editor();
        Vec::new()
    }

    pub(in crate::tui) fn paste_in_editor(&mut self, text: &str) -> Vec<Effect> {
        let editing = self.editors.open_mut();
        let line = editing.and_then(|editing| {
            editing.notice = None;
            editing.input.iter_mut().for_each(Input::replace_selected);
            line(editing)
        });
        if let Some(line) = line {
            line.insert(text);
        }
        Vec::new()
    }

    fn back_in_editor(&mut self) -> Vec<Effect> {
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        if editing.input.take().is_none() && editing.layer.take().is_none() {
            return self.close_editor();
        }
        self.after_edit()
    }

    fn toggle_live(&mut self) -> Vec<Effect> {
        self.editors.live = !self.editors.live;
        let solve = self.keys.names(self.mode, self.theme.glyphs.ascii).of(Action::Solve);
        let text =
            if self.editors.live { "each edit is solved".into() } else { format!("live solving off: {solve} solves") };
        if let Some(editing) = self.editors.open_mut() {
            editing.say(text);
        }
        self.solve_if_live()
    }
}

pub(super) fn plural(count: usize, word: &str) -> String {
    if count == 1 { word.to_owned() } else { format!("{word}s") }
}
