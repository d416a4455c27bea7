//! The torque, and what a mean load from it needs.

use super::Checker;
use crate::design::key_path::KeyPath;
use crate::design::{Bearing, BearingModel, Design, MeanState, Side};

pub(super) fn check(design: &Design, top: &KeyPath, checker: &Checker<'_>) {
    if design.operating.and_then(|operating| operating.pinion_torque).is_some_and(|torque| torque < 0.0) {
        let hint =
            "pinion_turns in [mesh.geometry] chooses the loaded flank; without gear data the line of action does";
        let path = top.key("operating").key("pinion_torque_n_m");
        checker.warn(&path, "only its size counts: the sign changes nothing", Some(hint));
    }
    let is_from_torque = |bearing: &&Bearing| matches!(mean_state(bearing), Some(MeanState::FromTorque(_)));
    for side in Side::BOTH {
        for (place, _) in design.rotor(side).bearings.iter().enumerate().filter(|(_, b)| is_from_torque(b)) {
            let path = top.key(side.name()).key("bearing").place(place).key("mean_load");
            if design.operating.is_none_or(|operating| operating.pinion_torque.is_none()) {
                let hint = "write pinion_torque_n_m = 300.0 in a table [operating]";
                checker.error(&path, "needs pinion_torque_n_m in [operating]", Some(hint));
            } else if torque_arm(design) == 0.0 {
                let message = "the line of action meets the pinion's axis: no mesh force can carry the torque";
                checker.error(&path, message, None);
            }
        }
    }
}

fn mean_state(bearing: &Bearing) -> Option<MeanState> {
    match &bearing.model {
        BearingModel::Ball(ball) => ball.mean_state(),
        BearingModel::Roller(roller) => roller.mean_state(),
        _ => None,
    }
}

fn torque_arm(design: &Design) -> f64 {
    let ([x, _, z], [nx, _, nz]) = (design.mesh.pinion.point, design.mesh.pinion.line_of_action);
    z * nx - x * nz
}
