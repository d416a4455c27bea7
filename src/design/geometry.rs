//! Gear data in place of mesh vectors, in SI units and rad. Declared like the rest of the [model](super::model).

use super::schema::{Kind, Limit, Presence, Written};
use super::{Design, MeshVectors};
use crate::gear::{Cone, Pair, Pitch, Teeth};
use crate::units::Quantity;

const SHARP: Limit = Limit::Between(0.0, 90.0);
const ZERO: Presence = Presence::Default(Written::Number(0.0));

tables! {
    /// The pair as on its data sheet; mesh points and lines of action follow from it.
    #[derive(Debug, Clone, Copy, PartialEq)]
    pub struct MeshGeometry as "mesh geometry" {
        /// Kind of the pair; it decides which of the sizes are wanted.
        pub kind: PairKind = "kind", Kind::Word(PairKind::WORDS), Presence::Required;
        /// Normal pressure angle of the loaded flank.
        pub pressure_angle: f64 = "pressure_angle_deg", Kind::Number(Quantity::Angle, SHARP), Presence::Required;
        /// Hand of the pinion's teeth; not for spur and straight bevel pairs.
        pub hand: Option<Hand> = "hand", Kind::Word(Hand::WORDS), Presence::Optional;
        /// Which way the driving pinion turns about its y axis (bevel: from pitch apex to heel).
        pub pinion_turns: Turns = "pinion_turns", Kind::Word(Turns::WORDS), Presence::Default(Written::Text("positive"));
        /// Where round the pinion's shaft the mesh point lies: from +z, counted about +y.
        pub pinion_azimuth: f64 = "pinion_azimuth_deg", Kind::Number(Quantity::Angle, Limit::Any), ZERO;
        /// Where round the gear's shaft the mesh point lies.
        pub gear_azimuth: f64 = "gear_azimuth_deg", Kind::Number(Quantity::Angle, Limit::Any), ZERO;
        /// Bevel and hypoid: pitch angle of the pinion.
        pub pinion_pitch_angle: Option<f64> = "pinion_pitch_angle_deg",
            Kind::Number(Quantity::Angle, SHARP), Presence::Optional;
        /// Bevel and hypoid: pitch angle of the gear.
        pub gear_pitch_angle: Option<f64> = "gear_pitch_angle_deg",
            Kind::Number(Quantity::Angle, SHARP), Presence::Optional;
        /// Bevel and hypoid: from the pinion's pitch apex to the mean point.
        pub pinion_mean_cone_distance: Option<f64> = "pinion_mean_cone_distance_mm",
            Kind::Number(Quantity::Length, Limit::Positive), Presence::Optional;
        /// Bevel and hypoid: from the gear's pitch apex to the mean point.
        pub gear_mean_cone_distance: Option<f64> = "gear_mean_cone_distance_mm",
            Kind::Number(Quantity::Length, Limit::Positive), Presence::Optional;
        /// Spiral bevel and hypoid: mean spiral angle of the pinion.
        pub pinion_spiral_angle: Option<f64> = "pinion_spiral_angle_deg",
            Kind::Number(Quantity::Angle, SHARP), Presence::Optional;
        /// Spiral bevel and hypoid: mean spiral angle of the gear.
        pub gear_spiral_angle: Option<f64> = "gear_spiral_angle_deg",
            Kind::Number(Quantity::Angle, SHARP), Presence::Optional;
        /// Bevel and hypoid: where the pinion's pitch apex lies on the shaft's own y scale.
        pub pinion_apex: Option<f64> = "pinion_apex_mm", Kind::Number(Quantity::Length, Limit::Any), Presence::Optional;
        /// Bevel and hypoid: where the gear's pitch apex lies on the shaft's own y scale.
        pub gear_apex: Option<f64> = "gear_apex_mm", Kind::Number(Quantity::Length, Limit::Any), Presence::Optional;
        /// Spur and helical: pitch diameter of the pinion.
        pub pinion_pitch_diameter: Option<f64> = "pinion_pitch_diameter_mm",
            Kind::Number(Quantity::Length, Limit::Positive), Presence::Optional;
        /// Spur and helical: pitch diameter of the gear.
        pub gear_pitch_diameter: Option<f64> = "gear_pitch_diameter_mm",
            Kind::Number(Quantity::Length, Limit::Positive), Presence::Optional;
        /// Helical: helix angle at the pitch cylinder.
        pub helix_angle: Option<f64> = "helix_angle_deg", Kind::Number(Quantity::Angle, SHARP), Presence::Optional;
    }
}

