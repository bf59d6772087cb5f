//! Outlines in space, closed rings of points: lengths, areas, rounding, and whether they lie in a plane.

use glam::DVec3;
use radiosity_geom::{COINCIDENT, PLANARITY, ROUNDINGS_OF_PLANE, area_vector, coordinate_rounding, sides};

use crate::tolerances::ROUNDINGS_OF_POINTS;

/// Largest distance of a corner from the first (length).
pub fn extent(outline: &[DVec3]) -> f64 {
    let Some(first) = outline.first() else { return 0.0 };
    outline.iter().map(|x| x.distance(*first)).fold(0.0, f64::max)
}

/// Largest distance of a corner from the plane through the first corner across the vector of area (length); 0
/// without area.
pub fn unevenness(outline: &[DVec3]) -> f64 {
    let Some(first) = outline.first() else { return 0.0 };
    let normal = area_vector(outline).normalize_or_zero();
    outline.iter().map(|x| (*x - *first).dot(normal).abs()).fold(0.0, f64::max)
}

/// The length (the ring's unit) up to which two of its points are one: the largest of `asked`, of 1e-9 of its
/// extent, within which [`PlanarRegion`](radiosity_geom::PlanarRegion) refuses points, and of the rounding of
/// its coordinates, in single precision where they are of that.
pub fn tolerance(ring: &[DVec3], asked: Option<f64>) -> f64 {
    asked
        .unwrap_or(0.0)
        .max(COINCIDENT * extent(ring))
        .max(ROUNDINGS_OF_POINTS * coordinate_rounding(ring, None))
}

/// Length of the ring, all around.
pub(super) fn perimeter(ring: &[DVec3]) -> f64 {
    sides(ring).map(|[x, y]| x.distance(y)).sum()
}

/// Length between two points far from each other, and the largest distance of a point from the line through
/// them.
pub fn length_and_width(ring: &[DVec3]) -> [f64; 2] {
    let farthest = |from: DVec3| {
        ring.iter().copied().max_by(|x, y| x.distance_squared(from).total_cmp(&y.distance_squared(from)))
    };
    let Some(one) = ring.first().and_then(|first| farthest(*first)) else { return [0.0; 2] };
    let Some(other) = farthest(one) else { return [0.0; 2] };
    let Some(along) = (other - one).try_normalize() else { return [0.0; 2] };
    let width = ring.iter().map(|x| (*x - one).cross(along).length()).fold(0.0, f64::max);
    [one.distance(other), width]
}

/// Message on a face of four corners off its plane.
pub const WARPED: &str = "a face of four corners is off its plane: it is a bilinear patch";

/// Whether four corners make a patch that is curved: off their plane by more than 2e-5 of their extent and
/// than their rounding, and convex seen from the front.
pub fn is_warped(corners: &[DVec3; 4]) -> bool {
    let tolerance =
        (PLANARITY * extent(corners)).max(ROUNDINGS_OF_PLANE * coordinate_rounding(corners, None));
    let normal = area_vector(corners);
    let turn = |k: usize| {
        let [a, b, c] = [0, 1, 2].map(|step| corners[(k + step) % 4]);
        (b - a).cross(c - b).dot(normal)
    };
    unevenness(corners) > tolerance && (0..4).all(|k| turn(k) > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(lift: f64) -> [DVec3; 4] {
        [DVec3::ZERO, DVec3::X, DVec3::new(1.0, 1.0, lift), DVec3::Y]
    }

    #[test]
    fn the_area_of_a_square_points_to_its_front() {
        assert_eq!(area_vector(&square(0.0)), DVec3::Z);
        assert_eq!(extent(&square(0.0)), 2f64.sqrt());
    }

    #[test]
    fn only_lifted_convex_squares_are_warped() {
        assert!(is_warped(&square(0.1)));
        assert!(!is_warped(&square(1e-5)));
        let dart = [DVec3::ZERO, DVec3::X, DVec3::new(0.2, 0.2, 0.1), DVec3::Y];
        assert!(!is_warped(&dart));
    }
}
