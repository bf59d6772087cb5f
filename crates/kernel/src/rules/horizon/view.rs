//! Heights that are positive where two points see each other: over each other's tangent planes, and over the
//! cone of a ball.
//!
//! Let e be the vector from x to the ball's centre c, r its radius, d = y − x, and E = |e|² − r² the squared
//! length of the tangents from x. The ball hides y inside the cone of the tangents beyond the plane e·d = E
//! of their points of contact, which is where
//!
//! ```text
//! h = E |d|² − (e·d)²  if e·d > E ,     h = E (|y − c|² − r²)  otherwise
//! ```
//!
//! is negative. h and its gradient are continuous; the second form is positive outside the ball.

use radiosity_elements::patch::Node;
use radiosity_geom::DVec3;

/// A ball that may stand between two patches.
#[derive(Clone, Copy, Debug)]
pub struct Ball {
    /// Centre of the ball.
    pub center: DVec3,
    /// Radius of the ball (scene length).
    pub radius: f64,
}

/// Number of heights that have to be positive.
pub(super) const HEIGHTS: usize = 3;
/// One height for each condition.
pub(super) type Heights = [f64; HEIGHTS];

/// An outer point, with what may stand between it and the inner patches.
pub(super) struct View {
    pub node: Node,
    pub ball: Option<Ball>,
}

impl View {
    /// [n_x·(y − x), n_y·(x − y), h]: heights over both tangent planes, and over the cone of the ball (1 without a
    /// ball).
    pub(super) fn heights(&self, y: &Node) -> Heights {
        let d = y.position - self.node.position;
        let over_ball = self.ball.map_or(1.0, |ball| ball.clearance(self.node.position, y.position));
        [self.node.normal.dot(d), -y.normal.dot(d), over_ball]
    }
}

impl Ball {
    /// h of the module's header.
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
    use proptest::prelude::*;
    use radiosity_geom::shapes::{FULL_TURN, Sphere};
    use radiosity_geom::{Ray, Surface};

    use super::*;

    proptest! {
        /// The clearance is negative where a ray meets the sphere.
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
