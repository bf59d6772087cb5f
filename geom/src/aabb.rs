//! Axis-aligned bounding boxes.

use glam::DVec3;

/// The points with `min ≤ x ≤ max` in every coordinate; empty where `min > max`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// Lowest coordinates.
    pub min: DVec3,
    /// Highest coordinates.
    pub max: DVec3,
}

impl Aabb {
    /// The box of no points.
    pub const EMPTY: Aabb = Aabb { min: DVec3::INFINITY, max: DVec3::NEG_INFINITY };

    /// The smallest box around `points`.
    pub fn around(points: impl IntoIterator<Item = DVec3>) -> Aabb {
        points.into_iter().fold(Aabb::EMPTY, Aabb::grow)
    }

    /// The smallest box around this one and `point`.
    #[must_use]
    pub fn grow(self, point: DVec3) -> Aabb {
        Aabb { min: self.min.min(point), max: self.max.max(point) }
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, other: Aabb) -> Aabb {
        Aabb { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The points of both.
    #[must_use]
    pub fn intersection(self, other: Aabb) -> Aabb {
        Aabb { min: self.min.max(other.min), max: self.max.min(other.max) }
    }

    /// The box moved outwards by `margin` on every side.
    #[must_use]
    pub fn inflate(self, margin: f64) -> Aabb {
        self.inflate_each(DVec3::splat(margin))
    }

    /// The box moved outwards by `margins` along each coordinate.
    #[must_use]
    pub(crate) fn inflate_each(self, margins: DVec3) -> Aabb {
        Aabb { min: self.min - margins, max: self.max + margins }
    }

    /// Whether the box has no points.
    pub fn is_empty(&self) -> bool {
        self.min.cmpgt(self.max).any()
    }

    /// Whether the boxes share a point.
    pub fn overlaps(&self, other: &Aabb) -> bool {
        self.min.cmple(other.max).all() && other.min.cmple(self.max).all()
    }

    /// Whether `point` lies in the box or on its border.
    pub fn contains(&self, point: DVec3) -> bool {
        self.min.cmple(point).all() && point.cmple(self.max).all()
    }

    /// The middle.
    pub fn center(&self) -> DVec3 {
        0.5 * (self.min + self.max)
    }

    /// Length of the space diagonal; 0 for the empty box.
    pub fn diagonal(&self) -> f64 {
        if self.is_empty() { 0.0 } else { (self.max - self.min).length() }
    }

    /// Surface area; 0 for the empty box.
    pub fn surface(&self) -> f64 {
        let d = self.max - self.min;
        if self.is_empty() { 0.0 } else { 2.0 * (d.x * d.y + d.y * d.z + d.z * d.x) }
    }

    /// The eight corners.
    pub fn corners(&self) -> [DVec3; 8] {
        std::array::from_fn(|k| {
            let pick = |axis: usize| if k >> axis & 1 == 0 { self.min[axis] } else { self.max[axis] };
            DVec3::new(pick(0), pick(1), pick(2))
        })
    }

    /// The square of the distance from `point` to the nearest point of the box.
    pub fn distance_squared(&self, point: DVec3) -> f64 {
        (point - point.clamp(self.min, self.max)).length_squared()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_empty_box_is_neutral() {
        let unit = Aabb { min: DVec3::ZERO, max: DVec3::ONE };
        assert_eq!(Aabb::EMPTY.union(unit), unit);
        assert!(Aabb::EMPTY.is_empty() && !Aabb::EMPTY.overlaps(&unit));
        assert_eq!(Aabb::EMPTY.diagonal(), 0.0);
    }

    #[test]
    fn touching_boxes_overlap() {
        let unit = Aabb { min: DVec3::ZERO, max: DVec3::ONE };
        let beside = Aabb { min: DVec3::X, max: DVec3::new(2.0, 1.0, 1.0) };
        assert!(unit.overlaps(&beside));
        assert!(!unit.overlaps(&Aabb { min: 1.5 * DVec3::ONE, max: 2.0 * DVec3::ONE }));
        assert_eq!(Aabb::around(unit.corners()), unit);
        assert_eq!(unit.surface(), 6.0);
        assert_eq!(unit.distance_squared(DVec3::new(2.0, 3.0, 0.5)), 5.0);
    }
}
