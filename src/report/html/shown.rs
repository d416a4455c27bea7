//! What a screen shows, as a page of its own.

use std::fmt::Write as _;

use super::start;
use super::table::{Cell, Table};
use crate::document::{self, Document, Values};
use crate::number::significant;
use crate::report::markup::escape;
use crate::report::svg;

/// The whole page; `date` as `2026-01-31`.
pub fn shown(document: &Document, date: &str) -> String {
    let mut out = start(&document.title);
    // writing to a String cannot fail
    let _ = write!(out, "<main>\n<h1>{}</h1>\n<dl class=\"facts\">\n", escape(&document.title));
    for source in &document.sources {
        let hash = source.hash.as_ref().map_or_else(|| "no file".into(), |hash| format!("hash {hash} (SHA-256)"));
        let (role, name) = (escape(&source.role), escape(&source.name));
        let _ = writeln!(out, "<dt>{role}</dt><dd><bdi>{name}</bdi>, {}</dd>", escape(&hash));
    }
    let version = env!("CARGO_PKG_VERSION");
    let _ = write!(
        out,
        "<dt>program</dt><dd>bevelscope {version}</dd>\n<dt>date</dt><dd><time datetime=\"{0}\">{0}</time></dd>\n</dl>\n",
        escape(date)
    );
    if let Some(picture) = svg::picture(document) {
        let _ = writeln!(out, "<figure>\n{}\n</figure>", picture.inline(""));
    }
    for note in &document.notes {
        let _ = writeln!(out, "<p>{}</p>", escape(note));
    }
    for table in document.tables.iter().filter(|table| table.rows() > 0) {
        out.push_str(&rendered(table));
    }
    out.push_str("</main>\n</body>\n</html>\n");
    out
}

pub(super) fn rendered(table: &document::Table) -> String {
    let head = |column: &document::Column| match column.values {
        Values::Texts(_) => column.name.clone(),
        Values::Numbers(_) | Values::Figures(_) => format!("{}#", column.name),
    };
    let mut out = Table::new(&table.caption, table.columns.iter().map(head));
    for row in 0..table.rows() {
        let cell = |column: &document::Column| match &column.values {
            Values::Texts(texts) => Cell::name(&texts[row]),
            Values::Figures(texts) => Cell::number_or_none(Some(texts[row].clone()).filter(|text| !text.is_empty())),
            Values::Numbers(values) => Cell::number_or_none(
                Some(values[row]).filter(|value| !value.is_nan()).map(|value| significant(value, 6)),
            ),
        };
        out.row(table.columns.iter().map(cell));
    }
    out.render()
}
