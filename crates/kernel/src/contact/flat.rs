//! Contact of two patches: a common edge, a common corner, or none.
//!
//! The contact alone decides the rule. Flat pairs come already cut, so that contacts are whole edges or
//! corners ([`crate::contact::clip`]); for pairs with a curved patch see [`crate::contact::curved`].

use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, distance_to_segment, sides};

/// Contact of two flat patches, which are oriented inside as the rule needs them.
#[derive(Clone, Debug)]
pub enum FlatContact {
    /// A whole common edge: at t = 0 in both charts, run through in the same sense.
    Edge(Patch, Patch),
    /// One common corner: at (0, 0) in both charts.
    Vertex(Patch, Patch),
    /// No common point, and the distance; zero where no rule covers the contact.
    Apart(f64),
}

/// Classifies two patches; points closer than `tolerance` coincide.
pub fn classify(p: &Patch, q: &Patch, tolerance: f64) -> FlatContact {
    let (corners_p, corners_q) = (p.polygon(), q.polygon());
    match shared_corners(&corners_p, &corners_q, tolerance)[..] {
        [] => FlatContact::Apart(gap(p, q)),
        [(i, j)] if !overlapping_sides(&corners_p, i, &corners_q, j, tolerance) => FlatContact::Vertex(
            p.oriented(i, (i + 1) % corners_p.len()),
            q.oriented(j, (j + 1) % corners_q.len()),
        ),
        [(i, j), (k, l)] if neighbours(i, k, corners_p.len()) && neighbours(j, l, corners_q.len()) => {
            FlatContact::Edge(p.oriented(i, k), q.oriented(j, l))
        }
        _ => FlatContact::Apart(0.0),
    }
}

/// The pairs of corners of two polygons that coincide, by their indices.
pub(crate) fn shared_corners(p: &[DVec3], q: &[DVec3], tolerance: f64) -> Vec<(usize, usize)> {
    let pairs = (0..p.len()).flat_map(|i| (0..q.len()).map(move |j| (i, j)));
    pairs.filter(|(i, j)| p[*i].distance(q[*j]) <= tolerance).collect()
}

/// Whether two of `count` corners are the ends of one side.
pub(crate) fn neighbours(i: usize, j: usize, count: usize) -> bool {
    (i + 1) % count == j || (j + 1) % count == i
}

/// Whether two sides that leave a common corner lie along each other.
fn overlapping_sides(p: &[DVec3], i: usize, q: &[DVec3], j: usize, tolerance: f64) -> bool {
    let around = |points: &[DVec3], k: usize| {
        let n = points.len();
        [points[(k + 1) % n], points[(k + n - 1) % n]]
    };
    let corner = p[i];
    let (sides_p, sides_q) = (around(p, i), around(q, j));
    sides_p.iter().any(|a| {
        sides_q.iter().any(|b| {
            distance_to_segment(*a, [corner, *b]) <= tolerance
                || distance_to_segment(*b, [corner, *a]) <= tolerance
        })
    })
}

/// Distance between two patches: exact for flat ones, a lower bound where one is curved.
///
/// The larger of two bounds: the distance of the corners' polygons less both sagittas, good for small or
/// nearly flat patches; and the distance of points of uniform grids less half the diagonals of the grids'
/// cells.
pub fn gap(p: &Patch, q: &Patch) -> f64 {
    let by_corners = polygon_distance(&p.polygon(), &q.polygon()) - p.sagitta() - q.sagitta();
    if p.is_flat() && q.is_flat() || by_corners > 0.5 * (diagonal(p) + diagonal(q)) {
        return by_corners.max(0.0);
    }
    let by_points = match (p.is_flat(), q.is_flat()) {
        (false, false) => {
            let (a, b) = (grid(p), grid(q));
            let distances = a.iter().flat_map(|x| b.iter().map(move |y| x.distance_squared(*y)));
            distances.fold(f64::INFINITY, f64::min).sqrt() - cell(p) - cell(q)
        }
        (true, _) => to_polygon(&grid(q), &p.polygon()) - cell(q),
        (_, true) => to_polygon(&grid(p), &q.polygon()) - cell(p),
    };
    by_corners.max(by_points).max(0.0)
}

/// Points per direction of these grids. The bound is short of the distance by half the diagonals of their
/// cells, a tenth of the diagonals of the patches; more points make it sharper and cost their fourth power.
const GRID: usize = 7;

fn grid(patch: &Patch) -> Vec<DVec3> {
    let place = |k: usize| k as f64 / (GRID - 1) as f64;
    (0..GRID * GRID).map(|k| patch.node(place(k / GRID), place(k % GRID)).position).collect()
}

/// Half the diagonal of a cell of the grid, times 1.2 since an arc is longer than its chord: 1.12 times where
/// it turns by 1.6, as lines of sectors do at most.
fn cell(patch: &Patch) -> f64 {
    0.6 * diagonal(patch) / (GRID - 1) as f64
}

fn diagonal(patch: &Patch) -> f64 {
    let [along, across] = patch.extents();
    along.hypot(across)
}

