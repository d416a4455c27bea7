//! Tables with a caption, heads in words and in code, and a first column that names the row.

use std::fmt::Write as _;

use crate::report::markup::escape;

/// One cell, markup already.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    class: &'static str,
    content: String,
}

impl Cell {
    pub fn text(text: &str) -> Self {
        Self { class: "", content: escape(text) }
    }

    /// A name from a file: its own direction does not turn what is around it.
    pub fn name(text: &str) -> Self {
        Self { class: "", content: format!("<bdi>{}</bdi>", escape(text)) }
    }

    pub fn number(text: &str) -> Self {
        Self { class: " class=\"n\"", content: escape(text) }
    }

    /// A number where there is one.
    pub fn number_or_none(text: Option<String>) -> Self {
        text.map_or_else(Self::none, |text| Self::number(&text))
    }

    pub fn none() -> Self {
        Self { class: " class=\"n\"", content: "–".into() }
    }

    /// What holds where a file says nothing.
    pub fn default(self) -> Self {
        Self { content: format!("<i>{}</i>", self.content), ..self }
    }
}

#[derive(Debug)]
pub struct Table {
    caption: String,
    /// Text, and whether numbers stand below it
    heads: Vec<(String, bool)>,
    rows: Vec<Vec<Cell>>,
}

impl Table {
    /// Units belong into the heads; one that ends with `#` has numbers below it.
    pub fn new(caption: &str, heads: impl IntoIterator<Item = impl AsRef<str>>) -> Self {
        let head = |head: &str| match head.strip_suffix('#') {
            Some(head) => (head.to_owned(), true),
            None => (head.to_owned(), false),
        };
        Self {
            caption: caption.into(),
            heads: heads.into_iter().map(|text| head(text.as_ref())).collect(),
            rows: Vec::new(),
        }
    }

    pub fn row(&mut self, cells: impl IntoIterator<Item = Cell>) {
        self.rows.push(cells.into_iter().collect());
    }

    pub fn render(&self) -> String {
        /// A table of at most this many rows is not parted between pages.
        const SHORT: usize = 24;
        let class = if self.rows.len() <= SHORT { " class=\"short\"" } else { "" };
        let label = escape(&self.caption);
        let mut out = format!(
            "<div class=\"wide\" role=\"region\" tabindex=\"0\" aria-label=\"{label}\">\n\
             <table{class}>\n<caption>{label}</caption>\n<thead><tr>"
        );
        for (head, numbers) in &self.heads {
            let class = if *numbers { " class=\"n\"" } else { "" };
            // writing to a String cannot fail
            let _ = write!(out, "<th scope=\"col\"{class}>{}</th>", escape(head));
        }
        out.push_str("</tr></thead>\n<tbody>\n");
        for row in &self.rows {
            out.push_str("<tr>");
            for (i, Cell { class, content }) in row.iter().enumerate() {
                let start = if i == 0 { "th scope=\"row\"" } else { "td" };
                let _ = write!(out, "<{start}{class}>{content}</{}>", &start[..2]);
            }
            out.push_str("</tr>\n");
        }
        out.push_str("</tbody>\n</table>\n</div>\n");
        out
    }
}
