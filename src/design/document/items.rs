//! Inline lists and tables: `[1, 2]`, `{ a = 1 }`, in one line or in several.

use std::ops::Range;

use super::scan::{Part, Scanner};
use super::splice::Splice;

/// What stands between the brackets.
#[derive(Debug, Clone)]
pub(super) struct Items<'t> {
    text: &'t str,
    /// With the brackets
    span: Range<usize>,
    pub entries: Vec<Item>,
}

/// An entry of a list, or a key with its value.
#[derive(Debug, Clone)]
pub(super) struct Item {
    /// Empty in lists
    pub parts: Vec<Part>,
    pub value: Range<usize>,
    /// Key and value
    pub span: Range<usize>,
    /// Where the comma after it is
    comma: Option<usize>,
}

/// An item that has its lines for itself, with the comments that belong to it.
struct Lines {
    /// From the first line of the comments above to the end of the item, without the comma
    block: Range<usize>,
    /// The comment after item and comma, with the blanks before it; empty where there is none
    tail: Range<usize>,
}

impl<'t> Items<'t> {
    /// The list or table that is written there; nothing where neither is.
    pub fn new(text: &'t str, span: Range<usize>) -> Option<Self> {
        let table = match text.as_bytes().get(span.start)? {
            b'[' => false,
            b'{' => true,
            _ => return None,
        };
        let mut scanner = Scanner::new(text, span.start + 1);
        let mut entries = Vec::new();
        loop {
            scanner.skip_space();
            if scanner.at + 1 >= span.end {
                return Some(Self { text, span, entries });
            }
            let start = scanner.at;
            let parts = if table { scanner.keys() } else { Vec::new() };
            if table && scanner.peek() == Some(b'=') {
                scanner.at += 1;
                scanner.skip_blanks();
            }
            let value = scanner.value();
            let end = scanner.at;
            scanner.skip_space();
            let comma = (scanner.peek() == Some(b',')).then_some(scanner.at);
            scanner.at += usize::from(comma.is_some());
            if scanner.at == start {
                // no TOML; nothing here may go round in circles
                return None;
            }
            entries.push(Item { parts, value, span: start..end, comma });
        }
    }

    /// Puts an item at that place.
    pub fn insert(&self, place: usize, item: &str) -> Vec<Splice> {
        let Some(last) = self.entries.len().checked_sub(1) else {
            let inside = if self.is_table() { format!(" {item} ") } else { item.into() };
            let space = self.text[self.span.start + 1..self.span.end - 1].trim().is_empty();
            let end = if space { self.span.end - 1 } else { self.span.start + 1 };
            return vec![Splice::new(self.span.start + 1..end, inside)];
        };
        if place <= last {
            let next = &self.entries[place];
            let Some(lines) = self.lines(place) else {
                return vec![Splice::insert(next.span.start, format!("{item}, "))];
            };
            let (indent, line_break) = (self.indent(next.span.start), super::line_break(self.text));
            return vec![Splice::insert(lines.block.start, format!("{indent}{item},{line_break}"))];
        }
        let before = &self.entries[last];
        let Some(lines) = self.lines(last) else {
            return vec![Splice::insert(before.span.end, format!(", {item}"))];
        };
        let (indent, line_break) = (self.indent(before.span.start), super::line_break(self.text));
        let comma = if before.comma.is_some() { "," } else { "" };
        let line = Splice::insert(lines.tail.end, format!("{line_break}{indent}{item}{comma}"));
        match before.comma {
            Some(_) => vec![line],
            None if lines.tail.end == before.span.end => {
                vec![Splice::insert(before.span.end, format!(",{}", line.text))]
            }
            None => vec![Splice::insert(before.span.end, ","), line],
        }
    }

    /// Takes the item at that place out, with its comma and the comments that belong to it.
    pub fn remove(&self, place: usize) -> Vec<Splice> {
        let item = &self.entries[place];
        if let Some(lines) = self.lines(place) {
            let mut scanner = Scanner::new(self.text, lines.tail.end);
            scanner.skip_break();
            return vec![Splice::remove(lines.block.start..scanner.at)];
        }
        if self.entries.len() == 1 && self.span_is_plain() {
            return vec![Splice::remove(self.span.start + 1..self.span.end - 1)];
        }
        let end = item.comma.map_or(item.span.end, |comma| comma + 1);
        let range = match (self.entries.get(place + 1), place.checked_sub(1).map(|before| &self.entries[before])) {
            (Some(next), _) if self.is_plain(end..next.span.start) => item.span.start..next.span.start,
            (None, Some(before)) if self.is_plain(before.span.end..item.span.start) => before.span.end..item.span.end,
            _ => item.span.start..end,
        };
        vec![Splice::remove(range)]
    }

