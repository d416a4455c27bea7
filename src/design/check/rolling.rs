//! Ball and roller bearings: contact data or geometry, and exactly one mean state.

use std::f64::consts::PI;

use super::Checker;
use crate::design::key_path::KeyPath;
use crate::design::read::listed;
use crate::design::rolling::{BallBearing, RollerBearing};
use crate::design::rotor::{Bearing, BearingModel};

pub(super) fn check(bearing: &Bearing, path: &KeyPath, checker: &Checker<'_>) {
    match &bearing.model {
        BearingModel::Ball(ball) => {
            let states = [ball.displacement.is_some(), ball.preload.is_some(), ball.mean_load.is_some()];
            mean_state(states, ball.mounting_preload, ball.contact_angle, path, checker);
            check_ball(ball, path, checker);
        }
        BearingModel::Roller(roller) => {
            let states = [roller.displacement.is_some(), roller.preload.is_some(), roller.mean_load.is_some()];
            mean_state(states, roller.mounting_preload, roller.contact_angle, path, checker);
            check_roller(roller, path, checker);
        }
        _ => {}
    }
}

const MEAN_STATES: [&str; 3] = ["displacement", "preload", "mean_load"];

fn mean_state(written: [bool; 3], mounting: f64, angle: f64, path: &KeyPath, checker: &Checker<'_>) {
    let keys: Vec<&str> =
        MEAN_STATES.into_iter().zip(written).filter(|(_, written)| *written).map(|(key, _)| key).collect();
    match keys[..] {
        [] => {
            let message = "its mean state is missing: exactly one of displacement, preload, mean_load is wanted";
            checker.error(
                path,
                message,
                Some("for example preload = { y_n = 5000.0 }, or mean_load = \"from-torque\""),
            );
        }
        [_] => {}
        [first, second, ..] => {
            let message =
                format!("goes with `{first}` never: exactly one of displacement, preload, mean_load is wanted");
            checker.error(&path.key(second), message, None);
        }
    }
    if mounting > 0.0 {
        let path = path.key("mounting_preload_um");
        if !written[2] {
            checker.warn(&path, "has no effect without mean_load = \"from-torque\"", None);
        } else if angle == 0.0 {
            let message = "needs a contact angle: without one no axial approach closes the bearing";
            checker.error(&path, message, None);
        }
    }
}

fn check_ball(ball: &BallBearing, path: &KeyPath, checker: &Checker<'_>) {
    let contact = [
        ("contact_stiffness_n_per_m_1_5", ball.contact_stiffness),
        ("groove_distance_mm", ball.groove_distance),
        ("pitch_radius_mm", ball.pitch_radius),
    ];
    let geometry = [
        ("ball_diameter_mm", ball.ball_diameter),
        ("pitch_diameter_mm", ball.pitch_diameter),
        ("inner_groove_factor", ball.inner_groove_factor),
        ("outer_groove_factor", ball.outer_groove_factor),
    ];
    let first =
        |group: &[(&'static str, Option<f64>)]| group.iter().find(|(_, value)| value.is_some()).map(|(key, _)| *key);
    match (first(&contact), first(&geometry)) {
        (Some(contact), Some(geometry)) => {
            let message = format!("goes with `{contact}` never: give contact data or geometry, not both");
            checker.error(&path.key(geometry), message, None);
        }
        (None, None) => {
            let all = |group: &[(&'static str, Option<f64>)]| listed(group.iter().map(|(key, _)| *key));
            let hint = format!("contact data: {}; or geometry: {}", all(&contact), all(&geometry));
            checker.error(path, "its contacts are missing: give contact data or geometry", Some(&hint));
        }
        (Some(_), None) => missing(&contact, path, checker),
        (None, Some(_)) => missing(&geometry, path, checker),
    }
    sizes(ball, path, checker);
}

fn missing(group: &[(&'static str, Option<f64>)], path: &KeyPath, checker: &Checker<'_>) {
    for (key, _) in group.iter().filter(|(_, value)| value.is_none()) {
        checker.error(path, format!("`{key}` is missing"), None);
    }
}

fn sizes(ball: &BallBearing, path: &KeyPath, checker: &Checker<'_>) {
    let (diameter, pitch) = (ball.ball_diameter.unwrap_or(f64::NAN), ball.pitch_diameter.unwrap_or(f64::NAN));
    if diameter >= pitch {
        let message =
            format!("must be less than pitch_diameter_mm, {:?} mm; it is {:?} mm", pitch * 1e3, diameter * 1e3);
        checker.error(&path.key("ball_diameter_mm"), message, None);
    } else if ball.elements as f64 * diameter > PI * pitch {
        let message = format!("{} balls of {:?} mm do not fit on the pitch circle", ball.elements, diameter * 1e3);
        checker.warn(&path.key("elements"), message, None);
    }
    let geometry = |factors: (f64, f64)| (factors.0 + factors.1 - 1.0) * diameter;
    let factors = ball.inner_groove_factor.zip(ball.outer_groove_factor);
    let distance = ball.groove_distance.or(factors.map(geometry)).unwrap_or(f64::NAN);
    // cos(alpha0) = 1 - r_L / A0: the angle is what the clearance leaves room for
    let room = distance * (1.0 - ball.contact_angle.cos());
    if ball.clearance > 0.0 && (ball.clearance / room - 1.0).abs() < 0.01 {
        let message = "the contact angle comes from this very clearance: it would count twice";
        checker.warn(&path.key("clearance_mm"), message, Some("leave the clearance out"));
    }
}

fn check_roller(roller: &RollerBearing, path: &KeyPath, checker: &Checker<'_>) {
    if roller.contact_stiffness.is_none() && roller.roller_length.is_none() {
        let message = "contact_stiffness_n_per_m_10_9 or roller_length_mm is missing, of which a steel roller's stiffness follows";
        checker.error(path, message, None);
    }
}
