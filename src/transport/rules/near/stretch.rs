//! A Gauss rule on [0, 1], concentrated near a point by sinh, and its number of points.
//!
//! ```text
//! s = c + b sinh μ ,    ∫₀¹ f(s) ds = ∫ f(s(μ)) b cosh μ dμ
//! ```
//!
//! An f with a singularity at c ± 𝚒b becomes analytic up to |Im μ| = π/2 for every b. Let the nearest singularity lie
//! on the ellipse ϱ of the μ-interval. For f times a polynomial of degree N the error of n points is at most of order
//! G(ϱ′)ᴺ ϱ′⁻²ⁿ for every 1 < ϱ′ ≤ ϱ. G = a + √(a² − 1) is the growth of Legendre polynomials at the farthest place
//! a ≥ 1, in the coordinates of their element, that the ellipse ϱ′ reaches. Hence
//!
//! ```text
//! n = ⌈ min over ϱ′ of (N ln G(ϱ′) + ln(1/ε)) / (2 ln ϱ′) ⌉ .
//! ```
//!
//! Reference: P. R. Johnston, D. Elliott, *A sinh transformation for evaluating nearly singular boundary element
//! integrals*, Int. J. Numer. Methods Eng. 62 (2005).

use crate::elements::rule::UnitRule;
use crate::transport::rules::near::complex::Complex;

/// Largest ϱ used in counts: 2.2 digits per point. Chosen; not tuned.
const LARGEST_RHO: f64 = 12.0;
/// ln ϱ′ / ln ϱ of the ellipses over which the minimum is taken. Chosen; not tuned.
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
    pub(super) fn ellipse(&self, place: Complex) -> f64 {
        let half = 0.5 * (self.high - self.low);
        let rho = |mu: Complex| (mu - Complex::new(self.low + half, 0.0)).scale(1.0 / half).ellipse();
        if !self.scale.is_finite() {
            return rho(place);
        }
        let mu = (place - Complex::new(self.center, 0.0)).scale(1.0 / self.scale).asinh();
        // sinh(𝚒π − μ) = sinh μ: the singularity has a second image, beyond π/2.
        rho(mu).min(rho(Complex::new(-mu.re, core::f64::consts::PI - mu.im)))
    }

    /// Points for polynomials of degree `degree` on an element of whose frame [0, 1] covers the part `fraction`.
    pub(super) fn points(&self, rho: f64, fraction: f64, degree: usize, eps: f64) -> usize {
        let most = rho.clamp(1.0 + 1e-6, LARGEST_RHO).ln();
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

    /// How far beyond [0, 1] the ellipse ϱ reaches.
    fn reach(&self, rho: f64) -> f64 {
        let beyond = 0.25 * (rho + 1.0 / rho - 2.0) * (self.high - self.low);
        if !self.scale.is_finite() {
            return beyond;
        }
        let at = |mu: f64| self.center + self.scale * mu.sinh();
        (at(self.high + beyond) - 1.0).max(-at(self.low - beyond))
    }
}
