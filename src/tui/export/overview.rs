//! All designs with their figures, as a document.

use crate::document::{Column, Document, Picture, Rows, Source, Table, Values};
use crate::text::printable;
use crate::tui::app::App;
use crate::tui::library::{Row, RowState};
use crate::tui::overview::{Column as Of, SPAN_DB, reason};

impl App {
    /// The rows in sight and in their order, with the filter.
    pub(super) fn overview_document(&self) -> Document {
        let rows = self.overview_rows();
        let hash = |row: &Row| row.loaded.as_ref().and_then(|loaded| loaded.hash.clone());
        let texts = |text: &dyn Fn(&Row) -> String| Values::Texts(rows.iter().map(|row| text(row)).collect());
        let safe = |text: &str| printable(text).into_owned();
        let names = texts(&|row| safe(&row.stem));
        let hashes = texts(&|row| hash(row).unwrap_or_default());
        let reasons = texts(&|row| reason(row).unwrap_or_default());
        let any_reason = rows.iter().any(|row| reason(row).is_some());
        let table = |figures: &dyn Fn(Of) -> Values, has_reasons: bool| {
            let mut columns = vec![Column::new("design", "design", names.clone())];
            columns.extend(Of::ALL[1..].iter().map(|of| Column::new(of.key(), of.name(), figures(*of))));
            columns.push(Column::new("hash", "hash", hashes.clone()));
            if has_reasons {
                columns.push(Column::new("error", "error", reasons.clone()));
            }
            Table { caption: "Lumped models against finite elements, over all lines of each analysis".into(), columns }
        };
        let exact = |of: Of| Values::Numbers(rows.iter().map(|row| of.figure(row).unwrap_or(f64::NAN)).collect());
        let read = |of: Of| {
            Values::Figures(rows.iter().map(|row| of.figure(row).map_or(String::new(), |_| of.shown(row))).collect())
        };
        let sources = rows.iter().map(|row| Source { role: "design".into(), name: safe(&row.stem), hash: hash(row) });
        let spectra: Vec<(String, Vec<f64>)> = rows
            .iter()
            .filter_map(|row| match &row.state {
                RowState::Solved(summary) => Some((safe(&row.stem), summary.fe_outline.clone())),
                _ => None,
            })
            .collect();
        let levels = spectra.iter().flat_map(|(_, levels)| levels).copied().filter(|level| level.is_finite());
        let top = levels.fold(f64::NEG_INFINITY, f64::max);
        let picture = Rows {
            label: "FE dynamic mesh force over the lines of each analysis, dB re 1 N".into(),
            range: (top - SPAN_DB, top),
            rows: spectra,
        };
        let filter = self.library.filter();
        Document {
            title: "Overview of designs".into(),
            notes: if filter.is_empty() { Vec::new() } else { vec![format!("Filter: {}", safe(filter))] },
            picture: (!picture.rows.is_empty()).then_some(Picture::Rows(picture)),
            tables: vec![table(&read, any_reason)],
            data: table(&exact, true),
            sources: sources.collect(),
        }
    }
}
