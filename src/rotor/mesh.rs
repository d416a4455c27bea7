//! The mesh spring: how it grips the mesh station.

use nalgebra::Vector6;

use crate::design::{Design, MeshVectors, Side};

/// h of (9), (10): force and moments on the mesh station for a unit force along the line of action; order x, y, z, thx, thy, thz, moments
/// in m.
pub fn mesh_vector(vectors: &MeshVectors) -> Vector6<f64> {
    let [x, y, z] = vectors.point;
    let [nx, ny, nz] = vectors.line_of_action;
    Vector6::new(nx, ny, nz, y * nz - z * ny, z * nx - x * nz, x * ny - y * nx)
}

/// Sign of the mesh vector on a shaft: the spring is stretched by +h_p . x_p - h_g . x_g (8).
pub fn signed(side: Side) -> f64 {
    match side {
        Side::Pinion => 1.0,
        Side::Gear => -1.0,
    }
}

/// The tooth mesh frequency f = N_p n / 60 (Hz) at the speed that the design is run at; nothing where it says no speed or no number of teeth.
pub fn mesh_frequency_hz(design: &Design) -> Option<f64> {
    let teeth = design.pinion.teeth.filter(|teeth| *teeth > 0)?;
    let speed = design.operating?.pinion_speed.filter(|speed| *speed > 0.0)?;
    Some(f64::from(teeth) * speed / std::f64::consts::TAU)
}

/// Speed of the pinion (1/min) at which its tooth mesh frequency f = N_p n / 60 is the given one (Hz); nothing where the design has no
/// number of teeth.
pub fn pinion_speed_rpm(design: &Design, mesh_frequency_hz: f64) -> Option<f64> {
    let teeth = design.pinion.teeth.filter(|teeth| *teeth > 0)?;
    Some(60.0 * mesh_frequency_hz / f64::from(teeth))
}
