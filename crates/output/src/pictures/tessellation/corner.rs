//! A corner of a facet.

use radiosity_geom::DVec3;

/// A point of a surface with its parameters.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// The point.
    pub position: DVec3,
    /// Parameters (u, v) ∈ [−1, 1]².
    pub parameters: [f64; 2],
}
