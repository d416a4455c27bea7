//! The command line: one file a subcommand.

mod bands;
mod check;
mod compare;
mod doctor;
mod explore;
mod export;
mod guard;
mod import_mesh;
mod input;
mod inspect;
mod keys;
mod mesh_stiffness;
mod modes;
mod new;
mod report;
mod solve;

use std::io::{self, Write};
use std::path::PathBuf;

pub use explore::Files;

use clap::{Parser, Subcommand, ValueEnum};

use crate::comparison::SolveError;
use crate::design::LoadError;
use crate::model::ModelKind;
use crate::text::printable;
use crate::tui::TuiError;

/// Explore spiral bevel geared rotor designs: dynamic finite element and lumped models side by side.
///
/// Without a subcommand the terminal explorer opens on the given folders and design files; by default on `designs` in the
/// current folder, else on the library in the user's data folder.
#[derive(Debug, Parser)]
#[command(name = "bevelscope", version, args_conflicts_with_subcommands = true)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    #[command(flatten)]
    explore: explore::Args,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Dynamic mesh force and transmission error over the frequency lines
    Solve(solve::Args),
    /// Natural frequencies with the mesh, kinetic-energy shares, and which modes pair up
    Modes(modes::Args),
    /// How well the lumped models agree with the finite element model, a row a design
    Check(check::Args),
    /// Where a lumped model disagrees with the finite element model, the modes behind it, and why
    Bands(bands::Args),
    /// What was built: stations, totals, stiffness at the mesh, bending modes, effective masses, bearings
    Inspect(inspect::Args),
    /// A page to read, print and keep: spectra, bands with reasons, peaks, modes, side view, tables
    Report(report::Args),
    /// Where two designs differ, and how the models of both agree
    Compare(compare::Args),
    /// A new design from a few wishes: a complete commented file that solves at once
    New(Box<new::Args>),
    /// Estimate a mean mesh stiffness from the effective face width (ISO 10300-1, method B)
    MeshStiffness(mesh_stiffness::Args),
    ImportMesh(import_mesh::Args),
    /// The keys of the explorer, with those of the user's file
    Keys(keys::Args),
    /// What the program sees of terminal, folders and designs in use: for bug reports
    Doctor(doctor::Args),
}

/// How a program that did its work ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Status {
    Success,
    /// `check` found a design outside a limit
    OutsideLimits,
    /// Some of the input was bad, and has been reported
    BadInput,
}

impl Status {
    /// Exit status of the process.
    pub fn code(self) -> u8 {
        match self {
            Self::Success => 0,
            Self::OutsideLimits => 1,
            Self::BadInput => 2,
        }
    }
}

/// Why a command came to nothing. The texts are ready to be shown: nothing in them steers a terminal.
#[derive(Debug, thiserror::Error)]
pub enum CommandError {
    #[error(transparent)]
    Load(#[from] LoadError),
    #[error("{}: error: {error}", printable(name))]
    Solve { name: String, error: SolveError },
    #[error("error: {0}")]
    Usage(String),
    #[error("error: cannot write the output: {0}")]
    Output(#[from] io::Error),
    #[error("bevelscope: {0}")]
    Explorer(#[from] TuiError),
}

impl CommandError {
    /// The reader of our output has gone: nothing to say, and nobody to say it to.
    pub fn is_closed_pipe(&self) -> bool {
        matches!(self, Self::Output(error) if error.kind() == io::ErrorKind::BrokenPipe)
    }

    /// Exit status of the process.
    pub fn code(&self) -> u8 {
        match self {
            Self::Explorer(error) => error.exit_status(),
            _ => Status::BadInput.code(),
        }
    }
}

impl Cli {
    /// Carries the command out; results go to `out`, warnings to `err`.
    ///
    /// # Errors
    ///
    /// [`CommandError`], with nothing on `out` but what was already complete.
    pub fn run(&self, mut out: impl Write, mut err: impl Write) -> Result<Status, CommandError> {
        let status = match &self.command {
            None => {
                explore::run(&self.explore)?;
                Status::Success
            }
            Some(Command::Solve(args)) => solve::run(args, &mut out, &mut err)?,
            Some(Command::Modes(args)) => modes::run(args, &mut out, &mut err)?,
            Some(Command::Check(args)) => check::run(args, &mut out)?,
            Some(Command::Bands(args)) => bands::run(args, &mut out, &mut err)?,
            Some(Command::Inspect(args)) => inspect::run(args, &mut out, &mut err)?,
            Some(Command::Report(args)) => report::run(args, &mut out, &mut err)?,
            Some(Command::Compare(args)) => compare::run(args, &mut out, &mut err)?,
            Some(Command::New(args)) => new::run(args, &mut out)?,
            Some(Command::MeshStiffness(args)) => mesh_stiffness::run(args, &mut out)?,
            Some(Command::ImportMesh(args)) => import_mesh::run(args, &mut out, &mut err)?,
            Some(Command::Keys(args)) => keys::run(args, &mut out, &mut err)?,
            Some(Command::Doctor(args)) => doctor::run(args, &mut out)?,
        };
        out.flush()?;
        Ok(status)
    }
}

/// Formats of results that are no plain list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// Aligned, for reading
    Table,
    /// One JSON value, full precision
    Json,
}

/// The design file of a command.
#[derive(Debug, clap::Args)]
struct FileArg {
    /// Design file, or - for standard input
    file: PathBuf,
}

/// The models of a command.
#[derive(Debug, clap::Args)]
struct ModelArg {
    /// Models, separated by commas, in the order of the output: fe, enhanced, basic, reduced:K (each rotor with its K lowest
    /// fixed-interface modes)
    #[arg(long, value_delimiter = ',', default_value = "fe,enhanced,basic")]
    model: Vec<ModelKind>,
}

impl ModelArg {
    /// Each named model once.
    fn kinds(&self) -> Vec<ModelKind> {
        let mut kinds: Vec<ModelKind> = Vec::new();
        for kind in &self.model {
            if !kinds.contains(kind) {
                kinds.push(*kind);
            }
        }
        kinds
    }
}
