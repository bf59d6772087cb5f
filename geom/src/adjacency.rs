//! Adjacency of two patches: the same, touching along an edge, in a vertex, in a T, near, or apart; and two faults,
//! overlapping or passing through each other.
//!
//! Lengths below 1e-6 of the smaller patch's extent count as zero. Edges are compared as curves, by points along them,
//! so that two patches need not have the same parametrisation, or even shape, to share one.

use crate::{Aabb, Border, Patch, PlanarRegion, Ray, clip_polygon, polygon_area};
use glam::DVec3;

/// Lengths below this multiple of the smaller extent count as zero. Chosen; not tuned.
const TOUCH: f64 = 1e-6;
/// Patches closer than this multiple of the larger extent are near: their kernel varies strongly. As for near pairs of
/// elements (`transport` of the main crate).
const NEAR: f64 = 0.25;
/// Places at which borders are compared, in no symmetry. Chosen; not tuned.
const PLACES: [f64; 5] = [-1.0, -0.55, 0.05, 0.6, 1.0];

/// How two patches, the first and the second, lie to each other.
#[derive(Clone, Debug, PartialEq)]
pub enum Adjacency {
    /// Both cover the same points.
    Same,
    /// They coincide over part of their area, as no two surfaces of a scene should.
    Overlap,
    /// One passes through the other at `at`.
    Crossing {
        /// A point of both, to two digits of their extent.
        at: DVec3,
    },
    /// They share whole edges.
    Edges(Vec<Seam>),
    /// An edge of one, or part of it where both are straight and flat, lies inside the other's face, or along
    /// part of its edge.
    Tee(Vec<Tee>),
    /// They share single points.
    Vertices(Vec<DVec3>),
    /// They do not touch but are close, compared with their size.
    Near {
        /// Least distance, to a few digits.
        gap: f64,
    },
    /// They are well apart: by more than a quarter of the larger one's extent.
    Apart,
}

/// A whole edge that two patches share.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seam {
    /// Indices into [`Patch::borders`] of the first and of the second.
    pub borders: [usize; 2],
    /// Whether the two run in opposite directions, as they do where the patches face the same way.
    pub reversed: bool,
    /// Whether equal w (opposite w, where reversed) give equal points. Otherwise [`Border::nearest`] gives
    /// the correspondence.
    pub matched: bool,
    /// The largest angle between the normals along the edge, in radians: 0 where the patches join smoothly
    /// and face the same way.
    pub bend: f64,
}

/// An edge of one patch that lies on the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tee {
    /// Which patch the edge belongs to: 0 the first, 1 the second.
    pub owner: usize,
    /// Index of the edge into the owner's [`Patch::borders`].
    pub border: usize,
    /// The edge of the other patch it lies along, or `None` where it lies inside the face.
    pub along: Option<usize>,
    /// The stretch of the owner's edge in contact, w from and to.
    pub range: [f64; 2],
}

impl Adjacency {
    /// How `first` and `second` lie to each other. Where several relations hold the one listed first in
    /// [`Adjacency`] is returned.
    pub fn of(first: &Patch, second: &Patch) -> Adjacency {
        let extents = [first, second].map(|patch| patch.bounds().diagonal());
        let tolerance = TOUCH * extents[0].min(extents[1]);
        let boxes = [first, second].map(|patch| patch.bounds().inflate(tolerance));
        if boxes[0].overlaps(&boxes[1])
            && let Some(contact) = contact(first, second, tolerance)
        {
            return contact;
        }
        let near = NEAR * extents[0].max(extents[1]);
        if !boxes[0].inflate(near).overlaps(&boxes[1]) {
            return Adjacency::Apart;
        }
        let gap = gap(first, second);
        if gap < near { Adjacency::Near { gap } } else { Adjacency::Apart }
    }
}

