//! One shaft of a new design: seat of the teeth, two bearings, the end towards the drive.

use std::f64::consts::PI;

use super::bearings::{BearingKind, TypicalBearing};
use super::field::Field;
use super::pair::{Pair, SHAFT_STRESS, shaft_diameter};
use super::wishes::{Refusal, Wishes};
use crate::design::{Body, PairKind, Side};

/// Where the teeth stand between the bearings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mounting {
    Overhung,
    Straddle,
}

impl Mounting {
    /// As it is asked for.
    pub fn word(self) -> &'static str {
        match self {
            Self::Overhung => "overhung",
            Self::Straddle => "straddle",
        }
    }
}

/// A piece of the shaft; m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    pub length: f64,
    pub diameter: f64,
    pub what: &'static str,
}

/// A bearing at its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placed {
    pub bearing: TypicalBearing,
    pub position: f64,
}

/// A shaft from its free end at y = 0; SI units.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaft {
    pub mounting: Mounting,
    pub mesh_position: f64,
    pub pieces: Vec<Piece>,
    /// The teeth with what carries them, without the shaft inside
    pub wheel: Body,
    pub bearings: [Placed; 2],
    pub drive_position: f64,
    /// N m/rad
    pub drive_stiffness: f64,
    pub drive_inertia: f64,
}

/// Torsional stress beyond which no shaft is proposed, Pa.
const STRESS_LIMIT: f64 = 80e6;
const DENSITY: f64 = 7850.0;
/// Shear modulus of steel of 206 GPa and Poisson's ratio 0.3, Pa.
const SHEAR_MODULUS: f64 = 206e9 / 2.6;

/// To half a millimetre.
fn rounded(length: f64) -> f64 {
    (length * 2e3).round() / 2e3
}

struct Layout<'a> {
    pair: &'a Pair,
    at: usize,
    side: Side,
    mounting: Mounting,
    bearings: [TypicalBearing; 2],
}

impl Shaft {
    pub(super) fn new(wishes: &Wishes, pair: &Pair, side: Side) -> Result<Self, Refusal> {
        let at = usize::from(side == Side::Gear);
        let mounting = match wishes.word([Field::PinionMounting, Field::GearMounting][at]) {
            Some("straddle") => Mounting::Straddle,
            None if pair.kind.is_parallel() => Mounting::Straddle,
            _ => Mounting::Overhung,
        };
        let bearings = bearings(wishes, pair, at, mounting)?;
        Ok(Layout { pair, at, side, mounting, bearings }.build())
    }

    /// m
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.length).sum()
    }
}

/// The bearings asked for, else the smallest of the usual kind whose bore carries the torque.
fn bearings(wishes: &Wishes, pair: &Pair, at: usize, mounting: Mounting) -> Result<[TypicalBearing; 2], Refusal> {
    let fields = [[Field::PinionB1, Field::PinionB2], [Field::GearB1, Field::GearB2]][at];
    let shaft = ["pinion", "gear"][at];
    let (torque, mean_diameter) = (pair.torque(at), pair.mean_diameters[at]);
    let needed = shaft_diameter(torque, SHAFT_STRESS);
    let kind = match pair.kind {
        PairKind::Spur => BearingKind::DeepGroove,
        PairKind::Helical => BearingKind::AngularContact,
        _ => BearingKind::Tapered,
    };
    let given = |field: Field| wishes.word(field).and_then(TypicalBearing::named);
    let listed = || TypicalBearing::of_kind(kind);
    let size = if pair.kind.is_parallel() { Field::NormalModule } else { Field::GearOuterDiameter };
    let rear = match given(fields[1]) {
        Some(bearing) => bearing,
        None => listed().find(|bearing| bearing.bore >= needed).ok_or_else(|| {
            let message = format!(
                "{torque:.0} N m need a {shaft} shaft of {:.0} mm at {:.0} MPa: the list of bearings ends at 100 mm",
                needed * 1e3,
                SHAFT_STRESS / 1e6
            );
            Refusal::new(Field::PinionTorque, message)
        })?,
    };
    // a shaft may be thicker than the teeth before it, up to a point
    if rear.bore > 1.5 * mean_diameter {
        let message = format!(
            "a {shaft} of {:.1} mm mean diameter is too small for its shaft of {:.0} mm under {torque:.0} N m",
            mean_diameter * 1e3,
            rear.bore * 1e3
        );
        return Err(Refusal::new(if wishes.is_given(fields[1]) { fields[1] } else { size }, message));
    }
    // no torque passes the bearing before the teeth
    let carries = [mounting == Mounting::Overhung, true];
    let widest = if carries[0] { 1.5 * mean_diameter } else { 0.8 * mean_diameter };
    let front = match given(fields[0]) {
        Some(bearing) => bearing,
        None => listed().take_while(|one| one.bore <= rear.bore.min(widest)).last().ok_or_else(|| {
            let message = format!(
                "a {shaft} of {:.1} mm mean diameter leaves no room for a bearing before it: overhung, or a larger pair",
                mean_diameter * 1e3
            );
            Refusal::new(size, message)
        })?,
    };
    let chosen = [front, rear];
    // what follows from the other is blamed last
    for place in [1, 0] {
        let (bearing, field) = (chosen[place], fields[place]);
        let bore = bearing.bore * 1e3;
        if carries[place] && bearing.bore < shaft_diameter(torque, STRESS_LIMIT) {
            let least = shaft_diameter(torque, STRESS_LIMIT) * 1e3;
            let limit = STRESS_LIMIT / 1e6;
            let message =
                format!("a shaft of {bore:.0} mm carries {torque:.0} N m at over {limit:.0} MPa: from {least:.0} mm");
            return Err(Refusal::new(field, message));
        }
        if place == 0 && bearing.bore > widest {
            let message =
                format!("at most {:.0} mm fit a {shaft} of {:.1} mm mean diameter", widest * 1e3, mean_diameter * 1e3);
            return Err(Refusal::new(field, message));
        }
    }
    Ok(chosen)
}

