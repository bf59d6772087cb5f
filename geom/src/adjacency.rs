//! Contacts of two patches: along an edge, in a vertex, in a T; and those that no scene should have, overlaps
//! and crossings.
//!
//! Lengths below 1e-6 of the smaller patch's extent count as zero. Edges are compared as curves, by points
//! along them, so that two patches need not have the same parametrisation, or even shape, to share one.

use crate::{Aabb, Border, LOOSE, Patch, PlanarRegion, Ray, intersection, polygon_area, sides};
use glam::DVec3;

/// Where along a border it is compared with another.
const PLACES: [f64; 5] = [-1.0, -0.55, 0.05, 0.6, 1.0];

/// Contact of two patches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Adjacency {
    /// They share area, as no two surfaces of a scene should.
    Overlap,
    /// One passes through the other at `at`.
    Crossing {
        /// A point of both, to two digits of their extent.
        at: DVec3,
    },
    /// They share a whole edge.
    Edge,
    /// An edge of one, or part of it where both are straight and flat, lies inside the other's face, or along
    /// part of its edge.
    Tee,
    /// They share single points.
    Vertex,
}

impl Adjacency {
    /// Contact of `first` and `second`; None if they do not touch. Where several relations hold it is the one
    /// listed first in [`Adjacency`].
    pub fn of(first: &Patch, second: &Patch) -> Option<Adjacency> {
        let extents = [first, second].map(|patch| patch.bounds().diagonal());
        let tolerance = LOOSE * extents[0].min(extents[1]);
        let boxes = [first, second].map(|patch| patch.bounds().inflate(tolerance));
        if !boxes[0].overlaps(&boxes[1]) {
            return None;
        }
        if shares_area(first, second, tolerance) {
            return Some(Adjacency::Overlap);
        }
        let crossing = crossing(first, second, tolerance).or_else(|| crossing(second, first, tolerance));
        if let Some(at) = crossing {
            return Some(Adjacency::Crossing { at });
        }
        let [a, b] = [first, second].map(|patch| whole_borders(patch, tolerance));
        if a.iter().any(|x| b.iter().any(|y| coincide(x, y, tolerance))) {
            Some(Adjacency::Edge)
        } else if a.iter().any(|x| lies_on(x, second, &b, tolerance))
            || b.iter().any(|y| lies_on(y, first, &a, tolerance))
        {
            Some(Adjacency::Tee)
        } else {
            let meets = has_corner_on(first, second, tolerance) || has_corner_on(second, first, tolerance);
            meets.then_some(Adjacency::Vertex)
        }
    }
}

/// The borders that are not collapsed to a point.
fn whole_borders<'a>(patch: &Patch<'a>, tolerance: f64) -> Vec<Border<'a>> {
    patch.borders().into_iter().filter(|border| border.extent() > tolerance).collect()
}

/// Whether they share area: in a plane by the area itself, else if inner points of one lie on the other and
/// face along its normal.
fn shares_area(first: &Patch, second: &Patch, tolerance: f64) -> bool {
    if let (Patch::Flat(a), Patch::Flat(b)) = (first, second) {
        return share_plane_area(a, b, tolerance);
    }
    let shares = |a: &Patch, b: &Patch| {
        let around = b.bounds().inflate(tolerance);
        let on = |(x, normal): &(DVec3, DVec3)| {
            around.contains(*x) && {
                let (foot, other) = b.foot(*x);
                foot.distance(*x) <= tolerance && normal.dot(other).abs() > 1.0 - 1e-6
            }
        };
        // A single point may be where one surface rests on the other.
        a.inner_samples().into_iter().filter(on).nth(1).is_some()
    };
    shares(first, second) || shares(second, first)
}

/// Whether two planar regions share area: one lies in the plane of the other, and their convex pieces share
/// more than outlines within `tolerance` of each other enclose, or more than 1e-3 of the smaller region.
fn share_plane_area(a: &PlanarRegion, b: &PlanarRegion, tolerance: f64) -> bool {
    let lies_in_plane = |a: &PlanarRegion, b: &PlanarRegion| {
        a.outer().iter().all(|x| (*x - b.origin()).dot(b.normal()).abs() <= tolerance)
    };
    if !lies_in_plane(a, b) && !lies_in_plane(b, a) {
        return false;
    }
    let pieces = [a, b].map(PlanarRegion::convex_pieces);
    let pairs = pieces[0].iter().flat_map(|p| pieces[1].iter().map(move |q| (p, q)));
    let shared: f64 = pairs.map(|(p, q)| polygon_area(&intersection(p, q, b.normal()))).sum();
    // Outlines within tolerance of each other enclose that much between them, or less.
    let strip = 8.0 * tolerance * a.extent().min(b.extent());
    shared > strip.min(1e-3 * a.area().min(b.area()))
}

