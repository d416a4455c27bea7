//! What a screen shows as text: the data as CSV, the picture as SVG, all of it as a page.

use std::fmt::Write as _;

use super::csv::field;
use super::html;
use super::svg;
use crate::document::{Document, Format, Table, Values};
use crate::text::printable;

/// A screen without a picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("there is no picture in sight: write .csv or .html")]
pub struct NoPicture;

/// The content of a file; `date` as `2026-01-31`.
///
/// # Errors
///
/// [`NoPicture`], if one is asked for.
pub fn text(document: &Document, format: Format, date: &str) -> Result<String, NoPicture> {
    match format {
        Format::Csv => Ok(csv(document)),
        Format::Svg => Ok(svg::picture(document).ok_or(NoPicture)?.file(&document.provenance())),
        Format::Html => Ok(html::shown(document, date)),
    }
}

/// RFC 4180 below one line that begins with `#` and says where it comes from.
fn csv(document: &Document) -> String {
    let Table { columns, .. } = &document.data;
    let keys: Vec<_> = columns.iter().map(|column| field(&printable(&column.key)).into_owned()).collect();
    let mut out = format!("# {}\r\n{}\r\n", printable(&document.provenance()), keys.join(","));
    for row in 0..document.data.rows() {
        for (at, column) in columns.iter().enumerate() {
            if at > 0 {
                out.push(',');
            }
            match &column.values {
                // the shortest form that reads back as the same double; writing to a String cannot fail
                Values::Numbers(values) if values[row].is_nan() => {}
                Values::Numbers(values) => drop(write!(out, "{:?}", values[row])),
                Values::Figures(texts) | Values::Texts(texts) => out.push_str(&field(&printable(&texts[row]))),
            }
        }
        out.push_str("\r\n");
    }
    out
}
