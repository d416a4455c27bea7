//! Modes of a lumped model and of the finite element model, paired by their shapes.

use nalgebra::{DMatrix, DVector};

use crate::model::{Model, RotorModel};
use crate::response::Modes;
use crate::rotor::Motion;

/// A lumped mode and the finite element mode whose shape it has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModePair {
    /// Index among the lumped modes
    pub lumped: usize,
    /// Index among the finite element modes
    pub fe: usize,
    /// Modal assurance criterion, 0 to 1
    pub mac: f64,
}

/// Modes with a smaller MAC are no pair.
pub const LEAST_MAC: f64 = 0.5;

/// Pairs modes one to one, greatest MAC first, at least [`LEAST_MAC`]. Many finite element modes look alike at the mesh (all axial ones of a shaft, say), so of
/// MACs that are equal but for rounding the nearest in frequency comes first.
///
/// Shapes are compared at the lumped coordinates, each weighted with the square root of its mass in the enhanced model, since metres and radians
/// must not mix unweighted.
pub fn pair_modes(lumped: (&Model, &Modes), fe: (&Model, &Modes), enhanced: &Model) -> Vec<ModePair> {
    const EQUAL: f64 = 1e-6;
    let mac = mac_matrix(lumped, fe, enhanced);
    let mut candidates: Vec<ModePair> = Vec::new();
    for i in 0..mac.nrows() {
        for j in 0..mac.ncols() {
            if mac[(i, j)] >= LEAST_MAC {
                candidates.push(ModePair { lumped: i, fe: j, mac: mac[(i, j)] });
            }
        }
    }
    let octaves = |pair: &ModePair| {
        let ratio = lumped.1.0[pair.lumped].frequency_hz / fe.1.0[pair.fe].frequency_hz;
        // the rigid rotation, at zero in both, is nearest to itself
        if ratio.is_nan() { 0.0 } else { ratio.log2().abs() }
    };
    let steps = |pair: &ModePair| (pair.mac / EQUAL).round();
    candidates.sort_by(|a, b| steps(b).total_cmp(&steps(a)).then(octaves(a).total_cmp(&octaves(b))));
    let (mut lumped_taken, mut fe_taken) = (vec![false; mac.nrows()], vec![false; mac.ncols()]);
    candidates.retain(|pair| {
        let free = !lumped_taken[pair.lumped] && !fe_taken[pair.fe];
        if free {
            lumped_taken[pair.lumped] = true;
            fe_taken[pair.fe] = true;
        }
        free
    });
    candidates.sort_by_key(|pair| pair.lumped);
    candidates
}

/// Modal assurance criterion of every lumped mode (row) with every finite element mode (column), at the lumped coordinates, weighted as
/// in [`pair_modes`]; 0 where one of them does not move there.
pub fn mac_matrix(lumped: (&Model, &Modes), fe: (&Model, &Modes), enhanced: &Model) -> DMatrix<f64> {
    let weights: Vec<f64> = enhanced.rotors().iter().flat_map(|rotor| weights(rotor)).collect();
    let shapes = |(model, modes): (&Model, &Modes)| -> Vec<DVector<f64>> {
        let places = lumped_places(model);
        let pick = |shape: &DVector<f64>| {
            let values = places.iter().zip(&weights).map(|(place, weight)| place.map_or(0.0, |i| shape[i]) * weight);
            DVector::from_iterator(weights.len(), values)
        };
        modes.0.iter().map(|mode| pick(&mode.shape)).collect()
    };
    let (lumped, fe) = (shapes(lumped), shapes(fe));
    let mac = |a: &DVector<f64>, b: &DVector<f64>| {
        let (a_size, b_size) = (a.norm(), b.norm());
        // what hardly moves there has no shape but that of rounding errors; 1 is all of a lumped mode
        if a_size.min(b_size) < 1e-9 { 0.0 } else { (a.dot(b) / (a_size * b_size)).powi(2) }
    };
    DMatrix::from_fn(lumped.len(), fe.len(), |i, j| mac(&lumped[i], &fe[j]))
}

/// Square roots of the masses at the mesh station's six coordinates and the drive.
fn weights(rotor: &RotorModel) -> Vec<f64> {
    rotor.mass.diagonal().iter().map(|mass| mass.sqrt()).collect()
}

/// Where the lumped coordinates stand among those of a model: the mesh station's six, then the drive if any, for both rotors.
fn lumped_places(model: &Model) -> Vec<Option<usize>> {
    let mut places = Vec::new();
    let mut at = 0;
    for rotor in model.rotors() {
        let own = Motion::ALL.into_iter().map(|motion| rotor.at_mesh(motion)).chain(rotor.drive().map(Some));
        places.extend(own.map(|place| place.map(|i| at + i)));
        at += rotor.coordinates.len();
    }
    places
}
