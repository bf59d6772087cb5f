//! What two points have to be above to see each other: the tangent plane of the other, and the cone of a ball between.
//!
//! With e from x to the centre of the ball, d = y − x and the squared length E = |e|² − r² of the tangents from x, y is hidden
//! where it lies within the cone of the tangents and beyond the plane e·d = E of the points where they touch, and so where
//!
//! ```text
//! h = E |d|² − (e·d)²  if e·d > E ,     h = E (|y − c|² − r²)  otherwise
//! ```
//!
//! is negative; h and its gradient are continuous, and the second is positive outside the ball.

use radiosity_geom::DVec3;

use crate::elements::patch::Node;

/// A ball that may stand between.
#[derive(Clone, Copy, Debug)]
pub(in crate::transport) struct Ball {
    /// Its centre.
    pub center: DVec3,
    /// Its radius.
    pub radius: f64,
}

/// What has to be positive for two points to see each other.
pub(super) const HEIGHTS: usize = 3;
/// One a condition.
pub(super) type Heights = [f64; HEIGHTS];

/// A point that looks at an inner patch, with what may stand in between.
pub(super) struct View {
    /// The point.
    pub node: Node,
    /// The ball.
    pub ball: Option<Ball>,
}

impl View {
    /// [n_x·(y − x), n_y·(x − y), h]: the heights of each over the tangent plane of the other, and that over the cone of
    /// the ball, 1 if there is none.
    pub(super) fn heights(&self, y: &Node) -> Heights {
        let d = y.position - self.node.position;
        let over_ball = self.ball.map_or(1.0, |ball| ball.clearance(self.node.position, y.position));
        [self.node.normal.dot(d), -y.normal.dot(d), over_ball]
    }
}

impl Ball {
    /// h of the module's head.
    pub(super) fn clearance(&self, x: DVec3, y: DVec3) -> f64 {
        let (e, d) = (self.center - x, y - x);
        let tangent = e.length_squared() - self.radius * self.radius;
        let along = e.dot(d);
        if along > tangent {
            tangent * d.length_squared() - along * along
        } else {
            tangent * (y.distance_squared(self.center) - self.radius * self.radius)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use proptest::prelude::*;
    use radiosity_geom::shapes::{FULL_TURN, Sphere};
    use radiosity_geom::{Ray, Surface};

    proptest! {
        /// The sign of the clearance tells what a ray against the sphere tells.
        #[test]
        fn clearance_is_negative_where_the_ball_stands_between(
            x in prop::array::uniform3(-3.0..3.0f64), y in prop::array::uniform3(-3.0..3.0f64),
        ) {
            let (x, y) = (DVec3::from_array(x), DVec3::from_array(y));
            prop_assume!(x.length() > 1.0 && y.length() > 1.0);
            let ball = Ball { center: DVec3::ZERO, radius: 1.0 };
            let sphere = Sphere::new(DVec3::ZERO, 1.0, DVec3::Z, [-1.0, 1.0], FULL_TURN).expect("a sphere");
            let clearance = ball.clearance(x, y);
            prop_assume!(clearance.abs() > 1e-9);
            prop_assert_eq!(clearance < 0.0, sphere.occludes(&Ray::segment(x, y)));
        }
    }
}
