//! A message changes the state and says what is to be done.

use std::path::PathBuf;
use std::sync::Arc;

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

use super::action::Action;
use super::app::{App, BROKEN, Outcome, Picture, UNSOLVABLE};
use super::backend::LoadedDesign;
use super::files::Purpose;
use super::keymap::Mode;
use super::library::RowState;
use super::message::{Effect, Ending, Message};
use super::notice::NoticeKind;
use super::solving::{Solved, Ticket};
use super::text_field::TextField;

impl App {
    /// Takes in one message.
    pub fn update(&mut self, message: Message) -> Vec<Effect> {
        let mut effects = self.take_in(message);
        self.keep_notice_of_editor();
        let protection = self.protect();
        // before the program ends
        effects.splice(0..0, protection);
        effects
    }

    fn take_in(&mut self, message: Message) -> Vec<Effect> {
        match message {
            Message::Key(event) => self.key(event),
            Message::Paste(text) => self.paste(&text),
            // it may have had another size in between, and shows what that left
            Message::Resized => vec![Effect::Redraw],
            Message::Loaded { ticket, path, result } => {
                if let Some(row) = self.library.row_mut(&path).filter(|row| ticket >= row.ticket) {
                    row.ticket = ticket;
                    let parent = |loaded: &Arc<LoadedDesign>| loaded.design.parent.clone();
                    let before = row.loaded.as_ref().and_then(parent);
                    let moves = before != result.as_ref().ok().and_then(parent);
                    match &result {
                        Ok(loaded) => {
                            row.loaded = Some(loaded.clone());
                            // figures from before a rereading stay until the new ones are there
                            if !matches!(row.state, RowState::Solved(_)) {
                                row.state = RowState::Loaded;
                            }
                        }
                        Err(broken) => {
                            row.loaded = None;
                            row.stale = false;
                            row.state = RowState::Broken(broken.clone());
                        }
                    }
                    self.library.names_changed(moves);
                }
                if self.awaits(ticket, &path) {
                    match result {
                        Ok(loaded) => self.detail.loaded = Some(loaded),
                        Err(broken) => self.finish(Outcome::Failed { title: BROKEN, text: broken.full_text }),
                    }
                }
                self.follow_selection()
            }
            Message::Solved { ticket, path, result } => {
                self.solved(ticket, &path, result);
                Vec::new()
            }
            Message::Opened { path, result } => {
                let effects = self.opened(path, result);
                self.show_awaited_pair();
                effects
            }
            Message::MeshTable { ticket, result } => {
                self.mesh_table_came(ticket, result);
                Vec::new()
            }
            Message::Progress { ticket, done } => {
                self.progress(ticket, done);
                Vec::new()
            }
            Message::SolvedEdited { ticket, path, result } => {
                self.solved_edited(ticket, &path, result);
                Vec::new()
            }
            Message::Saved { path, text, result } => self.saved(&path, text, result),
            Message::VariantSaved { original, result } => self.variant_saved(&original, result),
            message @ (Message::Looked { .. } | Message::Left(_) | Message::Protected(_) | Message::NotTidied(_)) => {
                self.hear_of_recovery(message);
                Vec::new()
            }
            Message::Listed(Ok(paths)) => {
                self.notice.take_if(|notice| notice.kind == NoticeKind::NotListed);
                self.library.replace(paths);
                let mut effects = self.follow_selection();
                effects.extend(self.fill());
                effects
            }
            Message::Listed(Err(error)) => {
                self.notify(error, NoticeKind::NotListed);
                Vec::new()
            }
            Message::FileChanged { request, result } => self.file_done(request, result),
            Message::Compared { ticket, result } => {
                self.compared(ticket, *result);
                Vec::new()
            }
            Message::Spectra { ticket, part } => {
                self.spectra_came(ticket, &part);
                Vec::new()
            }
            Message::Exported(result) => {
                self.exported(result);
                Vec::new()
            }
            Message::ModesFound { ticket, result } => self.modes_found(ticket, result),
            Message::Suspend => vec![Effect::Suspend],
            Message::Continued => vec![Effect::TakeAgain],
            Message::Signal(number) => vec![Effect::Quit(Ending::Signal(number))],
            Message::TerminalGone => vec![Effect::Quit(Ending::TerminalGone)],
        }
    }

