//! Designs that are being edited, and edits that were never saved.

use std::path::Path;

use crate::design::library::{self, Found};

/// A row a design of the default library that somebody has open, and a row a journal of unsaved edits.
pub fn rows() -> Vec<(String, String)> {
    let mut rows = Vec::new();
    let designs = library::default_place(Path::new(""), dirs::data_dir().as_deref()).filter(|folder| folder.is_dir());
    let files = library::files(&designs.into_iter().collect::<Vec<_>>());
    let held: Vec<_> = files.iter().filter_map(|path| library::holder(path).map(|holder| (path, holder))).collect();
    rows.push(("locks".into(), format!("{} of {} designs are open elsewhere", held.len(), files.len())));
    for (at, (path, holder)) in held.iter().enumerate() {
        rows.push((format!("lock {}", at + 1), format!("{} by {holder}", path.display())));
    }
    let Some(folder) = library::recovery_folder() else {
        rows.push(("journals".into(), "this system names no folder for them".into()));
        return rows;
    };
    let found = library::journals(&folder);
    rows.push(("journals".into(), format!("{} in {}", found.len(), folder.display())));
    rows.extend(found.iter().enumerate().map(|(at, found)| (format!("journal {}", at + 1), journal(found))));
    rows
}

fn journal(found: &Found) -> String {
    match &found.journal {
        Ok(journal) => {
            let whose = if found.is_alive { "of a program that runs" } else { "left by a program that ended" };
            let when = crate::moment::readable(journal.when);
            format!("{}, {when}, {whose} (bevelscope {})", journal.design.display(), journal.program)
        }
        Err(error) => format!("{}: {error}", found.path.display()),
    }
}