words! {
    /// Kind of a gear pair.
    pub enum PairKind {
        SpiralBevel = "spiral-bevel",
        StraightBevel = "straight-bevel",
        Hypoid = "hypoid",
        Spur = "spur",
        Helical = "helical",
    }

    /// Hand of the pinion's teeth: which way their outer halves lean, seen from the apex.
    pub enum Hand {
        Right = "right",
        Left = "left",
    }

    /// Sense of rotation about the y axis.
    pub enum Turns {
        Positive = "positive",
        Negative = "negative",
    }
}

impl PairKind {
    /// The axes are parallel.
    pub fn is_parallel(self) -> bool {
        matches!(self, Self::Spur | Self::Helical)
    }

    /// The teeth lean: they have a hand.
    pub fn has_hand(self) -> bool {
        !matches!(self, Self::Spur | Self::StraightBevel)
    }
}

impl MeshGeometry {
    /// The pair, each member in its own frame. What is not written counts as not-a-number.
    pub fn pair(&self) -> Pair {
        let teeth = Teeth {
            pressure_angle: self.pressure_angle,
            hand: if self.hand == Some(Hand::Left) { -1.0 } else { 1.0 },
            turns: if self.pinion_turns == Turns::Negative { -1.0 } else { 1.0 },
        };
        let given = |value: Option<f64>| value.unwrap_or(f64::NAN);
        let angle = |value: Option<f64>, leans: bool| if leans { given(value) } else { 0.0 };
        let leans = self.kind.has_hand();
        let pitch = if self.kind.is_parallel() {
            Pitch::Parallel {
                radii: [self.pinion_pitch_diameter, self.gear_pitch_diameter].map(|diameter| given(diameter) / 2.0),
                helix_angle: angle(self.helix_angle, leans),
            }
        } else {
            let cone = |pitch_angle, cone_distance, spiral_angle| Cone {
                pitch_angle: given(pitch_angle),
                cone_distance: given(cone_distance),
                spiral_angle: angle(spiral_angle, leans),
            };
            Pitch::Bevel {
                cones: [
                    cone(self.pinion_pitch_angle, self.pinion_mean_cone_distance, self.pinion_spiral_angle),
                    cone(self.gear_pitch_angle, self.gear_mean_cone_distance, self.gear_spiral_angle),
                ],
            }
        };
        Pair::new(&teeth, &pitch)
    }
}

impl Design {
    /// Mesh vectors of pinion and gear as they follow from `[mesh.geometry]`; nothing where the design has none.
    pub fn vectors_of_geometry(&self) -> Option<[MeshVectors; 2]> {
        let geometry = self.mesh.geometry.as_ref()?;
        let pair = geometry.pair();
        let vectors = |member: &crate::gear::Member, azimuth: f64, apex: Option<f64>, station: f64| {
            let (mut point, line_of_action) = member.turned(azimuth);
            if !geometry.kind.is_parallel() {
                point.y += apex.unwrap_or(f64::NAN) - station;
            }
            MeshVectors { point: without_rounding(point), line_of_action: without_rounding(line_of_action) }
        };
        Some([
            vectors(&pair.pinion, geometry.pinion_azimuth, geometry.pinion_apex, self.pinion.mesh_position),
            vectors(&pair.gear, geometry.gear_azimuth, geometry.gear_apex, self.gear.mesh_position),
        ])
    }
}

/// Components that are nothing but the rounding of the others are zero.
fn without_rounding(vector: nalgebra::Vector3<f64>) -> [f64; 3] {
    const ROUNDING: f64 = 1e-9;
    let least = ROUNDING * vector.norm();
    vector.map(|component| if component.abs() < least { 0.0 } else { component }).into()
}
