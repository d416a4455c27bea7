//! A TOML text line by line: headers, keys with values, comments, empty lines.

use std::collections::HashMap;
use std::ops::Range;

use super::scan::{Part, Scanner};
use crate::design::KeyPath;

/// A line, or several where a value goes over several.
#[derive(Debug, Clone)]
pub(super) struct Statement {
    pub kind: Kind,
    /// Whole lines, without the last line break
    pub lines: Range<usize>,
    /// By place; the root for comments and empty lines
    pub address: KeyPath,
}

#[derive(Debug, Clone)]
pub(super) enum Kind {
    Empty,
    Comment,
    Header {
        parts: Vec<Part>,
    },
    Pair {
        parts: Vec<Part>,
        value: Range<usize>,
        /// How many steps of the address come from the header above
        above: usize,
    },
}

impl Statement {
    pub fn is_header(&self) -> bool {
        matches!(self.kind, Kind::Header { .. })
    }

    pub fn is_pair(&self) -> bool {
        matches!(self.kind, Kind::Pair { .. })
    }

    pub fn is_comment(&self) -> bool {
        matches!(self.kind, Kind::Comment)
    }

    pub fn is_empty(&self) -> bool {
        matches!(self.kind, Kind::Empty)
    }
}

/// Where the first line starts: after a byte order mark.
pub(super) fn start(text: &str) -> usize {
    if text.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { 0 }
}

/// All statements; what comes after the last line break is one only if there is something.
pub(super) fn statements(text: &str) -> Vec<Statement> {
    let mut scanner = Scanner::new(text, start(text));
    let mut found = Vec::new();
    let mut lists: HashMap<KeyPath, usize> = HashMap::new();
    let mut context = KeyPath::root();
    while scanner.at < text.len() {
        let line = scanner.at;
        scanner.skip_blanks();
        let (kind, address) = match scanner.peek() {
            None | Some(b'\r' | b'\n') => (Kind::Empty, KeyPath::root()),
            Some(b'#') => (Kind::Comment, KeyPath::root()),
            Some(b'[') => {
                let parts = header(&mut scanner);
                context = resolve(&parts.1, parts.0, &mut lists);
                (Kind::Header { parts: parts.1 }, context.clone())
            }
            Some(_) => pair(&mut scanner, &context),
        };
        scanner.skip_line();
        found.push(Statement { kind, lines: line..scanner.at, address });
        let end = scanner.at;
        scanner.skip_break();
        if scanner.at == end && end < text.len() {
            // no TOML; nothing here may go round in circles
            break;
        }
    }
    found
}

/// Is it a list, and the keys.
fn header(scanner: &mut Scanner<'_>) -> (bool, Vec<Part>) {
    scanner.at += 1;
    let list = scanner.peek() == Some(b'[');
    scanner.at += usize::from(list);
    (list, scanner.keys())
}

fn pair(scanner: &mut Scanner<'_>, context: &KeyPath) -> (Kind, KeyPath) {
    let parts = scanner.keys();
    if scanner.peek() == Some(b'=') {
        scanner.at += 1;
    }
    scanner.skip_blanks();
    let value = scanner.value();
    let address = parts.iter().fold(context.clone(), |path, part| path.key(&part.name));
    (Kind::Pair { parts, value, above: context.steps().len() }, address)
}

/// The table that a header is about: of a list, the entry that it adds, or the last one so far.
fn resolve(parts: &[Part], list: bool, lists: &mut HashMap<KeyPath, usize>) -> KeyPath {
    let mut path = KeyPath::root();
    for (i, part) in parts.iter().enumerate() {
        path = path.key(&part.name);
        if list && i + 1 == parts.len() {
            let count = lists.entry(path.clone()).or_default();
            path = path.place(*count);
            *count += 1;
        } else if let Some(count) = lists.get(&path) {
            path = path.place(count - 1);
        }
    }
    path
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_statement_has_its_address() {
        let text = "\u{feff}# top\r\na.b = [\r\n 1, # c\r\n]\r\n\r\n[[p.s]]\r\n  x = 1 # c\r\n[[p.s]]\r\n[p.s.t]\r\ny=1\r\n[\"q r\"]";
        let found: Vec<(String, &str)> =
            statements(text).into_iter().map(|s| (s.address.to_string(), &text[s.lines])).collect();
        let expected = [
            ("", "# top"),
            ("a.b", "a.b = [\r\n 1, # c\r\n]"),
            ("", ""),
            ("p.s[0]", "[[p.s]]"),
            ("p.s[0].x", "  x = 1 # c"),
            ("p.s[1]", "[[p.s]]"),
            ("p.s[1].t", "[p.s.t]"),
            ("p.s[1].t.y", "y=1"),
            ("\"q r\"", "[\"q r\"]"),
        ];
        let found: Vec<(&str, &str)> = found.iter().map(|(address, lines)| (address.as_str(), *lines)).collect();
        assert_eq!(found, expected);
    }
}
