//! `bevelscope` without a subcommand: the terminal explorer.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use clap::CommandFactory;

use super::CommandError;
use super::guard::Guard;
use super::keys::KeysArg;
use crate::comparison::{self, Comparison, Observer, SolveError};
use crate::design::library::{Left, Trashed, trashed};
use crate::design::{self, Difference, LoadError, library};
use crate::document::Document;
use crate::gear::AveragedMesh;
use crate::model::Rotors;
use crate::text::printable;
use crate::tui::facts;
use crate::tui::files::{FileDone, FileRequest, Followed};
use crate::tui::recovery::{Kept, Look};
use crate::tui::{self, Backend, BrokenDesign, LoadedDesign, NotSaved};
use crate::{crash, log};

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Folders of designs and design files to open
    #[arg(value_name = "DIR or FILE.toml")]
    paths: Vec<PathBuf>,
    /// Draw with ASCII characters only
    #[arg(long)]
    ascii: bool,
    #[command(flatten)]
    keys: KeysArg,
    /// Add what happens to a log file, a line each with the time: for bug reports
    #[arg(long, value_name = "FILE")]
    log: Option<PathBuf>,
}

pub fn run(args: &Args) -> Result<(), CommandError> {
    let mut notice = None;
    let paths = if args.paths.is_empty() {
        let folder = library::default_folder().map_err(|error| CommandError::Usage(error.to_string()))?;
        let shown = printable(&folder.path.display().to_string()).into_owned();
        notice = folder.is_new.then(|| format!("new: {shown}, with the shipped designs"));
        vec![folder.path]
    } else {
        args.paths.clone()
    };
    if let Some(missing) = paths.iter().find(|path| !path.exists()) {
        return Err(CommandError::Usage(no_such(missing)));
    }
    let log = args.log.as_deref().map(log::open).transpose().map_err(|error| CommandError::Usage(error.to_string()))?;
    let terminal = facts::facts(args.ascii, |name| std::env::var(name).ok());
    crash::describe_terminal(facts::as_text(&terminal));
    if log.is_some() {
        log::write(format_args!("start of bevelscope {}, {}", env!("CARGO_PKG_VERSION"), super::doctor::platform()));
        facts::as_text(&terminal).lines().for_each(log::write);
    }
    let ended = explore(args, paths, notice);
    log::write(ended.as_ref().map_or_else(|error| format!("end: {error}"), |()| "end".into()));
    ended
}

fn explore(args: &Args, paths: Vec<PathBuf>, notice: Option<String>) -> Result<(), CommandError> {
    let shown_as: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
    let (keys, keys_report) = args.keys.for_explorer()?;
    let options = tui::Options { ascii: args.ascii, keys, keys_report, notice };
    let files = library::files(&paths);
    Ok(tui::run(files, shown_as.join(" "), options, Arc::new(Files::new(paths)))?)
}

/// The argument may be a mistyped command.
fn no_such(path: &Path) -> String {
    const ALIKE: f64 = 0.6;
    let shown = path.display().to_string();
    let cli = super::Cli::command();
    // what follows an option is a file to clap
    if cli.get_subcommands().any(|command| command.get_name() == shown) {
        return format!("`{shown}` is a command: it comes first, its options after it (bevelscope {shown} ...)");
    }
    let alike = |command: &&str| strsim::normalized_damerau_levenshtein(&shown, command) >= ALIKE;
    let hint = cli.get_subcommands().map(clap::Command::get_name).find(alike);
    let hint = hint.map(|command| format!("; did you mean the command `{command}`?")).unwrap_or_default();
    let what =
        if shown == "-" { "the explorer opens files, not standard input" } else { "there is no such file or folder" };
    format!("{}: {what}{hint}", printable(&shown))
}

/// Designs from disk, solved here.
#[derive(Debug)]
pub struct Files {
    /// The folders and files of the library. A file that is named here follows its renaming.
    paths: Mutex<Vec<PathBuf>>,
    guard: Guard,
}

