//! Design files named on the command line.

use std::io::Write;
use std::path::Path;

use super::CommandError;
use crate::design::{self, Loaded};

/// Reads a design file, or standard input for `-`; its warnings go to `err`.
pub fn load(path: &Path, err: &mut impl Write) -> Result<Loaded, CommandError> {
    let loaded = design::load(path)?;
    // a result is worth more than its warnings: stderr may be closed or full
    let _ = write!(err, "{}", loaded.render_warnings());
    Ok(loaded)
}
