//! `bevelscope keys`: the keys of the explorer, with those of the user's file.

use std::io::Write;
use std::path::{Path, PathBuf};

use super::{CommandError, Status};
use crate::design::{self, Source, TextError};
use crate::text::{printable, wrap};
use crate::tui::action::{ACTIONS, Action, Category};
use crate::tui::keymap::{Mode, is_known};
use crate::tui::keys::{self, Keys};

/// Larger files of keys are no files of keys.
const MAX_BYTES: u64 = 1 << 20;

#[derive(Debug, clap::Args)]
pub struct KeysArg {
    /// File of keys, in place of bevelscope/keys.toml in the user's configuration folder
    #[arg(long = "keys", value_name = "FILE")]
    file: Option<PathBuf>,
}

#[derive(Debug, clap::Args)]
pub struct Args {
    #[command(flatten)]
    keys: KeysArg,
    /// Only check a file of keys: exit status 2 where something is wrong with it
    #[arg(long, value_name = "FILE", conflicts_with = "file")]
    check: Option<PathBuf>,
}

/// Keys in force, and what is wrong with the file.
#[derive(Default)]
struct Read {
    keys: Keys,
    /// In full; empty where nothing is wrong
    report: String,
    /// In a few words
    summary: String,
}

impl KeysArg {
    /// The file that was named.
    pub fn named(&self) -> Option<PathBuf> {
        self.file.clone()
    }

    /// The file meant: the one that is named, else the user's, if it is there.
    fn path(&self) -> Option<PathBuf> {
        self.file.clone().or_else(|| {
            let folder = dirs::config_dir()?.join("bevelscope");
            Some(folder.join("keys.toml")).filter(|path| path.exists())
        })
    }

    fn read(&self) -> Result<Read, String> {
        match self.path() {
            Some(path) => read(&path),
            None => Ok(Read::default()),
        }
    }

    /// The keys, and what is wrong with them in a few words and in full. Only a file that was named must be there.
    pub fn for_explorer(&self) -> Result<(Keys, Option<(String, String)>), CommandError> {
        let read = match self.read() {
            Ok(read) => read,
            Err(error) if self.file.is_some() => return Err(CommandError::Usage(error)),
            Err(error) => return Ok((Keys::default(), Some((error.clone(), error)))),
        };
        let key = read.keys.of(Mode::Library, Action::Messages, true).into_iter().next();
        let key = key.unwrap_or_else(|| format!(":{}", Action::Messages.name()));
        let report =
            (!read.report.is_empty()).then(|| (format!("keys ({key} shows all): {}", read.summary), read.report));
        Ok((read.keys, report))
    }
}

fn read(path: &Path) -> Result<Read, String> {
    let name = path.display().to_string();
    let fail = |reason: &dyn std::fmt::Display| format!("{}: {reason}", printable(&name));
    let text = design::read_text(path, MAX_BYTES).map_err(|error| match error {
        TextError::Folder | TextError::TooLarge { .. } => fail(&format!("{error}, not a file of keys")),
        _ => fail(&error),
    })?;
    let remapped = keys::read(&text);
    let source = Source::new(&name, &text);
    let summary = remapped.findings.first().map_or_else(String::new, |first| {
        let line = source.position(first.span.as_ref().map_or(0, |span| span.start)).line;
        let more = remapped.findings.len() - 1;
        let more = if more > 0 { format!(" (and {more} more)") } else { String::new() };
        format!("line {line}: {}{more}", printable(&first.message))
    });
    Ok(Read { report: source.render_all(&remapped.findings), keys: remapped.keys, summary })
}

pub fn run(args: &Args, out: &mut impl Write, err: &mut impl Write) -> Result<Status, CommandError> {
    if let Some(path) = &args.check {
        let read = read(path).map_err(CommandError::Usage)?;
        if read.report.is_empty() {
            writeln!(out, "{}: nothing is wrong with these keys", printable(&path.display().to_string()))?;
            return Ok(Status::Success);
        }
        write!(err, "{}", read.report)?;
        return Ok(Status::BadInput);
    }
    let read = args.keys.read().map_err(CommandError::Usage)?;
    write!(err, "{}", read.report)?;
    write_table(out, &read.keys)?;
    Ok(Status::Success)
}

/// Actions by category, a line for each set of keys; the modes in which they are the same stand together.
fn write_table(out: &mut impl Write, keys: &Keys) -> std::io::Result<()> {
    for (at, category) in Category::ALL.into_iter().enumerate() {
        if at > 0 {
            writeln!(out)?;
        }
        writeln!(out, "{}", category.title())?;
        for about in ACTIONS.iter().filter(|about| about.category == category) {
            for (line, doc) in wrap(about.doc, 61).iter().enumerate() {
                let name = if line == 0 { about.name } else { "" };
                writeln!(out, "  {name:<17}{doc}")?;
            }
            let mut sets: Vec<(String, Vec<&str>)> = Vec::new();
            for mode in Mode::ALL.into_iter().filter(|mode| is_known(*mode, about.action)) {
                let here = keys.of(mode, about.action, true).join(" ");
                match sets.iter_mut().find(|(set, _)| *set == here) {
                    Some((_, modes)) => modes.push(mode.name()),
                    None => sets.push((here, vec![mode.name()])),
                }
            }
            for (set, modes) in sets {
                let set = if set.is_empty() { format!(":{}", about.name) } else { set };
                let modes = if modes.len() == Mode::ALL.len() { "everywhere".into() } else { modes.join(" ") };
                for (line, modes) in wrap(&modes, 39).iter().enumerate() {
                    let set = if line == 0 { set.as_str() } else { "" };
                    writeln!(out, "{:19}{set:<22}{modes}", "")?;
                }
            }
        }
    }
    Ok(())
}
