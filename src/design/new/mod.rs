//! New designs: from a few wishes to a whole commented file that solves at once.
//!
//! ```text
//! Wishes ─> Pair (sizes, teeth) ─> two Shafts (segments, bodies, bearings) that clear one another ─> Proposal ─> text of a design file
//! ```
//!
//! Every wish that is not made follows from the others by a rule that is written beside its number. Nothing here reads or writes a file.

mod bearings;
mod choice;
mod clearance;
mod field;
mod pair;
mod shaft;
mod text;
mod wishes;

pub use bearings::{BearingKind, GROOVE_FACTOR, TypicalBearing};
pub use field::{Answer, Field};
pub use pair::Pair;
pub use shaft::{Mounting, Piece, Placed, Shaft};
pub use wishes::{Refusal, Value, Wishes, shown};

use std::collections::BTreeMap;

use super::Side;
use crate::number::significant;

/// A design as it would be made.
#[derive(Debug, Clone, PartialEq)]
pub struct Proposal {
    pub wishes: Wishes,
    pub pair: Pair,
    /// Pinion first
    pub shafts: [Shaft; 2],
}

impl Proposal {
    /// Sizes everything.
    ///
    /// # Errors
    ///
    /// [`Refusal`] names the wish that cannot be, and its limit.
    pub fn new(wishes: &Wishes) -> Result<Self, Refusal> {
        let pair = Pair::new(wishes)?;
        let [pinions, gears] = [Shaft::all(wishes, &pair, Side::Pinion)?, Shaft::all(wishes, &pair, Side::Gear)?];
        let mut last = None;
        for pinion in &pinions {
            for gear in &gears {
                let Some(collision) = clearance::collision(&pair, pinion, gear) else {
                    let shafts = [pinion.clone(), gear.clone()];
                    return Ok(Self { wishes: wishes.clone(), pair, shafts });
                };
                // of the smallest bearings
                last = Some(collision);
            }
        }
        let [of_pinion, of_gear] = last.unwrap_or(["shaft"; 2]);
        let straddle = |shafts: &[Shaft]| shafts.iter().any(|shaft| shaft.mounting == Mounting::Straddle);
        let (field, instead) = match [straddle(&pinions), straddle(&gears)] {
            [true, _] => (Field::PinionMounting, "overhung, or a larger pair"),
            [false, true] => (Field::GearMounting, "overhung, or a larger pair"),
            [false, false] => (pair.size_field(), "a larger pair, or smaller bearings"),
        };
        Err(Refusal::new(field, format!("the pinion's {of_pinion} would run into the gear's {of_gear}: {instead}")))
    }

    /// Sizes that follow, each with its unit: what it is, and how large for pinion and gear.
    pub fn facts(&self) -> Vec<(&'static str, String)> {
        let pair = &self.pair;
        let both = |values: [f64; 2], unit: &str| {
            let [pinion, gear] = values.map(|value| significant(value, 4));
            format!("{pinion} / {gear} {unit}")
        };
        let mut facts = vec![
            ("ratio", significant(pair.ratio(), 4)),
            ("torques", both([0, 1].map(|at| pair.torque(at)), "N m")),
            ("mean diameters", both(pair.mean_diameters.map(|diameter| diameter * 1e3), "mm")),
        ];
        if let (Some((pinion, _)), Some((gear, _))) = (pair.cone(0), pair.cone(1)) {
            facts.push(("pitch angles", both([pinion, gear].map(f64::to_degrees), "deg")));
        }
        if pair.kind.has_hand() {
            facts.push(("spiral angles", both(pair.spiral_angles.map(f64::to_degrees), "deg")));
        }
        let lengths = self.shafts.each_ref().map(|shaft| shaft.length() * 1e3);
        facts.push(("shafts, long", both(lengths, "mm")));
        facts.push(("mesh stiffness", format!("{} N/m", significant(pair.mesh_stiffness, 3))));
        let mesh_frequency = pair.pinion_speed / std::f64::consts::TAU * f64::from(pair.teeth[0]);
        facts.push(("mesh frequency", format!("{} Hz", significant(mesh_frequency, 4))));
        facts
    }

    /// All answers, those that were given and those that follow.
    pub fn answers(&self) -> BTreeMap<Field, Value> {
        let pair = &self.pair;
        let mut all = BTreeMap::new();
        let mut number = |field: Field, value: Option<f64>| {
            all.extend(value.map(|value| (field, Value::Number(value))));
        };
        number(Field::PinionTeeth, Some(f64::from(pair.teeth[0])));
        number(Field::GearTeeth, Some(f64::from(pair.teeth[1])));
        number(Field::PinionTorque, Some(pair.pinion_torque));
        number(Field::PinionSpeed, Some(pair.pinion_speed));
        number(Field::GearOuterDiameter, pair.gear_outer_diameter);
        number(Field::NormalModule, pair.normal_module);
        number(Field::FaceWidth, Some(pair.face_width));
        number(Field::SpiralAngle, pair.kind.has_hand().then_some(pair.spiral_angles[0]));
        number(Field::Offset, pair.hypoid.map(|(offset, _)| offset));
        number(Field::CutterRadius, pair.hypoid.map(|(_, cutter_radius)| cutter_radius));
        number(Field::PressureAngle, Some(pair.pressure_angle));
        let [pinion, gear] = &self.shafts;
        let mut word = |field: Field, word: String| all.insert(field, Value::Word(word));
        word(Field::Kind, pair.kind.word().into());
        if pair.kind.has_hand() {
            word(Field::Hand, pair.hand.word().into());
        }
        word(Field::PinionMounting, pinion.mounting.word().into());
        word(Field::GearMounting, gear.mounting.word().into());
        word(Field::PinionB1, pinion.bearings[0].bearing.name());
        word(Field::PinionB2, pinion.bearings[1].bearing.name());
        word(Field::GearB1, gear.bearings[0].bearing.name());
        word(Field::GearB2, gear.bearings[1].bearing.name());
        all
    }
}
