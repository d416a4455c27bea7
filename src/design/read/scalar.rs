//! Reading single values: numbers, texts, words and lists of them.

use toml::de::DeValue;

use super::table::{Found, FromFile, TableReader};
use super::{Value, did_you_mean, written};
use crate::design::key_path::KeyPath;
use crate::design::rotor::Hold;
use crate::design::schema::{Field, Kind, Limit, Written};
use crate::units::Quantity;

/// Why a value is no number that can be used.
pub(super) enum NoNumber {
    OtherType,
    NotFinite,
    TooLarge,
}

/// The finite number that is written as an integer or a float.
pub(super) fn as_number(value: &DeValue<'_>) -> Result<f64, NoNumber> {
    match value {
        DeValue::Float(float) => {
            let number: f64 = float.as_str().parse().map_err(|_| NoNumber::OtherType)?;
            match number {
                n if n.is_finite() => Ok(n),
                n if n.is_infinite() && !float.as_str().contains("inf") => Err(NoNumber::TooLarge),
                _ => Err(NoNumber::NotFinite),
            }
        }
        // TOML knows whole numbers of 64 bits only
        DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
            .map(|number| number as f64)
            .map_err(|_| NoNumber::TooLarge),
        _ => Err(NoNumber::OtherType),
    }
}

impl TableReader<'_> {
    /// A number in SI units within the limit; not-a-number, and reported, where it is not.
    fn number(&self, path: &KeyPath, value: &Value<'_>, quantity: Quantity, limit: Limit, wanted: &str) -> f64 {
        let raw = || written::raw(self.text, value);
        let message = match as_number(value.get_ref()) {
            Ok(number) if !limit.allows(number) => {
                format!("must be {}; it is {}", limit.describe(quantity), raw())
            }
            Ok(number) => {
                let si = quantity.to_si(number);
                if si.is_infinite() {
                    format!("{} is too large: it overflows in SI units", raw())
                } else if si == 0.0 && number != 0.0 {
                    format!("{} is too small: it vanishes in SI units", raw())
                } else {
                    return si;
                }
            }
            Err(NoNumber::NotFinite) => format!("must be a finite number; it is {}", raw()),
            Err(NoNumber::TooLarge) => format!("{} is too large for a number", raw()),
            Err(NoNumber::OtherType) => format!("expected {wanted}, found {}", written::what(self.text, value)),
        };
        self.wrong(path, value, message, None);
        f64::NAN
    }

    /// A whole number; nothing where there is none, reported unless it is optional.
    pub fn whole(&self, field: &'static Field) -> Option<u64> {
        let Kind::Whole(low, high) = field.kind else { return None };
        let value = match self.look_up(field) {
            Found::Written(value) => value,
            Found::Default(Written::Whole(number)) => return Some(number),
            Found::Default(_) | Found::Nothing => return None,
        };
        let exact = match value.get_ref() {
            DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix()).ok().map(i128::from),
            // a double without fraction is a whole number exactly; one beyond i128 becomes its end
            _ => as_number(value.get_ref()).ok().filter(|n| n.fract() == 0.0).map(|n| n as i128),
        };
        let raw = || written::raw(self.text, value);
        let message = match (exact, as_number(value.get_ref())) {
            (Some(number), _) => match u64::try_from(number) {
                Ok(number) if (low..=high).contains(&number) => return Some(number),
                // without a limit of its own, a later check says what is too much
                _ if high == u64::MAX && number > 0 => return Some(u64::MAX),
                _ if high == low => format!("must be {low}; it is {}", raw()),
                _ if number < i128::from(low) && high >= u64::from(u32::MAX) => {
                    format!("must be at least {low}; it is {}", raw())
                }
                _ => format!("must be from {low} to {high}; it is {}", raw()),
            },
            (None, Ok(_)) => format!("must be a whole number; it is {}", raw()),
            (None, Err(NoNumber::NotFinite)) => format!("must be a finite number; it is {}", raw()),
            (None, Err(NoNumber::TooLarge)) => format!("{} is too large for a number", raw()),
            (None, Err(NoNumber::OtherType)) => {
                format!("expected a whole number, found {}", written::what(self.text, value))
            }
        };
        self.wrong(&self.path_of(field), value, message, None);
        None
    }

    fn text_value(&self, field: &'static Field) -> Option<String> {
        match self.look_up(field) {
            Found::Written(value) => {
                let text = self.text_of(&self.path_of(field), value, &written::wanted(field))?;
                if matches!(field.kind, Kind::Name) && text.trim().is_empty() {
                    self.wrong(&self.path_of(field), value, "must not be empty", None);
                }
                Some(text)
            }
            Found::Default(Written::Text(text)) => Some(text.into()),
            Found::Default(Written::ByPlace(text)) => Some(format!("{text}{}", self.place + 1)),
            Found::Default(_) | Found::Nothing => None,
        }
    }

    fn text_of(&self, path: &KeyPath, value: &Value<'_>, wanted: &str) -> Option<String> {
        let text = value.get_ref().as_str().map(String::from);
        if text.is_none() {
            self.wrong(path, value, format!("expected {wanted}, found {}", written::what(self.text, value)), None);
        }
        text
    }

    /// One of the words; nothing where there is none, reported.
    pub fn word(&self, field: &'static Field, words: &'static [&'static str]) -> Option<&'static str> {
        match self.look_up(field) {
            Found::Written(value) => self.word_of(&self.path_of(field), value, words),
            Found::Default(Written::Text(word)) => Some(word),
            Found::Default(_) | Found::Nothing => None,
        }
    }

    fn word_of(&self, path: &KeyPath, value: &Value<'_>, words: &'static [&'static str]) -> Option<&'static str> {
        let allowed = written::quoted(words);
        let text = self.text_of(path, value, &format!("one of {allowed}"))?;
        let word = words.iter().find(|word| **word == text);
        if word.is_none() {
            let message = format!("must be one of {allowed}; it is {}", written::raw(self.text, value));
            let hint = did_you_mean(&text, words.iter().copied());
            self.wrong(path, value, message, Some(hint.trim_end().into()).filter(|hint: &String| !hint.is_empty()));
        }
        word.copied()
    }

    /// The entries of a list; nothing where there is none, reported. `count` is how many are wanted.
    fn list<'v>(&self, path: &KeyPath, value: &'v Value<'v>, wanted: &str, count: Option<usize>) -> &'v [Value<'v>] {
        let found = match value.get_ref() {
            DeValue::Array(entries) if count.is_none_or(|count| count == entries.len()) => return entries,
            DeValue::Array(entries) => format!("a list of {}", entries.len()),
            _ => written::what(self.text, value),
        };
        self.wrong(path, value, format!("expected {wanted}, found {found}"), None);
        &[]
    }

    /// A list of that many numbers in SI units.
    fn numbers<const N: usize>(&self, path: &KeyPath, value: &Value<'_>, quantity: Quantity, wanted: &str) -> [f64; N] {
        let mut numbers = [f64::NAN; N];
        for (place, (number, entry)) in numbers.iter_mut().zip(self.list(path, value, wanted, Some(N))).enumerate() {
            *number = self.number(&path.place(place), entry, quantity, Limit::Any, &written::number(quantity));
        }
        numbers
    }
}

impl FromFile for f64 {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        <Option<f64> as FromFile>::from_file(reader, field).unwrap_or(f64::NAN)
    }
}

impl FromFile for Option<f64> {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        let Kind::Number(quantity, limit) = field.kind else { return None };
        match reader.look_up(field) {
            Found::Written(value) => {
                Some(reader.number(&reader.path_of(field), value, quantity, limit, &written::wanted(field)))
            }
            Found::Default(Written::Number(number)) => Some(quantity.to_si(number)),
            Found::Default(_) | Found::Nothing => None,
        }
    }
}

impl FromFile for usize {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        reader.whole(field).map_or(1, |number| Self::try_from(number).unwrap_or(Self::MAX))
    }
}

