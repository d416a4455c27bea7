//! Keys and results of the editor.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::{Editing, Form, Layer, Line, List, Pending, Solution, Tab};
use crate::design::{KeyPath, Side, Towards};
use crate::text::printable;
use crate::tui::action::Action;
use crate::tui::app::{App, Outcome, Picture};
use crate::tui::backend::NotSaved;
use crate::tui::keymap::Mode;
use crate::tui::message::{Effect, Ending};
use crate::tui::worker::{EditedJob, FileJob, Solved, Ticket};

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
                self.editors.all.retain(|other| other.path != path);
                self.editors.all.push(editing);
                self.show_editor(path)
            }
            Err(error) => {
                let reason = error.lines().next().unwrap_or_default().to_owned();
                self.notice = Some(format!("no tables: {reason}"));
                Vec::new()
            }
        }
    }

    /// What the explorer shows of the design already.
    fn solution_at_hand(&self, path: &Path) -> Option<Solution> {
        let row = self.library.selected().filter(|row| row.path == path)?;
        let Some(Outcome::Solved { summary, picture }) = &self.detail.outcome else { return None };
        let design = Arc::new(row.loaded.as_ref()?.design.clone());
        let picture = Picture::new(Arc::clone(&picture.traces));
        Some(Solution { design, summary: (**summary).clone(), picture })
    }

    fn show_editor(&mut self, path: PathBuf) -> Vec<Effect> {
        self.notice = None;
        self.editors.opening = None;
        self.editors.open = Some(path);
        self.follow_editor();
        self.solve_if_live()
    }

    /// Takes over what the open design says about mode and marks.
    pub(in crate::tui) fn follow_editor(&mut self) {
        let Some(editing) = self.editors.open() else { return };
        let (mode, unsaved, path) = (editing.mode(), editing.is_modified(), editing.path.clone());
        if !matches!(self.mode, Mode::Help | Mode::Leave) {
            self.mode = mode;
        }
        if let Some(row) = self.library.row_mut(&path) {
            row.unsaved = unsaved;
        }
    }

    /// Back to the explorer; the edits stay.
    fn close_editor(&mut self) -> Vec<Effect> {
        if let Some(editing) = self.editors.open_mut() {
            editing.solving.pending = None;
            editing.notice = None;
        }
        let left = self.editors.open.take();
        self.mode = Mode::Library;
        let stale = self.library.selected().is_some_and(|row| row.stale);
        if self.detail.pending || stale || self.detail.path != left {
            return self.solve_selected();
        }
        vec![Effect::CancelSolve]
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
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        let Some(design) = editing.design.clone() else {
            if asked {
                let errors = editing.editor.reading().errors().count();
                editing.warn(format!("not solved: {errors} {} in the design (f lists them)", plural(errors, "error")));
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
            Ok(Solved { summary, traces: Some(traces) }) => {
                let picture = Picture::new(Arc::new(*traces));
                editing.solving.current = Some(Solution { design, summary, picture });
                editing.keep_ghost();
            }
            Ok(_) => {}
            Err(text) => editing.solving.failure = Some((design, text)),
        }
    }

    /// What a key does while the tables are in sight; nothing if it is not the editor's.
    pub(in crate::tui) fn act_in_editor(&mut self, action: Action) -> Option<Vec<Effect>> {
        if matches!(self.mode, Mode::Help | Mode::Leave) {
            return None;
        }
        let mode = self.mode;
        let editing = self.editors.open_mut()?;
        editing.notice = None;
        match action {
            Action::Back => return Some(self.back_in_editor()),
            Action::Save => return Some(self.save(None)),
            Action::SaveForm => return Some(self.save_form()),
            Action::Solve => {
                let effects = self.solve_edited(true);
                self.follow_editor();
                return Some(effects);
            }
            Action::ToggleLive => return Some(self.toggle_live()),
            Action::CancelSolve => {
                if editing.solving.pending.is_none() {
                    editing.say("nothing is being solved");
                    return Some(Vec::new());
                }
                editing.say("stopped solving: = starts again");
                return Some(self.drop_outdated());
            }
            Action::Help
            | Action::Quit
            | Action::Redraw
            | Action::Suspend
            | Action::SaveAll
            | Action::DiscardAll
            | Action::Filter
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

    /// The text may have changed.
    fn after_edit(&mut self) -> Vec<Effect> {
        self.follow_editor();
        let Some(editing) = self.editors.open() else { return Vec::new() };
        let is_typed = editing.input.is_some();
        let settled = editing.solving.pending.is_none() && !editing.wants_solution();
        let same = editing.is_pending_for_now();
        if is_typed || settled || same { Vec::new() } else { self.solve_if_live() }
    }

    /// A letter that is no action's: text, or the first letter of a number.
    pub(in crate::tui) fn type_in_editor(&mut self, letter: char) -> Vec<Effect> {
        let mode = self.mode;
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        match mode {
            Mode::Table | Mode::Matrix if "-+.09".contains(letter) => {
                editing.notice = None;
                editing.type_number(letter);
            }
            Mode::Cell | Mode::Form => return self.paste_in_editor(letter.encode_utf8(&mut [0; 4])),
            _ => {}
        }
        self.follow_editor();
        Vec::new()
    }

    pub(in crate::tui) fn paste_in_editor(&mut self, text: &str) -> Vec<Effect> {
        if let Some(line) = self.editors.open_mut().and_then(line) {
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
        let text = if self.editors.live { "each edit is solved" } else { "live solving off: = solves" };
        if let Some(editing) = self.editors.open_mut() {
            editing.say(text);
        }
        self.solve_if_live()
    }

    /// Saves one design, or the one in sight.
    fn save(&mut self, path: Option<&Path>) -> Vec<Effect> {
        let editing = match path {
            Some(path) => self.editors.get_mut(path),
            None => self.editors.open_mut(),
        };
        let Some(editing) = editing else { return Vec::new() };
        if !editing.is_modified() {
            editing.say("nothing to save");
            return Vec::new();
        }
        if editing.is_saving {
            return Vec::new();
        }
        editing.is_saving = true;
        let (path, expected) = (editing.path.clone(), editing.saved_text().to_owned());
        vec![Effect::File(FileJob::Save { path, expected, text: editing.editor.text().to_owned() })]
    }

    pub(in crate::tui) fn saved(&mut self, path: &Path, text: String, result: Result<(), NotSaved>) -> Vec<Effect> {
        let Some(editing) = self.editors.get_mut(path) else { return Vec::new() };
        editing.is_saving = false;
        let name = file_name(path);
        match result {
            Ok(()) => {
                editing.saved(text);
                let errors = editing.editor.reading().errors().count();
                match errors {
                    0 => editing.say(format!("saved {name}")),
                    _ => editing.say(format!("saved {name}, with {errors} {}", plural(errors, "error"))),
                }
                let unsaved = editing.is_modified();
                if let Some(row) = self.library.row_mut(path) {
                    (row.unsaved, row.stale) = (unsaved, true);
                }
            }
            Err(error) => {
                editing.warn(match &error {
                    NotSaved::Changed => "not saved, changed on disk: S saves it as a variant".into(),
                    NotSaved::Failed(error) => format!("not saved: {error}"),
                });
                if self.editors.open().is_none_or(|editing| editing.path != path) {
                    self.notice = Some(format!("{name} not saved: {error}"));
                }
                self.editors.is_leaving = false;
                return Vec::new();
            }
        }
        if self.editors.is_leaving || self.mode == Mode::Leave {
            if self.editors.unsaved().next().is_none() {
                return vec![Effect::Quit(Ending::Quit)];
            }
            return Vec::new();
        }
        self.fill().into_iter().collect()
    }

    fn save_form(&mut self) -> Vec<Effect> {
        let Some(editing) = self.editors.open_mut() else { return Vec::new() };
        let (original, text) = (editing.path.clone(), editing.editor.text().to_owned());
        if editing.is_saving {
            return Vec::new();
        }
        let Some(Layer::Form(form)) = &mut editing.layer else { return Vec::new() };
        match form.checked_name() {
            Ok(name) => {
                let note = Some(form.note.text().trim()).filter(|note| !note.is_empty()).map(str::to_owned);
                editing.is_saving = true;
                vec![Effect::File(FileJob::SaveVariant { original, name, text, note })]
            }
            Err(error) => {
                form.error = Some(error);
                form.on_note = false;
                Vec::new()
            }
        }
    }

    pub(in crate::tui) fn variant_saved(
        &mut self,
        original: &Path,
        result: Result<(PathBuf, String), String>,
    ) -> Vec<Effect> {
        let Some(editing) = self.editors.get_mut(original) else { return Vec::new() };
        editing.is_saving = false;
        match result {
            Ok((path, text)) => {
                let name = file_name(&path);
                editing.become_variant(path.clone(), text);
                editing.say(format!("saved {name}, a variant of {}", file_name(original)));
                if let Some(row) = self.library.row_mut(original) {
                    row.unsaved = false;
                }
                let was_open = self.editors.open.as_deref() == Some(original);
                self.library.add(path.clone());
                if was_open {
                    self.editors.open = Some(path.clone());
                    self.library.select(&path);
                }
                let mut effects = self.follow_selection();
                effects.push(Effect::List);
                effects.extend(self.fill());
                effects.extend(self.after_edit());
                effects
            }
            Err(error) => {
                match &mut editing.layer {
                    Some(Layer::Form(form)) => form.error = Some(error),
                    _ => editing.warn(format!("no variant: {error}")),
                }
                Vec::new()
            }
        }
    }

    /// Ends the program, or asks what to do with edits that are not saved.
    pub(in crate::tui) fn quit(&mut self) -> Vec<Effect> {
        if self.editors.unsaved().next().is_none() {
            return vec![Effect::Quit(Ending::Quit)];
        }
        if self.mode != Mode::Leave {
            self.mode_below_leave = if self.mode == Mode::Help { self.mode_below_help } else { self.mode };
            self.mode = Mode::Leave;
        }
        Vec::new()
    }

    /// Saves everything and ends the program then.
    pub(in crate::tui) fn save_all(&mut self) -> Vec<Effect> {
        self.stay();
        self.editors.is_leaving = true;
        let paths: Vec<PathBuf> = self.editors.unsaved().map(|editing| editing.path.clone()).collect();
        paths.iter().flat_map(|path| self.save(Some(path))).collect()
    }

    /// Closes the question.
    pub(in crate::tui) fn stay(&mut self) {
        self.editors.is_leaving = false;
        self.mode = self.mode_below_leave;
        self.follow_editor();
    }
}

fn act_on_table(editing: &mut Editing, action: Action) {
    let tab = |tab: Tab, editing: &mut Editing| editing.show(tab, editing.side);
    match action {
        Action::MoveUp => editing.move_rows(-1),
        Action::MoveDown => editing.move_rows(1),
        Action::PageUp => editing.move_rows(-editing.page()),
        Action::PageDown => editing.move_rows(editing.page()),
        Action::First => editing.move_rows(isize::MIN),
        Action::Last => editing.move_rows(isize::MAX),
        Action::MoveLeft => drop(editing.move_columns(-1)),
        Action::MoveRight => drop(editing.move_columns(1)),
        Action::FirstCell => editing.move_to_end(false),
        Action::LastCell => editing.move_to_end(true),
        Action::NextCell => editing.next_cell(1),
        Action::PreviousCell => editing.next_cell(-1),
        Action::OtherShaft => other_shaft(editing),
        Action::NextTable => next_tab(editing, 1),
        Action::PreviousTable => next_tab(editing, Tab::ALL.len() - 1),
        Action::Segments => tab(Tab::Segments, editing),
        Action::Bearings => tab(Tab::Bearings, editing),
        Action::Bodies => tab(Tab::Bodies, editing),
        Action::Mesh => tab(Tab::Mesh, editing),
        Action::Drives => tab(Tab::Drives, editing),
        Action::Analysis => tab(Tab::Analysis, editing),
        Action::Materials => tab(Tab::Materials, editing),
        Action::Design => tab(Tab::Design, editing),
        Action::EditCell => editing.edit_cell(false),
        Action::ReplaceCell => editing.edit_cell(true),
        Action::CycleCell => editing.cycle_cell(),
        Action::ClearCell => editing.clear_cell(),
        Action::AddRow => editing.add_row(true),
        Action::InsertRow => editing.add_row(false),
        Action::DuplicateRow => editing.duplicate_row(),
        Action::DeleteRow => editing.delete_row(),
        Action::MoveRowUp => editing.move_row(Towards::Start),
        Action::MoveRowDown => editing.move_row(Towards::End),
        Action::Undo => editing.undo(),
        Action::Redo => editing.redo(),
        Action::Findings => editing.layer = Some(Layer::Findings(List::default())),
        Action::SaveVariant => {
            let stem = editing.path.file_stem().unwrap_or_default().to_string_lossy();
            editing.layer = Some(Layer::Form(Form::new(format!("{stem}-variant"))));
        }
        _ => {}
    }
}

fn other_shaft(editing: &mut Editing) {
    if !editing.tab.has_sides() {
        return editing.say("this table belongs to both shafts");
    }
    let cursor = editing.cursor();
    let other = if editing.side == Side::Pinion { Side::Gear } else { Side::Pinion };
    editing.show(editing.tab, other);
    // the same value of the other shaft, where the tables are alike
    if editing.view.is_turned() {
        *editing.cursor_mut() = cursor;
        editing.show(editing.tab, other);
    }
}

fn next_tab(editing: &mut Editing, by: usize) {
    let at = (editing.tab as usize + by) % Tab::ALL.len();
    editing.show(Tab::ALL[at], editing.side);
}

fn act_on_matrix(editing: &mut Editing, action: Action) {
    match action {
        Action::EditCell => return editing.edit_cell(false),
        Action::ReplaceCell => return editing.edit_cell(true),
        Action::ClearCell => return editing.clear_cell(),
        Action::Undo => return editing.undo(),
        Action::Redo => return editing.redo(),
        _ => {}
    }
    let Some(Layer::Matrix(entry)) = &mut editing.layer else { return };
    match action {
        Action::MoveUp => entry.move_by(-1, 0),
        Action::MoveDown => entry.move_by(1, 0),
        Action::First | Action::PageUp => entry.move_by(-6, 0),
        Action::Last | Action::PageDown => entry.move_by(6, 0),
        Action::MoveLeft => entry.move_by(0, -1),
        Action::MoveRight => entry.move_by(0, 1),
        Action::FirstCell => entry.move_by(0, -6),
        Action::LastCell => entry.move_by(0, 6),
        Action::NextCell => entry.next(1),
        Action::PreviousCell => entry.next(-1),
        _ => {}
    }
}

fn act_on_choice(editing: &mut Editing, action: Action) {
    if action == Action::Choose {
        return editing.choose();
    }
    let Some(Layer::Choice(choice)) = &mut editing.layer else { return };
    match action {
        Action::MoveUp => choice.move_by(-1),
        Action::MoveDown => choice.move_by(1),
        Action::First | Action::PageUp => choice.move_by(isize::MIN),
        Action::Last | Action::PageDown => choice.move_by(isize::MAX),
        Action::Tick => choice.tick(),
        _ => {}
    }
}

fn act_on_findings(editing: &mut Editing, action: Action) {
    let count = editing.findings().len();
    let Some(Layer::Findings(list)) = &mut editing.layer else { return };
    let page = list.scroll.page();
    let by = match action {
        Action::MoveUp => -1,
        Action::MoveDown => 1,
        Action::PageUp => -page,
        Action::PageDown => page,
        Action::First => isize::MIN,
        Action::Last => isize::MAX,
        Action::GoToFinding => {
            let cursor = list.cursor;
            let path = editing.findings().get(cursor).map(|finding| finding.key_path.clone());
            match path.as_deref().map(str::parse::<KeyPath>) {
                Some(Ok(path)) => editing.go_to(&path),
                Some(Err(_)) => editing.say("this one is about the whole file"),
                None => editing.layer = None,
            }
            return;
        }
        _ => return,
    };
    list.cursor = list.cursor.saturating_add_signed(by).min(count.saturating_sub(1));
}

/// The line that is typed into.
fn line(editing: &mut Editing) -> Option<&mut Line> {
    if let Some(input) = &mut editing.input {
        input.error = None;
        return Some(&mut input.line);
    }
    match &mut editing.layer {
        Some(Layer::Form(form)) => Some(form.line()),
        _ => None,
    }
}

fn act_on_line(editing: &mut Editing, action: Action) {
    let Some(line) = line(editing) else { return };
    match action {
        Action::TextLeft => line.left(),
        Action::TextRight => line.right(),
        Action::TextStart => line.home(),
        Action::TextEnd => line.end(),
        Action::DeleteCharacter => line.backspace(),
        Action::DeleteForward => line.delete(),
        Action::DeleteWord => line.delete_word(),
        Action::ClearText => line.delete_to_start(),
        _ => {}
    }
}

fn act_on_form(editing: &mut Editing, action: Action) {
    match &mut editing.layer {
        Some(Layer::Form(form)) if action == Action::NextField => form.on_note = !form.on_note,
        _ => act_on_line(editing, action),
    }
}

fn act_on_input(editing: &mut Editing, action: Action) {
    let is_new = editing.input.as_ref().is_some_and(|input| input.target == super::Target::NewMaterial);
    let in_matrix = matches!(editing.layer, Some(Layer::Matrix(_)));
    let by = match action {
        Action::AcceptCell => 0,
        Action::AcceptNext => 1,
        Action::AcceptPrevious => -1,
        _ => return act_on_line(editing, action),
    };
    if !editing.accept() || is_new {
        return;
    }
    match (&mut editing.layer, by) {
        (Some(Layer::Matrix(entry)), 0) if in_matrix => entry.move_by(1, 0),
        (Some(Layer::Matrix(entry)), _) if in_matrix => entry.next(by),
        (_, 0) => editing.move_rows(1),
        (_, _) => editing.next_cell(by),
    }
}

/// The file's name, harmless to show.
fn file_name(path: &Path) -> String {
    printable(&path.file_name().unwrap_or_default().to_string_lossy()).into_owned()
}

fn plural(count: usize, word: &str) -> String {
    if count == 1 { word.to_owned() } else { format!("{word}s") }
}
