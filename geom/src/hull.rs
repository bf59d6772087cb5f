//! Convex hulls of points in a plane, by the monotone chain (Andrew, *Another efficient algorithm for convex
//! hulls in two dimensions*, Information Processing Letters 9, 1979).

use glam::{DVec2, DVec3};

/// The convex hull, counter-clockwise, from the earliest of `points` that lies on it; no three vertices in a
/// line.
pub(crate) fn convex_hull(points: &[DVec2]) -> Vec<DVec2> {
    let mut sorted = points.to_vec();
    sorted.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
    let chain = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut hull: Vec<DVec2> = Vec::new();
        for p in points {
            while hull.len() >= 2
                && (hull[hull.len() - 1] - hull[hull.len() - 2]).perp_dot(p - hull[hull.len() - 1]) <= 0.0
            {
                hull.pop();
            }
            hull.push(p);
        }
        hull.pop();
        hull
    };
    let mut hull = chain(&mut sorted.iter().copied());
    hull.extend(chain(&mut sorted.iter().rev().copied()));
    let start = points.iter().find_map(|p| hull.iter().position(|q| p == q)).expect("a hull has vertices");
    hull.rotate_left(start);
    hull
}

/// The vertices of the convex hull of coplanar `points`, each once; `normal` is perpendicular to their plane.
pub fn extreme_points(points: &[DVec3], normal: DVec3) -> Vec<DVec3> {
    let axes = normal.any_orthonormal_pair();
    let flat = |x: &DVec3| DVec2::new((*x - points[0]).dot(axes.0), (*x - points[0]).dot(axes.1));
    let flattened: Vec<DVec2> = points.iter().map(flat).collect();
    if points.len() < 4 {
        return points.to_vec();
    }
    let hull = convex_hull(&flattened);
    hull.iter().filter_map(|corner| flattened.iter().position(|x| x == corner)).map(|k| points[k]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inner_points_and_copies_are_left_out() {
        let up = DVec3::new(1.0, 2.0, 2.0) / 3.0;
        let (a, b) = up.any_orthonormal_pair();
        let at = |x: f64, y: f64| DVec3::ONE + x * a + y * b;
        let corners = [at(0.0, 0.0), at(2.0, 0.0), at(2.0, 1.0), at(0.0, 1.0)];
        let inner = [at(1.0, 0.5), at(0.3, 0.2)];
        let all: Vec<DVec3> = inner.iter().chain(&corners).chain(&corners[1..3]).copied().collect();
        let found = extreme_points(&all, up);
        assert_eq!(found.len(), 4);
        assert!(corners.iter().all(|corner| found.contains(corner)));
    }
}
