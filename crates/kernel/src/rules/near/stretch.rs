//! A Gauss rule on [0, 1], concentrated near a point by sinh, and its number of points.
//!
//! ```text
//! s = c + b sinh μ ,    ∫₀¹ f(s) ds = ∫ f(s(μ)) b cosh μ dμ
//! ```
//!
//! An f with a singularity at c ± 𝚒b becomes analytic up to |Im μ| = π/2 for every b. Let the nearest
//! singularity lie on the ellipse ϱ of the μ-interval. For f times a polynomial of degree N the error of n
//! points is at most of order G(ϱ′)ᴺ ϱ′⁻²ⁿ for every 1 < ϱ′ ≤ ϱ. G = a + √(a² − 1) is the growth of Legendre
//! polynomials at the farthest place a ≥ 1, in the coordinates of their element, that the ellipse ϱ′ reaches.
//! Hence
//!
//! ```text
//! n = ⌈ min over ϱ′ of (N ln G(ϱ′) + ln(1/ε)) / (2 ln ϱ′) ⌉ .
//! ```
//!
//! Reference: P. R. Johnston, D. Elliott, *A sinh transformation for evaluating nearly singular boundary
//! element integrals*, Int. J. Numer. Methods Eng. 62 (2005).

use num_complex::Complex64;
use radiosity_elements::rule::UnitRule;

use crate::rules::near::ellipse::ellipse;
use crate::tolerances::SMALLEST_RHO_OF_STRETCH;

/// Largest ϱ used in counts: 2.2 digits per point. Beyond it the nearest singularity is no longer what limits
/// a rule of few points; with a larger value such rules would have a point less.
const LARGEST_RHO: f64 = 12.0;
/// ln ϱ′ / ln ϱ of the ellipses over which the minimum is taken. The bound holds for each of them; more of
/// them would find numbers that are a little smaller.
const ELLIPSES: [f64; 3] = [1.0, 0.65, 0.4];

/// A map of [0, 1] onto itself; μ runs from `low` to `high`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stretch {
    center: f64,
    /// b; infinite for the identity.
    scale: f64,
    low: f64,
    high: f64,
}

impl Stretch {
    pub(super) const PLAIN: Self = Self { center: 0.0, scale: f64::INFINITY, low: 0.0, high: 1.0 };

    /// Concentrated near `center`, with the scale `scale` > 0.
    pub(super) fn around(center: f64, scale: f64) -> Self {
        let [low, high] = [-center, 1.0 - center].map(|x| (x / scale).asinh());
        Self { center, scale, low, high }
    }

    /// ϱ of a singularity at `place` in s, its imaginary part not negative.
    pub(super) fn ellipse(&self, place: Complex64) -> f64 {
        let half = 0.5 * (self.high - self.low);
        let rho = |mu: Complex64| ellipse((mu - (self.low + half)) / half);
        if !self.scale.is_finite() {
            return rho(place);
        }
        let mu = asinh((place - self.center) / self.scale);
        // sinh(𝚒π − μ) = sinh μ: the singularity has a second image, beyond π/2.
        rho(mu).min(rho(Complex64::new(-mu.re, core::f64::consts::PI - mu.im)))
    }

    /// Points for polynomials of degree `degree` on an element of whose frame [0, 1] covers the part
    /// `fraction`.
    pub(super) fn points(&self, rho: f64, fraction: f64, degree: usize, eps: f64) -> usize {
        let most = rho.clamp(SMALLEST_RHO_OF_STRETCH, LARGEST_RHO).ln();
        let accuracy = -eps.ln();
        let count = |part: f64| {
            let log = most * part;
            let place = 1.0 + 2.0 * fraction * self.reach(log.exp());
            let growth = place + (place * place - 1.0).sqrt();
            (degree as f64 * growth.ln() + accuracy) / (2.0 * log)
        };
        let least = ELLIPSES.into_iter().map(count).fold(f64::INFINITY, f64::min);
        least.ceil().max(1.0) as usize
    }

    /// s − c, and weights for ∫ ds, of n points.
    pub(super) fn offsets(&self, n: usize) -> impl Iterator<Item = (f64, f64)> + use<> {
        let Self { scale, low, high, .. } = *self;
        UnitRule::of(n).iter().map(move |(x, w)| {
            if !scale.is_finite() {
                return (x, w);
            }
            let mu = low + (high - low) * x;
            (scale * mu.sinh(), w * (high - low) * scale * mu.cosh())
        })
    }

    /// s, and weights for ∫ ds, of n points.
    pub(super) fn nodes(&self, n: usize) -> impl Iterator<Item = (f64, f64)> + use<> {
        let center = self.center;
        self.offsets(n).map(move |(s, w)| (center + s, w))
    }

    /// s in the middle of the μ-interval.
    pub(super) fn middle(&self) -> f64 {
        let mu = 0.5 * (self.low + self.high);
        if self.scale.is_finite() { self.center + self.scale * mu.sinh() } else { mu }
    }

    /// Distance by which the ellipse ϱ reaches beyond [0, 1].
    fn reach(&self, rho: f64) -> f64 {
        let beyond = 0.25 * (rho + 1.0 / rho - 2.0) * (self.high - self.low);
        if !self.scale.is_finite() {
            return beyond;
        }
        let at = |mu: f64| self.center + self.scale * mu.sinh();
        (at(self.high + beyond) - 1.0).max(-at(self.low - beyond))
    }
}

/// Principal inverse of sinh; on the cuts beyond ±𝚒 that of the side which the sign of zero tells.
///
/// It is odd, and conjugate at conjugate places. In the first quadrant the sum z + √(z² + 1) of
/// [`Complex64::asinh`] does not cancel.
fn asinh(z: Complex64) -> Complex64 {
    let first = Complex64::new(z.re.abs(), z.im.abs()).asinh();
    Complex64::new(first.re.copysign(z.re), first.im.copysign(z.im))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn asinh_inverts_sinh() {
        for (a, b) in [(0.3, 0.2), (-1.5, 1.4), (8.0, -0.7), (-17.0, 0.4), (0.0, 1.5), (-30.0, -1.5)] {
            let w = Complex64::new(f64::sinh(a) * f64::cos(b), f64::cosh(a) * f64::sin(b));
            assert!((asinh(w) - Complex64::new(a, b)).norm() < 1e-13, "{a} {b}");
        }
    }

    /// Beyond ±𝚒, where principal values jump, asinh(±0 + 𝚒y) = ±arcosh y + 𝚒π/2.
    #[test]
    fn asinh_is_that_of_either_side_of_its_cut() {
        for (side, y) in [0.0, -0.0].into_iter().flat_map(|side| [1.5, 2.0, 1e9].map(|y| (side, y))) {
            let right = Complex64::new(f64::acosh(y).copysign(side), core::f64::consts::FRAC_PI_2);
            for (z, right) in [(Complex64::new(side, y), right), (Complex64::new(side, -y), right.conj())] {
                assert!((asinh(z) - right).norm() < 1e-14 * right.norm(), "{z}: {}", asinh(z));
            }
        }
    }
}
