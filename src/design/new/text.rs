//! The file of a proposal: every number with where it comes from.

use super::Proposal;
use super::bearings::{BearingKind, GROOVE_FACTOR, TypicalBearing};
use super::field::Field;
use super::pair::{SHAFT_STRESS, effective_face_width};
use super::shaft::{Mounting, Placed, Shaft};
use crate::design::{PairKind, Side};
use crate::gear::{Cone, FULL_LOAD, Pitch};

/// Sizes that other numbers must agree with to the last digit, and all others.
const EXACT: usize = 13;
const PLAIN: usize = 4;

impl Proposal {
    /// What the design is called where nothing else is asked for: `Spiral bevel pair 14/39`.
    pub fn title(&self) -> String {
        let kind = self.pair.kind.word().replace('-', " ");
        let mut letters = kind.chars();
        let first = letters.next().map_or(String::new(), |letter| letter.to_uppercase().collect());
        format!("{first}{} pair {}/{}", letters.as_str(), self.pair.teeth[0], self.pair.teeth[1])
    }

    /// The whole design file, under that name.
    pub fn text(&self, name: &str) -> String {
        let mut out = Lines::default();
        self.head(name, &mut out);
        self.mesh(&mut out);
        self.geometry(&mut out);
        for side in [Side::Pinion, Side::Gear] {
            self.shaft(side, &mut out);
        }
        out.text
    }

    fn head(&self, name: &str, out: &mut Lines) {
        let pair = &self.pair;
        let mountings = self.shafts.each_ref().map(|shaft| shaft.mounting.word());
        let [pinion, gear] = mountings;
        out.comment(&format!("{}: made by `bevelscope new`", printable_comment(name)));
        out.line("#");
        out.comment(
            "A first design to go on from. Numbers marked \"asked for\" were given; all others follow from them by the rule beside them and \
             are to be replaced by those of the real parts. Bearings are typical ones of their size, of no maker.",
        );
        out.blank();
        out.line("format = 1");
        out.line(&format!("name = {}", quoted(name)));
        let mounted = if pinion == gear { format!("both {pinion}") } else { format!("pinion {pinion}, gear {gear}") };
        let description = format!("{}, {mounted}; a first design by rules of thumb.", self.title());
        out.line(&format!("description = {}", quoted(&description)));
        let [z1, z2] = pair.teeth;
        out.line(&format!("tags = [\"{}\", \"{z1}/{z2}\", \"first design\"]", pair.kind.word()));
        out.table("[analysis]");
        out.number("frequency_min_hz", 10.0, PLAIN, "designer's choice");
        out.number("frequency_max_hz", 5000.0, PLAIN, "designer's choice");
        out.key("frequency_lines", "1000", "");
        out.number("structural_damping", 0.03, PLAIN, "designer's choice: loss factor of shafts and bearings");
        out.table("[operating]");
        let torque = self.why(Field::PinionTorque, "designer's choice; all bearings take their mean state from it");
        out.number("pinion_torque_n_m", pair.pinion_torque, EXACT, &torque);
        let speed = self.why(Field::PinionSpeed, "designer's choice; marks the mesh frequency only");
        out.number("pinion_speed_rpm", pair.pinion_speed * 30.0 / std::f64::consts::PI, 10, &speed);
    }

    fn mesh(&self, out: &mut Lines) {
        let pair = &self.pair;
        out.table("[mesh]");
        let effective = effective_face_width(pair.kind, pair.face_width) * 1e3;
        let mean_angle = f64::midpoint(pair.spiral_angles[0], pair.spiral_angles[1]).to_degrees();
        let (source, share) = if pair.kind.is_parallel() {
            ("ISO 6336-1", "the face width")
        } else {
            ("ISO 10300-1, method B", "0.85 of the face width")
        };
        let load = written(pair.specific_load / 1e3, 3);
        let under = if pair.specific_load < FULL_LOAD {
            let rule = if pair.kind.is_parallel() { "the fourth root of load" } else { "load" };
            format!("under {load} N/mm, below 100 N/mm in proportion to {rule}")
        } else {
            format!("under {load} N/mm (at least 100 N/mm)")
        };
        out.comment(&format!(
            "estimate: {source}, 20 N/(mm um) over {share}, {}, along the tooth normal at {} deg; {under}",
            mm(effective),
            written(mean_angle, PLAIN)
        ));
        out.number("stiffness_n_per_m", pair.mesh_stiffness, 3, "");
        out.number("damping", 0.06, PLAIN, "designer's choice: loss factor of the tooth contact");
        let error = if pair.kind.is_parallel() { 2.0 } else { 5.0 };
        out.number("transmission_error_um", error, PLAIN, "designer's choice: amplitude at mesh frequency");
    }

