//! The roots of π_n by Laguerre's method with deflation, from both ends at once.
//!
//! For a polynomial whose m remaining roots are real, Laguerre's step from the right of all of them,
//!
//!   t ← t − m / (s₁ + √((m − 1)(m s₂ − s₁²))),
//!   s₁ = π′/π − Σ 1/(t − tᵢ),   s₂ = (π′/π)² − π″/π − Σ 1/(t − tᵢ)²   (sums over the roots found)
//!
//! descends monotonically to the largest: no root can be missed or found twice. π″ comes from the
//! differential equation (1 − t²) π″ = (d + (σ + 2) t) π′ − λπ, with d = α − β, σ = α + β, λ = n (n + σ + 1);
//! at t = 1 and at a root just found the limits of s₁ and s₂ are known too, so that the first step of each
//! search needs no recurrence. Two searches run side by side, one from each end; the left one sees the
//! mirrored polynomial (t = −x, d → −d). A search stops once a step is below 10⁻³ of the distance to the root
//! before (10⁻⁵ of that to the end): convergence is cubic, and the polish that follows is cubic again.
//!
//! Once the angles between roots are known well enough to extrapolate (module `trail`), Halley's step from
//! there replaces the search. It is taken only if it stays within a tenth of the gap, so that it lands on the
//! neighbour; otherwise Laguerre's method goes on.
//!
//! Reference: A. S. Householder, The Numerical Treatment of a Single Nonlinear Equation (1970), §4.4.

use super::trail::{Ends, Trail};
use crate::double::rough_sqrt;
use crate::jacobi::Weight;
use crate::jacobi::monic::{CHUNK, Monic};

/// The sign that mirrors the left end.
const SIGN: Ends = [1.0, -1.0];

/// The differential equation seen from both ends.
struct Search {
    monic: Monic,
    n: usize,
    lambda: f64,
    sigma: f64,
    difference: Ends,
    /// Where t = 1 the order of the zero of the weight.
    exponent: Ends,
}

/// Writes floats near all roots of π_n, ascending; n = `roots.len()`.
pub(super) const fn roots(weight: Weight, roots: &mut [f64]) {
    let n = roots.len();
    let search = Search::new(weight, n);
    let mut trail = Trail::new();
    let mut found = 0;
    while 2 * found < n {
        let t = match search.follow(&trail) {
            Some(t) => t,
            None => search.descend(&trail, roots, found),
        };
        roots[found] = -t[1];
        roots[n - 1 - found] = t[0];
        trail.push(t);
        found += 1;
    }
}

impl Search {
    const fn new(weight: Weight, n: usize) -> Search {
        let (alpha, beta) = (weight.alpha(), weight.beta());
        let sigma = alpha + beta;
        Search {
            monic: Monic::new(weight),
            n,
            lambda: n as f64 * (n as f64 + sigma + 1.0),
            sigma,
            difference: [alpha - beta, beta - alpha],
            exponent: [alpha, beta],
        }
    }

    /// The next root at each end by Halley's steps from the extrapolated ones, if these are near enough.
    const fn follow(&self, trail: &Trail) -> Option<Ends> {
        let Some(mut t) = trail.next() else { return None };
        let mut near = false;
        while !near {
            let (s_1, s_2) = self.inside(&t);
            near = true;
            let mut e = 0;
            while e < 2 {
                let gap = trail.t[e] - t[e];
                let step = 2.0 * s_1[e] / (s_1[e] * s_1[e] + s_2[e]);
                let neighbour = step.abs() < 0.1 * gap;
                if !neighbour {
                    return None;
                }
                near = near && step.abs() < 0.004 * gap;
                t[e] -= step;
                e += 1;
            }
        }
        Some(t)
    }

    /// The next root at each end by Laguerre's method, given `found` roots at each end.
    const fn descend(&self, trail: &Trail, roots: &[f64], found: usize) -> Ends {
        let m = (self.n - 2 * found) as f64;
        let (mut s_1, mut s_2) = if found == 0 { self.at_ends() } else { self.at_roots(trail.t) };
        let mut t = trail.t;
        // The first root lies farther from the end than from the second when the exponent is large.
        let near = if found == 0 { 1e-5 } else { 1e-3 };
        let mut moving = [true; 2];
        // The root at t itself is left out of the first sums: its limit is in s₁ and s₂ already.
        let mut skip = 1;
        loop {
            deflate(&t, roots, found, skip, &mut s_1, &mut s_2);
            let mut e = 0;
            while e < 2 {
                if moving[e] {
                    let inner = (m - 1.0) * (m * s_2[e] - s_1[e] * s_1[e]);
                    let root = rough_sqrt(if inner > 0.0 { inner } else { 0.0 });
                    let step = m / (s_1[e] + root.copysign(s_1[e]));
                    t[e] -= step;
                    moving[e] = step.abs() > near * (trail.t[e] - t[e]);
                }
                e += 1;
            }
            if !moving[0] && !moving[1] {
                return t;
            }
            (s_1, s_2) = self.inside(&t);
            skip = 0;
        }
    }

