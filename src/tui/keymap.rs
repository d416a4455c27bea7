//! Which key does what: data, so that the help and the hints cannot differ from what happens.

use ratatui::crossterm::event::KeyCode;

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
    /// What the help is searched for is being typed.
    HelpSearch,
    /// An action's name is being typed.
    Palette,
    /// A file's name is being typed.
    Name,
    /// A question with yes or no.
    Confirm,
    /// All messages in full.
    Messages,
    /// Two designs beside one another.
    Compare,
    /// The spectra over the whole window.
    Spectra,
    /// Why models disagree in a band.
    Why,
    /// The name of a file to write to is being typed.
    Export,
    /// The natural modes of a design.
    Modes,
    /// The frequency of a deflection shape is being typed.
    Frequency,
    /// All designs with their figures.
    Overview,
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
    /// What to do with edits of an earlier run.
    Recovery,
    /// What to do where somebody else has changed the file.
    Conflict,
}

impl Mode {
    pub const ALL: [Self; 25] = [
        Self::Library,
        Self::Text,
        Self::Filter,
        Self::Help,
        Self::HelpSearch,
        Self::Palette,
        Self::Name,
        Self::Confirm,
        Self::Messages,
        Self::Compare,
        Self::Spectra,
        Self::Why,
        Self::Export,
        Self::Modes,
        Self::Frequency,
        Self::Overview,
        Self::Table,
        Self::Cell,
        Self::Choice,
        Self::Matrix,
        Self::Findings,
        Self::Form,
        Self::Leave,
        Self::Recovery,
        Self::Conflict,
    ];

    /// Its table in the file of keys.
    pub fn name(self) -> &'static str {
        match self {
            Self::Library => "library",
            Self::Text => "text",
            Self::Filter => "filter",
            Self::Help => "help",
            Self::HelpSearch => "help-search",
            Self::Palette => "palette",
            Self::Name => "name",
            Self::Confirm => "confirm",
            Self::Messages => "messages",
            Self::Compare => "compare",
            Self::Spectra => "spectra",
            Self::Why => "why",
            Self::Export => "export",
            Self::Modes => "modes",
            Self::Frequency => "frequency",
            Self::Overview => "overview",
            Self::Table => "table",
            Self::Cell => "cell",
            Self::Choice => "choice",
            Self::Matrix => "matrix",
            Self::Findings => "findings",
            Self::Form => "form",
            Self::Leave => "leave",
            Self::Recovery => "recovery",
            Self::Conflict => "conflict",
        }
    }

    /// Where it is, as the title of what its keys do.
    pub fn place(self) -> &'static str {
        match self {
            Self::Library => "In the list of designs",
            Self::Text => "In the text about a design",
            Self::Filter => "While the filter is typed",
            Self::Help => "In this help",
            Self::HelpSearch => "While the help is searched",
            Self::Palette => "In the list of all actions",
            Self::Name => "While a file is named",
            Self::Confirm => "When asked whether to delete",
            Self::Messages => "In the messages",
            Self::Compare => "In the comparison",
            Self::Spectra => "Over the spectra",
            Self::Why => "In the reasons for a band",
            Self::Export => "While a file to write is named",
            Self::Modes => "In the natural modes",
            Self::Frequency => "While a frequency is typed",
            Self::Overview => "In the overview of designs",
            Self::Table => "In the tables",
            Self::Cell => "While a cell is typed into",
            Self::Choice => "In a list of words",
            Self::Matrix => "In a stiffness matrix",
            Self::Findings => "In the list of findings",
            Self::Form => "While a variant is named",
            Self::Leave => "When asked about unsaved edits",
            Self::Recovery => "When asked about edits of an earlier run",
            Self::Conflict => "When asked about somebody else's change",
        }
    }

    /// Whether letters are text.
    pub fn is_typing(self) -> bool {
        TYPING.contains(&self)
    }
}

/// One row of the keymap.
#[derive(Debug, Clone, Copy)]
pub struct Binding {
    pub modes: &'static [Mode],
    pub code: KeyCode,
    pub control: bool,
    pub action: Action,
}