    /// Swaps an item with the next one; the commas stay where they are.
    pub fn swap(&self, place: usize) -> Vec<Splice> {
        let (a, b) = (place, place + 1);
        let Some((lines_a, lines_b)) = self.lines(a).zip(self.lines(b)) else {
            let (a, b) = (self.entries[a].span.clone(), self.entries[b].span.clone());
            return vec![Splice::new(a.clone(), &self.text[b.clone()]), Splice::new(b, &self.text[a])];
        };
        let pairs = [(&lines_a.block, &lines_b.block), (&lines_a.tail, &lines_b.tail)];
        let there = pairs.map(|(a, b)| Splice::new(a.clone(), &self.text[b.clone()]));
        let back = pairs.map(|(a, b)| Splice::new(b.clone(), &self.text[a.clone()]));
        there.into_iter().chain(back).collect()
    }

    fn is_table(&self) -> bool {
        self.text.as_bytes()[self.span.start] == b'{'
    }

    /// Neither a comment nor anything else but blanks and commas.
    fn is_plain(&self, range: Range<usize>) -> bool {
        self.text[range].chars().all(|c| c == ',' || c.is_ascii_whitespace())
    }

    /// Nothing but the one item stands between the brackets.
    fn span_is_plain(&self) -> bool {
        let item = &self.entries[0].span;
        self.is_plain(self.span.start + 1..item.start) && self.is_plain(item.end..self.span.end - 1)
    }

    fn line_start(&self, at: usize) -> usize {
        self.text[..at].rfind('\n').map_or(0, |at| at + 1)
    }

    fn indent(&self, at: usize) -> &'t str {
        let line = &self.text[self.line_start(at)..at];
        &line[..line.len() - line.trim_start_matches([' ', '\t']).len()]
    }

    /// The lines of an item; nothing where it shares them with another one or with a bracket.
    fn lines(&self, place: usize) -> Option<Lines> {
        let item = &self.entries[place];
        let own = self.line_start(item.span.start);
        if own <= self.span.start || !self.text[own..item.span.start].trim().is_empty() {
            return None;
        }
        // the comma may only follow on the same line
        let end = match item.comma {
            Some(comma) if self.text[item.span.end..comma].contains(['\n', '#']) => return None,
            Some(comma) => comma + 1,
            None => item.span.end,
        };
        let mut scanner = Scanner::new(self.text, end);
        scanner.skip_blanks();
        match scanner.peek() {
            Some(b'#') => scanner.skip_line(),
            Some(b'\r' | b'\n') => scanner.at = end,
            _ => return None,
        }
        let mut start = own;
        loop {
            let above = self.line_start(start.saturating_sub(1));
            if above <= self.span.start || !self.text[above..start].trim_start().starts_with('#') {
                break;
            }
            start = above;
        }
        Some(Lines { block: start..item.span.end, tail: end..scanner.at })
    }
}

#[cfg(test)]
mod tests {
    use super::super::splice::spliced;
    use super::*;

    fn changed(text: &str, change: impl Fn(&Items<'_>) -> Vec<Splice>) -> String {
        spliced(text, &change(&Items::new(text, 0..text.len()).unwrap()))
    }

    #[test]
    fn items_come_and_go_with_their_commas() {
        for (text, place, with, without) in [
            ("[]", 0, "[9]", None),
            ("[ ]", 0, "[9]", None),
            ("[ # c\n]", 0, "[9 # c\n]", None),
            ("{}", 0, "{ 9 }", None),
            ("[1]", 0, "[9, 1]", Some("[]")),
            ("[1]", 1, "[1, 9]", None),
            ("[1, 2,]", 1, "[1, 9, 2,]", Some("[1,]")),
            ("[1, 2,]", 2, "[1, 2, 9,]", None),
            ("[1, 2]", 0, "[9, 1, 2]", Some("[2]")),
            ("[\n  1, # a\n  # b\n  2 # c\n]", 2, "[\n  1, # a\n  # b\n  2, # c\n  9\n]", None),
            ("[\n  1, # a\n  # b\n  2 # c\n]", 1, "[\n  1, # a\n  9,\n  # b\n  2 # c\n]", Some("[\n  1, # a\n]")),
            ("[\r\n\t1,\r\n]", 1, "[\r\n\t1,\r\n\t9,\r\n]", None),
            ("[\r\n\t1\r\n]", 1, "[\r\n\t1,\r\n\t9\r\n]", None),
            ("[1, # a\n 2]", 0, "[9, 1, # a\n 2]", Some("[ # a\n 2]")),
            ("[1 # a\n , 2]", 1, "[1 # a\n , 9, 2]", Some("[1 # a\n , ]")),
        ] {
            assert_eq!(changed(text, |items| items.insert(place, "9")), with, "{text:?}");
            if let Some(without) = without {
                assert_eq!(changed(text, |items| items.remove(place)), without, "{text:?}");
            }
        }
    }

    #[test]
    fn comments_move_with_their_item() {
        for (text, expected) in [
            ("[1, 2]", "[2, 1]"),
            ("[\n  # a\n  1, # b\n  2\n]", "[\n  2,\n  # a\n  1 # b\n]"),
            ("[\n  1,\n  # c\n  2 # d\n]", "[\n  # c\n  2, # d\n  1\n]"),
            ("[1, # a\n  2,\n]", "[2, # a\n  1,\n]"),
        ] {
            assert_eq!(changed(text, |items| items.swap(0)), expected, "{text:?}");
        }
    }
}
