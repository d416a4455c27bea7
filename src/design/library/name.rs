//! File names that are safe on every system.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::text::is_unprintable;

/// A checked name of a design file, without `.toml`.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct VariantName(String);

/// Why a name is not taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum NameError {
    #[error("a name is wanted")]
    Empty,
    #[error("the name is too long: {MAX_NAME} bytes at most")]
    TooLong,
    #[error("a name must not have {0:?} in it")]
    Character(char),
    #[error("a name must not begin with {0:?}")]
    Start(char),
    #[error("a name must not end with {0:?}")]
    End(char),
    #[error("this name is reserved by some systems")]
    Reserved,
}

/// Longest name, in bytes without `.toml`.
const MAX_NAME: usize = 100;

/// Device names of Windows, with or without anything after a dot.
const RESERVED: [&str; 6] = ["CON", "CONIN$", "CONOUT$", "PRN", "AUX", "NUL"];
const RESERVED_WITH_DIGIT: [&str; 2] = ["COM", "LPT"];

impl VariantName {
    /// Checks a name; a `.toml` at its end is not part of it.
    ///
    /// # Errors
    ///
    /// [`NameError`] says what is wrong with it.
    pub fn new(name: &str) -> Result<Self, NameError> {
        let ending = name.len().checked_sub(".toml".len()).and_then(|at| name.split_at_checked(at));
        let name = ending.filter(|(_, ending)| ending.eq_ignore_ascii_case(".toml")).map_or(name, |(name, _)| name);
        let (Some(first), Some(last)) = (name.chars().next(), name.chars().next_back()) else {
            return Err(NameError::Empty);
        };
        if name.len() > MAX_NAME {
            return Err(NameError::TooLong);
        }
        let is_bad = |c: &char| is_unprintable(*c) || "/\\:*?\"<>|".contains(*c);
        if let Some(bad) = name.chars().find(is_bad) {
            return Err(NameError::Character(bad));
        }
        if matches!(first, '.' | '-') || first.is_whitespace() {
            return Err(NameError::Start(first));
        }
        if last == '.' || last.is_whitespace() {
            return Err(NameError::End(last));
        }
        if is_reserved(name) { Err(NameError::Reserved) } else { Ok(Self(name.into())) }
    }

    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// `FOLDER/NAME.toml`
    pub fn path_in(&self, folder: &Path) -> PathBuf {
        folder.join(format!("{}.toml", self.0))
    }
}

fn is_reserved(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or_default().trim_end().to_uppercase();
    let with_digit = |device: &str| {
        let rest = stem.strip_prefix(device).map(|rest| rest.chars().collect::<Vec<_>>());
        matches!(rest.as_deref(), Some([c]) if c.is_ascii_digit() || "¹²³".contains(*c))
    };
    RESERVED.contains(&stem.as_str()) || RESERVED_WITH_DIGIT.iter().any(|device| with_digit(device))
}

impl fmt::Display for VariantName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_people_give_are_taken() {
        for name in
            ["a", "stiffer-bearing", "Kegelrad über alles", "v1.2", "歯車", "console", "com10", "a..b", "nul-test"]
        {
            assert_eq!(VariantName::new(name).unwrap().as_str(), name);
        }
        assert_eq!(VariantName::new("a.toml").unwrap().path_in(Path::new("x")), Path::new("x/a.toml"));
        assert_eq!(VariantName::new("A.TOML").unwrap().as_str(), "A");
        assert!(VariantName::new(&"a".repeat(100)).is_ok());
    }

    // Reserved names and characters: Microsoft, "Naming Files, Paths, and Namespaces".
    #[test]
    fn names_that_do_harm_are_not() {
        for (name, error) in [
            ("", NameError::Empty),
            (".toml", NameError::Empty),
            ("..", NameError::Start('.')),
            ("../x", NameError::Character('/')),
            ("a/b", NameError::Character('/')),
            ("a\\b", NameError::Character('\\')),
            ("C:x", NameError::Character(':')),
            ("a\0b", NameError::Character('\0')),
            ("a\nb", NameError::Character('\n')),
            ("a\u{202e}b", NameError::Character('\u{202e}')),
            ("a\u{200b}", NameError::Character('\u{200b}')),
            (".hidden", NameError::Start('.')),
            ("-rf", NameError::Start('-')),
            (" a", NameError::Start(' ')),
            ("a ", NameError::End(' ')),
            ("a.", NameError::End('.')),
            ("a .toml", NameError::End(' ')),
            ("CON", NameError::Reserved),
            ("nul", NameError::Reserved),
            ("Nul.txt", NameError::Reserved),
            ("conin$", NameError::Reserved),
            ("com1", NameError::Reserved),
            ("LPT9.x", NameError::Reserved),
            ("COM²", NameError::Reserved),
        ] {
            assert_eq!(VariantName::new(name), Err(error), "{name:?}");
        }
        assert_eq!(VariantName::new(&"ä".repeat(51)), Err(NameError::TooLong));
    }
}
