//! What a mode is called: by where its kinetic energy is.

use super::{EnergyShare, Mode};
use crate::design::Side;

/// Groups of motions, as the mode shapes of Hua et al. (2012) are read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MotionGroup {
    Lateral,
    Axial,
    /// Tilt of the lumped point, bending of the shaft
    Tilt,
    Torsion,
}

impl MotionGroup {
    pub const ALL: [Self; 4] = [Self::Lateral, Self::Axial, Self::Tilt, Self::Torsion];

    pub fn name(self) -> &'static str {
        match self {
            Self::Lateral => "lateral",
            Self::Axial => "axial",
            Self::Tilt => "tilt",
            Self::Torsion => "torsion",
        }
    }

    /// Its share among those of a rotor.
    pub fn of(self, share: &EnergyShare) -> f64 {
        match self {
            Self::Lateral => share.lateral,
            Self::Axial => share.axial,
            Self::Tilt => share.tilt,
            Self::Torsion => share.torsion,
        }
    }
}

/// The motion of one rotor that has most of a mode's kinetic energy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dominant {
    pub side: Side,
    pub group: MotionGroup,
    /// 0 to 1
    pub share: f64,
}

impl std::fmt::Display for Dominant {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {} {:.0} %", self.side.name(), self.group.name(), 100.0 * self.share)
    }
}

impl Mode {
    /// The motions of both rotors by their share, greatest first.
    fn ranked(&self) -> Vec<Dominant> {
        let sides = [(Side::Pinion, &self.pinion), (Side::Gear, &self.gear)];
        let mut all: Vec<Dominant> = sides
            .into_iter()
            .flat_map(|(side, share)| MotionGroup::ALL.map(|group| Dominant { side, group, share: group.of(share) }))
            .collect();
        all.sort_by(|a, b| b.share.total_cmp(&a.share));
        all
    }

    /// The motion with most of the kinetic energy.
    pub fn dominant(&self) -> Dominant {
        self.ranked()[0]
    }

    /// Share of the kinetic energy in one plane of a rotor: x-y (x, thz), then y-z (z, thx).
    pub fn plane_shares(&self, side: Side) -> [f64; 2] {
        let [x, _, z, thx, _, thz] = self.motions[side as usize];
        [x + thz, z + thx]
    }

    /// In the field's words, such as "gear tilt, x-y plane", "pinion axial", "torsion of both" or "rigid rotation".
    ///
    /// Both rotors are named where the second has a third of the first one's share of the same motion; a second motion where the first has
    /// less than half of the energy; a plane (of the rotor's own frame) where it has four fifths of the energy across the shaft.
    pub fn name(&self) -> String {
        const BOTH: f64 = 1.0 / 3.0;
        const ALONE: f64 = 0.5;
        const ONE_PLANE: f64 = 0.8;
        if self.is_rigid() {
            return "rigid rotation".to_owned();
        }
        let ranked = self.ranked();
        let first = ranked[0];
        let other = ranked.iter().find(|d| d.group == first.group && d.side != first.side);
        let both = other.filter(|other| other.share >= BOTH * first.share);
        let covered = first.share + both.map_or(0.0, |other| other.share);
        let mut name = match both {
            Some(_) => format!("{} of both", first.group.name()),
            None => format!("{} {}", first.side.name(), first.group.name()),
        };
        if covered < ALONE {
            let named = |d: &&Dominant| d.group != first.group || (both.is_none() && d.side != first.side);
            if let Some(second) = ranked.iter().find(named) {
                name = format!("{name} with {} {}", second.side.name(), second.group.name());
            }
        }
        if both.is_none() && matches!(first.group, MotionGroup::Lateral | MotionGroup::Tilt) {
            let [xy, yz] = self.plane_shares(first.side);
            if xy >= ONE_PLANE * (xy + yz) {
                name += ", x-y plane";
            } else if yz >= ONE_PLANE * (xy + yz) {
                name += ", y-z plane";
            }
        }
        name
    }
}
