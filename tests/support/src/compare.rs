//! Distances between numbers.

use radiosity::Solution;

/// The largest |xₖ|, 0 of none.
pub fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, x| largest.max(x.abs()))
}

/// The largest |xₖ − yₖ| of two lists of one length.
#[track_caller]
pub fn farthest(found: &[f64], exact: &[f64]) -> f64 {
    assert_eq!(found.len(), exact.len());
    found.iter().zip(exact).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

/// ‖x − y‖ / ‖y‖ of two lists of one length.
#[track_caller]
pub fn distance(found: &[f64], exact: &[f64]) -> f64 {
    assert_eq!(found.len(), exact.len());
    let squares: f64 = found.iter().zip(exact).map(|(x, y)| (x - y).powi(2)).sum();
    (squares / exact.iter().map(|y| y * y).sum::<f64>()).sqrt()
}

/// The largest [`distance`] of the coefficients of irradiance in any band of two solutions on the same
/// elements.
#[track_caller]
pub fn apart(found: &Solution, exact: &Solution) -> f64 {
    let bands = found.bands().iter().zip(exact.bands());
    bands.map(|(x, y)| distance(&x.coefficients.irradiance, &y.coefficients.irradiance)).fold(0.0, f64::max)
}

/// Asserts |x − y| ≤ accuracy · |y|.
#[track_caller]
pub fn assert_close(found: f64, exact: f64, accuracy: f64) {
    let error = (found - exact).abs();
    assert!(error <= accuracy * exact.abs(), "{found} instead of {exact}: {:.1e}", error / exact.abs());
}
