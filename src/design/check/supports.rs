//! Combinations of bearings and axial springs that mean something.

use super::Checker;
use crate::design::SAME_STATION;
use crate::design::key_path::KeyPath;
use crate::design::rotor::{Bearing, BearingModel, DiagonalBearing, RotorDesign};

/// How a bearing carries the shaft along its axis.
#[derive(PartialEq)]
enum Axial {
    Free,
    Elastic,
    Held,
}

fn axial(bearing: &Bearing) -> Axial {
    let stiffness = match &bearing.model {
        BearingModel::Rigid(hold) if hold.y => return Axial::Held,
        BearingModel::Diagonal(diagonal) => diagonal.ky,
        BearingModel::Matrix(matrix) => matrix[1][1],
        BearingModel::Rigid(_) => 0.0,
        // all but cylindrical roller bearings take thrust
        BearingModel::Roller(roller) => f64::from(u8::from(roller.contact_angle != 0.0)),
        BearingModel::Ball(_) => 1.0,
    };
    if stiffness == 0.0 { Axial::Free } else { Axial::Elastic }
}

pub(super) fn check(rotor: &RotorDesign, path: &KeyPath, checker: &Checker<'_>) {
    for (place, bearing) in rotor.bearings.iter().enumerate() {
        check_bearing(rotor, bearing, &path.key("bearing").place(place), checker);
    }
    if rotor.housing_axial_stiffness.is_some() {
        check_housing(rotor, &path.key("housing_axial_stiffness_n_per_m"), checker);
    }
}

fn check_bearing(rotor: &RotorDesign, bearing: &Bearing, path: &KeyPath, checker: &Checker<'_>) {
    if let BearingModel::Rigid(hold) = bearing.model
        && (hold.x || hold.y || hold.z)
        && (bearing.position - rotor.mesh_position).abs() <= SAME_STATION
    {
        let message = "a rigid bearing must not sit at the mesh position: nothing could move there";
        checker.error(&path.key("position_mm"), message, None);
    }
    if bearing.axial_series_stiffness.is_some() {
        let path = path.key("axial_series_stiffness_n_per_m");
        match axial(bearing) {
            Axial::Elastic => {}
            Axial::Held => {
                let message = "a bearing that holds y rigidly cannot have a spring in series";
                checker.error(&path, message, Some("leave out \"y\" in hold, or this key"));
            }
            // a model that could not be read stands in as no stiffness at all: that has its own finding
            Axial::Free if bearing.model == BearingModel::Diagonal(DiagonalBearing::default()) => {}
            Axial::Free => checker.warn(&path, "has no effect: the bearing has no axial stiffness", None),
        }
    }
}

/// The housing bolt carries all axial reactions; which share a rigid support takes beside another is not determined.
fn check_housing(rotor: &RotorDesign, path: &KeyPath, checker: &Checker<'_>) {
    let count = |kind: Axial| rotor.bearings.iter().filter(|bearing| axial(bearing) == kind).count();
    let (held, elastic) = (count(Axial::Held), count(Axial::Elastic));
    if held > 1 {
        let message = format!("goes with one rigid axial support only; {held} bearings hold y");
        checker.error(path, message, None);
    } else if held == 1 && elastic > 0 {
        let message = "goes with rigid or elastic axial supports, not with both on one shaft";
        checker.error(path, message, None);
    }
}