    fn awaits(&self, ticket: Ticket, path: &PathBuf) -> bool {
        self.detail.pending && self.detail.ticket == ticket && self.detail.path.as_ref() == Some(path)
    }

    fn finish(&mut self, outcome: Outcome) {
        self.detail.pending = false;
        self.detail.outcome = Some(outcome);
        if self.mode == Mode::Text && !self.has_text() {
            self.mode = Mode::Library;
        }
    }

    fn solved(&mut self, ticket: Ticket, path: &PathBuf, result: Result<Solved, String>) {
        if let Some(row) = self.library.row_mut(path).filter(|row| ticket >= row.ticket) {
            row.ticket = ticket;
            row.stale = false;
            row.state = match &result {
                Ok(solved) => RowState::Solved(solved.summary.clone()),
                Err(message) => RowState::Unsolvable(message.clone()),
            };
        }
        if self.awaits(ticket, path) {
            match result {
                Ok(Solved { summary, traces: Some(traces), bearings }) => {
                    let Some(loaded) = self.detail.loaded.take() else { return };
                    self.finish(Outcome::Solved {
                        loaded,
                        summary: Box::new(summary),
                        picture: Box::new(Picture::new(*traces)),
                        bearings,
                    });
                }
                Ok(_) => {}
                Err(text) => self.finish(Outcome::Failed { title: UNSOLVABLE, text }),
            }
        }
    }

    fn key(&mut self, event: KeyEvent) -> Vec<Effect> {
        if event.kind == KeyEventKind::Release {
            return Vec::new();
        }
        let action = self.keys.action(self.mode, event);
        // nothing is done to what cannot be seen
        if self.is_unseen && !matches!(action, Some(Action::Quit | Action::Suspend | Action::Redraw)) {
            return Vec::new();
        }
        self.clear_notice();
        if let Some(action) = action {
            return self.run(action);
        }
        match event.code {
            KeyCode::Char(letter) if !event.modifiers.intersects(KeyModifiers::CONTROL | KeyModifiers::ALT) => {
                if self.mode.is_typing() {
                    self.type_text(letter.encode_utf8(&mut [0; 4]))
                } else {
                    // the first letter of a number begins a cell
                    self.type_in_editor(letter)
                }
            }
            _ => Vec::new(),
        }
    }

    /// Letters, where something is typed.
    fn type_text(&mut self, text: &str) -> Vec<Effect> {
        match self.mode {
            Mode::Cell | Mode::Form => self.paste_in_editor(text),
            Mode::New => {
                self.type_in_new(text);
                Vec::new()
            }
            _ => self.edit(|field| field.insert(text)),
        }
    }

    /// Changes what is being typed.
    fn edit(&mut self, edit: impl FnOnce(&mut TextField)) -> Vec<Effect> {
        match self.mode {
            Mode::Filter => return self.edit_filter(edit),
            Mode::HelpSearch => self.edit_help_search(edit),
            Mode::Palette => self.edit_palette(edit),
            Mode::Name => self.edit_form(edit),
            Mode::Export => self.edit_export(edit),
            Mode::Frequency => self.edit_frequency(edit),
            Mode::Torque => self.edit_torque_field(edit),
            Mode::FaceWidth => self.edit_face_width(edit),
            Mode::MeshFile => self.edit_mesh_file(edit),
            Mode::New => self.edit_new(edit),
            _ => {}
        }
        Vec::new()
    }

    /// Text from the clipboard is text and never keys: a `q` in it does not quit.
    fn paste(&mut self, text: &str) -> Vec<Effect> {
        if self.is_unseen {
            return Vec::new();
        }
        let effects = self.type_text(text);
        if self.mode.is_typing() && text.trim_end().contains(['\n', '\r']) {
            let said = "only the first line was taken";
            match self.editors.open_mut().filter(|_| self.below.is_empty()) {
                Some(editing) => editing.say(said),
                None => self.say(said),
            }
        }
        effects
    }

