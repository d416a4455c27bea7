//! What comes in, as lines of the log: paths, names and durations, nothing of what a design says.

use super::files::FileDone;
use super::message::Message;
use crate::log;

/// Writes a line about a message that is worth one.
pub(super) fn record(message: &Message) {
    if log::is_open()
        && let Some(line) = line(message)
    {
        log::write(line);
    }
}

fn line(message: &Message) -> Option<String> {
    let line = match message {
        Message::Key(_)
        | Message::Paste(_)
        | Message::Progress { .. }
        | Message::Looked { .. }
        | Message::Spectra { .. }
        | Message::Listed(Ok(_)) => return None,
        Message::Resized => "the terminal has another size".into(),
        Message::Loaded { path, result, .. } => match result {
            Ok(_) => format!("read {}", path.display()),
            Err(broken) => format!("cannot read {}: {}", path.display(), broken.one_line),
        },
        Message::Solved { path, result, .. } | Message::SolvedEdited { path, result, .. } => match result {
            Ok(solved) => {
                format!("solved {} in {:.1} ms", path.display(), solved.summary.elapsed.as_secs_f64() * 1e3)
            }
            Err(error) => format!("cannot solve {}: {error}", path.display()),
        },
        Message::Opened { path, result } => match result {
            Ok(_) => format!("opened {}", path.display()),
            Err(error) => format!("cannot open {}: {error}", path.display()),
        },
        Message::Saved { path, result, .. } => match result {
            Ok(()) => format!("saved {}", path.display()),
            Err(error) => format!("cannot save {}: {error}", path.display()),
        },
        Message::VariantSaved { original, result } => match result {
            Ok((path, _)) => format!("saved {} as a variant of {}", path.display(), original.display()),
            Err(error) => format!("cannot save a variant of {}: {error}", original.display()),
        },
        Message::Left(left) if left.edits.is_empty() && left.damaged.is_empty() => return None,
        Message::Left(left) => {
            format!(
                "unsaved edits of {} designs were left, {} journals are damaged",
                left.edits.len(),
                left.damaged.len()
            )
        }
        Message::Protected(Ok(())) => "unsaved edits are kept in journals".into(),
        Message::Protected(Err(error)) => format!("unsaved edits cannot be kept in journals: {error}"),
        Message::NotTidied(error) => format!("cannot put away edits that nobody needs: {error}"),
        Message::Listed(Err(error)) => format!("cannot list the designs: {error}"),
        Message::FileChanged { request, result } => match result {
            Ok(done) => changed(done),
            Err(error) => format!("failed: {request:?}: {error}"),
        },
        Message::Compared { result, .. } => match &result.differences {
            Ok(differences) => format!("compared two designs: {} differences", differences.len()),
            Err(error) => format!("cannot compare two designs: {error}"),
        },
        Message::MeshTable { result: Ok(_), .. } => "read a table of mesh numbers".into(),
        Message::MeshTable { result: Err(error), .. } => format!("cannot read a table of mesh numbers: {error}"),
        Message::Exported(Ok(path)) => format!("wrote {}", path.display()),
        Message::Exported(Err(error)) => format!("cannot write: {error}"),
        Message::ModesFound { result: Ok(_), .. } => "computed modes or a deflection shape".into(),
        Message::ModesFound { result: Err(error), .. } => format!("cannot compute modes: {error}"),
        Message::Suspend => "asked to suspend".into(),
        Message::Continued => "continued".into(),
        Message::Signal(number) => format!("signal {number}"),
        Message::TerminalGone => "the terminal is gone".into(),
    };
    Some(line)
}

fn changed(done: &FileDone) -> String {
    match done {
        FileDone::Renamed { from, to, variants } => {
            let follow = variants.iter().filter(|variant| variant.result.is_ok()).count();
            format!("renamed {} to {}, {follow} of {} variants follow", from.display(), to.display(), variants.len())
        }
        FileDone::Created { path } => format!("wrote {}", path.display()),
        FileDone::Duplicated { from, to } => format!("copied {} to {}", from.display(), to.display()),
        FileDone::Deleted { path, .. } => format!("deleted {}", path.display()),
        FileDone::Restored { path } => format!("{} is back", path.display()),
    }
}
