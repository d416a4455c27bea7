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
    /// The tables of a design.
    Table,
    /// A cell is being typed into.
    Cell,
    /// The words that a cell may hold.
    Choice,
    /// The stiffness matrix of a bearing.
    Matrix,
    /// The list of findings.
    Findings,
    /// Name and note of a variant are being typed.
    Form,
    /// What to do with edits that are not saved.
    Leave,
}

impl Mode {
    pub const ALL: [Self; 11] = [
        Self::Library,
        Self::Text,
        Self::Filter,
        Self::Help,
        Self::Table,
        Self::Cell,
        Self::Choice,
        Self::Matrix,
        Self::Findings,
        Self::Form,
        Self::Leave,
    ];

    /// Where letters are text.
    pub const TYPING: [Self; 3] = [Self::Filter, Self::Cell, Self::Form];
}

/// One row of the keymap.
#[derive(Debug, Clone, Copy)]
pub struct Binding {
    pub modes: &'static [Mode],
    pub code: KeyCode,
    pub control: bool,
    pub action: Action,
}

const LISTS: &[Mode] = &[Mode::Library, Mode::Text, Mode::Help, Mode::Choice, Mode::Findings];
const ROWS: &[Mode] = &[Mode::Library, Mode::Text, Mode::Help, Mode::Choice, Mode::Findings, Mode::Table, Mode::Matrix];
const ROWS_AND_FILTER: &[Mode] =
    &[Mode::Library, Mode::Text, Mode::Help, Mode::Choice, Mode::Findings, Mode::Table, Mode::Matrix, Mode::Filter];
