//! What the enhanced model of a design rests on besides first bending modes.

use super::Rotors;
use crate::design::Side;
use crate::rotor::Bending;

/// Something to know of one rotor's effective mass or inertia, in either plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Caveat {
    pub side: Side,
    pub kind: CaveatKind,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum CaveatKind {
    /// The mode does not determine the mass: it is the static one
    StaticMass,
    /// The mode does not determine the inertia: it is the static one
    StaticInertia,
    /// Share of the mode's kinetic energy that mass and inertia miss
    EnergyMissed(f64),
}

impl Caveat {
    /// A missed share of the energy from here on is one.
    pub const ENERGY: f64 = 0.05;

    /// In two or three words, without the rotor.
    pub fn short(&self) -> String {
        match self.kind {
            CaveatKind::StaticMass => "static mass".into(),
            CaveatKind::StaticInertia => "static inertia".into(),
            CaveatKind::EnergyMissed(share) => format!("{:.0} % missed", share * 100.0),
        }
    }

    /// As a sentence would say it, with the rotor.
    pub fn long(&self) -> String {
        let text = match self.kind {
            CaveatKind::StaticMass => "mass from statics".into(),
            CaveatKind::StaticInertia => "inertia from statics".into(),
            CaveatKind::EnergyMissed(share) => format!("{:.0} % of the kinetic energy missed", share * 100.0),
        };
        format!("{}: {text}", self.side.name())
    }
}

/// The caveats of both rotors, the pinion's first.
pub(super) fn of(rotors: &Rotors) -> Vec<Caveat> {
    Side::BOTH.into_iter().flat_map(|side| of_rotor(side, rotors)).collect()
}

fn of_rotor(side: Side, rotors: &Rotors) -> Vec<Caveat> {
    let rotor = rotors.get(side);
    let planes = [&rotor.bending_x, &rotor.bending_z];
    let any = |is: fn(&Bending) -> bool| planes.into_iter().any(is);
    let missed = planes.map(|bending| bending.energy_residual.abs()).into_iter().fold(0.0, f64::max);
    let kinds = [
        any(|bending| bending.mass_fallback).then_some(CaveatKind::StaticMass),
        any(|bending| bending.inertia_fallback).then_some(CaveatKind::StaticInertia),
        (missed >= Caveat::ENERGY).then_some(CaveatKind::EnergyMissed(missed)),
    ];
    kinds.into_iter().flatten().map(|kind| Caveat { side, kind }).collect()
}
