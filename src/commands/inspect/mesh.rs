//! The mesh: where and along which line the teeth push, and what that means for each shaft.

use std::io::{self, Write};

use crate::design::Design;
use crate::gear::Force;
use crate::number::significant;
use crate::pair::{Arms, PairFigures, ShaftFigures};
use crate::report::Table;
use crate::text::wrap;

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
    /// What that is called: of parallel axes the centre distance
    #[serde(skip)]
    distance: &'static str,
    /// Arm of the gear over that of the pinion, and the teeth; only with the teeth of both
    #[serde(flatten)]
    arms: Option<ArmsOutput>,
    /// Only with a torque
    #[serde(skip_serializing_if = "Option::is_none")]
    normal_force_n: Option<f64>,
    /// Only without one: the forces under 1 N m
    #[serde(skip_serializing_if = "Option::is_none")]
    at_1_n_m: Option<UnitOutput>,
    /// Which way the teeth push both shafts
    thrust: String,
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
#[derive(Clone, Copy, serde::Serialize)]
struct ForceOutput {
    /// Along y
    axial_n: f64,
    /// Towards the shaft's own axis
    radial_n: f64,
    /// Turns the shaft positively about y
    tangential_n: f64,
}

#[derive(serde::Serialize)]
struct ArmsOutput {
    torque_arm_ratio: f64,
    tooth_ratio: f64,
    torque_arm_deviation_percent: f64,
    #[serde(skip)]
    deviation: String,
}

#[derive(serde::Serialize)]
struct UnitOutput {
    normal_force_n: f64,
    pinion: ForceOutput,
    gear: ForceOutput,
}

impl MeshOutput {
    pub fn new(design: &Design) -> Self {
        let figures = PairFigures::new(design);
        let force = |shaft: &ShaftFigures| shaft.force.map(ForceOutput::from);
        let side = |shaft: &ShaftFigures| SideOutput {
            point_mm: shaft.vectors.point.map(|value| value * 1e3),
            line_of_action: shaft.vectors.line_of_action,
            torque_arm_mm: shaft.torque_arm * 1e3,
            force: force(shaft).filter(|_| figures.torque.is_some()),
        };
        let under_1_n_m = || {
            let (pinion, gear) = force(&figures.pinion).zip(force(&figures.gear))?;
            Some(UnitOutput { normal_force_n: figures.normal_force?, pinion, gear })
        };
        Self {
            pinion: side(&figures.pinion),
            gear: side(&figures.gear),
            shaft_angle_deg: figures.pair.map(|pair| pair.shaft_angle.to_degrees()),
            offset_mm: figures.pair.map(|pair| pair.offset * 1e3),
            distance: if figures.has_cones() { "offset" } else { "centre distance" },
            arms: figures.arms.map(ArmsOutput::from),
            normal_force_n: figures.normal_force.filter(|_| figures.torque.is_some()),
            at_1_n_m: if figures.torque.is_none() { under_1_n_m() } else { None },
            thrust: figures.thrust(),
            mesh_frequency_hz: figures.mesh_frequency,
        }
    }

    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        writeln!(out, "\nMESH")?;
        let mut table = Table::new(["  ", "point x, y, z, mm", "line of action", "torque arm, mm"]);
        let mut forces = Table::new(["  ", "axial, N", "radial, N", "tangential, N"]);
        let unit = self.at_1_n_m.as_ref();
        for (name, side, unit) in [
            ("  pinion", &self.pinion, unit.map(|unit| unit.pinion)),
            ("  gear", &self.gear, unit.map(|unit| unit.gear)),
        ] {
            let three = |values: [f64; 3]| values.map(|value| significant(value, 5)).join("  ");
            table.row([
                name.into(),
                three(side.point_mm),
                three(side.line_of_action),
                significant(side.torque_arm_mm, 5),
            ]);
            if let Some(force) = side.force.or(unit) {
                let values = [force.axial_n, force.radial_n, force.tangential_n].map(|value| significant(value, 5));
                forces.row(std::iter::once(name.into()).chain(values));
            }
        }
        write!(out, "{table}")?;
        let normal =
            self.normal_force_n.map(|force| (force, "")).or(unit.map(|unit| (unit.normal_force_n, " under 1 N m")));
        if let Some((force, when)) = normal {
            writeln!(
                out,
                "mean normal force {} N{when}; on each shaft:\naxial along y, radial towards its axis, tangential",
                significant(force, 6)
            )?;
            write!(out, "{forces}")?;
        }
        for line in wrap(&self.thrust, 79) {
            writeln!(out, "{line}")?;
        }
        if let Some((angle, offset)) = self.shaft_angle_deg.zip(self.offset_mm) {
            writeln!(
                out,
                "shaft angle {} deg, {} {} mm",
                significant(angle, 6),
                self.distance,
                significant(offset, 5)
            )?;
        }
        if let Some(arms) = &self.arms {
            let [ratio, teeth] = [arms.torque_arm_ratio, arms.tooth_ratio].map(|ratio| significant(ratio, 5));
            writeln!(out, "torque arms {ratio} to 1, teeth {teeth} to 1: {}", arms.deviation)?;
        }
        if let Some(frequency) = self.mesh_frequency_hz {
            writeln!(out, "mesh frequency {} Hz", significant(frequency, 5))?;
        }
        Ok(())
    }
}

impl From<Arms> for ArmsOutput {
    fn from(arms: Arms) -> Self {
        Self {
            torque_arm_ratio: arms.ratio,
            tooth_ratio: arms.tooth_ratio(),
            torque_arm_deviation_percent: arms.deviation_percent,
            deviation: arms.deviation(),
        }
    }
}

impl From<Force> for ForceOutput {
    fn from(force: Force) -> Self {
        Self { axial_n: force.axial, radial_n: force.radial, tangential_n: force.tangential }
    }
}
