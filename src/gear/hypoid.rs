//! Pitch cones of a hypoid pair with crossed axes at a right angle.
//!
//! In a frame with the gear's axis along Z and the pinion's axis along X, at the offset a along Y, the mean point stands at the gear's
//! mean radius r2 and the angle eps from X. The common normal of both cones at the mean point meets both axes, so for a given gear
//! pitch angle everything follows from eps; the tooth ratio r1 u cos(beta1) = r2 cos(beta2) settles that. Which gear pitch angle it is
//! follows from the cutter: the limit curvature of the teeth (ISO 23509:2016, method 1) is that of the cutter's circle.

use std::f64::consts::FRAC_PI_2;

use super::Cone;

/// Mean cutter radii that are proposed, m: half of round sizes from 1 to 40 inches, the ends for pairs smaller and larger than most. A choice, not
/// the series of a standard.
pub const CUTTER_RADII: [f64; 18] = [
    0.0127, 0.01905, 0.0254, 0.03175, 0.04445, 0.05715, 0.0635, 0.0762, 0.09525, 0.1143, 0.13335, 0.1524, 0.2032,
    0.2286, 0.2667, 0.3048, 0.4064, 0.508,
];

/// What a hypoid pair is asked to be; m and rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HypoidBlank {
    /// Teeth of the gear over teeth of the pinion
    pub ratio: f64,
    /// Shortest distance of the axes
    pub offset: f64,
    pub gear_outer_diameter: f64,
    /// Of the gear
    pub face_width: f64,
    /// Mean spiral angle of the pinion
    pub pinion_spiral_angle: f64,
}

/// The pitch cones that do it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HypoidPitch {
    /// Pinion first
    pub cones: [Cone; 2],
    /// Mean cutter radius, m
    pub cutter_radius: f64,
    /// Difference of the spiral angles, rad: the offset angle in the pitch plane
    pub offset_angle: f64,
}

struct Solution {
    cones: [Cone; 2],
    /// 1/m, of the teeth in the pitch plane
    limit_curvature: f64,
}

impl HypoidBlank {
    /// The pitch cones for a mean cutter radius (m), or for the one of [`CUTTER_RADII`] that comes nearest to the gear pitch angle
    /// with which the method of ISO 23509 begins. Nothing where there is no such pair with a gear of 45 deg and more, which is flatter than
    /// its pinion.
    pub fn pitch(&self, cutter_radius: Option<f64>) -> Option<HypoidPitch> {
        // a gear is flatter than its pinion; it is never a disc
        const STEEPEST: f64 = std::f64::consts::FRAC_PI_4;
        const FLATTEST: f64 = FRAC_PI_2 - 0.01;
        let first = self.solve((self.ratio / 1.2).atan());
        let apart = |radius: f64| (1.0 / radius - first.limit_curvature).abs();
        let usual = || CUTTER_RADII.into_iter().min_by(|a, b| apart(*a).total_cmp(&apart(*b)));
        let cutter_radius = cutter_radius.or_else(usual)?;
        // the curvature falls as the gear gets flatter: its greatest value is at 21 to 38 deg
        let (mut low, mut high) = (STEEPEST, FLATTEST);
        let excess = |pitch_angle: f64| self.solve(pitch_angle).limit_curvature - 1.0 / cutter_radius;
        if !(excess(low) > 0.0 && excess(high) < 0.0) {
            return None;
        }
        for _ in 0..80 {
            let middle = f64::midpoint(low, high);
            if excess(middle) > 0.0 { low = middle } else { high = middle }
        }
        let [pinion, gear] = self.solve(f64::midpoint(low, high)).cones;
        let is_sound = |cone: &Cone| {
            cone.cone_distance.is_finite() && cone.cone_distance > 0.0 && (0.0..FRAC_PI_2).contains(&cone.spiral_angle)
        };
        let found =
            HypoidPitch { cones: [pinion, gear], cutter_radius, offset_angle: pinion.spiral_angle - gear.spiral_angle };
        found.cones.iter().all(is_sound).then_some(found)
    }

    /// The pair with that gear pitch angle.
    fn solve(&self, gear_pitch_angle: f64) -> Solution {
        let (sin_g, cos_g) = gear_pitch_angle.sin_cos();
        let gear_radius = (self.gear_outer_diameter - self.face_width * sin_g) / 2.0;
        let at = |eps: f64| {
            // distance of the mean point from the pinion's axis
            let across = self.offset - gear_radius * eps.sin();
            let pinion_radius = across * (sin_g / cos_g / eps.sin()).hypot(1.0);
            let pinion_pitch_angle = (cos_g * eps.cos()).asin();
            let offset_angle = (pinion_pitch_angle.tan() * gear_pitch_angle.tan()).clamp(-1.0, 1.0).acos();
            (pinion_radius, pinion_pitch_angle, offset_angle)
        };
        // from a pinion that is too large to one without size
        let (mut low, mut high) = (0.0, (self.offset / gear_radius).min(1.0).asin());
        for _ in 0..80 {
            let middle = f64::midpoint(low, high);
            let (pinion_radius, _, offset_angle) = at(middle);
            let pinion = pinion_radius * self.ratio * self.pinion_spiral_angle.cos();
            let gear = gear_radius * (self.pinion_spiral_angle - offset_angle).cos();
            if pinion > gear { low = middle } else { high = middle }
        }
        let (pinion_radius, pinion_pitch_angle, offset_angle) = at(f64::midpoint(low, high));
        let cone = |pitch_angle: f64, radius: f64, spiral_angle: f64| Cone {
            pitch_angle,
            cone_distance: radius / pitch_angle.sin(),
            spiral_angle,
        };
        let cones = [
            cone(pinion_pitch_angle, pinion_radius, self.pinion_spiral_angle),
            cone(gear_pitch_angle, gear_radius, self.pinion_spiral_angle - offset_angle),
        ];
        Solution { cones, limit_curvature: limit_curvature(&cones, offset_angle) }
    }
}

/// Limit curvature of the teeth, 1/m, at the limit pressure angle (ISO 23509:2016, method 1).
fn limit_curvature([pinion, gear]: &[Cone; 2], offset_angle: f64) -> f64 {
    let (tan_1, tan_2) = (pinion.pitch_angle.tan(), gear.pitch_angle.tan());
    let (r_1, r_2) = (pinion.cone_distance, gear.cone_distance);
    let (b_1, b_2) = (pinion.spiral_angle, gear.spiral_angle);
    let limit_angle =
        -(tan_1 * tan_2 / offset_angle.cos()) * (r_1 * b_1.sin() - r_2 * b_2.sin()) / (r_1 * tan_1 + r_2 * tan_2);
    let limit_angle = limit_angle.atan();
    let along = b_1.tan() / (r_1 * tan_1) + b_2.tan() / (r_2 * tan_2);
    let across = 1.0 / (r_1 * b_1.cos()) - 1.0 / (r_2 * b_2.cos());
    (across - limit_angle.tan() * along) * limit_angle.cos() / (b_1.tan() - b_2.tan())
}
