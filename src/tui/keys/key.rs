//! One key, as it is pressed and as people write it.

use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// A key with what is held down beside it. Shift is part of a letter: `G`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Key {
    code: KeyCode,
    control: bool,
    alt: bool,
    /// Never of a letter.
    shift: bool,
}

/// Why a text names no key.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum KeyError {
    #[error("a key is wanted, such as ctrl-s, alt-x, f5, shift-tab, space or G")]
    Empty,
    #[error("there is no key of this name; keys are written like ctrl-s, alt-x, f5, shift-tab, space, G")]
    Unknown,
    #[error("a terminal sends {0} for it: bind that one")]
    SentAs(&'static str),
    #[error("a terminal does not send this key")]
    NotSent,
}

/// Names of keys: as they are shown, and as they may be written as well (in small letters).
const NAMES: &[(KeyCode, &str, &[&str])] = &[
    (KeyCode::Up, "Up", &[]),
    (KeyCode::Down, "Down", &[]),
    (KeyCode::Left, "Left", &[]),
    (KeyCode::Right, "Right", &[]),
    (KeyCode::Home, "Home", &[]),
    (KeyCode::End, "End", &[]),
    (KeyCode::PageUp, "PgUp", &["pageup", "page-up"]),
    (KeyCode::PageDown, "PgDn", &["pagedown", "page-down", "pgdown"]),
    (KeyCode::Enter, "Enter", &["return"]),
    (KeyCode::Esc, "Esc", &["escape"]),
    (KeyCode::Tab, "Tab", &[]),
    (KeyCode::BackTab, "Shift-Tab", &["backtab"]),
    (KeyCode::Backspace, "Backspace", &["bs"]),
    (KeyCode::Delete, "Delete", &["del"]),
    (KeyCode::Insert, "Insert", &["ins"]),
    (KeyCode::Char(' '), "Space", &[]),
    (KeyCode::Char('-'), "-", &["minus"]),
    (KeyCode::Char('+'), "+", &["plus"]),
];

const ARROWS: [(KeyCode, &str); 4] =
    [(KeyCode::Up, "↑"), (KeyCode::Down, "↓"), (KeyCode::Left, "←"), (KeyCode::Right, "→")];

impl Key {
    /// A key by itself or with Ctrl.
    pub fn new(code: KeyCode, control: bool) -> Self {
        Self { code, control, alt: false, shift: false }
    }

    /// Reads a key as people write it: `ctrl-s`, `Alt-x`, `f5`, `shift-tab`, `space`, `G`.
    ///
    /// # Errors
    ///
    /// [`KeyError`], also for what no terminal sends.
    pub fn parse(text: &str) -> Result<Self, KeyError> {
        let mut key = Self::new(KeyCode::Null, false);
        let mut rest = text.trim_matches(|letter: char| letter.is_whitespace() && text.chars().count() > 1);
        if rest.is_empty() {
            return Err(KeyError::Empty);
        }
        loop {
            if let Some(after) = without(rest, &["ctrl", "control", "c"]) {
                (key.control, rest) = (true, after);
            } else if let Some(after) = without(rest, &["alt", "meta", "a", "m"]) {
                (key.alt, rest) = (true, after);
            } else if let Some(after) = without(rest, &["shift", "s"]) {
                (key.shift, rest) = (true, after);
            } else {
                break;
            }
        }
        key.code = code(rest).ok_or(KeyError::Unknown)?;
        key.as_sent()
    }

    /// The key as a terminal sends it.
    fn as_sent(mut self) -> Result<Self, KeyError> {
        if self.shift {
            match self.code {
                KeyCode::Tab => (self.code, self.shift) = (KeyCode::BackTab, false),
                KeyCode::Char(letter) if letter.is_alphabetic() && !self.control => {
                    self.shift = false;
                    self.code = KeyCode::Char(letter.to_uppercase().next().unwrap_or(letter));
                }
                KeyCode::Char(_) | KeyCode::Enter | KeyCode::Esc | KeyCode::Backspace => return Err(KeyError::NotSent),
                _ => {}
            }
        }
        if self.control {
            self.code = match self.code {
                KeyCode::Char('i' | 'I') | KeyCode::Tab => return Err(KeyError::SentAs("Tab")),
                KeyCode::Char('m' | 'M') | KeyCode::Enter => return Err(KeyError::SentAs("Enter")),
                KeyCode::Char('[') | KeyCode::Esc => return Err(KeyError::SentAs("Esc")),
                KeyCode::Backspace => return Err(KeyError::SentAs("ctrl-h")),
                KeyCode::Char('\\') => KeyCode::Char('4'),
                KeyCode::Char(']') => KeyCode::Char('5'),
                KeyCode::Char('^') => KeyCode::Char('6'),
                KeyCode::Char('_' | '/') => KeyCode::Char('7'),
                KeyCode::Char(letter) if letter.is_ascii_alphabetic() => KeyCode::Char(letter.to_ascii_lowercase()),
                KeyCode::Char(' ' | '4'..='7') => self.code,
                KeyCode::Char(_) | KeyCode::BackTab => return Err(KeyError::NotSent),
                code => code,
            };
        }
        Ok(self)
    }

