//! Sheared boxes around bicubic tiles: which rays certainly miss a tile, and which certainly meet it.
//!
//! A tile has an affine frame (a, b, h): its mean tangents become the units of a and b, h is the height along
//! its mean normal. The tile lies in the hull of its control points, so the ranges of their coordinates make
//! a box around it, the thinner the flatter the tile: a ray that misses the box misses the tile. The four
//! sides of the tile lie in the hulls of their own control points. If these leave a core between them,
//!
//! ```text
//! max a of the side s = 0  <  a  <  min a of the side s = 1 ,     max b of t = 0  <  b  <  min b of t = 1 ,
//! ```
//!
//! a ray that passes the whole height of the box within the core meets the tile: each coordinate of the
//! difference of X(s, t) and the ray's point at w changes its sign between two opposite faces of a box of (s,
//! t, w), so the difference vanishes somewhere (Poincaré and Miranda). This holds for any frame; a degenerate
//! tile takes that of space.
//!
//! Compare Gottschalk, Lin, Manocha, *OBBTree*, 1996, whose boxes are turned but not sheared.

use crate::slabs::inverted;
use crate::tolerances::OVERHANG;
use crate::{Aabb, Ray};
use glam::{DMat3, DVec2, DVec3, Vec3Swizzles};

/// Sine of the angle between mean tangents up to which they make no frame, and the axes of space serve
/// instead: the frame multiplies rounding by one over the sine, to 10⁻¹⁰. Any frame is right; with a larger
/// value fewer slender tiles get tight boxes.
const SLENDER: f64 = 1e-6;

/// A box in the frame of a tile.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sheared {
    origin: DVec3,
    /// Map from space to (a, b, h).
    frame: DMat3,
    /// Lowest and highest coordinates.
    range: [DVec3; 2],
    /// Lowest and highest a and b of the core; empty where the sides overlap.
    core: [DVec2; 2],
}

/// A ray in the frame of a tile.
#[derive(Clone, Copy, Debug)]
pub(super) struct Local {
    /// Origin of the ray.
    pub(super) from: DVec3,
    /// Direction of the ray.
    pub(super) along: DVec3,
    /// 1 over the direction, by coordinate.
    pub(super) inverse: DVec3,
}

/// The result of testing a ray against a box.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Passage {
    /// The ray misses it.
    Misses,
    /// The ray meets it.
    Meets,
    /// The ray may meet the box or miss it.
    Doubtful,
}

impl Sheared {
    /// Around the tile with the control points `points[i][j]`, i along s.
    pub(super) fn around(points: &[[DVec3; 4]; 4]) -> Self {
        let mut around = Self {
            origin: points[0][0],
            frame: frame(points),
            range: [DVec3::ZERO; 2],
            core: [DVec2::ZERO; 2],
        };
        let local = around.local(points);
        let room = around.room(points);
        let box_of = |points: &[DVec3]| Aabb::around(points.iter().copied()).inflate_each(room);
        let whole = box_of(local.as_flattened());
        let [first, last] = [0, 3].map(|i| box_of(&local[i]));
        let [start, end] = [0, 3].map(|j| box_of(&local.map(|row| row[j])));
        around.core = [DVec2::new(first.max.x, start.max.y), DVec2::new(last.min.x, end.min.y)];
        around.range = [whole.min, whole.max];
        around
    }

    /// Points in the frame.
    pub(super) fn local(&self, points: &[[DVec3; 4]; 4]) -> [[DVec3; 4]; 4] {
        points.map(|row| row.map(|x| self.frame * (x - self.origin)))
    }

    /// Boxes in the frame around parts of the tile with the control points `points`.
    pub(super) fn parts<const N: usize>(
        &self,
        points: &[[DVec3; 4]; 4],
        parts: [[[DVec3; 4]; 4]; N],
    ) -> [Aabb; N] {
        let room = self.room(points);
        parts.map(|part| Aabb::around(self.local(&part).into_iter().flatten()).inflate_each(room))
    }

