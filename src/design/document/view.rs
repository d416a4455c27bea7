//! A text with its statements and what it says, to find where something stands.

use std::ops::Range;

use super::items::Items;
use super::statement::{Kind, Statement, statements};
use super::tree::Tree;
use crate::design::KeyPath;
use crate::design::key_path::Step;

/// One state of a text.
pub(super) struct View<'t> {
    pub text: &'t str,
    pub statements: Vec<Statement>,
    pub tree: Tree,
}

/// How something is written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Spot {
    /// The whole file
    Root,
    /// In one place, after its key or inside an inline list or table
    Inline(Range<usize>),
    /// Key by key inside an inline table: `{ a.x = 1, a.y = 2 }`
    InlineDotted,
    /// A table with that header
    Header(usize),
    /// Key by key: `a.x = 1`
    Dotted,
    /// A list of tables with headers
    Rows,
    /// A table without header that has tables with headers below it
    Implied,
    Missing,
}

impl<'t> View<'t> {
    pub fn new(text: &'t str, tree: Tree) -> Self {
        Self { text, statements: statements(text), tree }
    }

    /// How the path, by place, is written.
    pub fn find(&self, path: &KeyPath) -> Spot {
        if path.steps().is_empty() {
            return Spot::Root;
        }
        for statement in &self.statements {
            if let Kind::Pair { value, .. } = &statement.kind
                && path.starts_with(&statement.address)
            {
                return self.inside(value.clone(), &path.steps()[statement.address.steps().len()..]);
            }
        }
        if let Some(header) = self.header(path) {
            return Spot::Header(header);
        }
        let steps = path.steps().len();
        let below = || self.statements.iter().filter(|statement| statement.address.starts_with(path));
        if below().any(|statement| matches!(statement.address.steps().get(steps), Some(Step::Place(_)))) {
            return Spot::Rows;
        }
        if below().any(|statement| matches!(statement.kind, Kind::Pair { above, .. } if above < steps)) {
            return Spot::Dotted;
        }
        if below().next().is_some() { Spot::Implied } else { Spot::Missing }
    }

    /// The header of exactly that table.
    pub fn header(&self, path: &KeyPath) -> Option<usize> {
        self.statements.iter().position(|statement| statement.is_header() && statement.address == *path)
    }

    /// Follows the steps through inline lists and tables.
    fn inside(&self, value: Range<usize>, steps: &[Step]) -> Spot {
        let Some(first) = steps.first() else { return Spot::Inline(value) };
        let Some(items) = Items::new(self.text, value) else { return Spot::Missing };
        if let Step::Place(place) = first {
            let item = items.entries.get(*place);
            return item.map_or(Spot::Missing, |item| self.inside(item.value.clone(), &steps[1..]));
        }
        let mut dotted = false;
        for item in &items.entries {
            let same = item.parts.iter().zip(steps).take_while(|(part, step)| part.is(step)).count();
            if !item.parts.is_empty() && same == item.parts.len() {
                return self.inside(item.value.clone(), &steps[same..]);
            }
            dotted |= same == steps.len();
        }
        if dotted { Spot::InlineDotted } else { Spot::Missing }
    }

    /// The inline list or table in which the last step of the path is an item, and its place there.
    pub fn container(&self, path: &KeyPath) -> Option<(Items<'t>, usize)> {
        let (around, last) = path.split_last()?;
        let Spot::Inline(span) = self.find(&around) else { return None };
        let items = Items::new(self.text, span)?;
        let is_last = |parts: &[super::scan::Part]| matches!(parts, [part] if part.is(last));
        let place = match last {
            Step::Place(place) => Some(*place).filter(|place| *place < items.entries.len()),
            _ => items.entries.iter().position(|item| is_last(&item.parts)),
        }?;
        Some((items, place))
    }

    /// The statements from a header, or from the start, to before the next header that is not below `path`.
    pub fn section(&self, header: Option<usize>, path: &KeyPath) -> Range<usize> {
        let first = header.map_or(0, |header| header + 1);
        let below = |s: &Statement| !path.steps().is_empty() && s.address.starts_with(path);
        let next = self.statements[first..].iter().position(|s| s.is_header() && !below(s));
        header.unwrap_or(0)..next.map_or(self.statements.len(), |next| first + next)
    }

    /// The first of the comments right above a statement, or the statement itself.
    pub fn lead(&self, statement: usize) -> usize {
        let above = self.statements[..statement].iter().rev().take_while(|s| s.is_comment()).count();
        statement - above
    }

    /// The end of what belongs to a section: its last key, or its header, and the comments right below that.
    pub fn content(&self, section: &Range<usize>) -> usize {
        let end = if section.end < self.statements.len() { self.lead(section.end) } else { section.end };
        let solid = |s: &Statement| s.is_header() || s.is_pair();
        let last = self.statements[section.start..end].iter().rposition(solid);
        let Some(last) = last.map(|last| section.start + last) else {
            // a file that begins with comments only
            return section.start;
        };
        let comments = self.statements[last + 1..end].iter().take_while(|s| s.is_comment()).count();
        last + 1 + comments
    }

    /// The bytes of these statements, without the last line break.
    pub fn bytes(&self, statements: Range<usize>) -> Range<usize> {
        let start = self.statements.get(statements.start).map_or(self.text.len(), |s| s.lines.start);
        let last = statements.end.checked_sub(1).filter(|last| *last >= statements.start);
        start..last.map_or(start, |last| self.statements[last].lines.end)
    }

    /// Is there an empty line above the statement and its comments?
    pub fn is_apart(&self, statement: usize) -> bool {
        self.lead(statement).checked_sub(1).is_some_and(|above| self.statements[above].is_empty())
    }

    /// Do headers stand apart in this file? The one at the very start does not count.
    pub fn is_airy(&self) -> bool {
        let headers = self.statements.iter().enumerate().filter(|(_, statement)| statement.is_header());
        let mut headers = headers.map(|(i, _)| i).filter(|i| self.lead(*i) > 0).peekable();
        headers.peek().is_none() || headers.any(|header| self.is_apart(header))
    }

    /// The blanks at the start of a statement.
    pub fn indent(&self, statement: usize) -> &'t str {
        let line = &self.text[self.statements[statement].lines.clone()];
        &line[..line.len() - line.trim_start_matches([' ', '\t']).len()]
    }

    pub fn line_break(&self) -> &'static str {
        super::line_break(self.text)
    }
}

impl super::scan::Part {
    pub fn is(&self, step: &Step) -> bool {
        matches!(step, Step::Key(key) if *key == self.name)
    }
}
