//! Giving a key another name, wherever it is written.

use super::splice::Splice;
use super::statement::Kind;
use super::view::View;
use super::{EditError, toml_key};
use crate::design::KeyPath;
use crate::design::key_path::Step;

/// Renames the last key of the path: in headers, before dots, in inline tables.
pub(super) fn rename(view: &View<'_>, path: &KeyPath, name: &str) -> Result<Vec<Splice>, EditError> {
    let Some((around, Step::Key(_))) = path.split_last() else { return Err(EditError::NoPlace(path.clone())) };
    let name = toml_key(name);
    if let Some((items, place)) = view.container(path) {
        return Ok(items.entries[place].parts.iter().map(|part| Splice::new(part.span.clone(), &name)).collect());
    }
    let depth = around.steps().len();
    let mut splices = Vec::new();
    for statement in view.statements.iter().filter(|statement| statement.address.starts_with(path)) {
        let (parts, above) = match &statement.kind {
            // places are steps of the address but no keys of a header
            Kind::Header { parts } => {
                let places = |steps: &[Step]| steps.iter().filter(|step| !matches!(step, Step::Key(_))).count();
                (parts, places(around.steps()))
            }
            Kind::Pair { parts, above, .. } => (parts, *above),
            _ => continue,
        };
        if let Some(part) = depth.checked_sub(above).and_then(|at| parts.get(at)) {
            splices.push(Splice::new(part.span.clone(), &name));
        }
    }
    if splices.is_empty() { Err(EditError::NotThere(path.clone())) } else { Ok(splices) }
}
