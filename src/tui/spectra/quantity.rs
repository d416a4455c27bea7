//! What is drawn over the frequency.

use super::solve::Subject;
use crate::agreement::{ModalComparison, Parts};
use crate::design::{Design, Side};
use crate::text::printable;

/// A quantity of a model, one complex value a frequency line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// Dynamic mesh force, N
    MeshForce,
    /// Dynamic transmission error, um
    TransmissionError,
    /// Force of a bearing on its shaft, N; bearings are counted over both shafts, the pinion's first
    Bearing { bearing: usize, part: Part },
}

/// What of a bearing's force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    /// sqrt(|fx|^2 + |fy|^2 + |fz|^2)
    Resultant,
    X,
    Y,
    Z,
    /// sqrt(|fx|^2 + |fz|^2)
    Radial,
}

impl Part {
    const ALL: [Self; 5] = [Self::Resultant, Self::X, Self::Y, Self::Z, Self::Radial];

    fn name(self) -> &'static str {
        match self {
            Self::Resultant => "resultant",
            Self::X => "x",
            Self::Y => "y (axial)",
            Self::Z => "z",
            Self::Radial => "radial",
        }
    }

    /// Those of fx, fy, fz that it is made from.
    fn components(self) -> &'static [usize] {
        match self {
            Self::Resultant => &[0, 1, 2],
            Self::X => &[0],
            Self::Y => &[1],
            Self::Z => &[2],
            Self::Radial => &[0, 2],
        }
    }

    fn key(self) -> &'static str {
        match self {
            Self::Resultant => "total",
            Self::X => "fx",
            Self::Y => "fy",
            Self::Z => "fz",
            Self::Radial => "radial",
        }
    }
}

/// Both rotors' bearings, in the order in which they are counted.
fn bearings(design: &Design) -> impl Iterator<Item = (Side, &str)> {
    let of = |side: Side| {
        let rotor = if side == Side::Pinion { &design.pinion } else { &design.gear };
        rotor.bearings.iter().map(move |bearing| (side, bearing.name.as_str()))
    };
    of(Side::Pinion).chain(of(Side::Gear))
}

impl Quantity {
    /// The next of mesh force, transmission error and each bearing; backwards with -1.
    #[must_use]
    pub fn next(self, by: isize, design: &Design) -> Self {
        let count = bearings(design).count() + 2;
        let (at, part) = match self {
            Self::MeshForce => (0, Part::Resultant),
            Self::TransmissionError => (1, Part::Resultant),
            Self::Bearing { bearing, part } => (bearing + 2, part),
        };
        match at.wrapping_add_signed(by.rem_euclid(count.cast_signed())) % count {
            0 => Self::MeshForce,
            1 => Self::TransmissionError,
            at => Self::Bearing { bearing: at - 2, part },
        }
    }

    /// The next direction of a bearing's force.
    #[must_use]
    pub fn next_part(self) -> Self {
        let Self::Bearing { bearing, part } = self else { return self };
        Self::Bearing { bearing, part: Part::ALL[(part as usize + 1) % Part::ALL.len()] }
    }

    /// The other quantity of the mesh, for the lower panel.
    #[must_use]
    pub fn beside(self) -> Self {
        if self == Self::TransmissionError { Self::MeshForce } else { Self::TransmissionError }
    }

    /// Whether there are several directions of it.
    pub fn has_parts(self) -> bool {
        matches!(self, Self::Bearing { .. })
    }

    /// Whether its values have a phase.
    pub fn has_phase(self) -> bool {
        !matches!(self, Self::Bearing { part: Part::Resultant | Part::Radial, .. })
    }

    /// What each mode has in it; nothing where that cannot be told.
    pub fn parts(self, modes: &ModalComparison, subject: &Subject) -> Option<Parts> {
        let Self::Bearing { bearing, part } = self else { return Some(Parts::of_mesh(modes)) };
        let (side, _) = bearings(&subject.design).nth(bearing)?;
        let before = if side == Side::Gear { subject.design.pinion.bearings.len() } else { 0 };
        Parts::of_bearing(modes, &subject.design, &subject.rotors, (side, bearing - before), part.components()).ok()
    }

    /// In words; what the design says is harmless to show.
    pub fn title(self, design: &Design) -> String {
        match self {
            Self::MeshForce => "Dynamic mesh force".into(),
            Self::TransmissionError => "Dynamic transmission error".into(),
            Self::Bearing { bearing, part } => match bearings(design).nth(bearing) {
                Some((side, name)) => {
                    format!("Force of bearing {} on the {}, {}", printable(name), side.name(), part.name())
                }
                None => "Force of a bearing".into(),
            },
        }
    }

    /// In few words.
    pub fn short(self, design: &Design) -> String {
        match self {
            Self::MeshForce => "Mesh force".into(),
            Self::TransmissionError => "Transm. error".into(),
            Self::Bearing { bearing, part } => match bearings(design).nth(bearing) {
                Some((side, name)) => format!("{} {}, {}", side.name(), printable(name), part.name()),
                None => "Bearing".into(),
            },
        }
    }

    /// Name in files and columns, with its unit.
    pub fn column(self, design: &Design) -> String {
        match self {
            Self::MeshForce => "mesh_force_n".into(),
            Self::TransmissionError => "transmission_error_um".into(),
            Self::Bearing { bearing, part } => match bearings(design).nth(bearing) {
                Some((side, name)) => format!("bearing_{}_{}_{}_n", side.name(), printable(name), part.key()),
                None => "bearing_n".into(),
            },
        }
    }

    pub fn unit(self, ascii: bool) -> &'static str {
        match self {
            Self::TransmissionError if ascii => "um",
            Self::TransmissionError => "µm",
            _ => "N",
        }
    }
}
