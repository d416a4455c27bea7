//! Where the schema wants a key or a table: new ones go behind those that come before them there.

use crate::design::KeyPath;
use crate::design::key_path::Step;
use crate::design::schema::{Field, Kind, ROOT, Table};

/// What the schema does not know comes last.
pub(super) const UNKNOWN: usize = usize::MAX;

/// The place of a key among those of its table.
pub(super) fn of_key(table: Option<&'static Table>, key: &str) -> usize {
    table.and_then(|table| table.all_fields().position(|field| field.key == key)).unwrap_or(UNKNOWN)
}

/// The schema of the table at a path.
pub(super) fn table(path: &KeyPath) -> Option<&'static Table> {
    walk(path).1
}

/// The place of a table among all of a file: compared step by step, parents first.
pub(super) fn of_table(path: &KeyPath) -> Vec<usize> {
    walk(path).0
}

fn walk(path: &KeyPath) -> (Vec<usize>, Option<&'static Table>) {
    let mut order = Vec::new();
    let (mut table, mut named) = (Some(ROOT), false);
    for step in path.steps() {
        match step {
            // every material stands beside the others
            Step::Key(_) if named => named = false,
            Step::Key(key) => {
                order.push(of_key(table, key));
                let field = table.and_then(|table| table.all_fields().find(|field| field.key == *key));
                named = matches!(field, Some(Field { kind: Kind::NamedTables(_), .. }));
                table = field.and_then(|field| match field.kind {
                    Kind::Table(table) | Kind::Tables(table, _) | Kind::NamedTables(table) => Some(table),
                    _ => None,
                });
                if table.is_none() {
                    return (order, None);
                }
            }
            Step::Place(place) => order.push(*place),
            Step::Name(_) => {}
        }
    }
    (order, table.filter(|_| !named))
}
