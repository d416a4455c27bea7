//! New designs: from a few wishes to a whole commented file that solves at once.
//!
//! ```text
//! Wishes ─> Pair (sizes, teeth) ─> two Shafts (segments, bodies, bearings) ─> Proposal ─> text of a design file
//! ```
//!
//! Every wish that is not made follows from the others by a rule that is written beside its number. Nothing here reads or writes a file.

mod bearings;
mod field;
mod pair;
mod shaft;
mod text;
mod wishes;

pub use bearings::{BearingKind, GROOVE_FACTOR, TypicalBearing};
pub use field::{Answer, Field};
pub use pair::Pair;
pub use shaft::{Mounting, Shaft};
pub use wishes::{Refusal, Value, Wishes, shown};

use std::collections::BTreeMap;

use super::Side;

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
        let shaft = |side| Shaft::new(wishes, &pair, side);
        let shafts = [shaft(Side::Pinion)?, shaft(Side::Gear)?];
        Ok(Self { wishes: wishes.clone(), pair, shafts })
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
