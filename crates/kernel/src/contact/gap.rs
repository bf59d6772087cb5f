//! Distances of patches and of polygons.

use radiosity_elements::patch::Patch;
use radiosity_geom::{DVec3, area_vector, distance_to_segment, sides};

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
    let normal = area_vector(polygon).normalize_or_zero();
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

    #[test]
    fn crossing_segments_are_close_in_the_middle() {
        let a = [DVec3::new(-1., 0., 0.), DVec3::new(1., 0., 0.)];
        let b = [DVec3::new(0., -1., 0.25), DVec3::new(0., 1., 0.25)];
        assert!((segment_to_segment(a, b) - 0.25).abs() < 1e-15);
        let parallel = [DVec3::new(2., 1., 0.), DVec3::new(3., 1., 0.)];
        assert!((segment_to_segment(a, parallel) - 2f64.sqrt()).abs() < 1e-15);
    }
}
