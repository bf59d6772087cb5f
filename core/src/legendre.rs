//! Orthonormal Legendre polynomials p_n = √(n + ½) P_n: ∫₋₁¹ p_m p_n dx = δ_mn, p_n(1) > 0.
//!
//! Values at single points come from the recurrence of differences anchored at the nearer end,
//!
//! ```text
//! y = 1 − |x|,  R₀ = 1,  D₀ = 0,  D_{k+1} = (k D_k − (2k + 1) y R_k)/(k + 1),  R_{k+1} = R_k + D_{k+1},
//! ```
//!
//! where R_k = P_k(|x|). It is exact at the ends, where the three-term recurrence loses n² ulp; for n ≤ 32
//! the error is a few ε of the local size √(p_n² + p_{n−1}²). Tiles use the three-term recurrence
//!
//! ```text
//! p_{k+1} = a_k x p_k − c_k p_{k−1},   a_k = √((2k + 1)(2k + 3))/(k + 1),   c_k = k/(k + 1) · √((2k + 3)/(2k − 1)),
//! ```
//!
//! or, where points lie near ±1, the differences in lanes.
//!
//! Reference: NIST Digital Library of Mathematical Functions, 18.9.1; the differences as in module `jacobi`.

use crate::jacobi::{Polynomials, Weight};
use crate::math;
use crate::recurrence::{Differences, Recurrence, Step};

mod derivative;
mod mass;
mod two_scale;

pub use self::derivative::derivative;
pub use self::mass::mass;
pub use self::two_scale::{Half, two_scale};

/// √(n + ½) = p_n(1) for the degrees in common use.
const ENDS: [f64; 64] = {
    let mut ends = [0.0; 64];
    let mut n = 0;
    while n < ends.len() {
        ends[n] = math::const_sqrt(n as f64 + 0.5);
        n += 1;
    }
    ends
};

/// p_n(1) = √(n + ½), the factor between P_n and p_n, and 1/‖P_n‖.
#[inline]
pub fn end(n: usize) -> f64 {
    if n < ENDS.len() { ENDS[n] } else { math::sqrt(n as f64 + 0.5) }
}

/// Writes p_0(x) … p_{m−1}(x), m = `out.len()`, for x ∈ [−1, 1].
pub fn orthonormal(x: f64, out: &mut [f64]) {
    let turn = if x < 0.0 { -1.0 } else { 1.0 };
    let (mut walk, mut sign) = (Differences::new(1.0 - x.abs()), 1.0);
    for (k, p) in out.iter_mut().enumerate() {
        *p = sign * (end(k) * walk.value());
        walk.advance(step(k));
        sign *= turn;
    }
}

/// Writes p_n(x) and p_n′(x), n = 0 … m − 1, for x ∈ [−1, 1].
///
/// # Panics
/// If the slices differ in length.
pub fn orthonormal_with_derivatives(x: f64, out: &mut [f64], slopes: &mut [f64]) {
    assert_eq!(out.len(), slopes.len(), "one derivative per value");
    let turn = if x < 0.0 { -1.0 } else { 1.0 };
    let (mut walk, mut sign) = (Differences::new(1.0 - x.abs()), 1.0);
    for (k, (p, d)) in out.iter_mut().zip(slopes).enumerate() {
        (*p, *d) = (sign * (end(k) * walk.value()), -sign * turn * (end(k) * walk.slope()));
        walk.advance_with_slope(step(k));
        sign *= turn;
    }
}

/// κ_k = 1/(k + 1) and σ_k = (2k + 1)/(k + 1).
#[inline(always)]
const fn step(k: usize) -> Step {
    let next = (k + 1) as f64;
    Step { keep: 1.0, kappa: 1.0 / next, sigma: (2 * k + 1) as f64 / next }
}

/// Σ f_n p_n(x) for x ∈ [−1, 1] by Clenshaw's recurrence; 0 for no coefficients.
pub fn sum(f: &[f64], x: f64) -> f64 {
    // b_n = f_n √(n + ½) + (2n + 1)/(n + 1) x b_{n+1} − (n + 1)/(n + 2) b_{n+2} for the classical P_n.
    let (mut above, mut last) = (0.0, 0.0);
    for (n, coefficient) in f.iter().enumerate().rev() {
        let (a, back) = (step(n).sigma, 1.0 - step(n + 1).kappa);
        (above, last) = (last, coefficient * end(n) + (a * x * last - back * above));
    }
    last
}

/// The first N Legendre polynomials in tables made by the compiler, for tiles.
pub struct Table<const N: usize>;

impl<const N: usize> Table<N> {
    /// The polynomials with anchored values, derivatives and end values.
    pub const POLYNOMIALS: Polynomials<N> = Polynomials::new(Weight::LEGENDRE);

    /// The three-term recurrence.
    pub const RECURRENCE: Recurrence<N> = *Self::POLYNOMIALS.recurrence();
}

/// `out[n][l]` = `p_n(x[l])`; W = 8 or 16 lanes, x ∈ [−1, 1].
#[inline]
pub fn tile<const N: usize, const W: usize>(x: &[f64; W], out: &mut [[f64; W]; N]) {
    const { &Table::<N>::RECURRENCE }.tile(x, out);
}

/// `out[n][l]` = `p_n(x[l])` and `slopes[n][l]` = `p_n′(x[l])`.
#[inline]
pub fn tile_with_derivatives<const N: usize, const W: usize>(
    x: &[f64; W],
    out: &mut [[f64; W]; N],
    slopes: &mut [[f64; W]; N],
) {
    const { &Table::<N>::RECURRENCE }.tile_with_derivatives(x, out, slopes);
}

/// Σ f_n `p_n(x[l])` at every lane, by Clenshaw's recurrence.
#[inline]
pub fn sum_tile<const N: usize, const W: usize>(f: &[f64; N], x: &[f64; W]) -> [f64; W] {
    const { &Table::<N>::RECURRENCE }.sum_tile(f, x)
}

/// `out[n][l]` = `p_n(x[l])`, anchored at the ends: twice the cost of [`tile`], exact at ±1 and near-exact
/// around them.
#[inline]
pub fn tile_anchored<const N: usize, const W: usize>(x: &[f64; W], out: &mut [[f64; W]; N]) {
    let (y, turn) = (x.map(|x| 1.0 - x.abs()), x.map(|x| 1.0f64.copysign(x)));
    let (mut value, mut difference) = ([1.0; W], [0.0; W]);
    for (k, row) in out.iter_mut().enumerate() {
        let Step { kappa, sigma, .. } = step(k);
        let end = end(k);
        for l in 0..W {
            row[l] = end * value[l];
            if k % 2 == 1 {
                row[l] *= turn[l];
            }
            difference[l] -= kappa * difference[l] + sigma * y[l] * value[l];
            value[l] += difference[l];
        }
    }
}
