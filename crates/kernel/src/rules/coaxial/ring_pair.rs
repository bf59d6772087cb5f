//! Exchange of two coaxial rings, by a closed form.
//!
//! Formula. With u = sin² ½φ, Δz = z₂ − z₁ and the squares of the least and the largest distance m² = (r₁ −
//! r₂)² + Δz² and M² = (r₁ + r₂)² + Δz²,
//!
//! ```text
//! n₁·d = A(u) = A₀ − a u ,    −n₂·d = P(u) = P₀ − p u ,    |d|² = m² + (M² − m²) u ,
//! A₀ = n₁r (r₂ − r₁) + n₁z Δz ,  a = 2 n₁r r₂ ,    P₀ = n₂r (r₁ − r₂) − n₂z Δz ,  p = 2 n₂r r₁ .
//! ```
//!
//! Each is positive in an interval of u. With tan ½φ = k tan θ, k = m/M, the peak at φ = 0 is gone:
//!
//! ```text
//! ∫ A P/|d|⁴ dφ = 2/(m³M) ∫ (A₀ w + A₁ k² (1 − w)) (P₀ w + P₁ k² (1 − w)) / q dθ ,
//! w = cos² θ ,   q = k² + D w ,   D = 1 − k² ,   A₁ = A₀ − a ,   P₁ = P₀ − p .
//! ```
//!
//! By division, with Â = A₀ − A₁ k² and P̂ = P₀ − P₁ k², and ∫ dθ/q = φ/(2k),
//!
//! ```text
//! D² ∫ = Â P̂ ∫ q dθ − k² (Â p + P̂ a) θ + k³ a p φ/2 ,     ∫ q dθ = k² θ + D (½ θ + ¼ sin 2θ) .
//! ```
//!
//! Range. D ≥ ¼; below, near the axis, digits would cancel as D², and the integrand over θ is smooth: its poles
//! are at cos² θ = −k²/D ≤ −3, and 16 points leave 10⁻¹⁸.

use radiosity_core::gauss::{Legendre, Rule};
use radiosity_geom::DVec2;

/// Smallest D for the closed form.
const LEAST_OF_CLOSED: f64 = 0.25;

/// Points for smaller D.
const POINTS: usize = 16;

/// A circle on a surface of revolution.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ring {
    /// Distance from the axis, and height.
    pub(super) place: DVec2,
    /// Unit normal of the front, likewise.
    pub(super) normal: DVec2,
}

/// A quantity A₀ − a u.
#[derive(Clone, Copy, Debug)]
struct Linear {
    /// Value at φ = 0.
    near: f64,
    /// Loss up to φ = π.
    drop: f64,
}

/// Two rings about one axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct RingPair {
    radii: [f64; 2],
    /// Heights of each over the plane of the other, times the distance of the points.
    fronts: [Linear; 2],
    /// Least and largest distance of points.
    least: f64,
    largest: f64,
}

impl RingPair {
    /// Two rings; of `collinear` ones, which lie on one meridian, none stands over the other's plane at φ = 0.
    pub(super) fn new([x, y]: [Ring; 2], collinear: bool) -> Self {
        let between = y.place - x.place;
        let front = |own: &Ring, to: DVec2, other: &Ring| Linear {
            near: if collinear { 0.0 } else { own.normal.dot(to) },
            drop: 2.0 * own.normal.x * other.place.x,
        };
        Self {
            radii: [x.place.x, y.place.x],
            fronts: [front(&x, between, &y), front(&y, -between, &x)],
            least: between.length(),
            largest: (x.place.x + y.place.x).hypot(between.y),
        }
    }

    /// 4 π r₁ r₂ ∫ κ dφ past a cylinder of the radius `core`.
    pub(super) fn exchange(&self, core: f64) -> f64 {
        let [a, b] = self.fronts.map(Linear::positive);
        let (low, high) = (a[0].max(b[0]), a[1].min(b[1]).min(self.unhidden(core)));
        if low >= high || self.least <= 0.0 {
            return 0.0;
        }
        let [first, last] = [low, high].map(|u| self.limit(u));
        4.0 * self.radii[0] * self.radii[1] * self.integral(first, last)
    }

    /// sin² ½φ of the largest angle at which the cylinder hides nothing.
    fn unhidden(&self, core: f64) -> f64 {
        let arc = |r: f64| ((r - core) * (r + core)).max(0.0).sqrt().atan2(core);
        let [a, b] = self.radii.map(arc);
        if core > 0.0 { (0.5 * (a + b)).sin().powi(2) } else { 1.0 }
    }

    fn limit(&self, u: f64) -> Limit {
        let (sine, cosine) = (u.sqrt(), (1.0 - u).sqrt());
        let stretch = self.least / self.largest;
        Limit { angle: 2.0 * sine.atan2(cosine), theta: sine.atan2(stretch * cosine) }
    }

    /// ∫ A P/|d|⁴ dφ between two limits.
    fn integral(&self, first: Limit, last: Limit) -> f64 {
        let k = self.least / self.largest;
        let open = (1.0 - k) * (1.0 + k);
        let value = match open >= LEAST_OF_CLOSED {
            true => self.primitive(last, k, open) - self.primitive(first, k, open),
            false => self.by_points([first.theta, last.theta], k, open),
        };
        2.0 * value / (self.least.powi(3) * self.largest)
    }

    fn primitive(&self, Limit { angle, theta }: Limit, k: f64, open: f64) -> f64 {
        let square = k * k;
        let [a, p] = self.fronts;
        let [at_a, at_p] = [a, p].map(|front| front.near * open + front.drop * square);
        let of_q = square * theta + open * (0.5 * theta + 0.25 * (2.0 * theta).sin());
        let mixed = at_a * p.drop + at_p * a.drop;
        let sum = at_a * at_p * of_q - square * mixed * theta + square * k * a.drop * p.drop * 0.5 * angle;
        sum / (open * open)
    }

    fn by_points(&self, [first, last]: [f64; 2], k: f64, open: f64) -> f64 {
        const RULE: Rule<POINTS> = Legendre::<POINTS>::RULE;
        let square = k * k;
        let half = 0.5 * (last - first);
        let at = |node: f64| {
            let w = (first + half * (1.0 + node)).cos().powi(2);
            let [a, p] =
                self.fronts.map(|front| front.near * w + (front.near - front.drop) * square * (1.0 - w));
            a * p / (square + open * w)
        };
        half * RULE.sum(at)
    }
}

/// A limit of the angle φ, and its θ.
#[derive(Clone, Copy, Debug)]
struct Limit {
    angle: f64,
    theta: f64,
}

impl Linear {
    /// The interval of u in [0, 1] where it is positive; low ≥ high where it is nowhere.
    fn positive(self) -> [f64; 2] {
        let Self { near, drop } = self;
        match drop {
            drop if drop > 0.0 => [0.0, (near / drop).min(1.0)],
            drop if drop < 0.0 => [(near / drop).max(0.0), 1.0],
            _ if near > 0.0 => [0.0, 1.0],
            _ => [1.0, 0.0],
        }
    }
}
