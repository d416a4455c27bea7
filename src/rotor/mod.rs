//! One shaft with its bearings and bodies: stations, beams, assembly, statics and first bending modes.

mod assembly;
mod beam;
mod bending;
mod count;
mod initial_parameter;
mod mean_shaft;
mod mean_states;
mod mesh;
mod plane;
mod root;
mod section;
mod statics;
mod stations;
mod supports;
mod totals;
mod transfer;

pub use assembly::ShaftMatrices;
pub use beam::ElementMatrix;
pub use bending::Bending;
pub use mean_states::{MeanStates, Rolling};
pub use mesh::{mesh_frequency_hz, mesh_vector, pinion_speed_rpm, signed};
pub use section::Section;
pub use statics::Statics;
pub use stations::Stations;
pub use supports::{Support, Supports};
pub use totals::Totals;

use crate::bearing;
use crate::design::{Design, MAX_STATIONS, Side};

/// Motion of a station's six coordinates, in their order; y is along the shaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Motion {
    X,
    Y,
    Z,
    ThX,
    ThY,
    ThZ,
}

impl Motion {
    pub const ALL: [Self; 6] = [Self::X, Self::Y, Self::Z, Self::ThX, Self::ThY, Self::ThZ];
}

/// Why a rotor cannot be built or solved.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RotorError {
    #[error("nothing holds it {}; {}", motions(.0), cure(.0))]
    Unsupported(Vec<Motion>),
    #[error("more than {MAX_STATIONS} stations: use fewer elements")]
    TooManyStations,
    #[error("position {position_mm:?} mm is off the shaft, which is {length_mm:?} mm long")]
    OffShaft { position_mm: f64, length_mm: f64 },
    #[error("the shaft is too short to have two stations")]
    TooShort,
    #[error("there is no material \"{}\"", .0.escape_debug())]
    UnknownMaterial(String),
    #[error("a rigid bearing holds the mesh station")]
    RigidAtMesh,
    #[error("bearing \"{}\" is rigid along the shaft: a series stiffness needs an elastic bearing", .0.escape_debug())]
    SeriesOnRigid(String),
    #[error(
        "the housing stiffness needs either elastic axial supports only or one rigid one alone: with more it is not \
         clear what rests on it"
    )]
    HousingAmbiguous,
    #[error("bearing \"{}\": {error}", name.escape_debug())]
    Bearing { name: String, error: BearingError },
    #[error(
        "SINGULAR: even with all rolling elements in contact nothing holds it {}; a bearing with a contact angle or with stiffness of its own \
         is wanted there", motions(.0)
    )]
    Singular(Vec<Motion>),
    #[error(
        "UNSUPPORTED_LOAD: bearing \"{}\" gives way under the mean mesh load of {:.4e}, {:.4e} and {:.4e} N in x, y and z; its thrust \
         points the unloaded way, or a bearing against it is missing", name.escape_debug(), load[0], load[1], load[2]
    )]
    GivesWay { name: String, load: [f64; 6] },
    #[error(
        "UNSUPPORTED_LOAD: bearing \"{}\" under the mean mesh load of {:.4e}, {:.4e} and {:.4e} N in x, y and z: the inner ring would move \
         by more than a quarter of its radius: the load is far too large for it",
        name.escape_debug(), load[0], load[1], load[2]
    )]
    MovesTooFar { name: String, load: [f64; 6] },
    #[error("NO_CONVERGENCE: no mean state was found; the mesh load is balanced to {residual:.1e} of its size only")]
    NoConvergence { residual: f64 },
    #[error("the {0} is too large or too small to compute with")]
    NotFinite(&'static str),
    #[error("the {0} cannot be factorised: values lie too many orders of magnitude apart")]
    IllConditioned(&'static str),
}

/// What is wrong with one ball or roller bearing.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum BearingError {
    #[error(transparent)]
    BadInput(#[from] bearing::BadInput),
    #[error(transparent)]
    Equilibrium(#[from] bearing::EquilibriumError),
    #[error("exactly one of displacement, preload and mean_load is wanted")]
    NoMeanState,
    #[error(
        "a mean load from torque needs pinion_torque_n_m in [operating], and a line of action that does not meet the pinion's axis"
    )]
    NoTorque,
}

/// In words, for "nothing holds it ...".
fn motions(motions: &[Motion]) -> String {
    let words = motions.iter().map(|motion| match motion {
        Motion::X => "sideways in x",
        Motion::Y => "in the axial direction",
        Motion::Z => "sideways in z",
        Motion::ThX => "against tilting about x",
        Motion::ThY => "against turning",
        Motion::ThZ => "against tilting about z",
    });
    words.collect::<Vec<_>>().join(", ")
}

/// What a bearing needs for the first of the motions.
fn cure(motions: &[Motion]) -> &'static str {
    match motions.first() {
        Some(Motion::X) => "give a bearing kx_n_per_m greater than 0, or let a rigid one hold \"x\"",
        Some(Motion::Y) => "give a bearing ky_n_per_m greater than 0, or let a rigid one hold \"y\"",
        Some(Motion::Z) => "give a bearing kz_n_per_m greater than 0, or let a rigid one hold \"z\"",
        Some(Motion::ThX) => "add a second bearing with kz_n_per_m, or give one krx_n_m_per_rad",
        _ => "add a second bearing with kx_n_per_m, or give one krz_n_m_per_rad",
    }
}

/// A shaft that is held, with its statics and first bending modes.
#[derive(Debug, Clone)]
pub struct Rotor {
    pub stations: Stations,
    pub supports: Supports,
    /// Of the ball and roller bearings
    pub mean_states: MeanStates,
    pub totals: Totals,
    pub statics: Statics,
    /// First bending mode in the x-y plane (x, thz)
    pub bending_x: Bending,
    /// First bending mode in the y-z plane (z, thx)
    pub bending_z: Bending,
}

impl Rotor {
    /// Places the stations, checks that the bearings hold the shaft, and solves its statics and first bending modes.
    ///
    /// # Errors
    ///
    /// [`RotorError`] where the shaft is not held, has too many stations, or its numbers overflow.
    pub fn new(design: &Design, side: Side) -> Result<Self, RotorError> {
        Self::reusing(design, side, None)
    }

    /// As [`new`](Self::new); the mean states of its bearings are taken over where nothing that they depend on differs.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn reusing(design: &Design, side: Side, earlier: Option<&MeanStates>) -> Result<Self, RotorError> {
        let rotor = design.rotor(side);
        let stations = Stations::new(design, rotor)?;
        // first: beside a length that overflows no bearing seems to hold anything
        let totals = Totals::new(rotor, &stations);
        totals.check_finite()?;
        let coarse = stations.coarsened();
        let mean_states = MeanStates::new(design, side, &stations, earlier)?;
        let supports = Supports::new(rotor, &mean_states)?;
        assembly::check_supported(&stations, &supports)?;
        let statics = Statics::new(rotor, &coarse, &supports)?;
        let [bending_x, bending_z] = bending::in_both_planes(rotor, &coarse, &supports, &statics)?;
        Ok(Self { stations, supports, mean_states, totals, statics, bending_x, bending_z })
    }
}