impl FromFile for Option<u32> {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        reader.whole(field).and_then(|number| u32::try_from(number).ok())
    }
}

impl FromFile for String {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        reader.text_value(field).unwrap_or_default()
    }
}

impl FromFile for Option<String> {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        reader.text_value(field)
    }
}

impl FromFile for Vec<String> {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        let Found::Written(value) = reader.look_up(field) else { return Self::new() };
        let path = reader.path_of(field);
        let entries = reader.list(&path, value, &written::wanted(field), None).iter().enumerate();
        entries.filter_map(|(place, entry)| reader.text_of(&path.place(place), entry, "a text in quotes")).collect()
    }
}

impl FromFile for [f64; 3] {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        match (reader.look_up(field), field.quantity()) {
            (Found::Written(value), Some(quantity)) => {
                reader.numbers(&reader.path_of(field), value, quantity, &written::wanted(field))
            }
            _ => [f64::NAN; 3],
        }
    }
}

impl FromFile for [[f64; 6]; 6] {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        let mut matrix = [[f64::NAN; 6]; 6];
        if let Found::Written(value) = reader.look_up(field) {
            let path = reader.path_of(field);
            let rows = reader.list(&path, value, &written::wanted(field), Some(6));
            for (place, (row, entry)) in matrix.iter_mut().zip(rows).enumerate() {
                *row = reader.numbers(&path.place(place), entry, Quantity::Ratio, "a row of six numbers");
            }
        }
        matrix
    }
}

impl FromFile for Hold {
    fn from_file(reader: &mut TableReader<'_>, field: &'static Field) -> Self {
        let mut hold = Self::default();
        let Found::Written(value) = reader.look_up(field) else { return hold };
        let path = reader.path_of(field);
        let entries = reader.list(&path, value, &written::wanted(field), None);
        if value.get_ref().as_array().is_some_and(|array| array.is_empty()) {
            let message = format!("must not be empty: any of {}", written::quoted(Self::WORDS));
            reader.wrong(&path, value, message, None);
        }
        for (place, entry) in entries.iter().enumerate() {
            let path = path.place(place);
            let held = match reader.word_of(&path, entry, Self::WORDS) {
                Some("x") => &mut hold.x,
                Some("y") => &mut hold.y,
                Some("z") => &mut hold.z,
                _ => continue,
            };
            if *held {
                reader.wrong(&path, entry, format!("{} is there already", written::raw(reader.text, entry)), None);
            }
            *held = true;
        }
        hold
    }
}
