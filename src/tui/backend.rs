//! What the explorer needs from the rest of the program.

use std::path::{Path, PathBuf};

use super::files::{FileDone, FileRequest};
use super::modes::Study;
use super::recovery::{Kept, Look};
use super::spectra::{ModelCurves, Subject};
use crate::comparison::{Comparison, Observer, SolveError};
use crate::design::library::{Left, VariantName};
use crate::design::{Design, Difference};
use crate::document::Document;
use crate::gear::AveragedMesh;
use crate::model::{ModelKind, Rotors};
use crate::pair::read_flanks;

/// Reads and solves designs. Called on background threads only, never before the first frame.
pub trait Backend: Send + Sync {
    /// Reads one design file.
    ///
    /// # Errors
    ///
    /// [`BrokenDesign`] says what is wrong with the file.
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign>;

    /// Solves the three models of a design; the observer hears how far it is and may end it.
    ///
    /// # Errors
    ///
    /// [`SolveError`] says why there is no solution.
    fn compare(&self, design: &Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError>;

    /// As [`compare`](Self::compare), of a design that is being edited: `rotors` are those of the edit before, and become its own, so that
    /// what has not changed of them need not be found again.
    ///
    /// # Errors
    ///
    /// As [`compare`](Self::compare).
    fn compare_edited(
        &self,
        design: &Design,
        rotors: &mut Option<Rotors>,
        observer: &mut Observer<'_>,
    ) -> Result<Comparison, SolveError> {
        let _ = rotors;
        self.compare(design, observer)
    }

    /// Solves one model of a design on the lines of its analysis, with all that further curves are made from.
    ///
    /// # Errors
    ///
    /// [`SolveError`] says why there is no solution.
    fn spectrum(
        &self,
        subject: &Subject,
        kind: ModelKind,
        observer: &mut Observer<'_>,
    ) -> Result<ModelCurves, SolveError> {
        ModelCurves::new(subject, kind, observer)
    }

    /// Writes what a screen shows to a new file, in the format that its name ends in, and says where that is.
    ///
    /// # Errors
    ///
    /// Why not, in one line. A file that is there is never overwritten.
    fn export(&self, path: &Path, document: &Document) -> Result<PathBuf, String> {
        let _ = (path, document);
        Err(READ_ONLY.into())
    }

    /// The flanks of a table of averaged mesh numbers.
    ///
    /// # Errors
    ///
    /// Why there are none: in words, with the line that is wrong and what is allowed there.
    fn mesh_table(&self, path: &Path) -> Result<Vec<AveragedMesh>, String> {
        let text = self.read(path)?;
        read_flanks(&text)
    }

    /// As [`export`](Self::export), of a design: its spectra as data, their picture, or the whole report. `text` is what counts in place of the file.
    ///
    /// # Errors
    ///
    /// As [`export`](Self::export), or why there is no solution.
    fn export_design(&self, path: &Path, design: &Path, text: Option<&str>) -> Result<PathBuf, String> {
        let _ = (path, design, text);
        Err(READ_ONLY.into())
    }

    /// The modes of a design's models, the reduced one with `reduced` fixed-interface modes a rotor; given up as soon as `wanted` says no.
    ///
    /// # Errors
    ///
    /// [`SolveError`] says why there are none.
    fn modes(&self, design: &Design, reduced: usize, wanted: &dyn Fn() -> bool) -> Result<Study, SolveError> {
        Study::new(design, reduced, wanted)
    }

    /// The text of a design file, also of one that is [broken](BrokenDesign).
    ///
    /// # Errors
    ///
    /// Why there is none, in one line.
    fn read(&self, path: &Path) -> Result<String, String> {
        let _ = path;
        Err(READ_ONLY.into())
    }

    /// Replaces the text of a design file, if it still is `expected`, or makes the file, if that is nothing and it is not there.
    ///
    /// # Errors
    ///
    /// [`NotSaved`]; the file is as it was then.
    fn save(&self, path: &Path, expected: Option<&[u8]>, text: &str) -> Result<(), NotSaved> {
        let _ = (path, expected, text);
        Err(NotSaved::Failed(READ_ONLY.into()))
    }

    /// Writes a text as a variant beside the design that it came from. Gives its path and its text, in which parent and
    /// note are set.
    ///
    /// # Errors
    ///
    /// Why there is no variant, in one line. A file that is there is never overwritten.
    fn save_variant(
        &self,
        original: &Path,
        name: &VariantName,
        text: &str,
        note: Option<&str>,
    ) -> Result<(PathBuf, String), String> {
        let _ = (original, name, text, note);
        Err(READ_ONLY.into())
    }

    /// The library's files as they are now, or why its folder cannot be read. `None` where the library is a fixed list
    /// of files.
    fn list(&self) -> Option<Result<Vec<PathBuf>, String>> {
        None
    }

    /// Renames, copies, deletes or brings back a file.
    ///
    /// # Errors
    ///
    /// Why not, in words; nothing has changed then.
    fn change_file(&self, request: &FileRequest) -> Result<FileDone, String> {
        let _ = request;
        Err("the files of this library cannot be changed".into())
    }

    /// Keeps unsaved edits where they survive the program, or no longer does.
    ///
    /// # Errors
    ///
    /// Why they are not protected, in one line.
    fn keep(&self, change: &Kept) -> Result<(), String> {
        let _ = change;
        Ok(())
    }

    /// The unsaved edits that earlier runs have left.
    fn left(&self) -> Left {
        Left::default()
    }

    /// Whether the file of an open design still is `expected`, and who else has it open.
    fn look(&self, path: &Path, expected: &str) -> Look {
        let _ = (path, expected);
        Look::default()
    }

    /// A design is not open any more.
    fn release(&self, path: &Path) {
        let _ = path;
    }

    /// Where two design files differ.
    ///
    /// # Errors
    ///
    /// Which of them cannot be read, and why.
    fn differences(&self, a: &Path, b: &Path) -> Result<Vec<Difference>, String> {
        let _ = (a, b);
        Err("the files of this library cannot be compared".into())
    }
}

const READ_ONLY: &str = "these designs can only be looked at";

/// Why a design was not saved. The file is as it was.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NotSaved {
    /// With what it holds now; nothing where it is gone
    #[error("the file has changed on disk since it was read")]
    Changed(Option<Vec<u8>>),
    #[error("{0}")]
    Failed(String),
}

/// A design that passed its checks.
#[derive(Debug, Clone, PartialEq)]
pub struct LoadedDesign {
    pub design: Design,
    /// What is allowed but looks unintended, one line each.
    pub warnings: Vec<String>,
    /// As of [`crate::design::hash`]; nothing where there is no file
    pub hash: Option<String>,
}

impl From<Design> for LoadedDesign {
    fn from(design: Design) -> Self {
        Self { design, warnings: Vec::new(), hash: None }
    }
}

/// Why a design file cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{one_line}")]
pub struct BrokenDesign {
    /// A few words for the library, e.g. `line 14: unknown key`.
    pub one_line: String,
    /// The whole message.
    pub full_text: String,
}