fn to_polygon(points: &[DVec3], polygon: &[DVec3]) -> f64 {
    points.iter().map(|x| point_to_polygon(*x, polygon)).fold(f64::INFINITY, f64::min)
}

/// Distance of two convex polygons that do not cross.
pub fn polygon_distance(p: &[DVec3], q: &[DVec3]) -> f64 {
    let corners = p.iter().map(|x| point_to_polygon(*x, q)).chain(q.iter().map(|y| point_to_polygon(*y, p)));
    let sides = sides(p).flat_map(|a| sides(q).map(move |b| segment_to_segment(a, b)));
    corners.chain(sides).fold(f64::INFINITY, f64::min)
}

/// Distance of a convex polygon and a segment that do not cross.
pub fn segment_distance(p: &[DVec3], [a, b]: [DVec3; 2]) -> f64 {
    let ends = point_to_polygon(a, p).min(point_to_polygon(b, p));
    sides(p).map(|side| segment_to_segment(side, [a, b])).fold(ends, f64::min)
}

/// Distance of a point and a convex polygon.
pub fn point_to_polygon(x: DVec3, polygon: &[DVec3]) -> f64 {
    let doubled: DVec3 = sides(polygon).map(|[a, b]| (a - polygon[0]).cross(b - polygon[0])).sum();
    let normal = doubled.normalize_or_zero();
    // A polygon without area has no interior.
    let inside = normal != DVec3::ZERO && sides(polygon).all(|[a, b]| normal.cross(b - a).dot(x - a) >= 0.0);
    if inside {
        return (x - polygon[0]).dot(normal).abs();
    }
    sides(polygon).map(|side| distance_to_segment(x, side)).fold(f64::INFINITY, f64::min)
}

/// Distance of two segments: minimises over the lines, clamps one parameter, then the other (C. Ericson,
/// *Real-Time Collision Detection*, 5.1.9). Lines whose sin² is below 1e-14 count as parallel.
fn segment_to_segment([a, b]: [DVec3; 2], [c, d]: [DVec3; 2]) -> f64 {
    let (u, v, w) = (b - a, d - c, a - c);
    let (uu, vv, uv) = (u.length_squared(), v.length_squared(), u.dot(v));
    let determinant = uu * vv - uv * uv;
    let s = if determinant > 1e-14 * uu * vv {
        ((uv * v.dot(w) - vv * u.dot(w)) / determinant).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let t = ((uv * s + v.dot(w)) / vv).clamp(0.0, 1.0);
    let s = ((uv * t - u.dot(w)) / uu).clamp(0.0, 1.0);
    (a + u * s).distance(c + v * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quad(corners: [[f64; 3]; 4]) -> Patch {
        let corners = corners.map(DVec3::from_array);
        let normal = (corners[1] - corners[0]).cross(corners[3] - corners[0]).normalize();
        Patch::Flat { corners, normal }
    }

    #[test]
    fn hinge_is_an_edge_run_the_same_way() {
        let floor = quad([[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let wall = quad([[0., 0., 1.], [1., 0., 1.], [1., 0., 0.], [0., 0., 0.]]);
        let FlatContact::Edge(p, q) = classify(&floor, &wall, 1e-12) else { panic!("they share an edge") };
        for s in [0.0, 0.3, 1.0] {
            assert!(p.node(s, 0.0).position.distance(q.node(s, 0.0).position) < 1e-15);
        }
    }

    #[test]
    fn corner_and_gap() {
        let floor = quad([[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let beyond = quad([[1., 1., 0.], [2., 1., 0.], [2., 1., 1.], [1., 1., 1.]]);
        assert!(matches!(classify(&floor, &beyond, 1e-12), FlatContact::Vertex(..)));
        let above = quad([[0.2, 0.2, 0.5], [0.8, 0.2, 0.7], [0.8, 0.8, 0.7], [0.2, 0.8, 0.5]]);
        let FlatContact::Apart(gap) = classify(&floor, &above, 1e-12) else { panic!("apart") };
        assert!((gap - 0.5).abs() < 1e-15);
    }

    #[test]
    fn partly_common_sides_are_no_vertex_contact() {
        let floor = quad([[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]]);
        let low = quad([[0., 0., 0.], [0.5, 0., 0.], [0.5, 0., 1.], [0., 0., 1.]]);
        let FlatContact::Apart(gap) = classify(&floor, &low, 1e-12) else { panic!("no rule covers it") };
        assert_eq!(gap, 0.0);
    }

    #[test]
    fn crossing_segments_are_close_in_the_middle() {
        let a = [DVec3::new(-1., 0., 0.), DVec3::new(1., 0., 0.)];
        let b = [DVec3::new(0., -1., 0.25), DVec3::new(0., 1., 0.25)];
        assert!((segment_to_segment(a, b) - 0.25).abs() < 1e-15);
        let parallel = [DVec3::new(2., 1., 0.), DVec3::new(3., 1., 0.)];
        assert!((segment_to_segment(a, parallel) - 2f64.sqrt()).abs() < 1e-15);
    }
}
