//! The keys as they are in force: those of the program with those of the user's file.
//!
//! ```text
//! keymap::BINDINGS ─┐
//!                   ├─> Keys ──> what a key does, help, footer, palette, `bevelscope keys`
//! keys.toml ────────┘
//! ```

mod file;
mod key;

use ratatui::crossterm::event::KeyEvent;

pub use file::{Remapped, read};
pub use key::{Key, KeyError};

use super::action::Action;
use super::keymap::{BINDINGS, Mode};

/// Which key does what in which mode.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Keys {
    /// The first key of an action is the one that the hints show.
    bound: Vec<Bound>,
}

/// One key in one mode.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bound {
    pub mode: Mode,
    pub key: Key,
    pub action: Action,
}

impl Default for Keys {
    fn default() -> Self {
        let bound = |(binding, mode): (&super::keymap::Binding, &Mode)| Bound {
            mode: *mode,
            key: Key::new(binding.code, binding.control),
            action: binding.action,
        };
        let bindings = BINDINGS.iter().flat_map(|binding| binding.modes.iter().map(move |mode| (binding, mode)));
        Self { bound: bindings.map(bound).collect() }
    }
}

impl Keys {
    /// What a key does in a mode, if anything.
    pub fn action(&self, mode: Mode, event: KeyEvent) -> Option<Action> {
        let key = Key::from(event);
        let find = |key| self.bound.iter().find(|bound| bound.mode == mode && bound.key == key);
        find(key).or_else(|| find(key.without_shift())).map(|bound| bound.action)
    }

    /// The keys of an action in a mode, as they are shown.
    pub fn of(&self, mode: Mode, action: Action, ascii: bool) -> Vec<String> {
        let bound = self.bound.iter().filter(|bound| bound.mode == mode && bound.action == action);
        bound.map(|bound| bound.key.shown(ascii)).collect()
    }

    /// The names of the keys in a mode, for texts.
    pub fn names(&self, mode: Mode, ascii: bool) -> KeyNames<'_> {
        KeyNames { keys: self, mode, ascii }
    }

    /// All keys.
    pub fn bound(&self) -> &[Bound] {
        &self.bound
    }
}

/// What texts call the keys of a mode.
#[derive(Debug, Clone, Copy)]
pub struct KeyNames<'a> {
    keys: &'a Keys,
    mode: Mode,
    ascii: bool,
}

impl KeyNames<'_> {
    /// The first key of an action, if it has one.
    pub fn key(&self, action: Action) -> Option<String> {
        self.keys.of(self.mode, action, self.ascii).into_iter().next()
    }

    /// The first key of an action, or how the palette finds it.
    pub fn of(&self, action: Action) -> String {
        self.key(action).unwrap_or_else(|| format!(":{}", action.name()))
    }
}
