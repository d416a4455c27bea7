//! The two shafts of a design.

use super::{Design, Mesh, MeshVectors, RotorDesign};

/// Which of the two shafts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    Pinion,
    Gear,
}

impl Side {
    pub const BOTH: [Self; 2] = [Self::Pinion, Self::Gear];

    /// Name of the rotor in files and messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Pinion => "pinion",
            Self::Gear => "gear",
        }
    }
}

impl Design {
    pub fn rotor(&self, side: Side) -> &RotorDesign {
        match side {
            Side::Pinion => &self.pinion,
            Side::Gear => &self.gear,
        }
    }
}

impl Mesh {
    pub fn vectors(&self, side: Side) -> &MeshVectors {
        match side {
            Side::Pinion => &self.pinion,
            Side::Gear => &self.gear,
        }
    }
}
