//! Renaming, copying, deleting and bringing back design files: asked for here, done in the background.

use std::path::{Path, PathBuf};

use super::action::Action;
use super::app::App;
use super::keymap::Mode;
use super::library::{Library, Row};
use super::message::Effect;
use super::text_field::TextField;
use crate::design::library::{NameError, Trashed, VariantName};

/// Something to be done with a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FileRequest {
    Rename {
        path: PathBuf,
        name: VariantName,
    },
    Duplicate {
        path: PathBuf,
        name: VariantName,
    },
    /// A new design, beside that one or in the first folder of the library.
    Create {
        beside: Option<PathBuf>,
        name: VariantName,
        text: String,
    },
    /// To the trash of its folder.
    Delete {
        path: PathBuf,
    },
    /// This one, or whatever was deleted last from the library.
    Restore(Option<Trashed>),
}

/// A file is where it was asked to be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FileDone {
    /// Those that named the old one as their parent name the new one now.
    Renamed {
        from: PathBuf,
        to: PathBuf,
        variants: Vec<Followed>,
    },
    Duplicated {
        from: PathBuf,
        to: PathBuf,
    },
    Created {
        path: PathBuf,
    },
    Deleted {
        path: PathBuf,
        trashed: Trashed,
    },
    Restored {
        path: PathBuf,
    },
}

/// A variant of a design that was renamed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Followed {
    pub path: PathBuf,
    /// Its text now, or why it still names the old parent.
    pub result: Result<String, String>,
}

/// What the form asks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    Rename,
    Duplicate,
}

/// A name that is being typed.
#[derive(Debug)]
pub struct Form {
    pub purpose: Purpose,
    pub path: PathBuf,
    pub field: TextField,
    /// What the file system had against the name.
    pub refused: Option<String>,
    /// It is being done.
    pub pending: bool,
    /// Something was typed or asked for: from then on it is said what is wrong.
    pub is_touched: bool,
}

/// Why a design cannot have the name.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NotFree {
    #[error(transparent)]
    Name(#[from] NameError),
    #[error("this is its name now")]
    Same,
    #[error("there is a design of that name already")]
    Taken,
    /// By the file system, in its words
    #[error("{0}")]
    Refused(String),
}

impl App {
    pub(super) fn open_form(&mut self, purpose: Purpose) {
        let Some(row) = self.library.selected() else { return };
        if purpose == Purpose::Rename && row.unsaved {
            let stem = row.stem.clone();
            return self.complain(format!("{stem} has edits that are not saved: save them first"));
        }
        let stem = row.path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let name = match purpose {
            Purpose::Rename => stem,
            Purpose::Duplicate => self.free_name(&row.path, &stem),
        };
        let path = row.path.clone();
        self.form = Some(Form {
            purpose,
            path,
            field: TextField::proposed(name),
            refused: None,
            pending: false,
            is_touched: false,
        });
        self.open(Mode::Name);
    }

    /// `STEM-2`, or the next number that is free.
    fn free_name(&self, path: &Path, stem: &str) -> String {
        let is_free = |name: &String| self.library.row(&path.with_file_name(format!("{name}.toml"))).is_none();
        let numbered = (2..1000).map(|number| format!("{stem}-{number}"));
        numbered.into_iter().find(is_free).unwrap_or_default()
    }

    pub(super) fn accept_form(&mut self) -> Vec<Effect> {
        let Some(form) = self.form.as_mut().filter(|form| !form.pending) else { return Vec::new() };
        form.is_touched = true;
        // what is wrong stands beside the name already
        let Ok(request) = form.checked(&self.library) else { return Vec::new() };
        // a variant that is being written could not follow
        if self.editors.is_saving() {
            form.refused = Some("a design is being saved: try again in a moment".into());
            return Vec::new();
        }
        form.pending = true;
        vec![Effect::ChangeFile(request)]
    }

    pub(super) fn edit_form(&mut self, edit: impl FnOnce(&mut TextField)) {
        if let Some(form) = self.form.as_mut().filter(|form| !form.pending) {
            let before = form.field.text().to_owned();
            edit(&mut form.field);
            form.is_touched |= form.field.text() != before;
            form.refused = None;
        }
    }

    pub(super) fn ask_to_delete(&mut self) {
        if let Some(row) = self.library.selected() {
            if row.unsaved {
                let stem = row.stem.clone();
                return self.complain(format!("{stem} has edits that are not saved: save them first"));
            }
            self.to_delete = Some(row.path.clone());
            self.open(Mode::Confirm);
        }
    }