    fn geometry(&self, out: &mut Lines) {
        let pair = &self.pair;
        out.blank();
        self.sizes(out);
        out.line("[mesh.geometry]");
        out.key("kind", &quoted(pair.kind.word()), "");
        let pressure = self.why(Field::PressureAngle, "usual value; of the loaded flank");
        out.number("pressure_angle_deg", pair.pressure_angle.to_degrees(), EXACT, &pressure);
        if pair.kind.has_hand() {
            out.key("hand", &quoted(pair.hand.word()), &self.why(Field::Hand, "of the pinion: designer's choice"));
        }
        let turns = if pair.turns_positively() { "positive" } else { "negative" };
        let why = if pair.kind.is_parallel() { "" } else { "thrust away from the apex" };
        out.key("pinion_turns", &quoted(turns), why);
        match &pair.pitch {
            Pitch::Bevel { cones } => self.cones(cones, out),
            Pitch::Parallel { radii, helix_angle } => {
                let rule = "teeth times the transverse module";
                out.number("pinion_pitch_diameter_mm", radii[0] * 2e3, EXACT, rule);
                out.number("gear_pitch_diameter_mm", radii[1] * 2e3, EXACT, rule);
                if pair.kind == PairKind::Helical {
                    let why = self.why(Field::SpiralAngle, "designer's choice");
                    out.number("helix_angle_deg", helix_angle.to_degrees(), EXACT, &why);
                }
            }
        }
    }

    /// What the sizes in the table follow from, which has no keys for it.
    fn sizes(&self, out: &mut Lines) {
        let pair = &self.pair;
        let by_torque =
            "in proportion to the cube root of its torque as sample 1 of ISO 23509, and room for the pinion's shaft";
        let width = match pair.kind {
            PairKind::Hypoid => "0.155 of the outer diameter",
            PairKind::Spur | PairKind::Helical => "10 normal modules",
            _ => "0.3 of the outer cone distance, at most 10 modules",
        };
        let width = format!("face width {}, {}", mm(pair.face_width * 1e3), self.why(Field::FaceWidth, width));
        if let Some(diameter) = pair.gear_outer_diameter {
            let why = self.why(Field::GearOuterDiameter, by_torque);
            out.comment(&format!("Outer pitch diameter of the gear {}, {why}; {width}.", mm(diameter * 1e3)));
        }
        if let Some(module) = pair.normal_module {
            let why = self.why(Field::NormalModule, &format!("of ISO 54; gear {by_torque}"));
            out.comment(&format!("Normal module {}, {why}; {width}.", mm(module * 1e3)));
        }
        if let Some((offset, cutter)) = pair.hypoid {
            let offset =
                format!("Offset {}, {}", mm(offset * 1e3), self.why(Field::Offset, "a tenth of the outer diameter"));
            let usual = "the round size with which the gear is nearest to the start value of ISO 23509, tan = u/1.2";
            out.comment(&format!(
                "{offset}; mean cutter radius {}, {}. Both pitch cones touch at the mean point, at a right angle of the axes; of all \
                 such pairs this one has the limit curvature of the cutter (ISO 23509:2016, method 1).",
                mm(cutter * 1e3),
                self.why(Field::CutterRadius, usual)
            ));
        }
    }

