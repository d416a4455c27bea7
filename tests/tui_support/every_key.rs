//! Keys that a screen's help names and that do nothing there.

use bevelscope::tui::keymap::{BINDINGS, Binding, Mode};
use bevelscope::tui::message::Message;
use ratatui::crossterm::event::{KeyEvent, KeyModifiers};

use super::Screen;

/// The bindings of a mode that change neither the picture nor ask for anything, whatever keys were pressed before.
pub fn dead_keys(mode: Mode, open: impl Fn() -> Screen, before: &[&str]) -> Vec<&'static Binding> {
    let does = |binding: &Binding, keys: &str| {
        let mut screen = open();
        screen.keys(keys);
        let before = (screen.text(), screen.effects.len());
        let held = if binding.control { KeyModifiers::CONTROL } else { KeyModifiers::NONE };
        screen.send(Message::Key(KeyEvent::new(binding.code, held)));
        (screen.text(), screen.effects.len()) != before
    };
    let of_mode = BINDINGS.iter().filter(|binding| binding.modes.contains(&mode));
    of_mode.filter(|binding| !before.iter().any(|keys| does(binding, keys))).collect()
}