    pub(super) fn edit_filter(&mut self, edit: impl FnOnce(&mut TextField)) -> Vec<Effect> {
        self.library.edit_filter(edit);
        self.follow_selection()
    }

    pub(super) fn act(&mut self, action: Action) -> Vec<Effect> {
        match action {
            Action::MoveUp => self.move_by(-1),
            Action::MoveDown => self.move_by(1),
            Action::PageUp => self.move_by(-self.page()),
            Action::PageDown => self.move_by(self.page()),
            Action::First => self.move_by(isize::MIN),
            Action::Last => self.move_by(isize::MAX),
            Action::NextPane => {
                self.mode = if self.mode == Mode::Library && self.has_text() { Mode::Text } else { Mode::Library };
                Vec::new()
            }
            Action::Filter if self.mode == Mode::Help => {
                self.open_help_search();
                Vec::new()
            }
            Action::Filter => {
                self.mode = Mode::Filter;
                self.edit_filter(TextField::end)
            }
            Action::KeepFilter if self.mode == Mode::HelpSearch => {
                self.close();
                Vec::new()
            }
            Action::KeepFilter => {
                self.mode = Mode::Library;
                Vec::new()
            }
            Action::NextMatch | Action::PreviousMatch if self.mode == Mode::Help => {
                self.help_search.cycle(if action == Action::NextMatch { 1 } else { -1 });
                Vec::new()
            }
            Action::NextMatch => self.next_match(1),
            Action::PreviousMatch => self.next_match(-1),
            Action::ToggleTree => {
                self.library.toggle_tree();
                self.say(if self.library.is_tree() { "variants below their parents" } else { "all designs by name" });
                self.follow_selection()
            }
            Action::Compare => self.open_compare(),
            Action::Swap => self.swap_compared(),
            Action::Mark
            | Action::Rename
            | Action::Duplicate
            | Action::Delete
            | Action::Palette
            | Action::Messages
            | Action::Help => {
                self.open_for(action);
                Vec::new()
            }
            Action::RestoreDeleted => self.restore_deleted(),
            Action::Accept => match self.mode {
                Mode::Palette => self.run_chosen(),
                Mode::Name => self.accept_form(),
                Mode::Export => self.accept_export(),
                Mode::Confirm => self.delete_confirmed(),
                _ => Vec::new(),
            },
            Action::Back => self.back(),
            Action::Reread => {
                let ticket = self.ticket();
                self.library.mark_stale(ticket);
                let mut effects = self.solve_selected();
                effects.push(Effect::List);
                effects.extend(self.fill());
                effects
            }
            Action::Redraw => vec![Effect::Redraw],
            Action::Suspend => vec![Effect::Suspend],
            Action::Quit => self.quit(),
            Action::OpenEditor => self.open_editor(),
            Action::SaveAll => self.save_all(),
            Action::DiscardAll
            | Action::Recover
            | Action::TakeEdits
            | Action::DiscardEdits
            | Action::NextOffer
            | Action::KeepMine
            | Action::TakeTheirs
            | Action::SaveVariant => self.answer(action),
            Action::CycleMarker | Action::ToggleBackground => self.change_looks(action),
            Action::Copy | Action::CopyPath => self.copy(action),
            // the rest is about what is typed, or the editor's
            _ => TextField::edit_of(action).map_or(Vec::new(), |edit| self.edit(edit)),
        }
    }

    /// What needs nothing but another state.
    fn open_for(&mut self, action: Action) {
        match action {
            Action::Mark => self.toggle_mark(),
            Action::Rename => self.open_form(Purpose::Rename),
            Action::Duplicate => self.open_form(Purpose::Duplicate),
            Action::Delete => self.ask_to_delete(),
            Action::Palette => self.open_palette(),
            Action::Messages => self.open_messages(),
            Action::Help => self.open_help(),
            _ => {}
        }
    }
}