    fn cones(&self, cones: &[Cone; 2], out: &mut Lines) {
        let hypoid = self.pair.kind == PairKind::Hypoid;
        let (angle, distance) = if hypoid {
            ("as said above", "")
        } else {
            ("from the tooth numbers", "outer cone distance less half the face")
        };
        for (side, cone) in ["pinion", "gear"].into_iter().zip(cones) {
            out.number(&format!("{side}_pitch_angle_deg"), cone.pitch_angle.to_degrees(), EXACT, angle);
            out.number(&format!("{side}_mean_cone_distance_mm"), cone.cone_distance * 1e3, EXACT, distance);
        }
        if self.pair.kind.has_hand() {
            let rule = if hypoid { "Gleason's rule 25 + 5 sqrt(u) + 90 offset/diameter" } else { "usual value" };
            let asked = self.why(Field::SpiralAngle, rule);
            let other = if hypoid { "for the tooth ratio" } else { "the same" };
            let [pinion, gear] = self.pair.spiral_angles.map(f64::to_degrees);
            out.number("pinion_spiral_angle_deg", pinion, EXACT, &asked);
            out.number("gear_spiral_angle_deg", gear, EXACT, other);
        }
        for (at, side) in ["pinion", "gear"].into_iter().enumerate() {
            let along = self.pair.cone(at).map_or(0.0, |(_, along)| along);
            let apex = self.shafts[at].mesh_position - along;
            out.number(&format!("{side}_apex_mm"), apex * 1e3, EXACT, "mean point in the plane of the mesh station");
        }
    }

    fn shaft(&self, side: Side, out: &mut Lines) {
        let at = usize::from(side == Side::Gear);
        let (shaft, name) = (&self.shafts[at], side.name());
        let torque = self.pair.torque(at);
        out.blank();
        let rule = match shaft.mounting {
            Mounting::Overhung => {
                "overhung: both bearings behind the teeth, apart by 2.5 times the overhang and 0.7 of the mean diameter at least (rules of thumb)"
            }
            Mounting::Straddle => {
                "straddle mounted: a bearing on either side, apart by 0.7 of the mean diameter at least (rule of thumb)"
            }
        };
        out.comment(&format!("---- {}, {rule}", if at == 0 { "Pinion" } else { "Gear" }));
        out.comment(&format!(
            "Diameters are the bores of the bearings, by default the smallest that carry {} N m at {} MPa in torsion; the teeth leave the \
             room of their root circle. Greatest torsional stress of a solid piece, 16 T/(pi d^3): {} MPa. Lengths follow from teeth and \
             bearings: designer's choice.",
            written(torque, PLAIN).trim_end_matches(".0"),
            SHAFT_STRESS / 1e6,
            written(shaft.stress / 1e6, 3)
        ));
        out.line(&format!("[{name}]"));
        let count = if at == 0 { Field::PinionTeeth } else { Field::GearTeeth };
        out.key("teeth", &self.pair.teeth[at].to_string(), &self.why(count, "designer's choice"));
        out.number("mesh_position_mm", shaft.mesh_position * 1e3, EXACT, "the middle of the teeth");
        for piece in &shaft.pieces {
            out.table(&format!("[[{name}.segment]]"));
            out.number("length_mm", piece.length * 1e3, 6, piece.what);
            out.number("outer_diameter_mm", piece.diameter * 1e3, 6, "");
            let elements = (piece.length / piece.diameter).round().clamp(1.0, 6.0);
            out.key("elements", &format!("{elements}"), "");
        }
        self.wheel(shaft, name, at, out);
        for (place, placed) in shaft.bearings.iter().enumerate() {
            self.bearing(placed, name, at, place, out);
        }
        out.table(&format!("[{name}.drive]"));
        out.number("position_mm", shaft.drive_position * 1e3, 6, if at == 0 { "the engine" } else { "the load" });
        let stiffness = "as half a metre of solid shaft of the end's diameter: designer's choice";
        out.number("torsional_stiffness_n_m_per_rad", shaft.drive_stiffness, 3, stiffness);
        let inertia = "20 times that of shaft and wheel: designer's choice";
        out.number("inertia_kg_m2", shaft.drive_inertia, 3, inertia);
    }

    fn wheel(&self, shaft: &Shaft, name: &str, at: usize, out: &mut Lines) {
        out.blank();
        out.comment(&format!(
            "Solid steel disc of the mean pitch diameter, {}, and the face width, {}, less the pieces of the shaft in it.",
            mm(self.pair.mean_diameters[at] * 1e3),
            mm(self.pair.face_width * 1e3)
        ));
        out.line(&format!("[[{name}.body]]"));
        let wheel = &shaft.wheel;
        out.key("name", &quoted(&wheel.name), "");
        out.number("position_mm", wheel.position * 1e3, EXACT, "");
        out.number("mass_kg", wheel.mass, 6, "");
        out.number("diametral_inertia_kg_m2", wheel.diametral_inertia, 6, "");
        out.number("polar_inertia_kg_m2", wheel.polar_inertia, 6, "");
    }

