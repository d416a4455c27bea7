//! The mesh: where and along which line the teeth push, and what that means for each shaft.

use std::io::{self, Write};

use crate::design::{Design, MeshVectors, Side};
use crate::number::significant;
use crate::report::Table;
use crate::rotor::{mesh_vector, signed};

#[derive(serde::Serialize)]
pub struct MeshOutput {
    pinion: SideOutput,
    gear: SideOutput,
    /// Between both y axes; only where the design has gear data
    #[serde(skip_serializing_if = "Option::is_none")]
    shaft_angle_deg: Option<f64>,
    /// Shortest distance of the axes; only where the design has gear data
    #[serde(skip_serializing_if = "Option::is_none")]
    offset_mm: Option<f64>,
    /// Only with a torque
    #[serde(skip_serializing_if = "Option::is_none")]
    normal_force_n: Option<f64>,
    /// Only with a speed and the pinion's teeth
    #[serde(skip_serializing_if = "Option::is_none")]
    mesh_frequency_hz: Option<f64>,
}

#[derive(serde::Serialize)]
struct SideOutput {
    /// From the mesh station
    point_mm: [f64; 3],
    line_of_action: [f64; 3],
    torque_arm_mm: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    force: Option<ForceOutput>,
}

/// On this shaft at the mesh point.
#[expect(clippy::struct_field_names, reason = "the names are keys, which carry their unit")]
#[derive(serde::Serialize)]
struct ForceOutput {
    /// Along y
    axial_n: f64,
    /// Towards the shaft's own axis
    radial_n: f64,
    /// Turns the shaft positively about y
    tangential_n: f64,
}

impl MeshOutput {
    pub fn new(design: &Design) -> Self {
        let torque = design.operating.and_then(|operating| operating.pinion_torque);
        let arm = mesh_vector(&design.mesh.pinion)[4];
        let normal_force = torque.map(|torque| (torque / arm).abs()).filter(|force| force.is_finite());
        let side = |side: Side| {
            let vectors = design.mesh.vectors(side);
            SideOutput {
                point_mm: vectors.point.map(|value| value * 1e3),
                line_of_action: vectors.line_of_action,
                torque_arm_mm: mesh_vector(vectors)[4] * 1e3,
                force: normal_force.map(|force| ForceOutput::new(vectors, -signed(side) * force)),
            }
        };
        let pair = design.mesh.geometry.map(|geometry| geometry.pair());
        let speed = design.operating.and_then(|operating| operating.pinion_speed).zip(design.pinion.teeth);
        Self {
            pinion: side(Side::Pinion),
            gear: side(Side::Gear),
            shaft_angle_deg: pair.map(|pair| pair.shaft_angle.to_degrees()),
            offset_mm: pair.map(|pair| pair.offset * 1e3),
            normal_force_n: normal_force,
            mesh_frequency_hz: speed.map(|(speed, teeth)| speed * f64::from(teeth) / std::f64::consts::TAU),
        }
    }

    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        writeln!(out, "\nMESH")?;
        let mut table = Table::new(["  ", "point x, y, z, mm", "line of action", "torque arm, mm"]);
        let mut forces = Table::new(["  ", "axial, N", "radial, N", "tangential, N"]);
        for (name, side) in [("  pinion", &self.pinion), ("  gear", &self.gear)] {
            let three = |values: [f64; 3]| values.map(|value| significant(value, 5)).join("  ");
            table.row([
                name.into(),
                three(side.point_mm),
                three(side.line_of_action),
                significant(side.torque_arm_mm, 5),
            ]);
            if let Some(force) = &side.force {
                let values = [force.axial_n, force.radial_n, force.tangential_n].map(|value| significant(value, 5));
                forces.row(std::iter::once(name.into()).chain(values));
            }
        }
        write!(out, "{table}")?;
        if let Some(force) = self.normal_force_n {
            writeln!(
                out,
                "mean normal force {} N; on each shaft: axial along y, radial towards its axis, tangential",
                significant(force, 6)
            )?;
            write!(out, "{forces}")?;
        }
        if let Some((angle, offset)) = self.shaft_angle_deg.zip(self.offset_mm) {
            writeln!(out, "shaft angle {} deg, offset {} mm", significant(angle, 6), significant(offset, 5))?;
        }
        if let Some(frequency) = self.mesh_frequency_hz {
            writeln!(out, "mesh frequency {} Hz", significant(frequency, 5))?;
        }
        Ok(())
    }
}

impl ForceOutput {
    fn new(vectors: &MeshVectors, along: f64) -> Self {
        let ([x, _, z], [fx, fy, fz]) = (vectors.point, vectors.line_of_action.map(|component| component * along));
        let radius = x.hypot(z);
        Self { axial_n: fy, radial_n: -(x * fx + z * fz) / radius, tangential_n: (z * fx - x * fz) / radius }
    }
}
