//! Text that came from outside, made harmless and cut to size before it is shown.

use std::borrow::Cow;
use std::fmt::Write as _;

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

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

/// `text` in at most `width` columns, with `ellipsis` where something was cut off.
pub fn cut(text: &str, width: usize, ellipsis: &str) -> String {
    if text.width() <= width {
        return text.to_owned();
    }
    let room = width.saturating_sub(ellipsis.width());
    let mut shown = prefix(text, room).to_owned();
    shown.push_str(prefix(ellipsis, width));
    shown
}

/// As [`cut`], but keeps the end: the last folders of a path say more than the first.
pub fn cut_start(text: &str, width: usize, ellipsis: &str) -> String {
    if text.width() <= width {
        return text.to_owned();
    }
    let room = width.saturating_sub(ellipsis.width());
    let mut used = 0;
    let start = text
        .char_indices()
        .rev()
        .take_while(|(_, character)| {
            used += character.width().unwrap_or(0);
            used <= room
        })
        .last()
        .map_or(text.len(), |(at, _)| at);
    format!("{}{}", prefix(ellipsis, width), &text[start..])
}

/// The longest start of `text` that fits `width` columns.
pub fn prefix(text: &str, width: usize) -> &str {
    let mut used = 0;
    for (at, character) in text.char_indices() {
        used += character.width().unwrap_or(0);
        if used > width {
            return &text[..at];
        }
    }
    text
}

/// Breaks `text` into lines of at most `width` columns, at spaces where there are some. A line that fits is left as it
/// is: the marks under a quoted line of a file must stay in place. Tabs become spaces, all else is [`printable`].
pub fn wrap(text: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut lines = Vec::new();
    for line in text.lines() {
        let line = line.trim_end().replace('\t', "    ");
        let line = printable(&line);
        let mut rest: &str = &line;
        while rest.width() > width {
            let mut head = prefix(rest, width);
            if let Some(space) = head.rfind(' ').filter(|&at| !head[..at].trim().is_empty()) {
                head = &rest[..space];
            }
            if head.is_empty() {
                // a character wider than the line: nothing can be shown of it
                head = &rest[..rest.chars().next().map_or(0, char::len_utf8)];
            }
            lines.push(head.to_owned());
            rest = rest[head.len()..].trim_start();
        }
        lines.push(rest.to_owned());
    }
    lines
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

    #[test]
    fn names_are_cut_by_columns_not_by_bytes() {
        assert_eq!(cut("overhung", 8, "…"), "overhung");
        assert_eq!(cut("overhung-elastic", 8, "…"), "overhun…");
        assert_eq!(cut("傘歯車装置", 5, "…"), "傘歯…");
        assert_eq!(cut("overhung", 0, "…"), "");
        assert_eq!(cut("overhung", 2, "..."), "..");
        assert_eq!(cut_start("/home/me/designs", 9, "…"), "…/designs");
    }

    #[test]
    fn wrapping_keeps_what_fits_and_breaks_at_spaces() {
        assert_eq!(wrap("  | ^^^\none two three", 9), ["  | ^^^", "one two", "three"]);
        assert_eq!(wrap("abcdefgh", 3), ["abc", "def", "gh"]);
        assert_eq!(wrap("傘", 1).len(), 2);
    }
}
