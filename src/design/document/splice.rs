//! Changes of a text as bytes to replace.

use std::ops::Range;

/// Bytes of a text, and what comes in their place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Splice {
    pub range: Range<usize>,
    pub text: String,
}

impl Splice {
    pub fn new(range: Range<usize>, text: impl Into<String>) -> Self {
        Self { range, text: text.into() }
    }

    pub fn insert(at: usize, text: impl Into<String>) -> Self {
        Self::new(at..at, text)
    }

    pub fn remove(range: Range<usize>) -> Self {
        Self::new(range, "")
    }
}

/// One difference of two texts, in either direction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Change {
    at: usize,
    old: String,
    new: String,
}

impl Change {
    /// The difference of two texts between what is the same at their starts and at their ends.
    pub fn between(old: &str, new: &str) -> Option<Self> {
        if old == new {
            return None;
        }
        let same = old.bytes().zip(new.bytes()).take_while(|(a, b)| a == b).count();
        let at = (0..=same).rev().find(|at| old.is_char_boundary(*at) && new.is_char_boundary(*at)).unwrap_or(0);
        let (old, new) = (&old[at..], &new[at..]);
        let same = old.bytes().rev().zip(new.bytes().rev()).take_while(|(a, b)| a == b).count();
        let ends = |text: &str, same: usize| text.is_char_boundary(text.len() - same);
        let same = (0..=same).rev().find(|same| ends(old, *same) && ends(new, *same)).unwrap_or(0);
        Some(Self { at, old: old[..old.len() - same].into(), new: new[..new.len() - same].into() })
    }

    /// Makes the change.
    pub fn redo(&self, text: &mut String) {
        text.replace_range(self.at..self.at + self.old.len(), &self.new);
    }

    /// Takes it back.
    pub fn undo(&self, text: &mut String) {
        text.replace_range(self.at..self.at + self.new.len(), &self.old);
    }
}

/// The text with all splices made. They must not overlap.
pub(super) fn spliced(text: &str, splices: &[Splice]) -> String {
    let mut splices: Vec<&Splice> = splices.iter().collect();
    splices.sort_by_key(|splice| (splice.range.start, splice.range.end));
    let mut result = String::with_capacity(text.len() + 64);
    let mut at = 0;
    for splice in splices {
        result.push_str(text.get(at..splice.range.start).unwrap_or_default());
        result.push_str(&splice.text);
        at = splice.range.end.max(at);
    }
    result.push_str(&text[at..]);
    result
}
