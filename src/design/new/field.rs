//! The questions that a new design answers: one table, from which the options of the command line and the form are made.

use crate::design::{Hand, PairKind};
use crate::units::Quantity;

/// What can be asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Field {
    Kind,
    PinionTeeth,
    GearTeeth,
    PinionTorque,
    PinionSpeed,
    GearOuterDiameter,
    NormalModule,
    FaceWidth,
    SpiralAngle,
    Offset,
    CutterRadius,
    PressureAngle,
    Hand,
    PinionMounting,
    GearMounting,
    PinionB1,
    PinionB2,
    GearB1,
    GearB2,
}

/// What an answer is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Answer {
    /// A whole number within these limits
    Whole(u32, u32),
    /// A number within these limits, in the quantity's unit
    Number(Quantity, f64, f64),
    /// One of these words
    Word(&'static [&'static str]),
    /// The name of a bearing of the list
    Bearing,
}

pub const MOUNTINGS: &[&str] = &["overhung", "straddle"];

type Row = (&'static str, &'static str, Answer, &'static str);

impl Field {
    /// In the order of the form.
    pub const ALL: [Self; 19] = [
        Self::Kind,
        Self::PinionTeeth,
        Self::GearTeeth,
        Self::PinionTorque,
        Self::PinionSpeed,
        Self::GearOuterDiameter,
        Self::NormalModule,
        Self::FaceWidth,
        Self::SpiralAngle,
        Self::Offset,
        Self::CutterRadius,
        Self::PressureAngle,
        Self::Hand,
        Self::PinionMounting,
        Self::GearMounting,
        Self::PinionB1,
        Self::PinionB2,
        Self::GearB1,
        Self::GearB2,
    ];

    /// Name, label, what an answer is, and a sentence of help.
    fn row(self) -> Row {
        use Answer::{Bearing, Number, Whole, Word};
        use Quantity::{Angle, Length, Speed, Torque};
        match self {
            Self::Kind => (
                "kind",
                "kind of pair",
                Word(PairKind::WORDS),
                "Bevel: the axes meet at a right angle. Hypoid: they pass at an offset. Spur, helical: parallel.",
            ),
            Self::PinionTeeth => {
                ("pinion-teeth", "pinion teeth", Whole(5, 100), "Teeth of the small wheel, which drives.")
            }
            Self::GearTeeth => (
                "gear-teeth",
                "gear teeth",
                Whole(5, 300),
                "Teeth of the large wheel; without a common factor with the pinion's, every tooth meets every other.",
            ),
            Self::PinionTorque => (
                "pinion-torque",
                "pinion torque",
                Number(Torque, 0.5, 15_000.0),
                "Mean torque of the pinion: it decides shafts and bearings, and what the bearings' stiffness is.",
            ),
            Self::PinionSpeed => (
                "pinion-speed",
                "pinion speed",
                Number(Speed, 1.0, 60_000.0),
                "Only marks the mesh frequency; the spectra do not depend on it.",
            ),
            Self::GearOuterDiameter => (
                "gear-outer-diameter",
                "gear outer dia",
                Number(Length, 30.0, 1200.0),
                "Pitch diameter of the gear at its heel, de2 on a data sheet: the size of the pair.",
            ),
            Self::NormalModule => {
                ("normal-module", "normal module", Number(Length, 0.5, 25.0), "Of both wheels: the size of the pair.")
            }
            Self::FaceWidth => (
                "face-width",
                "face width",
                Number(Length, 2.0, 500.0),
                "Of the gear, along its teeth's cone or cylinder; mesh stiffness follows from it.",
            ),
            Self::SpiralAngle => (
                "spiral-angle",
                "spiral angle",
                Number(Angle, 3.0, 60.0),
                "Mean spiral angle, of a hypoid pair the pinion's; of a helical pair the helix angle.",
            ),
            Self::Offset => (
                "offset",
                "offset",
                Number(Length, 0.3, 300.0),
                "Hypoid: how far the axes pass one another; up to a quarter of the gear's outer diameter.",
            ),
            Self::CutterRadius => (
                "cutter-radius",
                "cutter radius",
                Number(Length, 5.0, 1000.0),
                "Hypoid: mean radius of the face mill; it settles how steep both pitch cones are.",
            ),
            Self::PressureAngle => (
                "pressure-angle",
                "pressure angle",
                Number(Angle, 12.0, 32.0),
                "Normal pressure angle of the flank that carries the torque.",
            ),
            Self::Hand => (
                "hand",
                "pinion's hand",
                Word(Hand::WORDS),
                "Which way its teeth lean; it turns so that its thrust is out of mesh, away from the apex.",
            ),
            Self::PinionMounting => (
                "pinion-mounting",
                "pinion is",
                Word(MOUNTINGS),
                "Overhung: both bearings behind the teeth. Straddle: one on either side.",
            ),
            Self::GearMounting => (
                "gear-mounting",
                "gear is",
                Word(MOUNTINGS),
                "Overhung: both bearings behind the teeth. Straddle: one on either side.",
            ),
            Self::PinionB1 => ("pinion-b1", "pinion B1", Bearing, "The bearing beside the teeth, or before them."),
            Self::PinionB2 => ("pinion-b2", "pinion B2", Bearing, "The bearing towards the drive."),
            Self::GearB1 => ("gear-b1", "gear B1", Bearing, "The bearing beside the teeth, or before them."),
            Self::GearB2 => ("gear-b2", "gear B2", Bearing, "The bearing towards the load."),
        }
    }

    /// E.g. `face-width`.
    pub fn name(self) -> &'static str {
        self.row().0
    }

    /// As the form calls it.
    pub fn label(self) -> &'static str {
        self.row().1
    }

    pub fn answer(self) -> Answer {
        self.row().2
    }

    /// A sentence or two.
    pub fn help(self) -> &'static str {
        self.row().3
    }

    /// What a number measures; nothing for words.
    pub fn quantity(self) -> Option<Quantity> {
        match self.answer() {
            Answer::Whole(..) => Some(Quantity::Ratio),
            Answer::Number(quantity, ..) => Some(quantity),
            Answer::Word(_) | Answer::Bearing => None,
        }
    }

    /// Whether a pair of that kind has it.
    pub fn belongs_to(self, kind: PairKind) -> bool {
        match self {
            Self::GearOuterDiameter => !kind.is_parallel(),
            Self::NormalModule => kind.is_parallel(),
            Self::Offset | Self::CutterRadius => kind == PairKind::Hypoid,
            Self::SpiralAngle | Self::Hand => kind.has_hand(),
            _ => true,
        }
    }
}
