//! Clips two polygons for quadrature, so that they touch in whole edges or corners.
//!
//! Each polygon is clipped once by the plane of the other: the plane is the same for all its points, and what
//! lies behind it exchanges nothing. The rest can touch the other polygon only on the line where the planes
//! meet. Both are then cut across that line wherever either has a corner on it, so that every contact is one
//! whole common edge or one common corner. A box that stands on a floor needs no rule of its own.

use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, clip_polygon};

/// A convex planar polygon with the unit normal of its front.
#[derive(Clone, Debug)]
pub struct Facet {
    /// Corners in order.
    pub corners: Vec<DVec3>,
    /// Unit normal of its front.
    pub normal: DVec3,
}

impl Facet {
    /// A flat patch as a facet.
    pub fn of(patch: &Patch) -> Self {
        Self { corners: patch.polygon(), normal: patch.node(0.0, 0.0).normal }
    }

    /// The part of the facet in front of the plane of `other`; None if there is none.
    pub fn in_front_of(&self, other: &Self, tolerance: f64) -> Option<Self> {
        let heights = self.corners.iter().map(|c| (c - other.corners[0]).dot(other.normal));
        let (low, high) =
            heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), h| (low.min(h), high.max(h)));
        if high <= tolerance {
            return None;
        }
        if low >= -tolerance {
            return Some(self.clone());
        }
        let corners = clip_polygon(&self.corners, other.corners[0], other.normal);
        (corners.len() > 2).then_some(Self { corners, normal: self.normal })
    }

    /// Cuts the facet across a line along `direction`, at the given positions on it.
    fn cut_at(&self, direction: DVec3, positions: &[f64]) -> Vec<Self> {
        let mut parts = vec![self.clone()];
        for position in positions {
            let point = direction * *position;
            let halves = |part: &Self| {
                [direction, -direction].map(|side| Self {
                    corners: clip_polygon(&part.corners, point, side),
                    normal: part.normal,
                })
            };
            parts = parts.iter().flat_map(halves).filter(|part| part.corners.len() > 2).collect();
        }
        parts
    }

    /// Positions along `direction` of the corners within `tolerance` of the plane of `other`, ascending.
    fn corners_on(&self, other: &Self, direction: DVec3, tolerance: f64) -> Vec<f64> {
        let on_plane = |c: &&DVec3| (*c - other.corners[0]).dot(other.normal).abs() <= tolerance;
        let mut positions: Vec<f64> =
            self.corners.iter().filter(on_plane).map(|c| c.dot(direction)).collect();
        positions.sort_by(f64::total_cmp);
        positions
    }
}

/// Cuts two facets, each in front of the other's plane, so that they touch in whole edges or corners.
///
/// The pairs of parts make up the pair of facets; one pair if no cut is needed. Planes at an angle below 1e-9
/// count as parallel.
pub fn match_contact(p: &Facet, q: &Facet, tolerance: f64) -> Vec<(Facet, Facet)> {
    let line = p.normal.cross(q.normal);
    if line.length() < 1e-9 {
        return vec![(p.clone(), q.clone())];
    }
    let direction = line.normalize();
    let on_p = p.corners_on(q, direction, tolerance);
    let on_q = q.corners_on(p, direction, tolerance);
    let (Some(first_p), Some(first_q)) = (on_p.first(), on_q.first()) else {
        return vec![(p.clone(), q.clone())];
    };
    let low = first_p.max(*first_q);
    let high = on_p[on_p.len() - 1].min(on_q[on_q.len() - 1]);
    let mut positions: Vec<f64> = on_p
        .iter()
        .chain(&on_q)
        .copied()
        .filter(|x| (low - tolerance..=high + tolerance).contains(x))
        .collect();
    positions.sort_by(f64::total_cmp);
    positions.dedup_by(|a, b| (*a - *b).abs() <= tolerance);
    let (parts_p, parts_q) = (
        p.cut_at(direction, &inner(&positions, &on_p, tolerance)),
        q.cut_at(direction, &inner(&positions, &on_q, tolerance)),
    );
    parts_p.iter().flat_map(|a| parts_q.iter().map(move |b| (a.clone(), b.clone()))).collect()
}

/// The `positions` strictly inside the interval that `own` spans.
fn inner(positions: &[f64], own: &[f64], tolerance: f64) -> Vec<f64> {
    let (low, high) = (own[0] + tolerance, own[own.len() - 1] - tolerance);
    positions.iter().copied().filter(|x| *x > low && *x < high).collect()
}

#[cfg(test)]
mod tests {
    use radiosity_geom::polygon_area;

    use super::*;

    fn facet(corners: &[[f64; 3]], normal: DVec3) -> Facet {
        Facet { corners: corners.iter().map(|c| DVec3::from_array(*c)).collect(), normal }
    }

    fn floor() -> Facet {
        facet(&[[0., 0., 0.], [4., 0., 0.], [4., 4., 0.], [0., 4., 0.]], DVec3::Z)
    }

    #[test]
    fn what_lies_behind_is_cut_away() {
        let wall = facet(&[[1., 4., -1.], [1., 0., -1.], [1., 0., 2.], [1., 4., 2.]], DVec3::X);
        let floor = floor();
        let seen = floor.in_front_of(&wall, 1e-12).expect("three quarters are in front");
        assert!((polygon_area(&seen.corners) - 12.0).abs() < 1e-12);
        let above = wall.in_front_of(&floor, 1e-12).expect("two thirds are above");
        assert!((polygon_area(&above.corners) - 8.0).abs() < 1e-12);
        assert!(floor.in_front_of(&floor, 1e-12).is_none(), "coplanar facets exchange nothing");
    }

    #[test]
    fn standing_wall_gets_whole_common_edges() {
        // In front of x = 1 the floor's edge on the common line runs from 0 to 4, the wall's from 1 to 3.
        let wall = facet(&[[1., 1., 0.], [1., 3., 0.], [1., 3., 2.], [1., 1., 2.]], DVec3::X);
        let seen = floor().in_front_of(&wall, 1e-12).expect("in front");
        let pairs = match_contact(&seen, &wall, 1e-12);
        assert_eq!(pairs.len(), 3);
        let area: f64 = pairs.iter().map(|(a, _)| polygon_area(&a.corners)).sum();
        assert!((area - 12.0).abs() < 1e-12);
        let shared = |(a, b): &(Facet, Facet)| {
            a.corners.iter().filter(|x| b.corners.iter().any(|y| x.distance(*y) < 1e-12)).count()
        };
        let mut counts: Vec<usize> = pairs.iter().map(shared).collect();
        counts.sort_unstable();
        assert_eq!(counts, [1, 1, 2], "one common edge, two common corners");
    }

    #[test]
    fn parts_that_do_not_touch_stay_whole() {
        let wall = facet(&[[1., 1., 1.], [1., 3., 1.], [1., 3., 2.], [1., 1., 2.]], DVec3::X);
        let seen = floor().in_front_of(&wall, 1e-12).expect("in front");
        assert_eq!(match_contact(&seen, &wall, 1e-12).len(), 1);
    }
}
