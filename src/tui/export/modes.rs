//! Natural modes or a deflection shape, as a document.

use crate::design::{BearingModel, Design, Side};
use crate::document::{Column, Curve, Document, Line, Matrix, Picture, Plane, Shaft, Shafts, Source, Table, Values};
use crate::model::ModelKind;
use crate::number::significant;
use crate::response::{Mode, StationShape};
use crate::tui::modes::{ModeRow, ModesView, Moment, PHASES, Partner, SmallStudy, Study};

/// The planes: name, and the displacement that is drawn.
const PLANES: [(&str, usize); 2] = [("x-y", 0), ("y-z", 2)];

impl ModesView {
    /// A word for file names, and what is in sight: the table with the shape of the selected mode or the deflection shape, or the MAC. Nothing before
    /// the modes are there.
    pub fn document(&self) -> Option<(String, Document)> {
        let study = self.study()?;
        let sources = vec![Source { role: "design".into(), name: self.name.clone(), hash: study.hash.clone() }];
        let (name, title, notes, picture, data) = if self.mac.is_some() {
            let small = study.one(self.model)?;
            let model = small.own.kind().name();
            let title = format!("MAC of the {model} modes with those of finite elements");
            let note =
                "Modal assurance criterion, 0 to 1: a row a mode of the lumped model, a column a finite element mode.";
            (format!("mac-{model}"), title, vec![note.to_owned()], mac_picture(small), mac_table(small))
        } else {
            let (name, title, notes) = self.in_words(study);
            let picture = self.moment().map(|moment| picture(&moment, &study.design));
            (name, title, notes, picture, table(&self.rows, study, true))
        };
        let shape = self.moment().filter(|_| self.mac.is_none()).map(|moment| motions(&moment, &study.design));
        let tables = shape.into_iter().chain([table(&self.rows, study, false)]).collect();
        Some((name, Document { title, sources, notes, picture, tables, data }))
    }

    fn in_words(&self, study: &Study) -> (String, String, Vec<String>) {
        let phase = format!("Shapes at phase {} of {PHASES}.", self.phase + 1);
        if let Some(hz) = self.deflection_hz {
            let found = self.deflection.as_ref().and_then(|found| found.as_ref().ok());
            let hz = significant(hz, 6);
            let force =
                found.map(|found| format!("FE dynamic mesh force {} N.", significant(found.fe.force.norm(), 4)));
            let title = format!("Operating deflection shape at {hz} Hz");
            return (format!("deflection-{hz}-hz"), title, force.into_iter().chain([phase]).collect());
        }
        let mode = self.row().and_then(|row| Some((row, row.mode(study)?)));
        let shown = mode.map(|(row, mode)| {
            let number = row.fe.map_or(String::new(), |fe| format!(" {}", fe + 1));
            let strain = 100.0 * mode.mesh_strain_share;
            let hz = significant(mode.frequency_hz, 6);
            format!(
                "The picture shows {}{number}, {hz} Hz: {}; {strain:.0} % of the strain energy is in the mesh.",
                named(row.kind(study)).1,
                mode.name()
            )
        });
        ("modes".into(), "Natural modes".into(), shown.into_iter().chain([phase]).collect())
    }
}

/// Motions of the mesh station along and about the axis, and of the drive: what the picture does not show.
fn motions(moment: &Moment, design: &Design) -> Table {
    let [across, about] = moment.largest;
    let mut names = Vec::new();
    let mut values = vec![Vec::new(); moment.shapes.len()];
    for (at, side) in Side::BOTH.into_iter().enumerate() {
        let rotor = design.rotor(side);
        let at_mesh = |shape: &StationShape<f64>, component: usize| {
            let distance = |position: f64| (position - rotor.mesh_position).abs();
            let stations = shape.positions.iter().zip(&shape.displacements);
            let nearest = stations.min_by(|a, b| distance(*a.0).total_cmp(&distance(*b.0)));
            nearest.map(|(_, station)| station[component])
        };
        names.extend(["axial", "torsion", "drive"].map(|motion| format!("{} {motion}", side.name())));
        for (values, (_, both)) in values.iter_mut().zip(&moment.shapes) {
            let part = |value: Option<f64>, whole: f64| {
                value.filter(|_| whole > 0.0).map_or(String::new(), |value| decimals(value / whole, 3))
            };
            let shape = &both[at];
            values.extend([part(at_mesh(shape, 1), across), part(at_mesh(shape, 4), about), part(shape.drive, about)]);
        }
    }
    let mut columns = vec![Column::new("motion", "motion", Values::Texts(names))];
    columns.extend(moment.shapes.iter().zip(values).map(|((of, _), values)| {
        let name = named(*of).1;
        Column::new(name.clone(), name, Values::Figures(values))
    }));
    let caption =
        "Of the largest displacement of all, or of the largest rotation about an axis: at the mesh, and of the drive";
    Table { caption: caption.into(), columns }
}

/// No sign on what is rounded away.
fn decimals(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.bytes().all(|byte| matches!(byte, b'0' | b'.')) => rest.to_owned(),
        _ => text,
    }
}

