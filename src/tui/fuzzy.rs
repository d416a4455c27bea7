//! Letters of a name in their order, with others between them.

/// How well the letters of `pattern` are found in `text`, in their order; nothing where they are not. Letters at the start
/// of a word count most, then those that follow one another. Case and spaces of the pattern do not matter.
///
/// ```
/// use bevelscope::tui::fuzzy::score;
/// assert!(score("rd", "restore-deleted") > score("rd", "reread"));
/// assert_eq!(score("xyz", "restore-deleted"), None);
/// ```
pub fn score(pattern: &str, text: &str) -> Option<i32> {
    const LETTER: i32 = 8;
    const WORD_START: i32 = 8;
    const IN_A_ROW: i32 = 9;
    const FIRST: i32 = 4;
    let pattern: Vec<char> = pattern.chars().filter(|c| !c.is_whitespace()).flat_map(char::to_lowercase).collect();
    let text: Vec<char> = text.chars().flat_map(char::to_lowercase).collect();
    if pattern.len() > text.len() {
        return None;
    }
    // best[i]: the best score with the letters so far, the last of them at i
    let mut best: Vec<Option<i32>> = Vec::new();
    for (place, &letter) in pattern.iter().enumerate() {
        let mut before: Option<i32> = if place == 0 { Some(0) } else { None };
        let mut row = Vec::with_capacity(text.len());
        for (i, &found) in text.iter().enumerate() {
            let word_start = i == 0 || !text[i - 1].is_alphanumeric();
            let own = LETTER + if word_start { WORD_START } else { 0 } + if i == 0 { FIRST } else { 0 };
            let in_a_row = i.checked_sub(1).and_then(|i| *best.get(i)?).map(|score| score + IN_A_ROW);
            row.push(if found == letter { before.max(in_a_row).map(|score| score + own) } else { None });
            before = before.max(best.get(i).copied().flatten());
        }
        best = row;
    }
    if pattern.is_empty() { Some(0) } else { best.into_iter().flatten().max() }
}

#[cfg(test)]
mod tests {
    use super::score;

    #[test]
    fn starts_of_words_and_letters_in_a_row_count_most() {
        for (pattern, better, worse) in [
            ("re", "reread", "toggle-tree"),
            ("rd", "restore-deleted", "reread"),
            ("dup", "duplicate", "delete-up"),
            ("h", "help", "page-up-h"),
            ("nm", "next-match", "rename"),
        ] {
            assert!(score(pattern, better) > score(pattern, worse), "{pattern}");
        }
        for (pattern, text) in [("xq", "quit"), ("tiuq", "quit"), ("quits", "quit"), ("a", "")] {
            assert_eq!(score(pattern, text), None, "{pattern}");
        }
        assert_eq!(score("", "anything"), Some(0));
        assert_eq!(score("QU it", "quit"), score("quit", "quit"));
    }
}
