//! Contact of two pieces along an edge, and the cuts that make it one whole edge of both.
//!
//! Two flat pieces in planes that cross touch along the part cd of the crossing line that lies in both. Where
//! cd is no whole side of a piece, the piece is cut along cd, and then at c and d: a parallelogram with cd
//! along a side into parallelograms, all else into triangles with the corner that is farthest from cd.

use radiosity_elements::patch::Patch;
use radiosity_geom::{COINCIDENT, DVec3, PARALLEL_PLANES, Plane, clip_polygon, sides, touching};

use super::piece::Piece;

/// The contact of two pieces.
#[derive(Debug)]
pub(super) enum Contact<'a> {
    /// They share no edge.
    None,
    /// They share a whole side of both, at which they are charted with t = 0.
    Edge(Box<[Piece<'a>; 2]>),
    /// They share an edge that is no whole side of both, and are cut there.
    Cut([Vec<Piece<'a>>; 2]),
}

impl<'a> Contact<'a> {
    /// The contact of two pieces.
    pub(super) fn of(p: &Piece<'a>, q: &Piece<'a>) -> Self {
        if let Some(edge) = common_side(p, q) {
            return Self::Edge(Box::new(edge));
        }
        let Some(segment) = crossing(p, q) else { return Self::None };
        Self::Cut([cut(p, q, segment), cut(q, p, segment)])
    }
}

/// The pieces charted at their common side, along which they run at equal speed, in either direction. A side
/// that is collapsed to a point is none.
pub(super) fn common_side<'a>(p: &Piece<'a>, q: &Piece<'a>) -> Option<[Piece<'a>; 2]> {
    let (own, theirs) = (p.sides(), q.sides());
    let starts = own.iter().chain(&theirs).map(|[start, ..]| *start);
    let size = starts.map(|x| x.distance(own[0][0])).fold(0.0, f64::max);
    let coincide = |x: DVec3, y: DVec3| x.distance(y) <= COINCIDENT * size;
    for (k, [start, middle, end]) in own.iter().enumerate() {
        if coincide(*start, *middle) {
            continue;
        }
        let meets = |[x, y, z]: [DVec3; 3]| coincide(*start, x) && coincide(*middle, y) && coincide(*end, z);
        let other = theirs.iter().position(|[x, y, z]| meets([*x, *y, *z]) || meets([*z, *y, *x]));
        if let Some(other) = other {
            return Some([p.on_side(k), q.on_side(other)]);
        }
    }
    None
}

/// The part of the crossing line of the planes of two flat pieces that lies in both.
fn crossing(p: &Piece, q: &Piece) -> Option<[DVec3; 2]> {
    let planes = [p, q].map(|piece| match piece.patch {
        Patch::Flat { corners, normal } => Some(Plane { point: corners[0], normal }),
        Patch::Curved { .. } => None,
    });
    let [Some(own), Some(other)] = planes else { return None };
    let along = own.normal.cross(other.normal);
    if along.length() <= PARALLEL_PLANES {
        return None;
    }
    let along = along.normalize();
    let tolerance = touching(p.element.extent.min(q.element.extent), own.point.distance(other.point));
    let [first, second] = [on_plane(&p.patch, &other, tolerance), on_plane(&q.patch, &own, tolerance)];
    let [[a, b], [c, d]] = [ends(&first, along)?, ends(&second, along)?];
    let reach = |x: DVec3| x.dot(along);
    let low = if reach(a) >= reach(c) { a } else { c };
    let high = if reach(b) <= reach(d) { b } else { d };
    (reach(high) - reach(low) > tolerance).then_some([low, high])
}

/// The points where the border of a flat patch meets a plane.
fn on_plane(patch: &Patch, plane: &Plane, tolerance: f64) -> Vec<DVec3> {
    let height = |x: DVec3| {
        let height = plane.height(x);
        if height.abs() <= tolerance { 0.0 } else { height }
    };
    let mut met = Vec::new();
    for [x, y] in sides(&patch.polygon()) {
        let (from, to) = (height(x), height(y));
        if from == 0.0 {
            met.push(x);
        }
        if from * to < 0.0 {
            met.push(x.lerp(y, from / (from - to)));
        }
    }
    met
}

/// The first and the last of points along a direction.
fn ends(points: &[DVec3], along: DVec3) -> Option<[DVec3; 2]> {
    let order = |x: &&DVec3, y: &&DVec3| x.dot(along).total_cmp(&y.dot(along));
    Some([*points.iter().min_by(order)?, *points.iter().max_by(order)?])
}

/// The piece `p` cut so that the segment is a whole side of those parts that it bounds.
fn cut<'a>(p: &Piece<'a>, q: &Piece, segment: [DVec3; 2]) -> Vec<Piece<'a>> {
    let (Patch::Flat { normal, .. }, Patch::Flat { normal: across, .. }) = (&p.patch, &q.patch) else {
        return vec![p.clone()];
    };
    let polygon = p.patch.polygon();
    let halves = [*across, -*across].map(|side| clip_polygon(&polygon, segment[0], side));
    let open = halves.iter().filter(|half| half.len() > 2);
    let tolerance = touching(p.element.extent.min(q.element.extent), 0.0);
    let polygons: Vec<Vec<DVec3>> =
        open.flat_map(|half| with_side(&cleaned(half, tolerance), *normal, segment, tolerance)).collect();
    p.parts(&polygons)
}

