//! Accuracies to which light is gathered at points, and those of runs that follow each other, side by side.
//! Lengths that count as none are set by [`radiosity_geom`].

/// Relative accuracy of light gathered at a point that is asked for in code: as that of direct light
/// ([`radiosity_light::direct::ACCURACY`]), which is a part of it.
pub(crate) const AT_A_POINT: f64 = 1e-3;

/// Accuracy that light is gathered to where nothing else is asked for: that of the polynomials that it is
/// gathered from in rooms, about. Pictures take less.
pub const USUAL_EPS: f64 = 1.25e-3;

/// Tolerance of gathered light at a point over that of shadows in a block: a block is a mean of many points,
/// whose errors have either sign.
pub(crate) const POINT_OVER_BLOCK: f64 = 3.0;

/// Tolerance of the first of two gatherings over that of the second, which smooths its errors and multiplies
/// them by reflectances. With a larger value they show, with a smaller one the first takes most of the time.
pub(crate) const FIRST_OVER_SECOND: f64 = 5.0;

/// Accuracy of gathering, over the error of polynomials that it is to find, estimated or expected: with a
/// larger value errors of gathering are taken for those of the polynomials, with a smaller one the estimate
/// takes longer than a solution.
pub(crate) const OF_ERROR: f64 = 0.3;

/// Part of the wanted accuracy that light is read to. With .9 the error of reading was as large as that of
/// what was read.
pub(crate) const OF_ACCURACY: f64 = 0.3;

/// Part of the wanted accuracy that readings by walks are made for, which nothing else errs: the L2 mean of a dozen of
/// them, each good to 0.8 of what it is asked for, then exceeds the accuracy hardly ever.
pub(crate) const OF_WALKS: f64 = 0.7;

/// Coarsest accuracy of gathering for an estimate of the polynomials' error: it suffices where they are as
/// far off.
pub(crate) const LOOSEST_FOR_POLYNOMIALS: f64 = 3e-2;

/// Coarsest accuracy of gathering by cells for an estimate of the error of gathered light. With 9e-3
/// estimates were a third of the errors.
pub(crate) const LOOSEST_FOR_GATHERED: f64 = 3e-3;

/// Factor on the accuracy of gathering while an estimate is not sure: few steps, since each gathers all
/// points anew.
pub(crate) const SHARPENING_OF_GATHERING: f64 = 0.2;

/// Factor on the accuracies of transfers and shadows from rung to rung, on each of which orders or cuts grow
/// too: over seven rungs a twelfth.
pub(crate) const SHARPENING_OF_RUNGS: f64 = 0.7;

/// Factor on the accuracies of blocks and shadows where elements are refined in vain.
pub(crate) const SHARPENING_IN_VAIN: f64 = 0.4;
