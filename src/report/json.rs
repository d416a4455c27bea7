//! The shapes of the JSON output, and how it is written.

use std::borrow::Cow;
use std::io::{self, Write};

use serde::ser::{Serialize, Serializer};

/// Fields in a given order, for objects whose keys are data (model names).
#[derive(Debug, Clone, PartialEq)]
pub struct Object<T>(pub Vec<(Cow<'static, str>, T)>);

impl<T: Serialize> Serialize for Object<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(key, value)| (key, value)))
    }
}

/// Complex values as two lists.
#[derive(Debug, serde::Serialize)]
pub struct ComplexList {
    re: Vec<f64>,
    im: Vec<f64>,
}

impl From<&[num_complex::Complex64]> for ComplexList {
    fn from(values: &[num_complex::Complex64]) -> Self {
        Self { re: values.iter().map(|value| value.re).collect(), im: values.iter().map(|value| value.im).collect() }
    }
}

/// Writes one value on one line. Control characters beyond those that JSON must escape are escaped too, so that no name can
/// command the terminal it is shown on.
///
/// # Errors
///
/// Those of the writer.
pub fn write(out: &mut impl Write, value: &impl Serialize) -> io::Result<()> {
    let mut serializer = serde_json::Serializer::with_formatter(&mut *out, Harmless);
    value.serialize(&mut serializer)?;
    writeln!(out)
}

struct Harmless;

impl serde_json::ser::Formatter for Harmless {
    fn write_string_fragment<W: ?Sized + Write>(&mut self, writer: &mut W, fragment: &str) -> io::Result<()> {
        let mut plain = 0;
        for (i, c) in fragment.char_indices().filter(|(_, c)| crate::text::is_unprintable(*c)) {
            writer.write_all(&fragment.as_bytes()[plain..i])?;
            for unit in c.encode_utf16(&mut [0; 2]) {
                write!(writer, "\\u{unit:04x}")?;
            }
            plain = i + c.len_utf8();
        }
        writer.write_all(&fragment.as_bytes()[plain..])
    }
}

#[cfg(test)]
mod tests {
    /// The text read back is the same, and nothing in it commands a terminal.
    #[test]
    fn control_characters_are_escaped_and_read_back() {
        let name = "a\u{1b}[31m\u{9b}2J\u{7f}\u{202e}b\"\\";
        let mut out = Vec::new();
        super::write(&mut out, &name).unwrap();
        assert!(out.iter().all(|byte| *byte == b'\n' || (0x20..0x7f).contains(byte)), "{out:?}");
        assert_eq!(serde_json::from_slice::<String>(&out).unwrap(), name);
    }
}
