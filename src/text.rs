//! Text that came from outside, made harmless before it is shown.

use std::borrow::Cow;
use std::fmt::Write as _;

/// True for what a terminal or a reader's eye could be fooled with: control characters, and format characters that
/// are invisible or turn the direction of the text around.
pub fn is_unprintable(character: char) -> bool {
    character.is_control()
        || matches!(character,
            '\u{ad}' | '\u{61c}' | '\u{180e}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}'
            | '\u{2060}'..='\u{206f}' | '\u{feff}' | '\u{fff9}'..='\u{fffb}' | '\u{e0000}'..='\u{e007f}')
}

/// The text with everything [unprintable](is_unprintable) written out as `\u{1b}`; borrowed where there is nothing to do.
///
/// ```
/// use bevelscope::text::printable;
/// assert_eq!(printable("pinion"), "pinion");
/// assert_eq!(printable("pin\u{1b}[2Jion"), "pin\\u{1b}[2Jion");
/// ```
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.contains(is_unprintable) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for character in text.chars() {
        if is_unprintable(character) {
            // writing to a String cannot fail
            let _ = write!(shown, "\\u{{{:x}}}", u32::from(character));
        } else {
            shown.push(character);
        }
    }
    Cow::Owned(shown)
}

/// At most `limit` characters of the first line of the text, printable, with `...` where something was left out.
pub fn excerpt(text: &str, limit: usize) -> String {
    let line = text.lines().next().unwrap_or_default();
    let mut shown: String = line.chars().take(limit).collect();
    if shown.len() < text.trim_end().len() {
        shown.push_str("...");
    }
    printable(&shown).into_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_text_is_borrowed() {
        for plain in ["", "B1", "Kegelrad über alles", "歯車"] {
            assert!(matches!(printable(plain), Cow::Borrowed(_)), "{plain}");
        }
    }

    // Categories Cc and Cf of the Unicode character database, and the two line separators.
    #[test]
    fn nothing_that_steers_a_terminal_comes_through() {
        for (raw, shown) in [
            ("\u{1b}]0;title\u{7}", "\\u{1b}]0;title\\u{7}"),
            ("a\nb\tc", "a\\u{a}b\\u{9}c"),
            ("\u{7f}\u{9b}31m", "\\u{7f}\\u{9b}31m"),
            ("\u{202e}txt.lmot\u{2066}", "\\u{202e}txt.lmot\\u{2066}"),
            ("\u{200b}\u{2028}\u{2029}\u{feff}", "\\u{200b}\\u{2028}\\u{2029}\\u{feff}"),
        ] {
            assert_eq!(printable(raw), shown);
        }
    }

    #[test]
    fn an_excerpt_is_one_short_line() {
        assert_eq!(excerpt("short", 10), "short");
        assert_eq!(excerpt("rather long", 6), "rather...");
        assert_eq!(excerpt("[\n  1,\n]", 10), "[...");
    }
}
