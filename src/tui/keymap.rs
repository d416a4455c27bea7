//! Which key does what: data, so that the help and the hints cannot differ from what happens.

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use super::action::Action;

/// Who listens to the keys.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// The list of designs.
    Library,
    /// The error text of a broken design.
    Text,
    /// The filter is being typed.
    Filter,
    Help,
}

impl Mode {
    pub const ALL: [Self; 4] = [Self::Library, Self::Text, Self::Filter, Self::Help];
}

/// One row of the keymap.
#[derive(Debug, Clone, Copy)]
pub struct Binding {
    pub modes: &'static [Mode],
    pub code: KeyCode,
    pub control: bool,
    pub action: Action,
}

const LISTS: &[Mode] = &[Mode::Library, Mode::Text, Mode::Help];
const PANES: &[Mode] = &[Mode::Library, Mode::Text];
const FILTER: &[Mode] = &[Mode::Filter];
const HELP: &[Mode] = &[Mode::Help];
const ALL: &[Mode] = &Mode::ALL;

const fn key(modes: &'static [Mode], code: KeyCode, action: Action) -> Binding {
    Binding { modes, code, control: false, action }
}

const fn letter(modes: &'static [Mode], letter: char, action: Action) -> Binding {
    key(modes, KeyCode::Char(letter), action)
}

const fn control(modes: &'static [Mode], letter: char, action: Action) -> Binding {
    Binding { modes, code: KeyCode::Char(letter), control: true, action }
}

/// The keymap. The first key of an action is the one that the hints show.
pub const BINDINGS: &[Binding] = &[
    key(ALL, KeyCode::Up, Action::MoveUp),
    letter(LISTS, 'k', Action::MoveUp),
    key(ALL, KeyCode::Down, Action::MoveDown),
    letter(LISTS, 'j', Action::MoveDown),
    key(ALL, KeyCode::PageUp, Action::PageUp),
    control(ALL, 'b', Action::PageUp),
    key(ALL, KeyCode::PageDown, Action::PageDown),
    control(ALL, 'f', Action::PageDown),
    key(LISTS, KeyCode::Home, Action::First),
    letter(LISTS, 'g', Action::First),
    key(LISTS, KeyCode::End, Action::Last),
    letter(LISTS, 'G', Action::Last),
    key(PANES, KeyCode::Tab, Action::NextPane),
    key(PANES, KeyCode::BackTab, Action::NextPane),
    key(&[Mode::Library], KeyCode::Right, Action::NextPane),
    letter(&[Mode::Library], 'l', Action::NextPane),
    letter(PANES, '/', Action::Filter),
    key(FILTER, KeyCode::Enter, Action::KeepFilter),
    letter(PANES, 'n', Action::NextMatch),
    letter(PANES, 'N', Action::PreviousMatch),
    key(FILTER, KeyCode::Backspace, Action::DeleteCharacter),
    control(FILTER, 'h', Action::DeleteCharacter),
    control(FILTER, 'u', Action::ClearText),
    key(ALL, KeyCode::Esc, Action::Back),
    key(&[Mode::Text], KeyCode::Left, Action::Back),
    letter(&[Mode::Text], 'h', Action::Back),
    letter(HELP, 'q', Action::Back),
    letter(HELP, '?', Action::Back),
    letter(PANES, 'R', Action::Reread),
    control(ALL, 'l', Action::Redraw),
    control(ALL, 'z', Action::Suspend),
    letter(PANES, '?', Action::Help),
    letter(PANES, 'q', Action::Quit),
    control(ALL, 'c', Action::Quit),
];

/// What a key does in a mode, if anything.
pub fn action(mode: Mode, event: KeyEvent) -> Option<Action> {
    if event.modifiers.contains(KeyModifiers::ALT) {
        return None;
    }
    let control = event.modifiers.contains(KeyModifiers::CONTROL);
    BINDINGS
        .iter()
        .find(|binding| binding.modes.contains(&mode) && binding.code == event.code && binding.control == control)
        .map(|binding| binding.action)
}

/// The keys of an action in a mode, as they are shown.
pub fn keys(mode: Mode, action: Action, ascii: bool) -> Vec<String> {
    BINDINGS
        .iter()
        .filter(|binding| binding.modes.contains(&mode) && binding.action == action)
        .map(|binding| binding.shown(ascii))
        .collect()
}

impl Binding {
    /// The key's name, e.g. `Ctrl-c`.
    pub fn shown(&self, ascii: bool) -> String {
        let name = match self.code {
            KeyCode::Up if ascii => "Up".to_owned(),
            KeyCode::Up => "↑".to_owned(),
            KeyCode::Down if ascii => "Down".to_owned(),
            KeyCode::Down => "↓".to_owned(),
            KeyCode::Right if ascii => "Right".to_owned(),
            KeyCode::Right => "→".to_owned(),
            KeyCode::Left if ascii => "Left".to_owned(),
            KeyCode::Left => "←".to_owned(),
            KeyCode::PageUp => "PgUp".to_owned(),
            KeyCode::PageDown => "PgDn".to_owned(),
            KeyCode::BackTab => "Shift-Tab".to_owned(),
            KeyCode::Char(letter) => letter.to_string(),
            code => format!("{code:?}"),
        };
        if self.control { format!("Ctrl-{name}") } else { name }
    }
}

#[cfg(test)]
mod tests {
    use super::super::action::ACTIONS;
    use super::*;

    #[test]
    fn every_action_is_named_documented_and_has_a_key() {
        for about in ACTIONS {
            assert!(!about.name.is_empty() && !about.doc.is_empty(), "{about:?}");
            assert!(about.name.bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'-'), "{about:?}");
            assert_eq!(ACTIONS.iter().filter(|other| other.name == about.name).count(), 1, "{about:?}");
            let reached = Mode::ALL.iter().any(|&mode| !keys(mode, about.action, false).is_empty());
            assert!(reached, "no key for {}", about.name);
        }
    }

    #[test]
    fn no_key_has_two_meanings_in_a_mode() {
        for mode in Mode::ALL {
            let here: Vec<_> = BINDINGS.iter().filter(|binding| binding.modes.contains(&mode)).collect();
            for (at, binding) in here.iter().enumerate() {
                let twice =
                    here[..at].iter().any(|other| other.code == binding.code && other.control == binding.control);
                assert!(!twice, "{mode:?} {binding:?}");
            }
        }
    }

    #[test]
    fn letters_are_text_while_the_filter_is_typed() {
        for letter in ' '..='~' {
            assert_eq!(action(Mode::Filter, KeyEvent::from(KeyCode::Char(letter))), None, "{letter}");
        }
    }

    #[test]
    fn escape_never_quits() {
        for mode in Mode::ALL {
            assert_eq!(action(mode, KeyEvent::from(KeyCode::Esc)), Some(Action::Back));
        }
    }
}