    pub(super) fn delete_confirmed(&mut self) -> Vec<Effect> {
        self.close();
        self.to_delete.take().map(|path| Effect::ChangeFile(FileRequest::Delete { path })).into_iter().collect()
    }

    pub(super) fn restore_deleted(&mut self) -> Vec<Effect> {
        vec![Effect::ChangeFile(FileRequest::Restore(self.deleted.pop()))]
    }

    /// Takes in what became of a request.
    pub(super) fn file_done(&mut self, request: FileRequest, result: Result<FileDone, String>) -> Vec<Effect> {
        let from_form = self.form.as_ref().is_some_and(|form| form.pending && form.asked(&request));
        match result {
            Ok(done) => {
                if from_form {
                    self.close_form();
                }
                self.take_over(done);
                let mut effects = self.follow_selection();
                effects.push(Effect::List);
                effects
            }
            Err(error) => {
                match request {
                    // it is still there to be brought back
                    FileRequest::Restore(Some(trashed)) => self.deleted.push(trashed),
                    FileRequest::Create { .. } => self.design_refused(&error),
                    _ => {}
                }
                if let Some(form) = self.form.as_mut().filter(|_| from_form) {
                    form.pending = false;
                    form.refused = Some(error.clone());
                }
                self.complain(error);
                Vec::new()
            }
        }
    }

    fn take_over(&mut self, done: FileDone) {
        let stem = |path: &Path| Row::new(path.into()).stem;
        match done {
            FileDone::Renamed { from, to, variants } => {
                let (followed, failed): (Vec<_>, Vec<_>) = variants.into_iter().partition(|one| one.result.is_ok());
                let variants = match followed.len() {
                    0 => String::new(),
                    1 => "; 1 variant follows".into(),
                    more => format!("; {more} variants follow"),
                };
                self.say(format!("renamed {} to {}{variants}", stem(&from), stem(&to)));
                self.editors.forget(&from);
                self.editors.follow_parent(&from, &to, &followed);
                for Followed { path, .. } in &followed {
                    if let Some(row) = self.library.row_mut(path) {
                        row.stale = true;
                    }
                }
                for Followed { path, result } in failed {
                    let error = result.err().unwrap_or_default();
                    self.complain(format!("{} still names {} as its parent: {error}", stem(&path), stem(&from)));
                }
                self.library.moved(&from, &to);
                self.library.want(to);
            }
            FileDone::Duplicated { from, to } => {
                let without = match self.editors.unsaved_text(&from) {
                    Some(_) => ", without the edits that are not saved",
                    None => "",
                };
                self.say(format!("copied {} to {}{without}", stem(&from), stem(&to)));
                self.library.want(to);
            }
            FileDone::Deleted { path, trashed } => {
                let key = self.keys.names(Mode::Library, true).of(Action::RestoreDeleted);
                self.say(format!("deleted {}; {key} brings it back", stem(&path)));
                self.editors.forget(&path);
                self.deleted.push(trashed);
            }
            FileDone::Created { path } => {
                self.say(format!("made {}", stem(&path)));
                self.design_created();
                self.library.want(path);
            }
            FileDone::Restored { path } => {
                self.say(format!("{} is back", stem(&path)));
                self.library.want(path);
            }
        }
    }

    fn close_form(&mut self) {
        self.form = None;
        if self.mode == Mode::Name {
            self.close();
        }
    }
}

impl Form {
    /// What the form would do.
    ///
    /// # Errors
    ///
    /// [`NotFree`] says what is wrong with the name.
    pub fn checked(&self, library: &Library) -> Result<FileRequest, NotFree> {
        if let Some(refused) = &self.refused {
            return Err(NotFree::Refused(refused.clone()));
        }
        let name = VariantName::new(self.field.text().trim())?;
        let target = name.path_in(self.path.parent().unwrap_or(Path::new("")));
        if target == self.path {
            return Err(NotFree::Same);
        }
        if library.row(&target).is_some() {
            return Err(NotFree::Taken);
        }
        let path = self.path.clone();
        Ok(match self.purpose {
            Purpose::Rename => FileRequest::Rename { path, name },
            Purpose::Duplicate => FileRequest::Duplicate { path, name },
        })
    }

    fn asked(&self, request: &FileRequest) -> bool {
        match (self.purpose, request) {
            (Purpose::Rename, FileRequest::Rename { path, .. })
            | (Purpose::Duplicate, FileRequest::Duplicate { path, .. }) => *path == self.path,
            _ => false,
        }
    }
}
