//! Bounding balls, which quickly rule out what is far from a segment, or from the hull of two other balls.

use radiosity_geom::{Aabb, DVec3, ROUNDING, sides};

/// A ball around points, and so around their convex hull.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    center: DVec3,
    radius: f64,
}

impl Ball {
    /// The ball around `points` about the centre of their bounding box.
    pub fn around(points: &[DVec3]) -> Self {
        let bounds = Aabb::around(points.iter().copied());
        let center = 0.5 * (bounds.min + bounds.max);
        let farthest = points.iter().map(|x| x.distance_squared(center)).fold(0.0, f64::max);
        Self { center, radius: farthest.sqrt() }
    }

    /// The ball around a box.
    pub(super) fn over(bounds: &Aabb) -> Self {
        Self { center: bounds.center(), radius: 0.5 * bounds.diagonal() }
    }

    /// Its centre.
    pub(super) fn center(&self) -> DVec3 {
        self.center
    }

    /// Its radius.
    pub(super) fn radius(&self) -> f64 {
        self.radius
    }

    /// Lower bound of the distance of a segment from the ball; negative where the segment may meet it.
    pub fn gap_to_segment(&self, [x, y]: [DVec3; 2]) -> f64 {
        self.distance(x, y) - self.radius
    }

    /// Whether the ball certainly misses the segment from `x` to `y`.
    pub(super) fn misses(&self, x: DVec3, y: DVec3) -> bool {
        self.distance(x, y) > self.radius
    }

    /// Whether the ball certainly misses the convex hull of two balls.
    pub(super) fn misses_between(&self, a: &Self, b: &Self) -> bool {
        self.distance(a.center, b.center) > self.radius + a.radius.max(b.radius)
    }

    /// Whether the ball certainly misses the convex hull of a point and a ball: all balls about x + t a with
    /// the radius t R, 0 ≤ t ≤ 1. False where the point lies in that ball.
    pub(super) fn misses_cone(&self, x: DVec3, center: DVec3, radius: f64) -> bool {
        let (a, d) = (center - x, self.center - x);
        let length = a.length_squared() - radius * radius;
        if length <= 0.0 {
            return false;
        }
        let t = ((d.dot(a) + self.radius * radius) / length).clamp(0.0, 1.0);
        let rounding = ROUNDING * (a.length() + d.length() + self.radius);
        d.distance(t * a) > self.radius + t * radius + rounding
    }

    /// Whether some plane through `x` and a side of the convex polygon `piece` certainly separates the piece
    /// from the ball, so that the piece hides nothing of the ball from x.
    pub(super) fn is_beside(&self, piece: &[DVec3], x: DVec3) -> bool {
        let (middle, center) = (piece.iter().sum::<DVec3>() / piece.len() as f64 - x, self.center - x);
        sides(piece).any(|[a, b]| {
            let normal = (a - x).cross(b - x);
            let height = normal.dot(center) * -normal.dot(middle).signum();
            height > 0.0 && height * height > self.radius * self.radius * normal.length_squared()
        })
    }

    /// Lower bound of the distance of the centre from the segment from `x` to `y`.
    fn distance(&self, x: DVec3, y: DVec3) -> f64 {
        let (along, to_center) = (y - x, self.center - x);
        let length = along.length_squared();
        let place = if length > 0.0 { (to_center.dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
        to_center.distance(along * place) - ROUNDING * (length.sqrt() + to_center.length() + self.radius)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point() -> impl Strategy<Value = DVec3> {
        prop::array::uniform3(-1.0..1.0f64).prop_map(DVec3::from_array)
    }

    fn points() -> impl Strategy<Value = Vec<DVec3>> {
        (point(), 0.01f64..1.0, prop::collection::vec(point(), 1..6))
            .prop_map(|(center, size, points)| points.iter().map(|x| 3.0 * center + size * *x).collect())
    }

    proptest! {
        /// No point of a ball's set lies on a segment that it misses, be its ends given or in two other sets.
        #[test]
        fn what_misses_is_apart(a in points(), b in points(), c in points(), w in 0.0..1.0f64, k in 0usize..60) {
            let (x, y, z) = (a[k % a.len()], b[k % b.len()], c[k % c.len()]);
            let ball = Ball::around(&c);
            prop_assert!(!ball.misses(x, x + (z - x) / w.max(0.1)), "it holds a point of the segment");
            let through = x.lerp(y, w);
            let moved: Vec<DVec3> = c.iter().map(|p| p - z + through).collect();
            let ball = Ball::around(&moved);
            prop_assert!(!ball.misses_between(&Ball::around(&a), &Ball::around(&b)));
            let lamp = Ball::around(&b);
            prop_assert!(!ball.misses_cone(x, lamp.center, lamp.radius));
        }
    }

    #[test]
    fn far_things_miss() {
        let ball = Ball::around(&[DVec3::new(0.0, 2.0, 0.0), DVec3::new(0.0, 2.5, 0.0)]);
        assert!(ball.misses(DVec3::X, -DVec3::X) && !ball.misses(DVec3::ZERO, 3.0 * DVec3::Y));
        let other = |x: f64| Ball::around(&[DVec3::new(x, 0.5, 0.0), DVec3::new(x, -0.5, 0.0)]);
        assert!(ball.misses_between(&other(-3.0), &other(3.0)));
    }
}
