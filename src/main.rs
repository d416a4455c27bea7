//! Arguments, command, exit status.

use std::io::{self, BufWriter, Write};
use std::process::ExitCode;

use bevelscope::commands::Cli;
use bevelscope::crash;
use bevelscope::text::printable;
use clap::Parser;

fn main() -> ExitCode {
    crash::install();
    let cli = match parse() {
        Ok(cli) => cli,
        Err(status) => return status,
    };
    // not locked for the whole run: where the explorer hangs in a write, a signal must still get the terminal back
    match cli.run(BufWriter::new(io::stdout()), io::stderr()) {
        Ok(status) => status.code().into(),
        Err(error) if error.is_closed_pipe() => ExitCode::SUCCESS,
        Err(error) => {
            // nobody may be there to read it
            let _ = writeln!(io::stderr(), "{error}");
            error.code().into()
        }
    }
}

/// The arguments; or the exit status after help, version or a message about bad ones.
fn parse() -> Result<Cli, ExitCode> {
    Cli::try_parse().map_err(|error| {
        if !error.use_stderr() {
            // nobody may be there to read it
            let _ = error.print();
            return ExitCode::SUCCESS;
        }
        // arguments are quoted in the message, and a file's name can come in by a wildcard
        for line in error.render().to_string().lines() {
            let _ = writeln!(io::stderr(), "{}", printable(line));
        }
        ExitCode::from(2)
    })
}
