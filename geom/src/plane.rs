//! Oriented planes.

use glam::DVec3;

/// A plane with a front: of a flat surface, or tangent to a curved one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of it; of a tangent plane, where it touches.
    pub point: DVec3,
    /// Unit normal of its front.
    pub normal: DVec3,
}

impl Plane {
    /// Signed distance of a point from the plane, positive before its front.
    #[inline]
    pub fn height(&self, x: DVec3) -> f64 {
        (x - self.point).dot(self.normal)
    }
}
