//! The number of Gauss points that the area element of a curved cell needs.
//!
//! On the cell's chart the area element has the Legendre expansion
//!
//! ```text
//! A(s, t) = Σ c_mn q_m(s) q_n(t) ,   q_n(x) = √(2n + 1) P_n(2x − 1) ,   ∫₀¹ q_m q_n dx = δ_mn .
//! ```
//!
//! Where |c_mn| is below the rounding of the whole area for all m > M, A counts as a polynomial of degree M
//! in s, and a Gauss rule of d + M/2 + 1 points is exact for A times products of two polynomials of degree d.
//! The degree is 0 for a cylinder, 1 towards the apex of a cone, about 30 for a quarter of a sphere. A cell
//! whose coefficients do not fall off within 64 samples per direction is unresolved.

use radiosity_core::legendre;

use super::columns::add_scaled;
use super::patch::{Direction, Patch};
use super::rule::{MOST_POINTS, UnitRule};

/// The spectrum of an area element, from samples.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spectrum {
    /// Degrees of the area element along s and t, if resolved.
    pub degrees: [usize; 2],
    /// Largest coefficients in the last quarter of the degrees sampled along s and t; zero where resolved.
    pub tails: [f64; 2],
}

impl Spectrum {
    /// The spectrum for `patch`; coefficients up to `tolerance` (scene length²) count as rounding.
    pub(crate) fn of(patch: &Patch, tolerance: f64) -> Self {
        let mut samples = 16;
        loop {
            let largest = largest_coefficients(patch, samples);
            let resolved = samples * 3 / 4;
            let tail = |c: &Vec<f64>| c[resolved..].iter().copied().fold(0.0, f64::max);
            let tails = [0, 1].map(|k| tail(&largest[k])).map(|t| if t > tolerance { t } else { 0.0 });
            if tails == [0.0; 2] || samples == MOST_POINTS {
                let degree = |c: &Vec<f64>| c[..resolved].iter().rposition(|c| *c > tolerance).unwrap_or(0);
                return Self { degrees: [degree(&largest[0]), degree(&largest[1])], tails };
            }
            samples *= 2;
        }
    }

    /// Whether the coefficients fall off in both directions.
    pub(crate) fn is_resolved(&self) -> bool {
        self.tails == [0.0; 2]
    }

    /// The larger of the tails.
    pub(crate) fn tail(&self) -> f64 {
        self.tails[0].max(self.tails[1])
    }

    /// The direction with the larger tail.
    pub(crate) fn worse(&self) -> Direction {
        if self.tails[0] >= self.tails[1] { Direction::Along } else { Direction::Across }
    }
}

/// For each degree m along s, max_n |c_mn|, and for each degree n along t, max_m |c_mn|.
fn largest_coefficients(patch: &Patch, samples: usize) -> [Vec<f64>; 2] {
    let rule = UnitRule::of(samples);
    // w_a q_m(x_a), a row per point.
    let weighted: Vec<Vec<f64>> = rule.iter().map(|(x, w)| weighted_values(samples, x, w)).collect();
    let mut coefficients = vec![0.0; samples * samples];
    for (s, left) in rule.nodes.iter().zip(&weighted) {
        let mut row = vec![0.0; samples];
        for (t, right) in rule.nodes.iter().zip(&weighted) {
            add_scaled(&mut row, patch.node(*s, *t).area, right);
        }
        for (out, factor) in coefficients.chunks_exact_mut(samples).zip(left) {
            add_scaled(out, *factor, &row);
        }
    }
    let mut largest = [vec![0.0f64; samples], vec![0.0f64; samples]];
    for (k, c) in coefficients.iter().enumerate() {
        let (m, n) = (k / samples, k % samples);
        largest[0][m] = largest[0][m].max(c.abs());
        largest[1][n] = largest[1][n].max(c.abs());
    }
    largest
}

fn weighted_values(count: usize, x: f64, weight: f64) -> Vec<f64> {
    let mut values = vec![0.0; count];
    legendre::orthonormal(2.0 * x - 1.0, &mut values);
    values.iter_mut().for_each(|value| *value *= weight * std::f64::consts::SQRT_2);
    values
}
