//! One line of text that is being typed.

use super::action::Action;
use crate::text::{cut, cut_start, printable};
use unicode_width::UnicodeWidthStr;

/// A text and where the cursor stands in it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct TextField {
    text: String,
    /// Bytes before the cursor.
    cursor: usize,
    /// The whole text is selected: what is typed first takes its place.
    is_selected: bool,
}

impl TextField {
    /// The text, with the cursor at its end.
    pub fn new(text: impl Into<String>) -> Self {
        let text = text.into();
        Self { cursor: text.len(), text, is_selected: false }
    }

    /// A text that is proposed: what is typed or pasted first takes its place; any other edit keeps it.
    pub fn proposed(text: impl Into<String>) -> Self {
        let mut field = Self::new(text);
        field.select();
        field
    }

    /// Selects the whole text, with the cursor at its end.
    pub fn select(&mut self) {
        self.end();
        self.is_selected = !self.text.is_empty();
    }

    /// Takes the selection back; the text stays.
    pub fn deselect(&mut self) {
        self.is_selected = false;
    }

    /// Whether what is typed next takes the place of the text.
    pub fn is_selected(&self) -> bool {
        self.is_selected
    }

    pub fn text(&self) -> &str {
        &self.text
    }

    pub fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    /// Puts text in at the cursor, or in place of what is selected: what of it is one line, and no control character.
    pub fn insert(&mut self, text: &str) {
        let line: String = text.chars().take_while(|letter| !letter.is_control()).collect();
        if self.is_selected && !line.is_empty() {
            self.text.clear();
            self.cursor = 0;
        }
        self.deselect();
        self.text.insert_str(self.cursor, &line);
        self.cursor += line.len();
    }

    /// What an action does to a text; nothing where it is for something else.
    pub fn edit_of(action: Action) -> Option<fn(&mut Self)> {
        Some(match action {
            Action::TextLeft => Self::left,
            Action::TextRight => Self::right,
            Action::TextStart => Self::start,
            Action::TextEnd => Self::end,
            Action::DeleteCharacter => Self::delete_before,
            Action::DeleteForward => Self::delete_after,
            Action::DeleteWord => Self::delete_word,
            Action::ClearText => Self::delete_to_start,
            _ => return None,
        })
    }

    pub fn left(&mut self) {
        self.deselect();
        self.cursor -= self.before().chars().next_back().map_or(0, char::len_utf8);
    }

    pub fn right(&mut self) {
        self.deselect();
        self.cursor += self.after().chars().next().map_or(0, char::len_utf8);
    }

    pub fn start(&mut self) {
        self.deselect();
        self.cursor = 0;
    }

    pub fn end(&mut self) {
        self.deselect();
        self.cursor = self.text.len();
    }

    /// Takes out the letter before the cursor.
    pub fn delete_before(&mut self) {
        self.deselect();
        let end = self.cursor;
        self.left();
        self.text.drain(self.cursor..end);
    }

    /// Takes out the letter at the cursor.
    pub fn delete_after(&mut self) {
        self.deselect();
        let length = self.after().chars().next().map_or(0, char::len_utf8);
        self.text.drain(self.cursor..self.cursor + length);
    }

    /// Takes out everything before the cursor.
    pub fn delete_to_start(&mut self) {
        self.deselect();
        self.text.drain(..self.cursor);
        self.cursor = 0;
    }

    /// Takes out the word before the cursor, and the blanks between.
    pub fn delete_word(&mut self) {
        self.deselect();
        let word = self.before().trim_end();
        let start = word.rfind(' ').map_or(0, |space| space + 1);
        self.text.drain(start..self.cursor);
        self.cursor = start;
    }

    /// What is seen of it in `width` columns, harmless, and the column of the cursor.
    pub fn shown(&self, width: usize, ellipsis: &str) -> (String, usize) {
        // one column is the cursor's at the end of the text
        let before = cut_start(&printable(self.before()), width.saturating_sub(1), ellipsis);
        let column = before.width();
        let after = cut(&printable(self.after()), width.saturating_sub(column), ellipsis);
        (before + &after, column)
    }

    fn before(&self) -> &str {
        self.text.get(..self.cursor).unwrap_or_default()
    }

    fn after(&self) -> &str {
        self.text.get(self.cursor..).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::TextField;

    #[test]
    fn letters_come_and_go_at_the_cursor() {
        let mut field = TextField::new("Über");
        field.start();
        field.delete_after();
        field.insert("Ü1");
        assert_eq!(field.text(), "Ü1ber");
        field.delete_before();
        field.end();
        field.right();
        field.left();
        field.delete_before();
        assert_eq!(field.text(), "Übr");
        field.end();
        field.insert("m\nq");
        assert_eq!(field.text(), "Übrm");
        field.left();
        field.delete_to_start();
        assert_eq!(field.text(), "m");
        field.end();
        field.insert(" 13 mm ");
        field.delete_word();
        assert_eq!(field.text(), "m 13 ");
        field.delete_word();
        field.delete_word();
        assert_eq!(field.text(), "");
        field.left();
        field.delete_before();
        field.delete_after();
        assert!(field.is_empty());
    }

    #[test]
    fn what_is_typed_first_takes_the_place_of_a_proposal() {
        let mut field = TextField::proposed("300.0");
        field.insert("\n");
        assert_eq!(field.text(), "300.0");
        let mut field = TextField::proposed("300.0");
        assert!(field.is_selected());
        field.insert("6");
        field.insert("00");
        assert_eq!((field.text(), field.is_selected()), ("600", false));
        field.select();
        field.insert("1,5 kN m");
        assert_eq!(field.text(), "1,5 kN m");
        assert!(!TextField::proposed("").is_selected());
    }

    #[test]
    fn any_other_edit_keeps_a_proposal() {
        type Edit = (fn(&mut TextField), &'static str);
        let edits: [Edit; 8] = [
            (TextField::left, "300.1-0"),
            (TextField::right, "300.01-"),
            (TextField::start, "1-300.0"),
            (TextField::end, "300.01-"),
            (TextField::delete_before, "300.1-"),
            (TextField::delete_after, "300.01-"),
            (TextField::delete_word, "1-"),
            (TextField::delete_to_start, "1-"),
        ];
        for (edit, text) in edits {
            let mut field = TextField::proposed("300.0");
            edit(&mut field);
            field.insert("1-");
            assert_eq!(field.text(), text);
        }
    }

    #[test]
    fn the_cursor_is_always_in_sight() {
        let mut field = TextField::new("overhung\u{1b}elastic");
        for width in 0..30 {
            for _ in 0..20 {
                let (shown, column) = field.shown(width, "…");
                assert!(column < width.max(1), "{width}: {shown}");
                assert!(!shown.contains('\u{1b}'));
                field.left();
            }
            field.end();
        }
    }
}
