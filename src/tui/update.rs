//! A message changes the state and says what is to be done.

use std::path::PathBuf;

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyEventKind, KeyModifiers};

use super::action::Action;
use super::app::{App, BROKEN, Outcome, Picture, UNSOLVABLE};
use super::keymap::{self, Mode};
use super::library::RowState;
use super::message::{Effect, Ending, Message};
use super::worker::{Solved, Ticket};

impl App {
    /// Takes in one message.
    pub fn update(&mut self, message: Message) -> Vec<Effect> {
        match message {
            Message::Key(event) => self.key(event),
            Message::Paste(text) => self.paste(&text),
            Message::Resized => Vec::new(),
            Message::Loaded { ticket, path, result } => {
                if let Some(row) = self.library.row_mut(&path).filter(|row| ticket >= row.ticket) {
                    row.ticket = ticket;
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
                    self.library.names_changed();
                }
                if let Err(broken) = result
                    && self.awaits(ticket, &path)
                {
                    self.finish(Outcome::Failed { title: BROKEN, text: broken.full_text });
                }
                self.follow_selection()
            }
            Message::Solved { ticket, path, result } => {
                self.solved(ticket, &path, result);
                Vec::new()
            }
            Message::Opened { path, result } => self.opened(path, result),
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
            Message::Listed(Ok(paths)) => {
                self.notice = None;
                self.library.replace(paths);
                let mut effects = self.follow_selection();
                effects.extend(self.fill());
                effects
            }
            Message::Listed(Err(error)) => {
                self.notice = Some(error);
                Vec::new()
            }
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
                Ok(Solved { summary, traces: Some(traces) }) => {
                    self.finish(Outcome::Solved {
                        summary: Box::new(summary),
                        picture: Box::new(Picture::new(*traces)),
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
        if let Some(action) = keymap::action(self.mode, event) {
            return match self.act_in_editor(action) {
                Some(effects) => effects,
                None => self.act(action),
            };
        }
        match event.code {
            KeyCode::Char(letter) if !event.modifiers.intersects(KeyModifiers::CONTROL | KeyModifiers::ALT) => {
                match self.mode {
                    Mode::Filter => self.edit_filter(|filter| filter.push(letter)),
                    _ => self.type_in_editor(letter),
                }
            }
            _ => Vec::new(),
        }
    }

    /// Text from the clipboard is text and never keys: a `q` in it does not quit.
    fn paste(&mut self, text: &str) -> Vec<Effect> {
        if self.mode != Mode::Filter {
            return if Mode::TYPING.contains(&self.mode) { self.paste_in_editor(text) } else { Vec::new() };
        }
        let line: String = text.chars().take_while(|letter| !letter.is_control()).collect();
        self.edit_filter(|filter| filter.push_str(&line))
    }

    fn edit_filter(&mut self, edit: impl FnOnce(&mut String)) -> Vec<Effect> {
        let mut filter = self.library.filter().to_owned();
        edit(&mut filter);
        self.library.set_filter(filter);
        self.follow_selection()
    }

    fn act(&mut self, action: Action) -> Vec<Effect> {
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
            Action::Filter => {
                self.mode = Mode::Filter;
                Vec::new()
            }
            Action::KeepFilter => {
                self.mode = Mode::Library;
                Vec::new()
            }
            Action::NextMatch => self.next_match(1),
            Action::PreviousMatch => self.next_match(-1),
            Action::DeleteCharacter => self.edit_filter(|filter| filter.truncate(filter.len() - last_letter(filter))),
            Action::ClearText => self.edit_filter(String::clear),
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
            Action::Help => {
                self.mode_below_help = self.mode;
                self.mode = Mode::Help;
                self.help_scroll.top = 0;
                Vec::new()
            }
            Action::Quit => self.quit(),
            Action::OpenEditor => self.open_editor(),
            Action::SaveAll => self.save_all(),
            Action::DiscardAll => vec![Effect::Quit(Ending::Quit)],
            // the rest is the editor's
            _ => Vec::new(),
        }
    }

    fn page(&self) -> isize {
        match self.mode {
            Mode::Library | Mode::Filter => self.library.page(),
            Mode::Text => self.detail.text_scroll.page(),
            Mode::Help => self.help_scroll.page(),
            _ => 0,
        }
    }

    fn move_by(&mut self, by: isize) -> Vec<Effect> {
        match self.mode {
            Mode::Library | Mode::Filter => {
                self.library.move_by(by);
                return self.follow_selection();
            }
            Mode::Text => self.detail.text_scroll.by(by),
            Mode::Help => self.help_scroll.by(by),
            _ => {}
        }
        Vec::new()
    }

    fn next_match(&mut self, by: isize) -> Vec<Effect> {
        if self.library.filter().is_empty() {
            return Vec::new();
        }
        self.library.cycle(by);
        self.follow_selection()
    }

    fn back(&mut self) -> Vec<Effect> {
        match self.mode {
            Mode::Help => {
                // the text may have gone while the help lay over it
                let gone = self.mode_below_help == Mode::Text && !self.has_text();
                self.mode = if gone { Mode::Library } else { self.mode_below_help };
                self.follow_editor();
            }
            Mode::Leave => self.stay(),
            Mode::Text => self.mode = Mode::Library,
            Mode::Filter | Mode::Library => {
                self.mode = Mode::Library;
                return self.edit_filter(String::clear);
            }
            _ => {}
        }
        Vec::new()
    }
}

/// Bytes of the last letter.
fn last_letter(text: &str) -> usize {
    text.chars().next_back().map_or(0, char::len_utf8)
}