/// The strongest contact, if any.
fn contact(first: &Patch, second: &Patch, tolerance: f64) -> Option<Adjacency> {
    if let Some(shared_area) = shared_area(first, second, tolerance) {
        return Some(shared_area);
    }
    let crossing = crossing(first, second, tolerance).or_else(|| crossing(second, first, tolerance));
    if let Some(at) = crossing {
        return Some(Adjacency::Crossing { at });
    }
    let [a, b] = [first, second].map(|patch| whole_borders(patch, tolerance));
    let seams: Vec<Seam> =
        a.iter().flat_map(|x| b.iter().filter_map(|y| seam([first, second], [*x, *y], tolerance))).collect();
    if !seams.is_empty() {
        return Some(Adjacency::Edges(seams));
    }
    let mut tees = tees(0, &a, second, &b, tolerance);
    tees.extend(self::tees(1, &b, first, &a, tolerance));
    if !tees.is_empty() {
        return Some(Adjacency::Tee(tees));
    }
    let vertices = vertices(first, second, tolerance);
    (!vertices.is_empty()).then_some(Adjacency::Vertices(vertices))
}

/// The borders that are not collapsed to a point, with their indices.
fn whole_borders<'a>(patch: &Patch<'a>, tolerance: f64) -> Vec<(usize, Border<'a>)> {
    patch.borders().into_iter().enumerate().filter(|(_, border)| border.extent() > tolerance).collect()
}

/// [`Adjacency::Same`] or [`Adjacency::Overlap`]: in a plane by the area itself, else if inner points of one
/// lie on the other and face along its normal.
fn shared_area(first: &Patch, second: &Patch, tolerance: f64) -> Option<Adjacency> {
    if let (Patch::Flat(a), Patch::Flat(b)) = (first, second) {
        return shared_plane_area(a, b, tolerance);
    }
    let shared = |a: &Patch, b: &Patch| {
        let samples = a.inner_samples();
        let on = |(x, normal): &&(DVec3, DVec3)| {
            let (foot, other) = b.foot(*x);
            foot.distance(*x) <= tolerance && normal.dot(other).abs() > 1.0 - 1e-6
        };
        (samples.iter().filter(on).count(), samples.len())
    };
    let [(a, all_a), (b, all_b)] = [shared(first, second), shared(second, first)];
    if a == all_a && b == all_b {
        return Some(Adjacency::Same);
    }
    // A single point may be where one surface rests on the other.
    (a.max(b) > 1).then_some(Adjacency::Overlap)
}

/// As [`shared_area`] for regions, by the area that their convex pieces share; strips below 1e-3 of the smaller area,
/// or as wide as the tolerance, do not count (1e-3: chosen, not tuned).
fn shared_plane_area(a: &PlanarRegion, b: &PlanarRegion, tolerance: f64) -> Option<Adjacency> {
    let lies_in_plane = |a: &PlanarRegion, b: &PlanarRegion| {
        a.outer().iter().all(|x| (*x - b.origin()).dot(b.normal()).abs() <= tolerance)
    };
    if !lies_in_plane(a, b) && !lies_in_plane(b, a) {
        return None;
    }
    let pieces = [a, b].map(PlanarRegion::convex_pieces);
    let pairs = pieces[0].iter().flat_map(|p| pieces[1].iter().map(move |q| (p, q)));
    let shared: f64 = pairs.map(|(p, q)| polygon_area(&common_part(p, q, b.normal()))).sum();
    // Outlines within tolerance of each other enclose at most this area.
    let strip = 8.0 * tolerance * a.extent().min(b.extent());
    let slack = strip.min(1e-3 * a.area().min(b.area()));
    if a.area().max(b.area()) - shared <= slack {
        return Some(Adjacency::Same);
    }
    (shared > slack).then_some(Adjacency::Overlap)
}

