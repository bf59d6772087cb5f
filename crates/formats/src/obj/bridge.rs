//! Outlines that run along bridges to holes and back: polygons with holes for formats that have none.
//!
//! Each hole is joined to the outline by a side that meets nothing else, by the way of Eberly (*Triangulation
//! by Ear Clipping*, 2002, section 5), the hole that reaches farthest first. The area stays the same whatever
//! the bridge.

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};
use radiosity_geom::area_vector;

/// A corner in space and in the plane.
#[derive(Clone, Copy)]
struct Corner {
    point: DVec3,
    flat: DVec2,
}

/// One outline around a polygon and its holes.
pub(super) fn bridged(outline: &[DVec3], holes: &[Vec<DVec3>]) -> Vec<DVec3> {
    let normal = area_vector(outline).normalize_or(DVec3::Z);
    let x = normal.any_orthonormal_vector();
    let y = normal.cross(x);
    let ring = |points: &[DVec3]| -> Vec<Corner> {
        points.iter().map(|p| Corner { point: *p, flat: DVec2::new(p.dot(x), p.dot(y)) }).collect()
    };
    let mut bridged = ring(outline);
    let mut holes: Vec<Vec<Corner>> = holes
        .iter()
        .map(|hole| {
            let mut corners = ring(hole);
            if area_vector(hole).dot(normal) > 0.0 {
                corners.reverse();
            }
            let farthest = (0..corners.len())
                .max_by(|a, b| corners[*a].flat.x.total_cmp(&corners[*b].flat.x))
                .unwrap_or(0);
            corners.rotate_left(farthest);
            corners
        })
        .filter(|corners| !corners.is_empty())
        .collect();
    holes.sort_by(|a, b| b[0].flat.x.total_cmp(&a[0].flat.x));
    for hole in holes {
        let start = hole[0];
        let at = visible(&bridged, start.flat);
        let gate = bridged[at];
        let way = hole.into_iter().chain([start, gate]);
        drop(bridged.splice(at + 1..at + 1, way));
    }
    bridged.into_iter().map(|corner| corner.point).collect()
}

/// A corner of `ring` that is seen from the point `from` inside.
fn visible(ring: &[Corner], from: DVec2) -> usize {
    let Some((side, x)) = first_side(ring, from) else { return nearest(ring, from) };
    let [a, b] = [side, (side + 1) % ring.len()];
    let end = if ring[a].flat.x > ring[b].flat.x { a } else { b };
    let hit = DVec2::new(x, from.y);
    let corner = ring[end].flat;
    // Corners within the triangle hide its end; the one nearest to the ray in angle is seen.
    let slope = |index: &usize| {
        let way = ring[*index].flat - from;
        (way.y.abs() / way.x, way.length_squared())
    };
    let hidden = (0..ring.len()).filter(|index| {
        let point = ring[*index].flat;
        point.x > from.x
            && (point != corner)
            && is_within([from, hit, corner], point)
            && opens(ring, *index, from)
    });
    let first = hidden.min_by(|i, j| {
        let ((a, b), (c, d)) = (slope(i), slope(j));
        a.total_cmp(&c).then(b.total_cmp(&d))
    });
    first.unwrap_or_else(|| occurrence(ring, end, from))
}

/// The side of `ring` that a ray to greater x meets first, and the x of the meeting. The inside lies to the
/// left of a side, so it runs upwards there.
fn first_side(ring: &[Corner], from: DVec2) -> Option<(usize, f64)> {
    let meeting = |index: usize| {
        let [a, b] = [ring[index].flat, ring[(index + 1) % ring.len()].flat];
        let is_met = a.y <= from.y && b.y >= from.y && b.y > a.y;
        let x = a.x + (from.y - a.y) / (b.y - a.y) * (b.x - a.x);
        (is_met && x >= from.x).then_some((index, x))
    };
    (0..ring.len()).filter_map(meeting).min_by(|a, b| a.1.total_cmp(&b.1))
}

/// The corner nearest to a point, for outlines that do not hold it.
fn nearest(ring: &[Corner], from: DVec2) -> usize {
    let distance = |index: &usize| ring[*index].flat.distance_squared(from);
    (0..ring.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0)
}

/// Of the corners at one place that which opens to a point: bridges pass places twice.
fn occurrence(ring: &[Corner], at: usize, from: DVec2) -> usize {
    let same = |index: &usize| ring[*index].flat == ring[at].flat;
    (0..ring.len()).filter(same).find(|index| opens(ring, *index, from)).unwrap_or(at)
}

/// Whether a point lies in the angle that the inside has at a corner.
fn opens(ring: &[Corner], index: usize, from: DVec2) -> bool {
    let count = ring.len();
    let here = ring[index].flat;
    let [before, after] = [(index + count - 1) % count, (index + 1) % count].map(|k| ring[k].flat - here);
    // Counter-clockwise from the side that follows.
    let turn = |way: DVec2| {
        let angle = f64::atan2(after.perp_dot(way), after.dot(way));
        if angle < 0.0 { angle + TAU } else { angle }
    };
    turn(from - here) <= turn(before)
}

/// Whether a point lies in a triangle or on its border.
fn is_within([a, b, c]: [DVec2; 3], point: DVec2) -> bool {
    let sides = [[a, b], [b, c], [c, a]].map(|[p, q]| (q - p).perp_dot(point - p));
    sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
}
