//! The way to a value of a design file: `pinion.bearing[B1].kx_n_per_m`.

use std::fmt::{self, Write as _};
use std::str::FromStr;

use crate::text::{excerpt, is_unprintable};

/// One step on the way to a value.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Step {
    /// A key of a table: `pinion`
    Key(String),
    /// An entry of a list by place, from 0: `[2]`
    Place(usize),
    /// An entry of a list of tables by its name: `[B1]`
    Name(String),
}

/// The way from the top of a design file to a value or a table. Prints as it is typed:
///
/// ```
/// use bevelscope::design::KeyPath;
/// let path: KeyPath = "pinion.bearing[head bearing].kx_n_per_m".parse().unwrap();
/// assert_eq!(path.to_string(), "pinion.bearing[head bearing].kx_n_per_m");
/// assert_eq!(path, KeyPath::root().key("pinion").key("bearing").name("head bearing").key("kx_n_per_m"));
/// ```
///
/// A name that would be misread is quoted like a TOML string: `bearing["2"]` is the one named 2, `bearing[2]` the third.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Default)]
pub struct KeyPath {
    steps: Vec<Step>,
}

impl KeyPath {
    /// The whole file.
    pub fn root() -> Self {
        Self::default()
    }

    #[must_use]
    pub fn key(&self, key: &str) -> Self {
        self.with(Step::Key(key.into()))
    }

    #[must_use]
    pub fn place(&self, place: usize) -> Self {
        self.with(Step::Place(place))
    }

    #[must_use]
    pub fn name(&self, name: &str) -> Self {
        self.with(Step::Name(name.into()))
    }

    #[must_use]
    pub fn with(&self, step: Step) -> Self {
        let steps = self.steps.iter().cloned().chain([step]).collect();
        Self { steps }
    }

    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Is it the other path, or does it lead further than that?
    pub fn starts_with(&self, other: &Self) -> bool {
        self.steps.starts_with(&other.steps)
    }

    /// The way to the table or list around it, and the last step; nothing for the whole file.
    pub fn split_last(&self) -> Option<(Self, &Step)> {
        let (last, before) = self.steps.split_last()?;
        Some((Self { steps: before.to_vec() }, last))
    }
}

fn is_bare_key(key: &str) -> bool {
    !key.is_empty() && key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-')
}

fn is_bare_name(name: &str) -> bool {
    let digits = name.chars().all(|c| c.is_ascii_digit());
    !digits && name.trim() == name && !name.contains(['"', '\\', '[', ']']) && !name.contains(is_unprintable)
}

fn write_quoted(f: &mut fmt::Formatter<'_>, text: &str) -> fmt::Result {
    f.write_char('"')?;
    for character in text.chars() {
        match character {
            '"' | '\\' => write!(f, "\\{character}")?,
            c if is_unprintable(c) => write!(f, "\\u{{{:x}}}", u32::from(c))?,
            c => f.write_char(c)?,
        }
    }
    f.write_char('"')
}

impl fmt::Display for KeyPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, step) in self.steps.iter().enumerate() {
            match step {
                Step::Key(key) => {
                    if i > 0 {
                        f.write_char('.')?;
                    }
                    if is_bare_key(key) { f.write_str(key)? } else { write_quoted(f, key)? }
                }
                Step::Place(place) => write!(f, "[{place}]")?,
                Step::Name(name) if is_bare_name(name) => write!(f, "[{name}]")?,
                Step::Name(name) => {
                    f.write_char('[')?;
                    write_quoted(f, name)?;
                    f.write_char(']')?;
                }
            }
        }
        Ok(())
    }
}

/// Why a text is no key path.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{text}` is no key path: {what}; write it like pinion.bearing[B1].kx_n_per_m or pinion.bearing[0].kx_n_per_m")]
pub struct KeyPathError {
    text: String,
    what: &'static str,
}

impl FromStr for KeyPath {
    type Err = KeyPathError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        parse(text).map_err(|what| KeyPathError { text: excerpt(text, 60), what })
    }
}

