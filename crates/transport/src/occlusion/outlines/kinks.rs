//! Lines on the outer element along which what is hidden has a kink.
//!
//! Seen from x, an edge of a blocker passes a corner of the inner element, or a corner of a blocker an edge
//! of the inner element, where x crosses the plane through that edge and that corner. Between these planes
//! the hidden part of the inner element keeps its corners, and its integral is smooth in x. Rules whose cells
//! end at the planes converge by the number of their points; halved cells across a kink only by the power 3/2
//! of their number. Where three edges cross, the kink is curved; it is left to halving.

use radiosity_geom::{COINCIDENT, DVec3, PARALLEL_DIRECTIONS, sides};
use radiosity_kernel::contact::clip::Facet;
use radiosity_visibility::Visibility;

/// Most lines that an element is cut along, into 79 parts at the most: where blockers are many, halving cells
/// is cheaper.
const MOST: usize = 12;

/// A line on a plane: a point of it, and the direction across it in the plane.
pub(super) struct Line {
    /// A point of the line.
    pub(super) point: DVec3,
    /// Unit vector in the plane, normal to the line.
    pub(super) across: DVec3,
}

/// The lines across the facets of the outer element; none if there are too many.
pub(super) fn kinks(
    outer: &[Facet],
    inner: &[Facet],
    bodies: &[usize],
    visibility: &Visibility,
) -> Vec<Line> {
    let Some(first) = outer.first() else { return Vec::new() };
    let points: Vec<DVec3> = outer.iter().flat_map(|facet| facet.corners.iter().copied()).collect();
    let seen: Vec<DVec3> = inner.iter().flat_map(|facet| facet.corners.iter().copied()).collect();
    let mut lines: Vec<Line> = Vec::new();
    let mut add = |edge: [DVec3; 2], corner: DVec3| {
        if let Some(line) = line([edge[0], edge[1], corner], first, &points)
            && !lines.iter().any(|own| own.is(&line, &points))
        {
            lines.push(line);
        }
        lines.len() <= MOST
    };
    for edge in bodies.iter().flat_map(|body| visibility.blocker_edges(*body)) {
        if !edge.may_part(&points, &seen) {
            continue;
        }
        let passes_corners = seen.iter().all(|corner| add(edge.ends, *corner));
        let borders = || inner.iter().flat_map(|facet| sides(&facet.corners));
        let mut passes_edges = || edge.ends.into_iter().all(|end| borders().all(|side| add(side, end)));
        if !(passes_corners && passes_edges()) {
            return Vec::new();
        }
    }
    lines
}

/// Where the plane through three points crosses the plane of `facet` between `points`.
fn line([a, b, c]: [DVec3; 3], facet: &Facet, points: &[DVec3]) -> Option<Line> {
    let normal = (b - a).cross(c - a);
    let size = (b - a).length() * (c - a).length();
    let normal = (normal.length() > COINCIDENT * size).then(|| normal.normalize())?;
    let across = normal - normal.dot(facet.normal) * facet.normal;
    let steepness = across.length();
    let across = (steepness > COINCIDENT).then(|| across / steepness)?;
    // The point of both planes nearest to the facet's first corner.
    let point = facet.corners[0] + across * ((a - facet.corners[0]).dot(normal) / steepness);
    let line = Line { point, across };
    let (low, high) = line.range(points);
    let least = COINCIDENT * (high - low);
    (low < -least && high > least).then_some(line)
}

impl Line {
    /// Least and largest distance of points from the line, positive on the side of `across`.
    fn range(&self, points: &[DVec3]) -> (f64, f64) {
        let distances = points.iter().map(|x| (x - self.point).dot(self.across));
        distances.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), d| (low.min(d), high.max(d)))
    }

    /// Whether both are one line where they cross the points.
    fn is(&self, other: &Line, points: &[DVec3]) -> bool {
        let (low, high) = self.range(points);
        let is_parallel = self.across.cross(other.across).length() < PARALLEL_DIRECTIONS;
        is_parallel && (other.point - self.point).dot(self.across).abs() < COINCIDENT * (high - low)
    }
}
