//! What is different in another text of the same design.

use std::time::Duration;

use similar::{ChangeTag, TextDiff};

use super::{Difference, Document, diff};

/// How a text became another one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Changes {
    /// In the order of the schema.
    Values(Vec<Difference>),
    /// Where the values are the same, only comments and layout differ; or one of the texts is no TOML.
    Lines(Vec<LineChange>),
}

/// One line that is not in both texts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LineChange {
    /// `line` counts from 1 in the first text
    Removed { line: usize, text: String },
    /// `line` counts from 1 in the second
    Added { line: usize, text: String },
}

impl Changes {
    pub fn between(before: &str, after: &str) -> Self {
        let is_toml = |text: &str| Document::parse(text).is_ok();
        if is_toml(before) && is_toml(after) {
            let values = diff(before, after);
            if !values.is_empty() {
                return Self::Values(values);
            }
        }
        Self::Lines(lines(before, after))
    }

    pub fn len(&self) -> usize {
        match self {
            Self::Values(values) => values.len(),
            Self::Lines(lines) => lines.len(),
        }
    }

    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// `2 values`, `1 line`
    pub fn count(&self) -> String {
        let word = if matches!(self, Self::Values(_)) { "value" } else { "line" };
        let plural = if self.len() == 1 { "" } else { "s" };
        format!("{} {word}{plural}", self.len())
    }
}

fn lines(before: &str, after: &str) -> Vec<LineChange> {
    /// Texts of megabytes that have nothing in common are not worth more; what is found by then is right, if longer than need be.
    const PATIENCE: Duration = Duration::from_millis(500);
    let diff = TextDiff::configure().timeout(PATIENCE).diff_lines(before, after);
    let text = |value: &str| value.trim_end_matches(['\n', '\r']).to_owned();
    let change = |change: similar::Change<&str>| match (change.tag(), change.old_index(), change.new_index()) {
        (ChangeTag::Delete, Some(at), _) => Some(LineChange::Removed { line: at + 1, text: text(change.value()) }),
        (ChangeTag::Insert, _, Some(at)) => Some(LineChange::Added { line: at + 1, text: text(change.value()) }),
        _ => None,
    };
    diff.iter_all_changes().filter_map(change).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::library::SHIPPED;

    #[test]
    fn values_come_first_then_lines() {
        let text = SHIPPED[0].text;
        let values = Changes::between(text, &text.replacen("kx_n_per_m = 6.0e8", "kx_n_per_m = 7e8 # more", 1));
        assert!(matches!(&values, Changes::Values(values) if values[0].b.as_deref() == Some("7e8")), "{values:?}");
        assert_eq!(values.count(), "1 value");
        let comment = Changes::between("a = 1\nb = 2\n", "a = 1 # one\nb = 2\n");
        let removed = LineChange::Removed { line: 1, text: "a = 1".into() };
        assert_eq!(comment, Changes::Lines(vec![removed, LineChange::Added { line: 1, text: "a = 1 # one".into() }]));
        assert_eq!(comment.count(), "2 lines");
        assert!(matches!(Changes::between(text, "no = toml = here"), Changes::Lines(_)));
        assert!(Changes::between(text, text).is_empty());
    }
}
