//! A rotor that bends in one of its two planes, on its own in-plane supports.

use nalgebra::Matrix6;

use super::transfer::Piece;
use super::{Stations, Supports};
use crate::design::RotorDesign;

/// A plane of bending.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BendingPlane {
    /// x-y: (x, thz), slope dx/dy = -thz
    X,
    /// y-z: (z, thx), slope dz/dy = +thx
    Z,
}

impl BendingPlane {
    /// (tt, tr, rr) of a station's 6x6 for the deflection and the slope in this plane.
    pub fn block(self, k: &Matrix6<f64>) -> [f64; 3] {
        match self {
            Self::X => [k[(0, 0)], -k[(0, 5)], k[(5, 5)]],
            Self::Z => [k[(2, 2)], k[(2, 3)], k[(3, 3)]],
        }
    }

    /// Indices of deflection and rotation among the six coordinates of a station.
    pub fn coordinates(self) -> [usize; 2] {
        match self {
            Self::X => [0, 5],
            Self::Z => [2, 3],
        }
    }
}

/// What sits at one place of the plane: a body, a support, both or nothing.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Node {
    pub mass: f64,
    /// Diametral inertia
    pub inertia: f64,
    /// The deflection is held
    pub held: bool,
    /// Spring on the deflection
    pub tt: f64,
    /// Coupling of deflection and slope
    pub tr: f64,
    /// Spring on the slope
    pub rr: f64,
}

/// A rotor in one plane, in units of its own: lengths over `unit_length`, stiffness over `unit_stiffness`, both ends free.
///
/// Frequencies stay in rad/s: masses carry s^2. Deflections keep their unit, slopes are per `unit_length`.
#[derive(Debug, Clone, PartialEq)]
pub struct Plane {
    pub pieces: Vec<Piece>,
    /// One more than pieces
    pub nodes: Vec<Node>,
    /// Node of the mesh station
    pub mesh: usize,
    /// m
    pub unit_length: f64,
    /// EI / L^3, N/m
    pub unit_stiffness: f64,
}

impl Plane {
    /// In-plane model after Kc and before Khb; couplings to the other plane and to the axial direction are left out.
    pub fn new(rotor: &RotorDesign, stations: &Stations, supports: &Supports, plane: BendingPlane) -> Self {
        let length = stations.positions[stations.count() - 1] - stations.positions[0];
        let bending = stations.sections.iter().map(|section| section.bending_stiffness).fold(0.0, f64::max);
        let pieces = stations.sections.iter().enumerate().map(|(i, section)| Piece {
            length: stations.piece_length(i) / length,
            bending_stiffness: section.bending_stiffness / bending,
            shear_flexibility: section.shear_flexibility * bending / length.powi(2),
            mass: section.mass * length.powi(4) / bending,
            rotary_inertia: section.rotary_inertia * length.powi(2) / bending,
        });
        let mut nodes = vec![Node::default(); stations.count()];
        for (body, &station) in rotor.bodies.iter().zip(&stations.bodies) {
            nodes[station].mass += body.mass * length.powi(3) / bending;
            nodes[station].inertia += body.diametral_inertia * length / bending;
        }
        for (support, &station) in supports.bearings.iter().zip(&stations.bearings) {
            let [tt, tr, rr] = plane.block(&support.stiffness);
            let node = &mut nodes[station];
            node.held |= support.held[plane.coordinates()[0]];
            node.tt += tt * length.powi(3) / bending;
            node.tr += tr * length.powi(2) / bending;
            node.rr += rr * length / bending;
        }
        Self {
            pieces: pieces.collect(),
            nodes,
            mesh: stations.mesh,
            unit_length: length,
            unit_stiffness: bending / length.powi(3),
        }
    }
}