const LISTS: &[Mode] = &[
    Mode::Library,
    Mode::Text,
    Mode::Help,
    Mode::Messages,
    Mode::Compare,
    Mode::Spectra,
    Mode::Why,
    Mode::Modes,
    Mode::Overview,
    Mode::Choice,
    Mode::Findings,
    Mode::Recovery,
    Mode::Conflict,
];
/// Where letters move.
const ROWS: &[Mode] = &[
    Mode::Library,
    Mode::Text,
    Mode::Help,
    Mode::Messages,
    Mode::Compare,
    Mode::Spectra,
    Mode::Why,
    Mode::Modes,
    Mode::Overview,
    Mode::Choice,
    Mode::Findings,
    Mode::Table,
    Mode::Matrix,
    Mode::Recovery,
    Mode::Conflict,
];
/// Where there is something to move in.
const MOVING: &[Mode] = &[
    Mode::Library,
    Mode::Text,
    Mode::Filter,
    Mode::Help,
    Mode::HelpSearch,
    Mode::Palette,
    Mode::Messages,
    Mode::Compare,
    Mode::Spectra,
    Mode::Why,
    Mode::Modes,
    Mode::Overview,
    Mode::Choice,
    Mode::Findings,
    Mode::Table,
    Mode::Matrix,
    Mode::Recovery,
    Mode::Conflict,
];
const PANES: &[Mode] = &[Mode::Library, Mode::Text];
const LIBRARY: &[Mode] = &[Mode::Library];
const CELLS: &[Mode] = &[Mode::Table, Mode::Matrix];
/// Where there are columns to move in.
const COLUMNS: &[Mode] = &[Mode::Table, Mode::Matrix, Mode::Spectra];
const SPECTRA: &[Mode] = &[Mode::Spectra];
const TABLE: &[Mode] = &[Mode::Table];
const CELL: &[Mode] = &[Mode::Cell];
const FORM: &[Mode] = &[Mode::Form];
const BROWSING: &[Mode] = &[Mode::Library, Mode::Text, Mode::Table, Mode::Matrix, Mode::Findings];
/// Where letters are text.
const TYPING: &[Mode] =
    &[Mode::Filter, Mode::HelpSearch, Mode::Palette, Mode::Name, Mode::Export, Mode::Frequency, Mode::Cell, Mode::Form];
/// Where a filter is typed, and what it filters.
const FILTERING: &[Mode] = &[Mode::Filter, Mode::HelpSearch];
const FILTERED: &[Mode] = &[Mode::Library, Mode::Text, Mode::Help];
const MATCHED: &[Mode] = &[Mode::Library, Mode::Text, Mode::Help, Mode::Overview];
/// What lies over the explorer and is closed.
const VIEWS: &[Mode] =
    &[Mode::Help, Mode::Messages, Mode::Compare, Mode::Spectra, Mode::Why, Mode::Modes, Mode::Overview];
/// Those that are whole screens.
const SCREENS: &[Mode] = &[Mode::Compare, Mode::Spectra, Mode::Modes, Mode::Overview];
const ANSWERED: &[Mode] = &[Mode::Palette, Mode::Name, Mode::Export, Mode::Frequency, Mode::Confirm];
const MODES: &[Mode] = &[Mode::Modes];
const OVERVIEW: &[Mode] = &[Mode::Overview];
const CONFIRM: &[Mode] = &[Mode::Confirm];
const COMMANDS: &[Mode] = &[
    Mode::Library,
    Mode::Text,
    Mode::Help,
    Mode::Compare,
    Mode::Spectra,
    Mode::Modes,
    Mode::Overview,
    Mode::Table,
    Mode::Matrix,
    Mode::Findings,
];
const HELP: &[Mode] = &[Mode::Help];
const ALL: &[Mode] = &Mode::ALL;
/// Where there is a picture.
const PICTURES: &[Mode] =
    &[Mode::Library, Mode::Text, Mode::Compare, Mode::Spectra, Mode::Modes, Mode::Table, Mode::Matrix, Mode::Choice];
const OPENED: &[Mode] = &[Mode::Library, Mode::Text, Mode::Table];
const RECOVERY: &[Mode] = &[Mode::Recovery];
const CONFLICT: &[Mode] = &[Mode::Conflict];
const VARIANTS: &[Mode] = &[Mode::Table, Mode::Recovery, Mode::Conflict];

