//! The pair as data for files: its picture, and its figures as tables.

use super::{PairFigures, Role, Scene, ShaftFigures, Shape, scenes};
use crate::design::{Design, Side};
use crate::document::{Column, Ink, Place, Sketch, SketchFrame, Stroke, Table, Values};
use crate::number::significant;

/// The pictures of a design; nothing where there is none.
pub fn sketch(design: &Design, figures: &PairFigures) -> Option<Sketch> {
    let frames: Vec<SketchFrame> = scenes(design, figures).iter().map(frame).collect();
    let legend = "Forces of the teeth on each shaft: a axial, r radial, t tangential; a circle with a dot points towards the viewer, with \
                  a cross away. The open dot is the mesh point, filled ones are apexes.";
    (!frames.is_empty()).then(|| Sketch { legend: legend.into(), frames })
}

fn frame(scene: &Scene) -> SketchFrame {
    let ink = |role: Role| match role {
        Role::Pitch(Side::Pinion) => Ink::Pinion,
        Role::Pitch(Side::Gear) => Ink::Gear,
        Role::Axis(_) => Ink::Axis,
        Role::Action => Ink::Action,
    };
    let place = |point: super::scene::Point| -> Place { point.into() };
    let stroke = |shape: &Shape| match *shape {
        Shape::Line { from, to, role } => Stroke::Line { from: place(from), to: place(to), ink: ink(role) },
        Shape::Circle { centre, radius, role } => Stroke::Circle { centre: place(centre), radius, ink: ink(role) },
        Shape::Force { from, to, letter, .. } => {
            Stroke::Arrow { from: place(from), to: place(to), name: letter.to_string() }
        }
        Shape::ForceAcross { at, towards_viewer, letter, .. } => {
            Stroke::Across { at: place(at), towards_viewer, name: letter.to_string() }
        }
        Shape::MeshPoint(at) => Stroke::Dot { at: place(at), filled: false },
        Shape::Apex(at) => Stroke::Dot { at: place(at), filled: true },
        Shape::Label { at, text } => Stroke::Name { at: place(at), text: text.into(), below: true },
    };
    SketchFrame {
        title: scene.titles.first().cloned().unwrap_or_default(),
        strokes: scene.shapes.iter().map(stroke).collect(),
    }
}

/// One figure of both shafts, or of the pair, which then stands under `pair`.
struct Figure {
    key: &'static str,
    name: &'static str,
    unit: &'static str,
    /// Pinion, gear, pair; not a number where there is none
    values: [f64; 3],
}

/// All figures, for spreadsheets in full precision.
pub fn data(design: &Design, figures: &PairFigures) -> Table {
    let all = all(design, figures);
    let numbers = |at: usize| Values::Numbers(all.iter().map(|figure| figure.values[at]).collect());
    table(&all, |figure| figure.key, [0, 1, 2].map(numbers))
}

/// The same for reading, forces with their signs.
pub fn table_of(design: &Design, figures: &PairFigures) -> Table {
    let all = all(design, figures);
    let shown = |at: usize| Values::Figures(all.iter().map(|figure| shown(figure.values[at], figure.key)).collect());
    table(&all, |figure| figure.name, [0, 1, 2].map(shown))
}

fn table(all: &[Figure], name: impl Fn(&Figure) -> &'static str, values: [Values; 3]) -> Table {
    let texts =
        |of: &dyn Fn(&Figure) -> &'static str| Values::Texts(all.iter().map(|figure| of(figure).to_owned()).collect());
    let [pinion, gear, pair] = values;
    Table {
        caption: "Mean forces of the teeth on each shaft: axial along its +y, radial towards its own axis, tangential where it turns the \
                  shaft about its +y; mesh point from the mesh station, line of action as the force on the gear"
            .into(),
        columns: vec![
            Column::new("figure", "figure", texts(&name)),
            Column::new("pinion", "pinion", pinion),
            Column::new("gear", "gear", gear),
            Column::new("pair", "pair", pair),
            Column::new("unit", "unit", texts(&|figure| figure.unit)),
        ],
    }
}

