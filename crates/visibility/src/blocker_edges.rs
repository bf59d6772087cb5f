//! Edges of planar blockers, which bound shadows.
//!
//! The planes through x and the sides of a polygon bound what it hides from x. Of a convex body only the
//! edges between a face that x lies in front of and one that x lies behind count. If all points of a convex
//! set lie in front of both faces, or behind both, the edge bounds no shadow for any of them.

use radiosity_geom::{COINCIDENT, DVec3, Plane, sides};
use smallvec::SmallVec;

/// Distance of the corners of the octahedron that stands for a ball from its centre, in radii: the middles of
/// its edges lie at 0.85.
const BEYOND_BALL: f64 = 1.2;

/// An edge of a blocker.
#[derive(Debug)]
pub struct BlockerEdge {
    /// Its ends.
    pub ends: [DVec3; 2],
    /// The planes of the two faces that meet there, with outward normals; empty for a single polygon.
    pub(super) faces: SmallVec<[Plane; 2]>,
}

/// The side of a plane on which points lie.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Before,
    Behind,
    Both,
}

impl BlockerEdge {
    /// The edges of a single polygon.
    pub(super) fn all_of(polygon: &[DVec3]) -> impl Iterator<Item = Self> {
        sides(polygon).map(Self::alone)
    }

    /// An edge that stands for a part of an outline from any side.
    pub(super) fn alone(ends: [DVec3; 2]) -> Self {
        Self { ends, faces: SmallVec::new() }
    }

    /// Edges that stand for the outline of a ball from any side: those of an octahedron whose corners lie
    /// outside the ball, and the middles of whose edges inside, by about as much.
    pub(super) fn about_ball(center: DVec3, radius: f64) -> impl Iterator<Item = Self> {
        let corner = move |k: usize| {
            let axis = [DVec3::X, DVec3::Y, DVec3::Z][k / 2];
            center + BEYOND_BALL * radius * if k.is_multiple_of(2) { axis } else { -axis }
        };
        let pairs = (0..6).flat_map(|k| (0..k).map(move |l| [k, l])).filter(|[k, l]| k / 2 != l / 2);
        pairs.map(move |pair: [usize; 2]| Self::alone(pair.map(corner)))
    }

    /// Whether the edge may bound what some point in the hull of `cell` does not see of the hull of
    /// `polygon`.
    pub fn may_part(&self, cell: &[DVec3], polygon: &[DVec3]) -> bool {
        let sides = self.faces.iter().map(|face| side(cell, face));
        let is_outline = match sides.collect::<SmallVec<[Side; 2]>>()[..] {
            [first, second] => first != second || first == Side::Both,
            _ => true,
        };
        is_outline && self.parts(cell, polygon)
    }

    /// Whether a plane through the edge and a point of `cell` may divide `polygon`. The determinant of both
    /// points and the edge is linear in each point, so its signs at the corners decide for the hulls.
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

/// The side of a plane on which points lie, within rounding.
fn side(points: &[DVec3], plane: &Plane) -> Side {
    let height = |x: &DVec3| plane.height(*x) / x.distance(plane.point).max(f64::MIN_POSITIVE);
    if points.iter().all(|x| height(x) >= -COINCIDENT) {
        Side::Before
    } else if points.iter().all(|x| height(x) <= COINCIDENT) {
        Side::Behind
    } else {
        Side::Both
    }
}