fn parse(text: &str) -> Result<KeyPath, &'static str> {
    let mut path = KeyPath::root();
    let mut rest = text.trim();
    loop {
        let (key, after) = if rest.starts_with('"') { quoted(rest)? } else { bare_key(rest)? };
        path.steps.push(Step::Key(key));
        rest = after;
        while let Some(inside) = rest.strip_prefix('[') {
            let (step, after) = bracketed(inside)?;
            path.steps.push(step);
            rest = after;
        }
        match rest.strip_prefix('.') {
            Some(after) => rest = after,
            None if rest.is_empty() => return Ok(path),
            None => return Err("a dot or a bracket is wanted between two keys"),
        }
    }
}

fn bare_key(rest: &str) -> Result<(String, &str), &'static str> {
    let (key, after) = rest.split_at(rest.find(['.', '[']).unwrap_or(rest.len()));
    if is_bare_key(key) { Ok((key.into(), after)) } else { Err("a key is missing or has characters that need quotes") }
}

fn bracketed(inside: &str) -> Result<(Step, &str), &'static str> {
    const OPEN: &str = "a bracket is not closed";
    if inside.starts_with('"') {
        let (name, after) = quoted(inside)?;
        return Ok((Step::Name(name), after.strip_prefix(']').ok_or(OPEN)?));
    }
    let (name, after) = inside.split_once(']').ok_or(OPEN)?;
    if name.is_empty() {
        return Err("a name or a place is missing between brackets");
    }
    if name.chars().all(|c| c.is_ascii_digit()) {
        let place = name.parse().map_err(|_| "a place between brackets is too large")?;
        return Ok((Step::Place(place), after));
    }
    Ok((Step::Name(name.into()), after))
}

/// Reads a quoted text; the quote it starts with is still there.
fn quoted(rest: &str) -> Result<(String, &str), &'static str> {
    let mut text = String::new();
    let mut characters = rest.char_indices().skip(1);
    while let Some((at, character)) = characters.next() {
        match character {
            '"' => return Ok((text, &rest[at + 1..])),
            '\\' => match characters.next() {
                Some((_, c @ ('"' | '\\'))) => text.push(c),
                Some((_, 'u')) => {
                    let code: String = characters
                        .by_ref()
                        .map(|(_, c)| c)
                        .skip_while(|c| *c == '{')
                        .take_while(|c| *c != '}')
                        .collect();
                    let code = u32::from_str_radix(&code, 16).ok().and_then(char::from_u32);
                    text.push(code.ok_or("an escape is wrong")?);
                }
                _ => return Err("an escape is wrong"),
            },
            c => text.push(c),
        }
    }
    Err("a quote is not closed")
}

#[cfg(test)]
mod tests {
    use super::*;

    // By name and by place: the two forms that users may write.
    #[test]
    fn both_forms_read_and_print_alike() {
        for text in [
            "mesh.stiffness_n_per_m",
            "pinion.bearing[B1].kx_n_per_m",
            "pinion.bearing[0].kx_n_per_m",
            "pinion.bearing[0].stiffness[2][3]",
            "pinion.bearing[head bearing]",
            "material.\"Ti 6-4\".density_kg_per_m3",
            "gear.body[\"2\"].mass_kg",
            "gear.body[\"a]b\\\"c\\\\d\\u{1b}\"].mass_kg",
            "gear.body[\" padded\"]",
        ] {
            assert_eq!(text.parse::<KeyPath>().unwrap().to_string(), text);
        }
    }

    #[test]
    fn a_name_of_digits_is_not_a_place() {
        let by_name = KeyPath::root().key("gear").key("body").name("2");
        let by_place = KeyPath::root().key("gear").key("body").place(2);
        assert_eq!(by_name.to_string(), "gear.body[\"2\"]");
        assert_eq!(by_place.to_string(), "gear.body[2]");
        assert_eq!(by_name.to_string().parse(), Ok(by_name));
    }

    #[test]
    fn what_is_no_path_says_why() {
        for text in [
            "",
            ".",
            "a.",
            "a..b",
            "a[",
            "a[]",
            "a[1",
            "a[\"x]",
            "a b",
            "a[1]b",
            "a[99999999999999999999]",
            "a[\"\\q\"]",
        ] {
            let error = text.parse::<KeyPath>().expect_err(text).to_string();
            assert!(error.contains("pinion.bearing[B1]"), "{error}");
        }
    }
}
