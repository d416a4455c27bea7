//! The order of design files in a list.

use std::cmp::Ordering;
use std::path::Path;

/// By the name without `.toml`, numbers in it as numbers: `stiffer`, `stiffer-2`, `stiffer-10`.
pub fn by_name(one: &Path, other: &Path) -> Ordering {
    let stem = |path: &Path| path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    natural(&stem(one), &stem(other)).then_with(|| one.cmp(other))
}

fn natural(one: &str, other: &str) -> Ordering {
    let (mut one, mut other) = (one, other);
    while !one.is_empty() && !other.is_empty() {
        let (number, other_number) = (digits(one), digits(other));
        let order = if number.is_empty() || other_number.is_empty() {
            one.chars().next().cmp(&other.chars().next())
        } else {
            let (plain, other_plain) = (number.trim_start_matches('0'), other_number.trim_start_matches('0'));
            plain.len().cmp(&other_plain.len()).then(plain.cmp(other_plain))
        };
        if order.is_ne() {
            return order;
        }
        let step = |text: &str, number: &str| {
            if number.is_empty() { text.chars().next().map_or(0, char::len_utf8) } else { number.len() }
        };
        (one, other) = (&one[step(one, number)..], &other[step(other, other_number)..]);
    }
    one.len().cmp(&other.len())
}

/// The digits at the start.
fn digits(text: &str) -> &str {
    &text[..text.bytes().take_while(u8::is_ascii_digit).count()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_before_what_begins_with_them_and_numbers_as_numbers() {
        let sorted =
            ["7", "a9", "a10", "a010b", "overhung-rigid", "overhung-rigid-2", "stiffer", "stiffer-2", "stiffer-10"];
        let mut names = sorted.map(|stem| Path::new("designs").join(format!("{stem}.toml")));
        names.reverse();
        names.sort_by(|one, other| by_name(one, other));
        assert_eq!(names.map(|path| path.file_stem().unwrap().to_string_lossy().into_owned()), sorted);
    }
}
