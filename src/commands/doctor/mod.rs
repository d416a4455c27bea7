//! `bevelscope doctor`: what the program sees of its surroundings, for bug reports.

mod folders;
mod in_use;

use std::io::Write;

use serde_json::{Map, Value};

use super::keys::KeysArg;
use super::{CommandError, Format, Status};
use crate::report::json;
use crate::text::{printable, wrap};
use crate::tui::facts;

/// Columns of the table.
const WIDTH: usize = 80;
/// Columns of the names in it.
const NAMES: usize = 22;

#[derive(Debug, clap::Args)]
pub struct Args {
    /// As with the explorer: only ASCII characters
    #[arg(long)]
    ascii: bool,
    #[command(flatten)]
    keys: KeysArg,
    /// Output format
    #[arg(long, value_enum, default_value_t = Format::Table)]
    format: Format,
}

/// What belongs together.
struct Section {
    title: &'static str,
    rows: Vec<(String, String)>,
}

/// Operating system and processor.
pub fn platform() -> String {
    format!("{} {}", std::env::consts::OS, std::env::consts::ARCH)
}

pub fn run(args: &Args, out: &mut impl Write) -> Result<Status, CommandError> {
    // what is not UTF-8 is told with what it is not
    let variable = |name: &str| std::env::var_os(name).map(|value| value.to_string_lossy().into_owned());
    let terminal = facts::facts(args.ascii, variable);
    let program = std::env::current_exe().map_or_else(|error| error.to_string(), |path| path.display().to_string());
    let sections = [
        Section {
            title: "program",
            rows: vec![
                ("version".into(), env!("CARGO_PKG_VERSION").into()),
                ("platform".into(), platform()),
                ("file".into(), program),
            ],
        },
        Section {
            title: "terminal",
            rows: terminal.into_iter().map(|(name, value)| (name.to_owned(), value)).collect(),
        },
        Section { title: "folders", rows: folders::rows(&args.keys) },
        Section { title: "designs in use", rows: in_use::rows() },
    ];
    match args.format {
        Format::Table => write_table(&sections, out)?,
        Format::Json => write_json(&sections, out)?,
    }
    Ok(Status::Success)
}

fn write_table(sections: &[Section], out: &mut impl Write) -> std::io::Result<()> {
    for (at, section) in sections.iter().enumerate() {
        if at > 0 {
            writeln!(out)?;
        }
        writeln!(out, "{}", section.title)?;
        for (name, value) in &section.rows {
            let value = printable(value);
            let mut lines = wrap(&value, WIDTH - NAMES - 2);
            if lines.is_empty() {
                lines.push(String::new());
            }
            for (line, text) in lines.iter().enumerate() {
                let name = if line == 0 { name } else { "" };
                writeln!(out, "  {:<NAMES$}{text}", printable(name))?;
            }
        }
    }
    Ok(())
}

fn write_json(sections: &[Section], out: &mut impl Write) -> Result<(), CommandError> {
    let of = |section: &Section| {
        let key = |name: &str| name.replace(' ', "_");
        let rows: Map<String, Value> =
            section.rows.iter().map(|(name, value)| (key(name), Value::String(value.clone()))).collect();
        (key(section.title), Value::Object(rows))
    };
    let all = Value::Object(sections.iter().map(of).collect());
    json::write(out, &all)?;
    Ok(())
}
