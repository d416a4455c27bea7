//! A mean value of the mesh stiffness where no contact analysis is at hand.

/// Mean mesh stiffness by ISO 10300-1, method B, N/(mm um) over the face width.
const C_GAMMA: f64 = 20.0;

/// Why there is no estimate.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum StiffnessError {
    #[error("the face width must be greater than 0 mm")]
    FaceWidth,
    #[error("the spiral angle must be from 0 to less than 90 deg")]
    SpiralAngle,
}

/// Estimate of the mesh stiffness along the tooth normal, N/m: 20 N/(mm um) times the effective face width (m), which is transverse,
/// over the squared cosine of the mean spiral or helix angle (rad). ISO 10300-1, method B.
///
/// # Errors
///
/// A face width or an angle that no gear has.
pub fn mean_mesh_stiffness(effective_face_width: f64, spiral_angle: f64) -> Result<f64, StiffnessError> {
    if !(effective_face_width > 0.0 && effective_face_width.is_finite()) {
        return Err(StiffnessError::FaceWidth);
    }
    if !(0.0..std::f64::consts::FRAC_PI_2).contains(&spiral_angle) {
        return Err(StiffnessError::SpiralAngle);
    }
    // 1 N/(mm um) is 1e9 N/m^2
    Ok(C_GAMMA * 1e9 * effective_face_width / spiral_angle.cos().powi(2))
}
