//! Sets of places in which the same key means the same.

use super::Mode;

pub const LISTS: &[Mode] = &[
    Mode::Library,
    Mode::Text,
    Mode::Help,
    Mode::Messages,
    Mode::Compare,
    Mode::Spectra,
    Mode::Why,
    Mode::Modes,
    Mode::Bearings,
    Mode::Overview,
    Mode::Pair,
    Mode::MeshImport,
    Mode::Choice,
    Mode::Findings,
    Mode::Recovery,
    Mode::Conflict,
];
/// Where letters move.
pub const ROWS: &[Mode] = &[
    Mode::Library,
    Mode::Text,
    Mode::Help,
    Mode::Messages,
    Mode::Compare,
    Mode::Spectra,
    Mode::Why,
    Mode::Modes,
    Mode::Bearings,
    Mode::Overview,
    Mode::Pair,
    Mode::MeshImport,
    Mode::Choice,
    Mode::Findings,
    Mode::Table,
    Mode::Matrix,
    Mode::Recovery,
    Mode::Conflict,
];
/// Where there is something to move in.
pub const MOVING: &[Mode] = &[
    Mode::New,
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
    Mode::Bearings,
    Mode::Overview,
    Mode::Pair,
    Mode::MeshImport,
    Mode::Choice,
    Mode::Findings,
    Mode::Table,
    Mode::Matrix,
    Mode::Recovery,
    Mode::Conflict,
];
pub const PANES: &[Mode] = &[Mode::Library, Mode::Text];
pub const LIBRARY: &[Mode] = &[Mode::Library];
pub const PAIR: &[Mode] = &[Mode::Pair];
pub const PAIR_FORMS: &[Mode] = &[Mode::FaceWidth, Mode::MeshFile, Mode::MeshImport];
pub const FLANKS: &[Mode] = &[Mode::MeshFile, Mode::MeshImport];
pub const CELLS: &[Mode] = &[Mode::Table, Mode::Matrix];
/// Where a design is edited, and what of that is saved, solved and solved at once.
pub const EDITED: &[Mode] = &[Mode::Table, Mode::Matrix, Mode::Bearings, Mode::Pair];
pub const SAVED: &[Mode] = &[Mode::Table, Mode::Bearings, Mode::Pair];
pub const SOLVED: &[Mode] = &[Mode::Table, Mode::Matrix, Mode::Bearings];
pub const LIVE: &[Mode] = &[Mode::Table, Mode::Bearings];
/// Where messages come.
pub const TOLD: &[Mode] = &[
    Mode::Library,
    Mode::Text,
    Mode::Table,
    Mode::Matrix,
    Mode::Findings,
    Mode::Compare,
    Mode::Spectra,
    Mode::Modes,
    Mode::Bearings,
    Mode::Overview,
    Mode::Pair,
];
/// Where there are columns to move in.
pub const COLUMNS: &[Mode] = &[Mode::Table, Mode::Matrix, Mode::Spectra];
pub const SPECTRA: &[Mode] = &[Mode::Spectra];
pub const TABLE: &[Mode] = &[Mode::Table];
pub const CELL: &[Mode] = &[Mode::Cell];
pub const FORM: &[Mode] = &[Mode::Form];
pub const BROWSING: &[Mode] = &[Mode::Library, Mode::Text, Mode::Table, Mode::Matrix, Mode::Findings];
/// Where letters are text.
pub const TYPING: &[Mode] = &[
    Mode::Filter,
    Mode::HelpSearch,
    Mode::Palette,
    Mode::Name,
    Mode::New,
    Mode::Export,
    Mode::Frequency,
    Mode::Torque,
    Mode::FaceWidth,
    Mode::MeshFile,
    Mode::Cell,
    Mode::Form,
];
/// Where a filter is typed, and what it filters.
pub const FILTERING: &[Mode] = &[Mode::Filter, Mode::HelpSearch];
pub const FILTERED: &[Mode] = &[Mode::Library, Mode::Text, Mode::Help];
pub const MATCHED: &[Mode] = &[Mode::Library, Mode::Text, Mode::Help, Mode::Overview];
/// What lies over the explorer and is closed.
pub const VIEWS: &[Mode] = &[
    Mode::Help,
    Mode::Messages,
    Mode::Compare,
    Mode::Spectra,
    Mode::Why,
    Mode::Modes,
    Mode::Bearings,
    Mode::Overview,
    Mode::Pair,
];
/// Those that are whole screens.
pub const SCREENS: &[Mode] = &[Mode::Compare, Mode::Spectra, Mode::Modes, Mode::Bearings, Mode::Overview, Mode::Pair];
/// Those that can be written to a file with a key.
pub const WRITTEN: &[Mode] = &[Mode::Compare, Mode::Spectra, Mode::Modes, Mode::Bearings, Mode::Overview, Mode::Pair];
pub const ANSWERED: &[Mode] = &[Mode::Palette, Mode::Name, Mode::Export, Mode::Frequency, Mode::Torque, Mode::Confirm];
pub const MODES: &[Mode] = &[Mode::Modes];
pub const BEARINGS: &[Mode] = &[Mode::Bearings];
pub const OVERVIEW: &[Mode] = &[Mode::Overview];
pub const NEW: &[Mode] = &[Mode::New];
pub const CONFIRM: &[Mode] = &[Mode::Confirm];
pub const COMMANDS: &[Mode] = &[
    Mode::Library,
    Mode::Text,
    Mode::Help,
    Mode::Compare,
    Mode::Spectra,
    Mode::Modes,
    Mode::Bearings,
    Mode::Overview,
    Mode::Pair,
    Mode::Table,
    Mode::Matrix,
    Mode::Findings,
];
pub const HELP: &[Mode] = &[Mode::Help];
pub const ALL: &[Mode] = &Mode::ALL;
/// Where there is a picture.
pub const PICTURES: &[Mode] = &[
    Mode::Library,
    Mode::Text,
    Mode::Compare,
    Mode::Spectra,
    Mode::Modes,
    Mode::Bearings,
    Mode::Pair,
    Mode::Table,
    Mode::Matrix,
    Mode::Choice,
];
pub const OPENED: &[Mode] = &[Mode::Library, Mode::Text, Mode::Table];
pub const RECOVERY: &[Mode] = &[Mode::Recovery];
pub const CONFLICT: &[Mode] = &[Mode::Conflict];
pub const VARIANTS: &[Mode] = &[Mode::Table, Mode::Recovery, Mode::Conflict];
