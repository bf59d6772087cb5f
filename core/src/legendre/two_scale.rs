//! Parent and child: the Legendre basis of an interval in the bases of its halves.
//!
//! On the half around ±½, x = (t ± 1)/2 with t ∈ [−1, 1]:
//!
//!   p_n((t ± 1)/2) = Σ_{m ≤ n} H[n][m] p_m(t)
//!
//! Push (parent to child): b_child[m] = Σ_n H[n][m] b[n]. Pull (child to parent): b[n] = ½ Σ_halves Σ_m
//! H[n][m] b_child[m]. On a square the matrices multiply, and the ½ becomes ¼. Since the basis is
//! orthonormal, H₊ H₊ᵀ + H₋ H₋ᵀ = 2 I, and H₋[n][m] = (−1)^{n+m} H₊[n][m].
//!
//! In the classical polynomials the rows follow from the three-term recurrence; multiplication by t is
//! t P_m = ((m + 1) P_{m+1} + m P_{m−1})/(2m + 1):
//!
//!   (n + 1) row_{n+1} = (2n + 1) (t · row_n ± row_n)/2 − n row_{n−1}
//!
//! in double-double, rounded once.

use crate::double::Double;

/// A half of [−1, 1].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Half {
    /// [−1, 0].
    Left,
    /// [0, 1].
    Right,
}

/// H with p_n(x(t)) = Σ_m `H[n][m]` p_m(t) on a half; lower triangular.
pub const fn two_scale<const N: usize>(half: Half) -> [[f64; N]; N] {
    let centre = match half {
        Half::Left => -1.0,
        Half::Right => 1.0,
    };
    let mut matrix = [[0.0; N]; N];
    let (mut before, mut row) = ([Double::ZERO; N], [Double::ZERO; N]);
    let mut n = 0;
    while n < N {
        if n == 0 {
            row[0] = Double::ONE;
        } else {
            (before, row) = (row, next(n - 1, centre, &row, &before));
        }
        let mut m = 0;
        while m <= n {
            let norm = Double::ratio((2 * n + 1) as f64, (2 * m + 1) as f64).sqrt();
            matrix[n][m] = row[m].mul(norm).hi;
            m += 1;
        }
        n += 1;
    }
    matrix
}

/// The classical row n + 1 from the rows n and n − 1.
const fn next<const N: usize>(n: usize, centre: f64, row: &[Double; N], before: &[Double; N]) -> [Double; N] {
    let mut out = [Double::ZERO; N];
    let mut m = 0;
    while m <= n + 1 {
        let mut sum = row[m].scale(centre);
        if m > 0 {
            sum = sum.add(row[m - 1].mul(Double::ratio(m as f64, (2 * m - 1) as f64)));
        }
        if m + 1 < N {
            sum = sum.add(row[m + 1].mul(Double::ratio((m + 1) as f64, (2 * m + 3) as f64)));
        }
        let forward = sum.scale(0.5).mul(Double::new((2 * n + 1) as f64));
        let back = before[m].mul(Double::new(n as f64));
        out[m] = forward.sub(back).div(Double::new((n + 1) as f64));
        m += 1;
    }
    out
}
