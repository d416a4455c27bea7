//! Which way the thrust acts, in words.

use super::PairFigures;
use crate::gear::THRUST_INTO_MESH;

/// Below this share of the normal force there is no thrust but rounding.
const NOTHING: f64 = 1e-9;

impl PairFigures {
    /// Which way the teeth push the pinion along its shaft, then the gear: a sentence.
    pub fn thrust(&self) -> String {
        if self.normal_force.is_none() {
            return "no thrust: the line of action meets the pinion's axis".into();
        }
        // the force on the pinion is against the line of action
        let [pinion, gear] = [-self.pinion.vectors.line_of_action[1], self.gear.vectors.line_of_action[1]];
        let is = |thrust: f64, ways: [&'static str; 3]| match thrust {
            _ if thrust.abs() < NOTHING => ways[0],
            _ if thrust < 0.0 => ways[1],
            _ => ways[2],
        };
        if self.has_cones() {
            let of_pinion =
                ["no thrust on the pinion", THRUST_INTO_MESH, "thrust pushes the pinion out of mesh on this flank"];
            let of_gear = ["no thrust", "towards its apex", "away from its apex"];
            return format!("{}; gear: {}", is(pinion, of_pinion), is(gear, of_gear));
        }
        if pinion.abs() < NOTHING && gear.abs() < NOTHING {
            return "no thrust on either shaft".into();
        }
        let along = ["not at all", "along -y", "along +y"];
        let unknown = if self.kind.is_some() { "" } else { "; into mesh or out of it? add [mesh.geometry] for that" };
        format!("thrust pushes the pinion {}, the gear {}{unknown}", is(pinion, along), is(gear, along))
    }

    /// Whether that is the unusual way, which closes the backlash where a bearing gives way.
    pub fn pulls_into_mesh(&self) -> bool {
        self.normal_force.is_some() && self.has_cones() && self.pinion.vectors.line_of_action[1] > NOTHING
    }
}
