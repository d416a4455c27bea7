//! The help as lines, and what is searched for in it. All of it is made from the actions and the keys in force.

use super::action::{ACTIONS, About, Action, Category};
use super::app::App;
use super::keymap::{self, Mode};
use super::text_field::TextField;
use super::theme::Theme;
use crate::agreement::TOLERANCE_DB;

/// What is searched for.
#[derive(Debug, Default)]
pub struct HelpSearch {
    pub field: TextField,
    /// Which of the lines found is the present one, counted on without end.
    at: isize,
    /// The present line is to be brought in sight.
    pub(super) follow: bool,
}

impl HelpSearch {
    pub fn is_empty(&self) -> bool {
        self.field.is_empty()
    }

    pub(super) fn cycle(&mut self, by: isize) {
        self.at = self.at.wrapping_add(by);
        self.follow = true;
    }

    /// The place of the present one of `found` lines.
    pub fn place(&self, found: usize) -> Option<usize> {
        (found > 0 && !self.is_empty()).then(|| self.at.rem_euclid(found.cast_signed()).cast_unsigned())
    }
}

/// One line of the help.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum HelpLine {
    Title(&'static str),
    /// Keys or a mark, what it means, and what else finds it.
    Entry {
        keys: String,
        text: String,
        name: &'static str,
    },
}

/// Where letters are keys in a screen and what lies over it, the help itself last.
const EXPLORER: &[Mode] = &[
    Mode::Library,
    Mode::Text,
    Mode::Compare,
    Mode::Spectra,
    Mode::Why,
    Mode::Modes,
    Mode::Bearings,
    Mode::Overview,
    Mode::Pair,
    Mode::MeshImport,
    Mode::Confirm,
    Mode::Leave,
    Mode::Recovery,
    Mode::Conflict,
    Mode::Messages,
    Mode::Help,
];
const EDITOR: &[Mode] = &[
    Mode::Modes,
    Mode::Bearings,
    Mode::Table,
    Mode::Matrix,
    Mode::Choice,
    Mode::Findings,
    Mode::Spectra,
    Mode::Why,
    Mode::Pair,
    Mode::MeshImport,
    Mode::Leave,
    Mode::Recovery,
    Mode::Conflict,
    Mode::Messages,
    Mode::Help,
];
/// Where letters are text.
const TYPED_IN_EXPLORER: &[Mode] = &[
    Mode::Filter,
    Mode::Palette,
    Mode::Name,
    Mode::New,
    Mode::Export,
    Mode::Frequency,
    Mode::Torque,
    Mode::FaceWidth,
    Mode::MeshFile,
    Mode::HelpSearch,
];
const TYPED_IN_EDITOR: &[Mode] = &[
    Mode::Cell,
    Mode::Form,
    Mode::Export,
    Mode::Palette,
    Mode::Frequency,
    Mode::Torque,
    Mode::FaceWidth,
    Mode::MeshFile,
    Mode::HelpSearch,
];

impl App {
    pub(super) fn open_help(&mut self) {
        self.help_scroll.top = 0;
        self.help_search = HelpSearch::default();
        self.open(Mode::Help);
    }

    pub(super) fn open_help_search(&mut self) {
        self.help_search = HelpSearch::default();
        self.open(Mode::HelpSearch);
    }

    pub(super) fn edit_help_search(&mut self, edit: impl FnOnce(&mut TextField)) {
        edit(&mut self.help_search.field);
        self.help_search.at = 0;
        self.help_scroll.top = 0;
    }

    /// The lines that have what is searched for, each section below its title.
    pub fn help_lines(&self) -> Vec<HelpLine> {
        let search = self.help_search.field.text().trim().to_lowercase();
        let found = |line: &HelpLine| match line {
            HelpLine::Title(_) => false,
            HelpLine::Entry { keys, text, name } => {
                search.is_empty()
                    || [keys, text].iter().any(|text| text.to_lowercase().contains(&search))
                    || name.contains(&search)
            }
        };
        let mut lines = Vec::new();
        for (title, entries) in self.help_sections() {
            let entries: Vec<HelpLine> = entries.into_iter().filter(found).collect();
            if entries.is_empty() {
                continue;
            }
            if !lines.is_empty() {
                lines.push(HelpLine::Title(""));
            }
            lines.push(HelpLine::Title(title));
            lines.extend(entries);
        }
        lines
    }

