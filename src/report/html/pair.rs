//! The gear pair: to scale, and what its teeth do to both shafts.

use std::fmt::Write as _;

use super::shown::rendered;
use crate::design::Design;
use crate::pair::{PairFigures, notes, table_of};
use crate::report::markup::escape;
use crate::report::svg::{self, Picture};

/// `figure` puts a picture with its caption into a page.
pub fn render(design: &Design, figure: impl Fn(&Picture, &str) -> String) -> String {
    let figures = PairFigures::new(design);
    let mut out =
        svg::pair(design, &figures).map_or_else(String::new, |picture| figure(&picture, &picture.description));
    for note in notes(&figures) {
        // writing to a String cannot fail
        let _ = writeln!(out, "<p>{}</p>", escape(&note));
    }
    out + &rendered(&table_of(design, &figures))
}
