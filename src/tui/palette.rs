//! The command palette: an action by its name.

use super::action::{ACTIONS, About, Action, Category};
use super::app::App;
use super::fuzzy;
use super::keymap::{self, Mode};
use super::message::Effect;
use super::text_field::TextField;

/// What is typed, and which of the actions found is chosen.
#[derive(Debug, Default)]
pub struct Palette {
    pub typed: TextField,
    /// Place among those found.
    pub cursor: usize,
    /// First one in sight, and how many are: known when it is drawn.
    pub top: usize,
    pub height: usize,
}

/// One action with its keys.
#[derive(Debug)]
pub struct Entry {
    pub about: &'static About,
    pub keys: String,
}

impl Palette {
    /// Keeps the chosen one in sight.
    pub fn fit(&mut self, found: usize, height: usize) {
        self.height = height;
        self.cursor = self.cursor.min(found.saturating_sub(1));
        let lowest = (self.cursor + 1).saturating_sub(height);
        self.top = self.top.clamp(lowest, self.cursor.max(lowest)).min(found.saturating_sub(height).max(lowest));
    }
}

/// What the palette does itself, and not by its name.
const OWN: [Action; 1] = [Action::Palette];

impl App {
    pub(super) fn open_palette(&mut self) {
        self.palette = Palette::default();
        self.open(Mode::Palette);
    }

    /// The mode that a chosen action is for.
    fn commanded(&self) -> Mode {
        self.below.last().copied().unwrap_or(Mode::Library)
    }

    /// The actions of the mode below that have the letters typed, the best first.
    pub fn palette_entries(&self) -> Vec<Entry> {
        let mode = self.commanded();
        let typed = self.palette.typed.text();
        let mut found: Vec<(i32, &'static About)> = ACTIONS
            .iter()
            .filter(|about| keymap::is_known(mode, about.action) && !OWN.contains(&about.action))
            .filter_map(|about| {
                // the name counts most
                let name = fuzzy::score(typed, about.name).map(|score| score * 4);
                let doc = if typed.trim().len() > 2 { fuzzy::score(typed, about.doc) } else { None };
                name.max(doc).map(|score| (score, about))
            })
            .collect();
        // what keys are for anyway comes last
        found.sort_by_key(|(score, about)| (-score, about.category == Category::Move));
        let entry = |(_, about): (i32, &'static About)| Entry {
            about,
            keys: self.keys.of(mode, about.action, self.theme.glyphs.ascii).join(" "),
        };
        found.into_iter().map(entry).collect()
    }

    pub(super) fn run_chosen(&mut self) -> Vec<Effect> {
        let chosen = self.palette_entries().get(self.palette.cursor).map(|entry| entry.about.action);
        // with nothing found there is nothing to run, and what was typed can be mended
        let Some(action) = chosen else { return Vec::new() };
        self.close();
        self.run(action)
    }

    pub(super) fn edit_palette(&mut self, edit: impl FnOnce(&mut TextField)) {
        edit(&mut self.palette.typed);
        self.palette.cursor = 0;
    }

    pub(super) fn move_in_palette(&mut self, by: isize) {
        let last = self.palette_entries().len().saturating_sub(1);
        self.palette.cursor = self.palette.cursor.saturating_add_signed(by).min(last);
    }
}
