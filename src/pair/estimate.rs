//! An estimate of the mesh stiffness, where no contact analysis is at hand.

use crate::design::{Edit, EditName, KeyPath, MeshGeometry, Spelled};
use crate::gear::{StiffnessError, mean_mesh_stiffness};
use crate::number::significant;

/// Where the estimate comes from, for whoever reads it.
pub const METHOD: &str = "estimate: ISO 10300-1, method B (bevel: effective width about 0.85 of the face), ISO 6336-1 (spur, helical): \
     20 N/(mm um) over the effective face width, along the tooth normal, for at least 100 N/mm of tooth load";

/// A mean mesh stiffness that follows from the face width.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    /// N/m
    pub stiffness: f64,
    /// The sum that was done, with numbers and units.
    pub formula: String,
}

impl Estimate {
    /// From the effective face width, m, and the mean spiral or helix angle, rad.
    ///
    /// # Errors
    ///
    /// A face width or an angle that no gear has.
    pub fn new(effective_face_width: f64, spiral_angle: f64) -> Result<Self, StiffnessError> {
        let stiffness = mean_mesh_stiffness(effective_face_width, spiral_angle)?;
        let [width, angle] = [effective_face_width * 1e3, spiral_angle.to_degrees()].map(|value| significant(value, 5));
        let cosine = if spiral_angle > 0.0 { format!(" / cos^2({angle} deg)") } else { String::new() };
        Ok(Self { stiffness, formula: format!("20 N/(mm um) x {width} mm{cosine}") })
    }

    /// As it is written into a design: no more digits than an estimate has.
    pub fn written(&self) -> String {
        format!("{:.3e}", self.stiffness)
    }

    /// Taking it over, as an edit that says beside the number that it is an estimate.
    pub fn edit(&self) -> Option<Edit> {
        let path = KeyPath::root().key("mesh").key("stiffness_n_per_m");
        let comment = Edit::Comment { path: path.clone(), text: format!("{METHOD}: {}", self.formula) };
        let set = Edit::Set { path, value: Spelled::parse(&self.written())? };
        Some(Edit::Several {
            edits: vec![set, comment],
            name: EditName::new("stiffness of the mesh (estimate, ISO 10300-1)"),
        })
    }
}

/// The mean spiral or helix angle that the estimate is made with, rad: of a hypoid pair the mean of both, as for its virtual cylindrical gears
/// in ISO 10300-1. Nothing where the gear data do not say it.
pub fn spiral_angle(geometry: &MeshGeometry) -> Option<f64> {
    if !geometry.kind.has_hand() {
        return Some(0.0);
    }
    if geometry.kind.is_parallel() {
        return geometry.helix_angle;
    }
    Some(f64::midpoint(geometry.pinion_spiral_angle?, geometry.gear_spiral_angle?))
}
