//! Values as they are written into a file.

use std::fmt::Write as _;

use toml_edit::Value;

/// The spelling of one value: a number as a person wrote it, a text in quotes, a list.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Spelled(String);

impl Spelled {
    /// A value in TOML, e.g. `6e8`; nothing where it is none.
    pub fn parse(toml: &str) -> Option<Self> {
        let toml = toml.trim();
        toml.parse::<Value>().ok().map(|_| Self(toml.into()))
    }

    /// A text, quoted, in one line.
    pub fn text(text: &str) -> Self {
        Self(quoted(text))
    }

    /// A list of texts, quoted.
    pub fn texts<'a>(texts: impl IntoIterator<Item = &'a str>) -> Self {
        let texts: Vec<String> = texts.into_iter().map(quoted).collect();
        Self(format!("[{}]", texts.join(", ")))
    }

    pub fn as_str(&self) -> &str {
        &self.0
    }
}

/// In one line, so that it fits everywhere and line ends of the file stay alike.
fn quoted(text: &str) -> String {
    if !text.contains(['\n', '\r']) {
        return Value::from(text).to_string();
    }
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            '\n' => quoted.push_str("\\n"),
            '\r' => quoted.push_str("\\r"),
            '\t' => quoted.push_str("\\t"),
            // writing to a String cannot fail
            c if c.is_control() => drop(write!(quoted, "\\u{:04X}", u32::from(c))),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_text_is_one_line() {
        for (text, spelled) in [("plain", "\"plain\""), ("a\nb\r\n\"\\\u{1b}", r#""a\nb\r\n\"\\\u001B""#)] {
            assert_eq!(Spelled::text(text).as_str(), spelled);
        }
    }

    proptest! {
        #[test]
        fn what_is_spelled_reads_back(text in any::<String>(), more in "[\\n\"'\\\\# a]{0,8}") {
            for text in [&text, &more] {
                let spelled = Spelled::text(text);
                prop_assert!(!spelled.as_str().contains('\n'));
                let value: Value = spelled.as_str().parse().unwrap();
                prop_assert_eq!(value.as_str(), Some(text.as_str()));
                let list = Spelled::texts([text.as_str(), "x"]);
                let list: Value = list.as_str().parse().unwrap();
                prop_assert_eq!(list.as_array().map(toml_edit::Array::len), Some(2));
            }
        }
    }
}
