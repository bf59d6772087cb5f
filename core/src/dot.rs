//! Inner product and Euclidean norm of vectors.
//!
//! ```text
//! x · y = Σ_k x_k y_k ,      ‖x‖₂ = √(x · x) .
//! ```
//!
//! The order of summation depends on the length n alone, so that the result has the same bits whatever the
//! vector registers. With m = ⌊n/8⌋ the lanes s_l = Σ_{j < m} x_{8j+l} y_{8j+l} are summed from the first on
//! and added in halves, ((s₀ + s₄) + (s₂ + s₆)) + ((s₁ + s₅) + (s₃ + s₇)); then the products k ≥ 8m, summed
//! from the first on, are added. No product is rounded more than max(m + 4, 8) times, sums included, hence
//!
//! ```text
//! |error| ≤ γ Σ_k |x_k y_k| ,      γ = r u/(1 − r u) ,  r = max(m + 4, 8) ,  u = 2⁻⁵³ ,
//! ```
//!
//! where nothing overflows or underflows. Reference: N. J. Higham, *Accuracy and Stability of Numerical
//! Algorithms*, 2nd ed. (2002), section 3.1.

use crate::math::sqrt;

/// Partial sums: enough for the compiler to use vector registers.
const LANES: usize = 8;

/// Squares whose sum lies between these have neither overflowed nor lost digits below the normal numbers.
const SAFE_SQUARES: core::ops::Range<f64> = 1e-200..1e200;

/// x · y, in the order of the module's header; 0 of empty vectors.
///
/// ```
/// assert_eq!(radiosity_core::dot(&[1.0, 2.0, 3.0], &[4.0, -5.0, 6.0]), 12.0);
/// ```
///
/// # Panics
/// If the lengths differ.
#[inline]
pub fn dot(x: &[f64], y: &[f64]) -> f64 {
    assert!(x.len() == y.len(), "vectors of an inner product have the same length");
    let (x_lanes, x_rest) = x.as_chunks::<LANES>();
    let (y_lanes, y_rest) = y.as_chunks::<LANES>();
    let mut s = [0.0; LANES];
    for (x, y) in x_lanes.iter().zip(y_lanes) {
        for lane in 0..LANES {
            s[lane] += x[lane] * y[lane];
        }
    }
    let rest: f64 = x_rest.iter().zip(y_rest).map(|(x, y)| x * y).sum();
    (((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]))) + rest
}

/// ‖x‖₂, without overflow or underflow of the squares; NaN or infinite if an entry is.
///
/// ```
/// assert_eq!(radiosity_core::norm(&[3e300, -4e300]), 5e300);
/// ```
#[inline]
pub fn norm(x: &[f64]) -> f64 {
    let squares = dot(x, x);
    if SAFE_SQUARES.contains(&squares) { sqrt(squares) } else { scaled_norm(x, squares) }
}

/// ‖x‖₂ of entries divided by the largest, for squares whose plain sum is not safe.
#[cold]
fn scaled_norm(x: &[f64], squares: f64) -> f64 {
    let largest = x.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    if squares.is_nan() || largest == 0.0 || largest.is_infinite() {
        return squares;
    }
    let scaled = x.iter().map(|x| x / largest);
    largest * sqrt(scaled.map(|x| x * x).sum())
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use proptest::prelude::*;

    use super::*;
    use crate::double::Double;

    /// Integers below 2¹⁹: every sum of fewer than 2¹⁵ of their products is exact.
    fn integers(seed: u64, n: usize) -> Vec<i64> {
        (0..n as u64).map(|k| ((seed + 7919 * k) * (k + 104_729) % 1_048_573) as i64 - 524_286).collect()
    }

    #[test]
    fn every_product_counts_once() {
        for n in 0..=100 {
            let (x, y) = (integers(3, n), integers(5, n));
            let exact: i64 = x.iter().zip(&y).map(|(x, y)| x * y).sum();
            let [x, y] = [x, y].map(|all| all.iter().map(|k| *k as f64).collect::<Vec<f64>>());
            assert_eq!(dot(&x, &y), exact as f64, "{n}");
        }
    }

    /// 2⁵³ swallows each 1 that is added to it alone; it is cancelled in its lane, or in the first halving of
    /// the lanes, before any 1 is added.
    #[test]
    fn lanes_are_summed_apart_and_in_halves() {
        const HUGE: f64 = 9_007_199_254_740_992.0;
        let ones = [1.0; 19];
        let mut x = ones;
        (x[0], x[8]) = (HUGE, -HUGE);
        assert_eq!(dot(&x, &ones), 17.0, "in one lane");
        for lane in 0..4 {
            let mut x = [1.0; 11];
            (x[lane], x[lane + 4]) = (HUGE, -HUGE);
            assert_eq!(dot(&x, &ones[..11]), 9.0, "in the lanes {lane} and {}", lane + 4);
        }
        let mut x = ones;
        (x[3], x[7], x[11], x[15]) = (HUGE, -HUGE, 0.0, 0.0);
        assert_eq!(dot(&x, &ones), 15.0);
        // From the first on 3 + 2⁵³ is rounded to 2⁵³ + 4, and three of the ones are swallowed.
        assert_eq!(ones.iter().zip(&x).map(|(x, y)| x * y).sum::<f64>(), 13.0);
    }

    #[test]
    #[should_panic(expected = "same length")]
    fn different_lengths_are_refused() {
        let _ = dot(&[1.0; 9], &[1.0; 8]);
    }

    proptest! {
        #[test]
        fn the_error_is_within_its_bound(
            pairs in prop::collection::vec((-1.0..1.0f64, -1.0..1.0f64), 0..200),
            scale in -60i32..60,
        ) {
            let x: Vec<f64> = pairs.iter().enumerate().map(|(k, (x, _))| x * 2f64.powi(scale * (k as i32 % 2))).collect();
            let y: Vec<f64> = pairs.iter().map(|(_, y)| *y).collect();
            let products = x.iter().zip(&y).map(|(x, y)| Double::product(*x, *y));
            let exact = products.fold(Double::new(0.0), |sum, product| sum.add(product));
            let magnitude: f64 = x.iter().zip(&y).map(|(x, y)| (x * y).abs()).sum();
            let roundings = (pairs.len() / 8 + 4).max(8) as f64;
            let error = (dot(&x, &y) - exact.hi) - exact.lo;
            prop_assert!(error.abs() <= 1.001 * roundings * 0.5 * f64::EPSILON * magnitude, "{error:e} {magnitude}");
        }

        #[test]
        fn norms_scale_with_the_vector(
            entries in prop::collection::vec(-1.0..1.0f64, 1..40),
            power in -900i32..900,
        ) {
            let scaled: Vec<f64> = entries.iter().map(|x| x * 2f64.powi(power)).collect();
            let (all, once) = (norm(&scaled) * 2f64.powi(-power), norm(&entries));
            prop_assert!((all - once).abs() <= 1e-14 * once, "{all} {once}");
        }
    }

    #[test]
    fn norms_neither_overflow_nor_underflow() {
        for scale in [1e-300, 1e-170, 1.0, 1e170, 1e300] {
            assert!((norm(&[3.0 * scale, -4.0 * scale]) / (5.0 * scale) - 1.0).abs() < 1e-15, "{scale}");
        }
        assert_eq!(norm(&[]), 0.0);
        assert_eq!(norm(&[0.0, -0.0]), 0.0);
        assert_eq!(norm(&[1.0, f64::NEG_INFINITY]), f64::INFINITY);
        assert!(norm(&[1.0, f64::NAN, 2.0]).is_nan());
    }
}
