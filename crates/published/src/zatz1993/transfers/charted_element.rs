//! A patch of a pair, with its order and number of points.

use radiosity_elements::patch::Patch;

/// A patch, the order N of its functions and n points per direction.
#[derive(Clone, Copy, Debug)]
pub struct ChartedElement<'a> {
    /// The patch; its chart [0, 1]² is read as [−1, 1]².
    pub patch: &'a Patch,
    /// Total degree N.
    pub order: usize,
    /// Points per direction, at least 1.
    pub points: usize,
}
