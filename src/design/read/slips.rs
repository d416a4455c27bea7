//! What a person probably meant where a file is no TOML.

/// A hint for the line of a syntax error, where the slip is a common one.
pub fn hint(line: &str) -> Option<&'static str> {
    let line = line.split('#').next().unwrap_or_default().trim();
    if is_list_header(line) {
        return Some("a list of tables has double brackets: [[pinion.bearing]], [[pinion.segment]], [[pinion.body]]");
    }
    let (key, value) = line.split_once('=')?;
    let value = value.trim();
    if value.is_empty() {
        return Some("a value is missing behind the equals sign");
    }
    if value.starts_with('[') {
        let spaced =
            value.trim_matches(|c| matches!(c, '[' | ']' | ' ')).split(',').any(|entry| is_two_numbers(entry.trim()));
        return spaced.then_some("entries of a list have commas between them: [0.0, 0.0, 27.5]");
    }
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    let mut parts = value.trim_start_matches(['-', '+']).split(',');
    let numeric = parts.next().is_some_and(digits) && parts.next().is_some_and(|part| digits(part.trim_end()));
    if numeric {
        return Some("numbers have a decimal point and nothing between thousands: 36.5, 300000 or 3e5");
    }
    if value.starts_with(|c: char| c.is_ascii_digit()) && value.contains(|c: char| c.is_ascii_alphabetic()) {
        return Some("numbers stand without their unit: it is part of the key's name");
    }
    if value.starts_with(char::is_alphabetic) && !key.trim().is_empty() {
        return Some("text stands in quotes: \"steel\"");
    }
    None
}

/// `[gear.bearing]`: with single brackets a second one is a duplicate.
fn is_list_header(line: &str) -> bool {
    let name = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).filter(|name| !name.starts_with('['));
    name.is_some_and(|name| {
        ["segment", "body", "bearing"].iter().any(|list| name.trim_end().ends_with(&format!(".{list}")))
    })
}

fn is_two_numbers(entry: &str) -> bool {
    let mut words = entry.split_whitespace();
    let number = |word: Option<&str>| word.is_some_and(|word| word.parse::<f64>().is_ok());
    number(words.next()) && number(words.next())
}

#[cfg(test)]
mod tests {
    use super::hint;

    #[test]
    fn common_slips_are_recognised() {
        for (line, word) in [
            ("length_mm = 36,0", "decimal point"),
            ("kx_n_per_m = 300,000,000  # stiff", "decimal point"),
            ("point_mm = [0.0 0.0, 27.4]", "commas"),
            ("[gear.bearing]", "double brackets"),
            ("length_mm = 36 mm", "part of the key"),
            ("material = steel", "quotes"),
            ("teeth =", "missing"),
        ] {
            assert!(hint(line).is_some_and(|hint| hint.contains(word)), "{line}: {:?}", hint(line));
        }
        for line in ["[gear]", "length_mm = 36.0", "name = \"x\"", "}", ""] {
            assert_eq!(hint(line), None, "{line}");
        }
    }
}
