//! Design files named on the command line.

use std::io::Write;
use std::path::Path;

use super::CommandError;
use crate::comparison::SolveError;
use crate::design::{self, Loaded};
use crate::model::Rotors;
use crate::text::printable;

/// Reads a design file, or standard input for `-`; its warnings go to `err`.
pub fn load(path: &Path, err: &mut impl Write) -> Result<Loaded, CommandError> {
    let loaded = design::load(path)?;
    // a result is worth more than its warnings: stderr may be closed or full
    let _ = write!(err, "{}", loaded.render_warnings());
    Ok(loaded)
}

/// The rotors of a design; what is unusual about the mean states of their bearings goes to `err`.
pub fn rotors(loaded: &Loaded, err: &mut impl Write) -> Result<Rotors, CommandError> {
    let rotors = Rotors::new(&loaded.design).map_err(|error| failed(loaded, error.into()))?;
    let _ = write!(err, "{}", mean_state_warnings(loaded, &rotors));
    Ok(rotors)
}

pub fn failed(loaded: &Loaded, error: SolveError) -> CommandError {
    CommandError::Solve { name: loaded.name.clone(), error }
}

/// A line each, in the form of the file's own warnings; empty if there are none.
pub fn mean_state_warnings(loaded: &Loaded, rotors: &Rotors) -> String {
    let file = printable(&loaded.name);
    let warnings = rotors.mean_state_warnings(&loaded.design).into_iter();
    let lines: Vec<String> = warnings.map(|warning| format!("{file}: warning: {}\n", printable(&warning))).collect();
    lines.concat()
}
