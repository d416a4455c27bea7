//! Eigenvalues of a symmetric tridiagonal matrix, with a word after each: the longest part of a large rotor's modes.

use std::ops::ControlFlow;

use nalgebra::DMatrix;

/// Diagonalises T in Q T Q^T by implicit QR steps with Wilkinson's shift (Golub and Van Loan, "Matrix Computations", algorithm 8.3.3).
///
/// `diagonal` (n) becomes the eigenvalues in no particular order, `below` (n - 1) is used up, and the columns of `vectors` turn from Q
/// into the eigenvectors. `found` hears how many eigenvalues are still wanted whenever one is there.
///
/// # Errors
///
/// [`QrError::Ended`] where `found` breaks.
pub fn diagonalise(
    diagonal: &mut [f64],
    below: &mut [f64],
    vectors: &mut DMatrix<f64>,
    found: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Result<(), QrError> {
    /// Two a value is usual.
    const SWEEPS_A_VALUE: usize = 30;
    let mut sweeps_left = SWEEPS_A_VALUE * diagonal.len();
    let mut last = diagonal.len().saturating_sub(1);
    while last > 0 {
        let is_split = |i: usize| below[i].abs() <= f64::EPSILON * (diagonal[i].abs() + diagonal[i + 1].abs());
        if is_split(last - 1) {
            last -= 1;
            if found(last).is_break() {
                return Err(QrError::Ended);
            }
            continue;
        }
        let first = (1..last).rev().find(|&i| is_split(i - 1)).unwrap_or(0);
        sweeps_left = sweeps_left.checked_sub(1).ok_or(QrError::NotConverged)?;
        sweep(diagonal, below, vectors, first, last);
    }
    Ok(())
}

/// Why there are no eigenvalues.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum QrError {
    NotConverged,
    Ended,
}

/// One implicit QR step on the rows `first ..= last`, which nothing joins to the others.
fn sweep(diagonal: &mut [f64], below: &mut [f64], vectors: &mut DMatrix<f64>, first: usize, last: usize) {
    let half = 0.5 * (diagonal[last - 1] - diagonal[last]);
    let corner = below[last - 1];
    let shift = diagonal[last] - corner * (corner / (half + half.hypot(corner).copysign(half)));
    let (mut x, mut bulge) = (diagonal[first] - shift, below[first]);
    for k in first..last {
        let length = x.hypot(bulge);
        let (cosine, sine) = if length > 0.0 { (x / length, bulge / length) } else { (1.0, 0.0) };
        if k > first {
            below[k - 1] = length;
        }
        let (a, b, d) = (diagonal[k], below[k], diagonal[k + 1]);
        let (cc, cs, ss) = (cosine * cosine, cosine * sine, sine * sine);
        diagonal[k] = cc * a + 2.0 * cs * b + ss * d;
        diagonal[k + 1] = ss * a - 2.0 * cs * b + cc * d;
        below[k] = cs * (d - a) + (cc - ss) * b;
        if k + 1 < last {
            x = below[k];
            bulge = sine * below[k + 1];
            below[k + 1] *= cosine;
        }
        rotate(vectors, k, cosine, sine);
    }
}

/// Columns k and k + 1 become c q_k + s q_(k+1) and c q_(k+1) - s q_k.
fn rotate(vectors: &mut DMatrix<f64>, k: usize, cosine: f64, sine: f64) {
    let rows = vectors.nrows();
    let (left, right) = vectors.as_mut_slice()[k * rows..(k + 2) * rows].split_at_mut(rows);
    for (p, q) in left.iter_mut().zip(right) {
        (*p, *q) = (cosine * *p + sine * *q, cosine * *q - sine * *p);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::DVector;
    use std::f64::consts::PI;

    /// -1, 2, -1 on n points: lambda = 2 - 2 cos(k pi / (n + 1)), a chain of masses and springs in every textbook.
    #[test]
    fn a_chain_of_masses_has_its_closed_form_and_each_value_is_told() {
        let n = 40;
        let (mut diagonal, mut below) = (vec![2.0; n], vec![-1.0; n - 1]);
        let mut vectors = DMatrix::identity(n, n);
        let mut told = Vec::new();
        let heard = &mut |wanted| {
            told.push(wanted);
            ControlFlow::Continue(())
        };
        assert_eq!(diagonalise(&mut diagonal, &mut below, &mut vectors, heard), Ok(()));
        assert_eq!(told, (0..n - 1).rev().collect::<Vec<_>>());
        let chain = |i: usize, j: usize| match i.abs_diff(j) {
            0 => 2.0,
            1 => -1.0,
            _ => 0.0,
        };
        let matrix = DMatrix::from_fn(n, n, chain);
        let values = DVector::from_column_slice(&diagonal);
        assert!((&matrix * &vectors - &vectors * DMatrix::from_diagonal(&values)).amax() < 1e-14 * 10.0);
        assert!((vectors.tr_mul(&vectors) - DMatrix::identity(n, n)).amax() < 1e-14 * 10.0);
        diagonal.sort_by(f64::total_cmp);
        for (k, value) in diagonal.iter().enumerate() {
            let expected = 2.0 - 2.0 * ((k + 1) as f64 * PI / (n + 1) as f64).cos();
            assert!((value - expected).abs() < 1e-14 * 4.0, "{value} {expected}");
        }
    }

    #[test]
    fn a_break_ends_it_at_once() {
        let (mut diagonal, mut below) = (vec![2.0; 9], vec![-1.0; 8]);
        let mut told = 0;
        let heard = &mut |_| {
            told += 1;
            ControlFlow::Break(())
        };
        let ended = diagonalise(&mut diagonal, &mut below, &mut DMatrix::identity(9, 9), heard);
        assert_eq!((ended, told), (Err(QrError::Ended), 1));
    }

    #[test]
    fn zeros_and_single_values_are_no_trouble() {
        let heard = &mut |_| ControlFlow::Continue(());
        for n in [0, 1, 5] {
            let (mut diagonal, mut below) = (vec![0.0; n], vec![0.0; n.saturating_sub(1)]);
            assert_eq!(diagonalise(&mut diagonal, &mut below, &mut DMatrix::identity(n, n), heard), Ok(()));
        }
        // one coupling alone: eigenvalues +1 and -1
        let (mut diagonal, mut below) = (vec![0.0; 2], vec![1.0]);
        assert_eq!(diagonalise(&mut diagonal, &mut below, &mut DMatrix::identity(2, 2), heard), Ok(()));
        assert!((diagonal[0] * diagonal[1] + 1.0).abs() < 1e-15 * 4.0, "{diagonal:?}");
    }
}