    /// Whether it is text where text is typed.
    pub fn is_text(self) -> bool {
        matches!(self.code, KeyCode::Char(_)) && !self.control && !self.alt
    }

    /// As it is without Shift: what is not bound with it means the same without.
    #[must_use]
    pub fn without_shift(self) -> Self {
        Self { shift: false, ..self }
    }

    /// The key's name, e.g. `Ctrl-c`. [`Self::parse`] reads it.
    pub fn shown(self, ascii: bool) -> String {
        let arrow = ARROWS.iter().find(|(code, _)| *code == self.code && !ascii).map(|(_, arrow)| *arrow);
        let name = arrow.or_else(|| NAMES.iter().find(|(code, ..)| *code == self.code).map(|(_, name, _)| *name));
        let name = match (name, self.code) {
            (Some(name), _) => name.to_owned(),
            (None, KeyCode::Char(letter)) => letter.to_string(),
            (None, KeyCode::F(number)) => format!("F{number}"),
            (None, code) => format!("{code:?}"),
        };
        let held = |held: bool, name: &'static str| if held { name } else { "" };
        format!("{}{}{}{name}", held(self.control, "Ctrl-"), held(self.alt, "Alt-"), held(self.shift, "Shift-"))
    }
}

impl From<KeyEvent> for Key {
    fn from(event: KeyEvent) -> Self {
        let held = |modifier| event.modifiers.contains(modifier);
        let (control, alt, shift) = (held(KeyModifiers::CONTROL), held(KeyModifiers::ALT), held(KeyModifiers::SHIFT));
        let (code, shift) = match event.code {
            KeyCode::Tab if shift => (KeyCode::BackTab, false),
            KeyCode::Char(letter) if control => (KeyCode::Char(letter.to_ascii_lowercase()), false),
            KeyCode::Char(_) | KeyCode::BackTab => (event.code, false),
            code => (code, shift),
        };
        Self { code, control, alt, shift }
    }
}

/// What follows the name of a key that is held down.
fn without<'a>(text: &'a str, names: &[&str]) -> Option<&'a str> {
    names.iter().find_map(|name| {
        let (start, rest) = text.split_at_checked(name.len())?;
        let rest = rest.strip_prefix(['-', '+'])?;
        (start.eq_ignore_ascii_case(name) && !rest.is_empty()).then_some(rest)
    })
}

fn code(name: &str) -> Option<KeyCode> {
    let mut letters = name.chars();
    if let (Some(letter), None) = (letters.next(), letters.next()) {
        return (!letter.is_control()).then_some(KeyCode::Char(letter));
    }
    let name = name.to_ascii_lowercase();
    if let Some(number) = name.strip_prefix('f').and_then(|number| number.parse::<u8>().ok()) {
        return (1..=24).contains(&number).then_some(KeyCode::F(number));
    }
    let named = NAMES.iter().find(|(_, shown, others)| shown.eq_ignore_ascii_case(&name) || others.contains(&&*name));
    named.map(|(code, ..)| *code)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_read_as_people_write_them() {
        for (written, shown) in [
            ("ctrl-s", "Ctrl-s"),
            ("Ctrl+S", "Ctrl-s"),
            ("C-s", "Ctrl-s"),
            ("alt-x", "Alt-x"),
            ("ctrl-alt-x", "Ctrl-Alt-x"),
            ("f5", "F5"),
            ("shift-f5", "Shift-F5"),
            ("shift-tab", "Shift-Tab"),
            ("space", "Space"),
            (" ", "Space"),
            ("G", "G"),
            ("shift-g", "G"),
            ("-", "-"),
            ("ctrl-/", "Ctrl-7"),
            ("pageup", "PgUp"),
            ("escape", "Esc"),
            ("ü", "ü"),
        ] {
            assert_eq!(Key::parse(written).map(|key| key.shown(true)).as_deref(), Ok(shown), "{written}");
        }
    }

    #[test]
    fn what_no_terminal_sends_is_refused() {
        for (written, error) in [
            ("", KeyError::Empty),
            ("ctrl-i", KeyError::SentAs("Tab")),
            ("ctrl-m", KeyError::SentAs("Enter")),
            ("ctrl-[", KeyError::SentAs("Esc")),
            ("ctrl-1", KeyError::NotSent),
            ("shift-enter", KeyError::NotSent),
            ("f99", KeyError::Unknown),
            ("hyper-x", KeyError::Unknown),
            ("ctrl-", KeyError::Unknown),
            ("\u{1b}", KeyError::Unknown),
        ] {
            assert_eq!(Key::parse(written), Err(error), "{written:?}");
        }
    }

    #[test]
    fn events_are_the_keys_that_are_written() {
        let event = |code, modifiers| Key::from(KeyEvent::new(code, modifiers));
        for (key, written) in [
            (event(KeyCode::Char('G'), KeyModifiers::SHIFT), "G"),
            (event(KeyCode::Char('s'), KeyModifiers::CONTROL), "ctrl-s"),
            (event(KeyCode::BackTab, KeyModifiers::SHIFT), "shift-tab"),
            (event(KeyCode::Up, KeyModifiers::SHIFT), "shift-up"),
            (event(KeyCode::Char('x'), KeyModifiers::ALT), "alt-x"),
        ] {
            assert_eq!(Key::parse(written), Ok(key), "{written}");
        }
    }
}
