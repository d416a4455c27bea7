//! The units that may be typed for each quantity.

use super::Quantity;

/// A unit: what it is called, and how many of the file's unit it is, as a fraction (exact where both are).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Unit {
    pub name: &'static str,
    pub times: f64,
    pub over: f64,
}

const fn unit(name: &'static str, times: f64) -> Unit {
    Unit { name, times, over: 1.0 }
}

const fn part(name: &'static str, over: f64) -> Unit {
    Unit { name, times: 1.0, over }
}

// The inch is 25.4 mm, the pound 0.45359237 kg and the standard acceleration 9.80665 m/s^2 by definition (NIST SP 811,
// appendix B.8); hence 1 lbf/in = 4.4482216152605 N / 25.4 mm and 1 psi = 4.4482216152605 N / (25.4 mm)^2.
const POUND_FORCE: f64 = 4.448_221_615_260_5;

const LENGTH: &[Unit] =
    &[unit("mm", 1.0), unit("m", 1e3), unit("cm", 10.0), part("um", 1e3), unit("in", 25.4), unit("ft", 304.8)];
const DEFLECTION: &[Unit] =
    &[unit("um", 1.0), unit("mm", 1e3), part("nm", 1e3), unit("m", 1e6), unit("in", 25_400.0), unit("thou", 25.4)];
const FREQUENCY: &[Unit] =
    &[unit("Hz", 1.0), unit("kHz", 1e3), part("rpm", 60.0), part("rad/s", std::f64::consts::TAU)];
const MASS: &[Unit] = &[unit("kg", 1.0), part("g", 1e3), unit("t", 1e3), unit("lb", 0.453_592_37)];
const INERTIA: &[Unit] =
    &[unit("kg m^2", 1.0), part("kg mm^2", 1e6), part("kg cm^2", 1e4), part("g cm^2", 1e7), part("g mm^2", 1e9)];
const STIFFNESS: &[Unit] = &[
    unit("N/m", 1.0),
    unit("N/mm", 1e3),
    unit("N/um", 1e6),
    unit("kN/m", 1e3),
    unit("kN/mm", 1e6),
    unit("MN/m", 1e6),
    unit("GN/m", 1e9),
    Unit { name: "lbf/in", times: POUND_FORCE, over: 0.0254 },
];
const ANGULAR_STIFFNESS: &[Unit] = &[
    unit("N m/rad", 1.0),
    unit("kN m/rad", 1e3),
    unit("MN m/rad", 1e6),
    part("N mm/rad", 1e3),
    unit("lbf in/rad", POUND_FORCE * 0.0254),
];
const FORCE: &[Unit] = &[unit("N", 1.0), unit("kN", 1e3), unit("MN", 1e6), unit("lbf", POUND_FORCE)];
const FORCE_PER_RADIAN: &[Unit] =
    &[unit("N/rad", 1.0), unit("kN/rad", 1e3), unit("MN/rad", 1e6), unit("lbf/rad", POUND_FORCE)];
const ELASTIC_MODULUS: &[Unit] = &[
    unit("GPa", 1.0),
    part("MPa", 1e3),
    part("Pa", 1e9),
    part("N/mm^2", 1e3),
    Unit { name: "psi", times: POUND_FORCE, over: 0.0254 * 0.0254 * 1e9 },
    Unit { name: "ksi", times: POUND_FORCE, over: 0.0254 * 0.0254 * 1e6 },
];
const DENSITY: &[Unit] = &[
    unit("kg/m^3", 1.0),
    unit("g/cm^3", 1e3),
    unit("kg/dm^3", 1e3),
    unit("t/m^3", 1e3),
    Unit { name: "lb/in^3", times: 0.453_592_37, over: 1.638_706_4e-5 },
];
const ANGLE: &[Unit] = &[unit("deg", 1.0), unit("rad", 180.0 / std::f64::consts::PI)];
const TILT: &[Unit] =
    &[unit("mrad", 1.0), unit("rad", 1e3), part("urad", 1e3), unit("deg", 1e3 * std::f64::consts::PI / 180.0)];
const TORQUE: &[Unit] = &[
    unit("N m", 1.0),
    unit("kN m", 1e3),
    part("N mm", 1e3),
    unit("lbf in", POUND_FORCE * 0.0254),
    unit("lbf ft", POUND_FORCE * 0.3048),
];
const SPEED: &[Unit] =
    &[unit("rpm", 1.0), unit("1/min", 1.0), unit("Hz", 60.0), unit("rad/s", 30.0 / std::f64::consts::PI)];
const BALL_CONTACT: &[Unit] = &[unit("N/m^1.5", 1.0), unit("N/mm^1.5", 31_622.776_601_683_792)];
// 1000^(10/9)
const ROLLER_CONTACT: &[Unit] = &[unit("N/m^(10/9)", 1.0), unit("N/mm^(10/9)", 2_154.434_690_031_884)];
const RATIO: &[Unit] = &[part("%", 100.0)];

impl Quantity {
    /// The file's own unit first; for ratios only what may be typed beside the plain number.
    pub(super) const fn accepted(self) -> &'static [Unit] {
        match self {
            Self::Length => LENGTH,
            Self::Deflection => DEFLECTION,
            Self::Frequency => FREQUENCY,
            Self::Mass => MASS,
            Self::Inertia => INERTIA,
            Self::Stiffness => STIFFNESS,
            Self::AngularStiffness => ANGULAR_STIFFNESS,
            Self::Force => FORCE,
            Self::ForcePerRadian => FORCE_PER_RADIAN,
            Self::ElasticModulus => ELASTIC_MODULUS,
            Self::Density => DENSITY,
            Self::Angle => ANGLE,
            Self::Tilt => TILT,
            Self::Torque => TORQUE,
            Self::Speed => SPEED,
            Self::BallContact => BALL_CONTACT,
            Self::RollerContact => ROLLER_CONTACT,
            Self::Ratio | Self::Damping => RATIO,
        }
    }

    /// The units that may be typed, as people write them; the file's own first.
    pub fn units(self) -> impl Iterator<Item = &'static str> {
        self.accepted().iter().map(|unit| unit.name)
    }
}

/// Whether `typed` is the unit `name`, as people write it: `N m` also as `Nm`, `N·m`, `N*m` or `N.m`, `m^2` also as `m2`
/// or `m²`, `um` also as `µm`.
pub(super) fn is_unit(typed: &str, name: &str) -> bool {
    let mut typed = typed.trim().chars().map(plain).peekable();
    for wanted in name.chars() {
        match wanted {
            ' ' => {
                while typed.next_if(|c| c.is_whitespace()).is_some() {}
                if typed.next_if(|c| "*·⋅.".contains(*c)).is_some() {
                    while typed.next_if(|c| c.is_whitespace()).is_some() {}
                }
            }
            '^' => {
                typed.next_if_eq(&'^');
            }
            '/' => {
                while typed.next_if(|c| c.is_whitespace()).is_some() {}
                if typed.next() != Some('/') {
                    return false;
                }
                while typed.next_if(|c| c.is_whitespace()).is_some() {}
            }
            wanted => {
                if typed.next() != Some(wanted) {
                    return false;
                }
            }
        }
    }
    typed.next().is_none()
}

fn plain(c: char) -> char {
    match c {
        '²' => '2',
        '³' => '3',
        'µ' | 'μ' => 'u',
        c => c,
    }
}
