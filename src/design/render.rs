//! Findings as text for people: where, what, the line itself, and what to do.

use std::fmt::Write as _;

use unicode_width::UnicodeWidthChar as _;

use super::finding::Finding;
use crate::text::{is_unprintable, printable};

/// Characters of a long line that are shown either side of the place.
const AROUND: usize = 60;

/// Where a byte of a text is: line and column from 1, the column in characters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Position {
    pub line: usize,
    pub column: usize,
}

/// A text and the name it is shown under, for findings about it.
#[derive(Debug, Clone)]
pub struct Source<'a> {
    name: &'a str,
    text: &'a str,
    /// Where each line starts
    lines: Vec<usize>,
}

impl<'a> Source<'a> {
    pub fn new(name: &'a str, text: &'a str) -> Self {
        let starts = text.bytes().enumerate().filter(|(_, byte)| *byte == b'\n').map(|(i, _)| i + 1);
        Self { name, text, lines: std::iter::once(0).chain(starts).collect() }
    }

    /// Line and column of a byte; of the end, where it lies beyond.
    pub fn position(&self, byte: usize) -> Position {
        let byte = boundary(self.text, byte);
        let line = self.lines.partition_point(|start| *start <= byte);
        let start = self.lines.get(line.wrapping_sub(1)).copied().unwrap_or(0);
        Position { line, column: self.text[start..byte].chars().count() + 1 }
    }

    /// `FILE:LINE:COLUMN: error: pinion.segment[0].lenght_mm: unknown key`, the line with a mark under the place, the hint.
    /// Nothing in it steers a terminal, whatever the file holds. Ends with a line break.
    pub fn render(&self, finding: &Finding) -> String {
        let mut shown = printable(self.name).into_owned();
        if let Some(span) = &finding.span {
            let position = self.position(span.start);
            let _ = write!(shown, ":{}:{}", position.line, position.column);
        }
        let _ = write!(shown, ": {}: ", finding.severity.word());
        let path = finding.shown_path();
        if !path.is_empty() {
            let _ = write!(shown, "{}: ", printable(&path));
        }
        let _ = writeln!(shown, "{}", printable(&finding.message));
        if let Some(span) = &finding.span {
            self.quote(&mut shown, span.start, span.end);
        }
        if let Some(hint) = &finding.hint {
            let _ = writeln!(shown, "    {}", printable(hint));
        }
        shown
    }

    /// All findings, one after the other.
    pub fn render_all(&self, findings: &[Finding]) -> String {
        findings.iter().map(|finding| self.render(finding)).collect()
    }

    /// Writes the line of the place, clipped, and the mark under it.
    fn quote(&self, shown: &mut String, start: usize, end: usize) {
        let (start, end) = (boundary(self.text, start), boundary(self.text, end));
        let Position { line, column } = self.position(start);
        let line_start = self.lines.get(line.wrapping_sub(1)).copied().unwrap_or(0);
        let content = self.text[line_start..].split('\n').next().unwrap_or_default();
        let content = content.strip_suffix('\r').unwrap_or(content);
        let marked = self.text[start..end.max(start)].split(['\n', '\r']).next().unwrap_or_default().chars().count();
        let first = column.saturating_sub(AROUND + 1);
        let before = column - 1 - first;
        let (mut text, mut mark) = (String::new(), String::new());
        if first > 0 {
            text.push_str("...");
            mark.push_str("   ");
        }
        let mut characters = content.chars().skip(first);
        for character in characters.by_ref().take(before) {
            let width = push_visible(&mut text, character);
            // a tab in the mark is as wide as the one above it
            if character == '\t' { mark.push('\t') } else { mark.extend(std::iter::repeat_n(' ', width)) }
        }
        let mut underlined = 0;
        for (i, character) in characters.by_ref().take(AROUND).enumerate() {
            let width = push_visible(&mut text, character);
            underlined += if i < marked { width } else { 0 };
        }
        // an empty place, or the end of the line, is marked too
        mark.extend(std::iter::repeat_n('^', underlined.max(1)));
        if characters.next().is_some() {
            text.push_str("...");
        }
        let number = line.to_string();
        let _ = writeln!(shown, "  {number} | {text}");
        let _ = writeln!(shown, "  {:width$} | {}", "", mark, width = number.len());
    }
}

/// Appends the character as it can be shown; gives how many columns it takes.
fn push_visible(text: &mut String, character: char) -> usize {
    if character == '\t' {
        text.push('\t');
        return 1;
    }
    let before = text.len();
    if is_unprintable(character) {
        text.push_str(&printable(character.encode_utf8(&mut [0; 4])));
        return text.len() - before;
    }
    text.push(character);
    character.width().unwrap_or(0)
}

/// The byte itself, or the start of the character that it is in the middle of.
fn boundary(text: &str, byte: usize) -> usize {
    (0..=byte.min(text.len())).rev().find(|byte| text.is_char_boundary(*byte)).unwrap_or(0)
}
