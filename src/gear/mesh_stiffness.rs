//! A mean value of the mesh stiffness where no contact analysis is at hand.

/// Mean mesh stiffness by ISO 10300-1, method B, and by ISO 6336-1, N/(mm um) over the face width.
const C_GAMMA: f64 = 20.0;
/// Largest effective face width, m, and mean spiral or helix angle, deg: beyond those of any gear.
const WIDEST: f64 = 10.0;
const STEEPEST_DEG: f64 = 80.0;
/// Tangential force over the effective face width from which teeth have their full stiffness, N/m.
pub const FULL_LOAD: f64 = 100e3;

/// Why there is no estimate.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum StiffnessError {
    #[error("the face width must be greater than 0 mm, and at most 10 000 mm")]
    FaceWidth,
    #[error("the spiral angle must be from 0 to 80 deg")]
    SpiralAngle,
}

/// Estimate of the mesh stiffness along the tooth normal, N/m: 20 N/(mm um) times the effective face width (m), which is transverse,
/// over the squared cosine of the mean spiral or helix angle (rad). ISO 10300-1, method B, for bevel gears, ISO 6336-1 for
/// cylindrical ones; both for [at least 100 N/mm](FULL_LOAD).
///
/// # Errors
///
/// A face width or an angle that no gear has.
pub fn mean_mesh_stiffness(effective_face_width: f64, spiral_angle: f64) -> Result<f64, StiffnessError> {
    if !(effective_face_width > 0.0 && effective_face_width <= WIDEST) {
        return Err(StiffnessError::FaceWidth);
    }
    // a limit that was typed may be a rounding off
    if !(0.0..=STEEPEST_DEG + 1e-9).contains(&spiral_angle.to_degrees()) {
        return Err(StiffnessError::SpiralAngle);
    }
    // 1 N/(mm um) is 1e9 N/m^2
    Ok(C_GAMMA * 1e9 * effective_face_width / spiral_angle.cos().powi(2))
}

/// How the stiffness falls below the full load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LightLoad {
    /// In proportion to the load: `C_F` of ISO 10300-1
    Bevel,
    /// With its fourth root: ISO 6336-1
    Cylindrical,
}

impl LightLoad {
    /// Of the full stiffness under a tangential force over the effective face width, N/m.
    pub fn factor(self, specific_load: f64) -> f64 {
        let share = (specific_load / FULL_LOAD).min(1.0);
        match self {
            Self::Bevel => share,
            Self::Cylindrical => share.sqrt().sqrt(),
        }
    }
}
