//! Arguments, command, exit status.

use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

use bevelscope::commands::Cli;
use clap::Parser;

fn main() -> ExitCode {
    let cli = Cli::parse();
    match cli.run(BufWriter::new(io::stdout().lock()), io::stderr()) {
        Ok(status) => status.code().into(),
        Err(error) if error.is_closed_pipe() => ExitCode::SUCCESS,
        Err(error) => {
            // nobody may be there to read it
            let _ = writeln!(io::stderr(), "{error}");
            error.code().into()
        }
    }
}
