//! Rays and where they hit.

use glam::DVec3;

/// The points `origin + t · direction` with `t` in `range`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// The point at t = 0.
    pub origin: DVec3,
    /// The step from t = 0 to t = 1; it need not be a unit vector but must not vanish.
    pub direction: DVec3,
    /// Lowest and highest t, both included.
    pub range: [f64; 2],
}

impl Ray {
    /// The half-line from `origin` along `direction`, 0 ≤ t < ∞.
    pub fn new(origin: DVec3, direction: DVec3) -> Ray {
        Ray { origin, direction, range: [0.0, f64::INFINITY] }
    }

    /// The segment from `start` (t = 0) to `end` (t = 1).
    pub fn segment(start: DVec3, end: DVec3) -> Ray {
        Ray { origin: start, direction: end - start, range: [0.0, 1.0] }
    }

    /// The point at `t`.
    pub fn at(&self, t: f64) -> DVec3 {
        self.origin + t * self.direction
    }

    /// Whether `t` belongs to the ray; false for NaN.
    pub fn reaches(&self, t: f64) -> bool {
        self.range[0] <= t && t <= self.range[1]
    }

    /// Ray from the same origin in the same direction, cut off beyond `t`.
    pub fn until(&self, t: f64) -> Ray {
        Ray { range: [self.range[0], self.range[1].min(t)], ..*self }
    }
}

/// Where a ray meets a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Place along the ray, in multiples of its direction.
    pub t: f64,
    /// First surface parameter, in [−1, 1].
    pub u: f64,
    /// Second surface parameter, in [−1, 1].
    pub v: f64,
}

impl Hit {
    /// Distance outside [−1, 1] up to which a parameter counts as a hit: rays aimed at the seam between two
    /// surfaces must not slip through by rounding, which is 10⁻⁷ of this. A larger one would let surfaces
    /// stop light beside them.
    pub const SEAM: f64 = 1e-9;

    /// The hit, its parameters clamped to [−1, 1]; `None` where they lie beyond 1 + [`Hit::SEAM`] or `t`
    /// outside the ray.
    pub(crate) fn accept(ray: &Ray, t: f64, u: f64, v: f64) -> Option<Hit> {
        let inside = u.abs() <= 1.0 + Hit::SEAM && v.abs() <= 1.0 + Hit::SEAM;
        (inside && ray.reaches(t)).then(|| Hit { t, u: u.clamp(-1.0, 1.0), v: v.clamp(-1.0, 1.0) })
    }

    /// The one of lower t.
    pub(crate) fn nearer(best: Option<Hit>, hit: Hit) -> Option<Hit> {
        Some(best.filter(|b| b.t <= hit.t).unwrap_or(hit))
    }
}
