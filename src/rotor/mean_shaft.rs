//! Static equilibrium of one shaft on bearings whose stiffness depends on their loads, under the mean mesh force.
//!
//! Five coordinates a station: torsion is balanced by the drive (or whatever turns the shaft) and moves no bearing. The beams and all
//! bearings of given stiffness are linear, so they are condensed exactly to the mesh station and the stations of the others. Kc and Khb belong
//! to the dynamics and are left out. The energy is convex; [`minimise`] finds its minimum.

use nalgebra::{Cholesky, DMatrix, DVector, Vector6};

use super::assembly::{ShaftMatrices, check_supported};
use super::mean_states::{mean_state, of_design};
use super::{BearingError, Rolling, RotorError, Stations, Supports};
use crate::bearing::{self, Bearing, EquilibriumError, Failure, Matrix, Potential, Vector, frames, minimise};
use crate::design::{MeanState, RotorDesign};

const TURNING: usize = 4;

/// The bearings whose state follows from the load, each by its place in the design. `given` is the stiffness of the other ball and roller
/// bearings; `load` acts at the mesh station.
pub fn solve(
    rotor: &RotorDesign,
    stations: &Stations,
    load: &Vector6<f64>,
    given: impl Fn(usize) -> Option<Matrix>,
) -> Result<Vec<(usize, Rolling)>, RotorError> {
    let springs = springs(rotor)?;
    check_held(rotor, stations, load, &springs, &given)?;
    let shaft = LoadedShaft::new(rotor, stations, load, springs, given)?;
    let size = shaft.load.amax().max(shaft.gradient(&DVector::zeros(shaft.load.len()), 1.0).amax());
    let name = |spring: &Spring| rotor.bearings[spring.place].name.clone();
    let open = |spring: &Spring| {
        let error = BearingError::Equilibrium(EquilibriumError::NoContact);
        RotorError::Bearing { name: name(spring), error }
    };
    if size == 0.0 {
        return Err(shaft.springs.first().map_or(RotorError::NoConvergence { residual: 0.0 }, open));
    }
    let deflection = |s: &Spring| s.bearing.typical_deflection(size) + s.bearing.clearance() + s.mounting.abs();
    let trust = 10.0 * shaft.springs.iter().map(deflection).fold(0.0, f64::max);
    let q = minimise(&shaft, shaft.load.len(), size, trust).map_err(|failure| match failure {
        Failure::Stalled { residual } => RotorError::NoConvergence { residual },
        Failure::RanAway(q) => {
            let far = |s: &&Spring| shaft.travel(s, &q);
            let furthest = shaft.springs.iter().max_by(|a, b| far(a).total_cmp(&far(b)));
            // a load that is too large moves a ring the way in which its bearing resists, or any way without contact angles
            let resists = |spring: &Spring| {
                let ring = shaft.ring(spring, &q);
                ring[2] * spring.bearing.contact_angle() > 0.0 && spring.bearing.state(&ring).loaded() > 0
            };
            let is_radial = shaft.springs.iter().all(|spring| spring.bearing.contact_angle() == 0.0);
            let (name, load) = (furthest.map(name).unwrap_or_default(), (*load).into());
            if is_radial || shaft.springs.iter().any(resists) {
                RotorError::MovesTooFar { name, load }
            } else {
                RotorError::GivesWay { name, load }
            }
        }
    })?;
    let solved = |spring: &Spring| {
        let state = spring.bearing.state(&shaft.ring(spring, &q));
        if state.loaded() == 0 {
            Err(open(spring))
        } else {
            Ok((spring.place, Rolling { bearing: spring.bearing, state }))
        }
    };
    shaft.springs.iter().map(solved).collect()
}

/// A bearing whose state is looked for.
struct Spring {
    place: usize,
    bearing: Bearing,
    /// Axial approach at assembly in the bearing's own loaded direction, m
    mounting: f64,
    /// Where its five displacements are among the coordinates; nothing where a rigid bearing at the same station holds one
    rows: [Option<usize>; 5],
}

fn springs(rotor: &RotorDesign) -> Result<Vec<Spring>, RotorError> {
    let mut springs = Vec::new();
    for (place, bearing) in rotor.bearings.iter().enumerate() {
        let Some(MeanState::FromTorque(mounting)) = mean_state(bearing) else { continue };
        let Some(computed) = of_design(bearing) else { continue };
        let named = |error: bearing::BadInput| RotorError::Bearing { name: bearing.name.clone(), error: error.into() };
        let computed = computed.map_err(named)?;
        let angle = computed.contact_angle();
        let direction = if angle == 0.0 { 0.0 } else { angle.signum() };
        springs.push(Spring { place, bearing: computed, mounting: direction * mounting, rows: [None; 5] });
    }
    Ok(springs)
}

/// Fails where a motion stays free even with every rolling element in contact.
fn check_held(
    rotor: &RotorDesign,
    stations: &Stations,
    load: &Vector6<f64>,
    springs: &[Spring],
    given: &impl Fn(usize) -> Option<Matrix>,
) -> Result<(), RotorError> {
    let full = |place: usize| {
        let spring = springs.iter().find(|spring| spring.place == place)?;
        let deflection = spring.bearing.typical_deflection(load.fixed_rows::<3>(0).norm().max(1.0));
        Some(spring.bearing.full_contact(deflection))
    };
    let supports = Supports::of_mean_state(rotor, |place| full(place).or_else(|| given(place)));
    check_supported(stations, &supports).map_err(|error| match error {
        RotorError::Unsupported(motions) => RotorError::Singular(motions),
        other => other,
    })
}

