//! Spur and helical pairs: the gear's y axis runs along the pinion's, its x and z are reversed.

use nalgebra::Vector3;

use super::{Member, Teeth};

pub(super) fn members(teeth: &Teeth, [pinion, gear]: [f64; 2], helix_angle: f64) -> (Member, Member) {
    let (sin_a, cos_a) = teeth.pressure_angle.sin_cos();
    let (sin_b, cos_b) = helix_angle.sin_cos();
    let line = Vector3::new(teeth.turns * cos_a * cos_b, -teeth.turns * teeth.hand * cos_a * sin_b, sin_a);
    let member = |radius: f64, side: f64| Member {
        point: Vector3::new(0.0, 0.0, radius),
        line_of_action: Vector3::new(side * line.x, line.y, side * line.z),
        axis: Vector3::y(),
        origin: Vector3::new(0.0, 0.0, if side > 0.0 { 0.0 } else { pinion + gear }),
        across: side * Vector3::x(),
    };
    (member(pinion, 1.0), member(gear, -1.0))
}
