//! One shaft of a new design: seat of the teeth, two bearings, the end towards the drive.

use std::f64::consts::PI;

use super::bearings::TypicalBearing;
use super::choice::Choice;
use super::field::{Field, MOUNTINGS};
use super::pair::{Pair, SHAFT_STRESS, shaft_diameter, torsional_stress};
use super::wishes::{Refusal, Wishes};
use crate::design::{Body, Side};

/// Where the teeth stand between the bearings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mounting {
    Overhung,
    Straddle,
}

impl Mounting {
    /// As it is asked for.
    pub fn word(self) -> &'static str {
        MOUNTINGS[self as usize]
    }
}

/// A piece of the shaft; m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    pub length: f64,
    pub diameter: f64,
    pub what: &'static str,
    /// Whether it lies between teeth and drive
    pub carries_torque: bool,
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
    /// Greatest nominal torsional stress of the pieces that carry the torque, Pa
    pub stress: f64,
    /// N m/rad
    pub drive_stiffness: f64,
    pub drive_inertia: f64,
}

/// Torsional stress beyond which no shaft is proposed, Pa.
pub(super) const STRESS_LIMIT: f64 = 80e6;
const DENSITY: f64 = 7850.0;
/// Shear modulus of steel of 206 GPa and Poisson's ratio 0.3, Pa.
const SHEAR_MODULUS: f64 = 206e9 / 2.6;

/// To half a millimetre.
fn rounded(length: f64) -> f64 {
    (length * 2e3).round() / 2e3
}

/// To the half millimetre below.
fn rounded_down(length: f64) -> f64 {
    (length * 2e3 + 1e-6).floor() / 2e3
}

struct Layout<'a> {
    pair: &'a Pair,
    at: usize,
    side: Side,
    mounting: Mounting,
    bearings: [TypicalBearing; 2],
}

impl Shaft {
    /// With every bearing before the teeth that is possible, the largest first.
    pub(super) fn all(wishes: &Wishes, pair: &Pair, side: Side) -> Result<Vec<Self>, Refusal> {
        let at = usize::from(side == Side::Gear);
        let mounting = match wishes.word([Field::PinionMounting, Field::GearMounting][at]) {
            Some(word) if word == Mounting::Straddle.word() => Mounting::Straddle,
            None if pair.kind.is_parallel() => Mounting::Straddle,
            _ => Mounting::Overhung,
        };
        let Choice { fronts, rear } = Choice::new(wishes, pair, at, mounting)?;
        fronts.into_iter().map(|front| Layout { pair, at, side, mounting, bearings: [front, rear] }.build()).collect()
    }

    /// m
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(|piece| piece.length).sum()
    }
}

impl Layout<'_> {
    /// Under the teeth: a fifth more than the bore, as far as the teeth leave room.
    fn seat(&self) -> f64 {
        let bore = self.bearings.iter().map(|bearing| bearing.bore).fold(0.0, f64::max);
        // half a millimetre down, so that it stays within the root circle
        rounded_down((1.2 * bore).min(self.pair.room_for_shaft(self.at)))
    }

    /// Towards the drive: 0.8 of the bore, or what the torque asks for, as far as the bore goes.
    fn end(&self) -> f64 {
        let [_, rear] = self.bearings;
        let needed = shaft_diameter(self.pair.torque(self.at), SHAFT_STRESS);
        rounded(0.8 * rear.bore).max(-rounded_down(-needed)).min(rear.bore)
    }

    fn build(self) -> Result<Shaft, Refusal> {
        let [front, rear] = self.bearings;
        let mean_diameter = self.pair.mean_diameters[self.at];
        let seat = self.seat();
        let seat_length = rounded(self.pair.axial_width(self.at) + 4e-3);
        let gap = rounded((0.15 * rear.bore).max(3e-3));
        let piece = |length, diameter, what| Piece { length, diameter, what, carries_torque: true };
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
                pieces.push(Piece { carries_torque: false, ..piece(before, front.bore, "through B1") });
                pieces.push(piece(seat_length, seat, "under the teeth"));
                pieces.push(piece(after, rear.bore, "through B2"));
                let first = rounded(front.width / 2.0);
                (before + seat_length / 2.0, [first, rounded(before + seat_length + gap + rear.width / 2.0)])
            }
        };
        let end = self.end();
        pieces.push(piece(rounded(1.5 * end), end, "to the drive"));
        let torque = self.pair.torque(self.at);
        let carrying = pieces.iter().filter(|piece| piece.carries_torque);
        let stress = carrying.map(|piece| torsional_stress(torque, piece.diameter)).fold(0.0, f64::max);
        if stress > STRESS_LIMIT {
            let message = format!(
                "the root circle of the {} leaves a shaft of {:.1} mm, which carries {torque:.0} N m at over {:.0} MPa: a larger pair",
                self.side.name(),
                seat * 1e3,
                STRESS_LIMIT / 1e6
            );
            return Err(Refusal::new(self.pair.size_field(), message));
        }
        let wheel = self.wheel(mesh_position, &pieces);
        let shaft: f64 = pieces.iter().map(|piece| DENSITY * PI / 32.0 * piece.diameter.powi(4) * piece.length).sum();
        Ok(Shaft {
            mounting: self.mounting,
            mesh_position,
            drive_position: pieces.iter().map(|piece| piece.length).sum(),
            stress,
            drive_stiffness: SHEAR_MODULUS * PI / 32.0 * end.powi(4) / 0.5,
            drive_inertia: 20.0 * (wheel.polar_inertia + shaft),
            pieces,
            wheel,
            bearings: [0, 1].map(|at| Placed { bearing: self.bearings[at], position: positions[at] }),
        })
    }

    /// A disc of the mean diameter, as wide as the face, less the pieces of the shaft that lie in it.
    fn wheel(&self, position: f64, pieces: &[Piece]) -> Body {
        let (outer, width) = (self.pair.mean_diameters[self.at], self.pair.face_width);
        let [mut mass, mut diametral_inertia, mut polar_inertia] = cylinder(outer, width, 0.0);
        let [low, high] = [position - width / 2.0, position + width / 2.0];
        let mut start = 0.0;
        for piece in pieces {
            let end = start + piece.length;
            let [from, to] = [f64::max(start, low), f64::min(end, high)];
            if from < to {
                let within = cylinder(piece.diameter.min(outer), to - from, f64::midpoint(from, to) - position);
                mass -= within[0];
                diametral_inertia -= within[1];
                polar_inertia -= within[2];
            }
            start = end;
        }
        Body { name: self.side.name().into(), position, mass, diametral_inertia, polar_inertia }
    }
}

/// Mass, diametral inertia about a point of the axis at that distance from the middle, and polar inertia, in SI units.
fn cylinder(diameter: f64, length: f64, distance: f64) -> [f64; 3] {
    let mass = DENSITY * PI / 4.0 * diameter * diameter * length;
    let across = diameter * diameter / 16.0 + length * length / 12.0 + distance * distance;
    [mass, mass * across, mass * diameter * diameter / 8.0]
}