impl Files {
    /// Of folders and design files.
    pub fn new(paths: Vec<PathBuf>) -> Self {
        Self { paths: Mutex::new(paths), guard: Guard::new() }
    }

    fn paths(&self) -> Vec<PathBuf> {
        self.paths.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Brings the list of files in line with what was done; in folders it shows by itself.
    fn follow(&self, done: &FileDone) {
        let mut paths = self.paths.lock().unwrap_or_else(PoisonError::into_inner);
        let place = |paths: &[PathBuf], path: &Path| paths.iter().position(|other| other == path);
        match done {
            FileDone::Renamed { from, to, .. } => {
                if let Some(at) = place(&paths, from) {
                    paths[at].clone_from(to);
                }
            }
            FileDone::Duplicated { from, to } => {
                if let Some(at) = place(&paths, from) {
                    paths.insert(at + 1, to.clone());
                }
            }
            FileDone::Deleted { path, .. } => paths.retain(|other| other != path),
            FileDone::Restored { path } | FileDone::Created { path } => {
                let listed = paths.iter().any(|other| path == other || path.parent() == Some(other));
                if !listed {
                    paths.push(path.clone());
                }
            }
        }
    }

    /// Where a new design goes: beside that one, else into the first folder.
    fn folder(&self, beside: Option<&Path>) -> PathBuf {
        let of = |path: &Path| path.parent().unwrap_or(Path::new("")).to_owned();
        let first = || self.paths().into_iter().next().unwrap_or_default();
        beside.map_or_else(|| Some(first()).filter(|path| path.is_dir()).unwrap_or_else(|| of(&first())), of)
    }

    /// What was deleted last from the folders of the library.
    fn deleted_last(&self) -> Option<Trashed> {
        let mut folders: Vec<PathBuf> = Vec::new();
        for path in self.paths() {
            let folder = if path.is_dir() { path } else { path.parent().unwrap_or(Path::new("")).into() };
            if !folders.contains(&folder) {
                folders.push(folder);
            }
        }
        // the first one of each folder is its latest
        let latest = folders.iter().filter_map(|folder| trashed(folder).into_iter().next());
        latest.max_by(|one, other| one.when.cmp(&other.when))
    }
}

/// Brings the variants of a design that was renamed after it.
fn followed(path: &Path, name: &library::VariantName) -> Vec<Followed> {
    let (folder, stem) = (path.parent().unwrap_or(Path::new("")), path.file_stem().unwrap_or_default());
    let variants = library::follow_parent(folder, &stem.to_string_lossy(), name).into_iter();
    variants.map(|(path, result)| Followed { path, result: result.map_err(|error| error.to_string()) }).collect()
}

/// The message without the library's folders: there is little room, and the header names them.
fn without_folders(message: &str, paths: &[PathBuf]) -> String {
    let folders = paths.iter().flat_map(|path| [Some(path.as_path()), path.parent()]).flatten();
    let folders = folders.filter(|folder| !folder.as_os_str().is_empty());
    folders.fold(message.to_owned(), |message, folder| {
        let folder = format!("{}{}", folder.display(), std::path::MAIN_SEPARATOR);
        message.strip_prefix(&*printable(&folder)).map_or(message.clone(), str::to_owned)
    })
}

impl Backend for Files {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        match design::load(path) {
            Ok(loaded) => {
                let warnings = loaded.sentences();
                let hash = Some(design::hash(loaded.text.as_bytes()));
                Ok(LoadedDesign { warnings, design: loaded.design, hash })
            }
            Err(error) => Err(BrokenDesign { one_line: error.reason(), full_text: error.to_string() }),
        }
    }

    fn compare(&self, design: &design::Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        comparison::compare_over(design, None, observer)
    }

    fn compare_edited(
        &self,
        design: &design::Design,
        rotors: &mut Option<Rotors>,
        observer: &mut Observer<'_>,
    ) -> Result<Comparison, SolveError> {
        let rotors = rotors.insert(Rotors::reusing(design, rotors.as_ref())?);
        comparison::compare_rotors(design, rotors, None, observer)
    }

