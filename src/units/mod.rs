//! Quantities at the edges of the program: which unit a number is written in, and what it is in SI.

mod accepted;
mod typed;

pub use typed::{Typed, UnitError, parse};

/// What a number of a design file measures. It decides the unit at the end of the file key and the way to SI units.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// mm, from lengths of shafts to positions
    Length,
    /// um, amplitude of the transmission error
    Deflection,
    /// Hz
    Frequency,
    /// kg
    Mass,
    /// kg m^2
    Inertia,
    /// N/m
    Stiffness,
    /// N m/rad
    AngularStiffness,
    /// N: a preload, or a moment per displacement in a stiffness matrix
    Force,
    /// N/rad: a force per rotation in a stiffness matrix
    ForcePerRadian,
    /// `GPa`
    ElasticModulus,
    /// kg/m^3
    Density,
    /// No unit: ratios and components of unit vectors
    Ratio,
    /// deg
    Angle,
    /// mrad, tilts of bearing rings
    Tilt,
    /// N m
    Torque,
    /// rpm; rad/s in SI
    Speed,
    /// N/m^(3/2), balls on their raceways
    BallContact,
    /// N/m^(10/9), rollers on their raceways
    RollerContact,
    /// Loss factor, or seconds where the damping is viscous: the design's damping model decides, so no unit in the key
    Damping,
}

/// How a unit relates to the SI unit: where it can be, a power of ten that a double holds exactly, so that one rounding is all
/// there is (42 mm becomes the same double as 0.042).
#[derive(Debug, Clone, Copy, PartialEq)]
enum Scale {
    One,
    Times(f64),
    Over(f64),
}

impl Quantity {
    /// Every quantity, for tables of units.
    pub const ALL: [Self; 19] = [
        Self::Length,
        Self::Deflection,
        Self::Frequency,
        Self::Mass,
        Self::Inertia,
        Self::Stiffness,
        Self::AngularStiffness,
        Self::Force,
        Self::ForcePerRadian,
        Self::ElasticModulus,
        Self::Density,
        Self::Angle,
        Self::Tilt,
        Self::Torque,
        Self::Speed,
        Self::BallContact,
        Self::RollerContact,
        Self::Ratio,
        Self::Damping,
    ];

    const fn row(self) -> (&'static str, &'static str, Scale) {
        match self {
            Self::Length => ("_mm", "mm", Scale::Over(1e3)),
            Self::Deflection => ("_um", "um", Scale::Over(1e6)),
            Self::Frequency => ("_hz", "Hz", Scale::One),
            Self::Mass => ("_kg", "kg", Scale::One),
            Self::Inertia => ("_kg_m2", "kg m^2", Scale::One),
            Self::Stiffness => ("_n_per_m", "N/m", Scale::One),
            Self::AngularStiffness => ("_n_m_per_rad", "N m/rad", Scale::One),
            Self::Force => ("_n", "N", Scale::One),
            Self::ForcePerRadian => ("_n_per_rad", "N/rad", Scale::One),
            Self::ElasticModulus => ("_gpa", "GPa", Scale::Times(1e9)),
            Self::Density => ("_kg_per_m3", "kg/m^3", Scale::One),
            Self::Angle => ("_deg", "deg", Scale::Times(std::f64::consts::PI / 180.0)),
            Self::Tilt => ("_mrad", "mrad", Scale::Over(1e3)),
            Self::Torque => ("_n_m", "N m", Scale::One),
            Self::Speed => ("_rpm", "rpm", Scale::Times(std::f64::consts::PI / 30.0)),
            Self::BallContact => ("_n_per_m_1_5", "N/m^1.5", Scale::One),
            Self::RollerContact => ("_n_per_m_10_9", "N/m^(10/9)", Scale::One),
            Self::Ratio | Self::Damping => ("", "", Scale::One),
        }
    }

    /// End of the file key, with its underscore: `_n_per_m`. Empty where there is no unit.
    pub const fn suffix(self) -> &'static str {
        self.row().0
    }

    /// Unit as people read it: `N/m`. Empty where there is none.
    pub const fn unit(self) -> &'static str {
        self.row().1
    }

    /// From the file's unit to SI. A finite value may overflow to infinity.
    pub fn to_si(self, value: f64) -> f64 {
        match self.row().2 {
            Scale::One => value,
            Scale::Times(factor) => value * factor,
            Scale::Over(divisor) => value / divisor,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // The factors are those of the SI prefixes milli, micro and giga.
    #[test]
    fn conversion_is_the_correctly_rounded_one() {
        assert_eq!(Quantity::Length.to_si(42.0).to_bits(), 0.042_f64.to_bits());
        assert_eq!(Quantity::Deflection.to_si(5.0).to_bits(), 5e-6_f64.to_bits());
        assert_eq!(Quantity::ElasticModulus.to_si(206.0).to_bits(), 206e9_f64.to_bits());
    }

    #[test]
    fn a_unit_and_a_suffix_come_together() {
        for quantity in Quantity::ALL {
            assert_eq!(quantity.unit().is_empty(), quantity.suffix().is_empty(), "{quantity:?}");
        }
    }
}