const CELLS: &[Mode] = &[Mode::Table, Mode::Matrix];
const TABLE: &[Mode] = &[Mode::Table];
const CELL: &[Mode] = &[Mode::Cell];
const FORM: &[Mode] = &[Mode::Form];
const LINES: &[Mode] = &[Mode::Cell, Mode::Form];
const TYPING: &[Mode] = &Mode::TYPING;
const PANES: &[Mode] = &[Mode::Library, Mode::Text];
const FILTER: &[Mode] = &[Mode::Filter];
const BROWSING: &[Mode] = &[Mode::Library, Mode::Text, Mode::Table, Mode::Matrix, Mode::Findings];
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
    key(ROWS_AND_FILTER, KeyCode::Up, Action::MoveUp),
    letter(ROWS, 'k', Action::MoveUp),
    key(ROWS_AND_FILTER, KeyCode::Down, Action::MoveDown),
    letter(ROWS, 'j', Action::MoveDown),
    key(ROWS_AND_FILTER, KeyCode::PageUp, Action::PageUp),
    control(ROWS_AND_FILTER, 'b', Action::PageUp),
    key(ROWS_AND_FILTER, KeyCode::PageDown, Action::PageDown),
    control(ROWS_AND_FILTER, 'f', Action::PageDown),
    key(LISTS, KeyCode::Home, Action::First),
    letter(ROWS, 'g', Action::First),
    key(LISTS, KeyCode::End, Action::Last),
    letter(ROWS, 'G', Action::Last),
    key(CELLS, KeyCode::Left, Action::MoveLeft),
    letter(CELLS, 'h', Action::MoveLeft),
    key(CELLS, KeyCode::Right, Action::MoveRight),
    letter(CELLS, 'l', Action::MoveRight),
    key(CELLS, KeyCode::Home, Action::FirstCell),
    key(CELLS, KeyCode::End, Action::LastCell),
    key(CELLS, KeyCode::Tab, Action::NextCell),
    key(CELLS, KeyCode::BackTab, Action::PreviousCell),
    letter(TABLE, 'p', Action::OtherShaft),
    letter(TABLE, ']', Action::NextTable),
    letter(TABLE, '[', Action::PreviousTable),
    letter(TABLE, '1', Action::Segments),
    letter(TABLE, '2', Action::Bearings),
    letter(TABLE, '3', Action::Bodies),
    letter(TABLE, '4', Action::Mesh),
    letter(TABLE, '5', Action::Drives),
    letter(TABLE, '6', Action::Analysis),
    letter(TABLE, '7', Action::Materials),
    letter(TABLE, '8', Action::Design),
    letter(PANES, 'e', Action::OpenEditor),
    key(PANES, KeyCode::Enter, Action::OpenEditor),
    key(CELLS, KeyCode::Enter, Action::EditCell),
    letter(CELLS, 'c', Action::ReplaceCell),
    letter(TABLE, ' ', Action::CycleCell),
    letter(CELLS, 'x', Action::ClearCell),
    key(CELLS, KeyCode::Delete, Action::ClearCell),
    letter(TABLE, 'a', Action::AddRow),
    letter(TABLE, 'A', Action::InsertRow),
    letter(TABLE, 'Y', Action::DuplicateRow),
    letter(TABLE, 'D', Action::DeleteRow),
    letter(TABLE, 'K', Action::MoveRowUp),
    letter(TABLE, 'J', Action::MoveRowDown),
    letter(CELLS, 'u', Action::Undo),
    control(CELLS, 'r', Action::Redo),
    letter(TABLE, 's', Action::Save),
    letter(TABLE, 'S', Action::SaveVariant),
    key(CELL, KeyCode::Enter, Action::AcceptCell),
    key(CELL, KeyCode::Tab, Action::AcceptNext),
    key(CELL, KeyCode::BackTab, Action::AcceptPrevious),
    key(&[Mode::Choice], KeyCode::Enter, Action::Choose),
    letter(&[Mode::Choice], ' ', Action::Tick),
    key(LINES, KeyCode::Left, Action::TextLeft),
    key(LINES, KeyCode::Right, Action::TextRight),
    key(LINES, KeyCode::Home, Action::TextStart),
    control(LINES, 'a', Action::TextStart),
    key(LINES, KeyCode::End, Action::TextEnd),
    control(LINES, 'e', Action::TextEnd),
    key(LINES, KeyCode::Delete, Action::DeleteForward),
    control(LINES, 'w', Action::DeleteWord),
    key(FORM, KeyCode::Enter, Action::SaveForm),
    key(FORM, KeyCode::Tab, Action::NextField),
    key(FORM, KeyCode::BackTab, Action::NextField),
    key(FORM, KeyCode::Up, Action::NextField),
    key(FORM, KeyCode::Down, Action::NextField),
    letter(&[Mode::Leave], 's', Action::SaveAll),
    letter(&[Mode::Leave], 'd', Action::DiscardAll),
    letter(TABLE, 'f', Action::Findings),
    letter(&[Mode::Findings], 'f', Action::Back),
    key(&[Mode::Findings], KeyCode::Enter, Action::GoToFinding),
    letter(CELLS, '=', Action::Solve),
    key(CELLS, KeyCode::F(5), Action::Solve),
    letter(TABLE, 'L', Action::ToggleLive),
    letter(CELLS, 'X', Action::CancelSolve),
    key(PANES, KeyCode::Tab, Action::NextPane),
    key(PANES, KeyCode::BackTab, Action::NextPane),
    key(&[Mode::Library], KeyCode::Right, Action::NextPane),
    letter(&[Mode::Library], 'l', Action::NextPane),
    letter(PANES, '/', Action::Filter),
    key(FILTER, KeyCode::Enter, Action::KeepFilter),
    letter(PANES, 'n', Action::NextMatch),
    letter(PANES, 'N', Action::PreviousMatch),
    key(TYPING, KeyCode::Backspace, Action::DeleteCharacter),
    control(TYPING, 'h', Action::DeleteCharacter),
    control(TYPING, 'u', Action::ClearText),
    key(ALL, KeyCode::Esc, Action::Back),
    key(&[Mode::Text], KeyCode::Left, Action::Back),
    letter(&[Mode::Text], 'h', Action::Back),
    letter(HELP, 'q', Action::Back),
    letter(HELP, '?', Action::Back),
    letter(PANES, 'R', Action::Reread),
    control(ALL, 'l', Action::Redraw),
    control(ALL, 'z', Action::Suspend),
    letter(BROWSING, '?', Action::Help),
    letter(BROWSING, 'q', Action::Quit),
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
            KeyCode::Char(' ') => "Space".to_owned(),
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
    fn letters_are_text_while_something_is_typed() {
        for (letter, mode) in (' '..='~').flat_map(|letter| Mode::TYPING.map(|mode| (letter, mode))) {
            assert_eq!(action(mode, KeyEvent::from(KeyCode::Char(letter))), None, "{mode:?} {letter}");
        }
    }

    #[test]
    fn escape_never_quits() {
        for mode in Mode::ALL {
            assert_eq!(action(mode, KeyEvent::from(KeyCode::Esc)), Some(Action::Back));
        }
    }
}
