//! The mesh vectors: unit lines of action, and torque arms that fit the tooth numbers.

use super::Checker;
use crate::design::key_path::KeyPath;
use crate::design::model::{Design, MeshVectors};
use crate::number::significant;

/// How far from 1 the length of a line of action may be.
const UNIT_TOLERANCE: f64 = 1e-3;

/// How far the torque arms may be from the tooth numbers.
const ARM_TOLERANCE: f64 = 0.01;

pub(super) fn check(design: &mut Design, path: &KeyPath, checker: &Checker<'_>) {
    normalise(&mut design.mesh.pinion, &path.key("pinion"), checker);
    normalise(&mut design.mesh.gear, &path.key("gear"), checker);
    if let (Some(pinion), Some(gear)) = (design.pinion.teeth, design.gear.teeth) {
        torque_arms(design, f64::from(pinion), f64::from(gear), path, checker);
    }
}

fn normalise(side: &mut MeshVectors, path: &KeyPath, checker: &Checker<'_>) {
    let [x, y, z] = side.line_of_action;
    // hypot neither overflows nor vanishes on the way
    let length = x.hypot(y).hypot(z);
    if (length - 1.0).abs() <= UNIT_TOLERANCE {
        side.line_of_action = side.line_of_action.map(|component| component / length);
    } else if !length.is_nan() {
        let shown = if (1e-3..1e6).contains(&length) { format!("{length:.6}") } else { format!("{length:e}") };
        let message = format!("must be a unit vector, to {UNIT_TOLERANCE}; its length is {shown}");
        checker.error(&path.key("line_of_action"), message, None);
    }
}

/// Arm of the mesh force about the shaft, m: |y| component of point x line of action (Hua et al. 2012, eqs. 9 and 10).
fn torque_arm(side: &MeshVectors) -> f64 {
    let ([x, _, z], [nx, _, nz]) = (side.point, side.line_of_action);
    (z * nx - x * nz).abs()
}

fn torque_arms(design: &Design, pinion_teeth: f64, gear_teeth: f64, path: &KeyPath, checker: &Checker<'_>) {
    let (pinion, gear) = (torque_arm(&design.mesh.pinion), torque_arm(&design.mesh.gear));
    // the ratios agree where the cross products do; so an arm of zero needs no case of its own
    let (left, right) = (pinion * gear_teeth, gear * pinion_teeth);
    if (left - right).abs() > ARM_TOLERANCE * right {
        let message = format!(
            "torque arms of {} mm (pinion) and {} mm (gear) contradict the tooth numbers {pinion_teeth} and {gear_teeth} by more than 1 %",
            significant(pinion * 1e3, 6),
            significant(gear * 1e3, 6)
        );
        let hint = "the arms, |z n_x - x n_z| of each side, should be to each other as the tooth numbers";
        checker.warn(path, message, Some(hint));
    }
}
