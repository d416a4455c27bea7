//! What is wrong, or worth a second look, in a design file.

use std::cell::{Cell, RefCell};
use std::ops::Range;

use super::key_path::KeyPath;

/// How bad a finding is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Severity {
    /// The design cannot be used.
    Error,
    /// The design can be used; something in it looks unintended.
    Warning,
}

impl Severity {
    pub fn word(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Warning => "warning",
        }
    }
}

/// One thing found while reading a design file. Texts may hold characters of the file: show them through
/// [`Source::render`](super::Source::render), which makes them harmless.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    pub severity: Severity,
    /// Which value it is about, by place: `pinion.segment[2].outer_diameter_mm`; the root where it is about the file. Names
    /// may be long: [`shown_path`](Self::shown_path) is clipped.
    pub key_path: KeyPath,
    /// Bytes of the text it is about.
    pub span: Option<Range<usize>>,
    /// What is wrong and what is wanted, without the key path.
    pub message: String,
    /// What to do about it.
    pub hint: Option<String>,
}

impl Finding {
    /// The key path as people read it, clipped; empty where it is about the file.
    pub fn shown_path(&self) -> String {
        let mut shown = self.key_path.to_string();
        clip(&mut shown);
        shown
    }
}

/// Collects findings while a file is read. Shared by everything that reads, so it is written to behind a shared reference.
///
/// A hostile file can have a million errors: past [`Collector::LIMIT`] they are counted but not kept.
#[derive(Debug, Default)]
pub(super) struct Collector {
    kept: RefCell<Vec<Finding>>,
    has_error: Cell<bool>,
    dropped: Cell<usize>,
}

impl Collector {
    pub const LIMIT: usize = 200;

    pub fn push(&self, mut finding: Finding) {
        // the first error is always kept: it decides whether there is a design
        let first_error = is_error(&finding) && !self.has_error.get();
        if self.kept.borrow().len() >= Self::LIMIT && !first_error {
            return self.dropped.set(self.dropped.get() + 1);
        }
        // names may be as long as the file
        [Some(&mut finding.message), finding.hint.as_mut()].into_iter().flatten().for_each(clip);
        while finding.key_path.to_string().len() > LONGEST_PATH {
            finding.key_path = finding.key_path.split_last().map(|(around, _)| around).unwrap_or_default();
        }
        self.has_error.set(self.has_error.get() || first_error);
        self.kept.borrow_mut().push(finding);
    }

    pub fn error(&self, key_path: &KeyPath, span: Range<usize>, message: impl Into<String>, hint: Option<String>) {
        if self.is_full() {
            // before any more text is made
            return self.dropped.set(self.dropped.get() + 1);
        }
        let (key_path, message) = (key_path.clone(), message.into());
        self.push(Finding { severity: Severity::Error, key_path, span: Some(span), message, hint });
    }

    /// True once there is an error and nothing more is kept: callers may stop looking.
    pub fn is_full(&self) -> bool {
        self.has_error.get() && self.kept.borrow().len() >= Self::LIMIT
    }

    /// The findings in the order of the text.
    pub fn finish(self) -> Vec<Finding> {
        let mut findings = self.kept.into_inner();
        findings.sort_by_key(|finding| finding.span.as_ref().map_or(usize::MAX, |span| span.start));
        let dropped = self.dropped.get();
        if dropped > 0 {
            let severity = if findings.iter().any(is_error) { Severity::Error } else { Severity::Warning };
            let message = format!("{dropped} more findings are not shown");
            findings.push(Finding { severity, key_path: KeyPath::root(), span: None, message, hint: None });
        }
        findings
    }
}

/// Longest text of a finding, in characters.
const LONGEST: usize = 500;
/// Longest key path, in bytes as it prints: a longer one, of a hostile file, leads to the table around only.
const LONGEST_PATH: usize = 10_000;

fn clip(text: &mut String) {
    if let Some((end, _)) = text.char_indices().nth(LONGEST) {
        text.truncate(end);
        text.push_str("...");
    }
}

pub(super) fn is_error(finding: &Finding) -> bool {
    finding.severity == Severity::Error
}