    fn bearing(&self, placed: &Placed, name: &str, at: usize, place: usize, out: &mut Lines) {
        let Placed { bearing, position } = placed;
        let field = [[Field::PinionB1, Field::PinionB2], [Field::GearB1, Field::GearB2]][at][place];
        out.blank();
        out.comment(&format!(
            "{}, {}: typical {} bearing {} x {} x {} mm, of no maker; {}.",
            bearing.name(),
            self.why(field, "fits the shaft"),
            bearing.kind.plain(),
            written(bearing.bore * 1e3, PLAIN).trim_end_matches(".0"),
            written(bearing.outside_diameter * 1e3, PLAIN).trim_end_matches(".0"),
            written(bearing.width * 1e3, PLAIN).trim_end_matches(".0"),
            bearing.kind.source()
        ));
        out.line(&format!("[[{name}.bearing]]"));
        out.key("name", &quoted(&format!("B{}", place + 1)), "");
        out.number("position_mm", position * 1e3, 6, "");
        inner_sizes(bearing, place == 0, out);
        out.key("mean_load", "\"from-torque\"", "");
        let approach = bearing.mounting_preload() * 1e6;
        out.number("mounting_preload_um", approach, PLAIN, "designer's choice: axial approach at assembly");
    }

    /// Where an answer comes from.
    fn why(&self, field: Field, rule: &str) -> String {
        if self.wishes.is_given(field) { "asked for".into() } else { rule.into() }
    }
}

fn inner_sizes(bearing: &TypicalBearing, is_front: bool, out: &mut Lines) {
    let is_tapered = bearing.kind == BearingKind::Tapered;
    out.key("model", if is_tapered { "\"roller\"" } else { "\"ball\"" }, "");
    out.key("elements", &bearing.elements().to_string(), "");
    let (angle, takes) = if bearing.kind == BearingKind::DeepGroove {
        (if is_front { bearing.contact_angle } else { -bearing.contact_angle }, "takes thrust both ways")
    } else if is_front {
        (bearing.contact_angle, "takes thrust towards +y")
    } else {
        (-bearing.contact_angle, "set against the other one, back to back")
    };
    out.number("contact_angle_deg", angle.to_degrees(), PLAIN, takes);
    if let Some(length) = bearing.roller_length() {
        out.number("pitch_radius_mm", bearing.pitch_diameter() * 1e3 / 2.0, PLAIN, "");
        out.number("roller_length_mm", length * 1e3, PLAIN, "");
    } else {
        out.number("ball_diameter_mm", bearing.element_diameter() * 1e3, PLAIN, "");
        out.number("pitch_diameter_mm", bearing.pitch_diameter() * 1e3, PLAIN, "");
        out.number("inner_groove_factor", GROOVE_FACTOR, PLAIN, "");
        out.number("outer_groove_factor", GROOVE_FACTOR, PLAIN, "");
    }
}

/// The text as it grows.
#[derive(Default)]
struct Lines {
    text: String,
}

impl Lines {
    fn line(&mut self, line: &str) {
        self.text.push_str(line);
        self.text.push('\n');
    }

    fn blank(&mut self) {
        self.line("");
    }

    fn table(&mut self, head: &str) {
        self.blank();
        self.line(head);
    }

    fn comment(&mut self, text: &str) {
        for line in crate::text::wrap(text, 110) {
            self.line(format!("# {line}").trim_end());
        }
    }

    fn key(&mut self, key: &str, value: &str, comment: &str) {
        let line = format!("{key} = {value}");
        if comment.is_empty() { self.line(&line) } else { self.line(&format!("{line:<44} # {comment}")) }
    }

    fn number(&mut self, key: &str, value: f64, digits: usize, comment: &str) {
        self.key(key, &written(value, digits), comment);
    }
}

/// A number as TOML has it, to so many significant digits.
fn written(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value);
    if rounded != 0.0 && !(1e-4..1e6).contains(&rounded.abs()) {
        format!("{rounded:e}")
    } else {
        format!("{rounded:?}")
    }
}

fn mm(value: f64) -> String {
    format!("{} mm", written(value, 6).trim_end_matches(".0"))
}

/// A basic string of TOML.
fn quoted(text: &str) -> String {
    toml_edit::Value::from(text).to_string()
}

fn printable_comment(name: &str) -> String {
    name.chars().map(|letter| if letter.is_control() { ' ' } else { letter }).collect()
}
