//! Which bearings of the list a shaft gets.

use super::bearings::{BearingKind, TypicalBearing};
use super::field::Field;
use super::pair::{Pair, SHAFT_STRESS, shaft_diameter};
use super::shaft::{Mounting, STRESS_LIMIT};
use super::wishes::{Refusal, Wishes};
use crate::design::PairKind;

/// The bearings asked for, else the smallest of the usual kind whose bore carries the torque.
pub(super) struct Choice {
    /// B1: at least one, the largest first
    pub fronts: Vec<TypicalBearing>,
    /// B2
    pub rear: TypicalBearing,
}

impl Choice {
    pub(super) fn new(wishes: &Wishes, pair: &Pair, at: usize, mounting: Mounting) -> Result<Self, Refusal> {
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
        let size = pair.size_field();
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
        let widest = if carries[0] { 1.5 * mean_diameter } else { pair.room_for_shaft(at) };
        let fronts = match given(fields[0]) {
            Some(bearing) => vec![bearing],
            None => listed().filter(|one| one.bore <= rear.bore.min(widest)).collect(),
        };
        let Some(largest) = fronts.last().copied() else {
            let message = format!(
                "a {shaft} of {:.1} mm mean diameter leaves no room for a bearing before it: overhung, or a larger pair",
                mean_diameter * 1e3
            );
            return Err(Refusal::new(size, message));
        };
        let chosen = [largest, rear];
        // what follows from the other is blamed last
        for place in [1, 0] {
            let (bearing, field) = (chosen[place], fields[place]);
            let bore = bearing.bore * 1e3;
            if carries[place] && bearing.bore < shaft_diameter(torque, STRESS_LIMIT) {
                let least = shaft_diameter(torque, STRESS_LIMIT) * 1e3;
                let limit = STRESS_LIMIT / 1e6;
                let message = format!(
                    "a shaft of {bore:.0} mm carries {torque:.0} N m at over {limit:.0} MPa: from {least:.0} mm"
                );
                return Err(Refusal::new(field, message));
            }
            if place == 0 && bearing.bore > widest {
                let (widest, mean_diameter) = (widest * 1e3, mean_diameter * 1e3);
                let message = format!("at most {widest:.0} mm fit a {shaft} of {mean_diameter:.1} mm mean diameter");
                return Err(Refusal::new(field, message));
            }
        }
        let fronts = if carries[0] { vec![largest] } else { fronts.into_iter().rev().collect() };
        Ok(Self { fronts, rear })
    }
}
