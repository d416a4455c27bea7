//! The picture of what a screen shows.

use super::{Picture, panels, shapes};
use crate::document::{self, Document};

/// Nothing where the screen has no picture.
pub fn picture(document: &Document) -> Option<Picture> {
    let (description, height, body) = match document.picture.as_ref()? {
        document::Picture::Panels(panels) => panels::draw(panels),
        document::Picture::Shafts(shafts) => shapes::shafts(shafts),
        document::Picture::Rows(rows) => shapes::rows(rows),
        document::Picture::Matrix(matrix) => shapes::matrix(matrix),
    };
    let names: Vec<&str> = document.sources.iter().map(|source| source.name.as_str()).collect();
    // of many designs the picture itself has the names
    let title = if let [one] = names[..] { format!("{} of {one}", document.title) } else { document.title.clone() };
    Some(Picture { name: "shown", title, description, height, body: body.0 })
}
