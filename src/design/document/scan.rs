//! Where keys, values and comments of a TOML text begin and end. The text is known to be TOML; of any other, the answers
//! mean nothing, but there is always one.

use std::ops::Range;

/// One key of a dotted key.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Part {
    /// Without quotes
    pub name: String,
    /// As written, with quotes
    pub span: Range<usize>,
}

/// A place in a text, moved on over what is there.
#[derive(Debug, Clone)]
pub(super) struct Scanner<'t> {
    text: &'t str,
    pub at: usize,
}

impl<'t> Scanner<'t> {
    pub fn new(text: &'t str, at: usize) -> Self {
        Self { text, at }
    }

    pub fn peek(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    fn starts_with(&self, what: &str) -> bool {
        self.text.get(self.at..).is_some_and(|rest| rest.starts_with(what))
    }

    fn skip_while(&mut self, wanted: impl Fn(u8) -> bool) {
        while self.peek().is_some_and(&wanted) {
            self.at += 1;
        }
    }

    /// Moves over spaces and tabs.
    pub fn skip_blanks(&mut self) {
        self.skip_while(|byte| matches!(byte, b' ' | b'\t'));
    }

    /// Moves over spaces, line breaks and comments.
    pub fn skip_space(&mut self) {
        loop {
            self.skip_while(|byte| byte.is_ascii_whitespace());
            if self.peek() != Some(b'#') {
                return;
            }
            self.skip_line();
        }
    }

    /// Moves to the end of the line, before its line break.
    pub fn skip_line(&mut self) {
        self.skip_while(|byte| byte != b'\n');
        if self.peek().is_some() && self.text[..self.at].ends_with('\r') {
            self.at -= 1;
        }
    }

    /// Moves over a line break, if there is one.
    pub fn skip_break(&mut self) {
        if self.starts_with("\r\n") {
            self.at += 2;
        } else if self.peek() == Some(b'\n') {
            self.at += 1;
        }
    }

    /// Moves over `a."b c".d`.
    pub fn keys(&mut self) -> Vec<Part> {
        let mut parts = Vec::new();
        loop {
            self.skip_blanks();
            let start = self.at;
            match self.peek() {
                Some(b'"' | b'\'') => self.string(),
                _ => self.skip_while(|byte| byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-')),
            }
            let span = start..self.at;
            let written = &self.text[span.clone()];
            let name = written.parse::<toml_edit::Key>().map_or_else(|_| written.into(), |key| key.get().into());
            parts.push(Part { name, span });
            self.skip_blanks();
            if self.peek() != Some(b'.') {
                return parts;
            }
            self.at += 1;
        }
    }

    /// Moves over the value that begins here, and gives its place.
    pub fn value(&mut self) -> Range<usize> {
        let start = self.at;
        match self.peek() {
            Some(b'"' | b'\'') => self.string(),
            Some(b'[' | b'{') => self.bracketed(),
            _ => {
                self.skip_while(|byte| !matches!(byte, b',' | b']' | b'}' | b'#' | b'\n'));
                self.at = start + self.text[start..self.at].trim_end().len();
            }
        }
        start..self.at
    }

    fn bracketed(&mut self) {
        let mut depth = 0_usize;
        while let Some(byte) = self.peek() {
            match byte {
                b'"' | b'\'' => {
                    self.string();
                    continue;
                }
                b'#' => {
                    self.skip_line();
                    continue;
                }
                b'[' | b'{' => depth += 1,
                b']' | b'}' => depth -= 1,
                _ => {}
            }
            self.at += 1;
            if depth == 0 {
                return;
            }
        }
    }

    /// Moves over the text in quotes, of one line or of several, that begins here.
    fn string(&mut self) {
        let Some(quote) = self.peek() else { return };
        let three = if quote == b'"' { "\"\"\"" } else { "'''" };
        let close = if self.starts_with(three) { three } else { &three[..1] };
        self.at += close.len();
        while self.peek().is_some() && !self.starts_with(close) {
            // an escape hides the quote after it
            self.at += if quote == b'"' && self.peek() == Some(b'\\') { 2 } else { 1 };
        }
        self.at = (self.at + close.len()).min(self.text.len());
        if close.len() == 3 {
            // up to two quotes may stand right before the closing ones
            for _ in 0..2 {
                self.at += usize::from(self.peek() == Some(quote));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> &str {
        &text[Scanner::new(text, 0).value()]
    }

    // The forms of values of the TOML specification, each followed by what may stand after it.
    #[test]
    fn a_value_ends_where_it_ends() {
        for (text, expected) in [
            ("6e8 # c", "6e8"),
            ("1_000\r\n", "1_000"),
            ("1979-05-27 07:32:00Z, 1", "1979-05-27 07:32:00Z"),
            (r#""a # \" ]" # c"#, r#""a # \" ]""#),
            (r"'a \' # c", r"'a \'"),
            ("\"\"\"a\n\"b\" \\\" \"\"\"\"\" # c", "\"\"\"a\n\"b\" \\\" \"\"\"\"\""),
            ("'''a'b'''", "'''a'b'''"),
            ("\"\"", "\"\""),
            ("[ 1, # ]\n [2, \"]\"] ] , 3", "[ 1, # ]\n [2, \"]\"] ]"),
            ("{ a = [{}] } ]", "{ a = [{}] }"),
        ] {
            assert_eq!(value(text), expected, "{text:?}");
        }
    }

    #[test]
    fn dotted_keys_come_apart() {
        let text = "a . \"b.\\\"c\".'d e' = 1";
        let names: Vec<String> = Scanner::new(text, 0).keys().into_iter().map(|part| part.name).collect();
        assert_eq!(names, ["a", "b.\"c", "d e"]);
    }

    #[test]
    fn no_text_stops_or_breaks_it() {
        for text in ["", "\"", "\"\"\"", "'\\", "[", "[\"", "{#", "ä", "\"\\", "a.", "]"] {
            let mut scanner = Scanner::new(text, 0);
            scanner.value();
            Scanner::new(text, 0).keys();
            assert!(scanner.at <= text.len() || text.ends_with('\\'), "{text:?}");
        }
    }
}