    /// s₁ and s₂ of π_n at t = 1.
    const fn at_ends(&self) -> (Ends, Ends) {
        let (mut s_1, mut s_2) = ([0.0; 2], [0.0; 2]);
        let mut e = 0;
        while e < 2 {
            s_1[e] = self.lambda / (2.0 * self.exponent[e] + 2.0);
            let second = (self.lambda - self.sigma - 2.0) / (2.0 * self.exponent[e] + 4.0) * s_1[e];
            s_2[e] = s_1[e] * s_1[e] - second;
            e += 1;
        }
        (s_1, s_2)
    }

    /// s₁ and s₂ of π_n without its root at t.
    const fn at_roots(&self, t: Ends) -> (Ends, Ends) {
        let (mut s_1, mut s_2) = ([0.0; 2], [0.0; 2]);
        let mut e = 0;
        while e < 2 {
            let one = (1.0 - t[e]) * (1.0 + t[e]);
            let second = (self.difference[e] + (self.sigma + 2.0) * t[e]) / one;
            let third = ((self.difference[e] + (self.sigma + 4.0) * t[e]) * second + self.sigma + 2.0
                - self.lambda)
                / one;
            s_1[e] = 0.5 * second;
            s_2[e] = 0.25 * second * second - third / 3.0;
            e += 1;
        }
        (s_1, s_2)
    }

    /// s₁ and s₂ of π_n at t, away from roots and ends.
    const fn inside(&self, t: &Ends) -> (Ends, Ends) {
        let (last, before) = self.evaluate(t);
        let n = self.n as f64;
        let s = self.monic.s(self.n).hi;
        let factor = 0.5 * (s + 1.0) * self.monic.four_gamma(self.n).hi;
        let (mut s_1, mut s_2) = ([0.0; 2], [0.0; 2]);
        let mut e = 0;
        while e < 2 {
            let one = (1.0 - t[e]) * (1.0 + t[e]);
            s_1[e] = (n * (self.difference[e] / s - t[e]) + factor * before[e] / last[e]) / one;
            let second = ((self.difference[e] + (self.sigma + 2.0) * t[e]) * s_1[e] - self.lambda) / one;
            s_2[e] = s_1[e] * s_1[e] - second;
            e += 1;
        }
        (s_1, s_2)
    }

    /// π̂_n and π̂_{n−1} at t, up to a common factor.
    const fn evaluate(&self, t: &Ends) -> (Ends, Ends) {
        let twice = [2.0 * t[0], 2.0 * t[1]];
        let (mut last, mut before) = ([1.0; 2], [0.0; 2]);
        let mut k = 0;
        while k < self.n {
            let (delta, gamma) = self.monic.coarse_steps(k);
            let mut l = 0;
            while l < CHUNK && k < self.n {
                let mut e = 0;
                while e < 2 {
                    let next = (twice[e] - SIGN[e] * delta[l]) * last[e] - gamma[l] * before[e];
                    before[e] = last[e];
                    last[e] = next;
                    e += 1;
                }
                l += 1;
                k += 1;
            }
        }
        (last, before)
    }
}

/// Subtracts the sums over the roots found, leaving out the last `skip` at the own end.
const fn deflate(t: &Ends, roots: &[f64], found: usize, skip: usize, s_1: &mut Ends, s_2: &mut Ends) {
    let n = roots.len();
    let mut i = 0;
    while i < found {
        let (left, right) = (roots[i], roots[n - 1 - i]);
        let far = [1.0 / (t[0] - left), 1.0 / (t[1] + right)];
        let near = if i + skip < found { [1.0 / (t[0] - right), 1.0 / (t[1] + left)] } else { [0.0; 2] };
        let mut e = 0;
        while e < 2 {
            s_1[e] -= far[e] + near[e];
            s_2[e] -= far[e] * far[e] + near[e] * near[e];
            e += 1;
        }
        i += 1;
    }
}
