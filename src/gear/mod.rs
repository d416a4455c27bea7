//! From the data sheet of a gear pair to the mesh: mesh point, line of action, and the forces of the teeth on both shafts.
//!
//! Each member has a frame of its own: y along its axis (of a bevel gear from the pitch apex towards the heel), z from the axis to
//! the mesh point at azimuth 0, x = y cross z. The line of action is the direction of the force on the gear.

mod bevel;
mod cylinder;
mod hypoid;
mod import;
mod mesh_stiffness;

pub use hypoid::{CUTTER_RADII, HypoidBlank, HypoidPitch};
pub use import::{AveragedMesh, COLUMNS, ImportError, read_csv};
pub use mesh_stiffness::{FULL_LOAD, LightLoad, StiffnessError, mean_mesh_stiffness};

use nalgebra::Vector3;

/// What is unusual about a pair of bevel gears.
pub const THRUST_INTO_MESH: &str = "thrust pulls the pinion into mesh on this flank";

/// What both members have in common.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Teeth {
    /// Normal pressure angle of the loaded flank, rad
    pub pressure_angle: f64,
    /// Hand of the pinion's teeth: +1 right, -1 left; of no effect where they are straight
    pub hand: f64,
    /// +1 where the driving pinion turns positively about its y axis, -1 where the other way; reversed where the other flank is loaded
    pub turns: f64,
}

/// One member of a bevel or hypoid pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// rad
    pub pitch_angle: f64,
    /// Mean cone distance, m
    pub cone_distance: f64,
    /// Mean spiral angle, rad; 0 for straight teeth
    pub spiral_angle: f64,
}

/// The pitch surfaces of a pair, pinion first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pitch {
    /// Straight and spiral bevel pairs, whose pitch apexes meet, and hypoid pairs, whose spiral angles differ
    Bevel { cones: [Cone; 2] },
    /// Spur and helical pairs: pitch radii, m, and helix angle, rad
    Parallel { radii: [f64; 2], helix_angle: f64 },
}

/// The mesh in the frame of one member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Member {
    /// Mesh point, m: from the pitch apex of a bevel gear, from the mesh plane of the others
    pub point: Vector3<f64>,
    /// Unit vector of the force on the gear
    pub line_of_action: Vector3<f64>,
    /// The member's y axis, and its origin (m), in a frame that both members share
    pub axis: Vector3<f64>,
    pub origin: Vector3<f64>,
    /// The member's x axis there
    pub across: Vector3<f64>,
}

/// Tooth force on one member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Force {
    /// N, along the member's y axis: of a bevel gear away from the apex, out of mesh
    pub axial: f64,
    /// N, towards the member's own axis: it separates the pair
    pub radial: f64,
    /// N, positive where it turns the member positively about its y axis
    pub tangential: f64,
}

/// A pair and how its axes lie.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pair {
    pub pinion: Member,
    pub gear: Member,
    /// Angle between both y axes, rad
    pub shaft_angle: f64,
    /// Shortest distance of the axes, m
    pub offset: f64,
}

impl Pair {
    /// The pair that follows from the data.
    pub fn new(teeth: &Teeth, pitch: &Pitch) -> Self {
        let (pinion, gear) = match pitch {
            Pitch::Bevel { cones } => bevel::members(teeth, cones),
            Pitch::Parallel { radii, helix_angle } => cylinder::members(teeth, *radii, *helix_angle),
        };
        let cross = pinion.axis.cross(&gear.axis);
        let between = gear.origin - pinion.origin;
        let shaft_angle = cross.norm().atan2(pinion.axis.dot(&gear.axis));
        let offset = if cross.norm() > 1e-9 {
            (between.dot(&cross) / cross.norm()).abs()
        } else {
            (between - pinion.axis * between.dot(&pinion.axis)).norm()
        };
        Self { pinion, gear, shaft_angle, offset }
    }

    /// Whether the axes pass one another; less is what rounding of a data sheet to hundredths of a millimetre leaves of axes that meet.
    pub fn is_offset(&self) -> bool {
        const HALF_A_DIGIT: f64 = 5e-6;
        self.offset >= HALF_A_DIGIT
    }

    /// Normal force, N, under a torque of the pinion (N m): |T| over the arm of the line of action.
    pub fn normal_force(&self, pinion_torque: f64) -> f64 {
        pinion_torque.abs() / self.pinion.torque_arm().abs()
    }

    /// Forces on pinion and gear under a normal force, N.
    pub fn forces(&self, normal_force: f64) -> [Force; 2] {
        [self.pinion.force(-normal_force), self.gear.force(normal_force)]
    }
}

impl Member {
    /// Lever arm of the line of action about the y axis, m, with its sign.
    pub fn torque_arm(&self) -> f64 {
        self.point.cross(&self.line_of_action).y
    }

    fn force(&self, along: f64) -> Force {
        let force = self.line_of_action * along;
        // azimuth 0: z leads from the axis to the mesh point, and a force along x turns positively
        Force { axial: force.y, radial: -force.z, tangential: force.x }
    }

    /// Mesh point and line of action with the mesh point elsewhere round the shaft: `azimuth` (rad) from +z, counted about +y.
    pub fn turned(&self, azimuth: f64) -> (Vector3<f64>, Vector3<f64>) {
        let turn = nalgebra::Rotation3::from_axis_angle(&Vector3::y_axis(), azimuth);
        (turn * self.point, turn * self.line_of_action)
    }
}
