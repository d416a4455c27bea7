//! Taking keys and tables out.

use super::EditError;
use super::scan::Scanner;
use super::splice::Splice;
use super::view::{Spot, View};
use crate::design::KeyPath;
use std::ops::Range;

/// Takes out whatever is written at the path and below it.
pub(super) fn take(view: &View<'_>, path: &KeyPath) -> Result<Vec<Splice>, EditError> {
    if let Some((items, place)) = view.container(path) {
        return Ok(items.remove(place));
    }
    match view.find(path) {
        Spot::Missing => Err(EditError::NotThere(path.clone())),
        Spot::Root | Spot::InlineDotted => Err(EditError::NoPlace(path.clone())),
        _ => Ok(blocks(view, path).into_iter().map(|block| Splice::remove(with_break(view, block))).collect()),
    }
}

/// The statements that are about the path or below it, as few blocks as there are.
fn blocks(view: &View<'_>, path: &KeyPath) -> Vec<Range<usize>> {
    let mut blocks = Vec::new();
    let mut next = 0;
    while next < view.statements.len() {
        let statement = &view.statements[next];
        let concerned = statement.address.starts_with(path);
        if concerned && statement.is_header() {
            let section = view.section(Some(next), path);
            blocks.push(view.lead(next)..view.content(&section));
            next = section.end;
        } else {
            if concerned && statement.is_pair() {
                blocks.push(next..next + 1);
            }
            next += 1;
        }
    }
    blocks
}

/// The bytes of the statements with the line breaks and empty lines that would be left over.
pub(super) fn with_break(view: &View<'_>, block: Range<usize>) -> Range<usize> {
    let Range { start, mut end } = view.bytes(block.clone());
    let is_empty = |statement: usize| view.statements.get(statement).is_some_and(super::statement::Statement::is_empty);
    let above = view.statements[..block.start].iter().rev().take_while(|statement| statement.is_empty()).count();
    let mut after = block.end;
    while is_empty(after) {
        after += 1;
    }
    let is_section = view.statements[block.clone()].iter().any(super::statement::Statement::is_header);
    if after == view.statements.len() && is_section && block.start > above {
        // nothing follows: the line break before it goes, the one at the very end stays
        let before = view.statements[block.start - above - 1].lines.end;
        return before..end;
    }
    if is_section && (above > 0 || block.start == 0) {
        end = view.bytes(block.start..after).end;
    }
    let mut scanner = Scanner::new(view.text, end);
    scanner.skip_break();
    start..scanner.at
}