/// Actions that have no key of their own, and where they can be used all the same.
const WITHOUT_KEY: &[(Action, &[Mode])] = &[(Action::ToggleBackground, COMMANDS), (Action::CopyPath, COMMANDS)];

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
    key(MOVING, KeyCode::Up, Action::MoveUp),
    letter(ROWS, 'k', Action::MoveUp),
    control(&[Mode::Palette], 'p', Action::MoveUp),
    key(MOVING, KeyCode::Down, Action::MoveDown),
    letter(ROWS, 'j', Action::MoveDown),
    control(&[Mode::Palette], 'n', Action::MoveDown),
    key(MOVING, KeyCode::PageUp, Action::PageUp),
    control(MOVING, 'b', Action::PageUp),
    key(MOVING, KeyCode::PageDown, Action::PageDown),
    control(MOVING, 'f', Action::PageDown),
    key(LISTS, KeyCode::Home, Action::First),
    letter(ROWS, 'g', Action::First),
    key(LISTS, KeyCode::End, Action::Last),
    letter(ROWS, 'G', Action::Last),
    key(COLUMNS, KeyCode::Left, Action::MoveLeft),
    letter(COLUMNS, 'h', Action::MoveLeft),
    key(COLUMNS, KeyCode::Right, Action::MoveRight),
    letter(COLUMNS, 'l', Action::MoveRight),
    key(CELLS, KeyCode::Home, Action::FirstCell),
    key(CELLS, KeyCode::End, Action::LastCell),
    key(CELLS, KeyCode::Tab, Action::NextCell),
    key(CELLS, KeyCode::BackTab, Action::PreviousCell),
    letter(TABLE, 'p', Action::OtherShaft),
    letter(TABLE, ']', Action::NextTable),
    letter(TABLE, '[', Action::PreviousTable),
    key(TABLE, KeyCode::F(1), Action::Segments),
    key(TABLE, KeyCode::F(2), Action::Bearings),
    key(TABLE, KeyCode::F(3), Action::Bodies),
    key(TABLE, KeyCode::F(4), Action::Mesh),
    key(TABLE, KeyCode::F(5), Action::Drives),
    key(TABLE, KeyCode::F(6), Action::Analysis),
    key(TABLE, KeyCode::F(7), Action::Materials),
    key(TABLE, KeyCode::F(8), Action::Design),
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
    letter(VARIANTS, 'S', Action::SaveVariant),
    key(CELL, KeyCode::Enter, Action::AcceptCell),
    key(CELL, KeyCode::Tab, Action::AcceptNext),
    key(CELL, KeyCode::BackTab, Action::AcceptPrevious),
    key(&[Mode::Choice], KeyCode::Enter, Action::Choose),
    letter(&[Mode::Choice], ' ', Action::Tick),
    control(TYPING, 'w', Action::DeleteWord),
    key(FORM, KeyCode::Enter, Action::SaveForm),
    key(FORM, KeyCode::Tab, Action::NextField),
    key(FORM, KeyCode::BackTab, Action::NextField),
    key(FORM, KeyCode::Up, Action::NextField),
    key(FORM, KeyCode::Down, Action::NextField),
    letter(&[Mode::Leave], 's', Action::SaveAll),
    letter(&[Mode::Leave], 'd', Action::DiscardAll),
    letter(OPENED, 'U', Action::Recover),
    letter(RECOVERY, 't', Action::TakeEdits),
    letter(RECOVERY, 'd', Action::DiscardEdits),
    letter(RECOVERY, 'n', Action::NextOffer),
    key(RECOVERY, KeyCode::Tab, Action::NextOffer),
    letter(CONFLICT, 'm', Action::KeepMine),
    letter(CONFLICT, 't', Action::TakeTheirs),
    letter(TABLE, 'f', Action::Findings),
    letter(&[Mode::Findings], 'f', Action::Back),
    key(&[Mode::Findings], KeyCode::Enter, Action::GoToFinding),
    letter(&[Mode::Findings], 'x', Action::RemoveKey),
    key(&[Mode::Findings], KeyCode::Delete, Action::RemoveKey),
    letter(CELLS, '=', Action::Solve),
    letter(TABLE, 'L', Action::ToggleLive),
    letter(CELLS, 'X', Action::CancelSolve),
    key(PANES, KeyCode::Tab, Action::NextPane),
    key(PANES, KeyCode::BackTab, Action::NextPane),
    key(LIBRARY, KeyCode::Right, Action::NextPane),
    letter(LIBRARY, 'l', Action::NextPane),
    letter(MATCHED, '/', Action::Filter),
    letter(FILTERED, 'n', Action::NextMatch),
    letter(FILTERED, 'N', Action::PreviousMatch),
    letter(LIBRARY, 't', Action::ToggleTree),
    letter(PANES, 'm', Action::Mark),
    letter(PANES, 'c', Action::Compare),
    letter(&[Mode::Compare], 'x', Action::Swap),
    letter(OPENED, 'M', Action::Modes),
    key(MODES, KeyCode::Left, Action::MoveLeft),
    letter(MODES, 'h', Action::MoveLeft),
    key(MODES, KeyCode::Right, Action::MoveRight),
    letter(MODES, 'l', Action::MoveRight),
    letter(MODES, ' ', Action::NextPhase),
    key(MODES, KeyCode::Tab, Action::OtherModel),
    letter(MODES, 'x', Action::ShowMac),
    letter(MODES, 'o', Action::Deflection),
    letter(MODES, 'f', Action::TypeFrequency),
    letter(PANES, 'O', Action::Overview),
    key(OVERVIEW, KeyCode::Enter, Action::ShowDesign),
    letter(OVERVIEW, 's', Action::SortColumn),
    letter(OVERVIEW, 'S', Action::SortDirection),
    letter(PANES, 'r', Action::Rename),
    letter(PANES, 'Y', Action::Duplicate),
    letter(PANES, 'D', Action::Delete),
    letter(PANES, 'u', Action::RestoreDeleted),
    key(FILTERING, KeyCode::Enter, Action::KeepFilter),
    key(TYPING, KeyCode::Left, Action::TextLeft),
    key(TYPING, KeyCode::Right, Action::TextRight),
    key(TYPING, KeyCode::Home, Action::TextStart),
    control(TYPING, 'a', Action::TextStart),
    key(TYPING, KeyCode::End, Action::TextEnd),
    control(TYPING, 'e', Action::TextEnd),
    key(TYPING, KeyCode::Backspace, Action::DeleteCharacter),
    control(TYPING, 'h', Action::DeleteCharacter),
    key(TYPING, KeyCode::Delete, Action::DeleteForward),
    control(TYPING, 'u', Action::ClearText),
    key(ANSWERED, KeyCode::Enter, Action::Accept),
    letter(CONFIRM, 'y', Action::Accept),
    key(ALL, KeyCode::Esc, Action::Back),
    key(&[Mode::Text], KeyCode::Left, Action::Back),
    letter(&[Mode::Text], 'h', Action::Back),
    letter(VIEWS, 'q', Action::Back),
    letter(HELP, '?', Action::Back),
    letter(CONFIRM, 'n', Action::Back),
    letter(PANES, 'R', Action::Reread),
    control(ALL, 'l', Action::Redraw),
    control(ALL, 'z', Action::Suspend),
    letter(PICTURES, 'b', Action::CycleMarker),
    letter(ROWS, 'y', Action::Copy),
    letter(COMMANDS, ':', Action::Palette),
    letter(BROWSING, '!', Action::Messages),
    letter(BROWSING, '?', Action::Help),
    letter(SCREENS, '?', Action::Help),
    letter(SPECTRA, '!', Action::Messages),
    letter(OPENED, 'w', Action::OpenSpectra),
    letter(SPECTRA, 'w', Action::Back),
    letter(SPECTRA, 'H', Action::JumpLeft),
    letter(SPECTRA, 'L', Action::JumpRight),
    letter(SPECTRA, 'i', Action::ZoomIn),
    letter(SPECTRA, 'o', Action::ZoomOut),
    letter(SPECTRA, 'f', Action::ZoomFit),
    letter(SPECTRA, '<', Action::PanLeft),
    letter(SPECTRA, '>', Action::PanRight),
    letter(SPECTRA, 'v', Action::NextQuantity),
    letter(SPECTRA, 'V', Action::PreviousQuantity),
    letter(SPECTRA, 'r', Action::NextDirection),
    letter(SPECTRA, '1', Action::ShowFe),
    letter(SPECTRA, '2', Action::ShowEnhanced),
    letter(SPECTRA, '3', Action::ShowBasic),
    letter(SPECTRA, '4', Action::ShowReduced),
    letter(SPECTRA, '+', Action::MoreModes),
    letter(SPECTRA, '-', Action::FewerModes),
    letter(SPECTRA, 'm', Action::NextAgainst),
    letter(SPECTRA, 'x', Action::LogFrequency),
    letter(SPECTRA, 'd', Action::LinearLevel),
    key(SPECTRA, KeyCode::Tab, Action::NextPanel),
    letter(SPECTRA, '[', Action::LessTolerance),
    letter(SPECTRA, ']', Action::MoreTolerance),
    letter(SPECTRA, 'n', Action::NextBand),
    letter(SPECTRA, 'N', Action::PreviousBand),
    letter(SPECTRA, 'p', Action::NextPeak),
    letter(SPECTRA, 'P', Action::PreviousPeak),
    letter(SPECTRA, 'a', Action::ListPeaks),
    key(SPECTRA, KeyCode::Enter, Action::Why),
    letter(SPECTRA, 'W', Action::Why),
    key(&[Mode::Why], KeyCode::Enter, Action::Back),
    letter(SPECTRA, 'E', Action::ExportShown),
    letter(BROWSING, 'q', Action::Quit),
    control(ALL, 'c', Action::Quit),
];

