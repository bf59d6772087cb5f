//! Tolerances of segments at their ends, and of parts of surfaces that are none. Lengths that count as none,
//! and which planes are parallel, are set by [`radiosity_geom`].

/// Part of a segment's length at both ends within which it may touch surfaces: rounding of where it starts
/// and ends. With a smaller value segments would be stopped where they start; with a larger one what stands
/// close to an end would be passed.
pub const END: f64 = 1e-9;

/// Part of a segment's length at an end within which it may touch the surface that the end lies on. A curved
/// surface is met again, at a grazing angle, farther from the end than rounding puts it off: a height of
/// [`END`] is left at a sine of 10⁻³. With a larger value bends of the surface itself would hide less.
pub const OWN_END: f64 = 1e-6;

/// Width of a piece beside or under a cover, over the extent of the smaller sheet, up to which it is rounding of the
/// cut. With a larger value narrow pieces that light reaches would be missing: strips beside boxes in recesses.
pub const NARROW_PIECE: f64 = 1e-9;

/// Height of a gap over the diagonals of the surfaces at both sides up to which it is narrow: then about its square of
/// the light outside comes to its middle. Chosen.
pub const NARROW_GAP: f64 = 0.03;

/// Height of a gap over the diagonal of the scene up to which it is narrow: mats lie closer, and storeys, however wide,
/// are higher. Chosen.
pub const NARROW_GAP_IN_SCENE: f64 = 0.01;

/// Part of a surface's area that has to be left beside footprints, and by which a footprint has to be smaller
/// than its surface: less is rounding.
pub(crate) const LEFT_BESIDE_FOOTPRINTS: f64 = 1e-6;
