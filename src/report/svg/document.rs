//! The picture of what a screen shows.

use super::{Picture, panels, shapes, sketch};
use crate::design::Design;
use crate::document::{self, Document};
use crate::pair::PairFigures;

/// The gear pair of a design; nothing where there is nothing to draw.
pub fn pair(design: &Design, figures: &PairFigures) -> Option<Picture> {
    let (description, height, body) = sketch::draw(&crate::pair::sketch(design, figures)?);
    Some(Picture { name: "pair", title: format!("Gear pair of {}", design.name), description, height, body: body.0 })
}

/// Nothing where the screen has no picture.
pub fn picture(document: &Document) -> Option<Picture> {
    let (description, height, body) = match document.picture.as_ref()? {
        document::Picture::Panels(panels) => panels::draw(panels),
        document::Picture::Shafts(shafts) => shapes::shafts(shafts),
        document::Picture::Rows(rows) => shapes::rows(rows),
        document::Picture::Matrix(matrix) => shapes::matrix(matrix),
        document::Picture::Sketch(of) => sketch::draw(of),
    };
    let names: Vec<&str> = document.sources.iter().map(|source| source.name.as_str()).collect();
    // of many designs the picture itself has the names
    let title = if let [one] = names[..] { format!("{} of {one}", document.title) } else { document.title.clone() };
    Some(Picture { name: "shown", title, description, height, body: body.0 })
}
