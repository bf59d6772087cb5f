//! A closed ring of vertices in a plane: its area, what it encloses, what lies on it, where it meets itself
//! or another ring.

use glam::{DVec2, DVec3};

use super::places::{Places, around};
use crate::tolerances::COINCIDENT;
use crate::{Aabb, ShapeError, sides};

/// A closed ring of vertices.
#[derive(Clone, Debug)]
pub(super) struct Ring {
    points: Vec<DVec2>,
    bounds: Aabb,
    edges: Places,
}

impl PartialEq for Ring {
    fn eq(&self, other: &Self) -> bool {
        self.points == other.points
    }
}

impl Ring {
    pub(super) fn new(points: Vec<DVec2>) -> Self {
        let bounds = around(points.iter().copied());
        let n = points.len();
        let edges = Places::new((0..n).map(|from| around([points[from], points[(from + 1) % n]])));
        Self { points, bounds, edges }
    }

    pub(super) fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The smallest box around it.
    pub(super) fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Area inside, positive for counter-clockwise rings.
    pub(super) fn signed_area(&self) -> f64 {
        signed_area(&self.points)
    }

    /// The edge from a vertex to the next.
    fn edge(&self, from: usize) -> [DVec2; 2] {
        [self.points[from], self.points[(from + 1) % self.points.len()]]
    }

    /// Whether the ring winds around `at` an odd number of times.
    pub(super) fn encloses(&self, at: DVec2) -> bool {
        let may_cross = |b: &Aabb| b.min.y <= at.y && at.y <= b.max.y && at.x <= b.max.x;
        let mut crossings = 0;
        self.edges.any(may_cross, |edge| {
            let [p, q] = self.edge(edge);
            let crosses =
                (p.y > at.y) != (q.y > at.y) && at.x < p.x + (at.y - p.y) / (q.y - p.y) * (q.x - p.x);
            crossings += usize::from(crosses);
            false
        });
        crossings % 2 == 1
    }

    /// Whether `at` lies on the ring itself, up to a distance.
    pub(super) fn touches(&self, at: DVec2, tolerance: f64) -> bool {
        let is_close = |b: &Aabb| b.inflate(tolerance).contains(at.extend(0.0));
        self.edges.any(is_close, |edge| to_segment(at, self.edge(edge)) <= tolerance)
    }

    /// Vertices and edge midpoints.
    pub(super) fn samples(&self) -> impl Iterator<Item = DVec2> + '_ {
        sides(&self.points).flat_map(|[p, q]| [p, 0.5 * (p + q)])
    }

    /// Two edges that meet elsewhere than at their common vertex, the first of all such pairs.
    pub(super) fn self_contact(&self, tolerance: f64) -> Option<(usize, usize)> {
        let last = self.points.len() - 1;
        let meet = |first: usize, second: usize| {
            let (e, f) = (self.edge(first), self.edge(second));
            if second == first + 1 {
                folds_back(e, f, tolerance)
            } else if first == 0 && second == last {
                folds_back(f, e, tolerance)
            } else {
                // Edges on one line, however far from each other, cross by rounding.
                properly_cross(e, f, tolerance) || segments_apart(e, f) <= tolerance
            }
        };
        (0..=last).find_map(|first| {
            let near = self.edges.near(&around(self.edge(first)).inflate(tolerance));
            let second = near.into_iter().find(|second| *second > first && meet(first, *second));
            second.map(|second| (first, second))
        })
    }

    /// Whether any edges of the two rings properly cross.
    pub(super) fn crosses(&self, other: &Self, tolerance: f64) -> bool {
        sides(&self.points).any(|e| {
            let own = around(e);
            let crosses = |edge: usize| properly_cross(e, other.edge(edge), tolerance);
            other.edges.any(|b| b.overlaps(&own), crosses)
        })
    }

    /// Whether two holes share more than boundary.
    pub(super) fn overlaps(&self, other: &Self, tolerance: f64) -> bool {
        let inside = |ring: &Self, at: DVec2| ring.encloses(at) && !ring.touches(at, tolerance);
        let enters =
            || self.samples().any(|at| inside(other, at)) || other.samples().any(|at| inside(self, at));
        let [a, b] = [self, other].map(Self::signed_area);
        let equal = (a - b).abs() <= tolerance * a.abs().sqrt() && a * b > 0.0;
        let same = || equal && self.samples().all(|at| other.touches(at, tolerance));
        enters() || self.crosses(other, tolerance) || same()
    }
}

/// ½ Σ xᵢ × xᵢ₊₁, positive for counter-clockwise polygons.
pub(super) fn signed_area(points: &[DVec2]) -> f64 {
    0.5 * sides(points).map(|[p, q]| (p - points[0]).perp_dot(q - points[0])).sum::<f64>()
}

/// The crossing of an outline in space whose edges cancel in area, such as a symmetric bow tie.
pub(super) fn bow_tie(outline: &[DVec3]) -> Option<ShapeError> {
    let origin = outline[0];
    let corner = |k: usize| (outline[k] - origin).cross(outline[(k + 1) % outline.len()] - origin);
    let normal =
        (1..outline.len()).map(corner).max_by(|a, b| a.length().total_cmp(&b.length()))?.try_normalize()?;
    let first = normal.any_orthonormal_vector();
    let second = normal.cross(first);
    let flat: Vec<DVec2> =
        outline.iter().map(|x| DVec2::new((*x - origin).dot(first), (*x - origin).dot(second))).collect();
    let extent = flat.iter().map(|x| x.length()).fold(0.0, f64::max);
    let (first, second) = Ring::new(flat).self_contact(COINCIDENT * extent)?;
    Some(ShapeError::SelfCrossing { field: "vertices".into(), first, second })
}

/// Distance from `at` to the segment.
pub(super) fn to_segment(at: DVec2, [p, q]: [DVec2; 2]) -> f64 {
    let along = (at - p).dot(q - p) / (q - p).length_squared();
    at.distance(p.lerp(q, along.clamp(0.0, 1.0)))
}

/// Whether `second`, which starts where `first` ends, runs back along it.
fn folds_back(first: [DVec2; 2], second: [DVec2; 2], tolerance: f64) -> bool {
    let back = (first[1] - first[0]).dot(second[1] - second[0]) < 0.0;
    back && (to_segment(second[1], first) <= tolerance || to_segment(first[0], second) <= tolerance)
}

/// Least distance between segments that do not cross.
fn segments_apart(e: [DVec2; 2], f: [DVec2; 2]) -> f64 {
    [to_segment(e[0], f), to_segment(e[1], f), to_segment(f[0], e), to_segment(f[1], e)]
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

/// Whether the segments cross in one inner point of both, each reaching past the other by more than
/// `tolerance`.
fn properly_cross(e: [DVec2; 2], f: [DVec2; 2], tolerance: f64) -> bool {
    let astride = |[p, q]: [DVec2; 2], [r, s]: [DVec2; 2]| {
        let normal = (q - p).perp() / (q - p).length();
        let (a, b) = (normal.dot(r - p), normal.dot(s - p));
        a.min(b) < -tolerance && a.max(b) > tolerance
    };
    astride(e, f) && astride(f, e)
}