    /// What works where the help was asked for, then what works elsewhere, each mode under its own title.
    fn help_sections(&self) -> Vec<(&'static str, Vec<HelpLine>)> {
        let (keyed, typed) = match self.editors.open() {
            Some(_) => (EDITOR, TYPED_IN_EDITOR),
            None => (EXPLORER, TYPED_IN_EXPLORER),
        };
        let is_help = |mode: &&Mode| matches!(mode, Mode::Help | Mode::HelpSearch);
        let here = self.below.iter().rev().find(|mode| !is_help(mode)).copied().unwrap_or(self.mode);
        let ascii = self.theme.glyphs.ascii;
        let entry = |about: &About, keys: String| HelpLine::Entry { keys, text: about.doc.into(), name: about.name };
        let known: Vec<&About> = ACTIONS.iter().filter(|about| keymap::is_known(here, about.action)).collect();
        let here_in = |category: Option<Category>| {
            let is_in =
                |about: &About| if is_own(here, about) { category.is_none() } else { category == Some(about.category) };
            let entry_here = |about: &About| {
                let (keys, text) = (self.keys_here(about, here), doc_in(here, about).into());
                HelpLine::Entry { keys, text, name: about.name }
            };
            known.iter().filter(|about| is_in(about)).map(|about| entry_here(about)).collect()
        };
        let mut sections: Vec<_> = vec![(here.place(), here_in(None))];
        sections.extend(Category::ALL.into_iter().map(|category| (category.title(), here_in(Some(category)))));
        for &mode in keyed.iter().chain(typed).filter(|mode| **mode != here) {
            let elsewhere = ACTIONS.iter().filter_map(|about| {
                let keys = self.keys.of(mode, about.action, ascii);
                // what is the same everywhere is said once
                let is_new = !keys.is_empty() && keys != self.keys.of(here, about.action, ascii);
                is_new.then(|| entry(about, keys.join(" ")))
            });
            sections.push((mode.place(), elsewhere.collect()));
        }
        sections.push(("Marks", marks(&self.theme)));
        sections
    }

    /// The keys of an action, or how the palette finds it.
    fn keys_here(&self, about: &About, mode: Mode) -> String {
        let keys = self.keys.of(mode, about.action, self.theme.glyphs.ascii);
        if keys.is_empty() { format!(":{}", about.name) } else { keys.join(" ") }
    }
}

/// Whether an action is of this place and at most one more, or means something of its own there.
fn is_own(here: Mode, about: &About) -> bool {
    const FEW: usize = 2;
    let places = Mode::ALL.into_iter().filter(|mode| keymap::is_known(*mode, about.action)).count();
    places <= FEW || doc_in(here, about) != about.doc
}

/// What an action does in a place.
fn doc_in(here: Mode, about: &About) -> &'static str {
    match (here, about.action) {
        (Mode::Spectra, Action::MoveLeft) => "the cursor a column to the left",
        (Mode::Spectra, Action::MoveRight) => "the cursor a column to the right",
        (Mode::Spectra, Action::First) => "the cursor to the lowest frequency",
        (Mode::Spectra, Action::Last) => "the cursor to the highest frequency",
        (Mode::Spectra, Action::MoveUp) => "the band before, or the peak where peaks are listed",
        (Mode::Spectra, Action::MoveDown) => "the next band, or the next peak where peaks are listed",
        (Mode::Spectra, Action::PageUp) => "a window to the left",
        (Mode::Spectra, Action::PageDown) => "a window to the right",
        _ => about.doc,
    }
}

fn marks(theme: &Theme) -> Vec<HelpLine> {
    let glyphs = theme.glyphs;
    let [fe, enhanced, basic] = theme.marker.samples();
    let entry = |mark: &str, text: &str| HelpLine::Entry { keys: mark.into(), text: text.into(), name: "" };
    vec![
        entry(fe, "mesh force of the finite element model"),
        entry(enhanced, "of the enhanced lumped model"),
        entry(basic, "of the basic lumped model"),
        entry(
            &glyphs.band.to_string(),
            &format!("the enhanced model is off by more than {TOLERANCE_DB} dB; in the strip: wide bars"),
        ),
        entry(&glyphs.trust.to_string(), "on the frequency axis: up to here the enhanced model can be trusted"),
        entry(&format!("{} {}", glyphs.bearing, glyphs.rigid_bearing), "a bearing, a rigid bearing"),
        entry(&format!("m {}", glyphs.mesh), "where the mesh acts on the shaft, and the mesh point"),
        entry("E L", "the drives: engine and load"),
        entry(glyphs.broken, "a design that cannot be read or solved"),
        entry("!", "a design with warnings; a cell with a warning"),
        entry("*", "edits that are not saved; beside a value: changed since it was saved"),
        entry("(0.0)", "not written in the file: the default that holds"),
        entry("{0.0}", "in a stiffness matrix: changes with the entry under the cursor"),
        entry("[36.0]", "the cell under the cursor"),
        entry(&glyphs.pointer.to_string(), "in the side view: what the cursor is on"),
        entry(&glyphs.ghost.to_string(), "mesh force of the saved state, finite element model"),
        entry(glyphs.branch.trim(), "a variant of the design above it"),
        entry(glyphs.marked, "the design that others are compared with"),
    ]
}
