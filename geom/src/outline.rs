//! Plane curves that bend one way, and the half-planes behind their tangents.
//!
//! ```text
//! e(p) = max over s of n(s)·(p − C(s)) ,      n the unit normal away from the side that the curve bends to
//! ```
//!
//! is a largest one of affine functions: convex in p, and at most 0 exactly where p lies behind all tangents.
//! With κ the curvature, its derivative by s is κ |C′| t·(p − C), so that the largest one lies at an end of
//! the curve, or where C′·(p − C) vanishes: of a cubic a polynomial of degree five.

use glam::DVec2;

use crate::arc::arc_range;
use crate::bernstein::evaluate;
use crate::roots;

/// Part of the squared length of a control polygon by which cross products of its legs may be off.
const STRAIGHT: f64 = 1e-13;

/// A curve that bends one way. Coordinates are lengths.
#[derive(Clone, Copy, Debug)]
pub enum Outline {
    /// The line x = radius + slope · y, with what it bounds at smaller x.
    Line {
        /// x where y = 0.
        radius: f64,
        /// Growth of x along y.
        slope: f64,
    },
    /// An arc of a circle.
    Arc {
        /// Its centre.
        center: DVec2,
        /// Its radius.
        radius: f64,
        /// Angles from and to (radians).
        angles: [f64; 2],
    },
    /// A cubic Bézier curve.
    Cubic {
        /// Its control points.
        points: [DVec2; 4],
        /// 1 if it bends to the left, −1 if to the right.
        side: f64,
    },
}

impl Outline {
    /// The curve with control points `points`, if it nowhere bends away from `side`: 1 for the left, −1 for
    /// the right.
    ///
    /// With dᵢ the legs of the control polygon C′ × C″ is 18 times
    /// (1 − s)² d₀ × d₁ + s (1 − s) d₀ × d₂ + s² d₁ × d₂.
    pub(crate) fn cubic(points: [DVec2; 4], side: f64) -> Option<Self> {
        let [d0, d1, d2] = legs(&points);
        let noise = STRAIGHT * (d0.length() + d1.length() + d2.length()).powi(2);
        let bends = [d0.perp_dot(d1), 0.5 * d0.perp_dot(d2), d1.perp_dot(d2)];
        is_nowhere_below(bends.map(|bend| side * bend), noise).then_some(Self::Cubic { points, side })
    }

    /// Distance of a point beyond a tangent of the curve at the most (length): e(p).
    pub(crate) fn excess(&self, point: DVec2) -> f64 {
        match *self {
            Self::Line { radius, slope } => {
                (point.x - radius - slope * point.y) / (1.0 + slope * slope).sqrt()
            }
            Self::Arc { center, radius, angles } => {
                let [x, y] = (point - center).to_array();
                arc_range(x, y, angles)[1] - radius
            }
            Self::Cubic { points, side } => {
                let mut most = f64::NEG_INFINITY;
                let mut look = |s: f64| most = most.max(beyond_tangent(&points, side, s, point));
                look(0.0);
                look(1.0);
                roots::bernstein(toward(&points, point), look);
                most
            }
        }
    }

    /// The curve `scale` times as large.
    pub(crate) fn scaled(self, scale: f64) -> Self {
        match self {
            Self::Line { radius, slope } => Self::Line { radius: scale * radius, slope },
            Self::Arc { center, radius, angles } => {
                Self::Arc { center: scale * center, radius: scale * radius, angles }
            }
            Self::Cubic { points, side } => Self::Cubic { points: points.map(|p| scale * p), side },
        }
    }
}

/// The legs of a control polygon.
pub(crate) fn legs(points: &[DVec2; 4]) -> [DVec2; 3] {
    std::array::from_fn(|k| points[k + 1] - points[k])
}

/// Whether the polynomial of degree two with these Bernstein coefficients is nowhere below −noise on [0, 1].
pub(crate) fn is_nowhere_below([a, b, c]: [f64; 3], noise: f64) -> bool {
    a >= -noise && c >= -noise && (b >= -noise || b * b <= a * c)
}

/// The height of a point beyond the tangent at s.
fn beyond_tangent(points: &[DVec2; 4], side: f64, s: f64, point: DVec2) -> f64 {
    let (at, slope) = evaluate(points, s);
    // Where the curve stops for a moment, its direction a little farther inside.
    let nudged = || evaluate(points, 0.5 + (1.0 - 1e-6) * (s - 0.5)).1.normalize_or_zero();
    let along = slope.try_normalize().unwrap_or_else(nudged);
    -side * along.perp_dot(point - at)
}

/// C′·(p − C) in Bernstein form.
fn toward(points: &[DVec2; 4], point: DVec2) -> [f64; 6] {
    const TWO: [f64; 3] = [1.0, 2.0, 1.0];
    const THREE: [f64; 4] = [1.0, 3.0, 3.0, 1.0];
    const FIVE: [f64; 6] = [1.0, 5.0, 10.0, 10.0, 5.0, 1.0];
    let mut sums = [0.0; 6];
    for (i, leg) in legs(points).into_iter().enumerate() {
        for (j, corner) in points.iter().enumerate() {
            sums[i + j] += TWO[i] * THREE[j] / FIVE[i + j] * leg.dot(point - *corner);
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn place() -> impl Strategy<Value = DVec2> {
        [-2.0..2.0, -2.0..2.0].prop_map(DVec2::from_array)
    }

    proptest! {
        /// Against the heights over two thousand tangents.
        #[test]
        fn the_farthest_tangent_is_found(points in prop::array::uniform4(place()), p in place()) {
            for side in [1.0, -1.0] {
                let Some(outline) = Outline::cubic(points, side) else { continue };
                let heights = (0..=2000).map(|k| beyond_tangent(&points, side, f64::from(k) / 2000.0, p));
                let most = heights.fold(f64::NEG_INFINITY, f64::max);
                let found = outline.excess(p);
                prop_assert!(found >= most - 1e-12 && found <= most + 1e-3, "{} {}", found, most);
            }
        }

        /// Against the turns of a polygon through many of its points.
        #[test]
        fn curves_that_bend_both_ways_are_none(points in prop::array::uniform4(place())) {
            let slopes: Vec<DVec2> = (0..=400).map(|k| evaluate(&points, f64::from(k) / 400.0).1).collect();
            let turns = || slopes.windows(2).map(|pair| pair[0].perp_dot(pair[1]));
            for side in [1.0, -1.0] {
                let lowest = turns().map(|turn| side * turn).fold(f64::MAX, f64::min);
                if lowest.abs() > 1e-9 {
                    prop_assert_eq!(Outline::cubic(points, side).is_some(), lowest > 0.0);
                }
            }
        }
    }

    #[test]
    fn an_arc_and_the_line_beside_it_have_their_distances() {
        let arc = Outline::Arc { center: DVec2::X, radius: 1.0, angles: [0.0, 0.5 * std::f64::consts::PI] };
        assert!((arc.excess(DVec2::new(4.0, 4.0)) - 4.0).abs() < 1e-15);
        // Beyond the ends their tangents count: x = 2 and y = 1.
        assert!((arc.excess(DVec2::new(2.5, -3.0)) - 0.5).abs() < 1e-15);
        let line = Outline::Line { radius: 1.0, slope: -0.75 };
        assert!((line.excess(DVec2::new(3.0, 1.0)) - 2.2).abs() < 1e-15);
    }
}
