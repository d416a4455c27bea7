//! Bevel and hypoid pairs, by their common pitch plane at the mean point.
//!
//! The shared frame has its origin at the mean point P, its first axis along the pinion's generator t_p (apex to P), its third along
//! the normal m of the pitch plane, out of the pinion into the gear.

use nalgebra::Vector3;

use super::{Cone, Member, Teeth};

pub(super) fn members(teeth: &Teeth, [pinion, gear]: &[Cone; 2]) -> (Member, Member) {
    let (t_p, m) = (Vector3::x(), Vector3::z());
    // pitch-line velocity of the pinion at P for positive rotation
    let s = t_p.cross(&m);
    let (sin_a, cos_a) = teeth.pressure_angle.sin_cos();
    let (sin_b, cos_b) = pinion.spiral_angle.sin_cos();
    let tooth = teeth.turns * (cos_b * s - teeth.hand * sin_b * t_p);
    let line = cos_a * tooth + sin_a * m;
    // a hypoid pair's generators stand apart by the difference of the spiral angles
    let (sin_z, cos_z) = (pinion.spiral_angle - gear.spiral_angle).sin_cos();
    let t_g = cos_z * t_p + teeth.hand * sin_z * s;
    (member(pinion, t_p, -m, line), member(gear, t_g, m, line))
}

/// `inwards`: normal of the pitch plane towards the side on which the axis lies at the heel.
fn member(cone: &Cone, generator: Vector3<f64>, inwards: Vector3<f64>, line: Vector3<f64>) -> Member {
    let (sin, cos) = cone.pitch_angle.sin_cos();
    let y = cos * generator + sin * inwards;
    let z = (generator - cos * y) / sin;
    let x = y.cross(&z);
    Member {
        point: Vector3::new(0.0, cone.cone_distance * cos, cone.cone_distance * sin),
        line_of_action: Vector3::new(line.dot(&x), line.dot(&y), line.dot(&z)),
        axis: y,
        origin: -cone.cone_distance * generator,
        across: x,
    }
}
