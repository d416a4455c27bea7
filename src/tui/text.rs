//! Words and numbers as the screen shows them.

use std::borrow::Cow;
use std::time::Duration;

use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

/// Text that came from a file, harmless: a control character, and what would turn the reading direction round, is
/// shown by its number instead of being obeyed. Tabs become spaces.
///
/// ```
/// assert_eq!(bevelscope::tui::text::printable("a\u{1b}[2Jb"), "a\\x1b[2Jb");
/// ```
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.chars().any(is_harmful) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 8);
    for character in text.chars() {
        match u32::from(character) {
            0x09 => shown.push_str("    "),
            code if is_harmful(character) && code < 0x100 => shown.extend(['\\', 'x'].into_iter().chain(hex(code, 2))),
            code if is_harmful(character) => {
                shown.push_str("\\u{");
                shown.extend(hex(code, 4));
                shown.push('}');
            }
            _ => shown.push(character),
        }
    }
    Cow::Owned(shown)
}

fn hex(code: u32, digits: u32) -> impl Iterator<Item = char> {
    (0..digits).rev().filter_map(move |place| char::from_digit(code >> (4 * place) & 0xf, 16))
}

fn is_harmful(character: char) -> bool {
    character.is_control()
        || matches!(u32::from(character), 0x61c | 0x200b..=0x200f | 0x2028..=0x202e | 0x2060..=0x206f | 0xfeff)
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
/// is: the marks under a quoted line of a file must stay in place.
pub fn wrap(text: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut lines = Vec::new();
    for line in text.lines() {
        let line = printable(line.trim_end());
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

/// A whole number with its thousands apart.
///
/// ```
/// assert_eq!(bevelscope::tui::text::thousands(2996.7), "2,997");
/// ```
pub fn thousands(value: f64) -> String {
    let rounded = format!("{value:.0}");
    let digits = rounded.trim_start_matches('-');
    if !digits.bytes().all(|byte| byte.is_ascii_digit()) {
        return rounded;
    }
    let mut shown = String::with_capacity(digits.len() + digits.len() / 3 + 1);
    if rounded.len() > digits.len() && digits != "0" {
        shown.push('-');
    }
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            shown.push(',');
        }
        shown.push(digit);
    }
    shown
}

/// A span of time in the unit that suits it.
pub fn duration(elapsed: Duration) -> String {
    let milliseconds = elapsed.as_secs_f64() * 1e3;
    if milliseconds < 10.0 {
        format!("{milliseconds:.1} ms")
    } else if milliseconds < 1000.0 {
        format!("{milliseconds:.0} ms")
    } else {
        format!("{:.1} s", milliseconds / 1e3)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn control_characters_are_shown_not_obeyed() {
        assert_eq!(printable("plain"), "plain");
        assert_eq!(printable("a\tb"), "a    b");
        assert_eq!(printable("\u{9b}31m\u{202e}x"), "\\x9b31m\\u{202e}x");
    }

    #[test]
    fn wrapping_keeps_what_fits_and_breaks_at_spaces() {
        assert_eq!(wrap("  | ^^^\none two three", 9), ["  | ^^^", "one two", "three"]);
        assert_eq!(wrap("abcdefgh", 3), ["abc", "def", "gh"]);
        assert_eq!(wrap("傘", 1).len(), 2);
    }

    #[test]
    fn numbers_have_their_thousands_apart() {
        let shown: Vec<_> = [0.0, -0.2, 999.0, 1000.0, -1_234_567.0].into_iter().map(thousands).collect();
        assert_eq!(shown, ["0", "0", "999", "1,000", "-1,234,567"]);
        assert_eq!(thousands(f64::INFINITY), "inf");
        assert_eq!(duration(Duration::from_micros(612)), "0.6 ms");
        assert_eq!(duration(Duration::from_millis(2540)), "2.5 s");
    }
}
