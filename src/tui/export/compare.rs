//! Two designs beside one another, as a document.

use crate::document::{Column, Curve, Document, Line, Panel, Panels, Picture, Source, Table, Values};
use crate::number::grouped;
use crate::text::printable;
use crate::tui::compare::{CompareView, Compared, ComparedSide};
use crate::tui::traces::range;

impl CompareView {
    /// The values that differ, both spectra, and how both models agree; nothing before they are there.
    pub fn document(&self) -> Option<Document> {
        let result = self.result.as_ref()?;
        let mut notes = Vec::new();
        for (name, side) in ["A", "B"].into_iter().zip(&result.sides) {
            notes.extend(side.as_ref().err().map(|error| format!("{name}: {error}")));
        }
        notes.extend(
            result
                .fe_rms_db
                .map(|rms| format!("The finite element spectra are {rms:.2} dB RMS apart, over all lines.")),
        );
        notes.extend(result.differences.as_ref().err().cloned());
        let sources = self.names.iter().zip(&result.sides).zip(["design A", "design B"]);
        let sources = sources.map(|((name, side), role)| Source {
            role: role.into(),
            name: name.clone(),
            hash: side.as_ref().ok().and_then(|side| side.hash.clone()),
        });
        let data = differences(result);
        Some(Document {
            title: "Comparison of two designs".into(),
            sources: sources.collect(),
            notes,
            picture: picture(result),
            tables: vec![agreements(result), data.clone()],
            data,
        })
    }
}

fn differences(result: &Compared) -> Table {
    let all = result.differences.as_deref().unwrap_or_default();
    let texts = |text: &dyn Fn(&crate::design::Difference) -> String| Values::Texts(all.iter().map(text).collect());
    let safe = |text: &str| printable(text).into_owned();
    Table {
        caption: "Values that differ".into(),
        columns: vec![
            Column::new("value", "value", texts(&|one| safe(&one.label))),
            Column::new("a", "A", texts(&|one| safe(one.shown()[0]))),
            Column::new("b", "B", texts(&|one| safe(one.shown()[1]))),
            Column::new("unit", "unit", texts(&|one| one.unit.to_owned())),
        ],
    }
}

fn agreements(result: &Compared) -> Table {
    let sides = ["A", "B"].into_iter().zip(&result.sides).filter_map(|(name, side)| Some((name, side.as_ref().ok()?)));
    let rows: Vec<_> =
        sides.flat_map(|(name, side)| [(name, "enhanced", &side.enhanced), (name, "basic", &side.basic)]).collect();
    let figures = |figure: &dyn Fn(&crate::agreement::Agreement) -> String| {
        Values::Figures(rows.iter().map(|(.., agreement)| figure(agreement)).collect())
    };
    Table {
        caption: "Lumped models against finite elements, over all lines of the analysis".into(),
        columns: vec![
            Column::new("design", "design", Values::Texts(rows.iter().map(|row| row.0.to_owned()).collect())),
            Column::new("model", "model", Values::Texts(rows.iter().map(|row| row.1.to_owned()).collect())),
            Column::new("limit_hz", "trust up to, Hz", figures(&|one| grouped(one.agreement_limit_hz))),
            Column::new("rms_db", "RMS, dB", figures(&|one| format!("{:.2}", one.rms_db))),
            Column::new("max_db", "largest, dB", figures(&|one| format!("{:.2}", one.max_db))),
            Column::new("max_at_hz", "at, Hz", figures(&|one| grouped(one.max_at_hz))),
            Column::new("frac", "FRAC (0 to 1)", figures(&|one| format!("{:.3}", one.frac))),
        ],
    }
}

fn picture(result: &Compared) -> Option<Picture> {
    let sides: Vec<(&str, Line, &ComparedSide)> = [("A", Line::Fe), ("B", Line::Enhanced)]
        .into_iter()
        .zip(&result.sides)
        .filter_map(|((name, line), side)| Some((name, line, side.as_ref().ok()?)))
        .filter(|(.., side)| !side.fe.is_empty())
        .collect();
    let first = sides.iter().filter_map(|(.., side)| side.frequency.first().copied()).reduce(f64::min)?;
    let last = sides.iter().filter_map(|(.., side)| side.frequency.last().copied()).reduce(f64::max)?;
    let levels: Vec<&[f64]> = sides.iter().map(|(.., side)| side.fe.as_slice()).collect();
    let curve = |(name, line, side): &(&str, Line, &ComparedSide)| Curve {
        line: *line,
        name: (*name).to_owned(),
        points: side.frequency.iter().copied().zip(side.fe.iter().copied()).collect(),
    };
    let panel = Panel {
        label: "FE dynamic mesh force, dB re 1 N".into(),
        range: range(&levels),
        curves: sides.iter().map(curve).collect(),
        levels: Vec::new(),
    };
    Some(Picture::Panels(Panels {
        range: (first, last),
        log: sides.iter().all(|(.., side)| side.log),
        panels: vec![panel],
        bands: Vec::new(),
        band: String::new(),
        marks: Vec::new(),
    }))
}
