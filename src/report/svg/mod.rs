//! Pictures of a study as SVG: of a fixed size, without scripts, links or fonts of their own, in the colours of [`STYLE`].

mod axis;
mod curve;
mod document;
mod frame;
mod levels;
mod panels;
mod shapes;
mod side_view;
mod sketch;
mod spectra;

pub use document::{pair, picture};
pub use levels::levels;
pub use side_view::side_view;
pub use spectra::{harmonics_in_words, spectra};

use std::fmt::Write as _;

use super::markup::escape;

/// Width of every picture, px.
pub const WIDTH: f64 = 800.0;

/// Colours and strokes, for light and dark backgrounds; dashes differ, so that lines are told apart without colour.
pub const STYLE: &str = include_str!("style.css");

/// A drawing with its description in words.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// Part of file names and ids: `spectra`
    pub name: &'static str,
    pub title: String,
    pub description: String,
    pub height: f64,
    /// The elements inside, markup already
    pub body: String,
}

impl Picture {
    /// As an element of an HTML page. `prefix` makes the ids unique there.
    pub fn inline(&self, prefix: &str) -> String {
        self.element("", "", prefix)
    }

    /// As a file of its own, which says where it comes from.
    pub fn file(&self, provenance: &str) -> String {
        let style = format!("<style>{STYLE}</style>\n<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n");
        let attributes =
            format!(" xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{}\"", px(self.height));
        let own = Self { description: format!("{} {provenance}.", self.description), ..self.clone() };
        format!("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{}\n", own.element(&attributes, &style, ""))
    }

    fn element(&self, attributes: &str, first: &str, prefix: &str) -> String {
        let id = format!("{prefix}{}", self.name);
        format!(
            "<svg{attributes} viewBox=\"0 0 {WIDTH} {}\" role=\"img\" aria-labelledby=\"{id}-title {id}-desc\">\n\
             <title id=\"{id}-title\">{}</title>\n<desc id=\"{id}-desc\">{}</desc>\n{first}{}</svg>",
            px(self.height),
            escape(&self.title),
            escape(&self.description),
            self.body,
        )
    }
}

/// A coordinate to 0.01 px, in as few digits as that takes.
fn px(value: f64) -> String {
    // no negative zero
    format!("{}", (value * 100.0).round() / 100.0 + 0.0)
}

/// Where a text is held at its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Anchor {
    Start,
    Middle,
    End,
}

/// Elements one after the other.
#[derive(Debug, Default)]
struct Drawing(String);

impl Drawing {
    fn line(&mut self, class: &str, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
        let [x1, y1, x2, y2] = [x1, y1, x2, y2].map(px);
        self.put(&format!("<line class=\"{class}\" x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"/>"));
    }

    /// A rectangle from one corner to the opposite one, with a text that is shown where it is pointed at.
    fn rect(&mut self, class: &str, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2], title: Option<&str>) {
        let [x, y, width, height] = [x1.min(x2), y1.min(y2), (x2 - x1).abs(), (y2 - y1).abs()].map(px);
        let start = format!("<rect class=\"{class}\" x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\"");
        self.put(&match title {
            Some(title) => format!("{start}><title>{}</title></rect>", escape(title)),
            None => format!("{start}/>"),
        });
    }

    fn text(&mut self, class: &str, [x, y]: [f64; 2], anchor: Anchor, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        self.put(&format!("<text class=\"{class}\" x=\"{}\" y=\"{}\"{anchor}>{}</text>", px(x), px(y), escape(text)));
    }

    /// A line through the places; closed and filled where the class says so.
    fn path(&mut self, class: &str, places: &[[f64; 2]], closed: bool) {
        if places.is_empty() {
            return;
        }
        let mut d = String::with_capacity(14 * places.len());
        for (i, [x, y]) in places.iter().enumerate() {
            // writing to a String cannot fail; a place after the first is joined by a line without a letter of its own
            let _ = write!(d, "{}{} {}", if i == 0 { "M" } else { " " }, px(*x), px(*y));
        }
        let end = if closed { "Z" } else { "" };
        self.put(&format!("<path class=\"{class}\" d=\"{d}{end}\"/>"));
    }

    fn put(&mut self, element: &str) {
        self.0.push_str(element);
        self.0.push('\n');
    }
}

/// About how wide a text is at the size of labels, px: enough to keep labels apart.
fn text_width(text: &str) -> f64 {
    use unicode_width::UnicodeWidthStr;
    6.6 * crate::text::printable(text).width() as f64
}

#[cfg(test)]
mod tests {
    use super::px;

    #[test]
    fn coordinates_are_rounded_and_short() {
        for (value, written) in [(0.0, "0"), (-0.001, "0"), (12.3456, "12.35"), (-7.5, "-7.5"), (800.0, "800")] {
            assert_eq!(px(value), written);
        }
    }
}
