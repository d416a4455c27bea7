//! Eigenvalues of a diagonal matrix plus one spring: diag(lambda) + k g g^T.
//!
//! The mesh couples the two rotors by a single spring, so that the modes with mesh follow from the modes without it: each new eigenvalue
//! lies between two old ones, at a root of 1 + k sum g_r^2/(lambda_r - x) = 0 (Golub 1973). Every root is kept as an offset from its
//! nearest old eigenvalue, which keeps all its digits.

/// One eigenvalue of the sum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Eigenvalue {
    /// The old pair with this index is untouched by the spring.
    Kept(usize),
    /// `lambda[origin] + offset`
    Moved { origin: usize, offset: f64 },
}

impl Eigenvalue {
    pub fn value(self, lambda: &[f64]) -> f64 {
        match self {
            Self::Kept(i) => lambda[i],
            Self::Moved { origin, offset } => lambda[origin] + offset,
        }
    }
}

/// All eigenvalues, ascending. `lambda` is ascending with distinct values wherever `g` is not zero; `k` > 0.
pub fn eigenvalues(lambda: &[f64], g: &[f64], k: f64) -> Vec<Eigenvalue> {
    let active: Vec<usize> = (0..lambda.len()).filter(|&i| g[i] != 0.0).collect();
    let mut out: Vec<Eigenvalue> = (0..lambda.len()).filter(|&i| g[i] == 0.0).map(Eigenvalue::Kept).collect();
    let weight: Vec<f64> = active.iter().map(|&i| k * g[i] * g[i]).collect();
    let total: f64 = weight.iter().sum();
    for (position, &i) in active.iter().enumerate() {
        let next = active.get(position + 1);
        let gap = next.map_or(total, |&j| lambda[j] - lambda[i]);
        // 1 + sum weight/(lambda - x), with x = lambda[origin] + offset
        let secular = |origin: usize, offset: f64| {
            let terms = active.iter().zip(&weight).map(|(&r, w)| w / ((lambda[r] - lambda[origin]) - offset));
            1.0 + terms.sum::<f64>()
        };
        // rising from -infinity to +infinity across the gap: the sign in the middle tells which end is nearer
        let from_left = next.is_none() || secular(i, 0.5 * gap) >= 0.0;
        let origin = if from_left { i } else { next.copied().unwrap_or(i) };
        let sign = if from_left { 1.0 } else { -1.0 };
        let above = |distance: f64| sign * secular(origin, sign * distance) >= 0.0;
        let farthest = if next.is_none() { gap } else { 0.5 * gap };
        out.push(Eigenvalue::Moved { origin, offset: sign * bisect(above, farthest) });
    }
    out.sort_by(|a, b| a.value(lambda).total_cmp(&b.value(lambda)));
    out
}

/// Smallest distance in (0, farthest] at which `above` holds, to the last digit; halves the exponent first, then the interval.
fn bisect(above: impl Fn(f64) -> bool, farthest: f64) -> f64 {
    let (mut low, mut high) = (farthest * 1e-40, farthest);
    while high > 2.0 * low {
        let middle = low.sqrt() * high.sqrt();
        if above(middle) { high = middle } else { low = middle }
    }
    loop {
        let middle = f64::midpoint(low, high);
        if middle <= low || middle >= high {
            return high;
        }
        if above(middle) { high = middle } else { low = middle }
    }
}

#[cfg(test)]
mod tests {
    use super::eigenvalues;
    use nalgebra::{DMatrix, DVector};

    /// The whole matrix by nalgebra's dense solver, which shares no code with the secular equation.
    #[test]
    fn agrees_with_a_dense_eigensolver() {
        let lambda = [0.0, 1.0, 2.5, 7.0, 7.5, 40.0];
        let g = [0.3, -1.0, 0.0, 2.0, 1e-3, 0.7];
        let k = 3.0;
        let g_vector = DVector::from_row_slice(&g);
        let spring: DMatrix<f64> = &g_vector * g_vector.transpose() * k;
        let dense = DMatrix::from_diagonal(&DVector::from_row_slice(&lambda)) + spring;
        let mut expected: Vec<f64> = dense.symmetric_eigenvalues().iter().copied().collect();
        expected.sort_by(f64::total_cmp);
        let found = eigenvalues(&lambda, &g, k);
        for (found, expected) in found.iter().zip(expected) {
            assert!((found.value(&lambda) - expected).abs() < 1e-12 * 50.0, "{found:?} {expected}");
        }
    }

    /// Two free shafts on one spring: lambda = 0 stays once, the other is k (g1^2 + g2^2).
    #[test]
    fn two_free_masses_keep_one_zero() {
        let g = [0.0, 5.0_f64.hypot(12.0)];
        let found = eigenvalues(&[0.0, 0.0], &g, 2.0);
        assert!(found[0].value(&[0.0, 0.0]) == 0.0);
        assert!((found[1].value(&[0.0, 0.0]) - 338.0).abs() < 1e-12 * 338.0);
    }
}
