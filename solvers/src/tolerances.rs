//! Tolerances of rounding that several methods have, side by side.

/// Relative difference of a_ij and a_ji that counts as rounding: some 10⁴ roundings, as entries are sums.
/// With a larger value matrices would count as symmetric for which Cholesky's method solves another system.
pub(crate) const ASYMMETRY_OF_ENTRIES: f64 = 1e-12;

/// Relative difference of vᵀ(A p) and pᵀ(A v) that counts as rounding: larger than that of entries, since
/// products of many unknowns cancel.
pub(crate) const ASYMMETRY_OF_PRODUCTS: f64 = 1e-10;

/// Fall of the recurred residual of conjugate gradients after which it is recomputed: some 50 roundings, by
/// which both may differ.
pub(crate) const DRIFT: f64 = 1e-14;

/// Relative length below which the remainder of orthogonalisation is rounding: some five roundings.
pub(crate) const VANISHED: f64 = 1e-15;

/// Tolerance below which a direct method comes first: some 500 roundings, which iterations may not reach.
pub(crate) const STRICT: f64 = 1e-13;

/// Residual down to which a direct solution is refined, even if the tolerance is looser: a step costs little
/// beside the factors, and errors of these are then gone.
pub(crate) const REFINED: f64 = 1e-10;
