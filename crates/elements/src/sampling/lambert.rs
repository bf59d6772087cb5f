//! Cosine-distributed directions.

use std::f64::consts::TAU;

use radiosity_geom::DVec3;

/// The direction about a unit normal that two numbers in [0, 1] choose, with the density cos θ / π.
pub fn lambert(normal: DVec3, [polar, turn]: [f64; 2]) -> DVec3 {
    let (along, across) = normal.any_orthonormal_pair();
    let (sin, cos) = (TAU * turn).sin_cos();
    (along * cos + across * sin) * polar.sqrt() + normal * (1.0 - polar).max(0.0).sqrt()
}
