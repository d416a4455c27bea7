//! Values as they are written into a file.

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

    /// A text, quoted.
    pub fn text(text: &str) -> Self {
        Self(Value::from(text).to_string())
    }

    /// A list of texts, quoted.
    pub fn texts<'a>(texts: impl IntoIterator<Item = &'a str>) -> Self {
        let texts: Vec<String> = texts.into_iter().map(|text| Value::from(text).to_string()).collect();
        Self(format!("[{}]", texts.join(", ")))
    }

    /// A number that is finite.
    pub fn number(number: f64) -> Option<Self> {
        number.is_finite().then(|| Self(format!("{number:?}")))
    }

    pub fn as_str(&self) -> &str {
        &self.0
    }
}