    /// Room of boxes in the frame for seams and rounding.
    fn room(&self, points: &[[DVec3; 4]; 4]) -> DVec3 {
        let size = Aabb::around(points.as_flattened().iter().copied()).diagonal();
        let rows = [0, 1, 2].map(|axis| self.frame.row(axis).length());
        OVERHANG * size * DVec3::from_array(rows)
    }

    /// A ray in the frame.
    pub(super) fn seen(&self, ray: &Ray) -> Local {
        let along = self.frame * ray.direction;
        Local { from: self.frame * (ray.origin - self.origin), along, inverse: inverted(along) }
    }

    /// Passage of a ray through the box between two multiples of its direction.
    pub(super) fn passage(&self, ray: &Local, [start, end]: [f64; 2]) -> Passage {
        let Local { from, along, inverse } = *ray;
        let [a, b] = self.range.map(|corner| (corner - from) * inverse);
        let (enter, leave) = (a.min(b), a.max(b));
        if enter.max_element().max(start) > leave.min_element().min(end) {
            return Passage::Misses;
        }
        let within = |t: f64| {
            let place = (from + t * along).xy();
            self.core[0].cmplt(place).all() && place.cmplt(self.core[1]).all()
        };
        let passes = start <= enter.z && leave.z <= end;
        if passes && within(enter.z) && within(leave.z) { Passage::Meets } else { Passage::Doubtful }
    }
}

/// From space to the units of the mean tangents and the height over them, in units of the longer one.
fn frame(points: &[[DVec3; 4]; 4]) -> DMat3 {
    let along: DVec3 = (0..4).map(|j| points[3][j] - points[0][j]).sum::<DVec3>() / 4.0;
    let across: DVec3 = points.iter().map(|row| row[3] - row[0]).sum::<DVec3>() / 4.0;
    let normal = along.cross(across);
    if normal.length() <= SLENDER * along.length() * across.length() {
        return DMat3::IDENTITY;
    }
    let size = along.length().max(across.length());
    DMat3::from_cols(along, across, size * normal.normalize()).inverse()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sheet(height: impl Fn(f64, f64) -> f64) -> [[DVec3; 4]; 4] {
        let third = |k: usize| k as f64 / 3.0;
        std::array::from_fn(|i| {
            std::array::from_fn(|j| DVec3::new(third(i), third(j), height(third(i), third(j))))
        })
    }

    #[test]
    fn rays_through_the_core_meet_and_rays_beside_the_box_miss() {
        let tile = Sheared::around(&sheet(|x, y| 0.1 * x * y));
        let at = |x: f64, y: f64, low: f64, high: f64| {
            let ray = Ray::segment(DVec3::new(x, y, low), DVec3::new(x, y, high));
            tile.passage(&tile.seen(&ray), ray.range)
        };
        assert_eq!(at(0.5, 0.5, -1.0, 1.0), Passage::Meets);
        assert_eq!(at(1.5, 0.5, -1.0, 1.0), Passage::Misses);
        assert_eq!(at(0.5, 0.5, 0.2, 1.0), Passage::Misses);
        assert_eq!(at(0.5, 0.5, 0.025, 1.0), Passage::Doubtful, "it starts within the box");
        assert_eq!(at(0.0, 0.5, -1.0, 1.0), Passage::Doubtful, "it passes the border");
    }

    #[test]
    fn a_tile_without_a_frame_is_in_doubt_or_missed() {
        let line = [0.0, 1.0, 2.0, 3.0].map(|i| [i; 4].map(|x| x * DVec3::X));
        let tile = Sheared::around(&line);
        let up = |x: f64| {
            let ray = Ray::segment(DVec3::new(x, 0.0, -1.0), DVec3::new(x, 0.0, 1.0));
            tile.passage(&tile.seen(&ray), ray.range)
        };
        assert_eq!((up(1.0), up(4.0)), (Passage::Doubtful, Passage::Misses));
    }
}
