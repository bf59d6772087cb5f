//! Planes of outlines, and flat coordinates in them.

use glam::{DVec2, DVec3};
use radiosity_geom::{NO_AREA, sides};

use crate::outline::extent;
use radiosity_geom::area_vector;

/// Part of its corners' areas below which the net area of an outline that crosses itself tells no direction:
/// the loops of a bow tie cancel but for what its coordinates are off by. An arbitrary choice: with a larger
/// value a small loop hides the direction of a large one; with a smaller one rounding decides.
const LEVEL: f64 = 1e-2;

/// A plane with a front and flat coordinates.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    origin: DVec3,
    normal: DVec3,
    /// Indices of the two coordinates in space that are flat coordinates, in the order that turns
    /// counter-clockwise about the normal. Lines parallel to an axis in space stay parallel to one to the
    /// last bit.
    axes: [usize; 2],
}

impl Plane {
    /// The plane of an outline, which runs counter-clockwise about its normal, by net area if it crosses
    /// itself. None if all points lie on a line.
    pub fn of(outline: &[DVec3]) -> Option<Plane> {
        let origin = *outline.first()?;
        let size = extent(outline);
        let net = area_vector(outline);
        let corners = || sides(outline).map(|[x, y]| (x - origin).cross(y - origin));
        let largest = corners().max_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))?;
        let aligned: DVec3 = corners().map(|x| if x.dot(largest) < 0.0 { -x } else { x }).sum();
        let normal = match net.length() > LEVEL * aligned.length() {
            true => net,
            false if net.dot(aligned) < 0.0 => -aligned,
            false => aligned,
        };
        if normal.length() <= NO_AREA * size * size {
            return None;
        }
        let normal = normal.try_normalize()?;
        let dropped = normal.abs().max_position();
        let [a, b] = [(dropped + 1) % 3, (dropped + 2) % 3];
        let axes = if normal[dropped] > 0.0 { [a, b] } else { [b, a] };
        Some(Plane { origin, normal, axes })
    }

    /// Unit normal of the plane, on its front.
    pub fn normal(&self) -> DVec3 {
        self.normal
    }

    /// Height of a point over the plane (length).
    pub fn height(&self, point: DVec3) -> f64 {
        (point - self.origin).dot(self.normal)
    }

    /// The nearest point of the plane.
    pub fn foot(&self, point: DVec3) -> DVec3 {
        point - self.height(point) * self.normal
    }

    /// Flat coordinates of a point (length).
    pub(super) fn flat(&self, point: DVec3) -> DVec2 {
        DVec2::new(point[self.axes[0]], point[self.axes[1]])
    }

    /// The point of the plane with these flat coordinates.
    pub(super) fn raised(&self, at: DVec2) -> DVec3 {
        let [a, b] = self.axes;
        let dropped = 3 - a - b;
        let mut point = self.origin;
        (point[a], point[b]) = (at.x, at.y);
        point[dropped] -= (point - self.origin).dot(self.normal) / self.normal[dropped];
        point
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flat_coordinates_turn_counter_clockwise_about_every_normal() {
        for normal in
            [[3.0, 1.0, -1.0], [-2.0, 0.5, 1.0], [0.1, 0.9, 0.2], [0.0, -1.0, 0.0], [1.0, 1.0, -2.0]]
        {
            let normal = DVec3::from_array(normal).normalize();
            let first = normal.any_orthonormal_vector();
            let second = normal.cross(first);
            let middle = DVec3::new(3.0, -2.0, 7.0);
            let outline = [middle, middle + first, middle + second];
            let plane = Plane::of(&outline).expect("a triangle has a plane");
            assert!(plane.normal().distance(normal) < 1e-12);
            let [p, q, r] = outline.map(|x| plane.flat(x));
            assert!((q - p).perp_dot(r - p) > 0.0);
            assert!(outline.iter().all(|x| plane.raised(plane.flat(*x)).distance(*x) < 1e-12));
        }
    }

    #[test]
    fn a_bow_tie_has_a_plane_and_a_line_has_none() {
        let tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]].map(|[x, y]| DVec3::new(x, y, 2.0));
        let plane = Plane::of(&tie).expect("a bow tie has a plane");
        assert!(plane.normal().z.abs() == 1.0 && tie.iter().all(|x| plane.height(*x) == 0.0));
        assert!(Plane::of(&[DVec3::ZERO, DVec3::X, 2.0 * DVec3::X]).is_none());
    }
}
