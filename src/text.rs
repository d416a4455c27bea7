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

/// Two texts, each in at most `width` columns, cut so that the first place where they differ is in sight.
///
/// ```
/// use bevelscope::text::cut_apart;
/// let texts = ["the same long beginning, then this", "the same long beginning, then that"];
/// assert_eq!(cut_apart(texts, 12, ".."), [".. then this", ".. then that"]);
/// ```
pub fn cut_apart(texts: [&str; 2], width: usize, ellipsis: &str) -> [String; 2] {
    let [a, b] = texts;
    let same = a.chars().zip(b.chars()).take_while(|(a, b)| a == b).map(|(a, _)| a.len_utf8()).sum::<usize>();
    let after = |text: &str| text[same..].chars().next().and_then(UnicodeWidthChar::width).unwrap_or(1).max(1);
    let needed = a[..same].width() + after(a).max(after(b)) + ellipsis.width();
    if needed <= width || texts.iter().all(|text| text.width() <= width) {
        return texts.map(|text| cut(text, width, ellipsis));
    }
    // some of what is the same stays before it; the longer one is cut at the left as little as possible
    let rest = texts.map(|text| text[same..].width()).into_iter().max().unwrap_or(0);
    let room = width.saturating_sub(ellipsis.width());
    let kept = (room.saturating_sub(ellipsis.width()) / 2).max(room.saturating_sub(rest));
    let start = cut_start(&a[..same], kept, "").len();
    texts.map(|text| cut(&format!("{ellipsis}{}", &text[same - start..]), width, ellipsis))
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

/// As [`wrap`], but lines quoted from a file, `  12 | kq = 6e8`, and the marks under them, `     | ^^`, are cut so that the
/// marks stay below what they mark.
pub fn wrap_quoted(text: &str, width: usize, ellipsis: &str) -> Vec<String> {
    let mut lines = Vec::new();
    let mut rest = text.lines().peekable();
    while let Some(line) = rest.next() {
        let Some(gutter) = gutter(line) else {
            lines.extend(if line.is_empty() { vec![String::new()] } else { wrap(line, width) });
            continue;
        };
        let marks = rest.next_if(|next| is_marks(next));
        // the marks, or as much of them as there is room for, are in sight
        let room = width.saturating_sub(gutter.width() + ellipsis.width());
        let marked = marks.map_or("", |marks| &marks[marks.find('|').map_or(0, |at| at + 1)..]);
        let start = marked.width() - marked.trim_start().width();
        let skipped = if marked.width() > room { start.saturating_sub(room / 2) } else { 0 };
        let cut_line = |line: &str, with: &str| {
            let line = printable(&line.replace('\t', "    ")).into_owned();
            let (head, tail) = line.split_at(line.find('|').map_or(0, |at| at + 1));
            if skipped == 0 {
                return cut(&line, width, with);
            }
            let tail = &tail[prefix(tail, skipped + with.width()).len()..];
            cut(&format!("{head}{with}{tail}"), width, with)
        };
        lines.push(cut_line(line, ellipsis));
        let blank = " ".repeat(ellipsis.width());
        lines.extend(marks.map(|marks| cut_line(marks, &blank).trim_end().to_owned()));
    }
    lines
}

/// `  12 |` of a line that is quoted with its number.
fn gutter(line: &str) -> Option<&str> {
    let (number, _) = line.split_once('|')?;
    let is_number = number.trim().bytes().all(|byte| byte.is_ascii_digit());
    (is_number && number.starts_with(' ')).then(|| &line[..=number.len()])
}

fn is_marks(line: &str) -> bool {
    line.split_once('|').is_some_and(|(before, marks)| before.trim().is_empty() && marks.trim_start().starts_with('^'))
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
    fn two_texts_are_cut_where_they_differ() {
        assert_eq!(cut_apart(["short", "shore"], 9, "…"), ["short", "shore"]);
        // from the start as long as that shows it
        assert_eq!(cut_apart(["6.0e8 and so on", "7.0e8 and so on"], 9, "…"), ["6.0e8 an…", "7.0e8 an…"]);
        for width in 3..40 {
            let texts = ["傘歯車装置, overhung and elastic".to_owned(), "傘歯車装置, overhung and rigid".to_owned()];
            let [a, b] = cut_apart([&texts[0], &texts[1]], width, "…");
            assert!(a != b && a.width() <= width && b.width() <= width, "{width}: {a} {b}");
        }
    }

    #[test]
    fn marks_stay_below_what_they_mark() {
        let quoted = "a.toml:14: an unknown key\n  14 | first = 1, second = 2, third = 3\n     |                        ^^^^^\n\nthe end";
        for width in 14..60 {
            let lines = wrap_quoted(quoted, width, "…");
            assert!(lines.iter().all(|line| line.width() <= width), "{width}: {lines:?}");
            let at = lines.iter().position(|line| line.starts_with("  14 |")).unwrap();
            let column = |line: &str, what: &str| line.find(what).map(|at| line[..at].width());
            let marks = column(&lines[at + 1], "^").unwrap();
            assert_eq!(
                column(&lines[at], "third").or(column(&lines[at], "thi")).or(column(&lines[at], "t")),
                Some(marks),
                "{width}: {lines:?}"
            );
            assert_eq!(lines.last().unwrap(), "the end");
            assert_eq!(lines[lines.len() - 2], "");
        }
    }

    #[test]
    fn wrapping_keeps_what_fits_and_breaks_at_spaces() {
        assert_eq!(wrap("  | ^^^\none two three", 9), ["  | ^^^", "one two", "three"]);
        assert_eq!(wrap("abcdefgh", 3), ["abc", "def", "gh"]);
        assert_eq!(wrap("傘", 1).len(), 2);
    }
}
