//! Prediction of the next root by extrapolating the angles between roots.
//!
//! With t = cos θ the roots of π_n are nearly equidistant in θ, and more so away from the ends:
//!
//!   Δ_k = θ_k − θ_{k−1},   Δ_{k+1} ≈ 2Δ_k − Δ_{k−1},   t_{k+1} ≈ t_k cos Δ_{k+1} − sin θ_k sin Δ_{k+1}
//!
//! Only angles below [`WIDEST`] are extrapolated, by the first terms of the series of sin, cos and arcsin.

use crate::math::const_sqrt;

/// One number per end of the interval: right, left (mirrored).
pub(super) type Ends = [f64; 2];

/// Largest angle between roots that is extrapolated: below it the series of arcsin is right to 10⁻⁵.
const WIDEST: f64 = 0.4;

/// The last roots found from each end.
pub(super) struct Trail {
    /// The last root, or 1.
    pub(super) t: Ends,
    sine: Ends,
    gap: Ends,
    gap_before: Ends,
    found: usize,
}

impl Trail {
    /// No root found: both ends stand at 1.
    pub(super) const fn new() -> Trail {
        Trail { t: [1.0; 2], sine: [0.0; 2], gap: [0.0; 2], gap_before: [0.0; 2], found: 0 }
    }

    /// Appends a root at each end.
    pub(super) const fn push(&mut self, t: Ends) {
        let mut e = 0;
        while e < 2 {
            let sine = const_sqrt((1.0 - t[e]) * (1.0 + t[e]));
            self.gap_before[e] = self.gap[e];
            self.gap[e] = arcsine(sine * self.t[e] - t[e] * self.sine[e]);
            self.sine[e] = sine;
            e += 1;
        }
        self.t = t;
        self.found += 1;
    }

    /// The extrapolated next roots, once three are known.
    pub(super) const fn next(&self) -> Option<Ends> {
        let mut t = self.t;
        let mut e = 0;
        while e < 2 {
            let gap = 2.0 * self.gap[e] - self.gap_before[e];
            if self.found < 3 || !(gap > 0.0 && gap < WIDEST) {
                return None;
            }
            let q = gap * gap;
            let cosine = 1.0 - q * (0.5 - q * (1.0 / 24.0 - q / 720.0));
            let sine = gap * (1.0 - q * (1.0 / 6.0 - q * (1.0 / 120.0 - q / 5040.0)));
            t[e] = self.t[e] * cosine - self.sine[e] * sine;
            e += 1;
        }
        Some(t)
    }
}

/// arcsin v for small v > 0, to 10⁻⁵ for v < 0.4.
const fn arcsine(v: f64) -> f64 {
    let q = v * v;
    v * (1.0 + q * (1.0 / 6.0 + q * (3.0 / 40.0 + q * (15.0 / 336.0 + q * (105.0 / 3456.0)))))
}
