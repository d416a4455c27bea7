//! What is said beside a value or a header.

use super::splice::Splice;
use super::statement::Kind;
use super::view::View;
use crate::design::KeyPath;

/// Puts a comment at the end of the line of a value or header, in place of the comment there and of those right above it: they spoke of what was
/// there before. The comment at the very start of a file is the file's own. Nothing for what has no line of its own.
pub(super) fn comment(view: &View<'_>, path: &KeyPath, text: &str) -> Vec<Splice> {
    let place = view
        .statements
        .iter()
        .position(|statement| (statement.is_pair() || statement.is_header()) && statement.address == *path);
    let Some((place, statement)) = place.map(|place| (place, &view.statements[place])) else { return Vec::new() };
    let end = match &statement.kind {
        Kind::Pair { value, .. } => value.end,
        Kind::Header { parts } => {
            let from = parts.last().map_or(statement.lines.start, |part| part.span.end);
            let rest = &view.text[from..statement.lines.end];
            from + rest.split('#').next().unwrap_or(rest).trim_end().len()
        }
        Kind::Empty | Kind::Comment => return Vec::new(),
    };
    let mut splices = vec![Splice::new(end..statement.lines.end, format!("  # {text}"))];
    let lead = view.lead(place);
    if (1..place).contains(&lead) {
        splices.push(Splice::remove(view.statements[lead].lines.start..statement.lines.start));
    }
    splices
}
