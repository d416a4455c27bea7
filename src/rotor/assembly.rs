//! Stiffness and mass of one shaft, assembled from its elements, bodies and bearings.

use nalgebra::{DMatrix, Matrix5, SMatrix};

use super::{Motion, RotorError, Stations, Supports, beam};
use crate::design::RotorDesign;

/// K and M of one shaft with its bearings and bodies, without drive and mesh; six coordinates a station.
#[derive(Debug, Clone)]
pub struct ShaftMatrices {
    pub stiffness: DMatrix<f64>,
    pub mass: DMatrix<f64>,
    /// Whether the coordinate is free; held ones stay in the matrices.
    pub free: Vec<bool>,
}

impl ShaftMatrices {
    pub fn new(rotor: &RotorDesign, stations: &Stations, supports: &Supports) -> Self {
        let n = 6 * stations.count();
        let mut stiffness = DMatrix::zeros(n, n);
        let mut mass = DMatrix::zeros(n, n);
        for (i, section) in stations.sections.iter().enumerate() {
            let length = stations.piece_length(i);
            let mut block = stiffness.fixed_view_mut::<12, 12>(6 * i, 6 * i);
            block += beam::stiffness(section, length);
            let mut block = mass.fixed_view_mut::<12, 12>(6 * i, 6 * i);
            block += beam::mass(section, length);
        }
        for (body, &station) in rotor.bodies.iter().zip(&stations.bodies) {
            let own =
                [body.mass, body.mass, body.mass, body.diametral_inertia, body.polar_inertia, body.diametral_inertia];
            for (motion, value) in own.into_iter().enumerate() {
                mass[(6 * station + motion, 6 * station + motion)] += value;
            }
        }
        supports.add_to(&mut stiffness, &stations.bearings);
        let mut free = vec![true; n];
        for (bearing, &station) in stations.bearings.iter().enumerate() {
            for translation in 0..3 {
                if supports.holds(bearing, translation) {
                    free[6 * station + translation] = false;
                }
            }
        }
        Self { stiffness, mass, free }
    }
}

/// Fails, naming the motion, when the bearings leave the shaft a rigid motion other than its rotation.
///
/// Looks at the supports' stiffness against the five rigid motions, scaled by the shaft's length: factorising the whole
/// shaft would not notice, since rounding turns a zero into a small number of either sign.
pub fn check_supported(stations: &Stations, supports: &Supports) -> Result<(), RotorError> {
    const UNSUPPORTED: f64 = 1e-14;
    const MOTIONS: [Motion; 5] = [Motion::X, Motion::Y, Motion::Z, Motion::ThX, Motion::ThZ];
    let n = 6 * stations.count();
    let mut ground = DMatrix::zeros(n, n);
    supports.add_to(&mut ground, &stations.bearings);
    let ends = (stations.positions[0], stations.positions[stations.count() - 1]);
    let (middle, length) = (f64::midpoint(ends.0, ends.1), ends.1 - ends.0);
    let rigid = |station: usize| {
        // translations, then tilts times the length: dx/dy = -thz, dz/dy = +thx
        let arm = (stations.positions[station] - middle) / length;
        let mut shape = SMatrix::<f64, 6, 5>::zeros();
        for translation in 0..3 {
            shape[(translation, translation)] = 1.0;
        }
        shape[(3, 3)] = 1.0 / length;
        shape[(2, 3)] = arm;
        shape[(5, 4)] = 1.0 / length;
        shape[(0, 4)] = -arm;
        shape
    };
    let mut shapes = DMatrix::zeros(n, 5);
    for &station in &stations.bearings {
        shapes.fixed_view_mut::<6, 5>(6 * station, 0).copy_from(&rigid(station));
    }
    let mut support: Matrix5<f64> = (shapes.transpose() * &ground * &shapes).fixed_view::<5, 5>(0, 0).into();
    // a held translation is a spring as stiff as the stiffest thing around
    let section = &stations.sections[0];
    let hold = support.diagonal().max().max(section.axial_stiffness / length);
    for (bearing, &station) in stations.bearings.iter().enumerate() {
        for translation in (0..3).filter(|&t| supports.holds(bearing, t)) {
            let row = shapes.fixed_view::<1, 5>(6 * station + translation, 0).into_owned();
            support += hold * row.transpose() * row;
        }
    }
    if !support.iter().all(|entry| entry.is_finite()) {
        return Err(RotorError::NotFinite("bearing stiffness"));
    }
    let eigen = support.symmetric_eigen();
    let threshold = UNSUPPORTED * eigen.eigenvalues.max();
    let mut freedom = [0.0; 5];
    for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
        if *value <= threshold {
            for (share, entry) in freedom.iter_mut().zip(vector.iter()) {
                *share += entry * entry;
            }
        }
    }
    let most = freedom.iter().copied().fold(0.0, f64::max);
    if most == 0.0 {
        return Ok(());
    }
    let named = |share: f64| share > 0.5 || share == most;
    let motions = MOTIONS.into_iter().zip(freedom).filter(|(_, share)| named(*share)).map(|(motion, _)| motion);
    Err(RotorError::Unsupported(motions.collect()))
}
