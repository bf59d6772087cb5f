//! A part of a planar surface on which bodies stand.

use radiosity_geom::PlanarRegion;

/// A part of a planar surface that no light reaches.
#[derive(Clone, Debug, PartialEq)]
pub struct Footprint {
    /// Index of the surface.
    pub surface: usize,
    /// The part of it, a polygon.
    pub region: PlanarRegion,
    /// Indices of the surfaces that stand around it, ascending.
    pub standing: Vec<usize>,
}
