//! What happens to the explorer, and what it asks for.

use std::path::PathBuf;
use std::sync::Arc;

use ratatui::crossterm::event::KeyEvent;

use super::backend::{BrokenDesign, LoadedDesign, NotSaved};
use super::compare::{CompareJob, Compared};
use super::file_jobs::FileJob;
use super::files::{FileDone, FileRequest};
use super::modes::{Answer, ModesJob};
use super::recovery::{Kept, Look};
use super::solving::{EditedJob, Job, Solved, Ticket};
use super::spectra::{Part, SpectraJob};
use crate::design::library::Left;
use crate::gear::AveragedMesh;

/// Everything that can change the state comes as one of these.
#[derive(Debug)]
pub enum Message {
    Key(KeyEvent),
    /// Text from the clipboard.
    Paste(String),
    Resized,
    /// A design was read.
    Loaded {
        ticket: Ticket,
        path: PathBuf,
        result: Result<Arc<LoadedDesign>, BrokenDesign>,
    },
    /// A design was solved, or why not.
    Solved {
        ticket: Ticket,
        path: PathBuf,
        result: Result<Solved, String>,
    },
    /// The text of a design, for its tables, or why there is none.
    Opened {
        path: PathBuf,
        result: Result<String, String>,
    },
    /// How far the solution of an edited design is, from 0 to 1.
    Progress {
        ticket: Ticket,
        done: f64,
    },
    /// An edited design was solved, or why not.
    SolvedEdited {
        ticket: Ticket,
        path: PathBuf,
        result: Result<Solved, String>,
    },
    /// A text was written, or why not.
    Saved {
        path: PathBuf,
        text: String,
        result: Result<(), NotSaved>,
    },
    /// A variant of the design at `original` was written: its path and its text, or why not.
    VariantSaved {
        original: PathBuf,
        result: Result<(PathBuf, String), String>,
    },
    /// Whether somebody else has changed or opened a file.
    Looked {
        path: PathBuf,
        look: Look,
    },
    /// Unsaved edits of earlier runs.
    Left(Left),
    /// Whether unsaved edits are kept where they survive the program, or why not; when that changes.
    Protected(Result<(), String>),
    /// Why edits that nobody needs any more could not be put away.
    NotTidied(String),
    /// The library's files, or why they cannot be listed.
    Listed(Result<Vec<PathBuf>, String>),
    /// What became of a change of a file.
    FileChanged {
        request: FileRequest,
        result: Result<FileDone, String>,
    },
    /// Two designs were compared.
    Compared {
        ticket: Ticket,
        result: Box<Compared>,
    },
    /// A part of what the wide screen shows.
    Spectra {
        ticket: Ticket,
        part: Box<Part>,
    },
    /// What was shown was written, or why not.
    Exported(Result<PathBuf, String>),
    /// A table of averaged mesh numbers was read, or why not.
    MeshTable {
        ticket: Ticket,
        result: Result<Vec<AveragedMesh>, String>,
    },
    /// Modes or a deflection shape were computed, or why not.
    ModesFound {
        ticket: Ticket,
        result: Result<Answer, String>,
    },
    /// The system asks the program to stop until it is continued.
    Suspend,
    /// The program was stopped, without being asked, and goes on.
    Continued,
    /// The system asks the program to end.
    Signal(i32),
    /// The terminal is gone.
    TerminalGone,
}

/// What the state asks of the world after a message.
#[derive(Debug, Clone, PartialEq)]
pub enum Effect {
    /// Read and solve the selected design.
    Solve(Job),
    /// Read and solve for the library's rows, in this order.
    Fill(Vec<Job>),
    /// Solve a design as it is being edited; what is being solved is no longer wanted.
    SolveEdited(EditedJob),
    /// What is being solved is no longer wanted.
    CancelSolve,
    /// Read or write a file.
    File(FileJob),
    /// Keep unsaved edits where they survive the program, or no longer.
    Keep(Kept),
    /// List the library's files again.
    List,
    /// Rename, copy, delete or bring back a file.
    ChangeFile(FileRequest),
    /// Compare two designs.
    Compare(CompareJob),
    /// The comparison is no longer wanted.
    CancelCompare,
    /// Solve what the wide screen shows.
    Spectra(Box<SpectraJob>),
    /// It is no longer wanted.
    CancelSpectra,
    /// Compute modes or a deflection shape.
    Modes(ModesJob),
    /// They are no longer wanted.
    CancelModes,
    /// Draw all of the screen, whatever the terminal shows.
    Redraw,
    /// Hand a text to the terminal: these bytes, as they are.
    Copy(Vec<u8>),
    Suspend,
    /// Take the terminal over again, whatever state it is in.
    TakeAgain,
    Quit(Ending),
}

/// Why the explorer ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    Quit,
    Signal(i32),
    TerminalGone,
}
