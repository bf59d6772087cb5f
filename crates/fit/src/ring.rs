//! Closed rings of points in space: lengths, areas, rounding.

use glam::DVec3;
use radiosity_geom::{COINCIDENT, coordinate_rounding, sides};

use crate::outline::extent;
use crate::tolerances::ROUNDINGS_OF_POINTS;

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
