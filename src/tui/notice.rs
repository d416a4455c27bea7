//! What the explorer has to say, in the footer; and all that it has said, in full.

use super::app::{App, Scroll};
use super::keymap::Mode;

/// A few words in the footer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Notice {
    pub text: String,
    pub kind: NoticeKind,
}

/// What a notice is about, and so how long it stays.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NoticeKind {
    /// Something was done; until the next key.
    Done,
    /// Something could not be done, and why; until the next key.
    Failed,
    /// The library cannot be listed; until it can.
    NotListed,
    /// Something is wrong and stays so; where there is nothing else to be said.
    Standing,
}

impl From<&str> for Notice {
    fn from(text: &str) -> Self {
        text.to_owned().into()
    }
}

impl From<String> for Notice {
    fn from(text: String) -> Self {
        Self { text, kind: NoticeKind::Failed }
    }
}

/// All messages since the start.
#[derive(Debug, Default)]
pub struct Messages {
    /// The latest last.
    all: Vec<String>,
    pub scroll: Scroll,
}

/// As many messages are kept.
const MOST: usize = 100;

impl Messages {
    /// All texts, the latest first.
    pub fn text(&self) -> String {
        if self.all.is_empty() {
            return "Nothing has been said yet.".into();
        }
        self.all.iter().rev().map(|text| text.trim_end()).collect::<Vec<_>>().join("\n\n")
    }

    pub(super) fn keep(&mut self, text: String) {
        if self.all.len() == MOST {
            self.all.remove(0);
        }
        self.all.push(text);
    }
}

impl App {
    /// What is to be said now.
    pub fn shown_notice(&self) -> Option<Notice> {
        let standing = || {
            let text = self.recovery.unprotected.clone()?;
            Some(Notice { text, kind: NoticeKind::Standing })
        };
        self.notice.clone().or_else(standing)
    }

    /// Says that something was done.
    pub fn say(&mut self, text: impl Into<String>) {
        self.notify(text.into(), NoticeKind::Done);
    }

    /// Says that something could not be done, and why.
    pub fn complain(&mut self, text: impl Into<String>) {
        self.notify(text.into(), NoticeKind::Failed);
    }

    /// Says a few words in the footer and keeps the whole text.
    pub fn complain_at_length(&mut self, text: impl Into<String>, full: String) {
        self.notice = Some(text.into().into());
        self.messages.keep(full);
    }

    /// Says that something is so, in a few words, and keeps the whole text.
    pub(super) fn say_at_length(&mut self, text: impl Into<String>, full: String) {
        self.notice = Some(Notice { text: text.into(), kind: NoticeKind::Done });
        self.messages.keep(full);
    }

    pub(super) fn notify(&mut self, text: String, kind: NoticeKind) {
        self.messages.keep(text.clone());
        self.notice = Some(Notice { text, kind });
    }

    /// A key takes away what was said before it.
    pub(super) fn clear_notice(&mut self) {
        self.notice.take_if(|notice| notice.kind != NoticeKind::NotListed);
    }

    pub(super) fn open_messages(&mut self) {
        self.messages.scroll.top = 0;
        self.open(Mode::Messages);
    }
}
