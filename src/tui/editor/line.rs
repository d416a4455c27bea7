//! One line of text while it is typed.

use unicode_width::UnicodeWidthChar;

use crate::text::is_unprintable;

/// A text with a cursor between its letters.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Line {
    text: String,
    /// In bytes, at the border of a letter
    cursor: usize,
}

impl Line {
    /// A text with the cursor at its end.
    pub fn new(text: impl Into<String>) -> Self {
        let text = text.into();
        Self { cursor: text.len(), text }
    }

    pub fn text(&self) -> &str {
        &self.text
    }

    /// Puts in what is one line of the text and no control character.
    pub fn insert(&mut self, text: &str) {
        let line: String = text.chars().take_while(|letter| !letter.is_control()).collect();
        self.text.insert_str(self.cursor, &line);
        self.cursor += line.len();
    }

    pub fn left(&mut self) {
        self.cursor -= self.text[..self.cursor].chars().next_back().map_or(0, char::len_utf8);
    }

    pub fn right(&mut self) {
        self.cursor += self.text[self.cursor..].chars().next().map_or(0, char::len_utf8);
    }

    pub fn home(&mut self) {
        self.cursor = 0;
    }

    pub fn end(&mut self) {
        self.cursor = self.text.len();
    }

    /// Deletes the letter before the cursor.
    pub fn backspace(&mut self) {
        let end = self.cursor;
        self.left();
        self.text.drain(self.cursor..end);
    }

    /// Deletes the letter after the cursor.
    pub fn delete(&mut self) {
        let start = self.cursor;
        self.right();
        self.text.drain(start..self.cursor);
        self.cursor = start;
    }

    /// Deletes everything before the cursor.
    pub fn delete_to_start(&mut self) {
        self.text.drain(..self.cursor);
        self.cursor = 0;
    }

    /// Deletes the word before the cursor, and the spaces between.
    pub fn delete_word(&mut self) {
        let word = self.text[..self.cursor].trim_end();
        let start = word.rfind(' ').map_or(0, |space| space + 1);
        self.text.drain(start..self.cursor);
        self.cursor = start;
    }

    /// What is in sight through a window of that many columns, harmless to show, and the cursor's column in it.
    pub fn window(&self, width: usize) -> (String, usize) {
        let letters = |text: &str| -> Vec<(char, usize)> {
            text.chars()
                .map(|letter| if is_unprintable(letter) { ('?', 1) } else { (letter, letter.width().unwrap_or(1)) })
                .collect()
        };
        let (before, after) = (letters(&self.text[..self.cursor]), letters(&self.text[self.cursor..]));
        // the cursor needs a column of its own, also after the last letter
        let room = width.saturating_sub(1);
        let (mut shown, mut used) = (Vec::new(), 0);
        for &(letter, columns) in before.iter().rev() {
            if used + columns > room {
                break;
            }
            used += columns;
            shown.push(letter);
        }
        shown.reverse();
        let cursor = used;
        for (letter, columns) in after {
            if used + columns > width {
                break;
            }
            used += columns;
            shown.push(letter);
        }
        (shown.into_iter().collect(), cursor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_come_and_go_at_the_cursor() {
        let mut line = Line::new("35 mm");
        line.home();
        line.insert("1");
        line.right();
        line.delete();
        assert_eq!(line.text(), "13 mm");
        line.end();
        line.backspace();
        line.insert("m\nq");
        assert_eq!(line.text(), "13 mm");
        line.delete_word();
        assert_eq!(line.text(), "13 ");
        line.delete_word();
        assert_eq!(line.text(), "");
        line.insert("αβγ");
        line.left();
        line.delete_to_start();
        assert_eq!(line.text(), "γ");
        for _ in 0..3 {
            line.left();
            line.backspace();
            line.right();
            line.delete();
        }
        assert_eq!(line.text(), "γ");
    }

    #[test]
    fn the_cursor_is_always_in_sight() {
        let mut line = Line::new("0123456789");
        assert_eq!(line.window(5), ("6789".into(), 4));
        line.home();
        assert_eq!(line.window(5), ("01234".into(), 0));
        assert_eq!(Line::new("傘歯車").window(4), ("車".into(), 2));
        assert_eq!(Line::new("a\u{1b}b").window(9), ("a?b".into(), 3));
        assert_eq!(line.window(0), (String::new(), 0));
    }
}
