//! Unsaved edits are kept where they survive the program; what an earlier run has left is offered.
//!
//! ```text
//! message ─> any change of any text ─> App::protect ─> Keeper ─> journal
//! start ─> journals without an owner ─> offer ─> an undoable edit over the file | aside | later
//! ```
//!
//! What is to be kept follows from the texts after each message and is never asked for by what changed them, so that no way to
//! edit can be forgotten.

mod answers;
mod keeper;
mod offers;
mod protect;

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

pub use keeper::Keeper;
pub use offers::{Offer, Offers, Theirs};

/// What becomes of unsaved edits outside the program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Kept {
    /// The design at `path` has these, over the text `base`.
    Edits { path: PathBuf, base: String, text: String },
    /// The design has none any more.
    Nothing { path: PathBuf },
    /// Nobody wants those of the design.
    Discarded { path: PathBuf },
    /// Those of an earlier run are edits of the design at `path` now.
    Taken { path: PathBuf, journal: PathBuf },
    /// Nobody wants those of an earlier run.
    Unwanted { journal: PathBuf },
}

/// What is known of the file of an open design.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Look {
    pub state: FileState,
    /// Who else has it open, in words
    pub holder: Option<String>,
}

/// A file against what it is thought to hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FileState {
    #[default]
    Same,
    Changed,
    Gone,
}

/// What is kept of which design, and what earlier runs have left.
#[derive(Debug, Default)]
pub struct Recovery {
    /// Base and text as they were given to be kept last.
    kept: BTreeMap<PathBuf, (String, String)>,
    /// The designs that are locked, or were to be.
    open: BTreeSet<PathBuf>,
    /// Why unsaved edits are not protected.
    pub unprotected: Option<String>,
    pub offers: Offers,
    /// The user asked for the offers, and wants to hear also if there are none.
    asked: bool,
    /// The program ends, and what is unsaved is not wanted.
    is_over: bool,
}
