//! Mesh points, lines of action and tooth forces of a design, in SI units.

use crate::design::{Design, MeshVectors, PairKind, Side};
use crate::gear::{Force, Pair};
use crate::rotor::{mesh_vector, signed};

/// What the teeth do to both shafts.
#[derive(Debug, Clone, PartialEq)]
pub struct PairFigures {
    pub pinion: ShaftFigures,
    pub gear: ShaftFigures,
    /// The operating torque of the pinion, N m; nothing where the design gives none, and forces are for 1 N m.
    pub torque: Option<f64>,
    /// Along the line of action, N; nothing where the line of action has no arm about the pinion's axis.
    pub normal_force: Option<f64>,
    /// Nothing where a number of teeth is missing.
    pub arms: Option<Arms>,
    /// Where the design has gear data.
    pub kind: Option<PairKind>,
    /// How the axes lie; where the design has gear data.
    pub pair: Option<Pair>,
    /// Hz; where speed and teeth of the pinion are given.
    pub mesh_frequency: Option<f64>,
}

/// The mesh in one shaft's frame, and the force of the teeth on that shaft.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShaftFigures {
    /// Mesh point from the mesh station, m, and the unit vector of the force on the gear.
    pub vectors: MeshVectors,
    /// Of the line of action about the y axis, m, with its sign.
    pub torque_arm: f64,
    /// Nothing where there is no [normal force](PairFigures::normal_force).
    pub force: Option<Force>,
}

/// Torque arms held against the tooth numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arms {
    /// Pinion, gear
    pub teeth: [u32; 2],
    /// Arm of the gear over that of the pinion, without sign.
    pub ratio: f64,
    /// How far the ratio is above that of the teeth, %.
    pub deviation_percent: f64,
}

impl Arms {
    /// The deviation with its sign, e.g. `+0.12 %`.
    pub fn deviation(&self) -> String {
        let rounded = (self.deviation_percent * 100.0).round() / 100.0;
        if rounded == 0.0 { "0.00 %".into() } else { format!("{rounded:+.2} %") }
    }

    /// Teeth of the gear over those of the pinion.
    pub fn tooth_ratio(&self) -> f64 {
        f64::from(self.teeth[1]) / f64::from(self.teeth[0])
    }
}

impl PairFigures {
    pub fn new(design: &Design) -> Self {
        let torque = design.operating.and_then(|operating| operating.pinion_torque);
        let arm = |side: Side| mesh_vector(design.mesh.vectors(side))[4];
        let normal_force = Some((torque.unwrap_or(1.0) / arm(Side::Pinion)).abs()).filter(|force| force.is_finite());
        let shaft = |side: Side| {
            let vectors = *design.mesh.vectors(side);
            let force = normal_force.map(|force| force_on(&vectors, -signed(side) * force));
            ShaftFigures { vectors, torque_arm: arm(side), force }
        };
        let teeth = design.pinion.teeth.zip(design.gear.teeth);
        let ratio = (arm(Side::Gear) / arm(Side::Pinion)).abs();
        let arms = teeth.filter(|_| ratio.is_finite()).map(|(pinion, gear)| Arms {
            teeth: [pinion, gear],
            ratio,
            deviation_percent: 100.0 * (ratio * f64::from(pinion) / f64::from(gear) - 1.0),
        });
        let speed = design.operating.and_then(|operating| operating.pinion_speed).zip(design.pinion.teeth);
        Self {
            pinion: shaft(Side::Pinion),
            gear: shaft(Side::Gear),
            torque,
            normal_force,
            arms,
            kind: design.mesh.geometry.map(|geometry| geometry.kind),
            pair: design.mesh.geometry.map(|geometry| geometry.pair()),
            mesh_frequency: speed.map(|(speed, teeth)| speed * f64::from(teeth) / std::f64::consts::TAU),
        }
    }

    pub fn shaft(&self, side: Side) -> &ShaftFigures {
        match side {
            Side::Pinion => &self.pinion,
            Side::Gear => &self.gear,
        }
    }

    /// Whether the pitch surfaces are cones: y then points from the apex to the heel.
    pub fn has_cones(&self) -> bool {
        self.kind.is_some_and(|kind| !kind.is_parallel())
    }
}

/// The force `along` (N) the line of action, as components about the shaft's own axis.
fn force_on(vectors: &MeshVectors, along: f64) -> Force {
    let ([x, _, z], [fx, fy, fz]) = (vectors.point, vectors.line_of_action.map(|component| component * along));
    let radius = x.hypot(z);
    Force { axial: fy, radial: -(x * fx + z * fz) / radius, tangential: (z * fx - x * fz) / radius }
}