    fn read(&self, path: &Path) -> Result<String, String> {
        match design::load(path) {
            Ok(loaded) => Ok(loaded.text),
            Err(LoadError::Invalid { text, .. }) => Ok(text),
            Err(error) => Err(error.reason()),
        }
    }

    fn save(&self, path: &Path, expected: Option<&[u8]>, text: &str) -> Result<(), NotSaved> {
        self.guard.save(path, expected, text)
    }

    fn keep(&self, change: &Kept) -> Result<(), String> {
        self.guard.keep(change)
    }

    fn left(&self) -> Left {
        self.guard.left(&self.paths())
    }

    fn look(&self, path: &Path, expected: &str) -> Look {
        self.guard.look(path, expected)
    }

    fn release(&self, path: &Path) {
        self.guard.release(path);
    }

    fn save_variant(
        &self,
        original: &Path,
        name: &library::VariantName,
        text: &str,
        note: Option<&str>,
    ) -> Result<(PathBuf, String), String> {
        let folder = original.parent().unwrap_or(Path::new(""));
        let parent = original.file_stem().map(|stem| stem.to_string_lossy());
        let about = library::About { design_name: None, parent: parent.as_deref(), note };
        library::save_variant(folder, name, text, about).map_err(|error| error.to_string())
    }

    fn export(&self, path: &Path, document: &Document) -> Result<PathBuf, String> {
        super::export::shown(path, document)
    }

    fn export_design(&self, path: &Path, design: &Path, text: Option<&str>) -> Result<PathBuf, String> {
        super::export::design(path, design, text)
    }

    fn mesh_table(&self, path: &Path) -> Result<Vec<AveragedMesh>, String> {
        super::import_mesh::flanks(path)
    }

    fn list(&self) -> Option<Result<Vec<PathBuf>, String>> {
        Some(Ok(library::files(&self.paths())))
    }

    fn change_file(&self, request: &FileRequest) -> Result<FileDone, String> {
        let done = match request {
            FileRequest::Rename { path, name } => library::rename(path, name).map(|to| FileDone::Renamed {
                from: path.clone(),
                to,
                variants: followed(path, name),
            }),
            FileRequest::Duplicate { path, name } => {
                library::duplicate(path, name).map(|to| FileDone::Duplicated { from: path.clone(), to })
            }
            FileRequest::Create { beside, name, text } => {
                let path = name.path_in(&self.folder(beside.as_deref()));
                design::save_new(&path, text).map(|()| FileDone::Created { path })
            }
            FileRequest::Delete { path } => {
                library::delete(path).map(|trashed| FileDone::Deleted { path: path.clone(), trashed })
            }
            FileRequest::Restore(trashed) => {
                let trashed = trashed.clone().or_else(|| self.deleted_last()).ok_or("nothing was deleted here")?;
                library::restore(&trashed).map(|path| FileDone::Restored { path })
            }
        };
        let done = done.map_err(|error| without_folders(&error.to_string(), &self.paths()))?;
        self.follow(&done);
        Ok(done)
    }

    fn differences(&self, a: &Path, b: &Path) -> Result<Vec<Difference>, String> {
        let text = |path| design::load(path).map(|loaded| loaded.text).map_err(|error| error.to_string());
        Ok(design::diff(&text(a)?, &text(b)?))
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn variants_follow_a_renamed_design_on_disk_and_in_what_is_told() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        let text = library::SHIPPED[0].text;
        fs::write(path("base.toml"), text).unwrap();
        fs::write(path("child.toml"), format!("parent = \"base\"\n{text}")).unwrap();
        let files = Files::new(vec![folder.path().into()]);
        let name = library::VariantName::new("mother").unwrap();
        let done = files.change_file(&FileRequest::Rename { path: path("base.toml"), name }).unwrap();
        let now = format!("parent = \"mother\"\n{text}");
        let variants = vec![Followed { path: path("child.toml"), result: Ok(now.clone()) }];
        assert_eq!(done, FileDone::Renamed { from: path("base.toml"), to: path("mother.toml"), variants });
        assert_eq!(fs::read_to_string(path("child.toml")).unwrap(), now);
    }
}