impl Layout<'_> {
    /// Under the teeth: a fifth more than the bore, as far as the teeth leave room.
    fn seat(&self) -> f64 {
        let bore = self.bearings.iter().map(|bearing| bearing.bore).fold(0.0, f64::max);
        rounded((1.2 * bore).min(0.8 * self.pair.mean_diameters[self.at])).max(2e-3)
    }

    fn build(self) -> Shaft {
        let [front, rear] = self.bearings;
        let mean_diameter = self.pair.mean_diameters[self.at];
        let seat = self.seat();
        let seat_length = rounded(self.pair.axial_width(self.at) + 4e-3);
        let gap = rounded((0.15 * rear.bore).max(3e-3));
        let piece = |length, diameter, what| Piece { length, diameter, what };
        let mut pieces = Vec::new();
        let (mesh_position, positions) = match self.mounting {
            Mounting::Overhung => {
                let mesh = seat_length / 2.0;
                let first = rounded(seat_length + gap + front.width / 2.0);
                // the usual rules for overhung wheels
                let span = (2.5 * (first - mesh)).max(0.7 * mean_diameter);
                let second = rounded(first + span);
                pieces.push(piece(seat_length, seat, "under the teeth"));
                let middle = rounded(f64::midpoint(first, second));
                let end = rounded(second + rear.width / 2.0);
                if front.bore == rear.bore {
                    pieces.push(piece(end - seat_length, rear.bore, "through both bearings"));
                } else {
                    pieces.push(piece(middle - seat_length, front.bore, "through B1"));
                    pieces.push(piece(end - middle, rear.bore, "through B2"));
                }
                (mesh, [first, second])
            }
            Mounting::Straddle => {
                let close = seat_length + f64::midpoint(front.width, rear.width);
                let gap = rounded(gap.max((0.7 * mean_diameter - close) / 2.0));
                let before = rounded(front.width + gap);
                let after = rounded(gap + rear.width);
                pieces.push(piece(before, front.bore, "through B1"));
                pieces.push(piece(seat_length, seat, "under the teeth"));
                pieces.push(piece(after, rear.bore, "through B2"));
                let first = rounded(front.width / 2.0);
                (before + seat_length / 2.0, [first, rounded(before + seat_length + gap + rear.width / 2.0)])
            }
        };
        let end_diameter = rounded(0.8 * rear.bore);
        pieces.push(piece(rounded(1.5 * end_diameter), end_diameter, "to the drive"));
        let wheel = self.wheel(mesh_position, seat);
        let shaft: f64 = pieces.iter().map(|piece| DENSITY * PI / 32.0 * piece.diameter.powi(4) * piece.length).sum();
        Shaft {
            mounting: self.mounting,
            mesh_position,
            drive_position: pieces.iter().map(|piece| piece.length).sum(),
            drive_stiffness: SHEAR_MODULUS * PI / 32.0 * end_diameter.powi(4) / 0.5,
            drive_inertia: 20.0 * (wheel.polar_inertia + shaft),
            pieces,
            wheel,
            bearings: [0, 1].map(|at| Placed { bearing: self.bearings[at], position: positions[at] }),
        }
    }

    /// A ring from the shaft to the mean diameter, as wide as the face.
    fn wheel(&self, position: f64, seat: f64) -> Body {
        let (outer, width) = (self.pair.mean_diameters[self.at], self.pair.face_width);
        let mass = DENSITY * PI / 4.0 * (outer * outer - seat * seat) * width;
        let squares = (outer * outer + seat * seat) / 4.0;
        Body {
            name: if self.side == Side::Pinion { "pinion" } else { "gear" }.into(),
            position,
            mass,
            diametral_inertia: mass * (squares / 4.0 + width * width / 12.0),
            polar_inertia: mass * squares / 2.0,
        }
    }
}
