//! Closed rings of vertices in a plane: area, inside, distance, and whether they are simple and nested as
//! they should be.

use crate::tolerances::COINCIDENT;
use crate::{ShapeError, sides};
use glam::{DVec2, DVec3};

/// ½ Σ xᵢ × xᵢ₊₁, positive for counter-clockwise rings.
pub(super) fn signed_area(ring: &[DVec2]) -> f64 {
    0.5 * sides(ring).map(|[p, q]| (p - ring[0]).perp_dot(q - ring[0])).sum::<f64>()
}

/// Whether the ring winds around `at` an odd number of times.
pub(super) fn encloses(ring: &[DVec2], at: DVec2) -> bool {
    let crosses = |[p, q]: &[DVec2; 2]| {
        (p.y > at.y) != (q.y > at.y) && at.x < p.x + (at.y - p.y) / (q.y - p.y) * (q.x - p.x)
    };
    sides(ring).filter(crosses).count() % 2 == 1
}

/// Distance from `at` to the ring itself.
pub(super) fn distance(ring: &[DVec2], at: DVec2) -> f64 {
    sides(ring).map(|edge| to_segment(at, edge)).fold(f64::INFINITY, f64::min)
}

/// Every ring simple, every hole inside the outline (ring 0) and apart from the others.
pub(super) fn check(rings: &[Vec<DVec2>], names: &[String], extent: f64) -> Result<(), ShapeError> {
    let tolerance = COINCIDENT * extent;
    for (ring, name) in rings.iter().zip(names) {
        if signed_area(ring).abs() <= tolerance * extent {
            return Err(ShapeError::NoArea { field: name.clone() });
        }
        if let Some((first, second)) = self_contact(ring, tolerance) {
            return Err(ShapeError::SelfCrossing { field: name.clone(), first, second });
        }
    }
    for (k, hole) in rings.iter().enumerate().skip(1) {
        let strays = |at: DVec2| !encloses(&rings[0], at) && distance(&rings[0], at) > tolerance;
        if cross(hole, &rings[0], tolerance) || samples(hole).any(strays) {
            return Err(ShapeError::HoleOutside { field: names[k].clone() });
        }
        for earlier in 1..k {
            if overlap(hole, &rings[earlier], tolerance) {
                return Err(ShapeError::HolesOverlap {
                    field: names[k].clone(),
                    other: names[earlier].clone(),
                });
            }
        }
    }
    Ok(())
}

/// The crossing of an outline in space whose edges cancel in area, such as a symmetric bow tie.
pub(super) fn bow_tie(ring: &[DVec3]) -> Option<ShapeError> {
    let origin = ring[0];
    let corner = |k: usize| (ring[k] - origin).cross(ring[(k + 1) % ring.len()] - origin);
    let normal =
        (1..ring.len()).map(corner).max_by(|a, b| a.length().total_cmp(&b.length()))?.try_normalize()?;
    let first = normal.any_orthonormal_vector();
    let second = normal.cross(first);
    let flat: Vec<DVec2> =
        ring.iter().map(|x| DVec2::new((*x - origin).dot(first), (*x - origin).dot(second))).collect();
    let extent = flat.iter().map(|x| x.length()).fold(0.0, f64::max);
    let (first, second) = self_contact(&flat, COINCIDENT * extent)?;
    Some(ShapeError::SelfCrossing { field: "vertices".into(), first, second })
}

/// Vertices and edge midpoints.
fn samples(ring: &[DVec2]) -> impl Iterator<Item = DVec2> + '_ {
    sides(ring).flat_map(|[p, q]| [p, 0.5 * (p + q)])
}

/// Distance from `at` to the segment.
pub(super) fn to_segment(at: DVec2, [p, q]: [DVec2; 2]) -> f64 {
    let along = (at - p).dot(q - p) / (q - p).length_squared();
    at.distance(p.lerp(q, along.clamp(0.0, 1.0)))
}

/// Two edges of the ring that meet elsewhere than at their common vertex.
fn self_contact(ring: &[DVec2], tolerance: f64) -> Option<(usize, usize)> {
    let all: Vec<[DVec2; 2]> = sides(ring).collect();
    let n = all.len();
    for first in 0..n {
        for second in first + 1..n {
            let (e, f) = (all[first], all[second]);
            let meet = if second == first + 1 {
                folds_back(e, f, tolerance)
            } else if first == 0 && second == n - 1 {
                folds_back(f, e, tolerance)
            } else {
                // Edges on one line, however far from each other, cross by rounding.
                properly_cross(e, f, tolerance) || segments_apart(e, f) <= tolerance
            };
            if meet {
                return Some((first, second));
            }
        }
    }
    None
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

/// Whether any edges of the two rings properly cross.
fn cross(a: &[DVec2], b: &[DVec2], tolerance: f64) -> bool {
    sides(a).any(|e| sides(b).any(|f| properly_cross(e, f, tolerance)))
}

/// Whether two holes share more than boundary.
fn overlap(a: &[DVec2], b: &[DVec2], tolerance: f64) -> bool {
    let inside = |ring: &[DVec2], at: DVec2| encloses(ring, at) && distance(ring, at) > tolerance;
    let enters = samples(a).any(|at| inside(b, at)) || samples(b).any(|at| inside(a, at));
    let same = samples(a).all(|at| distance(b, at) <= tolerance) && signed_area(a) * signed_area(b) > 0.0;
    let equal_area = (signed_area(a) - signed_area(b)).abs() <= tolerance * signed_area(a).abs().sqrt();
    enters || cross(a, b, tolerance) || (same && equal_area)
}
