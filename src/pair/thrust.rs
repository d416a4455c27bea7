//! Which way the thrust acts, in words.

use super::PairFigures;
use crate::gear::THRUST_INTO_MESH;

/// Below this share of the normal force there is no thrust but rounding.
const NOTHING: f64 = 1e-9;

impl PairFigures {
    /// Which way the teeth push the pinion along its shaft, then the gear: a sentence.
    pub fn thrust(&self) -> String {
        // the force on the pinion is against the line of action
        let [pinion, gear] = [-self.pinion.vectors.line_of_action[1], self.gear.vectors.line_of_action[1]];
        let away = |thrust: f64| match thrust {
            _ if thrust.abs() < NOTHING => "without thrust",
            _ if thrust < 0.0 => "pulled towards its apex",
            _ => "pushed away from its apex",
        };
        let along = |thrust: f64| match thrust {
            _ if thrust.abs() < NOTHING => "without thrust",
            _ if thrust < 0.0 => "pushed along -y",
            _ => "pushed along +y",
        };
        if self.has_cones() {
            return match pinion {
                _ if pinion.abs() < NOTHING => format!("no thrust on the pinion; the gear is {}", away(gear)),
                _ if pinion < 0.0 => format!("{THRUST_INTO_MESH}; the gear is {}", away(gear)),
                _ => format!("thrust pushes the pinion out of mesh on this flank; the gear is {}", away(gear)),
            };
        }
        if pinion.abs() < NOTHING && gear.abs() < NOTHING {
            return "no thrust on either shaft".into();
        }
        let unknown = if self.kind.is_some() { "" } else { "; whether that is into mesh, gear data would say" };
        format!("the pinion is {}, the gear {}{unknown}", along(pinion), along(gear))
    }

    /// Whether that is the unusual way, which closes the backlash where a bearing gives way.
    pub fn pulls_into_mesh(&self) -> bool {
        self.has_cones() && self.pinion.vectors.line_of_action[1] > NOTHING
    }
}
