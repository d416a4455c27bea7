//! Which key does what: data, so that the help and the hints cannot differ from what happens.

mod mode;
mod places;

use ratatui::crossterm::event::KeyCode;

pub use self::mode::Mode;
pub use self::places::SCREENS;
use self::places::{
    ALL, ANSWERED, BEARINGS, BROWSING, CELL, CELLS, COLUMNS, COMMANDS, CONFIRM, CONFLICT, EDITED, FILTERED, FILTERING,
    FLANKS, FORM, HELP, LIBRARY, LISTS, LIVE, MATCHED, MODES, MOVING, NEW, OPENED, OVERVIEW, PAIR, PAIR_FORMS, PANES,
    PICTURES, RECOVERY, ROWS, SAVED, SOLVED, SPECTRA, TABLE, TOLD, TYPING, VARIANTS, VIEWS, WRITTEN,
};
use super::action::Action;

/// One row of the keymap.
#[derive(Debug, Clone, Copy)]
pub struct Binding {
    pub modes: &'static [Mode],
    pub code: KeyCode,
    pub control: bool,
    pub action: Action,
}

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
    letter(EDITED, 'u', Action::Undo),
    control(EDITED, 'r', Action::Redo),
    letter(SAVED, 's', Action::Save),
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
    letter(SOLVED, '=', Action::Solve),
    letter(LIVE, 'L', Action::ToggleLive),
    letter(SOLVED, 'X', Action::CancelSolve),
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
    letter(SPECTRA, 'M', Action::Modes),
    key(MODES, KeyCode::Left, Action::MoveLeft),
    letter(MODES, 'h', Action::MoveLeft),
    key(MODES, KeyCode::Right, Action::MoveRight),
    letter(MODES, 'l', Action::MoveRight),
    letter(MODES, ' ', Action::NextPhase),
    key(MODES, KeyCode::Tab, Action::OtherModel),
    letter(MODES, 'x', Action::ShowMac),
    letter(MODES, 'o', Action::Deflection),
    letter(MODES, 'f', Action::TypeFrequency),
    letter(MODES, '+', Action::MoreModes),
    letter(MODES, '-', Action::FewerModes),
    letter(OPENED, 'O', Action::Overview),
    key(OVERVIEW, KeyCode::Left, Action::PreviousColumn),
    letter(OVERVIEW, 'h', Action::PreviousColumn),
    key(OVERVIEW, KeyCode::Enter, Action::ShowDesign),
    letter(OVERVIEW, 's', Action::SortColumn),
    key(OVERVIEW, KeyCode::Right, Action::SortColumn),
    letter(OVERVIEW, 'l', Action::SortColumn),
    letter(OVERVIEW, 'S', Action::SortDirection),
    letter(PANES, 'a', Action::NewDesign),
    key(NEW, KeyCode::Enter, Action::CreateDesign),
    key(NEW, KeyCode::Tab, Action::MoveDown),
    key(NEW, KeyCode::BackTab, Action::MoveUp),
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
    letter(TOLD, '!', Action::Messages),
    letter(BROWSING, '?', Action::Help),
    letter(SCREENS, '?', Action::Help),
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
    letter(WRITTEN, 'e', Action::ExportShown),
    letter(WRITTEN, 'E', Action::ExportShown),
    letter(OPENED, 'E', Action::ExportShown),
    letter(OPENED, 'B', Action::BearingLoads),
    letter(BEARINGS, 'B', Action::Back),
    letter(BEARINGS, '+', Action::MoreTorque),
    letter(BEARINGS, '-', Action::LessTorque),
    letter(BEARINGS, '>', Action::MuchMoreTorque),
    letter(BEARINGS, '<', Action::MuchLessTorque),
    letter(BEARINGS, 't', Action::TypeTorque),
    key(BEARINGS, KeyCode::Tab, Action::NextView),
    key(BEARINGS, KeyCode::Left, Action::PreviousElement),
    letter(BEARINGS, 'h', Action::PreviousElement),
    key(BEARINGS, KeyCode::Right, Action::NextElement),
    letter(BEARINGS, 'l', Action::NextElement),
    key(BEARINGS, KeyCode::Enter, Action::OpenEditor),
    letter(OPENED, 'P', Action::GearPair),
    letter(PAIR, 'P', Action::Back),
    letter(PAIR, 'f', Action::FlipFlank),
    letter(PAIR, 'K', Action::EstimateStiffness),
    letter(PAIR, 'I', Action::ImportMesh),
    key(&[Mode::FaceWidth], KeyCode::Tab, Action::OtherValue),
    key(FLANKS, KeyCode::Tab, Action::OtherFlank),
    key(PAIR_FORMS, KeyCode::Enter, Action::Accept),
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
