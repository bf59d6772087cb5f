//! Tolerances that several modules and crates share: what is no length, no area, one direction, one plane.
//!
//! A quantity has one name, wherever it is bounded. Where places bound it differently, the values stand side
//! by side. Lengths are parts of the extent of the smaller of the things compared, unless something else is
//! said.

/// Part of a length that rounding may leave of what is none, and difference of unit vectors that are one:
/// some 10⁴ roundings, which sums and products of coordinates stay below. Clipping, nearest points, outlooks
/// and the planes of elements use it. A larger one would take thin layers for nothing.
pub const ROUNDING: f64 = 1e-12;

/// Part of a length that is nothing between things that were meant to touch, and between points of a ring
/// that are one: some 10⁷ roundings, so that what was computed from coordinates in double precision touches
/// still. With a larger value sheets that are set apart by the least gap would touch.
pub const COINCIDENT: f64 = 1e-9;

/// Part of a length that is nothing in models of single precision, which round to 6·10⁻⁸ of a coordinate:
/// some sixteen roundings. Contacts of patches, borders of sheets and points on regions use it, which are
/// asked for models as they come.
pub const LOOSE: f64 = 1e-6;

/// Rounding of a height over a plane, as a part of the distance from the plane's point: some tens of units in
/// the last place.
pub(crate) const OF_DISTANCE: f64 = 1e-14;

/// Part of a size by which boxes exceed what is in them: ten times [`SEAM`](crate::Hit::SEAM), so that no box
/// leaves out a hit that is accepted just outside the parameters, nor one that rounding moves. Larger boxes
/// would only be entered more often.
pub(crate) const OVERHANG: f64 = 1e-8;

/// Part of a squared extent that is no area: what rounding leaves of the cross products of points on a line.
/// With a larger value slender sheets would be refused, whose breadth is as many times smaller than their
/// length.
pub const NO_AREA: f64 = 1e-12;

/// Part by which areas that are equal may differ where they are sums of many: some 10⁷ roundings. What is cut
/// into pieces or merged has to keep its area to this part, or it stays as it was; with a larger value pieces
/// that overlap a little, or leave a gap, would pass.
pub const ROUNDING_OF_AREAS: f64 = 1e-9;

/// Sine of the angle between planes, or axes, below which they are parallel: of sheets that may lie on each
/// other, whose corners may be of single precision ([`LOOSE`]). With a larger value sheets that meet at an
/// angle would count as one; with a smaller one copies of a sheet that were rounded apart would not be found.
pub const PARALLEL_PLANES: f64 = 1e-6;

/// Sine of the angle between two directions below which they span no plane: of edges, of axes and of the
/// camera's up vector. The cross product then has seven digits or fewer.
pub const PARALLEL_DIRECTIONS: f64 = 1e-9;

/// Distance of a vertex from the plane of its outline, at most, over the outline's extent, as long as it
/// counts as flat: four roundings of the fifth decimal at an extent of 1, and far above those of single
/// precision. With a larger value quads that are meant to be curved would be flattened; with a smaller one
/// faces with few decimals would be refused.
pub const PLANARITY: f64 = 2e-5;

/// Roundings by which a vertex may miss a plane through other vertices: each misses by one, and a plane
/// through three adds up to three more where it is extended; twice that.
pub const ROUNDINGS_OF_PLANE: f64 = 8.0;

/// Half a unit in the last place of single precision, relative to the number.
pub(crate) const ROUNDOFF_OF_SINGLE: f64 = 1.0 / (1u64 << 24) as f64;

/// Half a unit in the last place of double precision, relative to the number.
pub const ROUNDOFF_OF_DOUBLE: f64 = 1.0 / (1u64 << 53) as f64;
