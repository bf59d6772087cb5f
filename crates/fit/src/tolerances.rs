//! Tolerances of sheets that were meant to be one, or to lie on each other. Lengths that count as none, and which
//! planes are one, are set by [`radiosity_geom`].

/// Least common part of two sheets that lie on each other, or in front of each other, over the smaller area:
/// edges that touch share less by rounding. With a larger value a narrow strip that is shared would not
/// count.
pub const SHARED_AREA: f64 = 1e-6;

/// Width of the common part of two sheets, over the smaller extent, up to which they only touch: some sixteen
/// roundings in single precision. With a larger value sheets that lie on each other in a narrow strip would
/// pass; with a smaller one neighbours in models of single precision would count as overlapping.
pub(crate) const OVERLAP_OF_EXTENT: f64 = 1e-6;

/// Width of the common part over the narrower breadth, where that is less: of slender sheets
/// [`OVERLAP_OF_EXTENT`] may be all of the breadth.
pub(crate) const OVERLAP_OF_BREADTH: f64 = 1e-3;

/// Roundings by which two points that are meant to be one may differ: one of each. Corners that were computed
/// are allowed more where faces are merged.
pub(crate) const ROUNDINGS_OF_POINTS: f64 = 2.0;