/// Whether an action can be used in a mode.
pub fn is_known(mode: Mode, action: Action) -> bool {
    let here = |modes: &[Mode], other: Action| other == action && modes.contains(&mode);
    BINDINGS.iter().any(|binding| here(binding.modes, binding.action))
        || WITHOUT_KEY.iter().any(|(action, modes)| here(modes, *action))
}

#[cfg(test)]
mod tests {
    use super::super::action::ACTIONS;
    use super::super::keys::Keys;
    use super::*;
    use ratatui::crossterm::event::KeyEvent;

    #[test]
    fn every_action_is_named_documented_and_reached() {
        for about in ACTIONS {
            assert!(!about.name.is_empty() && !about.doc.is_empty(), "{about:?}");
            assert!(about.name.bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'-'), "{about:?}");
            assert_eq!(ACTIONS.iter().filter(|other| other.name == about.name).count(), 1, "{about:?}");
            assert!(!["none", "all"].contains(&about.name), "{about:?}");
            let modes: Vec<Mode> = Mode::ALL.into_iter().filter(|mode| is_known(*mode, about.action)).collect();
            assert!(!modes.is_empty(), "{} can be used nowhere", about.name);
            // what has no key is in the palette, which must be there
            for mode in modes {
                let has_key = !Keys::default().of(mode, about.action, false).is_empty();
                assert!(has_key || is_known(mode, Action::Palette), "no way to {} in {mode:?}", about.name);
            }
        }
    }

    #[test]
    fn no_key_has_two_meanings_in_a_mode() {
        let keys = Keys::default();
        for (at, bound) in keys.bound().iter().enumerate() {
            let twice = keys.bound()[..at].iter().any(|other| other.mode == bound.mode && other.key == bound.key);
            assert!(!twice, "{bound:?}");
        }
    }

    #[test]
    fn letters_are_text_while_something_is_typed() {
        for mode in Mode::ALL.into_iter().filter(|mode| mode.is_typing()) {
            for letter in ' '..='~' {
                assert_eq!(Keys::default().action(mode, KeyEvent::from(KeyCode::Char(letter))), None, "{letter}");
            }
        }
    }

    #[test]
    fn escape_never_quits_and_there_is_always_a_way_out() {
        for mode in Mode::ALL {
            assert_eq!(Keys::default().action(mode, KeyEvent::from(KeyCode::Esc)), Some(Action::Back));
            assert!(!Keys::default().of(mode, Action::Quit, true).is_empty(), "{mode:?}");
        }
    }
}
