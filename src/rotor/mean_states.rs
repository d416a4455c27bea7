//! Mean states of the ball and roller bearings of a rotor: what their stiffness depends on.

use std::sync::Arc;

use nalgebra::Vector6;

use super::{BearingError, RotorError, Stations, mean_shaft, mesh_vector, signed};
use crate::bearing::{self, State, Vector, Warning, equilibrium, frames};
use crate::design::{Bearing, BearingModel, Design, MeanState, Side};

/// A ball or roller bearing at its mean state.
#[derive(Debug, Clone, PartialEq)]
pub struct Rolling {
    pub bearing: bearing::Bearing,
    pub state: State,
}

/// The mean states of all bearings of a rotor, with what they were found from.
#[derive(Debug, Clone, PartialEq)]
pub struct MeanStates {
    inputs: Inputs,
    /// In the design's order; nothing for bearings whose stiffness is given. Shared with the states that they were taken over from
    pub bearings: Arc<[Option<Rolling>]>,
}

/// All that the mean states depend on: names, series springs, masses and drives are not among it.
#[derive(Debug, Clone, PartialEq)]
struct Inputs {
    bearings: Vec<BearingModel>,
    /// The shaft and the mean load at its mesh station, where a state follows from the torque
    shaft: Option<(Stations, Vector6<f64>)>,
}

impl MeanStates {
    /// Finds the mean states, or takes those of `earlier` where they come from the same.
    ///
    /// # Errors
    ///
    /// [`RotorError`] with the bearing that is not in contact or cannot carry its load.
    pub fn new(design: &Design, side: Side, stations: &Stations, earlier: Option<&Self>) -> Result<Self, RotorError> {
        let inputs = Inputs::new(design, side, stations)?;
        if let Some(earlier) = earlier.filter(|earlier| earlier.inputs == inputs) {
            return Ok(earlier.clone());
        }
        let rotor = design.rotor(side);
        let mut bearings = Vec::with_capacity(inputs.bearings.len());
        for (place, bearing) in rotor.bearings.iter().enumerate() {
            let is_same = |earlier: &&Self| earlier.inputs.bearings.get(place) == Some(&bearing.model);
            let state = match (mean_state(bearing), earlier.filter(is_same)) {
                (Some(MeanState::FromTorque(_)), _) => None,
                (_, Some(earlier)) => earlier.bearings[place].clone(),
                (_, None) => {
                    own_state(bearing).map_err(|error| RotorError::Bearing { name: bearing.name.clone(), error })?
                }
            };
            bearings.push(state);
        }
        if let Some((stations, load)) = &inputs.shaft {
            let given = |place: usize| bearings[place].as_ref().map(|rolling: &Rolling| rolling.state.stiffness);
            for (place, rolling) in mean_shaft::solve(rotor, stations, load, given)? {
                bearings[place] = Some(rolling);
            }
        }
        Ok(Self { inputs, bearings: bearings.into() })
    }

    /// What is unusual about the states, each with the place of its bearing.
    pub fn warnings(&self) -> impl Iterator<Item = (usize, &Warning)> {
        let states =
            self.bearings.iter().enumerate().filter_map(|(place, rolling)| Some((place, &rolling.as_ref()?.state)));
        states.flat_map(|(place, state)| state.warnings.iter().map(move |warning| (place, warning)))
    }

    /// Mean load on the rotor at its mesh station (order x, y, z, thx, thy, thz; N and N m), where a bearing's state follows from it.
    pub fn mesh_load(&self) -> Option<&Vector6<f64>> {
        self.inputs.shaft.as_ref().map(|(_, load)| load)
    }
}

impl Inputs {
    fn new(design: &Design, side: Side, stations: &Stations) -> Result<Self, RotorError> {
        let bearings = &design.rotor(side).bearings;
        let from_torque = |bearing: &&Bearing| matches!(mean_state(bearing), Some(MeanState::FromTorque(_)));
        let shaft = match bearings.iter().find(from_torque) {
            None => None,
            Some(bearing) => {
                let error = || RotorError::Bearing { name: bearing.name.clone(), error: BearingError::NoTorque };
                Some((stations.of_springs(), mean_mesh_load(design, side).ok_or_else(error)?))
            }
        };
        Ok(Self { bearings: bearings.iter().map(|bearing| bearing.model.clone()).collect(), shaft })
    }
}

pub(super) fn mean_state(bearing: &Bearing) -> Option<MeanState> {
    match &bearing.model {
        BearingModel::Ball(ball) => ball.mean_state(),
        BearingModel::Roller(roller) => roller.mean_state(),
        _ => None,
    }
}

/// The bearing that can be computed with, of those that need it.
pub(super) fn of_design(bearing: &Bearing) -> Option<Result<bearing::Bearing, bearing::BadInput>> {
    match &bearing.model {
        BearingModel::Ball(ball) => Some(ball.bearing()),
        BearingModel::Roller(roller) => Some(roller.bearing()),
        _ => None,
    }
}

/// The state of a bearing that the design says all about.
fn own_state(bearing: &Bearing) -> Result<Option<Rolling>, BearingError> {
    let Some(computed) = of_design(bearing) else { return Ok(None) };
    let computed = computed?;
    let state = match mean_state(bearing).ok_or(BearingError::NoMeanState)? {
        MeanState::FromTorque(_) => return Ok(None),
        MeanState::Displacement(d) => {
            let q = frames::to_bearing(&Vector6::new(d.x, d.y, d.z, d.rx, 0.0, d.rz));
            equilibrium(&computed, &Vector::zeros(), &std::array::from_fn(|i| Some(q[i])))?
        }
        MeanState::Preload(load) => {
            let load = frames::to_bearing(&Vector6::new(load.x, load.y, load.z, 0.0, 0.0, 0.0));
            equilibrium(&computed, &load, &[None, None, None, Some(0.0), Some(0.0)])?
        }
    };
    Ok(Some(Rolling { bearing: computed, state }))
}

/// The mean mesh force F = |T| / |arm of the pinion|, as it acts on this rotor: +F h on the gear, -F h on the pinion.
fn mean_mesh_load(design: &Design, side: Side) -> Option<Vector6<f64>> {
    const TURNING: usize = 4;
    let torque = design.operating?.pinion_torque?;
    let force = (torque / mesh_vector(design.mesh.vectors(Side::Pinion))[TURNING]).abs();
    let load = mesh_vector(design.mesh.vectors(side)) * (-signed(side) * force);
    load.iter().all(|entry| entry.is_finite()).then_some(load)
}