fn shown(value: f64, key: &str) -> String {
    if value.is_nan() {
        return String::new();
    }
    // what is rounding beside sizes of a gear is the zero it stands for
    if value.abs() < 1e-9 {
        return "0".into();
    }
    let is_signed = |key: &str| {
        let ends = ["axial_force", "radial_force", "tangential_force", "torque_arm"];
        ends.contains(&key) || key.starts_with("line_of_action") || key.starts_with("mesh_point")
    };
    let sign = if is_signed(key) && value > 0.0 { "+" } else { "" };
    format!("{sign}{}", significant(value, 5))
}

fn all(design: &Design, figures: &PairFigures) -> Vec<Figure> {
    let both = |key, name, unit, value: &dyn Fn(&ShaftFigures) -> Option<f64>| {
        let [pinion, gear] = Side::BOTH.map(|side| value(figures.shaft(side)).unwrap_or(f64::NAN));
        Figure { key, name, unit, values: [pinion, gear, f64::NAN] }
    };
    let one = |key, name, unit, value: Option<f64>| Figure {
        key,
        name,
        unit,
        values: [f64::NAN, f64::NAN, value.unwrap_or(f64::NAN)],
    };
    let point = |at: usize| move |shaft: &ShaftFigures| Some(shaft.vectors.point[at] * 1e3);
    let line = |at: usize| move |shaft: &ShaftFigures| Some(shaft.vectors.line_of_action[at]);
    let (arms, pair) = (figures.arms.as_ref(), figures.pair.as_ref());
    let distance =
        if figures.has_cones() { ["offset", "offset of the axes"] } else { ["centre_distance", "centre distance"] };
    let mut all = vec![
        both("axial_force", "axial force", "N", &|shaft| Some(shaft.force?.axial)),
        both("radial_force", "radial force", "N", &|shaft| Some(shaft.force?.radial)),
        both("tangential_force", "tangential force", "N", &|shaft| Some(shaft.force?.tangential)),
        one("normal_force", "normal force", "N", figures.normal_force),
        one("torque", "torque of the pinion", "N m", figures.torque.or(figures.normal_force.map(|_| 1.0))),
        both("torque_arm", "torque arm", "mm", &|shaft| Some(shaft.torque_arm * 1e3)),
        both("mesh_point_x", "mesh point x", "mm", &point(0)),
        both("mesh_point_y", "mesh point y", "mm", &point(1)),
        both("mesh_point_z", "mesh point z", "mm", &point(2)),
        both("line_of_action_x", "line of action x", "", &line(0)),
        both("line_of_action_y", "line of action y", "", &line(1)),
        both("line_of_action_z", "line of action z", "", &line(2)),
        one("torque_arm_ratio", "torque arms, gear over pinion", "", arms.map(|arms| arms.ratio)),
        one("tooth_ratio", "teeth, gear over pinion", "", arms.map(super::Arms::tooth_ratio)),
        one("shaft_angle", "shaft angle", "deg", pair.map(|pair| pair.shaft_angle.to_degrees())),
        one(distance[0], distance[1], "mm", pair.map(|pair| pair.offset * 1e3)),
        one("mesh_stiffness", "mesh stiffness", "N/m", Some(design.mesh.stiffness)),
        one("mesh_frequency", "mesh frequency", "Hz", figures.mesh_frequency),
    ];
    all.retain(|figure| !figure.values.iter().all(|value| value.is_nan()));
    all
}

/// What is to be said of the figures: which way the thrust acts, and at which torque the forces are.
pub fn notes(figures: &PairFigures) -> Vec<String> {
    let mut thrust = figures.thrust();
    if let Some(first) = thrust.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    let forces = match (figures.normal_force, figures.torque) {
        (None, _) => "No forces: the line of action meets the axis of the pinion.".to_owned(),
        (_, Some(torque)) => format!("Forces at {} N m on the pinion.", significant(torque, 5)),
        (_, None) => "The design gives no torque: forces are those at 1 N m on the pinion.".to_owned(),
    };
    vec![format!("{thrust}."), forces]
}
