//! Clipping a convex polygon by a plane (Sutherland and Hodgman, *Reentrant polygon clipping*, CACM 17,
//! 1974).

use glam::DVec3;
use smallvec::SmallVec;

use crate::{Aabb, ROUNDING};

/// The part of a convex `polygon` with (x − `point`) · `normal` ≥ 0, vertices in the same order.
///
/// Vertices within a relative 1e-12 of the plane (relative to the farthest vertex from `point`) count as on
/// it, so that no edge is cut next to its end. Empty where nothing but a vertex or an edge remains. `normal`
/// need not be a unit vector.
pub fn clip_polygon(polygon: &[DVec3], point: DVec3, normal: DVec3) -> Vec<DVec3> {
    let reach = polygon.iter().map(|x| (*x - point).length_squared()).fold(0.0, f64::max).sqrt();
    let tolerance = ROUNDING * reach * normal.length();
    let height = |x: DVec3| {
        let h = (x - point).dot(normal);
        if h.abs() <= tolerance { 0.0 } else { h }
    };
    let heights: SmallVec<[f64; 8]> = polygon.iter().map(|x| height(*x)).collect();
    let mut kept = Vec::with_capacity(polygon.len() + 1);
    clip_by_heights(polygon, &heights, |x| kept.push(x));
    let inside = heights.iter().any(|h| *h > 0.0);
    // Coplanar polygons lie in the closed half-space as a whole; what merely touches the plane from behind
    // has no area.
    let coplanar = kept.len() == polygon.len();
    if inside || coplanar { kept } else { Vec::new() }
}

/// Hands the vertices of the part of a convex `polygon` where heights are not negative to `keep`, in the same
/// order; those of its vertices are given, and linear in between.
pub fn clip_by_heights(polygon: &[DVec3], heights: &[f64], mut keep: impl FnMut(DVec3)) {
    let (Some(mut previous), Some(mut before)) = (polygon.last(), heights.last()) else { return };
    for (x, h) in polygon.iter().zip(heights) {
        if before * h < 0.0 {
            keep(previous.lerp(*x, before / (before - h)));
        }
        if *h >= 0.0 {
            keep(*x);
        }
        (previous, before) = (x, h);
    }
}

/// The part of a convex `polygon` over another, `clip`, seen along `normal`, about which `clip` runs
/// counter-clockwise. Fewer than three vertices remain where they share no area.
pub fn intersection(polygon: &[DVec3], clip: &[DVec3], normal: DVec3) -> Vec<DVec3> {
    sides(clip).fold(polygon.to_vec(), |rest, [from, to]| clip_polygon(&rest, from, normal.cross(to - from)))
}

/// The part of a convex `polygon` outside another, `hole`, seen along `normal`, about which `hole` runs
/// counter-clockwise, as disjoint convex parts. The polygon itself if the two share no area.
pub fn difference(polygon: &[DVec3], hole: &[DVec3], normal: DVec3) -> Vec<Vec<DVec3>> {
    let (mut beside, mut rest) = (Vec::new(), polygon.to_vec());
    for [from, to] in sides(hole) {
        let inward = normal.cross(to - from);
        beside.extend(Some(clip_polygon(&rest, from, -inward)).filter(|part| part.len() > 2));
        rest = clip_polygon(&rest, from, inward);
        if rest.len() < 3 {
            return vec![polygon.to_vec()];
        }
    }
    beside
}

/// The sides of a polygon, in order, from each corner to the next.
pub fn sides<T: Copy>(polygon: &[T]) -> impl Iterator<Item = [T; 2]> + Clone {
    polygon.iter().zip(polygon.iter().cycle().skip(1)).map(|(from, to)| [*from, *to])
}

/// Vector of area ½ Σ xᵢ × xᵢ₊₁ of a closed outline (Newell): along the front's normal, as long as the area.
pub fn area_vector(outline: &[DVec3]) -> DVec3 {
    let Some(first) = outline.first() else { return DVec3::ZERO };
    0.5 * sides(outline).map(|[x, y]| (x - *first).cross(y - *first)).sum::<DVec3>()
}

/// Distance of a point from the segment between two others (length).
pub fn distance_to_segment(x: DVec3, [a, b]: [DVec3; 2]) -> f64 {
    let along = ((x - a).dot(b - a) / a.distance_squared(b)).clamp(0.0, 1.0);
    x.distance(a + (b - a) * along)
}

