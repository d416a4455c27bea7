//! Unsaved edits on disk, so that they survive the program: one file a design and process, in a folder of the user's own.
//!
//! A journal is locked by the process that writes it, which lives as long as the lock is held, however it ends. Those
//! without an owner are what an earlier run has left.

mod folder;
mod format;
mod own;

pub use folder::{DISCARDED, Found, discard, journals, recovery_folder, set_aside};
pub use format::{Journal, JournalError};
pub(super) use own::settled;
pub use own::{Journals, remove};
