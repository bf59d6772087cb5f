//! Interpolation through nested Chebyshev points.
//!
//! ```text
//! x_k = cos(π k / n) ,   k = 0 … n ,
//! p(x) = Σ_k w_k f_k/(x − x_k) / Σ_k w_k/(x − x_k) ,   w_k = (−1)^k, halved at both ends
//! ```
//!
//! The points of n intervals are among those of 2 n. An analytic function is met to ρ^−n, ρ the sum of the
//! half axes of the ellipse with the foci ±1 in which it is analytic. (J.-P. Berrut, L. N. Trefethen,
//! *Barycentric Lagrange interpolation*, SIAM Rev. 46 (2004), 501–517. doi:10.1137/S0036144502417715)

use std::f64::consts::PI;

/// Point number `k` of `intervals` + 1 in [−1, 1], ascending; exactly symmetric.
pub(super) fn point(k: usize, intervals: usize) -> f64 {
    let (k, n) = (k as f64, intervals as f64);
    // −cos(π k/n), by the sine of the distance from the middle.
    (PI * (2.0 * k - n) / (2.0 * n)).sin()
}

/// The factors of the values at the points of `intervals` in the interpolant at `x` in [−1, 1]; their sum is
/// 1.
pub(super) fn factors(intervals: usize, x: f64) -> Vec<f64> {
    let points: Vec<f64> = (0..=intervals).map(|k| point(k, intervals)).collect();
    if let Some(met) = points.iter().position(|point| *point == x) {
        return (0..=intervals).map(|k| if k == met { 1.0 } else { 0.0 }).collect();
    }
    let part = |(k, point): (usize, &f64)| {
        let half = if k == 0 || k == intervals { 0.5 } else { 1.0 };
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        half * sign / (x - point)
    };
    let parts: Vec<f64> = points.iter().enumerate().map(part).collect();
    let sum: f64 = parts.iter().sum();
    parts.into_iter().map(|part| part / sum).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_nested() {
        for intervals in [2, 4, 8, 16] {
            for k in 0..=intervals {
                assert!((point(k, intervals) - point(2 * k, 2 * intervals)).abs() < 1e-16);
            }
            assert_eq!([point(0, intervals), point(intervals, intervals)], [-1.0, 1.0]);
        }
    }

    #[test]
    fn polynomials_are_met() {
        for intervals in [1, 2, 4, 8, 16] {
            for x in [-1.0, -0.7, 0.0, 0.1, 0.99] {
                for power in 0..=intervals as i32 {
                    let sum: f64 = factors(intervals, x)
                        .iter()
                        .enumerate()
                        .map(|(k, factor)| factor * point(k, intervals).powi(power))
                        .sum();
                    assert!((sum - x.powi(power)).abs() < 1e-14, "{intervals} {x} {power}");
                }
            }
        }
    }

    #[test]
    fn analytic_functions_are_met_as_fast_as_their_ellipse_says() {
        // 1/(1 + 4 x²) has its poles at ±i/2: ρ = (1 + √5)/2.
        let runge = |x: f64| 1.0 / (1.0 + 4.0 * x * x);
        let error = |intervals: usize| {
            let at = |x: f64| {
                let values = factors(intervals, x).into_iter().enumerate();
                values.map(|(k, factor)| factor * runge(point(k, intervals))).sum::<f64>() - runge(x)
            };
            (0..1000).map(|k| at(-1.0 + 0.002 * f64::from(k)).abs()).fold(0.0, f64::max)
        };
        let rate = (error(16) / error(32)).powf(1.0 / 16.0);
        assert!((rate - 0.5 * (1.0 + 5f64.sqrt())).abs() < 0.02, "{rate}");
    }
}