/// A point where a line of `a` passes through `b`, more than 5e-3 of b's diagonal away from b's border:
/// with a smaller margin contacts along the border would count as crossings, with a larger one shallow
/// crossings would be missed.
fn crossing(a: &Patch, b: &Patch, tolerance: f64) -> Option<DVec3> {
    // Odd, so that no step ends in the middle, where crossings are likely. A crossing is found where both
    // ends of a step are farther from the other patch than the line sags between them: with fewer steps
    // strongly bent lines pass unseen, and each takes a ray. An arbitrary choice.
    const STEPS: usize = 17;
    let around = b.bounds().inflate(tolerance);
    let borders = b.borders();
    let margin = 5e-3 * around.diagonal();
    let inner = |x: DVec3| borders.iter().all(|border| border.point(border.nearest(x)).distance(x) > margin);
    a.lines().iter().find_map(|line| {
        let steps = if matches!(line, Border::Segment(..)) { 1 } else { STEPS };
        let place = |k: usize| 2.0 * k as f64 / steps as f64 - 1.0;
        (0..steps).find_map(|k| {
            let (w0, w1) = (place(k), place(k + 1));
            let (p, q) = (line.point(w0), line.point(w1));
            if !Aabb::around([p, q]).overlaps(&around) {
                return None;
            }
            let (at, normal) = b.pierced(&Ray::segment(p, q))?;
            let sag = line.point(0.5 * (w0 + w1)).distance(0.5 * (p + q));
            let [before, after] = [p, q].map(|x| (x - at).dot(normal));
            let through = before * after < 0.0 && before.abs().min(after.abs()) > sag + tolerance;
            (through && inner(at)).then_some(at)
        })
    })
}

/// Whether two borders coincide as a whole.
fn coincide(a: &Border, b: &Border, tolerance: f64) -> bool {
    let meet = |w: f64, z: f64| a.point(w).distance(b.point(z)) <= tolerance;
    let direct = meet(-1.0, -1.0) && meet(1.0, 1.0);
    let opposite = meet(-1.0, 1.0) && meet(1.0, -1.0);
    (direct || opposite) && lies_along(a, b, tolerance) && lies_along(b, a, tolerance)
}

/// Whether all of `a` lies on `b`.
fn lies_along(a: &Border, b: &Border, tolerance: f64) -> bool {
    PLACES.iter().map(|w| a.point(*w)).all(|x| b.point(b.nearest(x)).distance(x) <= tolerance)
}

/// Whether a border lies on the patch `other`, inside its face or along one of its `others`.
fn lies_on(border: &Border, other: &Patch, others: &[Border], tolerance: f64) -> bool {
    if others.iter().any(|edge| share_stretch(border, edge, tolerance)) {
        return true;
    }
    if let (Border::Segment(p, q), Patch::Flat(region)) = (border, other) {
        return reaches_inside(*p, *q, region, tolerance);
    }
    PLACES.iter().all(|w| is_on(border.point(*w), other, tolerance))
}

fn is_on(x: DVec3, patch: &Patch, tolerance: f64) -> bool {
    // A foot on a curved patch is dear.
    let is_near = matches!(patch, Patch::Flat(_)) || patch.bounds().inflate(tolerance).contains(x);
    is_near && patch.foot(x).0.distance(x) <= tolerance
}

/// Whether a stretch of the segment from `p` to `q` lies in `region`.
fn reaches_inside(p: DVec3, q: DVec3, region: &PlanarRegion, tolerance: f64) -> bool {
    let off_plane = |x: DVec3| (x - region.origin()).dot(region.normal()).abs() > tolerance;
    if off_plane(p) || off_plane(q) {
        return false;
    }
    let pieces = region.convex_pieces();
    let mut parts: Vec<[f64; 2]> = pieces
        .iter()
        .map(|piece| stretch_in_piece(p, q, piece, region.normal(), 1e-3 * tolerance))
        .filter(|[low, high]| low < high)
        .collect();
    parts.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let least = 4.0 * tolerance / p.distance(q);
    let mut joined = [f64::INFINITY, f64::NEG_INFINITY];
    parts.into_iter().any(|[low, high]| {
        let continues = low <= joined[1] + least;
        joined = if continues { [joined[0], joined[1].max(high)] } else { [low, high] };
        joined[1] - joined[0] > least
    })
}

/// The stretch, w from and to, of the segment within `room` of a convex piece; ends out of order if there is
/// none.
fn stretch_in_piece(p: DVec3, q: DVec3, piece: &[DVec3], normal: DVec3, room: f64) -> [f64; 2] {
    sides(piece).fold([-1.0, 1.0], |[low, high]: [f64; 2], [r, s]| {
        let inward = normal.cross(s - r).normalize();
        let [start, end] = [p, q].map(|x| (x - r).dot(inward) + room);
        let crossing = (start + end) / (start - end);
        match (start < 0.0, end < 0.0) {
            (false, false) => [low, high],
            (true, false) => [low.max(crossing), high],
            (false, true) => [low, high.min(crossing)],
            (true, true) => [1.0, -1.0],
        }
    })
}

/// Whether a stretch of `a` that has length lies along `b`.
fn share_stretch(a: &Border, b: &Border, tolerance: f64) -> bool {
    let on = |edge: &Border, x: DVec3| edge.point(edge.nearest(x)).distance(x) <= tolerance;
    let own = [-1.0, 1.0].into_iter().filter(|w| on(b, a.point(*w)));
    let foreign = [-1.0, 1.0].map(|z| b.point(z)).into_iter().filter(|x| on(a, *x)).map(|x| a.nearest(x));
    let ends: Vec<f64> = own.chain(foreign).collect();
    let (low, high) = ends.iter().fold((1.0_f64, -1.0_f64), |(low, high), w| (low.min(*w), high.max(*w)));
    let between = |w: f64| low + 0.5 * (1.0 + w) * (high - low);
    let long = low < high
        && a.point(low).distance(a.point(high)).max(a.point(low).distance(a.point(between(0.0))))
            > 2.0 * tolerance;
    long && PLACES.iter().all(|w| on(b, a.point(between(*w))))
}

/// Whether a corner of `a` lies on `b`.
fn has_corner_on(a: &Patch, b: &Patch, tolerance: f64) -> bool {
    a.borders().iter().any(|border| is_on(border.point(-1.0), b, tolerance))
}
