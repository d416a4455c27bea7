//! What the rotors of a solved design say of their bearings.

use std::sync::Arc;

use nalgebra::Vector6;

use crate::bearing::frames;
use crate::design::Side;
use crate::model::Rotors;
use crate::number::without_rounding;
use crate::rotor::{Rolling, Support};

/// About the radius of a ring, m: holds tilts against displacements.
const RING: f64 = 0.01;

/// All bearings of a solved design.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingStates([SideStates; 2]);

/// The bearings of one rotor, in the design's order.
#[derive(Debug, Clone, PartialEq)]
pub struct SideStates {
    pub supports: Vec<Support>,
    /// Mean states; nothing for bearings whose stiffness is given. Shared with the solution that they were taken over from
    pub rolling: Arc<[Option<Rolling>]>,
}

impl BearingStates {
    pub fn of(rotors: &Rotors) -> Self {
        Self(Side::BOTH.map(|side| {
            let rotor = rotors.get(side);
            SideStates { supports: rotor.supports.bearings.clone(), rolling: Arc::clone(&rotor.mean_states.bearings) }
        }))
    }

    pub fn side(&self, side: Side) -> &SideStates {
        &self.0[side as usize]
    }
}

/// Mean load of a bearing on its inner ring; order x, y, z, thx, thy, thz, N and N m.
pub fn load(rolling: &Rolling) -> Vector6<f64> {
    let load = frames::to_station(&rolling.state.load);
    let largest = resultant(&load).max(rolling.state.greatest_load());
    // moments: at an arm of a metre
    load.map(|value| without_rounding(value, largest))
}

/// Mean displacement of the inner ring in the same order; m and rad.
pub fn displacement(rolling: &Rolling) -> Vector6<f64> {
    let moved = frames::to_station(&rolling.state.displacement);
    let (across, about) = (moved.fixed_rows::<3>(0).norm(), moved.fixed_rows::<3>(3).norm());
    let largest = across.max(about * RING);
    Vector6::from_fn(|i, _| without_rounding(moved[i], if i < 3 { largest } else { largest / RING }))
}

/// Size of the force of a load, N.
pub fn resultant(load: &Vector6<f64>) -> f64 {
    load.fixed_rows::<3>(0).norm()
}
