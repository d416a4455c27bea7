//! How many natural frequencies of a plane lie below a given one (Wittrick and Williams 1971).

use nalgebra::{Matrix2, Vector2};

use super::plane::{Node, Plane};
use super::transfer::Piece;

/// Number of natural frequencies of the plane below `omega` (rad/s).
///
/// Negative pivots of the exact dynamic stiffness, eliminated from left to right. Pieces are cut short enough to have no natural
/// frequency of their own below `omega` when clamped, so that no further term enters the count. `None` where numbers overflow.
pub fn natural_frequencies_below(plane: &Plane, omega: f64) -> Option<usize> {
    let omega_squared = omega * omega;
    let mut count = 0;
    let mut pivot = node_stiffness(&plane.nodes[0], omega_squared);
    let mut held = plane.nodes[0].held;
    for (piece, node) in plane.pieces.iter().zip(&plane.nodes[1..]) {
        let parts = piece.parts_without_own_modes(omega_squared);
        let stiffness = DynamicStiffness::new(piece, omega_squared, piece.length / parts as f64);
        for part in 1..=parts {
            let end = part == parts;
            let next_held = end && node.held;
            let mut next = stiffness.right;
            if end {
                next += node_stiffness(node, omega_squared);
            }
            let mut cross = stiffness.cross;
            hold(&mut pivot, held, &mut cross, next_held, stiffness.left);
            count += negative_eigenvalues(&pivot);
            if let Some(inverse) = pivot.try_inverse() {
                next -= cross.transpose() * inverse * cross;
            }
            pivot = next;
            held = next_held;
        }
    }
    let mut cross = Matrix2::zeros();
    hold(&mut pivot, held, &mut cross, false, Matrix2::zeros());
    let count = count + negative_eigenvalues(&pivot);
    pivot.iter().all(|entry| entry.is_finite()).then_some(count)
}

/// Completes a node's pivot with the piece to its right, and takes held deflections out of it.
fn hold(pivot: &mut Matrix2<f64>, held: bool, cross: &mut Matrix2<f64>, next_held: bool, left: Matrix2<f64>) {
    *pivot += left;
    if held {
        // one uncoupled positive pivot counts nothing
        *pivot = Matrix2::from_diagonal(&Vector2::new(1.0, pivot[(1, 1)]));
        cross.row_mut(0).fill(0.0);
    }
    if next_held {
        cross.column_mut(0).fill(0.0);
    }
}

fn negative_eigenvalues(pivot: &Matrix2<f64>) -> usize {
    let determinant = pivot[(0, 0)] * pivot[(1, 1)] - pivot[(0, 1)] * pivot[(1, 0)];
    if determinant < 0.0 {
        1
    } else if pivot[(0, 0)] + pivot[(1, 1)] < 0.0 {
        2
    } else {
        0
    }
}

/// Springs and inertia forces of a node on (z, phi).
fn node_stiffness(node: &Node, omega_squared: f64) -> Matrix2<f64> {
    Matrix2::new(node.tt - omega_squared * node.mass, node.tr, node.tr, node.rr - omega_squared * node.inertia)
}

/// End forces (F_z, F_phi) of a piece for its end displacements (z, phi).
struct DynamicStiffness {
    left: Matrix2<f64>,
    right: Matrix2<f64>,
    /// Left force for right displacement
    cross: Matrix2<f64>,
}

impl DynamicStiffness {
    /// From the transfer matrix: (u2, q2) = [A B; C D] (u1, q1) with q = (Mb, Q).
    ///
    /// On the left end F = (Q, -Mb), on the right end F = (-Q, Mb).
    fn new(piece: &Piece, omega_squared: f64, length: f64) -> Self {
        let transfer = piece.transfer(omega_squared, length);
        let a: Matrix2<f64> = transfer.fixed_view::<2, 2>(0, 0).into();
        let b: Matrix2<f64> = transfer.fixed_view::<2, 2>(0, 2).into();
        let d: Matrix2<f64> = transfer.fixed_view::<2, 2>(2, 2).into();
        let inverse = b.try_inverse().unwrap_or_else(Matrix2::zeros);
        let force = Matrix2::new(0.0, 1.0, -1.0, 0.0);
        Self { left: -(force * inverse * a), right: -(force * d * inverse), cross: force * inverse }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Uniform beam of unit length, stiffness and mass with nodes at the given places.
    fn beam(places: &[(f64, Node)]) -> Plane {
        let pieces = places.windows(2).map(|pair| Piece {
            length: pair[1].0 - pair[0].0,
            bending_stiffness: 1.0,
            shear_flexibility: 0.0,
            mass: 1.0,
            rotary_inertia: 0.0,
        });
        Plane {
            pieces: pieces.collect(),
            nodes: places.iter().map(|place| place.1).collect(),
            mesh: 0,
            unit_length: 1.0,
            unit_stiffness: 1.0,
        }
    }

    fn held() -> Node {
        Node { held: true, ..Node::default() }
    }

    fn body(mass: f64, inertia: f64) -> Node {
        Node { mass, inertia, ..Node::default() }
    }

    /// The count steps by one at each root x = k d, to the digits given.
    #[track_caller]
    fn assert_roots(plane: &Plane, roots: &[f64]) {
        for (below, root) in roots.iter().enumerate() {
            let count = |x: f64| natural_frequencies_below(plane, x * x);
            assert_eq!([count(root - 5.1e-7), count(root + 5.1e-7)], [Some(below), Some(below + 1)], "at {root}");
        }
    }

    /// First two roots of the overhung beam of Fig. 7 in Hua et al. (2012): body at a, supports at b and c, ends at 0 and 1. From two
    /// independent programs.
    #[test]
    fn first_two_roots_of_the_overhung_beam() {
        let free = Node::default();
        let rows = [
            (vec![(0.0, free), (0.5, held()), (1.0, held())], [3.011_831, 6.826_201]),
            (vec![(0.0, body(0.5, 0.01)), (0.3, held()), (1.0, held())], [2.558_542, 5.020_321]),
            (vec![(0.0, body(2.0, 0.05)), (0.3, held()), (0.9, held()), (1.0, free)], [1.888_960, 4.097_913]),
            (
                vec![(0.0, free), (0.05, body(0.5, 0.005)), (0.3, held()), (0.9, held()), (1.0, free)],
                [2.917_225, 5.876_424],
            ),
        ];
        for (places, roots) in rows {
            assert_roots(&beam(&places), &roots);
        }
    }

    /// n pi for simple supports at both ends (Timoshenko, Young and Weaver 1974), up to where pieces must be cut many times.
    #[test]
    fn pinned_beam() {
        let plane = beam(&[(0.0, held()), (0.37, Node::default()), (1.0, held())]);
        let roots: Vec<f64> = (1..=12).map(|n| f64::from(n) * std::f64::consts::PI).collect();
        assert_roots(&plane, &roots);
    }

    /// Bounce and pitch of a nearly rigid bar meet: the count steps by two.
    #[test]
    fn double_root_counts_twice() {
        let spring = Node { tt: 1e-4, ..Node::default() };
        // bounce 2k/m, pitch 2k/4/(1/12): with m = 1 the body's inertia must be 1/4 - 1/12
        let plane = beam(&[(0.0, spring), (0.5, body(0.0, 1.0 / 4.0 - 1.0 / 12.0)), (1.0, spring)]);
        let omega = 2e-4_f64.sqrt();
        assert_eq!(natural_frequencies_below(&plane, 0.999 * omega), Some(0));
        assert_eq!(natural_frequencies_below(&plane, 1.001 * omega), Some(2));
    }
}