/// How its line is drawn, and its name.
fn named(kind: ModelKind) -> (Line, String) {
    let line = match kind {
        ModelKind::Fe => return (Line::Fe, "finite elements".into()),
        ModelKind::Enhanced => Line::Enhanced,
        ModelKind::Basic => Line::Basic,
        ModelKind::Reduced(_) => Line::Reduced,
    };
    (line, kind.name().into())
}

/// Full precision for programs, else as people read it.
fn table(rows: &[ModeRow], study: &Study, exact: bool) -> Table {
    let numbers = |value: &dyn Fn(&ModeRow) -> Option<f64>, decimals: usize| {
        let all = rows.iter().map(value);
        if exact {
            Values::Numbers(all.map(|value| value.unwrap_or(f64::NAN)).collect())
        } else {
            Values::Figures(
                all.map(|value| value.map_or(String::new(), |value| self::decimals(value, decimals))).collect(),
            )
        }
    };
    let mode = |row: &ModeRow| row.mode(study).map(|mode: &Mode| mode.frequency_hz);
    let names = rows.iter().map(|row| row.mode(study).map_or(String::new(), Mode::name)).collect();
    let mut columns = vec![
        Column::new("fe_mode", "FE mode", numbers(&|row| row.fe.map(|fe| (fe + 1) as f64), 0)),
        Column::new("fe_hz", "FE, Hz", numbers(&|row| row.fe.and_then(|_| mode(row)), 2)),
        Column::new("name", "name", Values::Texts(names)),
    ];
    for (at, small) in study.small().enumerate() {
        let model = small.own.kind().name();
        let of = |value: fn(&Partner) -> Option<f64>| move |row: &ModeRow| row.partners[at].as_ref().and_then(value);
        let column =
            |key: &str, name: &str, values| Column::new(format!("{model}_{key}"), format!("{model}{name}"), values);
        columns.push(column("hz", ", Hz", numbers(&of(|one| Some(one.hz)), 2)));
        columns.push(column("shift_percent", " shift, %", numbers(&of(|one| one.shift_percent), 2)));
        columns.push(column("mac", " MAC", numbers(&of(|one| one.mac), 3)));
    }
    let strain = |row: &ModeRow| row.mode(study).map(|mode| 100.0 * mode.mesh_strain_share);
    columns.push(Column::new("mesh_strain_percent", "mesh strain, %", numbers(&strain, 1)));
    Table {
        caption: "Finite element modes with their partners by shape (MAC at least 0.5), and lumped modes without one"
            .into(),
        columns,
    }
}

fn mac_table(small: &SmallStudy) -> Table {
    let mac = &small.mac;
    let model = small.own.kind().name();
    let numbers = (0..mac.nrows()).map(|row| (row + 1) as f64).collect();
    let mut columns = vec![Column::new(format!("{model}_mode"), format!("{model} mode"), Values::Numbers(numbers))];
    columns.extend((0..mac.ncols()).map(|fe| {
        let values = mac.column(fe).iter().copied().collect();
        Column::new(format!("mac_with_fe_mode_{}", fe + 1), format!("FE {}", fe + 1), Values::Numbers(values))
    }));
    Table { caption: "MAC, 0 to 1".into(), columns }
}

fn mac_picture(small: &SmallStudy) -> Option<Picture> {
    let mac = &small.mac;
    let rows: Vec<Vec<f64>> = (0..mac.nrows()).map(|row| mac.row(row).iter().copied().collect()).collect();
    let row_label = format!("{} mode", small.own.kind().name());
    (!rows.is_empty()).then(|| Picture::Matrix(Matrix { row_label, column_label: "finite element mode".into(), rows }))
}

fn picture(moment: &Moment, design: &Design) -> Picture {
    let shaft = |at: usize, side: Side| {
        let rotor = design.rotor(side);
        let shapes = || moment.shapes.iter().map(|(of, both)| (*of, &both[at]));
        let ends = |start: f64, end: fn(&[f64]) -> Option<&f64>, of: fn(f64, f64) -> f64| {
            shapes().filter_map(|(_, shape)| end(&shape.positions).copied()).fold(start, of)
        };
        let plane = |(name, component): (&str, usize)| Plane {
            name: name.into(),
            curves: shapes().map(|(of, shape)| curve(of, shape, component, moment.largest[0])).collect(),
        };
        Shaft {
            name: side.name().into(),
            ends: (ends(0.0, <[f64]>::first, f64::min), ends(0.0, <[f64]>::last, f64::max)),
            bearings: rotor
                .bearings
                .iter()
                .map(|bearing| (bearing.position, matches!(bearing.model, BearingModel::Rigid(_))))
                .collect(),
            mesh: rotor.mesh_position,
            planes: PLANES.into_iter().map(plane).collect(),
        }
    };
    Picture::Shafts(Shafts { shafts: Side::BOTH.into_iter().enumerate().map(|(at, side)| shaft(at, side)).collect() })
}

fn curve(of: ModelKind, shape: &StationShape<f64>, component: usize, largest: f64) -> Curve {
    let (line, name) = named(of);
    let part = |value: f64| if largest > 0.0 { value / largest } else { 0.0 };
    let values = shape.displacements.iter().map(|station| part(station[component]));
    Curve { line, name, points: shape.positions.iter().copied().zip(values).collect() }
}
