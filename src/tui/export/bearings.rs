//! The bearings under their mean load, as a document.

use super::source;
use crate::bearing::State;
use crate::document::{Column, Document, Ink, Picture, Sketch, SketchFrame, Stroke, Table, Values};
use crate::number::{grouped, significant};
use crate::rotor::Support;
use crate::text::printable;
use crate::tui::app::App;
use crate::tui::bearings::{BearingRow, displacement, failure, is_stale, load, rows, shown_torque, torque};

const MOTIONS: [&str; 6] = ["x", "y", "z", "thx", "thy", "thz"];

impl App {
    /// All bearings, and the elements of the selected one; nothing before there is any.
    pub(super) fn bearings_document(&self) -> Option<Document> {
        let (view, editing) = (self.bearings.as_ref()?, self.editors.open()?);
        let rows = rows(editing);
        let selected = *rows.get(view.cursor)?;
        let torque = editing.last_design.as_ref().and_then(|design| torque(design));
        let mut notes = vec![torque.map_or_else(
            || "The design gives no torque.".to_owned(),
            |torque| format!("Torque of the pinion: {} N m.", shown_torque(torque)),
        )];
        if is_stale(editing) {
            notes.push("The figures are stale: those of an earlier state of the design.".into());
        }
        notes.extend(failure(editing).map(|reason| printable(reason).into_owned()));
        for row in &rows {
            let warnings = row.rolling.map_or(&[][..], |rolling| &rolling.state.warnings);
            notes.extend(warnings.iter().map(|warning| format!("{}: {warning}.", name(row))));
        }
        let state = selected.rolling.map(|rolling| &rolling.state);
        let mut tables = vec![table(&rows, None, &exact_or_read(false))];
        tables.extend(state.map(|state| elements(&selected, state)));
        tables.extend(selected.support.map(|support| stiffness(&selected, support)));
        Some(Document {
            title: "Bearings under load".into(),
            sources: vec![source(editing)],
            notes,
            picture: state.map(|state| Picture::Sketch(polar(&selected, state))),
            tables,
            data: table(&rows, Some(&selected), &exact_or_read(true)),
        })
    }
}

fn name(row: &BearingRow<'_>) -> String {
    format!("{} {}", row.side.name(), printable(&row.bearing.name))
}

/// In full precision, or as people read them.
fn exact_or_read(exact: bool) -> impl Fn(Vec<f64>) -> Values {
    let read = |value: f64| if value.is_nan() { String::new() } else { significant(value, 5) };
    move |values| if exact { Values::Numbers(values) } else { Values::Figures(values.into_iter().map(read).collect()) }
}

