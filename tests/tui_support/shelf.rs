//! Design files that are kept in memory.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use bevelscope::comparison::{Comparison, Observer, SolveError, compare_over, compare_rotors};
use bevelscope::design::library::{Left, SHIPPED, VariantName};
use bevelscope::design::{Design, Difference};
use bevelscope::model::Rotors;
use bevelscope::tui::files::{FileDone, FileRequest, Followed};
use bevelscope::tui::recovery::{FileState, Kept, Look};
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign, NotSaved};

use super::paths;

/// Design files that are kept in memory, read and solved as real ones are.
#[derive(Debug, Default, Clone)]
pub struct Shelf {
    pub texts: Arc<Mutex<BTreeMap<PathBuf, String>>>,
    /// What was asked to be kept, in order.
    pub kept: Arc<Mutex<Vec<Kept>>>,
    /// What an earlier run has left.
    pub left: Arc<Mutex<Left>>,
    /// Who else has the designs open.
    pub holder: Arc<Mutex<Option<String>>>,
}

impl Shelf {
    pub fn new(files: &[(&str, &str)]) -> Self {
        let texts = files.iter().map(|(stem, text)| (paths(&[stem])[0].clone(), (*text).to_owned())).collect();
        Self { texts: Arc::new(Mutex::new(texts)), ..Self::default() }
    }

    /// The designs that come with the program.
    pub fn shipped() -> Self {
        let files: Vec<_> =
            SHIPPED.iter().map(|shipped| (shipped.file_name.trim_end_matches(".toml"), shipped.text)).collect();
        Self::new(&files)
    }

    pub fn text(&self, stem: &str) -> Option<String> {
        self.texts.lock().unwrap().get(&paths(&[stem])[0]).cloned()
    }

    pub fn stems(&self) -> Vec<String> {
        let texts = self.texts.lock().unwrap();
        texts.keys().map(|path| path.file_stem().unwrap().to_string_lossy().into_owned()).collect()
    }
}

impl Backend for Shelf {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        let text = self.read(path).map_err(|error| BrokenDesign { one_line: error.clone(), full_text: error })?;
        let reading = bevelscope::design::read(&text);
        let message = reading.errors().next().map_or(String::new(), |finding| finding.message.clone());
        match reading.design {
            Some(design) => Ok(design.into()),
            None => Err(BrokenDesign { one_line: message.clone(), full_text: message }),
        }
    }

    fn compare(&self, design: &Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        compare_over(design, None, observer)
    }

    fn compare_edited(
        &self,
        design: &Design,
        rotors: &mut Option<Rotors>,
        observer: &mut Observer<'_>,
    ) -> Result<Comparison, SolveError> {
        let rotors = rotors.insert(Rotors::reusing(design, rotors.as_ref())?);
        compare_rotors(design, rotors, None, observer)
    }

    fn read(&self, path: &Path) -> Result<String, String> {
        self.texts.lock().unwrap().get(path).cloned().ok_or_else(|| "there is no such file".into())
    }

    fn save(&self, path: &Path, expected: Option<&[u8]>, text: &str) -> Result<(), NotSaved> {
        let mut texts = self.texts.lock().unwrap();
        let now = texts.get(path).map(String::as_bytes);
        if now != expected {
            return Err(NotSaved::Changed(now.map(<[u8]>::to_vec)));
        }
        texts.insert(path.into(), text.to_owned());
        Ok(())
    }

    fn keep(&self, change: &Kept) -> Result<(), String> {
        self.kept.lock().unwrap().push(change.clone());
        Ok(())
    }

    fn left(&self) -> Left {
        self.left.lock().unwrap().clone()
    }

    fn look(&self, path: &Path, expected: &str) -> Look {
        let state = match self.texts.lock().unwrap().get(path) {
            Some(text) if text == expected => FileState::Same,
            Some(_) => FileState::Changed,
            None => FileState::Gone,
        };
        Look { state, holder: self.holder.lock().unwrap().clone() }
    }

    fn save_variant(
        &self,
        original: &Path,
        name: &VariantName,
        text: &str,
        note: Option<&str>,
    ) -> Result<(PathBuf, String), String> {
        let path = name.path_in(original.parent().unwrap());
        let mut texts = self.texts.lock().unwrap();
        if texts.contains_key(&path) {
            return Err("there is a file of that name already".into());
        }
        let text = format!("# note: {}\n{text}", note.unwrap_or_default());
        texts.insert(path.clone(), text.clone());
        Ok((path, text))
    }

    fn differences(&self, a: &Path, b: &Path) -> Result<Vec<Difference>, String> {
        Ok(bevelscope::design::diff(&self.read(a)?, &self.read(b)?))
    }

    fn list(&self) -> Option<Result<Vec<PathBuf>, String>> {
        Some(Ok(self.texts.lock().unwrap().keys().cloned().collect()))
    }

    /// Renames, and makes new ones; a variant with the word `locked` in it cannot be written, nor a new one of that name.
    fn change_file(&self, request: &FileRequest) -> Result<FileDone, String> {
        if let FileRequest::Create { beside, name, text } = request {
            if name.as_str().contains("locked") {
                return Err("the folder is locked".into());
            }
            let folder = beside.as_deref().and_then(Path::parent).unwrap_or(Path::new("/designs"));
            let path = name.path_in(folder);
            self.texts.lock().unwrap().insert(path.clone(), text.clone());
            return Ok(FileDone::Created { path });
        }
        let FileRequest::Rename { path, name } = request else { return Err("not on this shelf".into()) };
        let mut texts = self.texts.lock().unwrap();
        let text = texts.remove(path).ok_or("there is no such file")?;
        let to = name.path_in(path.parent().unwrap());
        texts.insert(to.clone(), text);
        let (old, new) = (path.file_stem().unwrap().to_string_lossy(), name.as_str());
        let (old, new) = (format!("parent = \"{old}\""), format!("parent = \"{new}\""));
        let variants = texts.iter_mut().filter(|(_, text)| text.contains(&old)).map(|(path, text)| {
            let locked = text.contains("locked");
            if !locked {
                *text = text.replace(&old, &new);
            }
            Followed { path: path.clone(), result: if locked { Err("it is locked".into()) } else { Ok(text.clone()) } }
        });
        Ok(FileDone::Renamed { from: path.clone(), to, variants: variants.collect() })
    }
}
