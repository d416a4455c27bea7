//! What earlier runs have left: taken, put aside, or offered again.

use std::path::Path;

use super::Kept;
use crate::design::library::{Left, LeftEdits, OnDisk};
use crate::design::{Changes, Edit, EditName};
use crate::text::printable;
use crate::tui::app::{App, Scroll};
use crate::tui::editor::{Editing, Form, Layer};
use crate::tui::file_jobs::FileJob;
use crate::tui::keymap::Mode;
use crate::tui::library::Row;
use crate::tui::message::Effect;

/// The edits of one design.
#[derive(Debug, Clone, PartialEq)]
pub struct Offer {
    pub left: LeftEdits,
    /// The file's name without `.toml`, safe to show
    pub stem: String,
    /// What the edits were
    pub mine: Changes,
    /// What became of the file since they began; nothing where it is as it was
    pub theirs: Option<Theirs>,
}

/// What became of a file.
#[derive(Debug, Clone, PartialEq)]
pub enum Theirs {
    Changed(Changes),
    Gone,
    /// Why it cannot be read
    Unreadable(String),
}

impl Theirs {
    /// Of a file that held `base`; nothing where it still does.
    pub fn since(base: &str, on_disk: &OnDisk) -> Option<Self> {
        match on_disk {
            OnDisk::Text(text) if text == base => None,
            OnDisk::Text(text) => Some(Self::Changed(Changes::between(base, text))),
            OnDisk::Gone => Some(Self::Gone),
            OnDisk::Unreadable(reason) => Some(Self::Unreadable(reason.clone())),
        }
    }
}

/// All offers, one of them in sight.
#[derive(Debug, Default)]
pub struct Offers {
    pub all: Vec<Offer>,
    pub at: usize,
    pub scroll: Scroll,
}

impl Offers {
    pub fn present(&self) -> Option<&Offer> {
        self.all.get(self.at)
    }
}

impl Offer {
    pub fn new(left: LeftEdits) -> Self {
        let stem = Row::new(left.path.clone()).stem;
        let mine = Changes::between(&left.base, &left.text);
        let theirs = Theirs::since(&left.base, &left.on_disk);
        Self { left, stem, mine, theirs }
    }
}

impl App {
    /// Looks for what earlier runs have left, because the user wants to know.
    pub(super) fn ask_for_offers(&mut self) -> Vec<Effect> {
        self.recovery.asked = true;
        vec![Effect::File(FileJob::Left)]
    }

    pub(super) fn take_in_left(&mut self, left: Left) {
        let asked = std::mem::take(&mut self.recovery.asked);
        if self.mode == Mode::Recovery {
            return;
        }
        self.recovery.offers = Offers { all: left.edits.into_iter().map(Offer::new).collect(), ..Offers::default() };
        let elsewhere = left.elsewhere.len();
        if !left.damaged.is_empty() {
            let count = left.damaged.len();
            let journals = if count == 1 { "a recovery journal" } else { "recovery journals" };
            self.complain_at_length(format!("{journals} cannot be used: :messages says why"), left.damaged.join("\n"));
        } else if elsewhere > 0 {
            let designs = if elsewhere == 1 { "a design" } else { "designs" };
            let paths: Vec<String> =
                left.elsewhere.iter().map(|path| printable(&path.display().to_string()).into_owned()).collect();
            let full = format!(
                "There are unsaved edits of {designs} outside this library; open bevelscope on it to have them back:\n{}",
                paths.join("\n")
            );
            self.say_at_length(
                format!(
                    "unsaved edits of {elsewhere} {designs} elsewhere: :messages says of which",
                    designs = if elsewhere == 1 { "design" } else { "designs" }
                ),
                full,
            );
        }
        let count = self.recovery.offers.all.len();
        if count == 0 {
            if asked && elsewhere == 0 && left.damaged.is_empty() {
                self.say("no unsaved edits of an earlier run");
            }
            return;
        }
        // keys that are being typed must not answer a question that comes up under them
        let is_free = matches!(self.mode, Mode::Library | Mode::Text) && self.editors.opening.is_none();
        if asked || is_free {
            self.open(Mode::Recovery);
        } else {
            self.say("there are unsaved edits of an earlier run: :recover shows them");
        }
    }

