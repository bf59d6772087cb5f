//! Tolerances that several rules share, and those that bound one quantity in several rules, side by side.
//!
//! In order: rounding, shares of the accuracy ε, most halvings, grids over patches, contour integrals. A
//! tolerance that one rule alone has stands beside that rule.

/// Cosine or sine between two unit vectors below which they are at a right angle, or parallel: some ten
/// roundings. Contour integrals leave out pairs of edges at right angles and take parallel ones in closed
/// form, common edges have the same values on both sides of an upright depth. With a larger value terms that
/// count would be left out.
pub(crate) const ROUNDING_OF_DIRECTIONS: f64 = 1e-15;

/// Difference of two sums by rules, relative to them, that is rounding: some hundred roundings. Accuracies
/// below it are not asked of a trial, nor of the points that a chart needs.
pub(crate) const ROUNDING_OF_SUMS: f64 = 1e-14;

/// Height of a sample over a tangent plane, over the samples' extent, that counts as zero where two patches
/// are tested for facing each other: rounding of positions and of normals, some 10⁵ roundings. With a larger
/// value patches that see each other at a grazing angle would count as turned away.
pub(crate) const LEVEL_OF_SAMPLES: f64 = 1e-11;

/// Step of the height over a plane along a line, over the largest height, that counts as zero where lines are
/// tested for crossing the plane once: some thousand roundings, fewer than of [`LEVEL_OF_SAMPLES`] since one
/// plane is given.
pub(crate) const LEVEL_OF_STEPS: f64 = 1e-13;

/// Smallest convergence rate ϱ of kernels that are linear in each variable: keeps ln ϱ > 0 where a root lies
/// on the interval. The count of points then exceeds all rules.
pub(crate) const SMALLEST_RHO: f64 = 1.0 + 1e-9;

/// Smallest convergence rate ϱ of stretched rules, as [`SMALLEST_RHO`].
pub(crate) const SMALLEST_RHO_OF_STRETCH: f64 = 1.0 + 1e-6;

/// Smallest σ of a common edge, from which ϱ = σ + √(σ² − 1) is at least 1.0014, as [`SMALLEST_RHO`].
pub(crate) const SMALLEST_SIGMA_OF_EDGE: f64 = 1.0 + 1e-6;

/// Factor of ε for each subdomain of two triangles, at a common edge and at a common corner: the errors of
/// the subdomains add up, and their area elements vary. With 1 the sum may err by more than ε, smaller ones
/// cost points.
pub(crate) const SHARE_OF_TRIANGLES: f64 = 0.5;

/// Factor of ε for far patches on charts without right angles, where the formula was measured to fall a
/// little short.
pub(crate) const SHARE_OF_ASKEW: f64 = 0.5;

/// Factor of ε within which two sums of a trial have to agree: the coarser of them is the rule that is taken,
/// and other variables add their errors.
pub(crate) const SHARE_OF_TRIAL: f64 = 0.5;

/// Factor of ε within which two rules on an outer patch with horizons have to agree; the finer one is taken.
pub(crate) const SHARE_OF_CLIMB: f64 = 0.5;

/// Factor of ε for the estimates of both rules of a near pair, outer and inner: singularities in both
/// directions and of several edges add their errors.
pub(crate) const SHARE_OF_NEAR: f64 = 0.2;

/// Error of the halves of a cell, relative to their difference from the whole, at a kink of second order:
/// 2⁻³, doubled for the position of the kink.
pub(crate) const ERROR_OF_HALVES: f64 = 0.25;

/// Most halvings, one inside the other, of a square of two angular variables at a common edge: parts are then
/// 2⁻²⁴ as long, and a kernel that is still peaked is singular to rounding. `Multilinear` bounds their
/// number too.
pub(crate) const MOST_HALVINGS_OF_SQUARE: u32 = 48;

/// Most halvings, one inside the other, of a cube of three variables at a common corner: parts are then 2⁻²⁰
/// as long.
pub(crate) const MOST_HALVINGS_OF_CUBE: u32 = 60;

/// Most cuts, one inside the other, of a cell in the plan of a near pair: if they are halvings in turn along
/// and across, cells are 10⁻⁶ as long. A cell that wants more keeps its rule.
pub(crate) const MOST_CUTS_OF_CELL: usize = 40;

/// Most halvings, one inside the other, of a near pair of patches whose cost is told: parts of both are then 2⁻³⁰ as
/// long. Patches that cross by roundings of their corners would be halved without an end.
pub(crate) const MOST_HALVINGS_OF_SPLIT: u32 = 120;

/// Most halvings of a near pair of patches whose kernel is a sum of terms: each part is 1/64 of its patch if
/// both are halved as often. Nearer pairs are refused.
pub(crate) const MOST_HALVINGS_OF_TERMS: usize = 12;

/// Most halvings, along and across in turn, that remove from an outer patch what sees nothing: it is 1/256 as
/// long then. What is left dark counts as error.
pub(crate) const MOST_TRIMS: usize = 16;

/// Most halvings of an outer patch until a rule integrates its heights over a plane accurately: a bound of
/// the number of parts, 256.
pub(crate) const MOST_SPLITS: usize = 8;

/// Most times that a patch is quartered until its lines cross a horizon once at most, on either side of a
/// pair: quarters are then 1/32 as long. On what is left lines with any number of roots are summed, which is
/// right though less regular; a further quartering would make up to four times as many parts.
pub const MOST_QUARTERINGS: usize = 5;

/// Nodes per direction at which heights over horizons are known: of a patch and its quarters, and along a
/// line whose roots are looked for. Turns between two nodes may be missed. With more nodes fewer are, and
/// each patch, quarter and line costs more.
pub(crate) const GRID_OF_HEIGHTS: usize = 6;

/// ln(1/ε) of rules along edges that are near each other: ε = 6e-16, rounding.
pub(crate) const DIGITS_OF_CONTOUR: f64 = 35.0;

/// Most points of these rules, for a panel of a skew edge and for a stretch near a small polygon; parts that
/// want more are halved.
pub(crate) const MOST_POINTS_OF_CONTOUR: usize = 16;

/// Smallest σ for which [`MOST_POINTS_OF_CONTOUR`] points give [`DIGITS_OF_CONTOUR`]: 2 · 16 · ln(σ + √(σ² −
/// 1)) = 35.
pub(crate) const SMALLEST_SIGMA_OF_CONTOUR: f64 = 1.66;

/// ln(1/ε) of the rules along edges of polygons far apart, in which nothing cancels: ε = 3e-14 of A_i A_j/R².
pub(crate) const DIGITS_OF_DISTANT: f64 = 31.0;

/// Most points of an edge of polygons far apart. Pairs that want more go edge by edge; with a larger value
/// more room is kept for the points of every pair.
pub(crate) const MOST_POINTS_OF_DISTANT: usize = 14;