/// A row a bearing; then one for each element of `selected`, which repeats its name.
fn table(rows: &[BearingRow<'_>], selected: Option<&BearingRow<'_>>, figures: &dyn Fn(Vec<f64>) -> Values) -> Table {
    let elements = selected.and_then(|row| Some((row, row.rolling?)));
    let contacts = elements.map_or(&[][..], |(_, rolling)| &rolling.state.contacts);
    let all = || rows.iter().chain(contacts.iter().filter_map(|_| selected));
    let texts = |text: &dyn Fn(&BearingRow<'_>) -> String| Values::Texts(all().map(text).collect());
    let number = |value: &dyn Fn(&BearingRow<'_>) -> Option<f64>| {
        let of_bearings = rows.iter().map(|row| value(row).unwrap_or(f64::NAN));
        figures(of_bearings.chain(contacts.iter().map(|_| f64::NAN)).collect())
    };
    let mut columns = vec![
        Column::new("shaft", "shaft", texts(&|row| row.side.name().to_owned())),
        Column::new("bearing", "bearing", texts(&|row| printable(&row.bearing.name).into_owned())),
        Column::new("model", "model", texts(&|row| row.bearing.model.word().to_owned())),
        Column::new("position_mm", "position, mm", number(&|row| Some(row.bearing.position * 1e3))),
    ];
    for (at, motion) in MOTIONS.into_iter().enumerate().filter(|(at, _)| *at != 4) {
        let (key, unit) = if at < 3 { ("force", "N") } else { ("moment", "N m") };
        let motion = motion.trim_start_matches("th");
        let value = |row: &BearingRow<'_>| Some(load(row.rolling?)[at]);
        let ends = unit.to_lowercase().replace(' ', "_");
        columns.push(Column::new(format!("{key}_{motion}_{ends}"), format!("{key} {motion}, {unit}"), number(&value)));
    }
    for (at, motion) in MOTIONS.into_iter().enumerate().filter(|(at, _)| *at != 4) {
        let (scale, unit) = if at < 3 { (1e6, "um") } else { (1e3, "mrad") };
        let value = |row: &BearingRow<'_>| Some(displacement(row.rolling?)[at] * scale);
        columns.push(Column::new(format!("{motion}_{unit}"), format!("{motion}, {unit}"), number(&value)));
    }
    columns.extend([
        Column::new("loaded", "loaded", number(&|row| Some(row.rolling?.state.loaded() as f64))),
        Column::new("elements", "elements", number(&|row| Some(row.rolling?.state.contacts.len() as f64))),
        Column::new("greatest_load_n", "greatest load, N", number(&|row| Some(row.rolling?.state.greatest_load()))),
    ]);
    if selected.is_some() {
        let of_elements = |value: &dyn Fn(usize) -> f64| {
            figures(rows.iter().map(|_| f64::NAN).chain((0..contacts.len()).map(value)).collect())
        };
        let numbers = (0..contacts.len()).map(|at| at.to_string());
        let numbers = rows.iter().map(|_| String::new()).chain(numbers).collect();
        columns.extend([
            Column::new("element", "element", Values::Texts(numbers)),
            Column::new("azimuth_deg", "azimuth, deg", of_elements(&|at| contacts[at].position.to_degrees())),
            Column::new("element_load_n", "load, N", of_elements(&|at| contacts[at].load)),
            Column::new("contact_angle_deg", "contact angle, deg", of_elements(&|at| contacts[at].angle.to_degrees())),
        ]);
    }
    let caption = "Mean loads on the inner rings, displacements of the inner rings; empty where the stiffness is given";
    Table { caption: caption.into(), columns }
}

fn elements(row: &BearingRow<'_>, state: &State) -> Table {
    let figures = |value: &dyn Fn(&crate::bearing::Contact) -> String| {
        Values::Figures(state.contacts.iter().map(value).collect())
    };
    let numbers = (0..state.contacts.len()).map(|at| at.to_string()).collect();
    Table {
        caption: format!("Elements of {}; azimuth from +z towards +x", name(row)),
        columns: vec![
            Column::new("element", "element", Values::Texts(numbers)),
            Column::new("azimuth_deg", "azimuth, deg", figures(&|one| format!("{:.1}", one.position.to_degrees()))),
            Column::new("load_n", "load, N", figures(&|one| grouped(one.load))),
            Column::new(
                "contact_angle_deg",
                "contact angle, deg",
                figures(&|one| if one.load > 0.0 { format!("{:.1}", one.angle.to_degrees()) } else { String::new() }),
            ),
        ],
    }
}

fn stiffness(row: &BearingRow<'_>, support: &Support) -> Table {
    let entries = |j: usize| Values::Figures((0..6).map(|i| significant(support.stiffness[(i, j)], 5)).collect());
    let heads = MOTIONS.into_iter().enumerate().map(|(j, motion)| Column::new(motion, motion, entries(j)));
    let motions = Values::Texts(MOTIONS.map(str::to_owned).into());
    Table {
        caption: format!("Stiffness of {}, N/m, N/rad = N, N m/rad", name(row)),
        columns: std::iter::once(Column::new("motion", "motion", motions)).chain(heads).collect(),
    }
}

/// The ring as seen from +y: z up, x to the left. A bar stands outwards on each element that carries a load, as long as the load.
fn polar(row: &BearingRow<'_>, state: &State) -> Sketch {
    const LONGEST: f64 = 0.8;
    let place = |azimuth: f64, radius: f64| [-radius * azimuth.sin(), radius * azimuth.cos()];
    let greatest = state.greatest_load();
    let part = |load: f64| if greatest > 0.0 { LONGEST * load / greatest } else { 0.0 };
    let mut strokes = vec![Stroke::Circle { centre: [0.0; 2], radius: 1.0, ink: Ink::Axis }];
    // the whole picture keeps one size, whatever the loads are
    strokes.extend([0.0, 0.25, 0.5, 0.75].map(|turn| Stroke::Name {
        at: place(turn * std::f64::consts::TAU, 1.0 + LONGEST),
        text: ["z", "x", "-z", "-x"][(turn * 4.0) as usize].into(),
        below: false,
    }));
    for (at, contact) in state.contacts.iter().enumerate() {
        let azimuth = contact.position;
        if contact.load > 0.0 {
            let to = place(azimuth, 1.0 + part(contact.load));
            strokes.push(Stroke::Line { from: place(azimuth, 1.0), to, ink: Ink::Pinion });
        }
        strokes.push(Stroke::Dot { at: place(azimuth, 1.0), filled: contact.load > 0.0 });
        let inside = place(azimuth, 0.88);
        strokes.push(Stroke::Name { at: inside, text: at.to_string(), below: false });
    }
    // radial load: X is z, Y is x in the bearing's own frame
    let [x, z] = [state.load[1], state.load[0]];
    let size = x.hypot(z);
    if size > 1e-9 * greatest {
        let to = place(x.atan2(z), 0.7);
        strokes.push(Stroke::Arrow { from: [0.0; 2], to, name: format!("{} N", grouped(size)) });
    }
    let title = format!("{}: element loads as seen from +y, z up, x to the left", name(row));
    let legend = format!(
        "Bars are as long as the loads, the longest {} N; filled dots carry a load. The arrow is the radial load on the inner ring. Elements \
         are numbered from +z towards +x.",
        grouped(greatest)
    );
    Sketch { legend, frames: vec![SketchFrame { title, strokes }] }
}