    pub(super) fn next_offer(&mut self) {
        let offers = &mut self.recovery.offers;
        offers.at = (offers.at + 1) % offers.all.len().max(1);
        offers.scroll = Scroll::default();
    }

    /// Takes the present offer out; the window closes after the last.
    fn answer_offer(&mut self) -> Option<Offer> {
        let offers = &mut self.recovery.offers;
        let offer = (offers.at < offers.all.len()).then(|| offers.all.remove(offers.at))?;
        offers.at = offers.at.min(offers.all.len().saturating_sub(1));
        offers.scroll = Scroll::default();
        if offers.all.is_empty() {
            self.close();
        }
        Some(offer)
    }

    pub(super) fn discard_offer(&mut self) -> Vec<Effect> {
        let Some(offer) = self.answer_offer() else { return Vec::new() };
        self.say(format!("put aside the edits of {}", offer.stem));
        vec![Effect::Keep(Kept::Unwanted { journal: offer.left.journal })]
    }

    /// Opens the tables with the edits as one step over the file as it is now; what is unsaved there already stays below it.
    pub(super) fn take_offer(&mut self, as_variant: bool) -> Vec<Effect> {
        let Some(offer) = self.recovery.offers.present().cloned() else { return Vec::new() };
        let LeftEdits { journal, path, base, text, on_disk, .. } = offer.left;
        let mut editing = match self.take_editing(&path, &base, &on_disk) {
            Ok(editing) => editing,
            Err(error) => {
                self.complain(format!("{}: the edits cannot be shown in tables: {error}", offer.stem));
                return Vec::new();
            }
        };
        let name = EditName::new("recovered edits");
        let applied = editing.apply(&Edit::ReplaceText { text, name });
        if let Err(error) = applied {
            self.editors.put(editing);
            self.complain(format!("{}: {error}", offer.stem));
            return Vec::new();
        }
        editing.layer = None;
        editing.input = None;
        match offer.theirs {
            None => editing.say("recovered edits, not saved yet"),
            Some(Theirs::Changed(_)) => {
                editing.warn("recovered edits over a file that has changed since: look before saving");
            }
            Some(Theirs::Gone) => editing.warn("recovered edits; the file is gone: saving will ask"),
            Some(Theirs::Unreadable(reason)) => editing.warn(format!("recovered edits; of the file: {reason}")),
        }
        if as_variant {
            editing.layer = Some(Layer::Form(Form::new(format!("{}-recovered", file_stem(&path)))));
        }
        self.editors.put(editing);
        self.answer_offer();
        while !self.below.is_empty() {
            self.close();
        }
        self.library.select(&path);
        let mut effects = self.follow_selection();
        let notice = self.notice.take();
        effects.extend(self.show_editor(path.clone()));
        self.notice = notice;
        // first the edits as they are now, then the journal that they came from
        effects.extend(self.protect());
        effects.push(Effect::Keep(Kept::Taken { path, journal }));
        effects
    }

    /// The tables of the file as it is now, or of what the edits began with where it cannot be shown in tables.
    fn take_editing(&mut self, path: &Path, base: &str, on_disk: &OnDisk) -> Result<Editing, String> {
        let is_as_now = |editing: &Editing| matches!(on_disk, OnDisk::Text(text) if text == editing.saved_text());
        let there = self.editors.take(path);
        if let Some(editing) = there.filter(|editing| is_as_now(editing) || editing.is_modified() || editing.is_saving)
        {
            return Ok(editing);
        }
        let new = |text: &str| Editing::new(path.into(), text.to_owned()).map_err(|error| error.to_string());
        match on_disk {
            OnDisk::Text(text) => new(text).or_else(|_| new(base)),
            OnDisk::Gone | OnDisk::Unreadable(_) => new(base),
        }
    }
}

fn file_stem(path: &Path) -> String {
    path.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}
