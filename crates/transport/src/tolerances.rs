//! Tolerances that several ways to a block share, and those that bound one quantity in several ways, side by
//! side. Lengths that count as none are set by [`radiosity_geom`].
//!
//! In order: what counts, what a coarse or an unfinished sum tells, shadows, rays, halvings and points.

/// Part of the error allowed to a block that what a part of it carries may be, as long as the part is left
/// out: a thousand such parts spend all of it. What they carry is told as error.
pub(crate) const NEGLIGIBLE: f64 = 1e-3;

/// Relative accuracy below which shadows by outlines are found with more care: penumbras as seen from the
/// corners of a cell too, such as those of slits seen edge on, and cuts along kinks of the outer element.
/// Above it halving cells takes fewer points (`docs/measured.md`).
pub(crate) const FINE_SHADOWS: f64 = 1e-4;

/// Largest relative error of the inner rules of shadows by outlines: rules that err by more have a point or
/// two and tell nothing of a cell.
pub(crate) const LOOSEST_OF_OUTLINES: f64 = 0.05;

/// Largest relative error of the rules of a part of a curved element, however little it carries.
pub(crate) const LOOSEST_OF_PARTS: f64 = 1e-2;

/// Safety factor on a coarse estimate of what a pair carries as an upper bound, of near pairs and of parts of
/// them: few points may miss a peak. With a larger value less is left out, with a smaller one too much may
/// be.
pub(crate) const ABOVE_ESTIMATE: f64 = 3.0;

/// Factor that turns a coarse estimate of a curved pair, or the sum over the parts of a block that are done,
/// into a lower bound of its first entry. Errors are measured against it: with a larger value they may be
/// allowed to be too large.
pub(crate) const BELOW_ESTIMATE: f64 = 0.5;

/// Error over the difference of two rules on near parts, where both miss the kernel's peak: measured on a
/// ball that lies on a floor.
pub(crate) const MISSED_BY_ATTEMPTS: f64 = 2.0;

/// Error over the difference of the last two sums of a trial that did not converge: sums that converge slowly
/// are farther from their limit than from each other.
pub(crate) const MISSED_BY_TRIALS: f64 = 3.0;

/// Error of rules that did not converge, over what they tell, where rays are there to compare with: tori and
/// balls on floors were off by up to this.
pub(crate) const MISSED_BY_RULES: f64 = 10.0;

/// Allowed difference of two levels of a shadow by outlines, as a multiple of the error allowed of the finer
/// one: the coarser one errs by more of it. With a smaller value cells are divided that need it no more.
pub(crate) const AGREED_BY_LEVELS: f64 = 2.5;

/// Errors of rays by which a value by rules and one by rays may differ.
pub(crate) const AGREED_BY_RAYS: f64 = 3.0;

/// Error allowed for the shadows of a block, as a factor on ε_shadow times the largest entry of its row:
/// errors of sampled shadows have either sign and weigh little in the sum over many blocks. Four shadowed
/// blocks of a row may err together by ε_shadow.
pub(crate) const SHADOWS_IN_ROW: f64 = 0.25;

/// Error allowed for shadows by outlines, or sampled between flat elements, as a factor on ε_shadow times the
/// largest view factor of either element: the errors of the few shadowed blocks of a row may add up.
pub(crate) const SHADOWS_IN_FACTORS: f64 = 0.25;

/// Rule of three: if none of n independent points or rays is met, less than 3/n of them all are at 95 %, as
/// 0.05 = e⁻³.
pub(crate) const RULE_OF_THREE: f64 = 3.0;

/// Batches of points or rays whose sums tell the error of their mean: an even number, since pairs of them are
/// merged. With fewer the error itself is hardly known; more of them are small, and agree by chance.
pub const BATCHES: usize = 8;

/// Standard deviations of the mean of [`BATCHES`] that count as its error. At 7 degrees of freedom more than
/// three times as much is met once in a thousand cases (Student). Of sampled visibility, whose batches
/// balance each other, half of one is found on the average; a disk that hid part of another was off by three.
pub(crate) const DEVIATIONS: f64 = 2.0;

/// Most halvings of a cell of the outer element for shadows by outlines: it is then 1/16384 as long.
pub(crate) const MOST_HALVINGS_OF_OUTER: usize = 14;

/// Most halvings of a piece of the inner element, which is near the outer point: in turn along and across, it
/// is then 10⁻⁶ as long.
pub(crate) const MOST_HALVINGS_OF_INNER: usize = 40;

/// Most points per direction of the corner rule between parts of curved elements, which takes their fourth
/// power: 160 000.
pub(crate) const MOST_CORNER_POINTS: usize = 20;

/// Most angular points of the corner rule between flat elements where shadows are sampled, which takes their
/// third power, and of slender parts at the smallest size.
pub(crate) const MOST_SLIVER_POINTS: usize = 16;
