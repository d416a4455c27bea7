//! What a key does to the design in sight, by what it goes to.

use super::view::is_unknown;
use super::{Editing, Form, Layer, List, Tab, Target};
use crate::design::{Edit, KeyPath, Side, Towards};
use crate::tui::action::Action;
use crate::tui::text_field::TextField;

pub(super) fn act_on_table(editing: &mut Editing, action: Action) {
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

pub(super) fn act_on_matrix(editing: &mut Editing, action: Action) {
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

pub(super) fn act_on_choice(editing: &mut Editing, action: Action) {
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

pub(super) fn act_on_findings(editing: &mut Editing, action: Action) {
    let problems = editing.problems();
    let Some(Layer::Findings(list)) = &mut editing.layer else { return };
    let page = list.scroll.page();
    let by = match action {
        Action::MoveUp => -1,
        Action::MoveDown => 1,
        Action::PageUp => -page,
        Action::PageDown => page,
        Action::First => isize::MIN,
        Action::Last => isize::MAX,
        Action::RemoveKey => {
            let cursor = list.cursor;
            let path = problems.get(cursor).map(|finding| finding.key_path.clone());
            match path.filter(is_unknown) {
                Some(path) => drop(editing.make(&Edit::Remove { path })),
                None => editing.say("a table has this one: it is changed there"),
            }
            return;
        }
        Action::GoToFinding => {
            let cursor = list.cursor;
            let path = problems.get(cursor).map(|finding| finding.key_path.clone());
            match path {
                Some(path) if path == KeyPath::root() => editing.say("this one is about the whole file"),
                Some(path) => editing.go_to(&path),
                None => editing.layer = None,
            }
            return;
        }
        _ => return,
    };
    list.cursor = list.cursor.saturating_add_signed(by).min(problems.len().saturating_sub(1));
}

/// The line that is typed into.
pub(super) fn line(editing: &mut Editing) -> Option<&mut TextField> {
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
    if let Some(input) = &mut editing.input {
        match action {
            Action::DeleteCharacter | Action::DeleteForward | Action::DeleteWord => {
                if input.is_selected {
                    return input.replace_selected();
                }
            }
            _ => input.is_selected = false,
        }
    }
    if let (Some(line), Some(edit)) = (line(editing), TextField::edit_of(action)) {
        edit(line);
    }
}

pub(super) fn act_on_form(editing: &mut Editing, action: Action) {
    match &mut editing.layer {
        Some(Layer::Form(form)) if action == Action::NextField => form.switch(),
        _ => act_on_line(editing, action),
    }
}

pub(super) fn act_on_input(editing: &mut Editing, action: Action) {
    let is_new = editing.input.as_ref().is_some_and(|input| input.target == Target::NewMaterial);
    let in_matrix = matches!(editing.layer, Some(Layer::Matrix(_)));
    let by = match action {
        Action::AcceptCell => 0,
        Action::AcceptNext => 1,
        Action::AcceptPrevious => -1,
        _ => return act_on_line(editing, action),
    };
    let left = editing.target().map(|cell| cell.path.clone());
    if !editing.accept() || is_new {
        return;
    }
    if let Some(finding) = editing.findings().iter().find(|finding| Some(&finding.key_path) == left.as_ref()) {
        let (path, message) = (finding.key_path.clone(), finding.message.clone());
        let label = editing.editor.labels(std::iter::once(&path)).concat();
        editing.warn(format!("{label}: {message}"));
    }
    match (&mut editing.layer, by) {
        (Some(Layer::Matrix(entry)), 0) if in_matrix => entry.move_by(1, 0),
        (Some(Layer::Matrix(entry)), _) if in_matrix => entry.next(by),
        (_, 0) => editing.move_rows(1),
        (_, _) => editing.next_cell(by),
    }
}
