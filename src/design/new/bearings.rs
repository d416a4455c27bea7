//! A short list of typical bearings: boundary dimensions of the standards, inner sizes by rules of thumb, no maker's data.
//!
//! Boundary dimensions are those of dimension series 02: ISO 15 for balls, ISO 355 for tapered rollers. The rest follows the usual
//! proportions (after Harris and Kotzalas, Rolling Bearing Analysis): pitch diameter (d + D)/2, ball diameter 0.3 (D - d), groove radii
//! of 0.52 ball diameters; deep groove balls fill 186 degrees of the pitch circle, the others 87 % of it.

use std::f64::consts::PI;

/// What rolls, and how steep.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum BearingKind {
    DeepGroove,
    AngularContact,
    Tapered,
}

impl BearingKind {
    pub const ALL: [Self; 3] = [Self::DeepGroove, Self::AngularContact, Self::Tapered];

    /// First part of the names in the list.
    pub fn word(self) -> &'static str {
        match self {
            Self::DeepGroove => "deep-groove",
            Self::AngularContact => "angular-contact",
            Self::Tapered => "tapered",
        }
    }

    /// As a sentence has it.
    pub fn plain(self) -> &'static str {
        match self {
            Self::DeepGroove => "deep groove ball",
            Self::AngularContact => "angular contact ball",
            Self::Tapered => "tapered roller",
        }
    }

    /// Where the numbers come from.
    pub fn source(self) -> &'static str {
        match self {
            Self::DeepGroove => {
                "boundary dimensions ISO 15, series 02; typical inner sizes: balls 0.3 (D - d), grooves 0.52, filled over 186 deg, \
                 10 deg as left by normal clearance"
            }
            Self::AngularContact => {
                "boundary dimensions ISO 15, series 02; typical inner sizes: balls 0.3 (D - d), grooves 0.52, 87 % of the pitch circle \
                 filled, 25 deg"
            }
            Self::Tapered => {
                "boundary dimensions ISO 355, series 02; typical inner sizes: rollers 0.23 (D - d) thick and 0.65 T long, 87 % of the \
                 pitch circle filled, angle of its ISO 355 series"
            }
        }
    }
}

/// One of the list. Lengths in m, angle in rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TypicalBearing {
    pub kind: BearingKind,
    /// d
    pub bore: f64,
    /// D
    pub outside_diameter: f64,
    /// B of ball bearings, T of tapered ones
    pub width: f64,
    pub contact_angle: f64,
}

/// d, D, B of ISO 15 and T of ISO 355 for dimension series 02, mm; whether the tapered one is of angle series 2 and not 3.
const SERIES_02: [(u16, u16, u16, f64, bool); 10] = [
    (20, 47, 14, 15.25, true),
    (25, 52, 15, 16.25, false),
    (30, 62, 16, 17.25, false),
    (35, 72, 17, 18.25, false),
    (40, 80, 18, 19.75, false),
    (50, 90, 20, 21.75, false),
    (60, 110, 22, 23.75, false),
    (70, 125, 24, 26.25, false),
    (80, 140, 26, 28.25, false),
    (100, 180, 34, 37.0, false),
];

/// Groove radius over ball diameter.
pub const GROOVE_FACTOR: f64 = 0.52;

impl TypicalBearing {
    /// The whole list, by kind and bore.
    pub fn all() -> impl Iterator<Item = Self> {
        BearingKind::ALL.into_iter().flat_map(Self::of_kind)
    }

    /// By bore, the smallest first.
    pub fn of_kind(kind: BearingKind) -> impl Iterator<Item = Self> {
        SERIES_02.into_iter().map(move |(bore, outside, width, height, flat)| {
            let (width, degrees) = match kind {
                BearingKind::DeepGroove => (f64::from(width), 10.0),
                BearingKind::AngularContact => (f64::from(width), 25.0),
                BearingKind::Tapered => (height, if flat { 12.0 } else { 15.0 }),
            };
            Self {
                kind,
                bore: f64::from(bore) / 1e3,
                outside_diameter: f64::from(outside) / 1e3,
                width: width / 1e3,
                contact_angle: f64::to_radians(degrees),
            }
        })
    }

    /// By its name in the list.
    pub fn named(name: &str) -> Option<Self> {
        Self::all().find(|bearing| bearing.name() == name)
    }

    /// E.g. `tapered-35`: kind and bore in mm.
    pub fn name(&self) -> String {
        format!("{}-{:.0}", self.kind.word(), self.bore * 1e3)
    }

    /// Diameter of the circle of the rolling elements' centres, m.
    pub fn pitch_diameter(&self) -> f64 {
        f64::midpoint(self.bore, self.outside_diameter)
    }

    /// Ball diameter, or mean diameter of the rollers, m.
    pub fn element_diameter(&self) -> f64 {
        let share = if self.kind == BearingKind::Tapered { 0.23 } else { 0.3 };
        share * (self.outside_diameter - self.bore)
    }

    /// Effective length of the rollers, m; nothing for balls.
    pub fn roller_length(&self) -> Option<f64> {
        (self.kind == BearingKind::Tapered).then_some(0.65 * self.width)
    }

    /// Number of balls or rollers.
    pub fn elements(&self) -> u32 {
        let step = 2.0 * (self.element_diameter() / self.pitch_diameter()).asin();
        let number = match self.kind {
            BearingKind::DeepGroove => f64::to_radians(186.0) / step + 1.0,
            BearingKind::AngularContact | BearingKind::Tapered => 0.87 * 2.0 * PI / step,
        };
        number.floor() as u32
    }

    /// Axial approach of the rings at assembly, m: a designer's choice, lighter for balls.
    pub fn mounting_preload(&self) -> f64 {
        match self.kind {
            BearingKind::DeepGroove => 5e-6,
            BearingKind::AngularContact => 8e-6,
            BearingKind::Tapered => 10e-6,
        }
    }
}