/// The condensed shaft. Rotations count as displacements at `radius`, so that all coordinates weigh alike.
struct LoadedShaft {
    stiffness: DMatrix<f64>,
    load: DVector<f64>,
    springs: Vec<Spring>,
    radius: f64,
}

impl LoadedShaft {
    fn new(
        rotor: &RotorDesign,
        stations: &Stations,
        load: &Vector6<f64>,
        mut springs: Vec<Spring>,
        given: impl Fn(usize) -> Option<Matrix>,
    ) -> Result<Self, RotorError> {
        let shaft = ShaftMatrices::new(rotor, stations, &Supports::of_mean_state(rotor, given));
        let is_kept =
            |station: usize| station == stations.mesh || springs.iter().any(|s| stations.bearings[s.place] == station);
        let moves = |i: &usize| shaft.free[*i] && i % 6 != TURNING;
        let (kept, condensed): (Vec<usize>, Vec<usize>) =
            (0..shaft.free.len()).filter(moves).partition(|i| is_kept(i / 6));
        let radius = springs.iter().map(|spring| spring.bearing.radius()).fold(0.0, f64::max);
        let scale = |i: usize| if i % 6 < 3 { 1.0 } else { 1.0 / radius };
        let block = |rows: &[usize], columns: &[usize]| {
            DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
                scale(rows[i]) * shaft.stiffness[(rows[i], columns[j])] * scale(columns[j])
            })
        };
        let stiffness = condense(block(&kept, &kept), &block(&condensed, &kept), block(&condensed, &condensed))?;
        let mut loads = DVector::zeros(kept.len());
        for (row, &i) in kept.iter().enumerate().filter(|(_, i)| *i / 6 == stations.mesh) {
            loads[row] = load[i % 6] * scale(i);
        }
        for spring in &mut springs {
            let station = stations.bearings[spring.place];
            spring.rows = frames::PLACES.map(|place| kept.binary_search(&(6 * station + place)).ok());
        }
        Ok(Self { stiffness, load: loads, springs, radius })
    }

    fn scale(&self, i: usize) -> f64 {
        if i < 3 { 1.0 } else { self.radius }
    }

    /// Displacement of a bearing's inner ring.
    fn ring(&self, spring: &Spring, q: &DVector<f64>) -> Vector {
        let mut ring = Vector::from_fn(|i, _| spring.rows[i].map_or(0.0, |row| q[row] / self.scale(i)));
        ring[2] += spring.mounting;
        ring
    }

    /// How far a ring has moved, over its radius.
    fn travel(&self, spring: &Spring, q: &DVector<f64>) -> f64 {
        self.ring(spring, q).fixed_rows::<3>(0).amax() / spring.bearing.radius()
    }
}

/// K_rr - K_rc K_cc^-1 K_cr.
fn condense(kept: DMatrix<f64>, across: &DMatrix<f64>, condensed: DMatrix<f64>) -> Result<DMatrix<f64>, RotorError> {
    if !kept.iter().chain(across.iter()).chain(condensed.iter()).all(|entry| entry.is_finite()) {
        return Err(RotorError::NotFinite("stiffness of the shaft in its mean state"));
    }
    if condensed.nrows() == 0 {
        return Ok(kept);
    }
    let factor =
        Cholesky::new(condensed).ok_or(RotorError::IllConditioned("stiffness of the shaft in its mean state"))?;
    let condensed = kept - across.tr_mul(&factor.solve(across));
    Ok((&condensed + condensed.transpose()) / 2.0)
}

impl Potential for LoadedShaft {
    fn energy(&self, q: &DVector<f64>, load_factor: f64) -> f64 {
        let springs = self.springs.iter().map(|spring| spring.bearing.energy(&self.ring(spring, q)));
        q.dot(&(&self.stiffness * q)) / 2.0 + springs.sum::<f64>() - load_factor * self.load.dot(q)
    }

    fn gradient(&self, q: &DVector<f64>, load_factor: f64) -> DVector<f64> {
        let mut gradient = &self.stiffness * q - &self.load * load_factor;
        for spring in &self.springs {
            let load = spring.bearing.load(&self.ring(spring, q).into());
            for (i, row) in spring.rows.iter().enumerate() {
                if let Some(row) = *row {
                    gradient[row] += load[i] / self.scale(i);
                }
            }
        }
        gradient
    }

    fn hessian(&self, q: &DVector<f64>) -> DMatrix<f64> {
        let mut hessian = self.stiffness.clone();
        for spring in &self.springs {
            let stiffness = spring.bearing.stiffness(&self.ring(spring, q));
            for (i, row) in spring.rows.iter().enumerate() {
                for (j, column) in spring.rows.iter().enumerate() {
                    if let (Some(row), Some(column)) = (*row, *column) {
                        hessian[(row, column)] += stiffness[(i, j)] / (self.scale(i) * self.scale(j));
                    }
                }
            }
        }
        hessian
    }

    fn has_run_away(&self, q: &DVector<f64>) -> bool {
        self.springs.iter().any(|spring| self.travel(spring, q) > 0.25)
    }
}
