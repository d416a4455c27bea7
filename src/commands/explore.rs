//! `bevelscope` without a subcommand: the terminal explorer.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::CommandError;
use crate::comparison::{self, Comparison, SolveError};
use crate::design::{self, library};
use crate::text::printable;
use crate::tui::{self, Backend, BrokenDesign, LoadedDesign};

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
        let shown = missing.display().to_string();
        return Err(CommandError::Usage(format!("{}: there is no such file or folder", printable(&shown))));
    }
    let shown_as: Vec<String> = paths.iter().map(|path| path.display().to_string()).collect();
    let options = tui::Options { ascii: args.ascii };
    let files = library::files(&paths);
    Ok(tui::run(files, shown_as.join(" "), options, Arc::new(Files { paths }))?)
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

    fn compare(&self, design: &design::Design) -> Result<Comparison, SolveError> {
        comparison::compare(design)
    }

    fn list(&self) -> Option<Result<Vec<PathBuf>, String>> {
        Some(Ok(library::files(&self.paths)))
    }
}
