//! The stiffness matrix of a bearing: symmetric, positive semidefinite, nothing about the shaft's own axis.

use nalgebra::{Matrix6, SymmetricEigen};

use super::Checker;
use crate::design::key_path::KeyPath;

const NAMES: [&str; 6] = ["x", "y", "z", "thx", "thy", "thz"];
const THY: usize = 4;

/// How far apart mirrored entries may be, relative to the largest entry.
const SYMMETRY: f64 = 1e-6;

/// How far below zero an eigenvalue of the scaled matrix may be: entries are written with few digits.
const SEMIDEFINITE: f64 = 1e-6;

/// Checks the matrix and makes it exactly symmetric.
pub(super) fn check(matrix: &mut [[f64; 6]; 6], path: &KeyPath, checker: &Checker<'_>) {
    if matrix.iter().flatten().any(|entry| entry.is_nan()) {
        return;
    }
    let thy_free = (0..6).all(|i| matrix[THY][i] == 0.0 && matrix[i][THY] == 0.0);
    if !thy_free {
        let message = "row and column thy, the fifth, must be zero: a bearing lets the shaft turn";
        checker.error(path, message, None);
    }
    let largest = matrix.iter().flatten().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
    let mut symmetric = true;
    for (i, j) in (0..6).flat_map(|i| (0..i).map(move |j| (i, j))) {
        let (lower, upper) = (matrix[i][j], matrix[j][i]);
        // divided first: the difference of two finite numbers may overflow
        if (lower / largest - upper / largest).abs() > SYMMETRY {
            symmetric = false;
            let message = format!(
                "must be symmetric: row {}, column {} is {lower:e}, and row {}, column {} is {upper:e}",
                NAMES[i], NAMES[j], NAMES[j], NAMES[i]
            );
            checker.error(&path.place(i).place(j), message, None);
        }
        let mean = lower / 2.0 + upper / 2.0;
        (matrix[i][j], matrix[j][i]) = (mean, mean);
    }
    if symmetric && thy_free && largest > 0.0 && !is_semidefinite(matrix) {
        let message = "must be positive semidefinite: some displacement would be pushed on, not back";
        checker.error(path, message, None);
    }
}

/// After scaling to a unit diagonal, so that N/m and N m/rad count alike.
fn is_semidefinite(matrix: &[[f64; 6]; 6]) -> bool {
    let root: [f64; 6] = std::array::from_fn(|i| matrix[i][i].sqrt());
    let mut scaled = Matrix6::zeros();
    for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
        let entry = matrix[i][j];
        if entry == 0.0 {
            continue;
        }
        let value = entry / root[i] / root[j];
        // not a number, or infinite, where a diagonal entry is negative or zero
        if value.is_nan() || value.abs() > 1.0 + SEMIDEFINITE {
            return false;
        }
        scaled[(i, j)] = value;
    }
    SymmetricEigen::new(scaled).eigenvalues.min() >= -SEMIDEFINITE
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with_block(xx: f64, yy: f64, xy: f64) -> [[f64; 6]; 6] {
        let mut matrix = [[0.0; 6]; 6];
        (matrix[0][0], matrix[1][1], matrix[0][1], matrix[1][0]) = (xx, yy, xy, xy);
        matrix
    }

    // A 2x2 block is positive semidefinite exactly if both diagonal entries and the determinant are not negative.
    #[test]
    fn a_block_is_judged_by_its_determinant() {
        assert!(is_semidefinite(&with_block(4e8, 1e8, 2e8)));
        assert!(is_semidefinite(&with_block(4e8, 1e8, -1.9e8)));
        assert!(!is_semidefinite(&with_block(4e8, 1e8, 2.01e8)));
        assert!(!is_semidefinite(&with_block(4e8, 0.0, 1.0)));
        assert!(!is_semidefinite(&with_block(4e8, -1.0, 0.0)));
    }

    #[test]
    fn no_size_of_numbers_is_too_large_or_too_small() {
        assert!(is_semidefinite(&with_block(1e308, 1e308, 1e308)));
        assert!(is_semidefinite(&with_block(5e-324, 1e308, 0.0)));
        assert!(!is_semidefinite(&with_block(5e-324, 1e-300, 1e308)));
    }

    // Three axes, pairwise correlation -0.6: eigenvalues of the scaled block are 1.6, 1.6 and 1 - 2 * 0.6 = -0.2.
    #[test]
    fn every_pair_may_be_right_and_the_whole_wrong() {
        let mut matrix = [[0.0; 6]; 6];
        for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
            matrix[i][j] = if i == j { 1e8 } else { -0.6e8 };
        }
        assert!(!is_semidefinite(&matrix));
    }
}