/// Area of a planar polygon over the diagonal of the box around it: about its breadth (length).
pub fn polygon_width(polygon: &[DVec3]) -> f64 {
    polygon_area(polygon) / Aabb::around(polygon.iter().copied()).diagonal()
}

/// Area of a planar polygon, convex or not (length²).
pub fn polygon_area(polygon: &[DVec3]) -> f64 {
    let fan = polygon.windows(2).map(|edge| (edge[0] - polygon[0]).cross(edge[1] - polygon[0]));
    0.5 * fan.sum::<DVec3>().length()
}

/// Signed distance of the point `x` of a convex polygon's plane from the polygon: the largest distance from
/// the lines of its sides, positive beyond them (length). The corners run counter-clockwise about the unit
/// vector `normal`. Sides of no length do not count.
pub fn overhang(polygon: &[DVec3], normal: DVec3, x: DVec3) -> f64 {
    let beyond = |k: usize| {
        let side = polygon[(k + 1) % polygon.len()] - polygon[k];
        side.cross(normal).try_normalize().map(|outwards| (x - polygon[k]).dot(outwards))
    };
    (0..polygon.len()).filter_map(beyond).fold(f64::NEG_INFINITY, f64::max)
}

/// Whether the point `x` of a convex polygon's plane lies inside: [`overhang`] is below 0. Faster than that.
pub fn holds(polygon: &[DVec3], normal: DVec3, x: DVec3) -> bool {
    let is_within = |k: usize| {
        let side = polygon[(k + 1) % polygon.len()] - polygon[k];
        side.cross(normal).dot(x - polygon[k]) < 0.0
    };
    (0..polygon.len()).all(is_within)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn square() -> [DVec3; 4] {
        [DVec3::ZERO, DVec3::X, DVec3::X + DVec3::Y, DVec3::Y]
    }

    proptest! {
        #[test]
        fn overhang_of_a_square_is_the_larger_of_two_distances(x in -2.0f64..3.0, y in -2.0f64..3.0) {
            let exact = (-x).max(x - 1.0).max(-y).max(y - 1.0);
            prop_assert!((overhang(&square(), DVec3::Z, DVec3::new(x, y, 0.0)) - exact).abs() < 1e-15);
        }
    }

    proptest! {
        #[test]
        fn what_lies_in_another_and_beside_it_adds_up(
            x in -0.5f64..1.2, y in -0.5f64..1.2, size in 0.01f64..1.5, angle in 0.0f64..6.3,
        ) {
            let turned = |k: usize| {
                let angle = angle + k as f64 * core::f64::consts::TAU / 5.0;
                DVec3::new(x + size * angle.cos(), y + size * angle.sin(), 0.3)
            };
            let hole: Vec<DVec3> = (0..5).map(turned).collect();
            let inside = intersection(&square(), &hole, DVec3::Z);
            let beside = difference(&square(), &hole, DVec3::Z);
            let sum = polygon_area(&inside) + beside.iter().map(|part| polygon_area(part)).sum::<f64>();
            prop_assert!((sum - 1.0).abs() < 1e-14);
            prop_assert!(inside.iter().all(|x| overhang(&hole, DVec3::Z, *x) < 1e-12));
            for part in &beside {
                let middle = part.iter().sum::<DVec3>() / part.len() as f64;
                prop_assert!(inside.len() < 3 || overhang(&hole, DVec3::Z, middle) > -1e-12);
            }
        }
    }

    #[test]
    fn plane_through_an_edge_keeps_all_or_nothing() {
        for (normal, count) in [(DVec3::X, 4), (-DVec3::X, 0)] {
            assert_eq!(clip_polygon(&square(), DVec3::ZERO, normal).len(), count);
            assert_eq!(clip_polygon(&square(), 1e-14 * DVec3::X, normal).len(), count);
        }
        assert_eq!(clip_polygon(&square(), DVec3::ZERO, DVec3::Z), square());
    }

    proptest! {
        #[test]
        fn the_two_sides_add_up(px in -0.5..1.5, py in -0.5..1.5, angle in 0.0..6.3) {
            let (point, normal) = (DVec3::new(px, py, 0.0), DVec3::new(f64::cos(angle), f64::sin(angle), 0.3));
            let sides = [normal, -normal].map(|n| clip_polygon(&square(), point, n));
            prop_assert!((polygon_area(&sides[0]) + polygon_area(&sides[1]) - 1.0).abs() < 1e-14);
            for (side, n) in sides.iter().zip([normal, -normal]) {
                prop_assert!(side.iter().all(|x| (*x - point).dot(n) >= -1e-12));
            }
        }
    }
}
