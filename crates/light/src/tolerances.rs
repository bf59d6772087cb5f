//! Tolerances of light at a point that several rules share, and those that bound one quantity in several
//! rules, side by side. Lengths that count as none are set by [`radiosity_geom`].

/// Least distance from a bent area light, in its radii, from which its outline is taken for the whole of it:
/// nearer, chords of its silhouette mesh are seen at too large an angle. With a larger value more of it goes
/// by cells, or by rays, which cost more.
pub(crate) const OUTLINE_FROM: f64 = 2.0;

/// Least cosine between the normals of a cell with straight sides that counts as flat (2.6°): it is seen
/// under an angle that is off by as much. Whole surfaces count as flat up to 0.8°, since nothing is known of
/// who sees them.
pub(crate) const COSINE_OF_FLAT: f64 = 0.999;

/// Least cosine between two normals of a curved cell that a rule is tried on (46°): of cells that turn
/// farther, points of the rule face away that others stand for, and the cell is divided at once.
pub(crate) const COSINE_OF_CELL: f64 = 0.7;

/// Error that one cell may contribute, over the accuracy of the sum: the errors of some ten cells, of either
/// sign, then add up to it. With a larger value the sum may miss its accuracy where more cells are divided no
/// further.
pub(crate) const PER_CELL: f64 = 0.3;

/// Most quarterings of a flat cell of an emitter, which is then 6·10⁻⁸ as long: a bound for receivers that
/// all but touch it.
pub(crate) const MOST_QUARTERINGS_OF_FLAT: usize = 24;

/// Most quarterings of a curved cell, whose quarters at a pole stay as near as it was.
pub(crate) const MOST_QUARTERINGS_OF_CURVED: usize = 12;

/// Most quarterings of a cell on the receiver's own surface, where κ is bounded: what is left carries 4⁻⁸ of
/// a patch.
pub(crate) const MOST_QUARTERINGS_OF_OWN: usize = 8;

/// Most quarterings of a cell for a field that varies over it: corners of three surfaces, in which light
/// depends on the direction alone, have no end of their own.
pub(crate) const MOST_QUARTERINGS_OF_FIELD: usize = 12;

/// Most quarterings of a lamp's cells for rays. A tube of 60 times its radius wants five where it is a radius
/// away.
pub(crate) const MOST_QUARTERINGS_OF_LAMP: u32 = 7;

/// Most quarterings of a cell beside a luminaire for the first bounce: it is then 2⁻¹⁴ as long, and a
/// luminaire that is nearer lights next to nothing of it from there.
pub(crate) const MOST_QUARTERINGS_AT_LUMINAIRE: usize = 14;

/// Most halvings of a panel across scan lines: 1/64 of it, beyond which the sum is taken as it is.
pub(crate) const MOST_HALVINGS_OF_PANEL: usize = 6;

/// Most halvings of a luminous line: a bound for intensities that jump along it.
pub(crate) const MOST_HALVINGS_OF_LINE: u32 = 16;

/// Part of the light that is expected at a point, without shadows or by the mean radiosity of the scene:
/// where less arrives, its error counts relative to this part. With a smaller value deep shadows take most of
/// the rays.
pub const DARK: f64 = 0.02;

/// Length of a curved cell over its breadth above which it is cut across its length only. With a larger value
/// slender cells take more parts to become as short as rules want; with a smaller one parts may become
/// broader than they are long.
pub const LONG_CELL: f64 = 2.0;

/// As [`LONG_CELL`], of flat cells. Chosen: walls and tables are quartered, and strips are cut across: with cuts along
/// a strip as well, a point beside it would need as many cells as the square of its length over its breadth.
pub(crate) const LONG_STRIP: f64 = 4.0;
