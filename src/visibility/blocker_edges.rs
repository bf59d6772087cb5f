//! Edges of planar blockers, which bound what they hide.
//!
//! What a polygon hides from x is bounded by the planes through x and its sides. Of a convex body only those edges count that
//! lie between a face with x before it and one with x behind: where all points of a convex set lie before both, or behind both,
//! the edge bounds nothing for any of them.

use radiosity_geom::{COINCIDENT, DVec3, sides};
use smallvec::SmallVec;

/// An edge of a blocker.
#[derive(Debug)]
pub struct Rim {
    /// Its ends.
    pub ends: [DVec3; 2],
    /// A point and the unit normal out of the body of each of the two faces that meet there; none of a lone polygon.
    pub(super) faces: SmallVec<[(DVec3, DVec3); 2]>,
}

/// On which side of a plane points lie.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Before,
    Behind,
    Both,
}

impl Rim {
    /// Those of a lone polygon.
    pub(super) fn all_of(polygon: &[DVec3]) -> impl Iterator<Item = Self> {
        sides(polygon).map(|ends| Self { ends, faces: SmallVec::new() })
    }

    /// Whether it may bound what is hidden from some point of the convex hull of `cell`, of some of that of `polygon`.
    pub fn may_part(&self, cell: &[DVec3], polygon: &[DVec3]) -> bool {
        let sides = self.faces.iter().map(|(point, outward)| side(cell, *point, *outward));
        let is_outline = match sides.collect::<SmallVec<[Side; 2]>>()[..] {
            [first, second] => first != second || first == Side::Both,
            _ => true,
        };
        is_outline && self.parts(cell, polygon)
    }

    /// Whether planes through it and a point of `cell` may part `polygon`: the determinant of both and the edge is linear in
    /// either, so that its signs at the corners are those of the hulls.
    fn parts(&self, cell: &[DVec3], polygon: &[DVec3]) -> bool {
        let [a, b] = self.ends;
        let normals = cell.iter().map(|x| (x - a).cross(b - a));
        let (mut above, mut below) = (false, false);
        for normal in normals {
            let margin = COINCIDENT * normal.length();
            for y in polygon {
                let height = (y - a).dot(normal);
                above |= height > margin * y.distance(a);
                below |= height < -margin * y.distance(a);
            }
        }
        above && below
    }
}

/// The side of a plane that points lie on, but for rounding.
fn side(points: &[DVec3], point: DVec3, outward: DVec3) -> Side {
    let height = |x: &DVec3| (x - point).dot(outward) / (x - point).length().max(f64::MIN_POSITIVE);
    if points.iter().all(|x| height(x) >= -COINCIDENT) {
        Side::Before
    } else if points.iter().all(|x| height(x) <= COINCIDENT) {
        Side::Behind
    } else {
        Side::Both
    }
}
