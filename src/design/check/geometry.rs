//! Gear data: what each kind of pair needs, and what contradicts.

use super::Checker;
use crate::design::geometry::{MeshGeometry, PairKind};
use crate::design::key_path::KeyPath;
use crate::design::model::Design;
use crate::gear::THRUST_INTO_MESH;
use crate::number::significant;

/// Checks the gear data and puts the mesh vectors that follow from them into the design.
pub(super) fn check(design: &mut Design, path: &KeyPath, checker: &Checker<'_>) {
    let Some(geometry) = design.mesh.geometry else { return };
    keys(&geometry, path, checker);
    for (side, teeth) in [("pinion", design.pinion.teeth), ("gear", design.gear.teeth)] {
        if teeth.is_none() {
            let teeth = KeyPath::root().key(side).key("teeth");
            checker.error(&teeth, "is missing: gear data need the number of teeth", None);
        }
    }
    contradictions(&geometry, path, checker);
    if let Some([pinion, gear]) = design.vectors_of_geometry() {
        (design.mesh.pinion, design.mesh.gear) = (pinion, gear);
    }
}

/// Every key that only some kinds have, whether it is written, and whether this kind has it.
fn keys(geometry: &MeshGeometry, path: &KeyPath, checker: &Checker<'_>) {
    let (bevel, leans) = (!geometry.kind.is_parallel(), geometry.kind.has_hand());
    for (key, written, wanted) in [
        ("hand", geometry.hand.is_some(), leans),
        ("pinion_pitch_angle_deg", geometry.pinion_pitch_angle.is_some(), bevel),
        ("gear_pitch_angle_deg", geometry.gear_pitch_angle.is_some(), bevel),
        ("pinion_mean_cone_distance_mm", geometry.pinion_mean_cone_distance.is_some(), bevel),
        ("gear_mean_cone_distance_mm", geometry.gear_mean_cone_distance.is_some(), bevel),
        ("pinion_spiral_angle_deg", geometry.pinion_spiral_angle.is_some(), bevel && leans),
        ("gear_spiral_angle_deg", geometry.gear_spiral_angle.is_some(), bevel && leans),
        ("pinion_apex_mm", geometry.pinion_apex.is_some(), bevel),
        ("gear_apex_mm", geometry.gear_apex.is_some(), bevel),
        ("pinion_pitch_diameter_mm", geometry.pinion_pitch_diameter.is_some(), !bevel),
        ("gear_pitch_diameter_mm", geometry.gear_pitch_diameter.is_some(), !bevel),
        ("helix_angle_deg", geometry.helix_angle.is_some(), !bevel && leans),
    ] {
        let kind = geometry.kind.word();
        match (written, wanted) {
            (false, true) => checker.error(&path.key(key), format!("is missing: a {kind} pair needs it"), None),
            (true, false) => checker.error(&path.key(key), format!("does not belong to a {kind} pair"), None),
            _ => {}
        }
    }
}

fn contradictions(geometry: &MeshGeometry, path: &KeyPath, checker: &Checker<'_>) {
    /// Sizes are written with few digits.
    const APART: f64 = 1e-3;
    let given = |value: Option<f64>| value.unwrap_or(f64::NAN);
    if geometry.kind == PairKind::SpiralBevel {
        let (pinion, gear) = (given(geometry.pinion_spiral_angle), given(geometry.gear_spiral_angle));
        if (pinion - gear).abs() > APART {
            let message = format!(
                "both members of a spiral bevel pair have one spiral angle; {} and {} deg are written",
                significant(pinion.to_degrees(), 6),
                significant(gear.to_degrees(), 6)
            );
            checker.error(
                &path.key("gear_spiral_angle_deg"),
                message,
                Some("pairs with an offset are kind = \"hypoid\""),
            );
        }
    }
    if matches!(geometry.kind, PairKind::SpiralBevel | PairKind::StraightBevel) {
        let (pinion, gear) = (given(geometry.pinion_mean_cone_distance), given(geometry.gear_mean_cone_distance));
        if (pinion / gear - 1.0).abs() > APART {
            let message = "differs from the pinion's: the pitch apexes of a bevel pair meet, so both are the same";
            checker.warn(&path.key("gear_mean_cone_distance_mm"), message, None);
        }
    }
    let pair = geometry.pair();
    // of either sign, so that not-a-number warns of nothing
    if !geometry.kind.is_parallel() && pair.forces(1.0)[0].axial < 0.0 {
        let message = format!("{THRUST_INTO_MESH}: it closes the backlash where a bearing gives way");
        checker.warn(
            &path.key("hand"),
            message,
            Some("the usual choice is the other hand, or the other sense of rotation"),
        );
    }
}
