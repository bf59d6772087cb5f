//! Where a shape is put: scaled, then rotated about an axis through the origin, then moved.

use glam::DMat3;
use radiosity_geom::DVec3;

/// The similarity x ↦ R (s x) + t.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Placement {
    linear: DMat3,
    translate: DVec3,
}

impl Placement {
    /// Leaves everything where it is.
    pub(super) const STAY: Placement = Placement { linear: DMat3::IDENTITY, translate: DVec3::ZERO };

    /// `scale` > 0; `axis` a unit vector, `degrees` right-handed about it.
    pub(super) fn new(scale: f64, axis: DVec3, degrees: f64, translate: DVec3) -> Self {
        Placement { linear: DMat3::from_axis_angle(axis, degrees.to_radians()) * scale, translate }
    }

    /// Where a point goes.
    pub(super) fn point(&self, point: DVec3) -> DVec3 {
        self.linear * point + self.translate
    }

    /// Where the points of a list go.
    pub(super) fn points(&self, points: &[DVec3]) -> Vec<DVec3> {
        points.iter().map(|&point| self.point(point)).collect()
    }

    /// What becomes of a vector.
    pub(super) fn vector(&self, vector: DVec3) -> DVec3 {
        self.linear * vector
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scale_then_rotate_then_translate() {
        let placement = Placement::new(2.0, DVec3::Z, 90.0, DVec3::new(0.0, 0.0, 5.0));
        let moved = placement.point(DVec3::X);
        assert!(moved.distance(DVec3::new(0.0, 2.0, 5.0)) < 1e-15);
        assert!(placement.vector(DVec3::X).distance(DVec3::new(0.0, 2.0, 0.0)) < 1e-15);
    }
}