/// A polygon without corners that repeat the one before.
fn cleaned(polygon: &[DVec3], tolerance: f64) -> Vec<DVec3> {
    let apart = sides(polygon).filter(|[x, y]| x.distance(*y) > tolerance);
    apart.map(|[x, _]| x).collect()
}

/// Triangles and parallelograms that cover a convex polygon, of which those that touch the segment, which
/// lies on the border, have it as a whole side.
fn with_side(polygon: &[DVec3], normal: DVec3, [c, d]: [DVec3; 2], tolerance: f64) -> Vec<Vec<DVec3>> {
    let mut bordered = polygon.to_vec();
    for end in [c, d] {
        bordered = with_corner(&bordered, end, tolerance);
    }
    if let [a, b, _, e] = polygon
        && is_parallelogram(polygon)
    {
        let parallel = |side: &&DVec3| side.cross(d - c).length() <= tolerance * side.length();
        let along = [*b - *a, *e - *a];
        if let Some(k) = along.iter().position(|side| parallel(&side)) {
            let step = normal.cross(along[1 - k]).normalize();
            return strips(polygon, step, [c, d], tolerance);
        }
    }
    fan(&bordered, [c, d])
}

/// The polygon with `x` among its corners, if it lies on the border.
fn with_corner(polygon: &[DVec3], x: DVec3, tolerance: f64) -> Vec<DVec3> {
    let mut corners = Vec::with_capacity(polygon.len() + 1);
    let is_corner = polygon.iter().any(|corner| corner.distance(x) <= tolerance);
    for [from, to] in sides(polygon) {
        corners.push(from);
        let share = (x - from).dot(to - from) / from.distance_squared(to);
        let inside = share > 0.0 && share < 1.0;
        if !is_corner && inside && x.distance(from.lerp(to, share)) <= tolerance {
            corners.push(x);
        }
    }
    corners
}

fn is_parallelogram(polygon: &[DVec3]) -> bool {
    let [a, b, c, d] = polygon else { return false };
    ((*b - *a) - (*c - *d)).length() <= COINCIDENT * a.distance(*c)
}

/// A polygon cut by the planes through two points across `step`.
fn strips(polygon: &[DVec3], step: DVec3, ends: [DVec3; 2], tolerance: f64) -> Vec<Vec<DVec3>> {
    let mut parts = vec![polygon.to_vec()];
    for end in ends {
        let both =
            |part: &Vec<DVec3>| [step, -step].map(|side| cleaned(&clip_polygon(part, end, side), tolerance));
        parts = parts.iter().flat_map(both).filter(|part| part.len() > 2).collect();
    }
    parts
}

/// Triangles from the corner that is farthest from the segment's line to all sides that do not meet there.
fn fan(polygon: &[DVec3], [c, d]: [DVec3; 2]) -> Vec<Vec<DVec3>> {
    let distance = |x: DVec3| (x - c).cross(d - c).length();
    let order = |x: &&DVec3, y: &&DVec3| distance(**x).total_cmp(&distance(**y));
    let Some(apex) = polygon.iter().max_by(order).copied() else { return Vec::new() };
    sides(polygon).filter(|side| !side.contains(&apex)).map(|[x, y]| vec![apex, x, y]).collect()
}
