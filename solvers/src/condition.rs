//! ‖A⁻¹‖₁ from a few solves.
//!
//! ‖A⁻¹‖₁ = max ‖A⁻¹ x‖₁ over ‖x‖₁ ≤ 1 is sought by steepest ascent: with y = A⁻¹ x and z = A⁻ᵀ sign(y), z is
//! a subgradient at x, and the next x is the unit vector of its largest entry; it ends when |z_j| ≤ zᵀx.
//! Besides, the vector x_i = (−1)ⁱ (1 + i/(n−1)) gives 2 ‖A⁻¹x‖₁ / 3n, which catches what cancellation hides.
//! The result is a lower bound, seldom wrong by more than 3. Reference: N. J. Higham, *ACM TOMS* 14 (1988)
//! 381-396.

use crate::factors::Factors;
use crate::vector::dot;

/// Most steps of the ascent, as in LAPACK's `dlacn2`; two are usual.
const STEPS: usize = 5;

/// Lower bound of ‖A⁻¹‖₁ for a matrix of dimension `dim`; infinite if the factors are singular.
pub(crate) fn inverse_norm(factors: &dyn Factors, dim: usize) -> f64 {
    if dim == 0 {
        return 0.0;
    }
    let bound = ascend(factors, dim).max(alternate(factors, dim));
    if bound.is_nan() { f64::INFINITY } else { bound }
}

/// The bound from the ascent.
fn ascend(factors: &dyn Factors, dim: usize) -> f64 {
    let mut x = vec![1.0 / dim as f64; dim];
    let mut bound: f64 = 0.0;
    for _ in 0..STEPS {
        let mut y = x.clone();
        factors.solve(&mut y);
        let size = one_norm(&y);
        if size <= bound {
            return bound;
        }
        bound = size;
        let mut z: Vec<f64> = y.iter().map(|y| 1f64.copysign(*y)).collect();
        factors.solve_transposed(&mut z);
        let Some(j) = (0..dim).max_by(|i, j| z[*i].abs().total_cmp(&z[*j].abs())) else { return bound };
        if z[j].abs() <= dot(&z, &x) {
            return bound;
        }
        x.fill(0.0);
        x[j] = 1.0;
    }
    bound
}

/// The bound from the vector of alternating signs.
fn alternate(factors: &dyn Factors, dim: usize) -> f64 {
    let last = dim.saturating_sub(1).max(1) as f64;
    let sign = |i: usize| if i.is_multiple_of(2) { 1.0 } else { -1.0 };
    let mut x: Vec<f64> = (0..dim).map(|i| sign(i) * (1.0 + i as f64 / last)).collect();
    factors.solve(&mut x);
    2.0 * one_norm(&x) / (3.0 * dim.max(1) as f64)
}

/// ‖x‖₁.
fn one_norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x.abs()).sum()
}
