//! What the keys do in the form of a new design.

use std::path::{Path, PathBuf};

use super::{NewDesign, Row};
use crate::design::library::VariantName;
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::files::FileRequest;
use crate::tui::keymap::Mode;
use crate::tui::message::Effect;
use crate::tui::text_field::TextField;

impl App {
    /// Does an action of the form, or opens it; nothing where the action is another's.
    pub(in crate::tui) fn act_in_new(&mut self, action: Action) -> Option<Vec<Effect>> {
        if action == Action::NewDesign {
            self.open_new();
            return Some(Vec::new());
        }
        if self.mode != Mode::New {
            return None;
        }
        let form = &mut self.new_design;
        let is_choice = NewDesign::words(form.row()).is_some();
        match action {
            Action::Back => self.close(),
            // what is being written is waited for
            Action::CreateDesign if form.pending => {}
            _ if form.pending => return None,
            Action::CreateDesign => return Some(self.create_design()),
            Action::TextLeft if is_choice => form.cycle(-1, None),
            Action::TextRight if is_choice => form.cycle(1, None),
            Action::DeleteCharacter | Action::DeleteForward | Action::DeleteWord | Action::ClearText if is_choice => {
                form.clear();
            }
            _ => return None,
        }
        self.name_new();
        Some(Vec::new())
    }

    fn open_new(&mut self) {
        self.new_design.pending = false;
        self.new_design.refresh();
        self.name_new();
        self.open(Mode::New);
    }

    /// Where the new file is to stand: beside the selected design. Nothing where the library is empty.
    fn beside(&self) -> Option<PathBuf> {
        self.library.selected().map(|row| row.path.clone())
    }

    /// Finds a name that is free.
    fn name_new(&mut self) {
        let Some((proposal, _)) = &self.new_design.proposal else { return };
        let stem = proposal.title().to_lowercase().replace(" pair", "").replace([' ', '/'], "-");
        let folder = self.beside().and_then(|path| path.parent().map(Path::to_owned)).unwrap_or_default();
        let is_free = |name: &String| self.library.row(&folder.join(format!("{name}.toml"))).is_none();
        let numbered = (2..1000).map(|number| format!("{stem}-{number}"));
        self.new_design.free_name = std::iter::once(stem.clone()).chain(numbered).find(is_free).unwrap_or(stem);
    }

    pub(in crate::tui) fn edit_new(&mut self, edit: impl FnOnce(&mut TextField)) {
        if !self.new_design.pending {
            self.new_design.edit(edit);
            self.name_new();
        }
    }

    /// Letters: text, or the next word that begins so; a blank goes on to the next word.
    pub(in crate::tui) fn type_in_new(&mut self, text: &str) {
        let form = &mut self.new_design;
        if NewDesign::words(form.row()).is_none() {
            return self.edit_new(|field| field.insert(text));
        }
        if form.pending {
            return;
        }
        match text.chars().next() {
            Some(' ') => form.cycle(1, None),
            letter => form.cycle(0, letter),
        }
        self.name_new();
    }

    pub(in crate::tui) fn move_in_new(&mut self, by: isize) {
        let form = &mut self.new_design;
        form.cursor = form.cursor.saturating_add_signed(by).min(form.rows().len().saturating_sub(1));
    }

    fn create_design(&mut self) -> Vec<Effect> {
        let beside = self.beside();
        let form = &mut self.new_design;
        let typed = form.typed(Row::Name).map_or_else(|| form.free_name.clone(), |name| name.text().trim().to_owned());
        let name = VariantName::new(&typed).map_err(|error| error.to_string()).and_then(|name| {
            let folder = beside.as_deref().and_then(Path::parent).unwrap_or(Path::new(""));
            let is_taken = self.library.row(&name.path_in(folder)).is_some();
            if is_taken { Err("there is a design of that name already".into()) } else { Ok(name) }
        });
        match (name, form.text()) {
            (Ok(name), Some(text)) => {
                form.pending = true;
                return vec![Effect::ChangeFile(FileRequest::Create { beside, name, text })];
            }
            (Err(error), _) => form.refused = Some(error),
            (Ok(_), None) => {}
        }
        form.cursor = form.first_error().unwrap_or(form.cursor);
        Vec::new()
    }

    /// The file is there.
    pub(in crate::tui) fn design_created(&mut self) {
        self.new_design.pending = false;
        // the next one has another name
        self.new_design.name = TextField::default();
        if self.mode == Mode::New {
            self.close();
        }
    }

    /// The file is not there; where the form was left meanwhile, the message says so alone.
    pub(in crate::tui) fn design_refused(&mut self, error: &str) {
        self.new_design.pending = false;
        self.new_design.refused = Some(error.to_owned());
        self.new_design.cursor = 0;
    }
}
