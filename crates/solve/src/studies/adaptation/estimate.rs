//! Error estimate of a run, from light gathered at points.
//!
//! The polynomials B_h of a run send light; its [gathered](crate::gather) irradiance at a point x is
//!
//! ```text
//! E_g(x) = D(x) + ∫ κ(x, y) V(x, y) ρ(y) (D(y) + S_h(y)) dA_y ,
//! ```
//!
//! D the direct light and S_h the polynomial of the rest. The error of polynomials is orthogonal to them: it
//! oscillates, and the integral removes nearly all of it, so that E₀ + ρ E_g is much nearer to B than B_h is.
//! Therefore
//!
//! ```text
//! ‖B − B_h‖² ≈ ∫ ρ² (E_g − E_h)² dA ≈ Σ_patches 1/n Σ_k (ρ (E_g − E_h))²(x_k) J(x_k) ,
//! ```
//!
//! at [points](super::sensor) x_k; J is the area element. ‖B − E₀‖² is the same sum of (ρ E_g)². Kinks,
//! shadow edges and corners count wherever they lie, as no rate of convergence is assumed; a detail between
//! the points is missed.
//!
//! An error of the transfers does not oscillate. E_g shows its first effect, but not its effect after further
//! reflections; and many blocks have such errors at random. A tenth of the largest is added as a sum of
//! squares: a guess, too small where nearly everything reflects nearly all.

use std::sync::atomic::{AtomicUsize, Ordering};

use radiosity_light::occluders::Site;
use radiosity_visibility::Visibility;
use radiosity_work::ranks::PartName;
use radiosity_work::{Stage, Work};

use super::error_estimate::{ErrorEstimate, error_estimate};
use super::sensor::{Point, Sensor, points};
use crate::driver::{Failure, Options, Outcome};
use crate::gather::Gather;
use crate::goal::{Aim, Goal};
use crate::solution::Solution;
use crate::solved::Solved;
use crate::tolerances::{LOOSEST_FOR_POLYNOMIALS, OF_ERROR, SHARPENING_OF_GATHERING};

/// Least accuracy of gathering, over the wanted error: below it the polynomials are good enough whatever it
/// is.
const OF_WANTED: f64 = 0.1;

/// Part of the transfers' error that reaches the radiosity unseen by E_g: a guess, see the header.
const TRANSFERRED: f64 = 0.1;

/// Estimated ‖B − B_h‖/‖B − E₀‖ of a run, all bands pooled, accurate enough to compare with the
/// goal; B_h are the polynomials, or E₀ + ρ E_g where gathered light is the goal
/// ([`error_estimate`](super::error_estimate)). Where rays carried the pairs, the error that they left.
///
/// # Errors
/// Threads that cannot be started.
pub(super) fn estimate(
    run: &Solved,
    goal: &Goal,
    expected: f64,
    work: &Work<'_>,
) -> Result<ErrorEstimate, Failure> {
    if let Some(sampling) = run.outcome.sampling {
        let error = sampling.error.unwrap_or(f64::INFINITY);
        return Ok(ErrorEstimate { error, shares: Vec::new() });
    }
    let (solution, visibility) = (&run.outcome.solution, run.visibility());
    if goal.of == Aim::Solution {
        let of_polynomials = || of_polynomials(solution, visibility, goal.accuracy, work);
        let error = run.options.in_threads(work.ranks, of_polynomials)?;
        let error = error.hypot(TRANSFERRED * missed(&run.outcome, &run.options));
        return Ok(ErrorEstimate { error, shares: Vec::new() });
    }
    run.options.in_threads(work.ranks, || {
        let sensors = Sensor::of(goal, solution, visibility);
        error_estimate(run, &sensors, expected, work)
    })
}

/// Error of the polynomials, by light gathered as accurately as it needs to be compared with `wanted`.
fn of_polynomials(solution: &Solution, visibility: &Visibility, wanted: f64, work: &Work<'_>) -> f64 {
    let mut eps = LOOSEST_FOR_POLYNOMIALS;
    let mut error = unresolved(solution, visibility, eps, work);
    while error > 0.0 && eps > OF_ERROR * error && eps > OF_WANTED * wanted {
        eps = (SHARPENING_OF_GATHERING * eps).max(OF_WANTED * wanted);
        error = unresolved(solution, visibility, eps, work);
    }
    error
}

/// Error of the polynomials, by light gathered to `eps`.
fn unresolved(solution: &Solution, visibility: &Visibility, eps: f64, work: &Work<'_>) -> f64 {
    let gather = Gather::new(solution, visibility, eps);
    let points = points(solution.elements().list());
    let done = AtomicUsize::new(0);
    let of = |element: usize| {
        let squares = squares(element, &points[element], solution, &gather);
        work.report_done(Stage::Estimate, done.fetch_add(1, Ordering::Relaxed) + 1, points.len());
        squares
    };
    let counts: Vec<f64> = points.iter().map(|own| own.len() as f64).collect();
    let squares = work.ranks.map(PartName::Missed, &counts, of);
    let [missed, size] = [0, 1].map(|k| squares.iter().map(|s| s[k]).sum::<f64>());
    if size > 0.0 { (missed / size).sqrt() } else { 0.0 }
}

/// ∫ (ρ² + τ²) (E_g − E_h)² dA and ∫ (ρ² + τ²) E_g² dA over an element, by its points.
fn squares(element: usize, points: &[Point], solution: &Solution, gather: &Gather) -> [f64; 2] {
    let weights: Vec<f64> = solution.bands().iter().map(|band| band.coating.squared(element)).collect();
    let mut sums = [0.0; 2];
    if weights.iter().all(|weight| *weight == 0.0) {
        return sums;
    }
    let occluders = gather.around(&Site::of(&solution.elements().list()[element]));
    for point in points {
        let gathered = gather.irradiance(&point.receiver_point(), &occluders);
        for (band, (weight, gathered)) in weights.iter().zip(gathered).enumerate() {
            let held = solution.irradiance(band, element, &point.place);
            let weight = point.area * weight;
            sums[0] += weight * (gathered - held).powi(2);
            sums[1] += weight * gathered.powi(2);
        }
    }
    sums
}

/// Largest relative error that a transfer may have.
fn missed(outcome: &Outcome, options: &Options) -> f64 {
    let accuracy = options.accuracy();
    let shadows = if outcome.pairs.partly_hidden > 0 { accuracy.shadow_eps } else { 0.0 };
    accuracy.eps.max(shadows).max(outcome.accuracy_reached)
}