/// The intersection of two convex polygons in a plane; `normal` is the second's.
fn common_part(a: &[DVec3], b: &[DVec3], normal: DVec3) -> Vec<DVec3> {
    let edges = b.iter().zip(b.iter().cycle().skip(1));
    edges.fold(a.to_vec(), |part, (p, q)| clip_polygon(&part, *p, normal.cross(*q - *p)))
}

/// A point where a line of `a` passes through `b`, away from b's border by 5e-3 of its diagonal (chosen, not tuned).
fn crossing(a: &Patch, b: &Patch, tolerance: f64) -> Option<DVec3> {
    // Odd, so that no step ends in the middle, where crossings are likely. Chosen; not tuned.
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

/// The seam of two borders that coincide as a whole.
fn seam(patches: [&Patch; 2], [a, b]: [(usize, Border); 2], tolerance: f64) -> Option<Seam> {
    let meet = |w: f64, z: f64| a.1.point(w).distance(b.1.point(z)) <= tolerance;
    let direct = meet(-1.0, -1.0) && meet(1.0, 1.0);
    let opposite = meet(-1.0, 1.0) && meet(1.0, -1.0);
    if !(direct || opposite) || !lies_along(&a.1, &b.1, tolerance) || !lies_along(&b.1, &a.1, tolerance) {
        return None;
    }
    // Closed edges meet in either direction at their ends; places in between decide.
    let reversed = b.1.nearest(a.1.point(0.6)) < b.1.nearest(a.1.point(0.05));
    let sign = if reversed { -1.0 } else { 1.0 };
    let matched = PLACES.iter().all(|w| meet(*w, sign * w));
    let bend = PLACES.map(|w| {
        let [m, n] = patches.map(|patch| patch.foot(a.1.point(w)).1);
        m.cross(n).length().atan2(m.dot(n))
    });
    Some(Seam { borders: [a.0, b.0], reversed, matched, bend: bend.into_iter().fold(0.0, f64::max) })
}

/// Whether all of `a` lies on `b`.
fn lies_along(a: &Border, b: &Border, tolerance: f64) -> bool {
    PLACES.iter().map(|w| a.point(*w)).all(|x| b.point(b.nearest(x)).distance(x) <= tolerance)
}

/// The borders of the patch number `owner` that lie on `other`, inside its face or along its borders.
fn tees(
    owner: usize,
    borders: &[(usize, Border)],
    other: &Patch,
    others: &[(usize, Border)],
    tolerance: f64,
) -> Vec<Tee> {
    let on_face = |x: DVec3| other.foot(x).0.distance(x) <= tolerance;
    let mut found = Vec::new();
    for (index, border) in borders {
        let along = others.iter().find_map(|(k, edge)| Some((*k, common_stretch(border, edge, tolerance)?)));
        if let Some((k, range)) = along {
            found.push(Tee { owner, border: *index, along: Some(k), range });
        } else if let (Border::Segment(p, q), Patch::Flat(region)) = (border, other) {
            let stretches = stretches_inside(*p, *q, region, tolerance);
            found.extend(stretches.into_iter().map(|range| Tee {
                owner,
                border: *index,
                along: None,
                range,
            }));
        } else if PLACES.iter().all(|w| on_face(border.point(*w))) {
            found.push(Tee { owner, border: *index, along: None, range: [-1.0, 1.0] });
        }
    }
    found
}

/// The stretches, w from and to, of the segment from `p` to `q` that lie in `region`.
fn stretches_inside(p: DVec3, q: DVec3, region: &PlanarRegion, tolerance: f64) -> Vec<[f64; 2]> {
    let off_plane = |x: DVec3| (x - region.origin()).dot(region.normal()).abs() > tolerance;
    if off_plane(p) || off_plane(q) {
        return Vec::new();
    }
    let pieces = region.convex_pieces();
    let mut parts: Vec<[f64; 2]> = pieces
        .iter()
        .map(|piece| stretch_in_piece(p, q, piece, region.normal(), 1e-3 * tolerance))
        .filter(|[low, high]| low < high)
        .collect();
    parts.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let least = 4.0 * tolerance / p.distance(q);
    let mut joined: Vec<[f64; 2]> = Vec::new();
    for part in parts {
        match joined.last_mut().filter(|last| part[0] <= last[1] + least) {
            Some(last) => last[1] = last[1].max(part[1]),
            None => joined.push(part),
        }
    }
    joined.retain(|[low, high]| high - low > least);
    joined
}

/// The stretch, w from and to, of the segment within `room` of a convex piece; ends out of order if there is none.
fn stretch_in_piece(p: DVec3, q: DVec3, piece: &[DVec3], normal: DVec3, room: f64) -> [f64; 2] {
    let edges = piece.iter().zip(piece.iter().cycle().skip(1));
    edges.fold([-1.0, 1.0], |[low, high]: [f64; 2], (r, s)| {
        let inward = normal.cross(*s - *r).normalize();
        let [start, end] = [p, q].map(|x| (x - *r).dot(inward) + room);
        let crossing = (start + end) / (start - end);
        match (start < 0.0, end < 0.0) {
            (false, false) => [low, high],
            (true, false) => [low.max(crossing), high],
            (false, true) => [low, high.min(crossing)],
            (true, true) => [1.0, -1.0],
        }
    })
}

/// The stretch of `a` that lies along `b`, if it has a length.
fn common_stretch(a: &Border, b: &Border, tolerance: f64) -> Option<[f64; 2]> {
    let on = |edge: &Border, x: DVec3| edge.point(edge.nearest(x)).distance(x) <= tolerance;
    let own = [-1.0, 1.0].into_iter().filter(|w| on(b, a.point(*w)));
    let foreign = [-1.0, 1.0].map(|z| b.point(z)).into_iter().filter(|x| on(a, *x)).map(|x| a.nearest(x));
    let ends: Vec<f64> = own.chain(foreign).collect();
    let (low, high) = ends.iter().fold((1.0_f64, -1.0_f64), |(low, high), w| (low.min(*w), high.max(*w)));
    let between = |w: f64| low + 0.5 * (1.0 + w) * (high - low);
    let long = low < high
        && a.point(low).distance(a.point(high)).max(a.point(low).distance(a.point(between(0.0))))
            > 2.0 * tolerance;
    (long && PLACES.iter().all(|w| on(b, a.point(between(*w))))).then_some([low, high])
}

/// Corners of either patch that lie on the other.
fn vertices(first: &Patch, second: &Patch, tolerance: f64) -> Vec<DVec3> {
    let mut found: Vec<DVec3> = Vec::new();
    for (a, b) in [(first, second), (second, first)] {
        for x in a.borders().iter().map(|border| border.point(-1.0)) {
            let new = found.iter().all(|y| y.distance(x) > tolerance);
            if new && b.foot(x).0.distance(x) <= tolerance {
                found.push(x);
            }
        }
    }
    found
}

/// Least distance: from the nearest pair of sampled points, by dropping feet from one patch to the other and
/// back.
fn gap(first: &Patch, second: &Patch) -> f64 {
    let samples = |patch: &Patch| -> Vec<DVec3> {
        let borders = patch.borders().into_iter().flat_map(|border| PLACES.map(|w| border.point(w)));
        patch.inner_samples().into_iter().map(|(x, _)| x).chain(borders).collect()
    };
    let (a, b) = (samples(first), samples(second));
    let pairs = a.iter().flat_map(|x| b.iter().map(move |y| (x.distance_squared(*y), *x, *y)));
    let (_, mut x, mut y) = pairs.min_by(|p, q| p.0.total_cmp(&q.0)).expect("patches have points");
    for _ in 0..20 {
        let before = x.distance(y);
        y = second.foot(x).0;
        x = first.foot(y).0;
        if x.distance(y) > 0.999 * before {
            break;
        }
    }
    x.distance(y)
}
