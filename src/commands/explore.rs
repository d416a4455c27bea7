//! `bevelscope` without a subcommand: the terminal explorer.

use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::CommandError;
use crate::comparison::{self, Comparison, Observer, SolveError};
use crate::design::{self, LoadError, library};
use crate::text::printable;
use crate::tui::{self, Backend, BrokenDesign, LoadedDesign, NotSaved};

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Folders of designs and design files to open
    #[arg(value_name = "DIR or FILE.toml")]
    paths: Vec<PathBuf>,
    /// Draw with ASCII characters only
    #[arg(long)]
    ascii: bool,
}

pub fn run(args: &Args) -> Result<(), CommandError> {
    let paths = if args.paths.is_empty() {
        vec![library::default_folder().map_err(|error| CommandError::Usage(error.to_string()))?]
    } else {
        args.paths.clone()
    };
    if let Some(missing) = paths.iter().find(|path| !path.exists()) {
        return Err(CommandError::Usage(no_such(missing)));
    }
    let shown_as: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
    let options = tui::Options { ascii: args.ascii };
    let files = library::files(&paths);
    Ok(tui::run(files, shown_as.join(" "), options, Arc::new(Files { paths }))?)
}

/// The argument may be a mistyped command.
fn no_such(path: &Path) -> String {
    const ALIKE: f64 = 0.6;
    let shown = path.display().to_string();
    let commands = ["solve", "modes", "check", "inspect"];
    let alike = |command: &&str| strsim::normalized_damerau_levenshtein(&shown, command) >= ALIKE;
    let hint = commands.into_iter().find(alike);
    let hint = hint.map(|command| format!("; did you mean the command `{command}`?")).unwrap_or_default();
    let what =
        if shown == "-" { "the explorer opens files, not standard input" } else { "there is no such file or folder" };
    format!("{}: {what}{hint}", printable(&shown))
}

/// Designs from disk, solved here.
struct Files {
    paths: Vec<PathBuf>,
}

impl Backend for Files {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        match design::load(path) {
            Ok(loaded) => {
                let warnings = loaded.render_warnings().lines().map(str::to_owned).collect();
                Ok(LoadedDesign { warnings, design: loaded.design })
            }
            Err(error) => Err(BrokenDesign { one_line: error.reason(), full_text: error.to_string() }),
        }
    }

    fn compare(&self, design: &design::Design, observer: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        comparison::compare_over(design, None, observer)
    }

    fn read(&self, path: &Path) -> Result<String, String> {
        match design::load(path) {
            Ok(loaded) => Ok(loaded.text),
            Err(LoadError::Invalid { text, .. }) => Ok(text),
            Err(error) => Err(error.reason()),
        }
    }

    fn save(&self, path: &Path, expected: &str, text: &str) -> Result<(), NotSaved> {
        match fs::read(path) {
            Ok(bytes) if bytes == expected.as_bytes() => {}
            Ok(_) => return Err(NotSaved::Changed),
            Err(error) if error.kind() == ErrorKind::NotFound => return Err(NotSaved::Changed),
            Err(error) => return Err(NotSaved::Failed(error.to_string())),
        }
        design::save(path, text).map_err(|error| NotSaved::Failed(error.to_string()))
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

    fn list(&self) -> Option<Result<Vec<PathBuf>, String>> {
        Some(Ok(library::files(&self.paths)))
    }
}
